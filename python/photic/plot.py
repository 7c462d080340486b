"""Drawing results: echo against depth, and quantities beside echoes, on a figure of matplotlib."""

from photic import plot_many, plot_one, plot_several, plot_tallies
from photic.choice import drawn
from photic.errors import Error
from photic.page import build, page
from photic.panels import COLOURS
from photic.result import has_echoes, tallies
from photic.sources import caution

BARS = "Bars of tallies: 95 % intervals."


def figure(results, names, telescopes=(), channels=(), title=None, width_mm=None):
    """For one result: each telescope's echoes by channel, by process, by order; if there are
    environments, below these a row for each channel with the echo in every one and what it changes; if
    there are sensitivities, below all a panel of them for each channel. Several: a row for each
    telescope and channel, with the echoes overlaid, and beside them each result by order. Results of
    one telescope each are drawn on the same axes whatever its name is. On top is the spectrum,
    where more filters see it than have colours of their own. One result with more channels than these,
    of which none is chosen, has a map of depth and wavelength and spectra in the place of all else. Below
    all, or without echoes alone, one result has its quantities beside echoes.

    results   datasets of photic.open; names: a name for each of them
    telescopes, channels  by name; default: all, as far as a page holds them
    width_mm  of the figure; default: what the panels ask for

    Raises photic.Error for names that are not there, and for results without anything to draw.
    """
    if len(results) == 1 and not has_echoes(results[0]):
        _expect_all(names[0], telescopes, channels)
        return _of_tallies(results[0], title, width_mm)
    for result, name in zip(results, names):
        if not has_echoes(result):
            raise Error(f"{name}: holds no echoes, by which results are compared: draw it alone")
        if 0 in (result.sizes[axis] for axis in ("telescope", "channel", "gate")):
            raise Error(f"{name}: holds no echoes: there is nothing to draw")
    notes = []
    shown = drawn(results, names, telescopes, channels, notes)
    many = len(shown.channels) > len(COLOURS) and not channels
    alone = plot_many.draw if many else plot_one.draw
    draw = alone if len(results) == 1 else plot_several.draw
    sheet, rows, more = draw(results, names, shown, width_mm)
    rows += plot_tallies.draw(sheet, results[0]) if len(results) == 1 else []
    captions = [about_run(result, shown) for result in results]
    if len(results) > 1:
        captions = [
            f"{name}: {caption}{_left_out(result)}"
            for name, caption, result in zip(names, captions, results)
        ]
    cautions = dict.fromkeys(filter(None, map(caution, results)))
    titles = {result.attrs["title"] for result in results}
    title = title or (titles.pop() if len(titles) == 1 else "")
    caption = [*captions, *notes, *more, *cautions, _bands(results)]
    return build(sheet, rows, title, "\n".join(caption))


def _expect_all(name, telescopes, channels):
    for option, given in (("telescope", telescopes), ("channel", channels)):
        if given:
            raise Error(f"{name}: holds no echoes, and no {option}s (leave out --{option})")


def _of_tallies(result, title, width_mm):
    """The figure of a result without echoes."""
    sheet = page(width_mm, plot_tallies.ABREAST * plot_tallies.PANEL)
    caption = [about_run(result), plot_tallies.balance(result), BARS]
    drawn_rows = plot_tallies.draw(sheet, result)
    return build(sheet, drawn_rows, title or result.attrs["title"], "\n".join(filter(None, caption)))


def _bands(results):
    bands = "Bands: 95 % intervals, the lower end not below a tenth of the echo."
    if len(results) == 1 and "environment" in results[0].sizes:
        bands += " Of changes: those of differences between the same photons."
    if len(results) == 1 and tallies(results[0]):
        bands += "\n" + "\n".join(filter(None, [plot_tallies.balance(results[0]), BARS]))
    return bands


def about_run(result, shown=None):
    """A line on the run, and the telescope if one alone is shown."""
    run = result.attrs
    photons = f"{int(run['photons']):,}".replace(",", "\u2009")
    parts = [f"Photic {run['version']}", f"{photons} photons", f"seed {run['seed']}"]
    if run["partial"]:
        parts.append("partial: interrupted")
    if shown is None:
        return ", ".join(parts)
    names = [str(name) for name in result.telescope.values]
    of_it = [name for name in shown.telescopes if name in names] or names[:1]
    if len(of_it) == 1 and (len(names) > 1 or shown.telescopes == [None]):
        parts.append(f"telescope {of_it[0]}")
    return ", ".join(parts)


def _left_out(result):
    """The parts that a figure of several results does not show."""
    more = {"environment": "environments", "parameter": "sensitivities"}
    there = [word for axis, word in more.items() if axis in result.sizes]
    there = " and ".join(there + ["tallies"] * bool(tallies(result)))
    return f"; its {there} are drawn only where it is drawn alone" if there else ""
