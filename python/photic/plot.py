"""Drawing results: echo against depth, on a figure of matplotlib."""

import itertools
import textwrap

from matplotlib.figure import Figure

from photic import panels
from photic.errors import Error

# Okabe & Ito (2008), "Color Universal Design": told apart by the colour-blind too.
# Green comes first, for 532 nm.
COLOURS = ["#009E73", "#D55E00", "#0072B2", "#CC79A7", "#E69F00", "#56B4E9", "#000000"]
LETTERS_PER_INCH = 11  # of a panel's title
LOOK = {"dpi": 150, "layout": "constrained"}


def figure(results, names, telescope=None, title=None):
    """One result: its echoes by channel, by process, by order; if there are environments, below
    these a row for each channel with the echo in every one and what it changes; if there are
    sensitivities, below all a panel of them for each channel. Several: a row for each channel, with
    the echoes overlaid, and beside them each result by order.

    results    datasets of photic.open; names: what to call each of them
    telescope  by name; default: the first of each
    """
    seen = [_through(result, name, telescope) for result, name in zip(results, names)]
    captions = [_caption(result, str(one.telescope.values)) for result, one in zip(results, seen)]
    if len(seen) == 1:
        drawing = _one(seen[0])
    else:
        drawing = _several(seen, names)
        captions = [f"{name}: {caption}" for name, caption in zip(names, captions)]
        for k, result in enumerate(seen):
            captions[k] += _left_out(result)
    titles = {result.attrs["title"] for result in seen}
    title = title or (titles.pop() if len(titles) == 1 else "")
    if title:
        drawing.suptitle(panels.text(title), x=0.01, ha="left", fontsize=14, fontweight="bold")
    captions.append("Bands: 95 % intervals, the lower end not below a tenth of the echo.")
    if len(seen) == 1 and "environment" in seen[0].sizes:
        captions[-1] += " Against the scene's: those of differences between the same photons."
    caption = panels.text("\n".join(captions))
    drawing.supxlabel(caption, x=0.01, ha="left", fontsize=8, color="0.3")
    return drawing


def _through(result, name, telescope):
    known = [str(each) for each in result.telescope.values]
    if telescope is not None and telescope not in known:
        raise Error(f"{name}: there is no telescope {telescope!r}; there are: {', '.join(known)}")
    one = result.isel(telescope=0 if telescope is None else known.index(telescope))
    return _by_time(one) if one.gate_depth.isnull().all() else one


def _by_time(result):
    """The gates of a telescope that has neither depths nor ranges, placed by their time."""
    for name in ("gate_depth", "gate_depth_bounds"):
        times = result[name.replace("depth", "time")].broadcast_like(result[name])
        times = times.transpose(*result[name].dims)
        result = result.assign_coords({name: (times.dims, times.values, {"units": "ns"})})
    return result


def _caption(result, telescope):
    run = result.attrs
    photons = f"{int(run['photons']):,}".replace(",", "\u2009")
    parts = [f"Photic {run['version']}", f"{photons} photons", f"seed {run['seed']}"]
    if run["partial"]:
        parts.append("partial: interrupted")
    if result.sizes["telescope"] > 1:
        parts.append(f"telescope {telescope}")
    return ", ".join(parts)


def _left_out(result):
    """What of a result a figure of several does not show."""
    more = {"environment": "environments", "parameter": "sensitivities"}
    there = " and ".join(word for axis, word in more.items() if axis in result.sizes)
    return f"; its {there} are not drawn here, but where it is drawn alone" if there else ""


def _one(result):
    """Echoes by channel with their breakdowns, and below, if there are any, environments and
    sensitivities."""
    mixed, by_order = _broken_down(result)
    width = 6.6 + 3.3 * (len(mixed) + len(by_order))
    rows = [(6.6, lambda part: _breakdowns(part, result, mixed, by_order))]
    if "environment" in result.sizes:
        rows.append((4.6 * result.sizes["channel"], lambda part: _environments(part, result)))
    if "parameter" in result.sizes:
        rows.append((4.6, lambda part: _sensitivities(part, result)))
    heights = [height for height, _ in rows]
    drawing = Figure(figsize=(width, sum(heights)), **LOOK)
    parts = [drawing]
    if len(rows) > 1:
        parts = drawing.subfigures(len(rows), 1, height_ratios=heights)
    for part, (_, draw) in zip(parts, rows):
        draw(part)
    return drawing


def _broken_down(result):
    """By process the first channel that is fed by several, by order the first channels."""
    channels = [str(channel) for channel in result.channel.values]
    feeding = (result.echo_by_process > 0).any("gate").sum("process")
    mixed = [channel for channel in channels if feeding.sel(channel=channel) > 1][:1]
    return mixed, channels[: 2 - len(mixed)]


def _environments(drawing, result):
    """A row for each channel: the echo in every environment, and beside it what they change."""
    channels = [str(channel) for channel in result.channel.values]
    colours = panels.family(COLOURS, result.sizes["environment"])
    grid = drawing.subplots(len(channels), 2, sharey=True, squeeze=False)
    for (echo, change), channel in zip(grid, channels):
        part = result.sel(channel=channel)
        panels.environments(echo, part, colours, f"{channel} echo in the environments")
        panels.changes(change, part, colours, f"{channel} echo against the scene's")
        panels.finish_depth(echo, [result])
    panels.environments_legend(grid[0, 1], result, colours)


def _sensitivities(drawing, result):
    """A panel for each channel: the logarithmic sensitivities of its echo."""
    channels = [str(channel) for channel in result.channel.values]
    colours = panels.family(COLOURS, result.sizes["parameter"])
    row = drawing.subplots(1, len(channels), sharey=True, squeeze=False)[0]
    for panel, channel in zip(row, channels):
        part = result.sel(channel=channel)
        panels.sensitivities(panel, part, colours, f"{channel} echo: sensitivities")
    panels.finish_depth(row[0], [result])
    panels.sensitivities_legend(row[-1], result, colours)


def _breakdowns(drawing, result, mixed, by_order):
    """Echoes by channel, and beside them those by process and by order of the channels given."""
    channels = [str(channel) for channel in result.channel.values]
    beside = len(mixed) + len(by_order)
    ratios = [1.5] + [1] * beside
    row = drawing.subplots(1, 1 + beside, sharey=True, squeeze=False, width_ratios=ratios)[0]
    for channel, colour in zip(channels, itertools.cycle(COLOURS)):
        part = result.sel(channel=channel)
        label = f"{channel} ({float(part.channel_wavelength):.4g} nm)"
        panels.line(row[0], part, part.echo, part.echo_standard_error, colour, label)
    title = "Echo by channel" if mixed else "Echo by channel (one process each)"
    panels.finish_lines(row[0], [(result.echo, result.converged)], title)
    for panel, channel in zip(row[1:], mixed):
        part = result.sel(channel=channel)
        panels.processes(panel, part, itertools.cycle(COLOURS), f"{channel} echo by process")
    for panel, channel in zip(row[1 + len(mixed) :], by_order):
        title = f"{channel} echo by order of scattering"
        panels.orders(panel, result.sel(channel=channel), title, result.sizes["order"])
    panels.orders_legend(row[-1], [result])
    panels.finish_depth(row[0], [result])


def _several(results, names):
    """A row for each channel that any of the results has: the echoes over each other, and beside them
    the orders of each result."""
    every = (str(channel) for result in results for channel in result.channel.values)
    channels = list(dict.fromkeys(every))
    orders = max(result.sizes["order"] for result in results)
    width = max(1.6, 3.0 - 0.3 * len(results))  # of the orders of one result
    size = (6.6 + width * len(results), 1.4 + 4.6 * len(channels))
    drawing = Figure(figsize=size, **LOOK)
    ratios = [5.0] + [width] * len(results)
    shape = (len(channels), 1 + len(results))
    grid = drawing.subplots(*shape, sharey=True, squeeze=False, width_ratios=ratios)
    for row, channel in zip(grid, channels):
        shown = []
        for result, name, colour, beside in zip(
            results, names, itertools.cycle(COLOURS), row[1:]
        ):
            if channel not in result.channel.values:
                beside.remove()
                continue
            part = result.sel(channel=channel)
            panels.line(row[0], part, part.echo, part.echo_standard_error, colour, name)
            shown.append((part.echo, part.converged))
            last = part.sizes["order"]
            title = f"{name} by order" + ("" if last == orders else f" ({last} and above in one)")
            title = textwrap.fill(title, int(LETTERS_PER_INCH * width))
            panels.orders(beside, part, title, orders, colour)
        panels.finish_lines(row[0], shown, f"{channel} echo")
        panels.finish_depth(row[0], results)
    at_the_right = next(panel for panel in grid[:, -1] if panel in drawing.axes)
    panels.orders_legend(at_the_right, results)
    return drawing
