"""Error bars over many seeds, against a long run."""

from dataclasses import replace
from statistics import NormalDist

from measure import coverage
from measure.accuracy import estimator
from measure.kinds import Measurement, Row, percent, within

SEEDS = 60
FEWER = 40  # where a run takes longer
FEW = 100  # gates of all runs: chance alone takes their coverage beyond what is allowed
ALLOWED = (0.91, 0.98)
TIMID = {"forward": 0.4, "bidirectional": 0.1}
PHOTONS = {"forward": 1e6, "bidirectional": 8e4}
WATERS = {
    "peaked water": ("run", "scenes/benchmark-peaked.toml", "--set", "gates.depth_step_m=2"),
    "Henyey-Greenstein water": ("run", "scenes/benchmark-hg.toml", "--set", "gates.depth_step_m=2"),
}
HARD = ("run", "experiments/hard.toml")


def long_run(runner, scene, photons, name="bidirectional"):
    """The truth, with a seed that no short run has."""
    return runner.result(*scene, *estimator(name), "--photons", runner.photons(photons, name), "--seed", 7777)


def short_runs(runner, scene, name, photons, seeds):
    count = runner.photons(photons, name)
    return runner.results([(*scene, *estimator(name), "--photons", count, "--seed", s) for s in runner.seeds(seeds)])


def compared(runner, scene, truth, photons, seeds, kinds=("echoes",)):
    """Short runs against the long one, by estimator and kind of number."""
    out = {}
    for name in photons:
        runs = short_runs(runner, scene, name, photons[name], seeds)
        for kind in kinds:
            counts = coverage.compare([coverage.cells(run, kind) for run in runs], coverage.cells(truth, kind))
            out[f"{name}, {kind}"] = counts
    return out


def covered(what, counts, allowed):
    """The row of a coverage. Nothing that is compared is nothing that holds; a few gates leave it open."""
    text = f"{100 * allowed[0]:.0f} to {100 * allowed[1]:.0f} %"
    total = sum(counts["converged"])
    if total == 0:
        return Row(what, "no gate is converged", text, False)
    share, error = coverage.share(counts["covered"], counts["converged"])
    seen = total / (counts["in_reference"] * len(counts["converged"]))
    measured = f"{100 * share:.1f} +- {100 * error:.1f} % of {total} ({percent(seen, 0)} are converged)"
    if total < FEW:
        return Row(what, measured + ": too few to judge", text)
    return Row(what, measured, text, within(share, *allowed))


def measure_coverage(runner):
    return {water: compared(runner, scene, long_run(runner, scene, 4e6), PHOTONS, SEEDS) for water, scene in WATERS.items()}


def rows_coverage(raw):
    for water, by_estimator in raw.items():
        for name, counts in by_estimator.items():
            yield covered(f"{water}, {name.split(',')[0]}", counts, ALLOWED)


def measure_hard(runner):
    truth = long_run(runner, HARD, 1e7, "forward")
    return compared(runner, HARD, truth, {"forward": 1e6, "bidirectional": 1.2e5}, FEWER)


def rows_hard(raw):
    for name, counts in raw.items():
        row = covered(name.split(",")[0], counts, ALLOWED)
        share, _ = coverage.share(counts["covered"], counts["converged"])
        if 0 < share < 1:  # what normal errors would be too small by
            factor = coverage.TWO_SIDED_95 / NormalDist().inv_cdf((1 + share) / 2)
            row = replace(row, measured=f"{row.measured}; errors {factor:.2f} times as large would cover 95 %")
        yield row


def rows_flags(raw):
    for water, by_estimator in raw.items():
        for name, counts in by_estimator.items():
            what = f"{water}, {name.split(',')[0]}"
            wild, converged = sum(counts["wild"]), sum(counts["converged"])
            share = wild / converged if converged else 1.0
            yield Row(f"{what}: converged, off by more than 4 errors", f"{wild} of {converged}", "at most 0.3 %", share < 0.003)
            if counts["known"] == 0:
                yield Row(f"{what}: known to 2.5 %, flagged all the same", "no gate is known to 2.5 %")
                continue
            timid = counts["known_but_flagged"] / counts["known"]
            measured = f"{percent(timid)} of {counts['known']}"
            most = TIMID[name.split(",")[0]]
            yield Row(f"{what}: known to 2.5 %, flagged all the same", measured, f"at most {percent(most, 0)}", timid < most)


PATH = "sea.layer.0.chlorophyll_mg_m3"
CHANGED = (
    "run", "scenes/ship.toml", "--set", f"{PATH}=0.5", "--set", "gates.depth_max_m=5", "--set", "gates.depth_step_m=0.5",
    "--set", f"environment_grid.{PATH}=[0.505]", "--set", f'sensitivity=["{PATH}"]',
)
NAMES = {"environment_echoes": "difference for 1 % more chlorophyll", "sensitivities": "derivative by chlorophyll"}


def measure_differences(runner):
    return compared(runner, CHANGED, long_run(runner, CHANGED, 2e6), {"forward": 4e5, "bidirectional": 6e4}, FEWER, tuple(NAMES))


def rows_differences(raw):
    for name, counts in raw.items():
        one, kind = name.split(", ")
        yield covered(f"{NAMES[kind]}, {one}", counts, ALLOWED)


def measure_target(runner):
    scene = (*WATERS["peaked water"], "--set", "gates.depth_max_m=40")
    truth = coverage.cells(long_run(runner, scene, 4e6), "echoes")
    runs = runner.results([(*scene, "--target", "5%", "--photons", "1e9", "--seed", s) for s in runner.seeds(SEEDS)])
    counts = coverage.compare([coverage.cells(run, "echoes") for run in runs], truth)
    return counts | {"ended": [run["stopped_by"] for run in runs]}


def rows_target(raw):
    total = sum(raw["converged"])
    reached = raw["ended"].count("target")
    yield Row("runs that reached the target", f"{reached} of {len(raw['ended'])}", "all", reached == len(raw["ended"]))
    yield covered("their 95 % intervals cover", raw, ALLOWED)
    beyond = sum(raw["beyond"]) / total if total else 1.0
    yield Row("gates off by more than twice the target", f"{percent(beyond)} of {total}", "at most 5 %", beyond < 0.05)


SHORT = (
    "Short runs of many seeds against one long run of the bidirectional estimator, whose own error widens the intervals; gates "
    "that are flagged in either are left out."
)
MEASUREMENTS = [
    Measurement(
        "coverage", "Error bars", "95 % intervals of gates flagged converged cover the truth in 95 % of the cases.",
        SHORT + " The number is the share of intervals that cover, its error the scatter from seed to seed.",
        measure_coverage, rows_coverage,
    ),
    Measurement(
        "coverage-hard", "Error bars in hard water", "In forty layers of random chlorophyll, seen by a tilted and a wide telescope, "
        "elastic and Raman.",
        "As above, but the long run is the forward estimator's, which converges in more of the gates. The bound is that of "
        "other water.",
        measure_hard, rows_hard,
    ),
    Measurement(
        "flags", "Flags", "Gates flagged converged are not far off, and gates that are well known are not flagged.",
        "The runs of `coverage`. A gate is known to 2.5 %, half of the 5 % that such runs aim at, where the short runs scatter about "
        "the truth by less (root mean square). The forward estimator is flagged sooner: its large scores are rare.",
        measure_coverage, rows_flags,
    ),
    Measurement(
        "differences", "Differences and derivatives", "95 % intervals of differences between waters, and of derivatives, "
        "cover the truth in 95 % of the cases.", SHORT, measure_differences, rows_differences,
    ),
    Measurement(
        "target", "Runs that end at a target", "A run that `--target` ended is as good as it says: ending when errors look small "
        "does not make them too small.", "Peaked water to 40 m at 5 %. " + SHORT, measure_target, rows_target,
    ),
]
