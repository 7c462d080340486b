"""The thickness of a film of oil, from the light that it takes from the water's Raman echo."""

from __future__ import annotations

from typing import Any

import numpy
import xarray

from photic.errors import Error
from photic.names import chosen, listed, suggestion
from photic.result import scene_of

FORMULAS = ["interfaces", "paper"]
UM_PER_M = 1e6
# Of gates, and by how much they may differ, relative and in ns or m. Depths are those of a channel's
# mean wavelength: behind a filter it is a little another one under a film.
BOUNDS = {"gate_time_bounds": 1e-9, "gate_depth_bounds": 1e-3}
ROUNDING = 1e-9
LARGEST_RATIO = 2  # of measured echoes: no film makes Raman light so much brighter; per cent are above it
WITHOUT_FILM = "run the same scene with oil.thickness_um = 0"


def oil_thickness(
    result: xarray.Dataset,
    clean: str | xarray.Dataset,
    *,
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
    the scene's oil.thickness_um, also where the echoes of an environment were put in the place of its own.

    result   of a run over a film of oil, whole, as photic.open and photic.run return it
    clean    the same sea without the film: the name of an environment of `result` with
             oil.thickness_um = 0, or the whole result of another run with the same telescopes and
             gates, and with another simulation.seed, since it is taken as independent. That nothing
             but the film differs is not checked: leave [oil] in the scene, since it damps waves too
    channel  name of the channel that counts the water's Raman light
    formula  "interfaces" or "paper"; a measured ratio needs neither
    ratio    measured: above 0, and about 1 at most. A number, a value for each gate, or a DataArray on
             telescope, gate or both; NaN where nothing was measured
    ratio_error  its standard deviation, in the same forms

    On (telescope, gate), with their coordinates:
    thickness                 [um] any number: below 0 where noise has it so
    thickness_standard_error  [um] 0 or more, to the first order in the errors of E and W: valid
                              while these are far below E and W. Echoes of one run come from the
                              same photons: their covariance is taken from the error of their
                              difference, and the error is NaN where no covariance fits all three.
                              Those of two runs have none. Of a measured ratio both errors are in it,
                              the measurement's and the run's, as independent of each other. a and r
                              are taken as exact
    reliable                  [bool] whether E and W are both converged and above 0, and thickness
                              and error are known
    Thickness and error are NaN where E or W is not above 0, for telescopes or a laser in the water
    (r is NaN there) and where the film absorbs nothing.

    Every gate gives the thickness anew. From below a film of many 1/a hardly any Raman light comes
    back.

    Raises photic.Error if `result` or `clean` is not a whole result, `result` has no film or `clean`
    has one, there is no such environment, channel or formula, telescopes or gates differ, or a ratio
    comes without its error, is not above 0 or too large, or does not fit the gates.

    Sources: Raman light that is missing as the measure of a film, Hoge & Swift 1980, Appl. Opt. 19,
    3269 [from memory]; the formula without interfaces, Barbini et al. 2000 (PREMAR-2F), Proc.
    EARSeL-SIG-Workshop LIDAR, Dresden.
    """
    _check_film(result)
    if formula not in FORMULAS:
        raise Error(f"there is no formula {formula!r}{suggestion(str(formula), FORMULAS)}")
    measured = _measured(result, ratio, ratio_error, formula)
    oily = _of_channel(result, "result", channel)
    if isinstance(clean, str):
        water = _environment(result, oily, clean)
    else:
        water = _other_run(oily, clean, channel)

    lit = (oily.echo > 0) & (water.echo > 0)
    film = (oily.film_attenuation > 0) & (oily.film_interface_ratio > 0)
    um = UM_PER_M / oily.film_attenuation.where(film)
    logarithm = numpy.log(water.echo.where(lit) / oily.echo.where(lit))
    variance = _variance_of_log_ratio(oily, water, lit)
    if measured is not None:
        thickness = measured.film_um - um * (numpy.log(measured.ratio) + logarithm)
        variance = variance + (measured.error / measured.ratio) ** 2
    elif formula == "interfaces":
        thickness = um * (logarithm + numpy.log(oily.film_interface_ratio.where(film)))
    else:
        thickness = um * logarithm
    error = um * numpy.sqrt(variance)
    reliable = oily.converged & water.converged & numpy.isfinite(error)

    of = "thickness of the film of oil"
    return xarray.Dataset(
        {
            "thickness": thickness.assign_attrs(long_name=of, units="um"),
            "thickness_standard_error": error.assign_attrs(
                long_name=f"standard error of the {of}", units="um"
            ),
            "reliable": reliable.assign_attrs(
                long_name=f"whether the {of} and its standard error can be relied on"
            ),
        },
        attrs={"formula": formula} if measured is None else {},
    ).transpose("telescope", "gate")


def _variance_of_log_ratio(oily, water, lit):
    """The variance of ln(W / E), to the first order: vE/E^2 + vW/W^2 - 2 cov/(E W), with 2 cov =
    vE + vW - vD, written so that like echoes lose no digits. NaN where the three errors contradict
    one another: no covariance makes it fall below (sE/E - sW/W)^2, except by rounding."""
    e, w = oily.echo.where(lit), water.echo.where(lit)
    own = water.variance / w - oily.echo_standard_error**2 / e
    variance = (water.variance_of_difference - (w - e) * own) / (e * w)
    of_oily, of_water = oily.echo_standard_error / e, numpy.sqrt(water.variance) / w
    least = (of_oily - of_water) ** 2
    return variance.clip(min=least).where(variance > least - ROUNDING * (of_oily + of_water) ** 2)


def _measured(result, ratio, error, formula):
    """The measured values, by gate or alike in all, and the thickness of the run's film [um]; None if
    nothing was."""
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
    film_um = scene_of(result)["oil"]["thickness_um"]
    return xarray.Dataset({"ratio": ratio, "error": error, "film_um": film_um})


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
            "result: no film of oil: its scene has no [oil], or oil.thickness_um = 0; take the run "
            "over the film as result, and the sea without it as clean"
        )


def _check_whole(dataset, refused):
    whole = isinstance(dataset, xarray.Dataset) and set(BOUNDS) <= set(dataset.coords)
    if not whole or not {"telescope", "channel", "gate"} <= set(dataset.dims):
        raise Error(
            f"{refused} the whole result of a run over the sea: take what photic.open or "
            "photic.run returns"
        )


def _of_channel(dataset, name, channel):
    (channel,) = chosen([dataset], [name], "channel", [str(channel)])
    return dataset.sel(channel=channel)


def _environment(result, oily, name):
    """The clean sea as an environment: its echo, what is known of its errors, and whether it has
    converged."""
    if "environment" not in result.dims:
        raise Error(
            f"result: there is no environment {name!r}, nor any other: add [[environment]] with "
            f'set = {{ "oil.thickness_um" = 0 }} to the scene, or {WITHOUT_FILM} and take that '
            "result as clean"
        )
    chosen([result], ["result"], "environment", [name])
    one = oily.sel(environment=name).reset_coords(drop=True)
    return xarray.Dataset(
        {
            "echo": one.environment_echo,
            "variance": one.environment_echo_standard_error**2,
            "variance_of_difference": one.environment_difference_standard_error**2,
            "converged": one.environment_converged,
        }
    )


def _other_run(oily, clean, channel):
    """The same, of a run that has no photons in common with that over the film."""
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
    other = other.reset_coords(drop=True)
    variance = other.echo_standard_error**2
    return xarray.Dataset(
        {
            "echo": other.echo,
            "variance": variance,
            "variance_of_difference": oily.echo_standard_error**2 + variance,
            "converged": other.converged,
        }
    )


def _same_gates(one, other):
    if one.sizes["gate"] != other.sizes["gate"]:
        return False
    for name, most in BOUNDS.items():
        left, right = one[name], other[name].transpose(*one[name].dims)
        if not numpy.allclose(left.values, right.values, rtol=most, atol=most, equal_nan=True):
            return False
    return True
