"""Drawing results: echo against depth, on a figure of matplotlib."""

from photic import plot_many, plot_one, plot_several
from photic.choice import drawn
from photic.errors import Error
from photic.page import build
from photic.panels import COLOURS
from photic.sources import caution


def figure(results, names, telescopes=(), channels=(), title=None, width_mm=None):
    """For one result: each telescope's echoes by channel, by process, by order; if there are
    environments, below these a row for each channel with the echo in every one and what it changes; if
    there are sensitivities, below all a panel of them for each channel. Several: a row for each
    telescope and channel, with the echoes overlaid, and beside them each result by order. Results of
    one telescope each are drawn on the same axes whatever its name is. On top is the spectrum,
    where more filters see it than have colours of their own. One result with more channels than these,
    of which none is chosen, has a map of depth and wavelength and spectra in the place of all else.

    results   datasets of photic.open; names: a name for each of them
    telescopes, channels  by name; default: all, as far as a page holds them
    width_mm  of the figure; default: what the panels ask for

    Raises photic.Error for names that are not there, and for results without echoes.
    """
    for result, name in zip(results, names):
        if 0 in (result.sizes[axis] for axis in ("telescope", "channel", "gate")):
            raise Error(f"{name}: holds no echoes: there is nothing to draw")
    notes = []
    shown = drawn(results, names, telescopes, channels, notes)
    many = len(shown.channels) > len(COLOURS) and not channels
    alone = plot_many.draw if many else plot_one.draw
    draw = alone if len(results) == 1 else plot_several.draw
    sheet, rows, more = draw(results, names, shown, width_mm)
    captions = [_caption(result, shown) for result in results]
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


def _bands(results):
    bands = "Bands: 95 % intervals, the lower end not below a tenth of the echo."
    if len(results) == 1 and "environment" in results[0].sizes:
        bands += " Of changes: those of differences between the same photons."
    return bands


def _caption(result, shown):
    run = result.attrs
    photons = f"{int(run['photons']):,}".replace(",", "\u2009")
    parts = [f"Photic {run['version']}", f"{photons} photons", f"seed {run['seed']}"]
    if run["partial"]:
        parts.append("partial: interrupted")
    names = [str(name) for name in result.telescope.values]
    of_it = [name for name in shown.telescopes if name in names] or names[:1]
    if len(of_it) == 1 and (len(names) > 1 or shown.telescopes == [None]):
        parts.append(f"telescope {of_it[0]}")
    return ", ".join(parts)


def _left_out(result):
    """The parts that a figure of several results does not show."""
    more = {"environment": "environments", "parameter": "sensitivities"}
    there = " and ".join(word for axis, word in more.items() if axis in result.sizes)
    return f"; its {there} are drawn only where it is drawn alone" if there else ""
