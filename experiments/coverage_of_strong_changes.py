#!/usr/bin/python3
"""The share of 95 % intervals that cover runs of their own, for environments of many times the scene's attenuation.

    experiments/coverage_of_strong_changes.py build/release/apps/photic/photic bidirectional 0.924 62000 100

Water of albedo 0.625 that scatters by Henyey and Greenstein's function with the given asymmetry, to 10 m; SEEDS runs of
PHOTONS photons, each with all environments. Gates that are flagged are left out and counted. The truth: bidirectional
runs with 4e6 photons, whose errors are added.
"""

import subprocess
import sys
import tempfile
from pathlib import Path

import netCDF4
import numpy as np

CHANGES = (0.4, 0.7, 1.5, 2.5)
A_PER_M, B_PER_M = 0.06, 0.10


def water(times):
    return {"sea.layer.0.iop.0.a_per_m": A_PER_M * times, "sea.layer.0.iop.0.b_per_m": B_PER_M * times}


def run(program, scene, out, settings, names):
    words = [word for path, value in settings.items() for word in ("--set", f"{path}={value}")]
    subprocess.run([program, "run", scene, "-o", out, *words], check=True, capture_output=True)
    with netCDF4.Dataset(out) as file:
        return np.array([np.ma.filled(file[name][:], np.nan).squeeze() for name in names])


def main():
    program, estimator, g, photons, seeds = sys.argv[1], sys.argv[2], float(sys.argv[3]), int(float(sys.argv[4])), int(sys.argv[5])
    gates = {"gates.depth_max_m": 10, "gates.depth_step_m": 1}
    with tempfile.TemporaryDirectory() as folder:
        scene, out = Path(folder) / "scene.toml", Path(folder) / "out.nc"
        text = (Path(__file__).parent.parent / "scenes/benchmark-hg.toml").read_text()
        scene.write_text(text)
        phase = {"sea.layer.0.phase_function.g": g}
        names = ("echo", "echo_standard_error", "converged")
        truth = [
            run(program, scene, out, gates | phase | water(times) | {"simulation.estimator": "bidirectional", "simulation.photons": 4e6}, names)
            for times in CHANGES
        ]
        for times in CHANGES:
            change = ", ".join(f'"{path}" = {value}' for path, value in water(times).items())
            text += f'\n[[environment]]\nname = "{times}"\nset = {{ {change} }}\n'
        scene.write_text(text)
        names = ("environment_echo", "environment_echo_standard_error", "environment_converged")
        settings = gates | phase | {"simulation.estimator": estimator, "simulation.photons": photons}
        runs = np.array([run(program, scene, out, settings | {"simulation.seed": seed}, names) for seed in range(1, seeds + 1)])
    for e, times in enumerate(CHANGES):
        value, error, converged = (runs[:, k, e] for k in range(3))
        true_value, true_error, known = truth[e]
        unflagged = (converged == 1) & (known == 1)
        covered = unflagged & (np.abs(value - true_value) < 1.96 * np.hypot(error, true_error))
        by_gate = ", ".join(f"{c} of {n}" for c, n in zip(covered.sum(axis=0), unflagged.sum(axis=0)))
        print(f"{estimator}, attenuation times {times}: of {unflagged.size} gates {unflagged.sum()} are not flagged; "
              f"{100 * covered.sum() / max(1, unflagged.sum()):.1f} % of these cover (gate by gate {by_gate})")


if __name__ == "__main__":
    main()
