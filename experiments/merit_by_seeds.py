#!/usr/bin/python3
"""Figures of merit of the bidirectional estimator by depth, from the scatter of short runs over many seeds.

    experiments/merit_by_seeds.py build/release/apps/photic/photic scenes/benchmark-peaked.toml 160000 60 \
        simulation.walks=2 simulation.connected_fraction=0.6

Figures are 1 / (relative variance x CPU time of a run) [1/s], the geometric mean over the gates of a band of depth. `photic
bench` compares with a long run, in 12 repeats, which leaves 41 %; here the scatter alone counts, known to sqrt(2 / (seeds - 1))
for one gate and better for a band. That flatters estimators whose large scores are rare: not for the forward one.
"""

import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import netCDF4
import numpy as np

BANDS = [(0, 8), (4, 6), (8, 16), (16, 25), (25, 33), (33, 41), (38, 42), (41, 50)]  # [m]


def run(program, scene, photons, seed, settings, out):
    settings = ["simulation.estimator=bidirectional", f"simulation.seed={seed}", *settings]
    command = [program, "run", scene, "-o", out, "--threads", "1", "--photons", photons]
    subprocess.run([*command, *(w for s in settings for w in ("--set", s))], check=True, capture_output=True)


def read(out):
    """Echo of the first telescope and channel by gate, depth of the gates [m], time [s]."""
    with netCDF4.Dataset(out) as file:
        return np.ma.filled(file["echo"][0, 0], np.nan), np.ma.filled(file["gate_depth"][0, 0], np.nan), float(file.wall_time_s)


def main():
    program, scene, photons, seeds, settings = sys.argv[1], sys.argv[2], sys.argv[3], int(sys.argv[4]), sys.argv[5:]
    with tempfile.TemporaryDirectory() as folder:
        outs = [Path(folder) / f"{seed}.nc" for seed in range(1, seeds + 1)]
        with ThreadPoolExecutor(2) as pool:
            list(pool.map(lambda o: run(program, scene, photons, int(o.stem), settings, o), outs))
        results = [read(out) for out in outs]
    echo = np.array([r[0] for r in results])
    seconds = np.mean([r[2] for r in results])
    depth = results[0][1]
    merit = echo.mean(axis=0) ** 2 / (echo.var(axis=0, ddof=1) * seconds)
    print(f"{seeds} seeds, {seconds:.2f} s each, one gate known to {np.sqrt(2 / (seeds - 1)):.0%}")
    for low, high in [*BANDS, (0, np.inf)]:
        inside = (depth >= low) & (depth < high)
        print(f"{low:4.0f} to {high:4.0f} m: {np.exp(np.log(merit[inside]).mean()):.3g}")


if __name__ == "__main__":
    main()
