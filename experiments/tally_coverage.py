#!/usr/bin/python3
"""Measures how often the standard errors of tallies hold what they claim: the coverage of intervals of 95 %.

    experiments/tally_coverage.py build/release/apps/photic/photic
    experiments/tally_coverage.py build/release/apps/photic/photic --scene scenes/cone.toml --seeds 100 --photons 3e5

A scene is run with many seeds. The truth of each cell is the mean of all runs. Cells count that are not
flagged in a run and whose light is not known without chance. Printed are, by quantity and of all, how many of these are within
1.96 standard errors of the truth (95 %), and within 1 (68.3 %). Of the one scene of `./test` 93 to 97 % are allowed.
"""

import argparse
import subprocess
import sys
import tempfile
from pathlib import Path

import netCDF4
import numpy as np

FLAGS = "_convergence_flags"
LEAST_ERROR = 1e-6  # of the value; below it nothing is left to chance


def run(program, scene, photons, seed):
    """By quantity: values, standard errors and flags of its cells."""
    with tempfile.TemporaryDirectory() as folder:
        done = subprocess.run([program, "run", scene, "-o", f"{folder}/out.nc", "--seed", str(seed), "--photons", f"{photons:.0f}",
                               "--target", "0.0001%", "--max-time", "10h"], capture_output=True, text=True)
        if done.returncode != 0:
            sys.exit(done.stderr)
        with netCDF4.Dataset(f"{folder}/out.nc") as file:
            names = [name.removesuffix(FLAGS) for name in file.variables if name.endswith(FLAGS)]
            return {name: [np.ma.filled(file[name + end][:], np.nan).ravel() for end in ("", "_standard_error", FLAGS)]
                    for name in names if name + "_standard_error" in file.variables and name != "echo"}


def coverage(runs, name):
    """The number of unflagged cells of all runs, and the numbers within 1.96 and 1 errors of the truth."""
    value, error, flags = (np.array([one[name][i] for one in runs]) for i in range(3))
    truth = value.mean(0)
    counts = (flags == 0) & (error > LEAST_ERROR * truth)
    z = np.abs(value - truth)[counts] / np.sqrt(1 - 1 / len(runs)) / error[counts]  # each run is a part of the mean
    return np.array([z.size, (z < 1.96).sum(), (z < 1).sum()])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--scene", default=Path(__file__).parent.parent / "scenes/sun.toml")
    parser.add_argument("--seeds", type=int, default=100)
    parser.add_argument("--photons", type=float, default=1e5)
    asked = parser.parse_args()
    runs = [run(asked.program, asked.scene, asked.photons, seed) for seed in range(1, asked.seeds + 1)]
    counted = {name: coverage(runs, name) for name in runs[0]}
    for name, (cells, two, one) in (counted | {"all": sum(counted.values())}).items():
        if cells:
            print(f"{name:28} {cells:6} cells {100 * two / cells:6.1f} % within 1.96 errors {100 * one / cells:6.1f} % within 1")


if __name__ == "__main__":
    main()
