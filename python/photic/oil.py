"""The thickness of a film of oil, from the light that it takes from the water's Raman echo."""

from __future__ import annotations

from typing import Any

import numpy
import xarray

from photic.errors import Error
from photic.jackknife import described, estimate, with_error
from photic.names import chosen, listed, suggestion
from photic.ratios import expect_environment
from photic.result import scene_of

FORMULAS = ["interfaces", "paper"]
UM_PER_M = 1e6
# Of gates, and by how much they may differ, relative and in ns or m. Depths are those of a channel's
# mean wavelength: behind a filter it is a little another one under a film.
BOUNDS = {"gate_time_bounds": 1e-9, "gate_depth_bounds": 1e-3}
LARGEST_RATIO = 2  # of measured echoes: no film makes Raman light so much brighter; per cent are above it
OF_ECHO = ("echo", "echo_standard_error", "converged")
ATTRIBUTES = {"long_name": "thickness of the film of oil", "units": "um"}
# Keys of [oil] on which its absorption and its interfaces do not depend.
FREE = {"thickness_um", "yield", "lifetime_ns"}
WITHOUT_FILM = "run the same scene with oil.thickness_um = 0"


def oil_thickness(
    result: xarray.Dataset,
    clean: str | xarray.Dataset,
    *,
    environment: str | None = None,
    channel: str = "raman",
    formula: str = "interfaces",
    ratio: Any = None,
    ratio_error: Any = None,
) -> xarray.Dataset:
    """The thickness of a film found from Raman echoes, as an xarray.Dataset: of the run's film, or of
    one over which a ratio of echoes was measured.

    With E the echo of the sea under the film, W that of the clean sea, a the film's absorption per
    metre of thickness [1/m], of the laser's light on its slanted way down and of the channel's on
    its way up (film_attenuation), and r the share that passes both ways through a film that absorbs
    nothing, over the share that passes the bare surface (film_interface_ratio):

        thickness = (ln(W / E) + ln(r)) / a      formula="interfaces"
        thickness = ln(W / E) / a                formula="paper", which assumes r = 1

    A measured ratio of the echo under a film to that of the clean sea beside it is compared with E / W of
    the run, whose film is d thick:

        thickness = d + (ln(E / W) - ln(ratio)) / a

    So whatever the formulas neglect, as waves, is counted as it is over the run's film: take a scene whose
    film is about as thick as the one sought, over the sea and with the instrument of the measurement. d is
    oil.thickness_um of the scene, or of the environment.

    result   of a run over a film of oil, whole, as photic.open and photic.run return it
    clean    the same sea without the film: the name of an environment of `result` with
             oil.thickness_um = 0, or the whole result of another run with the same telescopes and
             gates, and with another simulation.seed, since it is taken as independent. That nothing
             but the film differs is not checked: leave [oil] in the scene, since it damps waves too
    environment  name of an environment of `result` whose film is sought, in the place of the scene's.
             It is of the scene's oil, with a and r of the scene, which has a film itself
    channel  name of the channel that counts the water's Raman light
    formula  "interfaces" or "paper"; a measured ratio needs neither
    ratio    measured: above 0, and about 1 at most. A number, a value for each gate, or a DataArray on
             telescope, gate or both; NaN where nothing was measured
    ratio_error  its standard deviation, in the same forms

    On (telescope, gate), with their coordinates:
    thickness                 [um] any number: below 0 where noise has it so
    thickness_standard_error  [um] 0 or more. Echoes of one run come from the same photons: there it is
                              by groups of batches (photic.error_of), which know how they vary
                              together. Errors of two runs are independent: there it is to the first
                              order in those of E and W, valid while these are far below E and W. Of
                              a measured ratio both errors are in it, the measurement's and the
                              run's, as independent of each other. a and r are taken as exact
    reliable                  [bool] whether E and W are both converged and above 0, and thickness
                              and error are known; of one run, from 30 groups at least
    thickness_bias, thickness_replicates  [um] of one run alone: as photic.error_of has them, of E and W.
                              A measurement is the same in all replicates
    Thickness and error are NaN where E or W is not above 0, for telescopes or a laser in the water
    (r is NaN there) and where the film absorbs nothing.

    Every gate gives the thickness anew. From below a film of many 1/a hardly any Raman light comes
    back.

    Raises photic.Error if `result` or `clean` is not a whole result, `result` has no film in the scene
    itself or `clean` has one, there is no such environment, channel or formula, an environment has no
    film or one of other absorption, echoes of one run have no groups (simulation.keep_groups),
    telescopes or gates differ, or a ratio comes without its error, is not above 0 or too large, or does
    not fit the gates.

    Sources: Raman light that is missing as the measure of a film, Hoge & Swift 1980, Appl. Opt. 19,
    3269 [from memory]; the formula without interfaces, Barbini et al. 2000 (PREMAR-2F), Proc.
    EARSeL-SIG-Workshop LIDAR, Dresden. Errors: docs/theory.md, eq. 112.
    """
    _check_film(result)
    if formula not in FORMULAS:
        raise Error(f"there is no formula {formula!r}{suggestion(str(formula), FORMULAS)}")
    film_um = _film_sought(result, environment)
    measured = _measured(result, ratio, ratio_error, formula)
    oily = _of_channel(result, "result", channel)
    film = (oily.film_attenuation > 0) & (oily.film_interface_ratio > 0)
    um = UM_PER_M / oily.film_attenuation.where(film)

    def thickness(under, bare):
        lit = (under > 0) & (bare > 0)
        logarithm = numpy.log(bare.where(lit) / under.where(lit))
        if measured is not None:
            return film_um - um * (numpy.log(measured.ratio) + logarithm)
        if formula == "interfaces":
            logarithm = logarithm + numpy.log(oily.film_interface_ratio.where(film))
        return um * logarithm

    if isinstance(clean, str):
        _expect_clean(result, clean)
        out = _of_one_run(oily, environment, clean, thickness)
    else:
        out = _of_two_runs(oily, environment, _other_run(oily, clean, channel), thickness, um)
    if measured is not None:
        out = _with_error_of_measurement(out, um * measured.error / measured.ratio)
    else:
        out = out.assign_attrs(formula=formula)
    return out.transpose("batch_group", "telescope", "gate", missing_dims="ignore")


def _of_one_run(oily, environment, clean, thickness):
    """The thickness from echoes whose photons are the same, with what groups of batches show of it."""

    def function(echoes):
        return thickness(_in(environment, echoes), _in(clean, echoes))

    return described(estimate(oily, function), "thickness", **ATTRIBUTES)


def _of_two_runs(oily, environment, water, thickness, um):
    """The thickness from echoes that have no photons in common, to the first order in their errors."""
    echo, error, converged = (_in(environment, oily, name) for name in OF_ECHO)
    value = thickness(echo, water.echo)
    relative = numpy.hypot(error / echo, water.echo_standard_error / water.echo)
    return with_error(value, (um * relative).where(value.notnull()), converged & water.converged, "thickness", **ATTRIBUTES)


def _in(environment, dataset, name="echo"):
    """A variable of the scene's own echo, or of that of an environment."""
    if environment is None:
        return dataset[name]
    return dataset[f"environment_{name}"].sel(environment=environment, drop=True)


def _with_error_of_measurement(out, own):
    """The same with another error that is independent of what is known of the run's."""
    error = numpy.hypot(out.thickness_standard_error, own)
    return out.assign(
        thickness_standard_error=error.assign_attrs(out.thickness_standard_error.attrs),
        reliable=(out.reliable & numpy.isfinite(error)).assign_attrs(out.reliable.attrs),
    )


def _measured(result, ratio, error, formula):
    """The measured values, by gate or alike in all; None if nothing was."""
    if ratio is None and error is None:
        return None
    if ratio is None or error is None:
        given, missing = ("ratio", "ratio_error") if error is None else ("ratio_error", "ratio")
        raise Error(f"{given} without {missing}: give both, the measured ratio and its standard deviation")
    if formula != "interfaces":
        raise Error(
            f"formula {formula!r} with a measured ratio: that is compared with the run's, which has the "
            "interfaces in it (leave out formula)"
        )
    ratio, error = _by_gate(result, "ratio", ratio), _by_gate(result, "ratio_error", error)
    if not bool((ratio.isnull() | ((ratio > 0) & (ratio <= LARGEST_RATIO))).all()):
        raise Error(
            "ratio: not above 0, or too large: it is the echo under the film over that of the clean sea, "
            "as 0.83 and not 83 per cent"
        )
    if not bool((error.isnull() | ((error >= 0) & (error < numpy.inf))).all()):
        raise Error("ratio_error: below 0 or infinite: it is a standard deviation")
    return xarray.Dataset({"ratio": ratio, "error": error})


def _by_gate(result, name, values):
    """Numbers as a DataArray that fits the result."""
    if not isinstance(values, xarray.DataArray):
        if numpy.ma.isMaskedArray(values):
            values = values.astype(float).filled(numpy.nan)
        values = numpy.asarray(values)
        values = xarray.DataArray(values, dims=["gate"][: values.ndim]) if values.ndim < 2 else None
    if values is None or values.dtype.kind not in "if" or not _fits(result, values):
        raise Error(
            f"{name}: give a number, one for each of the {result.sizes['gate']} gates, or a DataArray on "
            "telescope and gate"
        )
    return values.reset_coords(drop=True).astype(float)


def _fits(result, values):
    """Returns whether there is a value for each telescope and gate of the result along the axes that there are."""
    if set(values.dims) - {"telescope", "gate"}:
        return False
    named = set(values.telescope.values) == set(result.telescope.values) if "telescope" in values.dims else True
    return named and all(values.sizes[axis] == result.sizes[axis] for axis in values.dims)


def _check_film(result):
    _check_whole(result, "result: not")
    if "film_attenuation" not in result:
        raise Error(
            "result: no film of oil: its scene itself has no [oil], or oil.thickness_um = 0, and what a "
            "film absorbs is in results of scenes that have one; take the run over the film as result, "
            "and the sea without it as clean"
        )


def _check_whole(dataset, refused):
    whole = isinstance(dataset, xarray.Dataset) and set(BOUNDS) <= set(dataset.coords)
    if not whole or "scene" not in dataset.attrs or not {"telescope", "channel", "gate"} <= set(dataset.dims):
        raise Error(
            f"{refused} the whole result of a run over the sea: take what photic.open or "
            "photic.run returns"
        )


def _of_channel(dataset, name, channel):
    (channel,) = chosen([dataset], [name], "channel", [str(channel)])
    return dataset.sel(channel=channel)


def _film_sought(result, environment):
    """The thickness [um] of the scene's film, or of that of an environment."""
    own = scene_of(result)["oil"]
    if environment is None:
        return own["thickness_um"]
    expect_environment(result, str(environment))
    oil = _oil_in(result, environment)
    other = [key for key in oil if key not in FREE and oil[key] != own.get(key)]
    if other:
        raise Error(
            f"environment: {environment!r} sets oil.{other[0]}, too, and what is known of absorption is that of "
            "the scene's own film: let them differ in oil.thickness_um"
        )
    if oil["thickness_um"] == 0:
        raise Error(f"environment: {environment!r} has no film of oil: its oil.thickness_um is 0")
    return oil["thickness_um"]


def _oil_in(result, environment):
    """The oil of an environment: that of the scene, but for what it sets."""
    scene = scene_of(result)
    changes = next(each["set"] for each in scene["environment"] if each["name"] == environment)
    start = "oil."
    return scene["oil"] | {path[len(start) :]: value for path, value in changes.items() if path.startswith(start)}


def _expect_clean(result, name):
    """Raises photic.Error for what is no environment without a film."""
    if "environment" not in result.dims:
        raise Error(
            f"result: there is no environment {name!r}, nor any other: add [[environment]] with "
            f'set = {{ "oil.thickness_um" = 0 }} to the scene, or {WITHOUT_FILM} and take that '
            "result as clean"
        )
    expect_environment(result, name)
    if _oil_in(result, name)["thickness_um"] > 0:
        raise Error(f"clean: environment {name!r} has a film of oil itself: take one with oil.thickness_um = 0")


def _other_run(oily, clean, channel):
    """The echo of the clean sea, its error and its flags, of a run that has no photons in common with that
    over the film."""
    _check_whole(clean, "clean: neither the name of an environment nor")
    if "film_attenuation" in clean:
        raise Error(f"clean: has a film of oil itself: {WITHOUT_FILM} for it")
    other = _of_channel(clean, "clean", channel)
    wanted, there = (list(map(str, each.telescope.values)) for each in (oily, other))
    if set(wanted) != set(there):
        raise Error(
            f"clean: other telescopes than those of result: {listed(there)} in place of "
            f"{listed(wanted)}; {WITHOUT_FILM}"
        )
    other = other.sel(telescope=oily.telescope)
    if not _same_gates(oily, other):
        raise Error(f"clean: other gates than those of result; {WITHOUT_FILM}")
    return other.reset_coords(drop=True)[list(OF_ECHO)]


def _same_gates(one, other):
    if one.sizes["gate"] != other.sizes["gate"]:
        return False
    for name, most in BOUNDS.items():
        left, right = one[name], other[name].transpose(*one[name].dims)
        if not numpy.allclose(left.values, right.values, rtol=most, atol=most, equal_nan=True):
            return False
    return True
