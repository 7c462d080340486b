"""The panels of several results."""

from functools import partial

from photic import panels, spectrum
from photic.choice import kept, through
from photic.page import Cell, as_many_as_fit, page, rows
from photic.panels import COLOURS

MOST_ROWS = 6  # of a telescope
WIDE, HIGH = 6.6, 4.6
WIDEST = 16.5


def draw(results, names, shown, width_mm):
    """The page, its rows, and notes of what does not fit: for each telescope the spectra, if many
    filters see one, and a row for each channel with the echoes on the same axes, and beside them the
    orders of each result."""
    count = len(results)
    slim = max(1.6, 3.0 - 0.3 * count)  # the orders of one result
    sheet = page(width_mm, min(WIDE + slim * count, WIDEST))
    colours = COLOURS[:count] if count <= len(COLOURS) else panels.family(count)
    fit = partial(_rows, sheet, results, list(zip(names, colours)), shown, slim)
    return sheet, *as_many_as_fit(sheet, MOST_ROWS, fit)


def _rows(sheet, results, looks, shown, slim, most):
    """looks: what to call each result, and its colour; most: channels of a telescope."""
    notes, out = [], []
    channels = kept(shown.channels, most, "channel", notes)
    for telescope in shown.telescopes:
        spectra = _spectra(sheet, results, looks, shown, telescope)
        if spectra and spectrum.CAPTION not in notes:
            notes.append(spectrum.CAPTION)
        out += spectra
        seen = through(results, telescope, channels)
        for channel in channels:
            of_all = [
                (one, *look)
                for one, look in zip(seen, looks)
                if one is not None and channel in one.channel.values
            ]
            if of_all:
                said = partial(shown.title, telescope)
                out += rows(sheet, _cells(of_all, channel, slim, said), HIGH)
    return out, notes


def _spectra(sheet, results, looks, shown, telescope):
    """A row of the spectra on the same axes; none if no result has one."""
    lines = []
    for one, look in zip(through(results, telescope, shown.channels), looks):
        filters = [] if one is None else spectrum.filters(one, list(one.channel.values))
        if filters:
            lines.append((*look, spectrum.seen(one, filters)))
    if not lines:
        return []
    draws = partial(panels.spectra, lines, [one for *_, one in lines])
    cell = Cell(shown.title(telescope, "Spectrum"), WIDE, draws, panels.spectra_legend(lines))
    return rows(sheet, [cell], HIGH)


def _cells(of_all, channel, slim, said):
    """of_all: results, their names and colours."""
    every = [one for one, _, _ in of_all]
    parts = [one.sel(channel=channel) for one in every]
    colours = [colour for _, _, colour in of_all]
    faded = any(panels.unsettled(part.echo, part.converged) for part in parts)
    legend = panels.lines_legend([(name, colour) for _, name, colour in of_all], faded)
    echoes = partial(_echoes, every, parts, colours)
    cells = [Cell(said(f"{channel} echo"), WIDE, echoes, legend)]
    orders = max(int(one.order[-1]) for one in every)
    for part, (_, name, colour) in zip(parts, of_all):
        last = int(part.order[-1])
        title = f"{name} by order" + ("" if last == orders else f" ({last} includes all above)")
        legend = panels.orders_legend(parts) if len(cells) == 1 else None
        draws = partial(_orders, every, part, orders)
        cells.append(Cell(title, slim, draws, legend, colour))
    return cells


def _echoes(every, parts, colours, panel):
    for part, colour in zip(parts, colours):
        panels.line(panel, part, part.echo, part.echo_standard_error, colour)
    panels.finish_lines(panel, [part.echo for part in parts])
    panels.finish_depth(panel, every)


def _orders(every, part, count, panel):
    panels.orders(panel, part, count)
    panels.finish_depth(panel, every)
