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

import numpy
import photic
import xarray

sys.path.insert(0, str(Path(__file__).parent.parent / "benchmarks"))
from measure.coverage import TWO_SIDED_95, share

MORE_ALGAE = {"name": "more algae", "set": {"sea.layer.0.chlorophyll_mg_m3": 0.11}}


def made(channel, other):
    """The numbers that are made of echoes, by name; functions as photic.error_of takes them, of all telescopes at once."""

    def of(name):
        return lambda e: e.echo.sel(channel=name, drop=True)

    def depth(e):
        light, edges = of(channel)(e).transpose("telescope", "gate").values, e.gate_depth_bounds.sel(channel=channel).values
        ends = [[each[0, 0], *each[:, 1]] for each in edges]
        sums = [[0.0, *numpy.cumsum(one)] for one in light]
        return xarray.DataArray([numpy.interp(0.9 * one[-1], one, end) for one, end in zip(sums, ends)], dims="telescope")

    return {
        f"ratio of {other} to {channel}": lambda e: of(other)(e) / of(channel)(e),
        f"sum over ten gates, {channel}": lambda e: of(channel)(e).isel(gate=slice(0, 10)).sum("gate"),
        f"K of neighbours, {channel}": lambda e: numpy.log(of(channel)(e)).diff("gate"),
        f"z90, {channel}": depth,
        f"environment's ratio, {channel}": lambda e: e.environment_echo.isel(environment=0).sel(channel=channel, drop=True) / of(channel)(e),
    }


def runs_of(scene, seeds, **options):
    """The results of so many seeds of a scene with one telescope, as telescopes of one."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", UserWarning)
        runs = [scene.run(seed=seed, **options) for seed in range(1, seeds + 1)]
    of_seeds = [run.assign_coords(telescope=[f"seed {seed}"]) for seed, run in enumerate(runs, 1)]
    return xarray.concat(of_seeds, dim="telescope", data_vars="minimal", coords="minimal", compat="override")


def intervals(runs, function):
    """z of every number that is reliable, by seed; and how its errors compare with the scatter."""
    found = photic.error_of(runs, function)
    mean = runs.isel(telescope=[0]).assign({name: runs[name].mean("telescope", keepdims=True) for name in ("echo", "environment_echo")})
    value, error, reliable, truth = (
        one.transpose("telescope", ...).values for one in (found.value, found.value_standard_error, found.reliable, function(mean))
    )
    z = (value - truth) / error / numpy.sqrt(1 - 1 / len(value))
    claimed = numpy.sqrt(numpy.mean(error**2, axis=0)) / value.std(axis=0, ddof=1)
    return numpy.where(reliable, z, numpy.nan), claimed


def coverage(z):
    """The share of intervals that hold the truth, and its error, from the scatter of seeds."""
    known = numpy.isfinite(z).reshape(len(z), -1)
    return share((known & (numpy.abs(z.reshape(len(z), -1)) < TWO_SIDED_95)).sum(axis=1), known.sum(axis=1))


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
    channels = list(map(str, runs.channel.values))
    for channel, other in zip(channels, channels[1:] + channels[:1]):
        for name, function in made(channel, other).items():
            z, claimed = intervals(runs, function)
            held, scatter = coverage(z)
            print(f"{name:40} {numpy.isfinite(z).sum():6} intervals, {100 * held:5.1f} +- {100 * scatter:3.1f} % hold the truth; "
                  f"claimed over scatter {numpy.nanmedian(claimed):.2f}", flush=True)


def _value(text):
    for kind in (int, float):
        try:
            return kind(text)
        except ValueError:
            pass
    return text


if __name__ == "__main__":
    main()
