"""The spectrum that the filters of a result see."""

import math
from dataclasses import dataclass

import numpy
import xarray

from photic.panels import COLOURS
from photic.result import scene_of

# What a filter lets pass in all, over its full width at half maximum.
AREA = {"top-hat": 1.0, "gaussian": math.sqrt(math.pi / math.log(16))}
CAPTION = "Spectra are sums over the gates. So are their bands: an upper bound."


@dataclass(frozen=True)
class Spectrum:
    """Photons per photon emitted and nm, by wavelength; standard_error: not below the true one;
    settled: whether all gates that see light have converged."""

    wavelength: numpy.ndarray
    density: numpy.ndarray
    standard_error: numpy.ndarray
    settled: numpy.ndarray


def filters(result, channels):
    """The channels that are filters, by ascending wavelength; empty if these are so few that each has
    a colour of its own. The scene of a result says what a channel is."""
    by_name = {channel["name"]: channel for channel in scene_of(result).get("channel", [])}
    there = [name for name in channels if name in by_name and "centre_nm" in by_name[name]]
    there.sort(key=lambda name: by_name[name]["centre_nm"])
    return [by_name[name] for name in there] if len(there) > len(COLOURS) else []


def widths(found):
    """The integrated transmission of the filters found [nm]."""
    return numpy.array([each["fwhm_nm"] * AREA[each.get("filter", "top-hat")] for each in found])


def seen(view, found, echo="echo", converged="converged"):
    """The echo that one telescope sees through the filters found; echo, converged: names of variables with the
    dimensions channel and gate.

    A result holds no covariances of gates. Whatever these are, the error of a sum is not above the
    sum of the errors.
    """
    names = [each["name"] for each in found]
    width = xarray.DataArray(widths(found), dims="channel", coords={"channel": names})
    part = view.sel(channel=names)
    density, error = (
        (part[name].sum("gate", skipna=False) / width).values
        for name in (echo, echo + "_standard_error")
    )
    settled = (part[converged] | ~(part[echo] > 0)).all("gate").values
    return Spectrum(numpy.array([each["centre_nm"] for each in found]), density, error, settled)
