"""The panels of a figure: echoes as lines, orders of scattering as shares, both against depth."""

import itertools

import numpy
from matplotlib import colormaps
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

INTERVAL_95 = 1.96  # standard errors of a normal distribution
MARKERS_PER_LINE = 40
LARGEST_RATIO = 1e16  # of echoes on one axis: more decades cannot be told apart
NO_LIGHT = "no light in any gate"
HATCH = {"hatch": "///", "edgecolor": "white", "linewidth": 0}


def text(words):
    """Users' words as they stand: to matplotlib $ begins a formula, and a leading _ hides a line
    from the legend."""
    words = str(words).replace("$", r"\$")
    return f" {words}" if words.startswith("_") else words


def line(panel, part, echo, standard_error, colour, label):
    """An echo with its 95 % band; open circles where not converged, a gap where not above 0."""
    depth = part.gate_depth.values
    echo = echo.where(echo > 0).values
    half_width = INTERVAL_95 * standard_error.values
    # A lower end at or below 0 has no place on a logarithmic axis: cut where the caption says.
    lower = numpy.maximum(echo - half_width, 0.1 * echo)
    there = ~numpy.isnan(echo)
    panel.fill_betweenx(
        depth, lower, echo + half_width, where=there, color=colour, alpha=0.22, linewidth=0
    )
    settled = part.converged.values
    thick = numpy.where(settled, echo, numpy.nan)
    panel.plot(thick, depth, color=colour, linewidth=1.8, label=text(label))
    panel.plot(echo, depth, color=colour, linewidth=0.8)
    marked = thinned(~settled, -(-len(depth) // MARKERS_PER_LINE))
    panel.plot(echo[marked], depth[marked], color=colour, markeredgewidth=0.9, **_circles())


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
    limits = _echo_limits([echo for echo, _ in shown])
    if limits is None:  # and no numbers for a logarithmic axis
        panel.text(0.5, 0.5, NO_LIGHT, transform=panel.transAxes, ha="center", color="0.3")
        panel.set_xticks([])
    else:
        panel.set_xscale("log")
        panel.set_xlim(limits)
    panel.set_xlabel("photons detected in the gate per photon emitted", fontsize=9)
    panel.set_title(text(title), fontsize=10.5, loc="left")
    panel.grid(which="major", color="0.88", linewidth=0.7)
    panel.set_axisbelow(True)
    handles, _ = panel.get_legend_handles_labels()
    if any(_unsettled(echo, converged) for echo, converged in shown):
        style = {**_circles(), "linestyle": "-", "linewidth": 0.8, "color": "0.4"}
        handles.append(Line2D([], [], label="not converged", **style))
    panel.legend(handles=handles, loc="best", fontsize=8.5, framealpha=0.92)


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
    place = {"loc": "upper left", "bbox_to_anchor": (1.01, 1), "borderaxespad": 0}
    size = {"fontsize": 8.5, "title_fontsize": 8.5}
    panel.legend(handles=handles, title="order", frameon=False, alignment="left", **place, **size)


def _shades(count):
    return colormaps["viridis"](numpy.linspace(0.12, 0.95, count))


def finish_depth(panel, results):
    """Depth downwards, from the first gate to the last that saw light in any result and channel."""
    ends = []
    for result in results:
        end = result.gate_depth_bounds.max("bnds")
        lit = result.echo > 0
        ends.append(float((end.where(lit) if lit.any() else end).max()))
    panel.set_ylim(max(ends), min(float(result.gate_depth_bounds.min()) for result in results))
    is_depth = results[0].gate_depth.attrs.get("standard_name") == "depth"
    panel.set_ylabel("depth [m]" if is_depth else "range [m]")
