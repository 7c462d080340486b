#!/usr/bin/python3
"""Near and far: which gates of lidars in the water and high above it are wrong and not flagged, whatever estimator a scene names.

    experiments/near_and_far.py run build/release/apps/photic/photic FOLDER [--seeds 8] [SCENE ...]
    experiments/near_and_far.py look FOLDER [SCENE ...]

`run` keeps one file for each scene, estimator, length of run and seed in FOLDER, and goes on with what is missing. `look` holds every
run against the mean of all long runs of the other estimator and of its own, each gate weighed by what seeds scatter, and prints a row
for each scene, estimator, length and channel:

    gates    seen by the reference to better than 3 %, times seeds
    free     of them not flagged
    wrong    of those off the reference by more than 4 standard errors (its own and the reference's)
    cover    share of the free gates within 1.96 of them
    mean z   over the free gates: a bias that no single one shows; the largest of a gate's means over seeds, in its own errors
    silly    flagged although the true error (rms over seeds about the reference) is below 5 %
"""

import argparse
import subprocess
from pathlib import Path

import netCDF4
import numpy as np

SHIP = Path(__file__).parent.parent / "scenes" / "ship.toml"
ESTIMATORS = {"forward": (1_000_000, 8_000_000), "bidirectional": (100_000, 500_000)}  # photons of short and long runs

UNLIMITED = ["simulation.target_relative_error=1e-6", "simulation.max_time_s=1e5"]
ELASTIC = "channel=[{ name = 'elastic', process = 'elastic' }]"
HG = ["sea.layer.0={ iop = [{ wavelength_nm = 532.0, a_per_m = 0.06, b_per_m = 0.10 }],"
      " phase_function = { model = 'henyey-greenstein', g = 0.924 } }", ELASTIC]
TURBID = ["sea.layer.0={ iop = [{ wavelength_nm = 532.0, a_per_m = 0.1, b_per_m = 2.0 }],"
          " phase_function = { model = 'fournier-forand', refractive_index = 1.10, slope = 3.5835 } }", ELASTIC]


def lidar(height, lens, view, laser, aside=0.0, up=False, spot=0.04):
    """Height [m], diameter of the lens [m], half field of view and half divergence of the laser [mrad]; telescope aside of it [m]."""
    axis = "[0, 0, 1]" if up else "[0, 0, -1]"
    return [f"source.position_m=[0, 0, {height}]", f"telescope.0.position_m=[{aside}, 0, {height}]",
            f"source.direction={axis}", f"telescope.0.direction={axis}", f"telescope.0.diameter_m={lens}",
            f"telescope.0.detector_diameter_m={2 * 2.0 * view / 1000}", f"source.half_divergence_mrad={laser}",
            f"source.diameter_m={spot}"]


def gates(low, high, step):
    return [f"gates.depth_min_m={low}", f"gates.depth_max_m={high}", f"gates.depth_step_m={step}"]


DEEP = gates(0, 40, 4)
SPACE = lidar(705e3, 1.0, 0.065, 0.05)
SCENES = {
    "ship": DEEP,
    "air": lidar(300, 0.3, 7.5, 2) + DEEP,
    "air-wide": lidar(300, 0.3, 25, 2) + DEEP,
    "space": SPACE + DEEP,
    "space-hg": SPACE + HG + DEEP,
    "space-turbid": SPACE + TURBID + gates(0, 5, 0.5),
    "space-wide": lidar(705e3, 1.0, 5, 0.25) + DEEP,
    "water": lidar(-5, 0.05, 30, 2, aside=0.1, spot=0.01) + gates(5, 9, 0.5),
    "water-hg": lidar(-5, 0.05, 30, 2, aside=0.1, spot=0.01) + HG + gates(5, 9, 0.5),
    "water-deep": lidar(-5, 0.05, 30, 2, aside=0.1, spot=0.01) + gates(5, 45, 4),
    "water-deep-hg": lidar(-5, 0.05, 30, 2, aside=0.1, spot=0.01) + HG + gates(5, 45, 4),
    "water-turbid": lidar(-5, 0.05, 30, 2, aside=0.1, spot=0.01) + TURBID + gates(5, 8, 0.3),
    "water-wide": lidar(-2, 0.02, 300, 2, aside=0.05, spot=0.01) + gates(2, 22, 2),
    "up": lidar(-20, 0.05, 30, 2, aside=0.1, up=True, spot=0.01) + ["gates={ range_min_m = 0, range_max_m = 40, range_step_m = 4 }"],
}


def path_of(folder, scene, estimator, photons, seed):
    return folder / f"{scene}.{estimator}.{photons}.{seed}.nc"


def run(program, folder, seeds, names):
    def one(job):
        name, estimator, photons, seed = job
        out = path_of(folder, *job)
        if out.exists():
            return
        settings = [f"simulation.estimator={estimator}", f"simulation.seed={seed}", *UNLIMITED, *SCENES[name]]
        command = [program, "run", SHIP, "-o", out, "--threads", "1", "--photons", str(photons), "--table", "none"]
        subprocess.run([*command, *(w for s in settings for w in ("--set", s))], check=True, stdout=subprocess.DEVNULL)

    jobs = [(name, estimator, photons, seed) for name in names for length in (0, 1)
            for estimator, lengths in ESTIMATORS.items() for photons in (lengths[length],) for seed in range(1, (seeds + 1 if length == 0 else seeds // 2 + 1))]
    for job in jobs:
        one(job)


def read(path):
    """Echo, standard error, flags, [channel][gate]."""
    with netCDF4.Dataset(path) as file:
        return [np.ma.filled(file[v][0].astype(float), np.nan) for v in ("echo", "echo_standard_error", "convergence_flags")]


def of_seeds(folder, scene, estimator, photons):
    """[seed][channel][gate] of echo, error and flags."""
    files = sorted(folder.glob(f"{scene}.{estimator}.{photons}.*.nc"))
    return np.array([read(f) for f in files]).swapaxes(0, 1) if files else None


def reference(runs):
    """Mean of all long runs, weighted by what is known of the scatter of each estimator; its error."""
    parts = []
    for echo, error, _ in runs:
        n = len(echo)
        # The larger of what seeds scatter and what runs claim: neither alone knows of what is rare.
        variance = np.maximum(echo.var(axis=0, ddof=1) / n, (error**2).mean(axis=0) / n)
        parts.append((echo.mean(axis=0), np.where(variance > 0, variance, np.inf)))
    weights = [1 / v for _, v in parts]
    total = sum(weights)
    return sum(w * m for w, (m, _) in zip(weights, parts)) / total, np.sqrt(1 / total), parts


def look(folder, names):
    print(f"{'scene':14} {'estimator':14}{'photons':>9} {'channel':>8}{'gates':>6}{'free':>6}{'wrong':>6}{'cover':>7}"
          f"{'mean z':>8}{'worst':>7}{'low %':>7}{'silly':>6}")
    for name in names:
        long_runs = {e: of_seeds(folder, name, e, n[1]) for e, n in ESTIMATORS.items()}
        if any(r is None or r.shape[1] < 2 for r in long_runs.values()):
            continue
        for estimator, lengths in ESTIMATORS.items():
            other = [r for e, r in long_runs.items() if e != estimator]
            both, both_error, parts = reference([long_runs[estimator], *other])
            for photons in lengths:
                runs = of_seeds(folder, name, estimator, photons)
                if runs is None:
                    continue
                echo, error, flags = runs
                for c in range(echo.shape[1]):
                    ref, ref_error = both[c], both_error[c]
                    known = ref_error < 0.03 * ref
                    free = (flags[:, c] == 0) & known
                    z = (echo[:, c] - ref) / np.hypot(error[:, c], ref_error)
                    z_free = np.where(free, z, np.nan)
                    n = free.sum(axis=0)
                    if n.sum() == 0:
                        gate_z = worst_low = np.zeros(1)
                    else:
                        with np.errstate(all="ignore"):
                            relative = np.where(free, echo[:, c] / ref - 1, np.nan)
                            gate_z = np.where(n > 1, np.nansum(z_free, axis=0) / np.sqrt(np.maximum(n, 1)), 0)
                            worst_low = np.nanmin(relative)
                    rms = np.sqrt(np.mean((echo[:, c] / ref - 1) ** 2, axis=0))
                    silly = ((flags[:, c] != 0) & known & (rms < 0.05)).sum()
                    print(f"{name:14} {estimator:14}{photons:9} {c:>8}{known.sum() * len(echo):6}{free.sum():6}"
                          f"{(np.abs(z_free) > 4).sum():6}{np.mean(np.abs(z[free]) < 1.96) if free.any() else np.nan:7.3f}"
                          f"{np.mean(z[free]) if free.any() else np.nan:8.2f}{gate_z[np.argmax(np.abs(gate_z))]:7.1f}"
                          f"{100 * np.min(worst_low):7.1f}{silly:6}")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("what", choices=["run", "look"])
    parser.add_argument("paths", nargs="+")
    parser.add_argument("--seeds", type=int, default=8)
    parsed = parser.parse_args()
    if parsed.what == "run":
        program, folder, *names = parsed.paths
        Path(folder).mkdir(parents=True, exist_ok=True)
        run(program, Path(folder), parsed.seeds, names or list(SCENES))
    else:
        folder, *names = parsed.paths
        look(Path(folder), names or list(SCENES))


if __name__ == "__main__":
    main()
