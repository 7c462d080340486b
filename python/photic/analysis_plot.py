"""Figures of `photic analyse`: numbers against depth with error bars, by telescope, and straight lines."""

from dataclasses import replace
from functools import partial

import numpy
from matplotlib.lines import Line2D

from photic import panels
from photic.choice import MOST_TELESCOPES, kept
from photic.columns import with_error, with_unit
from photic.page import MOST_NAMED, Cell, Legend, build, page, rows, spread
from photic.plot import about_run
from photic.sources import caution

PANEL, HIGH = 5.6, 4.6  # of each, on a page of free width
ABREAST = {"profiles": 2, "line": 3}
BARS = "Bars: 95 % intervals. Open circles: not reliable."
DECADES = 100  # the ratio of numbers from which on an axis is logarithmic
APART = 10  # of places
SIZE = 4  # of markers
SHIFT = 0.5  # of the numbers of telescopes beside each other, all together


def figure(found, title, subject):
    """The figure of an analysis; subject: the result, or the scene, that it is of."""
    notes = []
    blocks = {block.telescope: block for block in found.blocks}
    shown = [blocks[name] for name in kept(list(blocks), MOST_TELESCOPES, "telescope", notes)]
    if not shown[0].columns:
        cells, abreast = [_by_telescope(shown)], 1
    elif shown[0].environments:
        cells = [cell for block in shown for cell in _of_line(block)]
        abreast = ABREAST["line"]
    else:
        cells = [_profiles(block, _titled(block, shown, block.columns[0].meaning)) for block in shown]
        abreast = min(len(cells), ABREAST["profiles"])
    sheet = page(None, abreast * PANEL)
    has_errors = any(column.errors is not None for block in shown for column in (*block.columns, *block.numbers))
    run = [about_run(subject), caution(subject)] if hasattr(subject, "attrs") else []
    caption = [*run, *notes, *found.notes, BARS if has_errors else ""]
    return build(sheet, rows(sheet, cells, HIGH, sharey=False), title, "\n".join(filter(None, caption)))


def _titled(block, shown, words):
    return f"{block.telescope}: {words}" if len(shown) > 1 else words


def _profiles(block, title):
    colours = panels.family(len(block.columns))
    return Cell(title, PANEL, partial(_draw_profiles, block, colours), _legend(block.columns, block.numbers, colours))


def _draw_profiles(block, colours, panel):
    values = numpy.concatenate([column.values[_trusted(column)] for column in block.columns])
    positive = values[values > 0]
    logarithmic = len(positive) > 0 and len(positive) == len(values) and positive.max() > DECADES * positive.min()
    for column, colour in zip(block.columns, colours):
        _bars(panel, column.values, block.places, column, colour, logarithmic)
    fits = [number for number in block.numbers if number.span]
    for number, colour in zip(fits, colours):
        _fit(panel, number, colour)
    _across(panel, block.columns, logarithmic)
    panel.set_xlabel(with_unit(block.columns[0].quantity.replace("_", " "), block.columns[0].units))
    panels.name_depth(panel, min(block.places), max(block.places), block.place, margin=_margin(block.places))
    panels.grid(panel)


def _margin(places):
    return 0.5 * abs(numpy.diff(places)).mean() if len(places) > 1 else 1.0


def _flags(column):
    return numpy.ones(numpy.shape(column.values), bool) if column.reliable is None else numpy.asarray(column.reliable)


def _trusted(column):
    """The numbers that an axis is chosen by: reliable ones and those of small errors, or all that are known if there
    are none of these."""
    known = numpy.isfinite(column.values)
    if column.errors is None:
        return known
    good = known & (_flags(column) | (column.errors < panels.NARROW * abs(column.values)))
    return good if good.any() else known


def _bars(panel, values, places, column, colour, logarithmic=False, upright=True):
    """Circles with bars, open ones where they are not reliable. upright: against places that go down, and joined by a
    thin line."""
    values = numpy.where(values > 0, values, numpy.nan) if logarithmic else values
    if upright:
        panel.plot(values, places, color=colour, linewidth=0.8, alpha=panels.FADED)
    bars = None if column.errors is None else _ends(values, panels.INTERVAL_95 * column.errors, logarithmic)
    for chosen, face in ((_flags(column), colour), (~_flags(column), "white")):
        of_chosen = None if bars is None else {"xerr" if upright else "yerr": bars[:, chosen]}
        look = {"fmt": "o", "color": colour, "markerfacecolor": face, "markersize": SIZE, "elinewidth": 1.1, "capsize": 2}
        panel.errorbar(*_turned(values[chosen], numpy.asarray(places)[chosen], upright), **(of_chosen or {}), **look)


def _turned(values, places, upright):
    return (values, places) if upright else (places, values)


def _ends(values, half_width, logarithmic):
    """The reach of bars to both sides; none where the error is not known."""
    half_width = numpy.where(numpy.isfinite(half_width), half_width, 0.0)
    lower = values - panels.band_ends(values, half_width)[0] if logarithmic else half_width
    return numpy.nan_to_num(numpy.array([lower, half_width]))


def _across(panel, columns, logarithmic):
    """The horizontal axis: what can be relied on lies on it, with its bars."""
    ends = []
    for column in columns:
        trusted = _trusted(column)
        width = numpy.zeros(trusted.sum()) if column.errors is None else panels.INTERVAL_95 * column.errors[trusted]
        width = numpy.where(numpy.isfinite(width), width, 0.0)
        ends += [column.values[trusted] - width, column.values[trusted] + width] if not logarithmic else [column.values[trusted]]
    ends = numpy.concatenate(ends)
    if logarithmic:
        panel.set_xscale("log")
        panel.set_xlim(panels.limits([ends]))
    elif len(ends) > 0:
        margin = 0.06 * numpy.ptp(ends) or 0.1 * abs(ends[0]) or 1.0
        panel.set_xlim(ends.min() - margin, ends.max() + margin)
    else:
        panels.say(panel, "no number is known")


def _fit(panel, number, colour):
    """A fitted number over the places that it is of."""
    half_width = panels.INTERVAL_95 * float(number.errors)
    panel.fill_betweenx(number.span, number.values - half_width, number.values + half_width, color=colour, alpha=panels.BAND, linewidth=0)
    panel.plot([number.values] * 2, number.span, color=colour, linestyle="--", linewidth=1.2)


def _legend(columns, numbers, colours):
    """Names of the columns, and of the numbers that are drawn beside them."""
    handles = [Line2D([], [], color=colours[k], marker="o", markersize=SIZE, label=columns[k].label) for k in spread(len(columns), MOST_NAMED)]
    for k, number in enumerate(number for number in numbers if number.span):
        words = with_unit(f"fitted: {with_error(float(number.values), float(number.errors), 5)}", number.units)
        words += "" if number.reliable else ", not reliable"
        handles.append(Line2D([], [], color=colours[k], linestyle="--", label=words))
    return Legend(handles)


def _by_telescope(blocks):
    count = len(blocks[0].numbers)
    colours = panels.family(count)
    words = blocks[0].numbers[0].meaning
    labels = [blocks[0].numbers[k].environment for k in range(count)]
    handles = [Line2D([], [], color=colours[k], marker="o", linestyle="none", markersize=SIZE, label=labels[k]) for k in spread(count, MOST_NAMED)]
    return Cell(words, PANEL, partial(_draw_by_telescope, blocks, colours), Legend(handles) if count > 1 else None)


def _draw_by_telescope(blocks, colours, panel):
    shifts = numpy.linspace(-SHIFT / 2, SHIFT / 2, len(colours)) if len(colours) > 1 else [0.0]
    for at, block in enumerate(blocks):
        for number, colour, shift in zip(block.numbers, colours, shifts):
            face = colour if number.reliable else "white"
            error = panels.INTERVAL_95 * float(number.errors)
            look = {"fmt": "o", "color": colour, "markerfacecolor": face, "markersize": 6, "elinewidth": 1.2, "capsize": 3}
            panel.errorbar([at + shift], [float(number.values)], yerr=[error] if numpy.isfinite(error) else None, **look)
    panel.set_xticks(range(len(blocks)), [block.telescope for block in blocks])
    panel.set_xlim(-0.6, len(blocks) - 0.4)
    low, high = panel.get_ylim()
    panel.set_ylim(high, low)
    panel.set_xlabel("telescope")
    panel.set_ylabel(with_unit("depth", blocks[0].numbers[0].units))
    panels.grid(panel)


def _of_line(block):
    """The line, what it leaves, and the numbers over their places where these are above 0."""
    value, residual = block.columns
    name = value.label
    numbers = {number.quantity: number for number in block.numbers}
    fit = Line2D([], [], color="black", linewidth=1.2, label=_equation(numbers))
    cells = [
        Cell(f"{block.telescope}: {name}", PANEL, partial(_draw_line, block, value, numbers), Legend([fit])),
        Cell("less the line", PANEL, partial(_draw_residuals, block, value, residual)),
    ]
    if all(place > 0 for place in block.places):
        cells.append(Cell(f"over {block.place}", PANEL, partial(_draw_quotients, block, value)))
    return cells


def _equation(numbers):
    def of(name):
        number = numbers[name]
        return with_error(float(number.values), float(number.errors), 4)

    chi_squared, free = (float(numbers[name].values) for name in ("chi_squared", "degrees_of_freedom"))
    tested = f", χ² {chi_squared:.3g} of {free:g}" if numpy.isfinite(chi_squared) else ""
    return f"({of('offset')}) + ({of('slope')}) x, r² {float(numbers['r_squared'].values):.4f}{tested}"


def _draw_line(block, value, numbers, panel):
    _bars(panel, value.values, block.places, value, panels.COLOURS[0], upright=False)
    ends = numpy.array([block.places.min(), block.places.max()])
    panel.plot(ends, float(numbers["offset"].values) + float(numbers["slope"].values) * ends, color="black", linewidth=1.2)
    _finish_line(panel, block, with_unit(value.label, value.units))


def _draw_residuals(block, value, residual, panel):
    panel.axhline(0, color="black", linewidth=1.2)
    _bars(panel, residual.values, block.places, value, panels.COLOURS[0], upright=False)
    _finish_line(panel, block, with_unit("residual", value.units))


def _draw_quotients(block, value, panel):
    over = block.places
    quotient = replace(value, values=value.values / over, errors=value.errors / over)
    _bars(panel, quotient.values, over, quotient, panels.COLOURS[0], upright=False)
    if over.max() >= APART * over.min():
        panel.set_xscale("log")
        panels.name_decades(panel.xaxis, over.min(), over.max())
    panel.set_ylim(0, 1.1 * (quotient.values + panels.INTERVAL_95 * quotient.errors).max())
    _finish_line(panel, block, f"{with_unit(value.label, value.units)} / {block.place}")


def _finish_line(panel, block, label):
    panel.set_xlabel(block.place)
    panel.set_ylabel(label)
    panels.grid(panel)
