"""Echoes freed of what the distance and the overlap make of them."""

from __future__ import annotations

from typing import Any

import numpy
import xarray

from photic.closed_form import expect_lidar_over_flat_sea
from photic.errors import Error
from photic.first_order import ACROSS, mean_overlap
from photic.gate_scale import cosine_in_water, has_ranges, scale_of
from photic.lens import Lens
from photic.names import suggestion
from photic.rays import unit
from photic.result import scene_of
from photic.seawater import Light, light_of

NEEDED = ["echo", "echo_standard_error", "converged", "gate_depth", "gate_depth_bounds", "channel_wavelength"]


def range_corrected(ds: xarray.Dataset) -> xarray.Dataset:
    """The echo without its fall with distance, by telescope, channel and gate:

        X_g = E_g n^2 S_s S_t cos(theta_w) / (cos(theta_a) A eta_g)
        S_s = l_a + l_w / n,   S_t = l_a + l_w / n cos^2(theta_a) / cos^2(theta_w)

    with E the echo, l_a and l_w the ways from the lens in the air and in the water, along the axis of the
    telescope, to the centre of the gate (gate_depth), theta_a and theta_w their angles to the vertical, A the
    open area of the lens, and eta the overlap of the result's own scene (photic.overlap). At nadir that is

        X_g = E_g (n H + z)^2 / (A eta_g)

    and of a gate in the air E_g l_a^2 / (A eta_g). In the lidar equation X is the light that is turned back
    in the gate, times all transmittances. n is that of the channel's mean wavelength. The laser is near the
    axis of the telescope: the area that its light spreads over does not count.

    ds       a result, as photic.open and photic.run return it, or a part of it that keeps these axes: lidars in
             the air over a flat sea

    On (telescope, channel, gate), with their coordinates:
    range_corrected                 [1/sr] NaN where the telescope sees nothing of the gate
    range_corrected_standard_error  [1/sr] that of the echo, by the same factor; the overlap is taken as exact
    reliable                        [bool] whether the echo has converged, and both numbers are known

    Raises photic.Error for what is no result with echoes, and for scenes with waves, air that bends light, or
    instruments in the water or looking up.

    Sources: docs/theory.md, eq. 28, 31, 32; Measures 1983, Laser Remote Sensing, Wiley.
    """
    _expect_echoes(ds)
    parts = scene_of(ds)
    expect_lidar_over_flat_sea(parts, "range_corrected")
    telescopes = [_named(parts["telescope"], name) for name in ds.telescope.values]
    lights = [light_of(parts["sea"], float(nm)) for nm in ds.channel_wavelength.values]
    factor = _per_echo(parts, telescopes, lights, ds)
    value, error = ds.echo * factor, ds.echo_standard_error * factor
    of = "range-corrected echo"
    return xarray.Dataset(
        {
            "range_corrected": value.assign_attrs(long_name=of, units="sr-1"),
            "range_corrected_standard_error": error.assign_attrs(long_name=f"standard error of the {of}", units="sr-1"),
            "reliable": (ds.converged & numpy.isfinite(value) & numpy.isfinite(error)).assign_attrs(
                long_name=f"whether the {of} and its standard error can be relied on"
            ),
        }
    ).transpose(*ACROSS)


def _per_echo(
    parts: dict[str, Any], telescopes: list[dict[str, Any]], lights: list[Light], ds: xarray.Dataset
) -> xarray.DataArray:
    """X_g / E_g. Places are known by depth or range, which air that delays pulses leaves as they are."""
    laser, is_range = light_of(parts["sea"], parts["source"]["wavelength_nm"]), has_ranges(parts)
    centres = ds.gate_depth.transpose(*ACROSS).values
    bounds = ds.gate_depth_bounds.transpose(*ACROSS, "bnds").values
    spread: list[list[Any]] = [[] for _ in telescopes]
    paths: list[list[Any]] = [[] for _ in telescopes]
    for t, telescope in enumerate(telescopes):
        for c, light in enumerate(lights):
            spread[t].append(_spread(telescope, light, centres[t, c], is_range))
            paths[t].append(scale_of(parts, telescope, laser, light, is_range).path(bounds[t, c]))
    eta = mean_overlap(parts, telescopes, lights, paths)
    areas = xarray.DataArray([Lens(telescope).area for telescope in telescopes], dims="telescope")
    factor: xarray.DataArray = xarray.DataArray(numpy.array(spread), dims=ACROSS) / (areas * eta.where(eta > 0))
    return factor


def _spread(telescope: dict[str, Any], light: Light, place: Any, is_range: bool) -> Any:
    """The area that one steradian of light spreads over on its way along the axis to the lens, by places that
    are ranges along it, or depths [m2/sr]."""
    n, up, height = light.refractive_index, -unit(telescope["direction"])[2], telescope["position_m"][2]
    in_water = cosine_in_water(up, n)
    along = place if is_range else numpy.where(place > 0, height / up + place / in_water, (height + place) / up)
    air = numpy.minimum(along, height / up)
    water = along - air
    s = air + water / n
    t = air + water / n * (up / in_water) ** 2
    return s * t * numpy.where(water > 0, n * n * in_water / up, 1.0)


def _named(telescopes: list[dict[str, Any]], name: Any) -> dict[str, Any]:
    known = {each["name"]: each for each in telescopes}
    if name not in known:
        raise Error(f"range_corrected: the result's scene has no telescope {str(name)!r}{suggestion(str(name), list(known))}")
    return known[name]


def _expect_echoes(ds: Any) -> None:
    is_result = isinstance(ds, xarray.Dataset) and "scene" in ds.attrs and all(name in ds.variables for name in NEEDED)
    if not is_result or not set(ACROSS) <= set(ds.dims):
        raise Error(
            "range_corrected: not a result with the axes telescope, channel and gate: take what photic.open or photic.run "
            'returns, or a part of it as ds.sel(channel=["raman"])'
        )
