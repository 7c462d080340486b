#!/usr/bin/python3
"""How often 95 % intervals of environments' differences, and of derivatives, cover their mean over many seeds.

    experiments/coverage_of_differences.py build/release/apps/photic/photic forward 400000 40

The water is the ship's with 0.5 mg/m3 chlorophyll; one environment has 1 % more, and the derivative is with respect to
chlorophyll. Intervals of gates that are flagged are left out and counted.
"""

import subprocess
import sys
import tempfile
from pathlib import Path

import netCDF4
import numpy as np

PATH = "sea.layer.0.chlorophyll_mg_m3"
CHANGES = f'\n[[environment]]\nname = "more"\nset = {{ "{PATH}" = 0.505 }}\n'


def run(program, scene, estimator, photons, seed, out):
    settings = [f"simulation.estimator={estimator}", f"simulation.photons={photons}", f"simulation.seed={seed}"]
    command = [program, "run", scene, "-o", out, *(word for s in settings for word in ("--set", s))]
    subprocess.run(command, check=True, capture_output=True)
    with netCDF4.Dataset(out) as file:
        names = ("environment_difference", "sensitivity")
        converged = {"environment_difference": "environment_converged", "sensitivity": "sensitivity_converged"}
        return {
            name: [np.ma.filled(file[v][:], np.nan) for v in (name, name + "_standard_error", converged[name])] for name in names
        }


def main():
    program, estimator, photons, seeds = sys.argv[1], sys.argv[2], int(sys.argv[3]), int(sys.argv[4])
    with tempfile.TemporaryDirectory() as folder:
        scene = Path(folder) / "scene.toml"
        text = subprocess.run([program, "new", "ship"], check=True, capture_output=True, text=True).stdout
        scene.write_text(f'sensitivity = ["{PATH}"]\n' + text + CHANGES)
        water = ["--set", f"{PATH}=0.5", "--set", "gates.depth_max_m=5.0", "--set", "gates.depth_step_m=0.5"]
        shown = subprocess.run([program, "show", scene, *water], check=True, capture_output=True, text=True).stdout
        scene.write_text(shown)
        runs = [run(program, scene, estimator, photons, seed, Path(folder) / "out.nc") for seed in range(1, seeds + 1)]
    for name in ("environment_difference", "sensitivity"):
        value, error, converged = (np.array([r[name][k] for r in runs]) for k in range(3))
        off = np.abs(value - value.mean(axis=0)) / np.sqrt(1 - 1 / seeds)
        known = converged.astype(bool)
        covered = (off < 1.96 * error) & known
        print(f"{estimator}, {photons} photons, {name}: {100 * covered.sum() / max(1, known.sum()):.1f} % of {known.sum()} "
              f"unflagged cover, {known.size - known.sum()} are flagged")


main()
