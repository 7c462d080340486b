#!/usr/bin/python3
"""Whether the forward and the bidirectional estimator agree in every gate and every order of scattering, over many seeds.

    experiments/agreement_by_seeds.py build/release/apps/photic/photic scenes/airborne.toml --seeds 20 \
        --forward 2e6 --bidirectional 2e5

For each scene three lines, gates, processes and orders: of pairs of runs of equal seeds, in gates that are converged in both, the difference
of two echoes over the error of that difference. The largest may pass its limit by chance in one of a hundred families; the
root mean square is to lie between 0.9 and 1.15. An order, or a process, has no flag of its own: compared are those known to 10 % by both.
A root mean square below 0.9 tells of errors that are told too large, not of estimators that differ. `--forward` and `--bidirectional` are numbers of photons.
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
KNOWN = 0.1


def run(asked, scene, estimator, seed, out):
    photons = getattr(asked, estimator)
    command = [asked.program, "run", scene, "-o", out, "--photons", photons, "--seed", str(seed), "--threads", str(asked.threads)]
    subprocess.run([*command, "--set", f"simulation.estimator={estimator}", "--target", "0.01%", "--max-time", "1h"], check=True, capture_output=True)
    with netCDF4.Dataset(out) as file:
        names = ("echo", "echo_standard_error", "echo_by_process", "echo_by_process_standard_error", "echo_by_order",
                 "echo_by_order_standard_error", "converged")
        return {name: np.ma.filled(file[name][:], np.nan) for name in names}


def differences(a, b, name, compared):
    """z where both are known."""
    errors = a[f"{name}_standard_error"], b[f"{name}_standard_error"]
    known = np.broadcast_to(compared, errors[0].shape).copy()
    for error, echo in zip(errors, (a[name], b[name])):
        known &= (error > 0) & (error < KNOWN * echo)
    return ((b[name] - a[name])[known] / np.hypot(*errors)[known]).tolist()


def told(name, z):
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
        gates, processes, orders = [], [], []
        with tempfile.TemporaryDirectory() as folder:
            for seed in range(1, asked.seeds + 1):
                a, b = (run(asked, scene, name, seed, f"{folder}/{name}-{seed}.nc") for name in ("forward", "bidirectional"))
                both = (a["converged"] == 1) & (b["converged"] == 1)
                gates += differences(a, b, "echo", both)
                processes += differences(a, b, "echo_by_process", both[:, :, None, :])
                orders += differences(a, b, "echo_by_order", both[:, :, None, :])
        print(f"{scene}: forward {asked.forward}, bidirectional {asked.bidirectional} photons, {asked.seeds} seeds")
        print(told("gates", gates))
        print(told("processes", processes))
        print(told("orders", orders), flush=True)


if __name__ == "__main__":
    main()
