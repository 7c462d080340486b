"""A thin lens and the round detector behind it (docs/theory.md, eq. 31 and 32)."""

from __future__ import annotations

from typing import Any

import numpy

from photic.rays import WayHome, dot, unit

SHARP_M = 1e-9  # radius of an image that is a point


class Lens:
    """A telescope of a scene."""

    def __init__(self, telescope: dict[str, Any]) -> None:
        self.axis = unit(telescope["direction"])
        self.centre = numpy.array(telescope["position_m"], dtype=float)
        self.radius = telescope["diameter_m"] / 2
        self.obstruction = telescope["obstruction_diameter_m"] / 2
        self.focal_length = f = telescope["focal_length_m"]
        if "detector_diameter_m" in telescope:
            self.detector = telescope["detector_diameter_m"] / 2
        else:
            self.detector = f * numpy.tan(1e-3 * telescope["half_field_of_view_mrad"])
        focus = telescope.get("focus_m")
        self.detector_distance = f + (telescope["detector_shift_m"] if focus is None else f * f / (focus - f))

    @property
    def area(self) -> float:
        """That collects light [m2]."""
        return float(numpy.pi * (self.radius**2 - self.obstruction**2))

    def cosine(self, way: WayHome) -> Any:
        """Of the arriving ray's angle to the axis."""
        return -dot(way.arriving, self.axis)

    def overlap(self, way: WayHome) -> Any:
        """The share of a point's image on the detector that the lens makes of it, eta."""
        cosine = numpy.maximum(self.cosine(way), 1e-9)
        x, range_m = self.detector_distance, numpy.maximum(way.apparent * cosine, 1e-9)
        per_radius = numpy.abs(1 - x * (1 / self.focal_length - 1 / range_m))
        blur, shadow = self.radius * per_radius, self.obstruction * per_radius
        aside = x * numpy.sqrt(numpy.maximum(0, 1 - cosine**2)) / cosine
        sharp = blur < SHARP_M
        lit = common_area(self.detector, blur, aside) - common_area(self.detector, shadow, aside)
        share = lit / numpy.where(sharp, 1, numpy.pi * (blur**2 - shadow**2))
        return numpy.where(self.cosine(way) > 0, numpy.where(sharp, aside < self.detector, share), 0.0)

    def solid_angle(self, way: WayHome) -> Any:
        """That leads from the points through the lens to the detector [sr]."""
        return way.angle_per_area * self.area * numpy.maximum(0, self.cosine(way)) * self.overlap(way)


def common_area(r1: Any, r2: Any, distance: Any) -> Any:
    """The common area of two circles."""
    r1, r2, d = numpy.broadcast_arrays(r1, numpy.maximum(r2, SHARP_M / 1e4), numpy.maximum(distance, 1e-12))
    first = numpy.arccos(numpy.clip((d * d + r1 * r1 - r2 * r2) / (2 * d * r1), -1, 1))
    second = numpy.arccos(numpy.clip((d * d + r2 * r2 - r1 * r1) / (2 * d * r2), -1, 1))
    kite = numpy.sqrt(numpy.maximum(0, (r1 + r2 - d) * (d + r1 - r2) * (d - r1 + r2) * (d + r1 + r2))) / 2
    lens_area = r1 * r1 * first + r2 * r2 * second - kite
    return numpy.where(d >= r1 + r2, 0, numpy.where(d <= numpy.abs(r1 - r2), numpy.pi * numpy.minimum(r1, r2) ** 2, lens_area))
