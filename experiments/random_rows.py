#!/usr/bin/python3
"""Rows of columns that nobody designed: the forward estimator against analog photons.

    experiments/random_rows.py build/release/apps/photic/photic 24

Draws so many rows of 2 to 5 columns with layers and beds of their own, with ends or without, under a flat sea or waves, some
with a film of oil, seen by lidars of any tilt, view and aperture a few metres above them. For each it lists how many cells by
order and by process analog photons know to 12 %, none where light misses the row, and their rms z. Exits with 1 if any |z| is beyond what chance allows in one
of a hundred such runs.
"""

import random
import subprocess
import sys
import tempfile
from pathlib import Path
from statistics import NormalDist

import netCDF4
import numpy as np

PHOTONS = {"forward": 3e5, "analog": 1.5e7}
KNOWN_TO = 0.12
FALSE_ALARMS = 0.01
SURFACES = ['model = "flat"', 'model = "cox-munk", wind_speed_m_s = 6.0, wind_direction_deg = 30',
            'model = "gaussian", upwind_slope_variance = 0.02, crosswind_slope_variance = 0.0']


def layer(draw, bottom_m):
    a, b, g = draw.uniform(0.02, 0.4), draw.uniform(0.05, 1.2), draw.uniform(0, 0.8)
    iop = ", ".join(f"{{ wavelength_nm = {nm}, a_per_m = {a:.3g}, b_per_m = {b:.3g} }}" for nm in (350, 800))
    return (f"[[sea.column.layer]]\nbottom_depth_m = {bottom_m:.3f}\niop = [{iop}]\n"
            f'phase_function = {{ model = "henyey-greenstein", g = {g:.2f} }}\n')


def row(draw, centre_m, ends):
    """Columns about x = `centre_m`, down to one depth."""
    columns, depth_m = draw.randint(2, 5), draw.uniform(1.5, 4)
    x_m = centre_m - draw.uniform(0.2, 1)
    out = f"x_min_m = {x_m - 1:.3f}\n" if ends else ""
    parts = []
    for k in range(columns):
        keys = out if k == 0 else ""
        if k < columns - 1 or ends:
            keys += f"x_max_m = {x_m:.3f}\n"
        x_m += draw.uniform(0.1, 0.9)
        bottoms = sorted(draw.uniform(0.2, depth_m - 0.2) for _ in range(draw.randint(0, 2))) + [depth_m]
        bed = f"[sea.column.bottom]\nalbedo = {draw.uniform(0.05, 0.6):.2f}\n" if draw.random() < 0.6 else ""
        parts.append(f"[[sea.column]]\n{keys}" + "".join(layer(draw, bottom) for bottom in bottoms) + bed)
    return "".join(parts)


def scene(draw):
    height_m, tilt = draw.uniform(1.5, 6), (draw.uniform(-0.4, 0.4), draw.uniform(-0.3, 0.3))
    laser_m, ends, film = draw.uniform(-0.5, 0.5), draw.random() < 0.4, draw.random() < 0.3
    first_ns = height_m / 0.15 - 6
    processes = ["elastic", "raman"] + ["oil"] * film
    channels = "".join(f'[[channel]]\nname = "{each}"\nprocess = "{each}"\n' for each in processes)
    return (
        f"[source]\nwavelength_nm = {draw.choice([355, 440, 532])}\n"
        f"position_m = [{laser_m:.3f}, {draw.uniform(-0.2, 0.2):.3f}, {height_m:.3f}]\n"
        f"direction = [{tilt[0]:.3f}, {tilt[1]:.3f}, -1]\ndiameter_m = 0.1\n"
        f"half_divergence_mrad = {draw.uniform(5, 60):.1f}\n"
        f"[[telescope]]\nposition_m = [{draw.uniform(-0.8, 0.8):.3f}, {draw.uniform(-0.5, 0.5):.3f}, "
        f"{height_m * draw.uniform(0.7, 1.2):.3f}]\n"
        f"direction = [{tilt[0] + draw.uniform(-0.1, 0.1):.3f}, {tilt[1]:.3f}, -1]\n"
        f"diameter_m = {draw.uniform(0.8, 2):.2f}\nfocal_length_m = 4\n"
        f"half_field_of_view_mrad = {draw.uniform(200, 600):.0f}\n{channels}"
        f"[gates]\nstart_ns = {first_ns:.2f}\nstop_ns = {first_ns + 50:.2f}\nstep_ns = 10\n"
        f"[sea]\nsurface = {{ {draw.choice(SURFACES)} }}\n" + ("y_min_m = -0.6\ny_max_m = 0.9\n" if ends else "")
        + row(draw, laser_m + tilt[0] * height_m, ends)
        + (f'[oil]\nclass = "weakly-absorbing-crude"\nthickness_um = {draw.uniform(0.5, 5):.1f}\n' if film else "")
        + "[simulation]\nphotons = 1000\n")


def run(program, folder, number, estimator):
    out = folder / f"{estimator}.nc"
    options = ["--photons", str(int(PHOTONS[estimator])), "--seed", str(number + 1000 * (estimator == "analog"))]
    subprocess.run([program, "run", folder / "row.toml", "-o", out, "--force", "--set",
                    f'simulation.estimator="{estimator}"', *options], check=True, capture_output=True)
    with netCDF4.Dataset(out) as file:
        names = [name + error for name in ("echo_by_order", "echo_by_process") for error in ("", "_standard_error")]
        by_order, order_error, by_process, process_error = (np.ma.filled(file[name][:], np.nan).ravel() for name in names)
    return np.concatenate([by_order, by_process]), np.concatenate([order_error, process_error])


def scores(program, folder, number):
    """The z of cells that analog photons know: by the counts that are expected, so that chance does not choose them."""
    (folder / "row.toml").write_text(scene(random.Random(number)))
    expected, error = run(program, folder, number, "forward")
    counted, _ = run(program, folder, number, "analog")
    with np.errstate(invalid="ignore"):
        by_chance = np.sqrt(expected / PHOTONS["analog"])
        known = by_chance < KNOWN_TO * expected
    return (counted[known] - expected[known]) / np.hypot(error[known], by_chance[known])


def main(program, rows):
    every = []
    with tempfile.TemporaryDirectory() as folder:
        for number in range(int(rows)):
            z = scores(program, Path(folder), number)
            every.extend(z)
            print(f"row {number}: {len(z)} cells" + (f", rms z {np.sqrt(np.mean(z**2)):.2f}" if len(z) else ""), flush=True)
    each = 1 - (1 - FALSE_ALARMS) ** (1 / len(every))
    limit = NormalDist().inv_cdf(1 - each / 2)
    z = np.abs(every)
    print(f"{len(z)} cells, rms z {np.sqrt(np.mean(z**2)):.3f}, largest {z.max():.2f} of {limit:.2f}")
    return int(z.max() > limit)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    sys.exit(main(*sys.argv[1:]))
