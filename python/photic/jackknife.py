"""Errors of numbers that are made of several echoes, all of which stem from the same photons."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import numpy
import xarray

from photic.errors import Error

# The echoes whose groups a result holds, with their groups and their flags.
GROUPED = {
    "echo": ("echo_by_group", "converged"),
    "environment_echo": ("environment_echo_by_group", "environment_converged"),
}
LEAST_GROUPS = 30  # of fewer an error is not known to 13 %
SEED = 1  # of changes that show which gates a number is made of


def error_of(result: xarray.Dataset, function: Callable[[xarray.Dataset], Any]) -> xarray.Dataset:
    """The value of a function of echoes, with its standard error, as an xarray.Dataset.

    result    of a run, whole or some of its telescopes, channels, gates and environments, as photic.open and
              photic.run return it, with simulation.keep_groups = true, as it is by default
    function  takes a Dataset with the variables `echo` and `environment_echo`, and all coordinates of the
              result, and returns a number or a DataArray, of the same form at every call. It is called some
              130 times. It must be smooth: the error of a median, of a largest value or of a depth where a
              threshold is passed comes out wrong

    value                 that of the function
    value_standard_error  by the jackknife over groups of batches, each gate's deviations being scaled to its
                          echo_standard_error, with what has not been seen. It is known to 1/sqrt(2 (R - 1)) of R
                          groups: 6 to 9 % of runs of 64 batches and more. NaN where the value is not
                          finite whichever group is left out, and for results of a single batch
    value_replicates      on batch_group before all others: the value without each of the groups, of which errors of
                          whatever is made of values follow
    value_bias            an estimate of what the function's curvature adds to the value; it is not taken off
    reliable              [bool] whether all gates that the value is made of have converged, and there are
                          30 groups at least. A gate counts if the value changes with it

        ratio = photic.error_of(ds, lambda e: e.echo.sel(channel="chlorophyll") / e.echo.sel(channel="raman"))

    Raises photic.Error for a result without groups, and for a function of anything but these two variables.
    Source: docs/theory.md, eq. 112 and 113; Tukey 1958, Ann. Math. Stat. 29, 614 [from memory].
    """
    return described(estimate(result, function), "value")


class Estimate:
    """The jackknife's findings on a function's value; DataArrays."""

    def __init__(self, value, replicates, reliable):
        self.value = value
        self.replicates = replicates  # on `batch_group`: the value without each of the groups
        self.reliable = reliable

    @property
    def groups(self) -> int:
        return self.replicates.sizes["batch_group"]

    @property
    def error(self):
        """The standard error (eq. 112)."""
        deviation = self.replicates - self.replicates.mean("batch_group", skipna=False)
        squares = (deviation**2).sum("batch_group", skipna=False)
        return numpy.sqrt((self.groups - 1) / self.groups * squares) if self.groups > 1 else squares * numpy.nan

    @property
    def bias(self):
        return (self.groups - 1) * (self.replicates.mean("batch_group", skipna=False) - self.value)


def described(found: Estimate, name: str, **attributes: str) -> xarray.Dataset:
    """An estimate under a name, with attributes (long_name, units) of the value."""
    of, units = _words(name, attributes)
    more = {
        f"{name}_bias": found.bias.assign_attrs(long_name=f"estimate of the bias of the {of}", **units),
        f"{name}_replicates": found.replicates.assign_attrs(long_name=f"{of} without a group of batches", **units),
    }
    return with_error(found.value, found.error, found.reliable, name, **attributes).assign(more)


def with_error(value, error, settled, name: str, **attributes: str) -> xarray.Dataset:
    """A value under a name, with its standard error, and whether both are settled and known."""
    of, units = _words(name, attributes)
    return xarray.Dataset(
        {
            name: value.assign_attrs(attributes),
            f"{name}_standard_error": error.assign_attrs(long_name=f"standard error of the {of}", **units),
            "reliable": (settled & numpy.isfinite(error)).assign_attrs(
                long_name=f"whether the {of} and its standard error can be relied on"
            ),
        }
    )


def _words(name, attributes):
    """The name of a value in texts, and the attribute of its unit."""
    return attributes.get("long_name", name), {key: value for key, value in attributes.items() if key == "units"}


def estimate(result: xarray.Dataset, function: Callable[[xarray.Dataset], Any]) -> Estimate:
    """As error_of, with the value without each group of batches."""
    echoes = _echoes(result)
    deviations = _scaled_deviations(result, echoes)
    value = _call(function, echoes, result)
    left_out = [_like(value, _call(function, each, result)) for each in _replicates(echoes, deviations)]
    replicates = xarray.concat(left_out, dim="batch_group")
    enough = replicates.sizes["batch_group"] >= LEAST_GROUPS
    return Estimate(value, replicates, _settled(result, echoes, function, value) & enough)


def check_groups(result: xarray.Dataset) -> None:
    """Raises photic.Error for what is no result with groups of batches."""
    if not isinstance(result, xarray.Dataset) or "echo" not in result:
        raise Error("no result of a run with echoes: take what photic.open or photic.run returns")
    lacking = [name for name in ("echo_by_group", "group_photons", "echo_standard_error") if name not in result]
    if lacking:
        raise Error(
            f"a result without {lacking[0]}: run its scene again with simulation.keep_groups = true, and with no "
            "more gates, channels and environments than keep it within 64 MB"
        )


def _echoes(result):
    """The echoes of a result, and its coordinates."""
    check_groups(result)
    there = [name for name in GROUPED if name in result and GROUPED[name][0] in result]
    return result.drop_vars([name for name in result.data_vars if name not in there])


def _call(function, echoes, result):
    try:
        value = function(echoes.copy(deep=True))  # which it may change
    except (KeyError, AttributeError) as error:
        missing = next((name for name in result.data_vars if name in str(error) and name not in echoes), None)
        if missing is None:
            raise
        raise Error(f"{missing}: its groups of batches are not kept; an error is known of echo and environment_echo") from error
    value = xarray.DataArray(value)
    if value.dtype.kind not in "fiub":
        raise Error(f"a function whose value is not a number, or an array of numbers, but {value.dtype}")
    return value.astype(float)


def _like(value, other):
    if other.dims != value.dims or other.shape != value.shape:
        raise Error(f"a function whose value had the form {dict(value.sizes)} and, without a group of batches, {dict(other.sizes)}")
    return other


def _replicates(echoes, deviations) -> Iterator[xarray.Dataset]:
    """The echoes without each of the groups of batches (eq. 113)."""
    for group in range(next(iter(deviations.values())).sizes["batch_group"]):
        yield echoes.assign({name: echoes[name] + each.isel(batch_group=group, drop=True) for name, each in deviations.items()})


def _scaled_deviations(result, echoes):
    """By how much each echo is another one without each group. The light that an environment has in common with the scene is
    scaled as the scene's, so that it cancels where they are compared."""
    of_scene = _deviations(result, "echo")
    out = {"echo": _scaled(of_scene, result.echo_standard_error)}
    if "environment_echo" in echoes:
        deviation, error = _deviations(result, "environment_echo"), result.environment_echo_standard_error
        out["environment_echo"] = _scaled(deviation, error)
        if "environment_difference_standard_error" in result:
            of_difference = result.environment_difference_standard_error
            common = out["echo"] + _scaled(deviation - of_scene, of_difference)
            out["environment_echo"] = xarray.where(of_difference < error, common, out["environment_echo"])
    return {name: out[name].transpose(*echoes[name].dims, "batch_group") for name in echoes.data_vars}


def _deviations(result, name):
    """Unscaled."""
    means, photons = result[GROUPED[name][0]], result.group_photons
    sums = means.astype(float).where(photons > 0, 0) * photons
    total, emitted = sums.sum("batch_group"), photons.sum("batch_group")
    left = emitted - photons
    deviation = ((total - sums) / left - total / emitted).where(left > 0, numpy.nan)
    return deviation.drop_vars("batch_group", errors="ignore")


def _scaled(deviation, reported):
    """To the error that is reported; nothing varies where nothing does and no error is known."""
    groups = deviation.sizes["batch_group"]
    centred = deviation - deviation.mean("batch_group")
    by_groups = numpy.sqrt((groups - 1) / groups * (centred**2).sum("batch_group", skipna=False))
    scale = (reported / by_groups).where(by_groups > 0, xarray.where(reported > 0, numpy.nan, 0.0))
    return (deviation * scale).where(~(by_groups == 0) | (reported > 0), 0.0)


def _settled(result, echoes, function, value):
    """Returns whether a value is made of converged gates alone: it stays the same when the others change."""
    random = numpy.random.default_rng(SEED)
    changed = {}
    for name in echoes.data_vars:
        echo, converged = echoes[name], result[GROUPED[name][1]].astype(bool)
        step = float(abs(echo).where(echo != 0).min())
        size = abs(echo).clip(min=step if numpy.isfinite(step) else 1.0)
        changed[name] = echo + xarray.where(converged, 0.0, size * random.uniform(0.1, 1.0, echo.shape))
    other = _like(value, _call(function, echoes.assign(changed), result))
    return (other == value) | (other.isnull() & value.isnull())
