"""Rays of a laser above a flat sea, and the way of their light home to a telescope: geometry of the closed
forms, made without the program. Rays refract by Snell's law; solid angles are those of thin bundles of rays,
differentiated by hand."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy

from photic.seawater import Light

LIGHT_M_PER_NS = 0.299792458
RINGS, AZIMUTHS = 192, 4  # of the laser's cone: edges of what is seen are known by rings
GOLDEN_SHARE = (3 - 5**0.5) / 2  # by which each ring is turned, of the way to its next ray
STEPS_TO_CROSSING, STEPS_TO_TIME = 6, 10
GAUSSIAN_CUT = 3  # of a Gaussian laser: where its light ends, over where it is 1/e2 of its peak


class WayHome(NamedTuple):
    """From points of rays to the centre of the lens."""

    in_water: Any  # [m]
    in_air: Any  # [m]
    arriving: Any  # direction of travel at the lens, on a last axis of three
    cosine: Any  # of the scattering angle
    angle_per_area: Any  # solid angle at the point over area across the ray at the lens [1/m2]
    transmittance: Any  # of the surface
    refractive_index: Any  # of the water

    @property
    def apparent(self) -> Any:
        """The distance at which the point seems to be, S_s of eq. 28 [m]."""
        return self.in_air + self.in_water / self.refractive_index


def fresnel(n1: float, n2: float, cosine1: Any, cosine2: Any) -> Any:
    """The unpolarised reflectance of an interface (Born & Wolf, section 1.5.2)."""
    s = (n1 * cosine1 - n2 * cosine2) / (n1 * cosine1 + n2 * cosine2)
    p = (n2 * cosine1 - n1 * cosine2) / (n2 * cosine1 + n1 * cosine2)
    return (s * s + p * p) / 2


def unit(direction: Any) -> Any:
    return numpy.asarray(direction, dtype=float) / numpy.linalg.norm(direction)


def dot(one: Any, other: Any) -> Any:
    return (one * other).sum(axis=-1)


def _where(wet: Any, in_water: Any, in_air: Any) -> Any:
    """Numbers, directions, or what is the same everywhere."""
    return numpy.where(wet[..., None] if numpy.ndim(in_water) > wet.ndim else wet, in_water, in_air)


class Beam:
    """The laser's cone: rays of equal shares of the light, by rings and azimuths. A place of a ray is its
    distance s from the surface: below 0 in the air, above 0 in the water."""

    def __init__(self, source: dict[str, Any], light: Light, rings: int = RINGS, azimuths: int = AZIMUTHS) -> None:
        disc, k = _cone(source, rings, azimuths)
        self.light, self.in_air = light, k
        self.path = -disc[:, 2] / k[:, 2]  # [m] from the disc to the surface
        self.start = disc + self.path[:, None] * k
        bent = k[:, :2] / light.refractive_index
        self.direction = numpy.column_stack([bent, -numpy.sqrt(1 - (bent**2).sum(axis=1))])
        self.transmittance = 1 - fresnel(1.0, light.refractive_index, -k[:, 2], -self.direction[:, 2])

    def way_home(self, s: Any, centre: Any, home: Light) -> WayHome:
        """From the places s [..., ray] to the centre of a lens in the air, as light of its own wavelength."""
        from_water, from_air = self._from_water(s, centre, home), self._from_air(s, centre, home.refractive_index)
        wet = numpy.asarray(s) > 0
        return WayHome(*(_where(wet, one, other) for one, other in zip(from_water, from_air)))

    def places(self, path: Any, centre: Any, home: Light) -> Any:
        """The places of the rays [..., ray] whose light has come so far [m], as group path, when it arrives at
        the lens; the disc for light that cannot arrive so early."""
        s = numpy.zeros(numpy.shape(path) + self.path.shape)
        path = numpy.asarray(path)[..., None]
        for _ in range(STEPS_TO_TIME):
            way = self.way_home(s, centre, home)
            out, back = numpy.where(s > 0, self.light.group_index, 1.0), numpy.where(s > 0, home.group_index, 1.0)
            missing = path - (self.path + out * s + home.group_index * way.in_water + way.in_air)
            # By how much a step makes the path longer; with group indices in place of indices, so all but exactly.
            s = numpy.maximum(s + missing / (out - back * way.cosine), -self.path)
        return s

    def _from_water(self, s: Any, centre: Any, home: Light) -> WayHome:
        point = self.start + numpy.maximum(s, 0)[..., None] * self.direction
        aside, depth, height, n = centre[:2] - point[..., :2], -point[..., 2], centre[2], home.refractive_index
        r = numpy.hypot(aside[..., 0], aside[..., 1])
        tangent = numpy.zeros_like(r)  # of the angle in the air
        for _ in range(STEPS_TO_CROSSING):  # Newton's; r is concave in the tangent, so that they come from below
            root = numpy.sqrt(n * n + (n * n - 1) * tangent**2)
            tangent += (r - tangent * (height + depth / root)) / (height + depth * n * n / root**3)
        air = 1 / numpy.sqrt(1 + tangent**2)  # cosines and sines of the angles to the vertical
        in_air_sine = tangent * air
        sine = in_air_sine / n
        water = numpy.sqrt(1 - sine**2)
        outward = aside / numpy.maximum(r, 1e-12)[..., None]
        leaving = numpy.concatenate([outward * sine[..., None], water[..., None]], axis=-1)
        in_water, in_air = depth / water, height / air
        # r = sine (depth / water + n height / air); of a cone of rays, dOmega = sine dtheta dphi in the water
        # lands on dA = r dr cos(theta_air) dphi across the ray.
        slope = depth / water**2 + height / air**2 * n * water / air  # dr / dtheta
        return WayHome(
            in_water, in_air,
            arriving=numpy.concatenate([outward * in_air_sine[..., None], air[..., None]], axis=-1),
            cosine=dot(leaving, self.direction), angle_per_area=1 / ((in_water + n * in_air) * slope * air),
            transmittance=1 - fresnel(n, 1.0, water, air), refractive_index=n,
        )  # fmt: skip

    def _from_air(self, s: Any, centre: Any, index: float) -> WayHome:
        way = centre - (self.start + numpy.minimum(s, 0)[..., None] * self.in_air)
        length = numpy.maximum(numpy.linalg.norm(way, axis=-1), 1e-12)
        arriving = way / length[..., None]
        none = numpy.zeros_like(length)
        return WayHome(
            none, length, arriving, cosine=dot(arriving, self.in_air), angle_per_area=1 / length**2,
            transmittance=none + 1, refractive_index=index,
        )  # fmt: skip


def _cone(source: dict[str, Any], rings: int, azimuths: int) -> tuple[Any, Any]:
    """The places where the rays leave the disc, and their directions."""
    axis, u, v = _frame(source["direction"])
    ring, ray = numpy.divmod(numpy.arange(rings * azimuths), azimuths)
    azimuth = (2 * numpy.pi / azimuths * (ray + ring * GOLDEN_SHARE))[:, None]
    around = numpy.cos(azimuth) * u + numpy.sin(azimuth) * v
    radius, divergence = source["diameter_m"] / 2, 1e-3 * source["half_divergence_mrad"]
    # Of 1 - cos, or of the disc's area where the light is parallel: even, but for a Gaussian.
    share = (ring + 0.5)[:, None] / rings
    if source["profile"] == "gaussian":
        share = _of_gaussian(share, divergence)
    if divergence == 0:
        across, k = radius * numpy.sqrt(share), numpy.tile(axis, (share.size, 1))
    else:
        cosine = 1 - 2 * numpy.sin(divergence / 2) ** 2 * share
        k = cosine * axis + numpy.sqrt(1 - cosine**2) * around
        # The cone's tip is behind the disc.
        across = radius / numpy.tan(divergence) * numpy.sqrt(1 - cosine**2) / cosine
    return numpy.array(source["position_m"]) + across * around, k


def _of_gaussian(share: Any, divergence: float) -> Any:
    """The radius within which a share of a Gaussian's light is, in units of where it is 1/e2 of its peak: it
    falls as exp(-2 x), and is cut off (docs/theory.md, eq. 108)."""
    cut = GAUSSIAN_CUT**2
    if divergence > 0:
        cut = (numpy.sin(GAUSSIAN_CUT * divergence / 2) / numpy.sin(divergence / 2)) ** 2
    return -numpy.log(1 - share * (1 - numpy.exp(-2 * cut))) / 2


def _frame(direction: Any) -> tuple[Any, Any, Any]:
    """The axis, and two directions across it and each other."""
    axis = unit(direction)
    across = unit(numpy.cross(axis, numpy.eye(3)[numpy.abs(axis).argmin()]))
    return axis, across, numpy.cross(axis, across)


def beam_for(source: dict[str, Any], telescope: dict[str, Any], light: Light) -> Beam:
    """The laser's cone, of one azimuth where turning everything about one vertical changes nothing."""
    offset = numpy.subtract(source["position_m"], telescope["position_m"])
    turned = [unit(source["direction"])[:2], unit(telescope["direction"])[:2], offset[:2]]
    return Beam(source, light, azimuths=1 if not numpy.any(turned) else AZIMUTHS)
