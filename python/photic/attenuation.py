"""The attenuation of a lidar's echo with depth."""

from __future__ import annotations

import numpy
import xarray

from photic.closed_form import expect_lidar_over_flat_sea
from photic.errors import Error
from photic.gate_scale import cosine_in_water, has_ranges
from photic.jackknife import Estimate, described, estimate
from photic.names import chosen
from photic.range_correction import range_corrected
from photic.ratios import expect_environment, of_telescope
from photic.rays import unit
from photic.result import scene_of
from photic.seawater import light_of

OF_GATES = ["gate_time", "gate_depth"]  # coordinates that an interval between two of them does not have
LARGEST_ERROR = 0.1  # of an echo: above it the mean of its logarithm is not the logarithm of the mean


def k_lidar(
    result: xarray.Dataset,
    channel: str,
    *,
    depths: tuple[float, float] | None = None,
    telescope: str | None = None,
    environment: str | None = None,
) -> xarray.Dataset:
    """The lidar attenuation coefficient K, from gate to gate, and fitted over depths.

        K_g = -ln(X_{g+1} / X_g) / (s_{g+1} - s_g)

    X is the range-corrected echo (photic.range_corrected), s the way in the water, there and back, to the middle of a
    gate along the axes of the laser and the telescope: s = z / cos(theta_l) + z / cos(theta_t), at nadir 2 z. The
    fitted K is minus the slope of the straight line through ln X against s, each gate weighted by the inverse of the variance
    of its logarithm by groups of batches.

    result       of a run, as photic.open and photic.run return it, with groups of batches; or a part of it
    channel      the name of the channel
    depths       [m] the first and the last depth of the fit; by default all of the water
    telescope    a name; by default all
    environment  a name, in the place of the scene itself

    k                 [1/m] on (telescope, interval), with depth, that of the interval between the middles of gates
    k_fitted          [1/m] on (telescope)
    k_fitted_gate     [bool] on (telescope, gate): whether the fit has the gate; those with echoes of errors above
                      10 % are left out, since the logarithm of their mean is off
    each with _standard_error, by groups of batches (photic.error_of), and _bias; reliable is of k, k_fitted_reliable of the
    fit. NaN where an echo is 0, and where the telescope sees nothing.

    Raises photic.Error for names that there are not, fewer than three gates that a fit may take, instruments
    or seas that photic.range_corrected refuses, and a result without groups.
    Sources: Gordon 1982, Appl. Opt. 21, 2996; Churnside 2014, Opt. Eng. 53, 051405 [both from memory].
    """
    result = of_telescope(result, telescope)
    chosen([result], ["result"], "channel", [channel])
    if environment is not None:
        expect_environment(result, environment)
    part = result.sel(channel=[channel])
    scene = scene_of(result)
    expect_lidar_over_flat_sea(scene, "k_lidar")
    if has_ranges(scene):
        raise Error("k_lidar: gates of this result have ranges, and no depths")
    corrected = range_corrected(part)
    factor = (corrected.range_corrected / part.echo.where(part.echo > 0)).isel(channel=0, drop=True)
    depth = part.gate_depth.isel(channel=0, drop=True)
    path = _path(scene, part, depth)
    water = part.gate_depth_bounds.isel(channel=0, drop=True).min("bnds") >= -1e-9

    def logarithm(e):
        echo = (e.echo if environment is None else e.environment_echo.sel(environment=environment, drop=True)).isel(channel=0, drop=True)
        scaled = echo * factor
        return numpy.log(scaled.where((scaled > 0) & water)).transpose("telescope", "gate")

    logarithms = estimate(part, logarithm)
    taken = _taken(logarithms, depth, depths)
    weight = (1 / logarithms.error**2).where(taken, 0.0)

    def of(function, reliable):
        return Estimate(function(logarithms.value), function(logarithms.replicates), reliable)

    both = logarithms.reliable & logarithms.reliable.shift(gate=-1, fill_value=False)
    both = both.isel(gate=slice(None, -1)).rename(gate="interval").drop_vars(OF_GATES, errors="ignore")
    between = of(lambda values: -(_steps(values) / _steps(path)), both)
    fitted = of(lambda values: -_slope(path, values, weight), (logarithms.reliable | ~taken).all("gate"))
    by_interval = described(between, "k", long_name=f"lidar attenuation coefficient of {channel}", units="m-1")
    fit = described(fitted, "k_fitted", long_name=f"lidar attenuation coefficient of {channel}, fitted", units="m-1")
    out = by_interval.merge(fit.rename(reliable="k_fitted_reliable"), compat="override")
    middle = _steps(depth) / 2 + depth.isel(gate=slice(None, -1)).rename(gate="interval").drop_vars(OF_GATES, errors="ignore")
    about = {"long_name": "depth between the middles of two gates", "units": "m"}
    return out.assign(k_fitted_gate=taken.assign_attrs(long_name="whether the fit has the gate")).assign_coords(
        depth=middle.assign_attrs(about)
    )


def _steps(values):
    """From gate to gate."""
    return values.diff("gate").rename(gate="interval").drop_vars([*OF_GATES, "interval"], errors="ignore")


def _path(scene, part, depth):
    """The way in the water, there and back [m]."""
    laser = light_of(scene["sea"], scene["source"]["wavelength_nm"])
    home = light_of(scene["sea"], float(part.channel_wavelength[0]))
    down = -unit(scene["source"]["direction"])[2]
    there = 1 / cosine_in_water(down, laser.refractive_index)
    axes = {each["name"]: -unit(each["direction"])[2] for each in scene["telescope"]}
    back = [1 / cosine_in_water(axes[str(name)], home.refractive_index) for name in part.telescope.values]
    return depth * (there + xarray.DataArray(back, dims="telescope", coords={"telescope": part.telescope}))


def _taken(logarithms, depth, depths):
    """The gates of a fit."""
    taken = (logarithms.error < LARGEST_ERROR) & (logarithms.error > 0) & numpy.isfinite(logarithms.value)
    if depths is not None:
        first, last = depths
        if not first < last:
            raise Error(f"depths = ({first:g}, {last:g}): the first depth of a fit is above the last")
        taken = taken & (depth >= first) & (depth <= last)
    fewest = int(taken.sum("gate").min())
    if fewest < 3:
        raise Error(f"k_lidar: a fit of three gates at least: {fewest} in the water have errors below 10 % (take more depths, or photons)")
    return taken


def _slope(x, y, weight):
    """The slope of the weighted straight line; gates of weight 0 are left out."""
    y = y.where(weight > 0, 0.0)
    total = weight.sum("gate")
    x0, y0 = (weight * x).sum("gate") / total, (weight * y).sum("gate") / total
    return (weight * (x - x0) * (y - y0)).sum("gate") / (weight * (x - x0) ** 2).sum("gate")
