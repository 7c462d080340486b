#!/usr/bin/python3
"""Which gates of the starters (`photic new KIND`) are not converged at the end of their runs, and why.

    experiments/starters.py                           # all of them, as they are
    experiments/starters.py oil-spill ship --threads 1
    experiments/starters.py --photons 1e5             # shorter; also --max-time

For each channel of each telescope: how many of its gates met the target, which did not, and what ended the run. Of the
latter those are marked that are *known*: their error is below the target (10 % where the scene has none), and a flag
keeps them from being converged. The exit code is 1 if any are known and `beam_missed`, which says that a run is too
short and not that its gates are hard.

The program is that of PHOTIC_PROGRAM, or build/release/apps/photic/photic.
"""

import argparse
import os
import re
import subprocess
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path

import netCDF4
import numpy as np

SOURCE = Path(__file__).resolve().parent.parent
NO_TARGET = 0.1


@dataclass
class Gate:
    """Of a starter, not converged to its target."""

    place: str  # telescope, channel, number of the gate
    error: float  # relative
    flags: list
    known: bool  # to the target


@dataclass
class Channel:
    place: str  # telescope and channel
    gates: int  # that were scored in
    left: list  # not converged to the target


def program():
    return os.environ.get("PHOTIC_PROGRAM", SOURCE / "build/release/apps/photic/photic")


def kinds():
    listed = subprocess.run([program(), "new", "--list"], capture_output=True, text=True, check=True).stdout
    return [line.split(":")[0] for line in listed.splitlines()]


def channels_of(file):
    """The channels of a result, and what of them is not converged to its target."""
    target = re.search(r"^target_relative_error = (\S+)|[{,] *target_relative_error = ([^\s,]+)", file.scene, re.MULTILINE)
    target = float(target[1] or target[2]) if target else NO_TARGET
    masks = dict(zip(file["convergence_flags"].flag_meanings.split(), file["convergence_flags"].flag_masks))
    echo, error, flags = (np.ma.filled(file[name][:], np.nan) for name in ("echo", "echo_standard_error", "convergence_flags"))
    telescopes, names = file["telescope_name"][:], file["channel_name"][:]
    out = []
    for t, c in np.ndindex(echo.shape[:2]):
        scored = np.flatnonzero(echo[t, c] > 0)
        channel = Channel(f"{telescopes[t]} {names[c]}", len(scored), [])
        for g in scored:
            relative = error[t, c, g] / echo[t, c, g]
            raised = [name for name, mask in masks.items() if int(flags[t, c, g]) & mask]
            if raised or not relative <= target:
                channel.left.append(Gate(f"{channel.place} gate {g}", relative, raised, bool(relative <= target)))
        out.append(channel)
    return out


def run(kind, folder, more):
    """The channels of a starter's result, what ended the run, its estimator and its photons."""
    subprocess.run([program(), "new", kind, "-o", f"{folder}/{kind}.toml"], check=True, capture_output=True)
    command = [program(), "run", f"{folder}/{kind}.toml", "-o", f"{folder}/{kind}.nc", "--table", "none", *more]
    subprocess.run(command, check=True, capture_output=True)
    with netCDF4.Dataset(f"{folder}/{kind}.nc") as file:
        file.set_auto_mask(False)
        return channels_of(file), file.stopped_by, file.estimator, int(file.photons)


def stuck(channels):
    """Gates that are known to the target, and flagged as if nothing had been seen of them."""
    return [gate for channel in channels for gate in channel.left if gate.known and "beam_missed" in gate.flags]


def tell(kind, channels, stopped_by, estimator, photons):
    print(f"{kind}: {estimator}, {photons:.3g} photons, stopped by {stopped_by}")
    for channel in channels:
        if not channel.left:
            continue
        print(f"  {channel.place}: {channel.gates - len(channel.left)} of {channel.gates} gates")
        for gate in channel.left:
            why = ", ".join(gate.flags) or "above the target"
            print(f"    {gate.place.split()[-1]:>4}: {100 * gate.error:.2g} %, {why}{'   KNOWN' if gate.known else ''}")
    sys.stdout.flush()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("kind", nargs="*", metavar="KIND", help="default: all")
    parser.add_argument("--photons")
    parser.add_argument("--max-time")
    parser.add_argument("--threads", default="1")
    asked = parser.parse_args()
    more = ["--threads", asked.threads]
    for option in ("photons", "max_time"):
        if getattr(asked, option):
            more += [f"--{option.replace('_', '-')}", getattr(asked, option)]
    left = []
    with tempfile.TemporaryDirectory() as folder:
        for kind in asked.kind or kinds():
            channels, *told = run(kind, folder, more)
            tell(kind, channels, *told)
            left += stuck(channels)
    for gate in left:
        print(f"known, and flagged for ever: {gate.place}, {100 * gate.error:.2g} %", file=sys.stderr)
    return 1 if left else 0


if __name__ == "__main__":
    sys.exit(main())
