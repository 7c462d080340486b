"""The indices of sea water for light of a wavelength."""

from __future__ import annotations

from typing import Any, NamedTuple


class Light(NamedTuple):
    """Light of one wavelength in the water."""

    wavelength_nm: float
    refractive_index: float  # which bends rays, relative to air
    group_index: float  # which times pulses


def light_of(sea: dict[str, Any], wavelength_nm: float) -> Light:
    """The light in a scene's sea. Its indices are those that the scene gives, else those of Quan & Fry 1995,
    Appl. Opt. 34, 3477, eq. (3), of wavelength, salinity and temperature; the group index is n - nm dn/dnm."""
    s, t, nm = sea["salinity_psu"], sea["temperature_c"], wavelength_nm
    at_infinity = 1.31405 + (1.779e-4 - 1.05e-6 * t + 1.6e-8 * t * t) * s - 2.02e-6 * t * t
    first, second, third = (15.868 + 0.01155 * s - 0.00423 * t) / nm, -4382.0 / nm**2, 1.1455e6 / nm**3
    index = at_infinity + first + second + third
    group_index = index + first + 2 * second + 3 * third
    return Light(nm, sea.get("refractive_index", index), sea.get("group_index", group_index))
