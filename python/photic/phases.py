"""Phase functions of light that turns back, of the cosine of the scattering angle [1/sr]."""

from __future__ import annotations

from typing import Any, Callable

import numpy

RAMAN_DEPOLARISATION = 0.17  # of a polarised beam: Porto 1966, J. Opt. Soc. Am. 56, 1585
STEP_DEG = 5.0  # of the angles of an optical table beyond 10 degrees
FIRST_DEG = 15.0
# Four neighbours of an interval, and the products of Lagrange's polynomials through them.
NEIGHBOURS = (-1, 0, 1, 2)


def isotropic(cosine: Any) -> Any:
    """Fluorescence."""
    return numpy.full(numpy.shape(cosine), 1 / (4 * numpy.pi))


def raman(cosine: Any) -> Any:
    """Of water: 3/(16 pi) (1 + 3 rho)/(1 + 2 rho) [1 + (1 - rho)/(1 + 3 rho) cos^2], Porto 1966."""
    rho = RAMAN_DEPOLARISATION
    return 3 / (16 * numpy.pi) * ((1 + 3 * rho) + (1 - rho) * numpy.square(cosine)) / (1 + 2 * rho)


def tabulated(angle_deg: Any, per_sr: Any) -> Callable[[Any], Any]:
    """Through the values of an optical table, beyond 20 degrees, by cubic polynomials in the angle. About 180
    degrees phase functions are even."""
    back = angle_deg >= FIRST_DEG
    values = numpy.concatenate([per_sr[back], per_sr[back][-2:-4:-1]])

    def phase(cosine: Any) -> Any:
        steps = (numpy.degrees(numpy.arccos(numpy.clip(cosine, -1, 1))) - FIRST_DEG) / STEP_DEG
        first = numpy.clip(numpy.floor(steps).astype(int), 1, len(values) - 3)
        x = steps - first
        total = numpy.zeros_like(steps)
        for at in NEIGHBOURS:
            others = [other for other in NEIGHBOURS if other != at]
            total += values[first + at] * numpy.prod([(x - other) / (at - other) for other in others], axis=0)
        return total

    return phase
