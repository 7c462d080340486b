"""The lidar equation and the overlap of a scene, by telescope, channel and gate."""

from __future__ import annotations

from typing import Any, NamedTuple, Union

import numpy
import xarray

from photic import optics, phases
from photic.closed_form import expect_clear_way, expect_lidar_over_flat_sea
from photic.errors import Error
from photic.gate_scale import coordinates, edge_paths
from photic.lens import Lens
from photic.rays import Beam, beam_for
from photic.result import scene_of
from photic.scene import Scene
from photic.seawater import Light, light_of
from photic.simulation import File
from photic.single_scattering import Layers, Turned, echo, quadrature

ACROSS = ("telescope", "channel", "gate")


def lidar_equation(scene: Union[Scene, File]) -> xarray.Dataset:
    """The echo of light that was scattered once, in closed form: what echo_by_order of a run has at order 1.

    Of each ray of the laser's cone, in water of plane layers under a flat sea, with s the way along the ray
    in the water at the depth z, theta the angle between the ray and the one that Snell's law leads to the
    centre of the lens, and l the way of that in the water:

        echo = mean over rays of the integral over the gate of
               T_down T_up sigma(z) p(theta) dOmega/dA A cos(psi) eta exp(-tau_down - tau_up) ds

    sigma is b of elastic light, else what the process emits per metre (with Raman light's and isotropic p, at
    each line of its spectrum); tau_down and tau_up are the integrals of c along both ways, at the laser's
    and the emitted wavelength; dOmega/dA is that of eq. 28 (at nadir 1 / (n H + z)^2), A the open area of the
    lens, psi the angle of the arriving ray to its axis, eta the overlap (eq. 31, 32). Straight down:

        d echo / dz = T_down T_up sigma p(180) A eta / (n H + z)^2 exp(-(c_laser + c_emitted) z)

    It shares no code with the program: sigma, c and p are those of photic.optics.of, whose phase function is
    interpolated between angles 5 degrees apart. The blur of an image is taken for round, as by runs with
    simulation.reception = "overlap": where a slanted lidar's detector sees a part of it (ship-tilted, 15
    degrees), single rays give 0.2 % less.

    scene  a photic.Scene, or the path of a scene file: laser and telescopes in the air, anywhere and tilted
           anyhow, channels of a process; environments and sensitivities do not count

    On (telescope, channel, gate), with the coordinates of a result:
    echo   [1] photons scattered once that are detected in the gate, per photon emitted

    Raises photic.SceneError for a scene that is wrong, photic.Error for what is not in the closed form: waves,
    a film, [atmosphere], instruments in the water or looking up, a sea bed that reflects, columns, channels
    with filters, fluorescence that lasts.

    Sources: docs/theory.md, eq. 20, 25, 28, 30 to 32, 34 and 35; Measures 1983, Laser Remote Sensing, Wiley.
    """
    scene = optics.scene_from(scene)
    table, parts = _described(scene, "lidar_equation")
    expect_clear_way(parts, "lidar_equation")
    lights = [_emitted(table, parts, channel["process"]) for channel in parts["channel"]]
    nm = {line.light.wavelength_nm for lines in lights for line in lines}
    spectra = optics.of(scene, sorted(nm | {parts["source"]["wavelength_nm"]}))
    processes = [channel["process"] for channel in parts["channel"]]
    turned = [[_turned(spectra, process, one) for one in lines] for process, lines in zip(processes, lights)]
    laser = light_of(parts["sea"], parts["source"]["wavelength_nm"])
    layers = Layers(_edges(table), spectra.c_per_m.sel(wavelength=laser.wavelength_nm).values)
    paths = _gate_paths(edge_paths(parts, laser))
    echoes, none = [], numpy.zeros(len(paths))
    for telescope in parts["telescope"]:
        beam, lens = beam_for(parts["source"], telescope, laser), Lens(telescope)
        echoes.append([sum((echo(beam, lens, layers, each, paths) for each in of_channel), none) for of_channel in turned])
    meaning = "expected photons scattered once that are detected in the gate per photon emitted"
    made = xarray.DataArray(numpy.array(echoes), dims=ACROSS, attrs={"long_name": meaning, "units": "1"})
    means = [_mean(lines) if lines else laser for lines in lights]
    return xarray.Dataset({"echo": made}, coordinates(parts, laser, means))


def overlap(scene: Union[Scene, File]) -> xarray.Dataset:
    """The overlap of laser and telescope: the share of the light that the open lens collects of a gate which
    falls on the detector.

    Of a point at the apparent range z along the telescope's axis and the angle psi off it, the lens (radius
    r_l, obstruction r_o, focal length f) makes on the plane of the detector (radius r_d, x_d behind the
    lens) a disc with a shadow in it, whose radii and distance from the axis are

        rho = r_l |1 - x_d (1/f - 1/z)|,   rho_o = rho r_o / r_l,   q = x_d tan(psi)
        eta = [A(r_d, rho, q) - A(r_d, rho_o, q)] / [pi (rho^2 - rho_o^2)]

    with A the area common to two circles. It is averaged evenly over the rays of the laser's cone, and along
    each over the gate: where light is that arrives in the gate after one scattering. z is the way in the air
    plus that in the water over n.

    scene    a photic.Scene, or the path of a scene file: laser and telescopes in the air, beside each other or
             not, tilted anyhow, detectors in focus or out of it. A film, the bed, columns, and air that does not
             bend light do not count

    On (telescope, channel, gate), with the coordinates of a result, but without gate_time where there is air,
    which delays pulses; channels differ by the index of their light, which of a filter is that at its centre:
    overlap  [1] 0 to 1; NaN in gates before any light

    Raises photic.SceneError for a scene that is wrong, photic.Error for waves, air that bends light, gates in time
    under air, instruments in the water or looking up, a filter without a centre.

    Sources: docs/theory.md, eq. 31, 32; compare Harms, Lahmann & Weitkamp 1978, Appl. Opt. 17, 1131, and Harms
    1979, Appl. Opt. 18, 1559.
    """
    table, parts = _described(scene, "overlap")
    laser = light_of(parts["sea"], parts["source"]["wavelength_nm"])
    lights = [_light_of_channel(table, parts, channel) for channel in parts["channel"]]
    if "atmosphere" in parts and "start_ns" in parts["gates"]:
        raise Error("overlap: the air delays pulses by what is not known here (give gates by depth or range, not in time)")
    paths = _gate_paths(edge_paths(parts, laser))
    eta = mean_overlap(parts, parts["telescope"], lights, [[paths for _ in lights] for _ in parts["telescope"]])
    return xarray.Dataset({"overlap": eta}, coordinates(parts, laser, lights))


def mean_overlap(
    parts: dict[str, Any], telescopes: list[dict[str, Any]], lights: list[Light], paths: list[list[Any]]
) -> xarray.DataArray:
    """The overlap of telescopes and lights, by gates that each have begin and end at group paths [m]."""
    laser = light_of(parts["sea"], parts["source"]["wavelength_nm"])
    values = []
    for telescope, of_telescope in zip(telescopes, paths):
        beam, lens = beam_for(parts["source"], telescope, laser), Lens(telescope)
        values.append([_mean_along(beam, lens, light, gates) for light, gates in zip(lights, of_telescope)])
    about = {"long_name": "share of the light collected from the gate that falls on the detector", "units": "1"}
    return xarray.DataArray(numpy.array(values), dims=ACROSS, attrs=about)


def _mean_along(beam: Beam, lens: Lens, light: Light, paths: Any) -> Any:
    ends = beam.places(paths, lens.centre, light)
    out = numpy.full(len(ends), numpy.nan)
    for gate, (low, high) in enumerate(zip(ends[:, 0], ends[:, 1])):
        s, weights = quadrature(low, high)
        if (high > low).any():
            out[gate] = (weights * lens.overlap(beam.way_home(s, lens.centre, light))).sum() / weights.sum()
    return out


class _Line(NamedTuple):
    """Light that a channel counts."""

    light: Light
    emitted_per_m: Any  # by layer; None of elastic light


def _described(scene: Any, function: str) -> tuple[xarray.Dataset, dict[str, Any]]:
    """The optical table of a scene, and the scene with its defaults; refused where its geometry is not known."""
    table = optics.of(scene)
    parts = scene_of(table)
    expect_lidar_over_flat_sea(parts, function)
    return table, parts


def _edges(table: xarray.Dataset) -> Any:
    bounds = table.depth_m_bounds.values
    return numpy.concatenate([bounds[:, 0], bounds[-1:, 1]])


def _gate_paths(edges: Any) -> Any:
    return numpy.stack([edges[:-1], edges[1:]], axis=-1)


def _emitted(table: xarray.Dataset, parts: dict[str, Any], process: str) -> list[_Line]:
    """The lines of a process's light, none where there is no such light."""
    if process == "elastic":
        return [_Line(light_of(parts["sea"], parts["source"]["wavelength_nm"]), None)]
    if "emission_line" not in table.dims:
        return []
    lines = table.isel(emission_line=(table.emission_line_process == process).values)
    coefficients = lines.emission_line_per_m.transpose("emission_line", "depth").values
    nm = [float(each) for each in lines.emission_wavelength_nm.values]
    return [_Line(light_of(parts["sea"], each), emitted) for each, emitted in zip(nm, coefficients)]


def _mean(lines: list[_Line]) -> Light:
    """The mean over the photons of the lines."""
    weights = [1.0 if line.emitted_per_m is None else float(line.emitted_per_m.sum()) for line in lines]
    return Light(*(float(numpy.average([line.light[k] for line in lines], weights=weights)) for k in range(3)))


def _light_of_channel(table: xarray.Dataset, parts: dict[str, Any], channel: dict[str, Any]) -> Light:
    if "centre_nm" in channel:
        return light_of(parts["sea"], channel["centre_nm"])
    if "process" not in channel:
        raise Error(
            f'overlap: channel "{channel["name"]}" has a filter without a centre, whose mean light is not known here '
            "(photic.range_corrected takes it from a result)"
        )
    lines = _emitted(table, parts, channel["process"]) or _emitted(table, parts, "elastic")
    return _mean(lines)


def _turned(spectra: xarray.Dataset, process: str, line: _Line) -> Turned:
    at = spectra.sel(wavelength=line.light.wavelength_nm)
    if line.emitted_per_m is None:
        in_layers = [phases.tabulated(at.angle.values, of_layer.values) for of_layer in at.phase_function_per_sr]
        return Turned(line.light, at.b_per_m.values, lambda layer, cosine: in_layers[layer](cosine), at.c_per_m.values)
    phase = phases.raman if process == "raman" else phases.isotropic
    return Turned(line.light, line.emitted_per_m, lambda layer, cosine: phase(cosine), at.c_per_m.values)
