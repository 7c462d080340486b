"""The panels of a figure: echoes and their ratios as lines, orders of scattering as shares, all
against depth; and spectra."""

import itertools

import numpy
from matplotlib import colormaps
from matplotlib.colors import to_rgba
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from matplotlib.patheffects import withStroke
from matplotlib.ticker import LogLocator, NullFormatter

from photic.page import MOST_NAMED, Legend, spread

# Okabe & Ito (2008), "Color Universal Design": distinct to the colour-blind too.
# Green comes first, for 532 nm.
COLOURS = ["#009E73", "#D55E00", "#0072B2", "#CC79A7", "#E69F00", "#56B4E9", "#000000"]
OF_AIR = "#56B4E9"  # light of the process air, and of no other
INTERVAL_95 = 1.96  # standard errors of a normal distribution
MARKERS_PER_LINE = 40
LARGEST_RATIO = 1e16  # of echoes on one axis: more decades cannot be distinguished
LARGEST_CHANGE = 3  # factor of an environment that is still given in per cent
NARROW = 0.3  # band, over its echo: not too wild to choose the axis by
BAND, FADED_BAND, FADED = 0.25, 0.08, 0.45  # opacity: of bands, and of what has not converged
NO_LIGHT = "no light in any gate"
NOT_CONVERGED = "faded: not converged"
HATCH = {"hatch": "///", "edgecolor": "white", "linewidth": 0}
LIGHT_EDGE = withStroke(linewidth=2.4, foreground="white")  # seen on dark shades, too
SEA_LEVEL = {"color": "0.25", "linewidth": 0.9, "linestyle": "--", "path_effects": [LIGHT_EDGE]}
SEA_LEVEL |= {"zorder": 1.5}  # over areas, under curves
VEIL = {"facecolor": (1, 1, 1, 1 - FADED)}


def line(panel, part, echo, standard_error, colour, style="-"):
    """An echo with its 95 % band; faded, with open circles, where not converged, a gap where not above
    0."""
    echo = echo.where(echo > 0).values
    ends = band_ends(echo, INTERVAL_95 * standard_error.values)
    _curve(panel, part.gate_depth.values, echo, ends, part.converged.values, colour, style=style)


def band_ends(middle, half_width):
    """The ends of a band on a logarithmic axis. A lower end at or below 0 is cut off where the
    caption says."""
    return numpy.maximum(middle - half_width, 0.1 * middle), middle + half_width


def _curve(panel, depth, middle, ends, settled, colour, upright=True, style="-"):
    """The line with its band, both faded where not converged. Not upright: along the horizontal axis,
    with wavelengths for depths."""
    there = ~numpy.isnan(middle)
    fill = panel.fill_betweenx if upright else panel.fill_between
    look = {"color": colour, "linewidth": 0}
    fill(depth, *ends, where=there & settled, alpha=BAND, **look)
    # Each gate twice, so that the rest begins and ends in the gate where the other does.
    rest = numpy.concatenate([[True], (~(settled[:-1] & settled[1:])).repeat(2), [True]])
    twice = [each.repeat(2) for each in (depth, *ends)]
    where = there.repeat(2) & rest
    fill(*twice, where=where, alpha=FADED_BAND, **look)
    thick = numpy.where(settled, middle, numpy.nan)
    alone = list(numpy.flatnonzero(_alone(settled & there)))  # a line needs two neighbours
    dots = {"marker": "o", "markersize": 3, "markevery": alone}
    marked = thinned(~settled, -(-len(depth) // MARKERS_PER_LINE))

    def plot(across, along, **look):
        panel.plot(*((across, along) if upright else (along, across)), color=colour, **look)

    plot(thick, depth, linewidth=1.8, linestyle=style, **dots)
    plot(middle, depth, linewidth=0.8, linestyle=style, alpha=FADED)
    plot(middle[marked], depth[marked], **_circles())


def _alone(drawn):
    """The gates that the line has, between gates that it has not."""
    around = numpy.concatenate([[False], drawn, [False]])
    return drawn & ~around[:-2] & ~around[2:]


def _circles():
    face = {"markerfacecolor": "white", "markeredgewidth": 0.9, "alpha": FADED}
    return {"linestyle": "none", "marker": "o", "markersize": 4, **face}


def thinned(chosen, step):
    """The first of every stretch that is chosen, so that none is unmarked, and every step-th on."""
    kept = []
    for stretch, indices in itertools.groupby(range(len(chosen)), key=lambda i: chosen[i]):
        kept += list(indices)[::step] if stretch else []
    return kept


def lines_legend(lines, faded, title=None, styles=()):
    """lines: their names and colours; faded: whether any gate has not converged; styles:
    the same of lines of any colour."""
    kept = spread(len(lines), MOST_NAMED)
    named = [lines[k] for k in kept]
    handles = [Line2D([], [], color=colour, linewidth=1.8, label=name) for name, colour in named]
    if len(named) < len(lines):
        label = f"{len(named)} of {len(lines)} are named"
        handles.append(Line2D([], [], linestyle="none", label=label))
    for name, style in styles:
        handles.append(Line2D([], [], color="0.2", linewidth=1.8, linestyle=style, label=name))
    if faded:
        style = {**_circles(), "linestyle": "-", "linewidth": 0.8, "color": "0.2"}
        handles.append(Line2D([], [], label=NOT_CONVERGED, **style))
    return Legend(handles, title)


def finish_lines(panel, echoes, every=None):
    """Axes for the echoes shown; every: those that other panels show on the same axis."""
    if limits(echoes) is None:
        say(panel, NO_LIGHT)
    ends = limits(every or echoes)
    if ends is None:  # no numbers for a logarithmic axis
        panel.set_xticks([])
    else:
        panel.set_xscale("log")
        panel.set_xlim(ends)
    panel.set_xlabel("photons detected per photon emitted")
    grid(panel)


def say(panel, words):
    """Words in the middle of a panel without curves."""
    panel.text(0.5, 0.5, words, transform=panel.transAxes, ha="center", color="0.3")


def grid(panel):
    panel.grid(which="major", color="0.88", linewidth=0.7)
    panel.set_axisbelow(True)


def unsettled(echo, converged):
    return bool(((echo > 0) & ~converged).any())


def limits(echoes):
    """The limits that hold every echo above 0; None if there is none."""
    values = numpy.concatenate([numpy.ravel(echo) for echo in echoes])
    values = values[values > 0]
    if len(values) == 0:
        return None
    return max(values.min() / 3, values.max() / LARGEST_RATIO), 3 * values.max()


def of_process(part, process):
    """The light of a process, with flags of its own: those of its gates where an earlier result has no
    others."""
    one = part.sel(process=process)
    return one.assign(converged=one.get("echo_by_process_converged", one.converged))


def processes(panel, part, lines, style="-"):
    """The echo of one channel by process; lines: processes, and their
    colours."""
    for process, colour in lines:
        one = of_process(part, process)
        line(panel, one, one.echo_by_process, one.echo_by_process_standard_error, colour, style)


def spectra(lines, every, panel, styles=itertools.repeat("-")):
    """lines: what spectra are called, their colours, and the spectra; every: those that the axis is
    chosen by; styles: of lines."""
    for (_, colour, one), style in zip(lines, styles):
        density = numpy.where(one.density > 0, one.density, numpy.nan)
        ends = band_ends(density, INTERVAL_95 * one.standard_error)
        _curve(panel, one.wavelength, density, ends, one.settled, colour, upright=False, style=style)
    finish_spectra(panel, [one.density for one in every], "photons detected per photon emitted and nm")


def finish_spectra(panel, values, unit):
    """Axes for values by wavelength."""
    ends = limits(values)
    if ends is None:
        say(panel, NO_LIGHT)
        panel.set_xticks([])
        panel.set_yticks([])
    else:
        panel.set_yscale("log")
        panel.set_ylim(ends)
    panel.set_xlabel("wavelength [nm]")
    panel.set_ylabel(unit)
    grid(panel)


def spectra_legend(lines, title=None, styles=()):
    """For one panel of them: a name for all lines of one colour."""
    faded = any((~one.settled & (one.density > 0)).any() for *_, one in lines)
    names = {name: colour for name, colour, _ in lines}
    return lines_legend(list(names.items()), faded, title, styles)


def environments(panel, part, colours):
    """The echo of one channel in the scene, black, and in its environments."""
    line(panel, part, part.echo, part.echo_standard_error, "black")
    for name, colour in zip(part.environment.values, colours):
        one = part.sel(environment=name)
        one = one.assign(converged=one.environment_converged)
        line(panel, one, one.environment_echo, one.environment_echo_standard_error, colour)
    finish_lines(panel, [part.echo, part.environment_echo])


def changes(panel, part, colours):
    """Draws the changes by the environments to the echo of one channel: over the scene's, in per cent unless
    factors are large. Bands are those of the difference."""
    echo = part.echo.where(part.echo > 0)
    ratio = (1 + part.environment_difference / echo).where(part.environment_echo > 0)
    half_width = INTERVAL_95 * part.environment_difference_standard_error / echo
    settled = part.environment_converged & part.converged
    factors = _largest_change(ratio.where(settled)) > LARGEST_CHANGE
    panel.axvline(1 if factors else 0, color="black", linewidth=1.2)
    shown = []
    for name, colour in zip(part.environment.values, colours):
        this = {"environment": name}
        middle, width = ratio.sel(this).values, half_width.sel(this).values
        # An error that is not known, of a single batch, hides no curve.
        good, narrow = settled.sel(this).values, ~(width >= NARROW * middle)
        seen = numpy.where(good | narrow, width, numpy.nan)  # wild bands would hide the others
        lower = numpy.maximum(middle - seen, 0)  # no echo is below 0
        ends = band_ends(middle, seen) if factors else (lower, middle + seen)
        if not factors:
            middle, *ends = (100 * (each - 1) for each in (middle, *ends))
        _curve(panel, part.gate_depth.values, middle, ends, good, colour)
        shown += [middle[good | narrow], *(end[good] for end in ends)]
    _change_axes(panel, numpy.concatenate(shown), factors)
    grid(panel)


def _largest_change(ratio):
    ratio = ratio.where(ratio > 0)
    return max(float(ratio.max()), 1 / float(ratio.min()))  # NaN, which is above nothing, if none


def _change_axes(panel, values, factors):
    values = values[numpy.isfinite(values)]
    if not factors or len(values) == 0:
        _around_zero(panel, values)
    else:
        low, high = min(values.min(), 1), max(values.max(), 1)
        panel.set_xscale("log")
        panel.set_xlim(low / (high / low) ** 0.05, high * (high / low) ** 0.05)
        name_decades(panel.xaxis, low, high)
        panel.xaxis.set_major_formatter("{x:g}")
    label = "ratio to the scene's echo" if factors else "change from the scene's echo [%]"
    panel.set_xlabel(label)


def name_decades(axis, low, high):
    """Numbers on a logarithmic axis: within decades, too, where it has few."""
    few = high < 100 * low
    axis.set_major_locator(LogLocator(subs=(1, 2, 5) if few else (1,)))
    axis.set_minor_formatter(NullFormatter())
    if few:
        axis.set_major_formatter("{x:g}")


def _around_zero(panel, values):
    """A linear axis that holds 0 and the values, if there are any."""
    if len(values) == 0:
        say(panel, NO_LIGHT)
        panel.set_xticks([])
        return
    low, high = min(values.min(), 0), max(values.max(), 0)
    margin = 0.05 * (high - low) or 1
    panel.set_xlim(low - margin, high + margin)


def sensitivities(panel, part, colours):
    """The logarithmic sensitivities of one channel's echo with their 95 % bands."""
    panel.axvline(0, color="black", linewidth=1.2)
    shown = []
    for name, colour in zip(part.parameter.values, colours):
        one = part.sel(parameter=name)
        middle = one.logarithmic_sensitivity.values
        error = INTERVAL_95 * one.logarithmic_sensitivity_standard_error.values
        good = one.sensitivity_converged.values
        ends = (middle - error, middle + error)
        _curve(panel, part.gate_depth.values, middle, ends, good, colour)
        narrow = ~(error >= NARROW * abs(middle))
        shown += [middle[good | narrow], *(end[good] for end in ends)]
    values = numpy.concatenate(shown)
    _around_zero(panel, values[numpy.isfinite(values)])
    panel.set_xlabel("change of the echo for 1 % of the parameter [%]")
    grid(panel)


def sensitivities_legend(result, colours):
    """For all panels of sensitivities."""
    lines = list(zip(result.parameter.values, colours))
    return lines_legend(lines, unsettled(result.echo, result.sensitivity_converged))


def environments_legend(result, colours):
    """For all panels of environments."""
    lines = [("the scene", "black"), *zip(result.environment.values, colours)]
    return lines_legend(lines, unsettled(result.echo, result.converged & result.environment_converged))


def orders(panel, part, count):
    """Shares of the orders of scattering, side by side: the lowest first. `count`: the highest order
    in the figure."""
    total = part.echo_by_order.sum("order")
    edges = (100 * part.echo_by_order / total.where(total > 0)).cumsum("order", skipna=False).values
    left = numpy.where(numpy.isnan(edges[0]), numpy.nan, 0.0)
    depth = part.gate_depth_bounds.values.ravel()  # each gate from its start to its end
    for right, shade in zip(edges, _shades(count)):
        panel.fill_betweenx(depth, left.repeat(2), right.repeat(2), color=shade, linewidth=0)
        left = right
    unsettled = (~part.converged.values & (total.values > 0)).repeat(2)
    panel.fill_betweenx(depth, 0, 100, where=unsettled, **VEIL, **HATCH)
    if not (total > 0).any():
        say(panel, NO_LIGHT)
    panel.set_xlim(0, 100)
    panel.set_xlabel("share of the echo [%]")


def orders_legend(results):
    """For all panels of orders."""
    count = max(int(result.order[-1]) for result in results)
    names = [str(order) for order in range(count + 1)]
    if count > 1:
        names[-1] += " and above"
    lines = list(zip(names, _shades(count)))
    if not any((result.echo_by_order.sel(order=0) > 0).any() for result in results):
        del lines[0]
    kept = spread(len(lines), MOST_NAMED)
    handles = [Patch(color=lines[k][1], label=lines[k][0]) for k in kept]
    if any(unsettled(result.echo, result.converged) for result in results):
        handles.append(Patch(facecolor="0.75", label=NOT_CONVERGED, **HATCH))
    return Legend(handles, "order of scattering")


def _shades(count):
    """The shades of the orders 0, 1, …, count."""
    return [to_rgba("0.6"), *colormaps["viridis"](numpy.linspace(0.12, 0.95, count))]


def family(count, taken=()):
    """Colours for this many lines, without black and those taken: shades in their order where
    there are more lines than colours."""
    free = [colour for colour in COLOURS if colour not in taken]
    if count < len(free):
        return free[:count]
    return list(colormaps["viridis"](numpy.linspace(0.15, 0.92, count)))


def of_processes(names):
    """Processes and their colours: air has one of its own, whatever else there is."""
    others = [name for name in names if name != "air"]
    colours = dict(zip(others, family(len(others), [OF_AIR]))) | {"air": OF_AIR}
    return [(name, colours[name]) for name in names]


def finish_depth(panel, results):
    """Depth downwards, from the first gate to the last that saw light in any result and channel. A line
    where the sea is, if there are gates on both sides of it."""
    ends = []
    for result in results:
        end = result.gate_depth_bounds.max("bnds")
        lit = result.echo > 0
        ends.append(float((end.where(lit) if lit.any() else end).max()))
    top = min(float(result.gate_depth_bounds.min()) for result in results)
    name_depth(panel, top, max(ends), axis_of(results[0]))


def name_depth(panel, top, bottom, label="depth [m]", margin=0):
    """Depth, or another axis of that label, downwards; with a margin at both ends."""
    panel.set_ylim(bottom + margin, top - margin)
    if label == "depth [m]" and top < 0 < bottom:
        panel.axhline(0, **SEA_LEVEL)
        label += "; above the line: air"
    elif label == "depth [m]" and top < 0:
        label += "; negative: in the air"
    panel.set_ylabel(label)


def axis_of(result):
    """The label of the axis of gates."""
    attributes = result.gate_depth.attrs
    word = "depth" if attributes.get("standard_name") == "depth" else "range"
    return "time [ns]" if attributes["units"] == "ns" else f"{word} [m]"
