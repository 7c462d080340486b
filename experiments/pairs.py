#!/usr/bin/python3
"""Tests whether features compose: small scenes in which each pair of values of two features stands, by both estimators.

    experiments/pairs.py build/release/apps/photic/photic                      # the whole array, 4 seeds: 15 minutes on two cores
    experiments/pairs.py build/release/apps/photic/photic --only air --only "run=scalar"    # scenes with air, or with the scalar engine
    experiments/pairs.py build/release/apps/photic/photic --only "surface=paper" --keep FOLDER
    experiments/pairs.py build/release/apps/photic/photic --list              # the scenes and the pairs that are refused
    experiments/pairs.py build/release/apps/photic/photic --write-guide       # the table of refused pairs in docs/guide.md

Features, their values and the scenes are those of pair_array/features.py. `photic check` is asked which pairs can be combined; of the
rest, --seed makes another array. A scene is run by the forward and by the bidirectional estimator. Tools and
overlap reception, which only the forward one has, are compared with the bidirectional run without them. An environment is compared with a run of its own, a
derivative with a difference of two runs; a run in two sittings is to be equal to one, lanes to be close to the scalar engine.

Compared are gates, processes and orders that neither estimator flags in nine tenths of the seeds. z is the plain mean of their differences
over all seeds, over the error of that mean. All z of the array stay below the largest allowed but for a chance of 1 in 100; the root mean
square of the z of single seeds of a scene is to be 0.7 to 1.4. A scene that fails is run with 20 seeds before it counts. A scene is
inconclusive if fewer than half of the gates with light are unflagged in both, in the mean over seeds. The exit code is 1 if a scene disagrees or
is inconclusive, if a refusal does not name both features, or if no scene can hold a pair that is accepted.
"""

import argparse
import difflib
import shutil
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
from pair_array import covering, judge, refusals  # noqa: E402
from pair_array.features import FEATURES, scene_of, title_of  # noqa: E402
from pair_array.program import Failed, Program  # noqa: E402
from pair_array.scenes import text_of  # noqa: E402

sys.path.insert(0, str(Path(__file__).parent.parent / "benchmarks"))
from measure import marked, pages  # noqa: E402

GUIDE = Path(__file__).parent.parent / "docs" / "guide.md"
TABLE = "refused pairs"  # its name there
MORE_SEEDS = 20  # of a scene that fails

TEN = [covering.plainest(*(tuple(one.split(": ")) for one in line.split("; "))) for line in (  # those that ./test runs with one seed
    "surface: cox-munk; on the surface: shining film; instruments: tilted; view: nested; water: three layers; light: raman",
    "surface: gaussian; on the surface: whitecaps; bed: by angle; instruments: biaxial; lens: obstruction; light: chlorophyll",
    "surface: one-dimensional; instruments: telescope below; lens: shifted away; view: nested; gates: range",
    "surface: paper; bed: by wavelength; instruments: laser below; view: wide; light: filter; run: continued",
    "bed: constant; air: haze; lens: shifted towards; view: nested; light: lifetime; gates: time",
    "surface: cox-munk; on the surface: slick; air: molecules; run: environments; gates: in the air",
    "air: refraction; instruments: tilted; lens: obstruction; water: peaked; run: scalar; gates: in the air",
    "bed: constant; instruments: both below; light: chlorophyll; run: forced collisions; gates: time",
    "surface: gaussian; on the surface: film; bed: constant; water: turbid; light: raman; run: derivatives; gates: range",
    "surface: cox-munk; on the surface: whitecaps; lens: shifted towards; view: apart; water: profile; run: environments of other surfaces",
)]


def chosen(text):
    """FEATURE or FEATURE=VALUE of --only, as the values of a feature."""
    feature, equals, value = text.partition("=")
    for what, name, known in (("feature", feature, [*FEATURES]), ("value of " + feature, value, FEATURES.get(feature, []))):
        if name not in known and (what == "feature" or equals):
            close = difflib.get_close_matches(name, known, 1)
            meant = f"did you mean {close[0]!r}?" if close else f"choose from: {', '.join(known)}"
            raise argparse.ArgumentTypeError(f"there is no {what} {name!r} ({meant})")
    return {feature: [value] if equals else [*FEATURES[feature][1:]]}


def natural(text):
    if not text.isdecimal() or int(text) < 1:
        raise argparse.ArgumentTypeError(f"{text!r} is not a whole number from 1 on")
    return int(text)


def is_asked(values, only):
    return not only or any(values[feature] in of_it for one in only for feature, of_it in one.items())


def in_words(outcome, bound):
    z, where = outcome.largest()
    flagged = " and ".join(f"{count} by {estimator}" for estimator, count in outcome.flagged.items())
    verdict = "   DISAGREES" if not outcome.held(bound) else "" if outcome.conclusive else "   INCONCLUSIVE"
    lines = [f"{title_of(outcome.values)}: {outcome.seeds} seeds, {outcome.count} compared, largest z {z:+.2f} ({where}), "
             f"rms z {outcome.rms:.2f}; of {outcome.lit} gates with light {flagged} flagged{verdict}"]
    return "\n  ".join([*lines, *outcome.faults, *outcome.beyond(bound)])


def keep(folder, scenes):
    folder.mkdir(parents=True, exist_ok=True)
    for n, values in enumerate(scenes, 1):
        (folder / f"{n:02}.toml").write_text(text_of(scene_of(values)))


def run(program, scenes, seeds, jobs, share=1.0):
    """The outcomes of scenes, those that fail with more seeds; and the bound of their comparisons."""
    with ThreadPoolExecutor(jobs) as pool:
        outcomes = list(pool.map(lambda values: judge.outcome_of(program, values, seeds, share), scenes))
        bound = judge.bound_of(outcomes)
        failed = [n for n, outcome in enumerate(outcomes) if not outcome.held(bound)] if seeds < MORE_SEEDS else []
        for n, outcome in zip(failed, pool.map(lambda n: judge.outcome_of(program, scenes[n], MORE_SEEDS, share), failed)):
            outcomes[n] = outcome
    return outcomes, bound


def report(outcomes, bound):
    """Prints the outcomes; returns whether all agree and are conclusive."""
    for outcome in outcomes:
        print(in_words(outcome, bound), flush=True)
    bad = sum(not outcome.held(bound) for outcome in outcomes)
    unclear = sum(outcome.held(bound) and not outcome.conclusive for outcome in outcomes)
    flagged = sum(sum(outcome.flagged.values()) for outcome in outcomes)
    print(f"{len(outcomes)} scenes, {sum(o.count for o in outcomes)} comparisons, |z| allowed up to {bound:.2f}: {bad} scenes disagree, "
          f"{unclear} are inconclusive; {sum(o.lit for o in outcomes)} gates with light, flagged {flagged} times")
    return not bad and not unclear


def table(found):
    """The table, and below it the reasons, the messages of `photic check`."""
    return "\n".join([*pages.table(refusals.HEAD, refusals.rows(found)), "", *refusals.numbered(found), ""])


def write_guide(found, page=GUIDE):
    page.write_text(marked.written(page.name, page.read_text(), TABLE, table(found)))


def ask(program, page=GUIDE):
    """The findings of `photic check`, asked first for the pairs that the guide lists: so others are soon known to be accepted."""
    asks = covering.Refusals(lambda values: program.problems(scene_of(values)))
    for pair in refusals.listed(marked.read(page.name, page.read_text(), TABLE)):
        if pair in covering.all_pairs():
            asks.of_pair(pair)
    return asks


def report_refusals(found, nowhere):
    """Prints what is wrong with the refusals; returns whether nothing is."""
    unnamed = [(refusal, one) for refusal in found for one in refusal.unnamed()]
    for refusal, (feature, value) in unnamed:
        print(f"a refusal does not name {feature} {value}: {refusal.text}")
    for one, other in nowhere:
        print(f"accepted, but in no scene: {' '.join(one)}, {' '.join(other)}")
    return not unnamed and not nowhere


def parse(arguments):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--seed", type=natural, default=1, help="of the array")
    parser.add_argument("--only", type=chosen, action="append", metavar="FEATURE[=VALUE]", help="scenes with this; may be repeated")
    parser.add_argument("--seeds", type=natural, default=4, help="of each scene's runs, from 1 on")
    parser.add_argument("--jobs", type=natural, default=2)
    parser.add_argument("--keep", type=Path, metavar="FOLDER", help="write the scenes there")
    parser.add_argument("--list", action="store_true", help="run nothing")
    parser.add_argument("--write-guide", action="store_true", help="write the table of refused pairs; run nothing")
    asked = parser.parse_args(arguments)
    if not shutil.which(asked.program):
        parser.error(f"there is no program {asked.program}")
    return asked


def main(arguments=None):
    asked = parse(arguments)
    program = Program(asked.program)
    try:
        asks = ask(program)
        scenes, nowhere = covering.make(asks, asked.seed)
        found = refusals.refused(asks)
        if asked.write_guide:
            write_guide(found)
            return 0 if report_refusals(found, nowhere) else 1
        scenes = [values for values in scenes if is_asked(values, asked.only)]
        if asked.keep:
            keep(asked.keep, scenes)
        if asked.list:
            print("\n".join([*map(title_of, scenes), "", table(found)]))
        good = report_refusals(found, nowhere)
        return 0 if (asked.list or report(*run(program, scenes, asked.seeds, asked.jobs))) and good else 1
    except (Failed, marked.Failed) as failure:
        print(f"pairs.py: {failure}", file=sys.stderr)
        return 2


if __name__ == "__main__":
    sys.exit(main())
