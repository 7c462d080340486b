"""The gates of a scene: their edges in time, and the depths or ranges that light of first order comes from
then (docs/theory.md, eq. 35)."""

from __future__ import annotations

import math
from typing import Any, NamedTuple, Sequence

import numpy
import xarray

from photic.rays import LIGHT_M_PER_NS, dot, unit
from photic.seawater import Light

STEEP = math.cos(math.radians(45))  # of axes that have depths
ROUNDING = 1e-6  # of a number of steps, which is no gate


class Scale(NamedTuple):
    """Depths or ranges against group paths: two straight lines that meet at the surface."""

    surface: float
    path_to_surface: float
    per_metre_in_air: float
    per_metre_in_water: float

    def path(self, place: Any) -> Any:
        beyond = numpy.asarray(place) - self.surface
        return self.path_to_surface + beyond * numpy.where(beyond < 0, self.per_metre_in_air, self.per_metre_in_water)

    def place(self, path: Any) -> Any:
        beyond = numpy.asarray(path) - self.path_to_surface
        return self.surface + beyond / numpy.where(beyond < 0, self.per_metre_in_air, self.per_metre_in_water)


def cosine_in_water(cosine: float, index: float) -> float:
    """By Snell's law."""
    return math.sqrt(1 - (1 - cosine * cosine) / index**2)


def edge_paths(scene: dict[str, Any], laser: Light) -> Any:
    """The group paths at the edges of the gates [m], from the disc to the lens, as if the air were a vacuum."""
    gates = scene["gates"]
    for kind in ("depth", "range"):
        if f"{kind}_max_m" in gates:
            scale = scale_of(scene, scene["telescope"][0], laser, laser, kind == "range")
            return scale.path(_edges(*(gates[f"{kind}_{name}_m"] for name in ("min", "max", "step"))))
    return LIGHT_M_PER_NS * _edges(gates["start_ns"], gates["stop_ns"], gates["step_ns"])


def coordinates(scene: dict[str, Any], laser: Light, lights: Sequence[Light]) -> dict[str, xarray.DataArray]:
    """Those of a result: of the gates, and of the channels, whose light is given. Without the time of gates where
    there is air, which delays pulses."""
    edges = edge_paths(scene, laser)
    is_range = has_ranges(scene)
    places = [[scale_of(scene, t, laser, light, is_range).place(edges) for light in lights] for t in scene["telescope"]]
    quantity = "range along the axis of the telescope" if is_range else "depth"
    about = {"long_name": f"{quantity} from which light scattered once arrives at the centre of the gate", "units": "m"}
    about |= {} if is_range else {"standard_name": "depth", "positive": "down"}
    of_time = {"long_name": "time from the laser to the telescope, centre of the gate", "units": "ns"}
    of_wavelength = {"long_name": "mean wavelength of the light that the channel counts", "units": "nm"}
    timed = {} if "atmosphere" in scene else _with_bounds("gate_time", ("gate",), edges / LIGHT_M_PER_NS, of_time)
    return {
        **{axis: xarray.DataArray([each["name"] for each in scene[axis]], dims=axis) for axis in ("telescope", "channel")},
        "channel_wavelength": xarray.DataArray([each.wavelength_nm for each in lights], dims="channel", attrs=of_wavelength),
        **timed,
        **_with_bounds("gate_depth", ("telescope", "channel", "gate"), numpy.array(places), about),
    }


def _with_bounds(name: str, dims: tuple[str, ...], edges: Any, about: dict[str, str]) -> dict[str, xarray.DataArray]:
    bounds = numpy.stack([edges[..., :-1], edges[..., 1:]], axis=-1)
    centres = xarray.DataArray(bounds.mean(axis=-1), dims=dims, attrs={**about, "bounds": name + "_bounds"})
    return {name: centres, name + "_bounds": xarray.DataArray(bounds, dims=(*dims, "bnds"))}


def _edges(first: float, last: float, step: float) -> Any:
    """Gates are all equally long."""
    return numpy.linspace(first, last, math.ceil((last - first) / step - ROUNDING) + 1)


def has_ranges(scene: dict[str, Any]) -> bool:
    """Returns whether the places of gates are ranges along the axis of each telescope, not depths."""
    axes = [scene["source"]["direction"], scene["telescope"][0]["direction"]]
    by_time = "start_ns" in scene["gates"]
    return "range_max_m" in scene["gates"] or (by_time and any(unit(axis)[2] >= -STEEP for axis in axes))


def scale_of(scene: dict[str, Any], telescope: dict[str, Any], laser: Light, home: Light, is_range: bool) -> Scale:
    """Depths, or ranges along the axis of the telescope, of light that comes home with other indices."""
    source, axis = scene["source"], unit(telescope["direction"])
    down, up = -unit(source["direction"])[2], -axis[2]
    to_lens = telescope["position_m"][2] / up
    if not is_range:
        ways = [(down, laser), (up, home)]
        per_metre = sum(light.group_index / cosine_in_water(cosine, light.refractive_index) for cosine, light in ways)
        return Scale(0.0, source["position_m"][2] / down + to_lens, 1 / down + 1 / up, per_metre)
    # The source counts as where it is along the axis of the telescope.
    ahead = float(dot(numpy.subtract(source["position_m"], telescope["position_m"]), axis))
    return Scale(to_lens, 2 * to_lens - ahead, 2.0, laser.group_index + home.group_index)
