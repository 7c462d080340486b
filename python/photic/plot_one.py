"""The panels of one result."""

from functools import partial

import numpy

from photic import panels, spectrum
from photic.choice import kept, through
from photic.names import listed
from photic.page import Cell, as_many_as_fit, columns, page, rows, with_legend
from photic.panels import COLOURS

MOST_ROWS = 6  # of environments, of panels with some channels each
BROKEN_DOWN = 2  # channels that are drawn by process, or by order
WIDE, GROUP, MIDDLE, SLIM = 6.6, 3.5, 3.9, 3.3  # panels, on a page of free width
COLUMNS = 4  # of groups, on such a page
HIGH, LOW, SMALL = 6.2, 4.4, 3.6


def draw(results, names, shown, width_mm):
    """The page, its rows, and notes of what has no place. For each telescope the spectrum, if many
    filters see one, echoes by channel with their breakdowns, and below, if there are any, environments
    and sensitivities."""
    views = [through(results, name, shown.channels)[0] for name in shown.telescopes]
    broken = [_broken_down(view) for view in views]
    beside = max(len(mixed) + len(by_order) for mixed, by_order in broken)
    free = WIDE + SLIM * beside if len(shown.channels) <= len(COLOURS) else COLUMNS * GROUP
    sheet = page(width_mm, free)
    told = min(len(by_order) for _, by_order in broken)
    notes = []
    kept(shown.channels, told, "channel", notes, "Orders of scattering are of")
    filters = spectrum.filters(results[0], shown.channels)
    if filters:
        notes.append(spectrum.CAPTION)
    fit = partial(_rows, sheet, shown, filters, views, broken)
    out, more = as_many_as_fit(sheet, MOST_ROWS, fit)
    return sheet, out, more + notes


def _rows(sheet, shown, filters, views, broken, most):
    """The rows where each telescope has at most so many of a kind, and notes."""
    notes = []
    groups = _groups(sheet, shown.channels, views, most, notes)
    changed = shown.channels
    if {"environment", "parameter"} & set(views[0].sizes):
        changed = kept(changed, most, "channel", notes, "Environments and sensitivities are of")
    out = []
    for telescope, view, (mixed, by_order) in zip(shown.telescopes, views, broken):
        said = partial(shown.title, telescope)
        if filters:
            out += _spectra(sheet, view, filters, said)
        echoes, parts = _echoes(view, groups, mixed, said), _parts(view, mixed, by_order, said)
        if len(groups) > 1:
            out += rows(sheet, echoes, SMALL) + rows(sheet, parts, SMALL)
        else:
            out += rows(sheet, echoes + parts, HIGH if len(views) == 1 else LOW)
        if "environment" in view.sizes:
            out += _environments(sheet, view, changed, said)
        if "parameter" in view.sizes:
            out += _sensitivities(sheet, view, changed, said)
    return out, notes


def _spectra(sheet, view, filters, said):
    """The spectrum of all light with that of each process; beside it those in the environments."""
    whole = spectrum.seen(view, filters)
    processes = {str(name): view.sel(process=name) for name in view.process.values}
    parts = {name: spectrum.seen(one, filters, "echo_by_process") for name, one in processes.items()}
    fed = [name for name, one in parts.items() if (one.density > 0).any()]
    lines = [(name, colour, parts[name]) for name, colour in panels.of_processes(fed)]
    lines.append(("all light", "black", whole))
    others = []
    if "environment" in view.sizes:
        names = ("environment_echo", "environment_converged")
        for name, colour in zip(view.environment.values, panels.family(view.sizes["environment"])):
            one = spectrum.seen(view.sel(environment=name), filters, *names)
            others.append((name, colour, one))
    every = [whole, *(one for *_, one in others)]
    cells = [_spectrum(said("Spectrum by process"), lines, every, "process")]
    if others:
        others.insert(0, ("the scene", "black", whole))
        cells.append(_spectrum(said("Spectrum in the environments"), others, every))
    return rows(sheet, cells, LOW)


def _spectrum(title, lines, every, of=None):
    drawn = partial(panels.spectra, lines, every)
    return Cell(title, MIDDLE, drawn, panels.spectra_legend(lines, of))


def _broken_down(result):
    """By process the first channel that is fed by several, by order the first channels with light."""
    channels = [str(channel) for channel in result.channel.values]
    channels.sort(key=lambda name: not _lit(result, name))
    feeding = (result.echo_by_process > 0).any("gate").sum("process")
    mixed = [channel for channel in channels if feeding.sel(channel=channel) > 1][:1]
    return mixed, channels[: BROKEN_DOWN - len(mixed)]


def _groups(sheet, channels, views, most, notes):
    """The channels in panels of so many that colours tell them apart. Of many channels those without
    light are left out."""
    if len(channels) > len(COLOURS):
        dark = [name for name in channels if not any(_lit(view, name) for view in views)]
        if 0 < len(dark) < len(channels):
            channels = [name for name in channels if name not in dark]
            notes.append(f"No light in any gate: {listed(dark)}.")
        room = most * columns(sheet, GROUP) * len(COLOURS)
        channels = kept(channels, room, "channel", notes)
    count = -(-len(channels) // len(COLOURS))
    return [[str(name) for name in part] for part in numpy.array_split(channels, count)]


def _lit(result, channel):
    return bool((result.echo.sel(channel=channel) > 0).any())


def _echoes(result, groups, mixed, said):
    """The echoes of each group of channels, on the same axes."""
    every = result.sel(channel=sum(groups, []))
    cells = []
    for group in groups:
        title = "Echo by channel" if mixed else "Echo by channel (one process each)"
        if len(groups) > 1:
            title = "Echo: " + " to ".join(dict.fromkeys([group[0], group[-1]]))
        part = result.sel(channel=group)
        labels = [_label(part.sel(channel=name)) for name in group]
        faded = panels.unsettled(part.echo, part.converged)
        legend = panels.lines_legend(list(zip(labels, COLOURS)), faded)
        width = WIDE if len(groups) == 1 else GROUP
        cells.append(Cell(said(title), width, partial(_echo, part, every), legend))
    return cells


def _label(one):
    """A channel in the legend."""
    dark = "" if (one.echo > 0).any() else ": no light"
    return f"{str(one.channel.values)} ({float(one.channel_wavelength):.4g} nm){dark}"


def _echo(result, every, panel):
    for channel, colour in zip(result.channel.values, COLOURS):
        part = result.sel(channel=channel)
        panels.line(panel, part, part.echo, part.echo_standard_error, colour)
    panels.finish_lines(panel, [result.echo], [every.echo])
    panels.finish_depth(panel, [every])


def _parts(result, mixed, by_order, said):
    """The echoes by process and by order of the channels given."""
    cells = []
    for channel in mixed:
        part = result.sel(channel=channel)
        fed = part.process.values[(part.echo_by_process > 0).any("gate").values]
        lines = panels.of_processes(fed)
        faded = panels.unsettled(part.echo_by_process, part.converged)
        legend = panels.lines_legend(lines, faded, "process")
        draws = partial(_panel, panels.processes, result, part, lines)
        cells.append(Cell(said(f"{channel} echo by process"), SLIM, draws, legend))
    shown = result.sel(channel=by_order)
    for channel in by_order:
        legend = panels.orders_legend([shown]) if channel == by_order[0] else None
        part, count = result.sel(channel=channel), int(result.order[-1])
        draws = partial(_panel, panels.orders, result, part, count)
        cells.append(Cell(said(f"{channel} echo by order of scattering"), SLIM, draws, legend))
    return cells


def _panel(draws, result, part, how, panel):
    """One of the functions of panels, on the axis of the result."""
    draws(panel, part, how)
    panels.finish_depth(panel, [result])


def _environments(sheet, result, channels, said):
    """A row for each channel: the echo in every environment, and beside it what they change."""
    colours = panels.family(result.sizes["environment"])
    out = []
    for channel in channels:
        echo, change = (
            partial(_panel, draws, result, result.sel(channel=channel), colours)
            for draws in (panels.environments, panels.changes)
        )
        cells = [
            Cell(said(f"{channel} echo in the environments"), MIDDLE, echo),
            Cell(said(f"{channel} echo: change from the scene's"), MIDDLE, change),
        ]
        out += rows(sheet, cells, LOW)
    return with_legend(out, panels.environments_legend(result.sel(channel=channels), colours))


def _sensitivities(sheet, result, channels, said):
    """A panel for each channel: the logarithmic sensitivities of its echo."""
    colours = panels.family(result.sizes["parameter"])
    cells = []
    for channel in channels:
        draws = partial(_panel, panels.sensitivities, result, result.sel(channel=channel), colours)
        cells.append(Cell(said(f"{channel} echo: sensitivities"), MIDDLE, draws))
    legend = panels.sensitivities_legend(result.sel(channel=channels), colours)
    return with_legend(rows(sheet, cells, LOW), legend)
