"""The panels of one result."""

from functools import partial

import numpy

from photic import panels, spectrum, views
from photic.choice import kept, through
from photic.names import listed
from photic.page import Cell, as_many_as_fit, columns, page, rows, with_legend
from photic.panels import COLOURS

MOST_ROWS = 6  # of environments, of panels with some channels each
BROKEN_DOWN = 2  # channels that are drawn by process, or by order
WIDE, GROUP, MIDDLE, SLIM = 6.6, 3.5, 3.9, 3.3  # panels, on a page of free width
COLUMNS = 4  # of groups, on such a page
BESIDE = 3  # slim panels beside a wide one
HIGH, LOW, SMALL = 6.2, 4.4, 3.6


def draw(results, names, shown, width_mm):
    """The page, its rows, and notes of what has no place. For each telescope the spectrum, if many
    filters see one, echoes by channel with their breakdowns, and below, if there are any, environments
    and sensitivities. Telescopes that differ in view alone share the panels of lines."""
    seen = [
        {name: through(results, name, shown.channels)[0] for name in group}
        for group in views.grouped(results[0], shown.telescopes)
    ]
    broken = [_broken_down(list(of_group.values())) for of_group in seen]
    beside = max(len(mixed) + len(by_order) * len(one) for one, (mixed, by_order) in zip(seen, broken))
    free = WIDE + SLIM * min(beside, BESIDE)
    sheet = page(width_mm, free if len(shown.channels) <= len(COLOURS) else COLUMNS * GROUP)
    known = min(len(by_order) for _, by_order in broken)
    notes = []
    kept(shown.channels, known, "channel", notes, "Orders of scattering are of")
    filters = spectrum.filters(results[0], shown.channels)
    if filters:
        notes.append(spectrum.CAPTION)
    fit = partial(_rows, sheet, shown, filters, seen, broken)
    out, more = as_many_as_fit(sheet, MOST_ROWS, fit)
    return sheet, out, more + notes


def _rows(sheet, shown, filters, seen, broken, most):
    """The rows where each telescope has at most so many of a kind, and notes."""
    notes = []
    every = [view for of_group in seen for view in of_group.values()]
    groups = _groups(sheet, shown.channels, every, most, notes)
    changed = shown.channels
    if {"environment", "parameter"} & set(every[0].sizes):
        changed = kept(changed, most, "channel", notes, "Environments and sensitivities are of")
    out = []
    for of_group, (mixed, by_order) in zip(seen, broken):
        said = [partial(shown.title, name) for name in of_group]
        of_all = partial(shown.title_of, list(of_group))
        for view, one in zip(of_group.values(), said):
            out += rows(sheet, spectra(view, filters, one), LOW) if filters else []
        echoes = _echoes(of_group, groups, mixed, of_all)
        parts = _processes(of_group, mixed, of_all) + _orders(of_group, by_order, said)
        if len(groups) > 1:
            out += rows(sheet, echoes, SMALL) + rows(sheet, parts, SMALL)
        else:
            out += rows(sheet, echoes + parts, HIGH if len(seen) == 1 else LOW)
        for view, one in zip(of_group.values(), said):
            out += _environments(sheet, view, changed, one) if "environment" in view.sizes else []
            out += _sensitivities(sheet, view, changed, one) if "parameter" in view.sizes else []
    return out, notes


def spectra(view, filters, said, width=MIDDLE):
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
    cells = [_spectrum(said("Spectrum by process"), width, lines, every, "process")]
    if others:
        others.insert(0, ("the scene", "black", whole))
        cells.append(_spectrum(said("Spectrum in the environments"), width, others, every))
    return cells


def _spectrum(title, width, lines, every, of=None):
    drawn = partial(panels.spectra, lines, every)
    return Cell(title, width, drawn, panels.spectra_legend(lines, of))


def _broken_down(views):
    """By process the first channel that is fed by several, by order the first channels with light."""
    channels = [str(channel) for channel in views[0].channel.values]
    channels.sort(key=lambda name: not any(_lit(view, name) for view in views))
    mixed = [channel for channel in channels if len(_feeding(views, channel)) > 1][:1]
    return mixed, channels[: BROKEN_DOWN - len(mixed)]


def _feeding(views, channel):
    """The processes that a channel has light of in any view."""
    fed = sum((view.echo_by_process.sel(channel=channel) > 0).any("gate") for view in views)
    return [str(name) for name in views[0].process.values[(fed > 0).values]]


def _groups(sheet, channels, views, most, notes):
    """The channels in panels of so many that colours distinguish them. Of many channels those without
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


def _echoes(of_group, groups, mixed, said):
    """The echoes of each group of channels, on the same axes; of_group: telescopes and their views."""
    every = [view.sel(channel=sum(groups, [])) for view in of_group.values()]
    cells = []
    for group in groups:
        title = "Echo by channel" if mixed else "Echo by channel (one process each)"
        if len(groups) > 1:
            title = "Echo: " + " to ".join(dict.fromkeys([group[0], group[-1]]))
        width = WIDE if len(groups) == 1 else GROUP
        cells.append(echoes_of(of_group, group, said(title), width, every))
    return cells


def echoes_of(of_group, channels, title, width, every):
    """A panel of the echoes of channels, on the axes of every view."""
    parts = [view.sel(channel=channels) for view in of_group.values()]
    labels = [_label([part.sel(channel=name) for part in parts]) for name in channels]
    faded = any(panels.unsettled(part.echo, part.converged) for part in parts)
    legend = panels.lines_legend(list(zip(labels, COLOURS)), faded, styles=styled(of_group))
    return Cell(title, width, partial(_echo, parts, every), legend)


def styled(of_group):
    """Telescopes that share a panel, and the styles of their lines; none of one alone."""
    return list(zip(of_group, views.STYLES)) if len(of_group) > 1 else []


def _label(parts):
    """A channel in the legend."""
    dark = "" if any((part.echo > 0).any() for part in parts) else ": no light"
    return f"{str(parts[0].channel.values)} ({float(parts[0].channel_wavelength):.4g} nm){dark}"


def _echo(parts, every, panel):
    for result, style in zip(parts, views.STYLES):
        for channel, colour in zip(result.channel.values, COLOURS):
            part = result.sel(channel=channel)
            panels.line(panel, part, part.echo, part.echo_standard_error, colour, style)
    panels.finish_lines(panel, [part.echo for part in parts], [view.echo for view in every])
    panels.finish_depth(panel, every)


def _processes(of_group, mixed, said):
    """The echoes by process of the channels given."""
    cells = []
    for channel in mixed:
        parts = [view.sel(channel=channel) for view in of_group.values()]
        lines = panels.of_processes(_feeding(list(of_group.values()), channel))
        shown = [panels.of_process(part, process) for part in parts for process, _ in lines]
        faded = any(panels.unsettled(one.echo_by_process, one.converged) for one in shown)
        legend = panels.lines_legend(lines, faded, "process", styled(of_group))
        draws = partial(_by_process, list(of_group.values()), parts, lines)
        cells.append(Cell(said(f"{channel} echo by process"), SLIM, draws, legend))
    return cells


def _by_process(every, parts, lines, panel):
    for part, style in zip(parts, views.STYLES):
        panels.processes(panel, part, lines, style)
    panels.finish_lines(panel, [part.echo_by_process for part in parts])
    panels.finish_depth(panel, every)


def _orders(of_group, by_order, said):
    """The echoes by order of the channels given, in each view; said: titles of each."""
    cells = []
    for view, title in zip(of_group.values(), said):
        for channel in by_order:
            legend = panels.orders_legend([view.sel(channel=by_order)]) if not cells else None
            draws = partial(_panel, panels.orders, view, view.sel(channel=channel), int(view.order[-1]))
            cells.append(Cell(title(f"{channel} echo by order of scattering"), SLIM, draws, legend))
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
