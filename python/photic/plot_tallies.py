"""The rows of a result's quantities beside echoes."""

from functools import partial

import numpy

from photic import panels, tallies
from photic.page import Cell, rows
from photic.result import tallies as names_of

PANEL = 4.6  # width of each, on a page of free width
ABREAST = 2  # on such a page
HIGH = 4.4


def draw(sheet, result):
    """The rows: profiles over levels, then what escapes and what is absorbed, then maps."""
    names = names_of(result)
    levels, bars, fluences = [], [], []
    for dims in dict.fromkeys(result[name].dims for name in names):
        same = [name for name in names if result[name].dims == dims]
        if len(dims) == 1 and has_points(result, dims[0]):
            levels.append(_profiles(result, same, dims[0]))
        elif dims == ("direction", "radiance_level"):
            levels.append(_radiance(result, same[0]))
        elif dims == ("level", "zone"):
            levels += [_zones(result, name) for name in same]
        elif dims == ("escape_zenith",):
            bars.append(_by_angle(result, same[0]))
        elif dims == ("layer", "constituent"):
            bars.append(_absorbed(result, same[0]))
        elif len(dims) == 2:
            fluences += [_fluence(result, name) for name in same]
    return [row for cells in (levels, bars, fluences) if cells for row in rows(sheet, cells, HIGH, sharey=False)]


def balance(result):
    """A line on whether all light is there; empty if the result does not have it."""
    if "balance" not in result:
        return ""
    error = float(result.balance_standard_error)
    flag = "" if bool(result.balance_converged) else ", not converged"
    return f"Balance of where all light ends: {float(result.balance):.5f} ± {error:.1g} (standard error){flag}."


def has_points(result, dimension):
    return dimension + "_depth" in result.coords


def _titled(words):
    return words[:1].upper() + words[1:]


def _label(result, name):
    return result[name].attrs["long_name"]


def _profiles(result, names, dimension):
    every = [tallies.quantity(result, name) for name in names]
    lines = list(zip([_label(result, name) for name in names], panels.family(len(names)), every))
    title = "Irradiance" if names[0].startswith("irradiance") else _titled(_label(result, names[0]))
    draws = partial(tallies.profiles, lines, result[dimension + "_depth"].values)
    return Cell(title, PANEL, draws, tallies.profiles_legend(lines))


def _radiance(result, name):
    count = result.sizes["direction"]
    angles = zip(result.direction_zenith.values, result.direction_azimuth.values)
    words = [f"zenith {zenith:g}°, azimuth {azimuth:g}°" for zenith, azimuth in angles]
    every = [tallies.quantity(result, name, direction=k) for k in range(count)]
    lines = list(zip(words, panels.family(count), every))
    draws = partial(tallies.profiles, lines, result.radiance_level_depth.values)
    return Cell(_titled(_label(result, name)), PANEL, draws, tallies.profiles_legend(lines))


def _zones(result, name):
    edges = _edges(result, "zone")
    words = [f"zone {first:g}° to {last:g}°" for first, last in zip(edges, edges[1:])]
    every = [tallies.quantity(result, name, zone=k) for k in range(len(words))]
    lines = list(zip(words, panels.family(len(words)), every))
    draws = partial(tallies.profiles, lines, result.level_depth.values)
    return Cell(_titled(_label(result, name)), PANEL, draws, tallies.profiles_legend(lines))


def _by_angle(result, name):
    one = tallies.quantity(result, name)
    draws = partial(tallies.by_angle, one, _edges(result, "escape_zenith"))
    return Cell(_titled(_label(result, name)), PANEL, draws, tallies.open_legend([one]))


def _absorbed(result, name):
    one = tallies.quantity(result, name)
    constituents = [str(each) for each in result.constituent.values]
    colours = panels.family(len(constituents))
    draws = partial(tallies.absorbed, one, [str(each) for each in result.layer.values], colours)
    legend = tallies.absorbed_legend(one, constituents, colours)
    return Cell(_titled(_label(result, name)), PANEL, draws, legend)


def _fluence(result, name):
    one = tallies.quantity(result, name)
    down, across = result[name].dims
    label = tallies.name_of(result[across])
    draws = partial(tallies.fluence, one, _edges(result, down), _edges(result, across), label)
    title = name if name != "fluence" else _titled(_label(result, name))
    return Cell(title, PANEL, draws, tallies.fluence_legend(one))


def _edges(result, dimension):
    bounds = result[dimension + "_bounds"].values
    return numpy.concatenate([bounds[:, 0], bounds[-1:, 1]])
