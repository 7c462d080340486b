#!/usr/bin/python3
"""Gates of the starters (`photic new KIND`) that do not meet their targets at the end of their runs, and the reasons.

    experiments/starters.py                           # all of them, as they are
    experiments/starters.py oil-spill ship --threads 1
    experiments/starters.py --photons 1e5             # shorter; also --max-time
    experiments/starters.py --write                   # all of them, on an idle machine; the table of docs/accuracy.md as well

For each starter: what ended its run, and how many of its gates met the target (10 % where the scene has none). Those that did
not are listed by reason, with depths and relative errors. The exit code is 1 if a gate is flagged although its error is below
the target, and more photons do not mend that flag: such a run never ends by its target.

The program is that of PHOTIC_PROGRAM, or build/release/apps/photic/photic.
"""

import argparse
import re
import shlex
import subprocess
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path

import netCDF4
import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "benchmarks"))
from measure import marked, pages, readme  # noqa: E402
from measure.program import ROOT, Runner, echo_scenes, find_program  # noqa: E402
from measure.stamp import stamp  # noqa: E402

NO_TARGET = 0.1
REASONS = {  # by the first flag of these that a gate has; the sentence names its errors
    "few_batches": "`few_batches`: the run is too short for an error (errors {})",
    "large_error": "few photons come back from there (errors {})",
    "heavy_tail": "`heavy_tail`: rare large scores may be missing (errors {})",
    "beam_missed": "`beam_missed`: the telescope's walks hardly met the beam (errors {})",
}
MENDED = {"few_batches", "large_error", "heavy_tail"}  # sooner or later, by more photons
MANY = 3  # channels with gates left for one reason: more are counted, not named


@dataclass
class Gate:
    """A gate of a starter, not converged to its target."""

    number: int
    depth: float  # its centre, in the coordinate of its file [m]
    error: float  # relative
    flags: list
    known: bool  # to the target


@dataclass
class Channel:
    place: str  # telescope, where there are several, and channel
    gates: int  # that were scored in
    left: list  # not converged to the target


@dataclass
class Run:
    """A starter's."""

    kind: str
    channels: list
    target: float | None
    stopped_by: str
    estimator: str
    photons: int
    seconds: float

    @property
    def gates(self):
        return sum(channel.gates for channel in self.channels)

    @property
    def left(self):
        return sum(len(channel.left) for channel in self.channels)

    @property
    def stuck(self):
        """Gates that no number of photons brings to the target."""
        return [(channel.place, gate) for channel in self.channels for gate in channel.left
                if gate.known and not MENDED.issuperset(gate.flags)]


def target_of(scene):
    found = re.search(r"(?:^|[{,] *)target_relative_error = ([^\s,}]+)", scene, re.MULTILINE)
    return float(found[1]) if found else None


def channels_of(file, target):
    """The channels of a result, and what of them is not converged to a target."""
    masks = dict(zip(file["convergence_flags"].flag_meanings.split(), file["convergence_flags"].flag_masks))
    names = ("echo", "echo_standard_error", "gate_depth", "convergence_flags")
    echo, error, depth, flags = (np.ma.filled(file[name][:], np.nan) for name in names)
    telescopes, channels = file["telescope_name"][:], file["channel_name"][:]
    out = []
    for t, c in np.ndindex(echo.shape[:2]):
        place = f"{channels[c]} of {telescopes[t]}" if len(telescopes) > 1 else str(channels[c])
        scored = np.flatnonzero(echo[t, c] > 0)
        channel = Channel(place, len(scored), [])
        for g in scored:
            relative = float(error[t, c, g] / echo[t, c, g])
            raised = [name for name, mask in masks.items() if int(flags[t, c, g]) & mask]
            if raised or not relative <= target:
                channel.left.append(Gate(int(g), float(depth[t, c, g]), relative, raised, relative <= target))
        out.append(channel)
    return out


def run(kind, more):
    """A starter, from `photic new` to its result; `more`: options."""
    with tempfile.TemporaryDirectory() as folder:
        scene, result = f"{folder}/{kind}.toml", f"{folder}/{kind}.nc"
        subprocess.run([find_program(), "new", kind, "-o", scene], check=True, capture_output=True)
        subprocess.run([find_program(), "run", scene, "-o", result, "--table", "none", *more], check=True, capture_output=True)
        with netCDF4.Dataset(result) as file:
            file.set_auto_mask(False)
            target = target_of(file.scene)
            channels = channels_of(file, NO_TARGET if target is None else target)
            return Run(kind, channels, target, file.stopped_by, file.estimator, int(file.photons), float(file.wall_time_s))


def percents(errors):
    low, high = (f"{100 * error:.0f}" if error > 0.1 else f"{100 * error:.2g}" for error in (min(errors), max(errors)))
    return f"{low} %" if low == high else f"{low} to {high} %"


def metres(gate):
    return f"{round(gate.depth, 1) + 0:g}"


def depths(gates):
    """The ranges of the centres of gates."""
    ranges = []
    for gate in gates:
        if ranges and gate.number == ranges[-1][1].number + 1:
            ranges[-1][1] = gate
        else:
            ranges.append([gate, gate])
    return ", ".join(metres(first) if first is last else f"{metres(first)} to {metres(last)}" for first, last in ranges) + " m"


def reason(gate, stopped_by):
    flag = next((flag for flag in REASONS if flag in gate.flags), None)
    if flag is not None:
        return REASONS[flag]
    if gate.flags:
        return ", ".join(f"`{flag}`" for flag in gate.flags) + " (errors {})"
    return f"above the target: the {stopped_by} ended the run first (errors {{}})"


def reasons(one):
    """The gates left of a run, one sentence for each reason."""
    found = {}
    for channel in one.channels:
        for gate in channel.left:
            found.setdefault(reason(gate, one.stopped_by), {}).setdefault(channel.place, []).append(gate)
    sentences = []
    for why, places in found.items():
        every = [gate for gates in places.values() for gate in gates]
        if len(places) > MANY:
            first, *_, last = sorted(every, key=lambda gate: gate.depth)
            where = f"{len(places)} channels, {len(every)} gates from {metres(first)} to {metres(last)} m"
        else:
            where = "; ".join(f"{place}, {depths(gates)}" for place, gates in places.items())
        sentences.append(f"{where}: {why.format(percents([gate.error for gate in every]))}")
    return sentences


def met(one):
    """The number of gates that met the target, by channel where some did not."""
    missed = [channel for channel in one.channels if channel.left]
    if len(one.channels) == 1 or not missed:
        return f"{one.gates - one.left} of {one.gates}"
    by_channel = ", ".join(f"{channel.place} {channel.gates - len(channel.left)} of {channel.gates}" for channel in missed)
    if len(missed) > MANY:
        by_channel = f"all of them in {len(one.channels) - len(missed)} of {len(one.channels)} channels"
    return f"{one.gates - one.left} of {one.gates}; {by_channel}"


def row(one):
    target = "10 % (none in the scene)" if one.target is None else percents([one.target])
    end = f"{one.stopped_by}, {one.seconds:.3g} s, {one.photons:.2g} photons".replace("e+0", "e")
    return [one.kind, one.estimator, end, target, met(one), "; ".join(reasons(one)) or "none"]


HEAD = ["starter", "estimator", "what ended it", "target", "gates that met it", "gates that did not"]


def table(runs, command, machine):
    return "\n".join([*pages.table(HEAD, map(row, runs)), "", f"`{command}` wrote this table. {machine}", ""])


def write(runs, command, page):
    machine = readme.machine(stamp(Runner(find_program())))
    page.write_text(marked.written(page.name, page.read_text(), "starters", table(runs, command, machine)))


def report(one):
    print(f"{one.kind}: {', '.join(row(one)[1:3])}; gates at the target: {met(one)}", *reasons(one), sep="\n  ", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("kind", nargs="*", metavar="KIND", help="default: all")
    parser.add_argument("--photons")
    parser.add_argument("--max-time")
    parser.add_argument("--threads", default="2")
    parser.add_argument("--write", action="store_true", help="the table of docs/accuracy.md; of all starters")
    asked = parser.parse_args()
    if asked.write and asked.kind:
        parser.error("--write takes no KIND: the table has all of them")
    more = ["--threads", asked.threads]
    for option in ("photons", "max_time"):
        if getattr(asked, option):
            more += [f"--{option.replace('_', '-')}", getattr(asked, option)]
    runs = []
    for kind in asked.kind or echo_scenes():
        runs.append(run(kind, more))
        report(runs[-1])
    if asked.write:
        write(runs, shlex.join(["experiments/starters.py", *sys.argv[1:]]), ROOT / pages.STARTERS_PAGE)
    stuck = [(one.kind, place, gate) for one in runs for place, gate in one.stuck]
    for kind, place, gate in stuck:
        print(f"{kind}: {place}, {metres(gate)} m: known to {percents([gate.error])}, and flagged {', '.join(gate.flags)}", file=sys.stderr)
    return 1 if stuck else 0


if __name__ == "__main__":
    sys.exit(main())
