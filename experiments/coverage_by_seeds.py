#!/usr/bin/python3
"""The share of 95 % intervals of a scene's gates that are not flagged which cover the mean over many seeds.

    experiments/coverage_by_seeds.py build/release/apps/photic/photic experiments/hard.toml 100 \
        --set simulation.estimator=bidirectional --photons 120000
    experiments/coverage_by_seeds.py build/release/apps/photic/photic scenes/benchmark-peaked.toml 100 --target 5%
    experiments/coverage_by_seeds.py build/release/apps/photic/photic scenes/ship.toml 40 --set gates.depth_max_m=5 \
        --set sea.layer.0.chlorophyll_mg_m3=0.5 --set 'environment_grid.sea.layer.0.chlorophyll_mg_m3=[0.505]' \
        --set 'sensitivity=["sea.layer.0.chlorophyll_mg_m3"]' --set simulation.estimator=forward --photons 400000

The options after the number of seeds are those of `photic run`. For echoes, differences and derivatives the script lists the share of
gates that are not flagged, the share of these whose interval covers, the root mean square of their errors over those that are
claimed, and how many intervals lie below the mean and above it. With `--reference RESULT` first among the options the mean is
that of a long run, whose own errors are added, and of whose gates only those are compared that have converged.
"""

import subprocess
import sys
import tempfile
from pathlib import Path

import netCDF4
import numpy as np

sys.path.insert(0, str(Path(__file__).parent.parent / "benchmarks"))
from measure.coverage import TWO_SIDED_95, share

KINDS = {  # what is estimated: whether its gates are converged
    "echo": "converged",
    "environment_difference": "environment_converged",
    "sensitivity": "sensitivity_converged",
}


def read(out):
    """By kind (value, standard error, whether converged), a row each, of all gates."""
    with netCDF4.Dataset(out) as file:
        return {
            kind: np.array([np.ma.filled(file[name][:], np.nan).ravel() for name in (kind, f"{kind}_standard_error", converged)])
            for kind, converged in KINDS.items() if kind in file.variables
        }


def run(program, scene, seed, options, out):
    command = [program, "run", scene, "-o", out, *options, "--seed", str(seed)]
    subprocess.run(command, check=True, capture_output=True)
    return read(out)


def report(kind, runs, reference):
    value, error, converged = (np.array([r[kind][k] for r in runs]) for k in range(3))
    unflagged = (converged == 1) & (error > 0)
    if reference is None:
        z = (value - value.mean(axis=0)) / np.sqrt(1 - 1 / len(runs)) / np.where(unflagged, error, 1)
        compared = unflagged
    else:
        truth, own, known = reference[kind]
        z = (value - truth) / np.where(unflagged, np.hypot(error, own), 1)
        compared = unflagged & (known == 1)
    covered, scatter = share((compared & (np.abs(z) < TWO_SIDED_95)).sum(axis=1), compared.sum(axis=1))
    z = z[compared]
    print(f"{kind}: {100 * unflagged.mean():.1f} % of {unflagged.size} gates are not flagged; of {z.size} intervals "
          f"{100 * covered:.1f} +- {100 * scatter:.1f} % cover, {100 * np.mean(z < -TWO_SIDED_95):.1f} % are too low, "
          f"{100 * np.mean(z > TWO_SIDED_95):.1f} % too high; rms error over claimed {np.sqrt(np.mean(z**2)):.3f}")


def main():
    program, scene, seeds, options = sys.argv[1], sys.argv[2], int(sys.argv[3]), sys.argv[4:]
    reference = None
    if options[:1] == ["--reference"]:
        reference, options = read(options[1]), options[2:]
    with tempfile.TemporaryDirectory() as folder:
        runs = []
        for seed in range(1, seeds + 1):
            runs.append(run(program, scene, seed, options, Path(folder) / f"{seed}.nc"))
            if reference and any(rows.shape != reference[kind].shape for kind, rows in runs[0].items()):
                sys.exit("coverage_by_seeds.py: the reference has other gates or channels than the scene")
    for kind in runs[0]:
        report(kind, runs, reference)


if __name__ == "__main__":
    main()
