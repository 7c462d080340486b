#!/usr/bin/python3
"""Claimed errors over the scatter of short runs over many seeds, by quarters of depth.

    experiments/claims_by_seeds.py build/release/apps/photic/photic 40           # all four scenes
    experiments/claims_by_seeds.py build/release/apps/photic/photic 40 rov-near  # some

Runs are of the bidirectional estimator, 60 000 photons each. A claim is the mean of the standard errors that the runs report, the
scatter the standard deviation of their echoes, known to sqrt(1 / (2 (seeds - 1))) in one gate. The geometric mean over a quarter's
gates is listed with claims as means and as root mean squares, which a few runs dominate where large scores are rare, then the largest
ratio (of means) of one gate, the share of gates that are not flagged, and the coverage of their 95 % intervals of the mean echo.
"""

import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np
from coverage_by_seeds import TWO_SIDED_95, read
from merit_by_seeds import run
from near_and_far import UNLIMITED

SCENE_FOLDER = Path(__file__).parent.parent / "scenes"
PHOTONS = 60_000
QUARTERS = 4
SCENES = {  # scene file, settings, rows (a channel of a telescope each)
    "ship": ("ship", [], 3),
    "narrow": ("ship", ["telescope.0.detector_diameter_m=0.008"], 3),  # half a view of 2 mrad
    "biaxial": ("biaxial", [], 2),
    "rov": ("rov", [], 2),
    "rov-near": ("rov", ["gates={ range_min_m = 0, range_max_m = 6, range_step_m = 0.5 }"], 2),
}


def runs_of(program, name, seeds, folder):
    """Echo, standard error and whether converged, each [seed][row][gate]."""
    scene, settings, rows = SCENES[name]
    outs = [Path(folder) / f"{name}.{seed}.nc" for seed in range(1, seeds + 1)]

    def one(out):
        run(program, SCENE_FOLDER / f"{scene}.toml", str(PHOTONS), out.suffixes[0][1:], [*UNLIMITED, *settings], out)

    with ThreadPoolExecutor(2) as pool:
        list(pool.map(one, outs))
    return np.array([read(out)["echo"].reshape(3, rows, -1) for out in outs]).swapaxes(0, 1)


def over_scatter(echo, claim):
    """Claimed errors over the scatter of the echoes, [row][gate]."""
    return claim / echo.std(axis=0, ddof=1)


def report(name, runs):
    echo, error, converged = runs
    means = np.log(over_scatter(echo, error.mean(axis=0)))
    squares = np.log(over_scatter(echo, np.sqrt((error**2).mean(axis=0))))
    covers = np.abs(echo - echo.mean(axis=0)) / np.sqrt(1 - 1 / len(echo)) < TWO_SIDED_95 * error
    for row in range(echo.shape[1]):
        for quarter, inside in enumerate(np.array_split(np.arange(echo.shape[2]), QUARTERS)):
            free = converged[:, row, inside] == 1
            covered = covers[:, row, inside][free].mean() if free.any() else np.nan
            print(f"{name:9}{row:3}{quarter + 1:8}{np.exp(means[row, inside].mean()):8.2f}{np.exp(squares[row, inside].mean()):6.2f}"
                  f"{np.exp(means[row, inside].max()):9.2f}{free.mean():11.3f}{100 * covered:10.1f}")


def main():
    program, seeds, names = sys.argv[1], int(sys.argv[2]), sys.argv[3:] or list(SCENES)
    print(f"{'scene':9}{'row':>3}{'quarter':>8}{'claim':>8}{'rms':>6}{'largest':>9}{'unflagged':>11}{'covered %':>10}")
    with tempfile.TemporaryDirectory() as folder:
        for name in names:
            report(name, runs_of(program, name, seeds, folder))


if __name__ == "__main__":
    main()
