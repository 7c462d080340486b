#!/usr/bin/python3
"""Tests whether the forward and the bidirectional estimator agree in every gate and every order of scattering, over many seeds.

    experiments/agreement_by_seeds.py build/release/apps/photic/photic scenes/airborne.toml --seeds 20 \
        --forward 2e6 --bidirectional 2e5

For each scene three lines, gates, processes and orders: of pairs of runs of equal seeds, in what is converged in both by its own flags,
the difference of two echoes over the error of that difference. The largest may pass its limit by chance in one of a hundred families;
the root mean square is to lie between 0.9 and 1.15. Below 0.9 it shows errors that are stated too large, not estimators that differ.
`--forward` and `--bidirectional` are numbers of photons.
"""

import argparse
import subprocess
import sys
import tempfile
from pathlib import Path

import netCDF4
import numpy as np

sys.path.insert(0, str(Path(__file__).parent.parent / "benchmarks"))
from measure.accuracy import family_wise_z

RMS = (0.9, 1.15)
ECHOES = {"echo": "converged", "echo_by_process": "echo_by_process_converged", "echo_by_order": "echo_by_order_converged"}


def run(asked, scene, estimator, seed, out):
    photons = getattr(asked, estimator)
    command = [asked.program, "run", scene, "-o", out, "--photons", photons, "--seed", str(seed), "--threads", str(asked.threads)]
    subprocess.run([*command, "--set", f"simulation.estimator={estimator}", "--target", "0.01%", "--max-time", "1h"], check=True, capture_output=True)
    with netCDF4.Dataset(out) as file:
        return {echo: [np.ma.filled(file[name][:], np.nan) for name in (echo, f"{echo}_standard_error", converged)]
                for echo, converged in ECHOES.items()}


def differences(a, b):
    """z of what is converged in both."""
    (value, error, converged), (other, other_error, other_converged) = a, b
    both = (converged == 1) & (other_converged == 1)
    return ((other - value)[both] / np.hypot(error, other_error)[both]).tolist()


def in_words(name, z):
    if not z:
        return f"  {name}: nothing to compare"
    z = np.array(z)
    limit, rms = family_wise_z(z.size), float(np.sqrt(np.mean(z**2)))
    held = np.abs(z).max() < limit and RMS[0] < rms < RMS[1]
    return (f"  {name}: {z.size} compared, largest |z| {np.abs(z).max():.2f} (limit {limit:.2f}), rms z {rms:.3f}, "
            f"mean z {z.mean():+.3f}{'' if held else '   NOT HELD'}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("scenes", nargs="+")
    parser.add_argument("--seeds", type=int, default=20)
    parser.add_argument("--forward", default="2e6")
    parser.add_argument("--bidirectional", default="2e5")
    parser.add_argument("--threads", type=int, default=1)
    asked = parser.parse_args()
    for scene in asked.scenes:
        z = {echo: [] for echo in ECHOES}
        with tempfile.TemporaryDirectory() as folder:
            for seed in range(1, asked.seeds + 1):
                a, b = (run(asked, scene, name, seed, f"{folder}/{name}-{seed}.nc") for name in ("forward", "bidirectional"))
                for echo in ECHOES:
                    z[echo] += differences(a[echo], b[echo])
        print(f"{scene}: forward {asked.forward}, bidirectional {asked.bidirectional} photons, {asked.seeds} seeds")
        print(in_words("gates", z["echo"]))
        print(in_words("processes", z["echo_by_process"]))
        print(in_words("orders", z["echo_by_order"]), flush=True)


if __name__ == "__main__":
    main()
