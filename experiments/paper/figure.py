"""Common parts of the experiments on the paper's figures: scenes after Table 1, checks, pictures."""

from __future__ import annotations

import dataclasses
import os
import warnings
from collections.abc import Callable

import numpy
import photic

DEVIATIONS = 3  # standard errors that a check allows beyond its tolerance
SETS = ("modern", "paper")  # optics.set


@dataclasses.dataclass
class Check:
    """A number that was found, and what it is to be."""

    what: str
    found: float
    expected: float
    tolerance: float
    error: float = 0.0  # standard error of the number

    @property
    def passed(self) -> bool:
        return abs(self.found - self.expected) <= self.tolerance + DEVIATIONS * self.error

    def cells(self) -> tuple[str, ...]:
        """The cells of a row: what, found, expected, allowed, and whether it passed."""
        within = " and ".join(
            [f"{self.tolerance:.2g}"] * (self.tolerance > 0) + [f"{DEVIATIONS} errors of {self.error:.2g}"] * (self.error > 0)
        )
        return self.what, f"{self.found:.5g}", f"{self.expected:.5g}", within, "yes" if self.passed else "**no**"


@dataclasses.dataclass
class Figure:
    """The findings of an experiment."""

    title: str
    paper: list[str]  # its sentences, in our words or quoted
    finds: list[str]  # what Photic finds, and why it differs
    checks: list[Check]
    draw: Callable  # takes a matplotlib figure

    @property
    def passed(self) -> bool:
        return all(check.passed for check in self.checks)


@dataclasses.dataclass
class Effort:
    """The number of photons: all of them, or a share for a short form."""

    share: float = 1.0
    threads: int = 0

    def run(self, scene: photic.Scene, photons: float, seed: int = 1, **options):
        """A run of a scene; the same photons on any number of threads."""
        threads = self.threads or len(os.sched_getaffinity(0))
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", UserWarning)
            return scene.run(photons=max(2000, round(self.share * photons)), seed=seed, threads=threads, **options)


def of_photons_alone(scene: photic.Scene) -> photic.Scene:
    """A scene that nothing but photons ends."""
    scene["simulation.photons"] = 1000
    for key in ("target_relative_error", "max_time_s"):
        if f"simulation.{key}" in scene:
            del scene[f"simulation.{key}"]
    return scene


def table_1(changes=None) -> photic.Scene:
    """The ship lidar of the paper's Table 1, with changes by path."""
    scene = of_photons_alone(photic.Scene.new("ship"))
    scene.update(changes or {})
    return scene


def power(x, values, replicates=None) -> tuple[float, float]:
    """The exponent of the power law through points, and its error of their jackknife replicates."""
    exponent = float(numpy.polyfit(numpy.log(x), numpy.log(values), 1)[0])
    if replicates is None:
        return exponent, 0.0
    others = numpy.polyfit(numpy.log(x), numpy.log(replicates).T, 1)[0]
    return exponent, float(numpy.sqrt((len(others) - 1) * others.var()))
