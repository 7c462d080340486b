"""The panels of one result with many channels."""

from functools import partial

import numpy

from photic import maps, panels, plot_one, spectrum, views
from photic.choice import kept, through
from photic.maps import Columns
from photic.page import Cell, as_many_as_fit, page, rows, spread
from photic.panels import COLOURS

MOST_TELESCOPES = 2  # those that differ in view alone are one
MOST_SPECTRA = 3  # of a telescope: at some depths, by process, in the environments
MOST_DEPTHS = 4  # of spectra
FREE = 14.0  # width of a page
WIDE, LINES, MIDDLE = 6.6, 4.6, 4.0  # panels
HIGH, LOW, SMALL = 5.0, 4.0, 3.5
MARKERS = ["o", "^", "s", "D"]  # of telescopes, from the widest view on
NO_ROOM = "A wider figure has more spectra: by process, and in the environments if there are any."
NOTE = (
    "Of {} channels there are a map and spectra: --channel NAME, which may be repeated, draws single ones, "
    "with their orders of scattering, environments and sensitivities."
)


def draw(results, names, shown, width_mm):
    """The page, its rows, and notes of what has no place. For each telescope a map of depth and
    wavelength, beside it the channels that are no filters, and below spectra: at some depths, and of all
    gates as in figures of few channels. Telescopes that differ in view alone share all but the map, which
    is that of the widest view."""
    groups = views.grouped(results[0], shown.telescopes)
    filters = spectrum.filters(results[0], shown.channels)
    sheet = page(width_mm, FREE)
    fit = partial(_rows, sheet, results, shown, groups, filters)
    out, notes = as_many_as_fit(sheet, MOST_SPECTRA, fit)
    return sheet, out, [NOTE.format(len(shown.channels)), *notes]


def _rows(sheet, results, shown, groups, filters, most):
    """The rows with so many spectra of each telescope, and notes."""
    notes, out = [], []
    telescopes = MOST_TELESCOPES if most > 1 else 1
    for name in kept([group[0] for group in groups], telescopes, "telescope", notes):
        group = next(each for each in groups if each[0] == name)
        seen = {name: through(results, name, shown.channels)[0] for name in group}
        said = partial(shown.title, name)
        of_all = partial(shown.title_of, group)
        columns, others = _columns(seen[name], filters)
        cells = [_map(seen[name], columns, said)]
        if others:
            channels = kept(others, len(COLOURS), "channel", notes, "Lines are of")
            every = [view.sel(channel=channels) for view in seen.values()]
            cells.append(plot_one.echoes_of(seen, channels, of_all("Echo of the other channels"), LINES, every))
        out += rows(sheet, cells, HIGH if len(groups) == 1 else LOW)
        cells = [_at_depths(seen, columns, of_all)]
        if filters:
            cells += plot_one.spectra(seen[name], filters, said, MIDDLE)
        out += rows(sheet, cells[:most], LOW if len(groups) == 1 else SMALL, sharey=False)
    if filters:
        notes.append(spectrum.CAPTION if most > 1 else NO_ROOM)
    return out, notes


def _columns(view, filters):
    """The columns of the map, and the channels that are not among them: filters, if these are many, or all
    channels."""
    channels = [str(name) for name in view.channel.values]
    if filters:
        named = [each["name"] for each in filters]
        centres = numpy.array([each["centre_nm"] for each in filters])
        of_filters = Columns(named, centres, spectrum.widths(filters), "filter")
        return of_filters, [name for name in channels if name not in named]
    wavelength = view.channel_wavelength.values
    order = numpy.argsort(wavelength, kind="stable")
    return Columns([channels[k] for k in order], wavelength[order], None, "channel"), []


def _map(view, columns, said):
    drawn = partial(maps.depth_by_wavelength, view, columns)
    return Cell(said("Echo by depth and wavelength"), WIDE, drawn, maps.map_legend(view, columns))


def _at_depths(seen, columns, said):
    """The spectra of some gates, in each view."""
    widest = next(iter(seen.values()))
    gates = _gates(widest, columns)
    labels = [_label(widest, columns, gate) for gate in gates]
    lines = [
        (label, colour, columns.at(view, gate))
        for view in seen.values()
        for label, colour, gate in zip(labels, COLOURS, gates)
    ]
    title = said("Spectrum at one depth" if len(gates) == 1 else "Spectra at several depths")
    every = [one for *_, one in lines]
    axis = panels.axis_of(widest)
    if columns.width_nm is None:
        markers = [marker for marker in MARKERS[: len(seen)] for _ in gates]
        legend = maps.points_legend(lines, axis, list(zip(seen, MARKERS)) if len(seen) > 1 else [])
        return Cell(title, MIDDLE, partial(maps.points, lines, every, columns.unit, markers), legend)
    styles = [style for style in views.STYLES[: len(seen)] for _ in gates]
    legend = panels.spectra_legend(lines, axis, plot_one.styled(seen))
    return Cell(title, MIDDLE, partial(panels.spectra, lines, every, styles=styles), legend)


def _gates(view, columns):
    """From the first with light to the last, of those with an echo that has converged, if there are any.
    The first gate, if there is no light at all."""
    lit = columns.seen(view, "echo") > 0
    settled = (lit & columns.seen(view, "converged")).any(axis=1)
    there = numpy.flatnonzero(settled if settled.any() else lit.any(axis=1))
    return [int(there[k]) for k in spread(len(there), MOST_DEPTHS)] or [0]


def _label(view, columns, gate):
    """From where to where the gate reaches."""
    bounds = view.gate_depth_bounds.sel(channel=columns.names).isel(gate=gate).mean("channel")
    return " to ".join(f"{float(end):.3g}" for end in bounds)
