#!/usr/bin/python3
"""The share of 95 % intervals of numbers made of several echoes which hold the truth, over seeds of a run.

    PYTHONPATH=build/release/python experiments/coverage_of_what_is_made.py scenes/ship.toml 200 --photons 16000 \
        --set simulation.estimator=bidirectional --set gates.depth_max_m=22

Options are those of `photic run`. The scene's channels are taken two by two, an environment with a tenth more chlorophyll is
added. The truth is what is made of the mean echoes of all seeds. Errors are by groups of batches (photic.error_of) and, beside
them, those of gates added in quadrature, which is what nobody should do.
"""

import argparse
import sys
import warnings
from pathlib import Path

import numpy as np
import photic
import xarray

sys.path.insert(0, str(Path(__file__).parent.parent / "benchmarks"))
from measure.coverage import TWO_SIDED_95, share

MORE_ALGAE = {"name": "more algae", "set": {"sea.layer.0.chlorophyll_mg_m3": 0.11}}


def made(channel, other):
    """The numbers that are made of echoes, by name; functions as photic.error_of takes them."""
    one, second = (lambda e, name=name: e.echo.sel(channel=name, drop=True).isel(telescope=0) for name in (channel, other))

    def depth(e):
        light, edges = one(e), e.gate_depth_bounds.sel(channel=channel).isel(telescope=0)
        sums = light.cumsum("gate")
        return xarray.DataArray(np.interp(0.9 * float(sums[-1]), [0.0, *sums.values], [float(edges[0, 0]), *edges[:, 1].values]))

    return {
        f"ratio of {second.__defaults__[0]} to {channel}": lambda e: second(e) / one(e),
        f"sum over ten gates, {channel}": lambda e: one(e).isel(gate=slice(0, 10)).sum(),
        f"K of neighbours, {channel}": lambda e: np.log(one(e)).diff("gate"),
        f"z90, {channel}": depth,
        f"environment's ratio, {channel}": lambda e: e.environment_echo.sel(channel=channel).isel(telescope=0, environment=0) / one(e),
    }


def runs_of(scene, seeds, **options):
    """The results of so many seeds."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", UserWarning)
        return [scene.run(seed=seed, **options) for seed in range(1, seeds + 1)]


def intervals(runs, function):
    """z of every number that is reliable, by seed; and how its errors compare with the scatter."""
    found = [photic.error_of(run, function) for run in runs]
    mean = runs[0].assign({name: sum(run[name] for run in runs) / len(runs) for name in ("echo", "environment_echo")})
    truth = np.asarray(function(mean), dtype=float)
    value, error, reliable = (
        np.array([np.asarray(one[name], dtype=float) for one in found]) for name in ("value", "value_standard_error", "reliable")
    )
    z = (value - truth) / error / np.sqrt(1 - 1 / len(runs))
    claimed = np.sqrt(np.mean(error**2, axis=0)) / value.std(axis=0, ddof=1)
    return np.where(reliable == 1, z, np.nan), claimed


def coverage(z):
    """The share of intervals that hold the truth, and its error, from the scatter of seeds."""
    known = np.isfinite(z).reshape(len(z), -1)
    return share((known & (np.abs(z.reshape(len(z), -1)) < TWO_SIDED_95)).sum(axis=1), known.sum(axis=1))


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("scene")
    parser.add_argument("seeds", type=int)
    parser.add_argument("--photons", type=float)
    parser.add_argument("--set", action="append", default=[])
    options = parser.parse_args()
    scene = photic.Scene.load(options.scene)
    for change in options.set:
        path, _, value = change.partition("=")
        scene[path] = _value(value)
    scene["environment"] = [MORE_ALGAE]
    runs = runs_of(scene, options.seeds, photons=options.photons)
    channels = list(map(str, runs[0].channel.values))
    for channel, other in zip(channels, channels[1:] + channels[:1]):
        for name, function in made(channel, other).items():
            z, claimed = intervals(runs, function)
            held, scatter = coverage(z)
            print(f"{name:40} {np.isfinite(z).sum():6} intervals, {100 * held:5.1f} +- {100 * scatter:3.1f} % hold the truth; "
                  f"claimed over scatter {np.nanmedian(claimed):.2f}", flush=True)


def _value(text):
    for kind in (int, float):
        try:
            return kind(text)
        except ValueError:
            pass
    return text


if __name__ == "__main__":
    main()
