"""The panels of a figure: echoes and their ratios as lines, orders of scattering as shares, all
against depth."""

import itertools

import numpy
from matplotlib import colormaps
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from matplotlib.ticker import LogLocator, NullFormatter

INTERVAL_95 = 1.96  # standard errors of a normal distribution
MARKERS_PER_LINE = 40
LARGEST_RATIO = 1e16  # of echoes on one axis: more decades cannot be told apart
LARGEST_CHANGE = 3  # factor of an environment that is still told in per cent
NARROW = 0.3  # band, over its echo: not too wild to choose the axis by
LEGEND_LINES = 22  # what fits beside a panel
AT_THE_RIGHT = {"loc": "upper left", "bbox_to_anchor": (1.01, 1), "borderaxespad": 0}
NO_LIGHT = "no light in any gate"
HATCH = {"hatch": "///", "edgecolor": "white", "linewidth": 0}


def text(words):
    """Users' words as they stand: to matplotlib $ begins a formula, and a leading _ hides a line
    from the legend."""
    words = str(words).replace("$", r"\$")
    return f" {words}" if words.startswith("_") else words


def line(panel, part, echo, standard_error, colour, label):
    """An echo with its 95 % band; open circles where not converged, a gap where not above 0."""
    echo = echo.where(echo > 0).values
    ends = _ends(echo, INTERVAL_95 * standard_error.values)
    _curve(panel, part.gate_depth.values, echo, ends, part.converged.values, colour, label)


def _ends(middle, half_width):
    """Of a band on a logarithmic axis. A lower end at or below 0 has no place there: cut where the
    caption says."""
    return numpy.maximum(middle - half_width, 0.1 * middle), middle + half_width


def _curve(panel, depth, middle, ends, settled, colour, label):
    there = ~numpy.isnan(middle)
    panel.fill_betweenx(depth, *ends, where=there, color=colour, alpha=0.22, linewidth=0)
    thick = numpy.where(settled, middle, numpy.nan)
    panel.plot(thick, depth, color=colour, linewidth=1.8, label=text(label))
    panel.plot(middle, depth, color=colour, linewidth=0.8)
    marked = thinned(~settled, -(-len(depth) // MARKERS_PER_LINE))
    panel.plot(middle[marked], depth[marked], color=colour, markeredgewidth=0.9, **_circles())


def _circles():
    return {"linestyle": "none", "marker": "o", "markersize": 4, "markerfacecolor": "white"}


def thinned(chosen, step):
    """The first of every stretch that is chosen, that none goes unmarked, and every step-th on."""
    kept = []
    for stretch, indices in itertools.groupby(range(len(chosen)), key=lambda i: chosen[i]):
        kept += list(indices)[::step] if stretch else []
    return kept


def finish_lines(panel, shown, title):
    """Axes and legend for the echoes shown, each given with the convergence of its gates."""
    _echo_axes(panel, [echo for echo, _ in shown], title)
    handles, _ = panel.get_legend_handles_labels()
    if any(_unsettled(echo, converged) for echo, converged in shown):
        handles.append(_not_converged())
    panel.legend(handles=handles, loc="best", fontsize=8.5, framealpha=0.92)


def _not_converged():
    style = {**_circles(), "linestyle": "-", "linewidth": 0.8, "color": "0.4"}
    return Line2D([], [], label="not converged", **style)


def _echo_axes(panel, echoes, title):
    limits = _echo_limits(echoes)
    if limits is None:  # and no numbers for a logarithmic axis
        panel.text(0.5, 0.5, NO_LIGHT, transform=panel.transAxes, ha="center", color="0.3")
        panel.set_xticks([])
    else:
        panel.set_xscale("log")
        panel.set_xlim(limits)
    panel.set_xlabel("photons detected in the gate per photon emitted", fontsize=9)
    panel.set_title(text(title), fontsize=10.5, loc="left")
    _grid(panel)


def _grid(panel):
    panel.grid(which="major", color="0.88", linewidth=0.7)
    panel.set_axisbelow(True)


def _unsettled(echo, converged):
    return bool(((echo > 0) & ~converged).any())


def _echo_limits(echoes):
    """What holds every echo above 0; None if there is none."""
    values = numpy.concatenate([echo.values.ravel() for echo in echoes])
    values = values[values > 0]
    if len(values) == 0:
        return None
    return max(values.min() / 3, values.max() / LARGEST_RATIO), 3 * values.max()


def processes(panel, part, colours, title):
    """The echo of one channel by the process in which the light turned."""
    for process in part.process.values:
        one = part.sel(process=process)
        if (one.echo_by_process > 0).any():
            error = one.echo_by_process_standard_error
            line(panel, part, one.echo_by_process, error, next(colours), process)
    finish_lines(panel, [(part.echo_by_process, part.converged)], title)


def environments(panel, part, colours, title):
    """The echo of one channel in the scene, black, and in its environments."""
    line(panel, part, part.echo, part.echo_standard_error, "black", "the scene")
    for name, colour in zip(part.environment.values, colours):
        one = part.sel(environment=name)
        one = one.assign(converged=one.environment_converged)
        error = one.environment_echo_standard_error
        line(panel, one, one.environment_echo, error, colour, name)
    _echo_axes(panel, [part.echo, part.environment_echo], title)


def changes(panel, part, colours, title):
    """What the environments change in the echo of one channel: over the scene's, in per cent unless
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
        ends = _ends(middle, width) if factors else (middle - width, middle + width)
        if not factors:
            middle, *ends = (100 * (each - 1) for each in (middle, *ends))
        _curve(panel, part.gate_depth.values, middle, ends, good, colour, name)
        shown += [middle[good | narrow], *(end[good] for end in ends)]
    _change_axes(panel, numpy.concatenate(shown), factors)
    panel.set_title(text(title), fontsize=10.5, loc="left")
    _grid(panel)


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
        panel.xaxis.set_major_locator(LogLocator(subs=(1, 2, 5) if high < 100 * low else (1,)))
        panel.xaxis.set_major_formatter("{x:g}")
        panel.xaxis.set_minor_formatter(NullFormatter())
    label = "echo over that of the scene" if factors else "echo against the scene's [%]"
    panel.set_xlabel(label, fontsize=9)


def _around_zero(panel, values):
    """A linear axis that holds 0 and the values, if there are any."""
    if len(values) == 0:
        panel.text(0.5, 0.5, NO_LIGHT, transform=panel.transAxes, ha="center", color="0.3")
        panel.set_xticks([])
        return
    low, high = min(values.min(), 0), max(values.max(), 0)
    margin = 0.05 * (high - low) or 1
    panel.set_xlim(low - margin, high + margin)


def sensitivities(panel, part, colours, title):
    """The logarithmic sensitivities of one channel's echo with their 95 % bands."""
    panel.axvline(0, color="black", linewidth=1.2)
    shown = []
    for name, colour in zip(part.parameter.values, colours):
        one = part.sel(parameter=name)
        middle = one.logarithmic_sensitivity.values
        error = INTERVAL_95 * one.logarithmic_sensitivity_standard_error.values
        good = one.sensitivity_converged.values
        ends = (middle - error, middle + error)
        _curve(panel, part.gate_depth.values, middle, ends, good, colour, name)
        narrow = ~(error >= NARROW * abs(middle))
        shown += [middle[good | narrow], *(end[good] for end in ends)]
    values = numpy.concatenate(shown)
    _around_zero(panel, values[numpy.isfinite(values)])
    panel.set_xlabel("change of the echo for 1 % of the parameter [%]", fontsize=9)
    panel.set_title(text(title), fontsize=10.5, loc="left")
    _grid(panel)


def sensitivities_legend(panel, result, colours):
    """To the right of the panel, for all panels of sensitivities."""
    _lines_legend(panel, zip(result.parameter.values, colours), result, result.sensitivity_converged)


def environments_legend(panel, result, colours):
    """To the right of the panel, for all panels of environments."""
    lines = [("the scene", "black"), *zip(result.environment.values, colours)]
    _lines_legend(panel, lines, result, result.converged & result.environment_converged)


def _lines_legend(panel, lines, result, converged):
    handles = []
    for name, colour in lines:
        handles.append(Line2D([], [], color=colour, linewidth=1.8, label=text(name)))
    if _unsettled(result.echo, converged):
        handles.append(_not_converged())
    columns = -(-len(handles) // LEGEND_LINES)
    panel.legend(handles=handles, frameon=False, fontsize=8.5, ncols=columns, **AT_THE_RIGHT)


def orders(panel, part, title, count, colour="black"):
    """Shares of the orders of scattering, side by side: single scattering first. `count`: of how many
    orders the figure tells."""
    total = part.echo_by_order.sum("order")
    edges = (100 * part.echo_by_order / total.where(total > 0)).cumsum("order", skipna=False).values
    left = numpy.where(numpy.isnan(edges[0]), numpy.nan, 0.0)
    depth = part.gate_depth_bounds.values.ravel()  # each gate from its start to its end
    for right, shade in zip(edges, _shades(count)):
        panel.fill_betweenx(depth, left.repeat(2), right.repeat(2), color=shade, linewidth=0)
        left = right
    unsettled = (~part.converged.values & (total.values > 0)).repeat(2)
    panel.fill_betweenx(depth, 0, 100, where=unsettled, facecolor="none", **HATCH)
    if not (total > 0).any():
        panel.text(0.5, 0.5, NO_LIGHT, transform=panel.transAxes, ha="center", color="0.3")
    panel.set_xlim(0, 100)
    panel.set_xlabel("share of the echo [%]", fontsize=9)
    panel.set_title(text(title), fontsize=10.5, loc="left", color=colour)


def orders_legend(panel, results):
    """To the right of the panel, for all panels of orders."""
    count = max(result.sizes["order"] for result in results)
    names = [str(order) for order in range(1, count + 1)]
    if count > 1:
        names[-1] += " and above"
    handles = [Patch(color=shade, label=name) for name, shade in zip(names, _shades(count))]
    if any(_unsettled(result.echo, result.converged) for result in results):
        handles.append(Patch(facecolor="0.55", label="not converged", **HATCH))
    size = {"fontsize": 8.5, "title_fontsize": 8.5}
    look = {"frameon": False, "alignment": "left", **size, **AT_THE_RIGHT}
    panel.legend(handles=handles, title="order", **look)


def _shades(count):
    return colormaps["viridis"](numpy.linspace(0.12, 0.95, count))


def family(colours, count):
    """Colours of so many lines that black is not among: shades in their order where there are more
    than colours."""
    if count < len(colours):
        return colours[:count]
    return list(colormaps["viridis"](numpy.linspace(0.15, 0.92, count)))


def finish_depth(panel, results):
    """Depth downwards, from the first gate to the last that saw light in any result and channel."""
    ends = []
    for result in results:
        end = result.gate_depth_bounds.max("bnds")
        lit = result.echo > 0
        ends.append(float((end.where(lit) if lit.any() else end).max()))
    panel.set_ylim(max(ends), min(float(result.gate_depth_bounds.min()) for result in results))
    told = results[0].gate_depth.attrs
    word = "depth" if told.get("standard_name") == "depth" else "range"
    panel.set_ylabel("time [ns]" if told["units"] == "ns" else f"{word} [m]")
