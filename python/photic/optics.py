"""The optics of a scene's water."""

from __future__ import annotations

import os
from typing import Any, Union

import numpy
import xarray

from photic.core import context, core
from photic.errors import Error
from photic.result import optics_of_arrays
from photic.scene import Scene
from photic.simulation import File


def of(scene: Union[Scene, File], wavelength_nm: Any = None) -> xarray.Dataset:
    """The optical properties of the layers of a scene's water: what `photic optics` writes of the scene, as
    photic.open gives it, in memory.

    scene          a photic.Scene, or the path of a scene file
    wavelength_nm  [nm] a number or several, in any order; by default the wavelengths that light of the scene
                   has: the laser's, and of each process that its channels count the mean

    On depth (the layers' upper edges) [m], wavelength [nm], angle [degree], process (indexed by name) and
    emission_line:
    a_per_m, b_per_m, c_per_m, bb_per_m  [1/m] (depth, wavelength): absorption, scattering, their sum,
                    and scattering backwards, of water and all its constituents
    albedo, mean_cosine  [1] (depth, wavelength): b / c, and the mean cosine of the scattering angle
    phase_function_per_sr  [1/sr] (depth, wavelength, angle): 1 over the whole sphere
    a_water_per_m …  [1/m] (depth, wavelength): parts of constituents
    emission_per_m, emission_line_per_m  [1/m] (depth, process or emission_line): photons that a process
                    emits per metre and photon of the laser's light, and those of each of its lines
    The sources of all numbers are in the attribute references, the scene with all its defaults in scene.

    Raises photic.SceneError for a scene that is wrong, photic.Error for a wavelength without data and for
    air without a sea. Source: docs/theory.md, sections 2 to 4.
    """
    scene = scene_from(scene)
    nm = None if wavelength_nm is None else _ascending(wavelength_nm)
    command = "photic.optics.of(scene)" if nm is None else f"photic.optics.of(scene, {nm!r})"
    table = optics_of_arrays(core().optics_of(context(), scene._document, nm, command))
    if table.sizes["depth"] == 0:
        raise Error("the scene has no water: it is of air alone (photic optics --air SCENE shows the air)")
    return table


def scene_from(scene: Any) -> Scene:
    """A scene as it is, or that of a file."""
    if isinstance(scene, Scene):
        return scene
    if isinstance(scene, (str, os.PathLike)):
        return Scene.load(scene)
    raise Error(
        f"scene: of type {type(scene).__name__}, neither a photic.Scene nor the path of a scene file "
        '(photic.Scene(ds.attrs["scene"]) is the scene of a result)'
    )


def _ascending(wavelength_nm: Any) -> list[float]:
    try:
        nm = numpy.unique(numpy.asarray(wavelength_nm, dtype=float))
    except (TypeError, ValueError):
        raise Error(f"wavelength_nm: {wavelength_nm!r} are no numbers (write 532, or [532, 650])") from None
    if nm.size == 0 or not bool((numpy.isfinite(nm) & (nm > 0)).all()):
        raise Error(f"wavelength_nm: {wavelength_nm!r} has no number, or one that is no wavelength in nm")
    return [float(each) for each in nm]
