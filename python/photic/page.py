"""The page of a figure: a title, rows of panels with their legends below them, and a caption. All
sizes are in inches but those of letters, in points."""

import textwrap
from bisect import bisect_right
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cache, lru_cache, partial
from itertools import accumulate

import numpy
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

MM_PER_INCH = 25.4
POINTS_PER_INCH = 72
LETTER = 0.55  # width of a letter, over the size of its font
LINE = 1.3  # height of a line, over the size of its font
IN_A_COLUMN = 0.42  # sizes of panels, over those of a figure of free width
LONGEST_COLUMN = 9.4
MOST_NAMED = 24  # lines of one legend
BESIDE = 0.35  # a panel: numbers of its vertical axis, and margins
WITHOUT_AXIS = 0.3
BELOW_AND_ABOVE = 0.6  # a panel: its title, numbers and name of its horizontal axis
BAR = 0.6  # of colours: its height where long names stand below the panel, over that of the row


@dataclass(frozen=True)
class Page:
    """width: of the figure, exactly; longest: how high it may become; dpi: dots per inch of a .png;
    scale: of the panels' sizes; more: height of each row beyond that, for letters that are not scaled;
    the rest: sizes of letters."""

    width: float
    longest: float = 28.0
    dpi: int = 150
    scale: float = 1.0
    more: float = 0.0
    title: float = 14.0
    heading: float = 10.5
    label: float = 9.0
    ticks: float = 9.5
    legend: float = 8.5
    caption: float = 8.0


def page(width_mm, free_width):
    """A page for a column of a journal, with letters of 7 to 9 points; without width_mm of the width
    that the panels ask for."""
    if width_mm is None:
        return Page(free_width)
    letters = {"title": 9.0, "heading": 8.0, "label": 8.0}
    letters |= {"ticks": 7.0, "legend": 7.0, "caption": 7.0}
    sizes = {"longest": LONGEST_COLUMN, "scale": IN_A_COLUMN, "more": 0.3}
    return Page(width_mm / MM_PER_INCH, dpi=300, **sizes, **letters)


@dataclass(frozen=True, eq=False)
class Legend:
    handles: list
    title: str | None = None


@dataclass(frozen=True)
class Cell:
    """A panel: its title, its width beside others on a page of scale 1, what draws into it, and the
    legend that begins below it and may reach to where the next one does."""

    title: str
    width: float
    draw: Callable
    legend: Legend | None = None
    colour: str = "black"


@dataclass(frozen=True)
class Row:
    """Panels side by side that share their vertical axis, or not; columns: as if there were so many."""

    cells: list
    height: float
    columns: int
    sharey: bool = True

    def shares(self):
        widths = [cell.width for cell in self.cells]
        widths += widths[-1:] * (self.columns - len(widths))
        return [width / sum(widths) for width in widths]


def text(words):
    """Users' words as they stand: to matplotlib $ begins a formula, and a leading _ hides a line
    from the legend."""
    words = str(words).replace("$", r"\$")
    return f" {words}" if words.startswith("_") else words


def folded(words, width, size):
    """The words on lines that are no wider."""
    letters = max(8, int(width * POINTS_PER_INCH / (LETTER * size)))
    return "\n".join(textwrap.fill(line, letters) for line in str(words).split("\n"))


def spread(count, most):
    """Indices below count: all, or so many of them, evenly from the first to the last."""
    return numpy.unique(numpy.linspace(0, count - 1, min(count, most)).round().astype(int))


def columns(page, width):
    """The number of panels of that width that stand side by side."""
    return max(1, int(page.width / (page.scale * width) + 1e-6))


def rows(page, cells, height, sharey=True):
    """The cells on as many rows as they need. Equal ones stand in columns."""
    return [
        Row(part, page.scale * height + page.more + _more_title(page, part, across), across, sharey)
        for part, across in _lines(page, cells)
    ]


def _more_title(page, cells, columns):
    """The height of titles beyond their first line."""
    width = page.width / columns - BESIDE
    lines = max(folded(cell.title, width, page.heading).count("\n") for cell in cells)
    return LINE * page.heading / POINTS_PER_INCH * lines if page.more else 0.0


def _lines(page, cells):
    """The cells of each row, and how many would have room."""
    if len({cell.width for cell in cells}) == 1:
        lines = -(-len(cells) // columns(page, cells[0].width))
        across = -(-len(cells) // lines)
        parts = [cells[k : k + across] for k in range(0, len(cells), across)]
        return [(part, across) for part in parts]
    parts, left = [], 0.0
    for cell in cells:
        if not parts or page.scale * cell.width > left + 1e-6:
            parts.append([])
            left = page.width
        parts[-1].append(cell)
        left -= page.scale * cell.width
    return [(part, len(part)) for part in parts]


def as_many_as_fit(page, most, draw):
    """Returns the drawing of the largest number, up to most, whose rows are not too high, or of 1. draw
    gives rows, and notes of what has no place."""
    for count in range(most, 0, -1):
        rows, notes = draw(count)
        so_far = accumulate(height for row in rows for height in _heights(page, row))
        if all(height <= page.longest for height in so_far):
            break
    return rows, notes


def _heights(page, row):
    """The heights of the panels, and of the legends if there are any."""
    strip = _strip(page, row)
    return [row.height] + ([max(height for *_, height in strip)] if strip else [])


def with_legend(rows, legend):
    """The rows with a legend of them all below the last."""
    first, *others = rows[-1].cells
    return [*rows[:-1], replace(rows[-1], cells=[replace(first, legend=legend), *others])]


def build(page, rows, title, caption):
    """The figure."""
    title = folded(title, page.width - 0.2, page.title)
    caption = folded(caption, page.width - 0.2, page.caption)
    heights, draws = [], []
    for row in rows:
        own = _heights(page, row)
        heights += own
        draws += [partial(_draw_panels, page, row), partial(_draw_legends, page, row)][: len(own)]
    # constrained_layout keeps room for both.
    around = _height(title, page.title) + _height(caption, page.caption)
    size = (page.width, sum(heights) + around)
    drawing = Figure(figsize=size, dpi=page.dpi, layout="constrained")
    parts = drawing.subfigures(len(heights), 1, height_ratios=heights, squeeze=False)[:, 0]
    for part, draw in zip(parts, draws):
        draw(part)
    at_the_left = {"x": 0.08 / page.width, "ha": "left"}
    if title:
        look = {"fontsize": page.title, "fontweight": "bold", **at_the_left}
        drawing.suptitle(text(title), **look)
    drawing.supxlabel(text(caption), fontsize=page.caption, color="0.3", **at_the_left)
    return drawing


def _height(words, size):
    return LINE * size / POINTS_PER_INCH * len(words.split("\n")) + 0.1 if words else 0.0


def _draw_panels(page, row, part):
    shape = {"sharey": row.sharey, "squeeze": False, "width_ratios": row.shares()}
    panels = part.subplots(1, row.columns, **shape)[0]
    for panel in panels[len(row.cells) :]:
        panel.remove()
    for panel, cell, share in zip(panels, row.cells, row.shares()):
        cell.draw(panel)
        label_text = panel.get_ylabel() if panel is panels[0] or not row.sharey else ""
        label_text = folded(label_text, row.height - BELOW_AND_ABOVE, page.label)
        panel.set_ylabel(label_text, fontsize=page.label)
        beside = BESIDE + _height(label_text, page.label) if label_text else WITHOUT_AXIS
        width = share * page.width - beside
        look = {"fontsize": page.heading, "loc": "left", "color": cell.colour}
        panel.set_title(text(folded(cell.title, width, page.heading)), **look)
        across = folded(panel.get_xlabel(), share * page.width - WITHOUT_AXIS, page.label)
        panel.set_xlabel(across, fontsize=page.label)
        panel.tick_params(which="both", labelsize=page.ticks)
        for words in panel.texts:
            words.set_fontsize(page.label)
    for bar in [each for each in part.axes if each not in panels]:  # of colours
        bar.tick_params(which="both", labelsize=page.ticks)
        bar.set_ylabel(folded(bar.get_ylabel(), BAR * row.height, page.label), fontsize=page.label)


def _strip(page, row):
    """The legends of a row: each with where it begins, how its lines are called, in how many columns
    they stand, and its height."""
    begins = numpy.concatenate([[0.0], numpy.cumsum(row.shares())])
    own = [k for k, cell in enumerate(row.cells) if cell.legend and cell.legend.handles]
    strip = []
    for k, following in zip(own, own[1:] + [row.columns]):
        legend, width = row.cells[k].legend, (begins[following] - begins[k]) * page.width - 0.1
        names = [handle.get_label() for handle in legend.handles]
        names = tuple(text(folded(name, width - 0.6, page.legend)) for name in names)
        begin = begins[k] + 0.06 / page.width
        strip.append((begin, legend, names, *_fit(page, legend, names, width)))
    return strip


@lru_cache(maxsize=256)  # measured for the choice of rows, for their heights, and to draw them
def _fit(page, legend, names, width):
    """As many columns as have room in the width, and the height that they then take."""
    part = Figure(dpi=100)
    renderer = FigureCanvasAgg(part).get_renderer()

    @cache
    def size(count):
        box = _legend(page, part, legend, names, count, 0.0).get_window_extent(renderer)
        return box.width / 100, box.height / 100

    room = len(names)
    if size(room)[0] > width:
        room = max(1, bisect_right(range(1, room), width, key=lambda count: size(count)[0]))
    return room, size(room)[1] + 0.08


def _legend(page, part, legend, names, count, begin):
    size = {"fontsize": page.legend, "title_fontsize": page.legend, "alignment": "left"}
    place = {"loc": "upper left", "bbox_to_anchor": (begin, 1.0), "borderaxespad": 0}
    look = {"frameon": False, "borderpad": 0.2, "columnspacing": 1.4, **size, **place}
    return part.legend(legend.handles, names, title=legend.title, ncols=count, **look)


def _draw_legends(page, row, part):
    for begin, legend, names, count, _ in _strip(page, row):
        _legend(page, part, legend, names, count, begin)
