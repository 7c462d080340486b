"""A straight line through numbers whose errors hang together."""

from __future__ import annotations

from typing import Any

import numpy
import xarray

from photic.errors import Error
from photic.jackknife import Estimate, described
from photic.names import suggestion

FEWEST = 3
ROUNDING = 1e-12  # of values: a scatter below it is none


def linear_fit(x: Any, y: xarray.Dataset, name: str | None = None) -> xarray.Dataset:
    """The weighted straight line through values of one run, y = offset + slope x.

    Each value is weighted by the inverse of its variance. Values of environments of one run hang together: the
    errors of slope and offset are those of the jackknife, with all covariances, and so is chi2, the sum of squares
    of the residuals in units of their covariance matrix, of as many degrees of freedom as there are values but two
    (with the factor (R - n - 2) / (R - 1) for n = degrees of freedom, since the covariances are those of R groups
    alone).

    x       the places: a number for each value, exact
    y       a Dataset as photic.ratio, photic.z90, photic.k_lidar and photic.error_of return it, or a part of it, whose
            values are on one axis, as environments are; sel(telescope=…) and sel(gate=…) leave one axis
    name    that of the variable; may be left out if there is one alone

    slope, offset     with _standard_error and _bias
    residual          along the axis: y less the line
    r_squared         1 less the weighted squares of the residuals over those of the distances from the mean. It
                      is close to 1 for many a curve, too: look at the residuals and at chi2
    chi_squared, degrees_of_freedom   NaN if there are half as many values as groups, or more
    reliable          [bool] whether all values are reliable

    Raises photic.Error for fewer than three values, values that are not finite, places that do not fit or are all alike.
    Sources: Cochran 1977, Sampling Techniques [from memory]; Hartlap et al. 2007, A&A 464, 399 [from memory].
    """
    name = _name(y, name)
    value, replicates, reliable = y[name], y[f"{name}_replicates"], _reliable(y, name)
    places = _places(x, value)
    error = y[f"{name}_standard_error"].values
    if not ((error > 0) & numpy.isfinite(error) & numpy.isfinite(value.values)).all():
        raise Error(f"linear_fit: values of {name} whose errors are not above 0 and finite: leave them out, or take more photons")
    weight = 1 / error**2
    slope, offset = _line(places, value.values, weight)
    of_groups = [_line(places, one, weight) for one in replicates.transpose("batch_group", ...).values]
    found = [
        Estimate(xarray.DataArray(one), xarray.DataArray(list(others), dims="batch_group"), reliable.all())
        for one, others in zip((slope, offset), zip(*of_groups))
    ]
    residual = value - (offset + slope * places)
    mean = numpy.average(value.values, weights=weight)
    squares = [float((weight * numpy.square(each)).sum()) for each in (residual.values, value.values - mean)]
    units, of = str(value.attrs.get("units", "1")), str(value.attrs.get("long_name", name))
    of_slope = described(found[0], "slope", long_name=f"slope of the line through the {of}")
    of_offset = described(found[1], "offset", long_name=f"offset of the line through the {of}", units=units)
    out = of_slope.assign(of_offset.drop_vars("reliable").data_vars).assign(reliable=of_slope.reliable & of_offset.reliable)
    return out.drop_vars(["slope_replicates", "offset_replicates"]).assign(
        residual=residual.assign_attrs(long_name=f"{of} less the line", units=units),
        r_squared=_number(1 - squares[0] / squares[1] if squares[1] > 0 else numpy.nan, "weighted squared correlation with the line"),
        chi_squared=_number(
            chi_squared(places, value.values, replicates.transpose("batch_group", ...).values),
            "squares of the residuals in units of their covariances",
        ),
        degrees_of_freedom=_number(len(places) - 2, "degrees of freedom of chi squared"),
    )


def _number(value, long_name):
    return xarray.DataArray(value, attrs={"long_name": long_name, "units": "1"})


def _name(y, name):
    if not isinstance(y, xarray.Dataset):
        raise Error("linear_fit: y is no Dataset: take what photic.ratio or photic.error_of returns")
    known = [str(each).removesuffix("_replicates") for each in y.data_vars if str(each).endswith("_replicates")]
    if name is None and len(known) == 1:
        return known[0]
    if name not in known:
        raise Error(f"linear_fit: there is no value {name!r}{suggestion(str(name), known)}")
    return name


def _reliable(y, name):
    own = f"{name}_reliable"
    return y[own] if own in y else y.reliable


def _places(x, value):
    if value.ndim != 1:
        raise Error(f"linear_fit: values on {' and '.join(map(str, value.dims)) or 'no axis'}: leave one axis, by sel(telescope=…)")
    try:
        places = numpy.asarray(x, dtype=float)
    except (TypeError, ValueError):
        raise Error("linear_fit: places that are no numbers") from None
    if places.shape != value.shape:
        raise Error(f"linear_fit: {places.size} places for {value.size} values: give one for each")
    if len(places) < FEWEST:
        raise Error(f"linear_fit: {len(places)} values: a line with errors takes {FEWEST} at least")
    if not numpy.isfinite(places).all() or numpy.ptp(places) == 0:
        raise Error("linear_fit: places that are not finite, or all alike")
    return places


def _line(x, y, weight):
    first, span = x[0], numpy.ptp(x)
    scaled = (x - first) / span
    x0, y0 = numpy.average(scaled, weights=weight), numpy.average(y, weights=weight)
    slope = (weight * (scaled - x0) * (y - y0)).sum() / (weight * (scaled - x0) ** 2).sum()
    return slope / span, y0 - slope * (x0 + first / span)


def chi_squared(x, y, replicates):
    """That of what a line leaves, whatever line that is: of the directions in which no line lies."""
    groups, free = len(replicates), len(x) - 2
    if 2 * free >= groups:
        return numpy.nan
    lines = numpy.column_stack([numpy.ones_like(x), (x - x[0]) / numpy.ptp(x)])
    across = numpy.linalg.qr(lines, mode="complete")[0][:, 2:]
    deviation = (replicates - replicates.mean(axis=0)) @ across
    covariance = (groups - 1) / groups * deviation.T @ deviation
    left = y @ across
    if numpy.linalg.eigvalsh(covariance)[0] < (ROUNDING * numpy.abs(y).max()) ** 2:
        return numpy.nan  # values that scatter together leave no scatter about a line
    return float(left @ numpy.linalg.solve(covariance, left)) * (groups - free - 2) / (groups - 1)
