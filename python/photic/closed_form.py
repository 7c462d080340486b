"""Limits of the closed forms, and the refusals."""

from __future__ import annotations

from typing import Any

import numpy

from photic.errors import Error
from photic.names import suggestion
from photic.rays import unit


def expect_lidar_over_flat_sea(scene: dict[str, Any], function: str) -> None:
    """Raises photic.Error for a scene whose geometry the closed forms do not have."""
    if not scene.get("telescope"):
        raise Error(f"{function}: the scene has no telescopes (add [[telescope]], [[channel]] and [gates])")
    if not {"layer", "column"} & set(scene.get("sea", {})):
        raise Error(f"{function}: the scene has no sea: it is of air alone (add [[sea.layer]])")
    for name, instrument in _instruments(scene):
        if instrument["position_m"][2] <= 0:
            raise Error(f"{function}: {name} is in the water, but the closed form is of the air (set position_m[2] above 0)")
        if unit(instrument["direction"])[2] >= 0:
            raise Error(f"{function}: {name} does not look down to the sea (set direction[2] below 0)")
    _expect_beam_to_come_down(scene["source"], function)
    model = scene["sea"]["surface"]["model"]
    if model != "flat":
        raise Error(f'{function}: the closed form has no waves (sea.surface.model is "{model}": set it to "flat")')
    if scene.get("atmosphere", {}).get("refraction"):
        raise Error(f"{function}: the closed form has no air that bends light (set atmosphere.refraction to false)")


def _expect_beam_to_come_down(source: dict[str, Any], function: str) -> None:
    edge = 1e-3 * source["half_divergence_mrad"] * (3 if source["profile"] == "gaussian" else 1)
    if numpy.arccos(-unit(source["direction"])[2]) + edge >= numpy.pi / 2:
        raise Error(
            f"{function}: some light of the laser does not come down to the sea (take a smaller source.half_divergence_mrad "
            "or a steeper source.direction)"
        )


def _instruments(scene: dict[str, Any]) -> list[tuple[str, dict[str, Any]]]:
    telescopes = [(f'telescope "{each["name"]}"', each) for each in scene["telescope"]]
    return [("the laser", scene["source"]), *telescopes]


def expect_clear_way(scene: dict[str, Any], function: str) -> None:
    """Raises photic.Error for what else light meets, and what the equation of single scattering does not have."""
    if "atmosphere" in scene:
        raise Error(f"{function}: the closed form has no air that scatters or absorbs (leave out [atmosphere])")
    if scene.get("oil", {}).get("thickness_um", 0) > 0:
        raise Error(f"{function}: the closed form has no film of oil (set oil.thickness_um to 0)")
    if scene.get("bottom", {}).get("albedo", 0) != 0:
        raise Error(f"{function}: the closed form has no light of the sea bed (leave out [bottom])")
    if scene["sea"].get("column"):
        raise Error(f"{function}: the closed form has no columns side by side (give [[sea.layer]], not [[sea.column]])")
    for channel in scene["channel"]:
        _expect_process(scene, channel, function)


def _expect_process(scene: dict[str, Any], channel: dict[str, Any], function: str) -> None:
    known = ["elastic", "raman", "chlorophyll", "cdom"]
    process = channel.get("process")
    if process is None:
        raise Error(
            f'{function}: channel "{channel["name"]}" has a filter, and the closed form counts all light of a process '
            f'(give it process = "elastic", or one of {", ".join(known[1:])})'
        )
    if process not in known:
        raise Error(
            f'{function}: channel "{channel["name"]}" counts {process} light, which water alone does not make'
            f"{suggestion(process, known)}"
        )
    lifetime = f"{process}_lifetime_ns"
    if scene["optics"].get(lifetime, 0) > 0:
        raise Error(f"{function}: the closed form has light that is emitted at once (set optics.{lifetime} to 0)")
