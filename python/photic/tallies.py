"""The panels of quantities beside echoes: profiles over levels, light that escapes by its angle, light
absorbed by layers and constituents, maps of the fluence."""

from dataclasses import dataclass

import numpy
from matplotlib.collections import PolyCollection
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from photic import maps, panels
from photic.page import Legend, text

OPEN = {"hatch": "////", "facecolor": "white", "linewidth": 1}  # bars that have not converged
OPEN_LABEL = "open, hatched: not converged"
FADED = {"markerfacecolor": "white", "alpha": panels.FADED}
ABSORBED_HEIGHT = 0.7  # of the bar of a layer, over the distance of two
MOST_LAYERS = 20  # whose names have room beside each other


@dataclass(frozen=True)
class Quantity:
    """Values of a variable by the source's strength, if it has one, and their 95 % intervals."""

    values: numpy.ndarray
    error: numpy.ndarray
    settled: numpy.ndarray
    unit: str

    @property
    def lit(self):
        return self.values > 0


def quantity(result, name, **at):
    """A variable of the result, or a part of it."""
    attributes = result[name].attrs
    scale = attributes.get("strength_scale", 1.0)
    of_itself = [attributes["units"], attributes["normalisation"]]
    unit = attributes.get("strength_units", " ".join(word for word in of_itself if word != "1"))
    value, error, settled = (
        result[name + end].isel(at).values for end in ("", "_standard_error", "_converged")
    )
    return Quantity(scale * value, panels.INTERVAL_95 * scale * error, settled, unit)


def name_of(coordinate):
    """depth [m] of level_depth, in metres."""
    return f"{coordinate.name.rsplit('_', 1)[-1]} [{coordinate.attrs['units']}]"


def profiles(lines, depth, panel):
    """Quantities over levels; lines: their names, colours and values. Points with bars: between levels
    there is nothing but a line to guide the eye. Open where not converged."""
    order = numpy.argsort(depth)
    for _, colour, one in lines:
        values = numpy.where(one.lit, one.values, numpy.nan)
        panel.plot(values[order], depth[order], color=colour, linewidth=0.8, alpha=panels.FADED)
        low, high = panels.band_ends(values, one.error)
        bars = numpy.nan_to_num([values - low, high - values])  # none where errors are not known
        for there, look in ((one.settled, {}), (~one.settled, FADED)):
            there = there & one.lit
            style = {"color": colour, "marker": "o", "markersize": 4, "linestyle": "none", "capsize": 2}
            panel.errorbar(values[there], depth[there], xerr=bars[:, there], **style, **look)
    limits = panels.limits([one.values for *_, one in lines])
    if limits is None:
        panels.say(panel, "no light at any level")
        panel.set_xticks([])
    else:
        panel.set_xscale("log")
        panel.set_xlim(limits)
        panels.name_decades(panel.xaxis, *limits)
    panel.set_xlabel(lines[0][2].unit)
    panels.grid(panel)
    margin = 0.04 * (numpy.ptp(depth) or 1)
    panels.name_depth(panel, depth.min(), depth.max(), margin=margin)


def profiles_legend(lines):
    look = {"marker": "o", "markersize": 4, "linewidth": 0.8}
    handles = [Line2D([], [], color=colour, label=name, **look) for name, colour, _ in lines]
    if any((one.lit & ~one.settled).any() for *_, one in lines):
        handles.append(Line2D([], [], color="0.2", label="open: not converged", **look, **FADED))
    return Legend(handles)


def by_angle(one, edges, panel):
    """Light in bins of angles."""
    for settled, look in ((True, {"color": panels.COLOURS[2]}), (False, OPEN)):
        chosen = (one.settled == settled) & one.lit
        error = numpy.nan_to_num(one.error[chosen])  # none where it is not known
        bars = {"yerr": error, "capsize": 2, "ecolor": "0.2"}
        style = {"align": "edge", "edgecolor": panels.COLOURS[2], "linewidth": 1} | look | bars
        panel.bar(edges[:-1][chosen], one.values[chosen], numpy.diff(edges)[chosen], **style)
    panel.set_xlim(edges[0], edges[-1])
    panel.set_ylim(bottom=0)
    panel.set_xlabel("angle from straight up [degree]")
    panel.set_ylabel(one.unit)
    panels.grid(panel)


def open_legend(every):
    """For bars of one colour."""
    flagged = any((one.lit & ~one.settled).any() for one in every)
    return Legend([Patch(edgecolor="0.3", label=OPEN_LABEL, **OPEN)] if flagged else [])


def absorbed(one, layers, colours, panel):
    """A bar for each layer, the first one on top, with a part for each constituent."""
    place = numpy.arange(len(layers))
    left = numpy.zeros(len(layers))
    for k, colour in enumerate(colours):
        for settled, look in ((True, {"color": colour}), (False, OPEN | {"edgecolor": colour})):
            chosen = (one.settled[:, k] == settled) & one.lit[:, k]
            parts = (place[chosen], one.values[chosen, k], ABSORBED_HEIGHT)
            panel.barh(*parts, left=left[chosen], **look)
        left += one.values[:, k]
    panel.set_ylim(len(layers) - 0.5, -0.5)
    every = -(-len(layers) // MOST_LAYERS)
    panel.set_yticks(place[::every], [text(layer) for layer in layers[::every]])
    panel.set_xlim(left=0)
    panel.locator_params(axis="x", nbins=5)
    panel.ticklabel_format(axis="x", scilimits=(-3, 4))
    panel.set_xlabel(one.unit)
    panels.grid(panel)


def absorbed_legend(one, constituents, colours):
    handles = [Patch(color=colour, label=name) for name, colour in zip(constituents, colours)]
    return Legend(handles + open_legend([one]).handles, "constituent")


def fluence(one, down, across, label, panel):
    """A map; what has not converged is hatched, and grey is no light."""
    if one.lit.any():
        edges = down[:, None].repeat(len(across) - 1, axis=1)
        shown = numpy.where(one.lit, one.values, numpy.nan)
        maps.colours(panel, across, edges, shown, maps.norm_of(one.values, one.lit & one.settled), one.unit)
        boxes = maps.boxes(across, edges, one.lit & ~one.settled)
        panel.add_collection(PolyCollection(boxes, zorder=1.2, **maps.HATCH), autolim=False)
    else:
        panels.say(panel, "no light in any cell")
    panel.set_facecolor(maps.DARK)
    panel.set_xlim(across[0], across[-1])
    panel.set_xlabel(label)
    panels.name_depth(panel, min(down), max(down))


def fluence_legend(one):
    handles = []
    if (one.lit & ~one.settled).any():
        handles.append(Patch(label="hatched: not converged", **(maps.HATCH | {"facecolor": "0.75"})))
    if not one.lit.all():
        handles.append(Patch(facecolor=maps.DARK, label="no light"))
    return Legend(handles)
