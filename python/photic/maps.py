"""The panels of a telescope with many channels: a map of depth and wavelength, and spectra at some
depths."""

from dataclasses import dataclass

import numpy
from matplotlib.collections import PolyCollection
from matplotlib.colors import LogNorm
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from photic import panels
from photic.page import Legend, spread, text
from photic.spectrum import Spectrum

MOST_NAMED = 16  # columns of a map
MOST_TICKS = 10  # of a map with more
LARGEST_RATIO = 1e8  # of echoes in one map: more decades have no colours of their own
DARK = "0.9"  # cells without light
HATCH = {"hatch": "////", "facecolor": (1, 1, 1, 0.25), "edgecolor": "0.15", "linewidth": 0}
FADED = {"alpha": panels.FADED, "markerfacecolor": "white"}
EVEN = 1.01  # the largest step of wavelengths over the smallest one, on an axis that is one


@dataclass(frozen=True)
class Columns:
    """The columns of a map: channels by ascending wavelength [nm]; width_nm: the divisors of their echoes,
    or None; of: their kind."""

    names: list
    wavelength: numpy.ndarray
    width_nm: numpy.ndarray | None
    of: str

    @property
    def unit(self):
        return "photons detected per photon emitted" + ("" if self.width_nm is None else " and nm")

    def seen(self, view, variable):
        """A variable of channels and gates, by columns: [gate, column]."""
        values = view[variable].sel(channel=self.names).transpose("gate", "channel").values
        is_number = values.dtype.kind == "f"
        return values / self.width_nm if is_number and self.width_nm is not None else values

    def at(self, view, gate):
        """The spectrum of one gate."""
        parts = (self.seen(view, name)[gate] for name in ("echo", "echo_standard_error", "converged"))
        return Spectrum(self.wavelength, *parts)

    def edges(self):
        """The edges of the columns, and whether these are wavelengths: columns that do not follow each other evenly
        stand side by side."""
        steps = numpy.diff(self.wavelength)
        if len(steps) == 0 or steps.min() <= 0 or steps.max() > EVEN * steps.min():
            return numpy.arange(len(self.names) + 1) - 0.5, False
        step = steps.mean()
        return self.wavelength[0] + step * (numpy.arange(len(self.names) + 1) - 0.5), True


def depth_by_wavelength(view, columns, panel):
    """Echoes as colours. What has not converged is hatched, and grey is no light."""
    echo, settled = columns.seen(view, "echo"), columns.seen(view, "converged")
    across, is_wavelength = columns.edges()
    down = _gate_edges(view, columns)
    lit = echo > 0
    if lit.any():
        colours(panel, across, down, numpy.where(lit, echo, numpy.nan), norm_of(echo, lit & settled), columns.unit)
        unsettled = boxes(across, down, lit & ~settled)
        panel.add_collection(PolyCollection(unsettled, zorder=1.2, **HATCH), autolim=False)
    else:
        panels.say(panel, panels.NO_LIGHT)
    panel.set_facecolor(DARK)
    panel.set_xlim(across[0], across[-1])
    _name(panel, columns, across, is_wavelength)
    panels.finish_depth(panel, [view])


def map_legend(view, columns):
    echo, settled = columns.seen(view, "echo"), columns.seen(view, "converged")
    handles = []
    if ((echo > 0) & ~settled).any():
        handles.append(Patch(label="hatched: not converged", **(HATCH | {"facecolor": "0.75"})))
    if not (echo > 0).all():
        handles.append(Patch(facecolor=DARK, label="no light"))
    return Legend(handles)


def _gate_edges(view, columns):
    """[gate + 1, column]; the outer ones alike, though gates of one time are a little deeper for some
    wavelengths."""
    bounds = view.gate_depth_bounds.sel(channel=columns.names).transpose("bnds", "gate", "channel").values
    edges = numpy.concatenate([bounds[0], bounds[1][-1:]])
    edges[0], edges[-1] = edges.min(), edges.max()
    return edges


def norm_of(echo, settled):
    """By what has converged, if anything has."""
    values = echo[settled if settled.any() else echo > 0]
    low, high = max(values.min(), values.max() / LARGEST_RATIO), values.max()
    return LogNorm(low, high) if low < high else LogNorm(low / 3, 3 * high)


def colours(panel, across, down, echo, norm, unit):
    """Each column with edges of its own, and cells without a width between them."""
    cells = numpy.full((len(echo), 2 * echo.shape[1] - 1), numpy.nan)
    cells[:, ::2] = echo
    sides = numpy.tile(across.repeat(2)[1:-1], (len(down), 1))
    mesh = panel.pcolormesh(sides, down.repeat(2, axis=1), cells, norm=norm, cmap="viridis", zorder=1)
    mesh.set_rasterized(True)  # no seams between the cells of a .pdf
    below, above = numpy.nanmin(echo) < norm.vmin, numpy.nanmax(echo) > norm.vmax
    extend = {(0, 0): "neither", (1, 0): "min", (0, 1): "max", (1, 1): "both"}[int(below), int(above)]
    bar = panel.figure.colorbar(mesh, ax=panel, extend=extend, pad=0.02, aspect=30)
    bar.set_label(unit)


def boxes(across, down, chosen):
    """A rectangle for each stretch of gates that are chosen in a column."""
    found = []
    for column, (left, right) in enumerate(zip(across[:-1], across[1:])):
        one = numpy.concatenate([[False], chosen[:, column], [False]]).astype(int)
        for begin, end in numpy.flatnonzero(numpy.diff(one)).reshape(-1, 2):
            top, bottom = down[begin, column], down[end, column]
            found.append([(left, top), (right, top), (right, bottom), (left, bottom)])
    return found


def _name(panel, columns, across, is_wavelength):
    """The columns, by ticks: wavelengths, with the names of a few channels of any kind."""
    panel.set_xlabel(f"wavelength of the {columns.of} [nm]")
    if is_wavelength:
        return
    count = len(columns.names)
    named = count <= MOST_NAMED and columns.width_nm is None
    shown = spread(count, count if count <= MOST_NAMED else MOST_TICKS)
    labels = [f"{columns.wavelength[k]:.4g}" for k in shown]
    if named:
        labels = [text(f"{columns.names[k]}, {label}") for k, label in zip(shown, labels)]
        panel.set_xlabel(f"{columns.of}, and its wavelength [nm]")
    middle = 0.5 * (across[:-1] + across[1:])
    panel.set_xticks(middle[shown], labels, rotation=90 if named else 0)


def points(lines, every, unit, markers, panel):
    """As panels.spectra, but points with bars, since the light between two channels is not known."""
    for (_, colour, one), marker in zip(lines, markers):
        low, high = panels.band_ends(one.density, panels.INTERVAL_95 * one.standard_error)
        bars = numpy.nan_to_num([one.density - low, high - one.density])  # none where errors are not known
        for settled, look in ((one.settled, {}), (~one.settled, FADED)):
            lit = settled & (one.density > 0)
            style = {"color": colour, "marker": marker, "linestyle": "none", "capsize": 2, **look}
            panel.errorbar(one.wavelength[lit], one.density[lit], bars[:, lit], **style)
    panels.finish_spectra(panel, [one.density for one in every], unit)


def points_legend(lines, title, styles):
    """For one panel of them; styles: telescopes and their markers."""
    look = {"linestyle": "none", "marker": "o"}
    names = {name: colour for name, colour, _ in lines}
    handles = [Line2D([], [], color=colour, label=name, **look) for name, colour in names.items()]
    handles += [Line2D([], [], color="0.2", label=name, **(look | {"marker": marker})) for name, marker in styles]
    if any((~one.settled & (one.density > 0)).any() for *_, one in lines):
        handles.append(Line2D([], [], color="0.2", label=panels.NOT_CONVERGED, **look, **FADED))
    return Legend(handles, title)
