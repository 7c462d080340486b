"""The echo of light that was scattered once, in closed form (docs/theory.md, eq. 30): the lidar equation of
plane layers under a flat sea, integrated over the laser's cone, every gate and every layer.

It shares no code with the program; coefficients, indices and phase functions are given to it."""

from __future__ import annotations

from typing import Any, Callable, NamedTuple

import numpy

from photic.lens import Lens
from photic.rays import Beam
from photic.seawater import Light

POINTS = 8  # along a ray within a layer of a gate
BOTTOMLESS_M = 1e6


class Turned(NamedTuple):
    """The processes that turn light, in each layer, and the light that is turned."""

    light: Light
    coefficient_per_m: Any  # [layer]
    phase: Callable[[int, Any], Any]  # of a layer and the cosine of the angle [1/sr]
    c_per_m: Any  # [layer], attenuation on the way home


class Layers:
    """Plane layers from the surface down, and how they attenuate the laser's light."""

    def __init__(self, edges_m: Any, c_per_m: Any) -> None:
        self.edges = numpy.minimum(edges_m, BOTTOMLESS_M)  # one more than layers
        self.c_per_m = numpy.asarray(c_per_m)

    def optical_depth(self, c_per_m: Any, depth: Any) -> Any:
        """From the surface straight down, for any attenuation."""
        at_edges = numpy.concatenate([[0.0], numpy.cumsum(c_per_m * numpy.diff(self.edges))])
        return numpy.interp(depth, self.edges, at_edges)


def echo(beam: Beam, lens: Lens, layers: Layers, turned: Turned, gate_paths: Any) -> Any:
    """Photons per photon emitted, by gate. gate_paths: group paths at the begin and end of each [m]."""
    ends = beam.places(gate_paths, lens.centre, turned.light)
    edges = layers.edges[:, None] / -beam.direction[:, 2]
    out = numpy.zeros(len(ends))
    for gate, (first, last) in enumerate(zip(ends[:, 0], ends[:, 1])):
        for layer, (top, bottom) in enumerate(zip(edges, edges[1:])):
            low, high = numpy.maximum(first, top), numpy.minimum(last, bottom)
            if (high > low).any():
                out[gate] += _integral(beam, lens, layers, turned, layer, low, numpy.maximum(low, high))
    return out


def _integral(beam: Beam, lens: Lens, layers: Layers, turned: Turned, layer: int, low: Any, high: Any) -> float:
    """The part of the echo from between two places of each ray, within one layer."""
    s, weights = quadrature(low, high)
    way = beam.way_home(s, lens.centre, turned.light)
    depth = -s * beam.direction[:, 2]
    slant = way.in_water / numpy.maximum(depth, 1e-12)
    tau = layers.optical_depth(layers.c_per_m, depth) / -beam.direction[:, 2]
    tau = tau + layers.optical_depth(turned.c_per_m, depth) * slant
    density = turned.phase(layer, way.cosine) * lens.solid_angle(way) * way.transmittance * numpy.exp(-tau)
    return float(turned.coefficient_per_m[layer] * numpy.mean(beam.transmittance * (weights * density).sum(axis=0)))


def quadrature(low: Any, high: Any) -> tuple[Any, Any]:
    """Gauss's points between places [ray], and their weights, [point, ray]."""
    nodes, weights = numpy.polynomial.legendre.leggauss(POINTS)
    half = (high - low) / 2
    return low + half * (nodes[:, None] + 1), half * weights[:, None]
