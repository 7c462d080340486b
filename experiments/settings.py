#!/usr/bin/python3
"""Tests whether settings of the bidirectional estimator change errors alone: echoes at their ends, against one another.

    experiments/settings.py build/release/apps/photic/photic --photons 4e5
    experiments/settings.py build/release/apps/photic/photic --photons 4e5 --scenes focus plane --seed 2

Each scene of experiments/settings is run with every row of SETTINGS, and once with ten times the photons and its own settings.
Compared with that are the gates that are converged in both, those of environments as well: the difference of two echoes over the
error of that difference. No |z| may be above 4.5, and the root mean square of a scene is to lie between 0.8 and 1.25.
`--photons`: of a run; settings that cost more have fewer. A line for each setting is printed with `--each`.
"""

import argparse
import subprocess
import sys
import tempfile
from pathlib import Path

import netCDF4
import numpy as np

SCENES = Path(__file__).parent / "settings"
MOST_Z, RMS = 4.5, (0.8, 1.25)
OWN = {"free_telescope_meetings": 0.1, "free_laser_meetings": 0.3}
NO_FREE_WALKS = {"free_telescope_meetings": 0, "free_laser_meetings": 0}
SETTINGS = {  # its settings, and the share of the photons that it has
    "meetings 1": (OWN | {"meetings": 1}, 1),
    "meetings 10000": (OWN | {"meetings": 10000}, 0.1),
    "walks 1": (OWN | {"walks": 1}, 1),
    "walks 16": (OWN | {"walks": 16}, 0.25),
    "walk_attenuation 0.3": (OWN | {"walk_attenuation": 0.3}, 1),
    "walk_attenuation 0.99": (OWN | {"walk_attenuation": 0.99}, 1),
    "random": (OWN | {"sampling": '"random"'}, 1),
    "no free walks": (NO_FREE_WALKS, 1),
    "free walks of telescopes": ({"free_telescope_meetings": 3, "free_laser_meetings": 0}, 0.5),
    "free walks of the laser": ({"free_telescope_meetings": 0, "free_laser_meetings": 3}, 0.5),
    "connected_fraction 0.01": (OWN | {"connected_fraction": 0.01}, 1),
    "connected_fraction 1": (OWN | {"connected_fraction": 1}, 1),
}
FEWEST = 20000  # with fewer than 7500 no gate is converged; of half as many, errors of film.toml are too small
KINDS = {"echo": "converged", "environment_echo": "environment_converged"}


def run(program, scene, settings, photons, seed, threads):
    """Echoes, their errors, and whether they are converged: of gates, then of their environments."""
    with tempfile.TemporaryDirectory() as folder:
        command = [program, "run", SCENES / f"{scene}.toml", "-o", f"{folder}/out.nc", "--seed", str(seed), "--photons", f"{photons:.0f}",
                   "--threads", str(threads), "--target", "0.0001%", "--max-time", "10h", "--set", "simulation.estimator=bidirectional"]
        for key, value in settings.items():
            command += ["--set", f"simulation.{key}={value}"]
        done = subprocess.run(command, capture_output=True, text=True)
        if done.returncode != 0:
            sys.exit(f"{scene}: {done.stderr}")
        with netCDF4.Dataset(f"{folder}/out.nc") as file:
            rows = [[np.ma.filled(file[name][:], np.nan).ravel() for name in (kind, f"{kind}_standard_error", converged)]
                    for kind, converged in KINDS.items() if kind in file.variables]
    return np.concatenate(rows, axis=1)


def differences(one, reference):
    known = (one[2] == 1) & (reference[2] == 1) & (one[1] > 0)
    (value, error, _), (truth, own, _) = one[:, known], reference[:, known]
    return (value - truth) / np.hypot(error, own)


def compare(program, scene, photons, seed, threads=1):
    """The differences of a scene, by setting."""
    reference = run(program, scene, OWN, 10 * photons, 100 * seed, threads)
    z = {}
    for n, (what, (settings, share)) in enumerate(SETTINGS.items(), 1):
        z[what] = differences(run(program, scene, settings, max(FEWEST, share * photons), 100 * seed + n, threads), reference)
    return z


def in_words(what, z):
    if z.size == 0:
        return f"{what}: nothing to compare"
    largest, rms = np.abs(z).max(), np.sqrt(np.mean(z**2))
    return f"{what}: {z.size} compared, largest |z| {largest:.2f}, rms z {rms:.3f}, mean z {z.mean():+.3f}"


def held(z):
    return bool(z.size > 0 and np.abs(z).max() <= MOST_Z and RMS[0] < np.sqrt(np.mean(z**2)) < RMS[1])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--scenes", nargs="+", default=sorted(path.stem for path in SCENES.glob("*.toml")))
    parser.add_argument("--photons", type=float, default=4e5)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--threads", type=int, default=1)
    parser.add_argument("--each", action="store_true")
    asked = parser.parse_args()
    all_held = True
    for scene in asked.scenes:
        z = compare(asked.program, scene, asked.photons, asked.seed, asked.threads)
        together = np.concatenate(list(z.values()))
        all_held &= held(together)
        print(in_words(scene, together) + ("" if held(together) else "   NOT HELD"), flush=True)
        for what, one in z.items():
            if asked.each or (one.size and np.abs(one).max() > MOST_Z):
                print("  " + in_words(what, one), flush=True)
    return 0 if all_held else 1


if __name__ == "__main__":
    sys.exit(main())
