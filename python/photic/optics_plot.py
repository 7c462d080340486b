"""Drawing what `photic optics` wrote: absorption and scattering against wavelength, phase functions
against angle, and emitted light; a row for each layer. Air emits nothing: the lowest layer is at the
bottom. Spectra of an oil and transmittances have a panel for each unit."""

from functools import cache, partial

import numpy
from matplotlib import colormaps
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from photic.page import Cell, Legend, as_many_as_fit, build, page, rows, spread
from photic.panels import COLOURS, grid, say
from photic.sources import caution

MOST_LAYERS = 6  # of a figure; of more layers so many are drawn, from the first to the last
MOST_PHASES = 5  # phase functions in a panel, of so many wavelengths
WIDE, HIGH = 4.5, 3.6  # a panel, on a page of free width
FEW = 12  # points or lines that are drawn one by one
DECADES = 6  # of an axis: what is less than all of them below the most is not seen
OF_CONSTITUENT = {
    **{"water": "#0072B2", "phytoplankton": "#009E73", "CDOM": "#D55E00"},
    **{"molecules": "#0072B2", "ozone": "#009E73", "aerosols": "#D55E00"},
}
OF_PROCESS = {"raman": "#0072B2", "chlorophyll": "#009E73", "cdom": "#D55E00"}
UNITS = {"m-1": "1/m", "nm-1": "1/nm"}
FLOOR = 1e-30  # 0 for a logarithmic axis
ANGLES = [0, 1, 10, 30, 60, 90, 180]
TOTAL = {"color": "black", "linewidth": 2.0}
UNNAMED = "_child"  # as matplotlib calls lines that have no name
NO_EMISSION = "no light of other wavelengths"


def figure(optics, title=None, width_mm=None):
    """optics: what photic.open gives for a file of `photic optics`; title: default the scene's;
    width_mm: of the figure."""
    across = 4 if "process" in optics.sizes else 3
    sheet = page(width_mm, WIDE * across)
    cells = cache(partial(_cells, optics, across))  # more than one number of layers is tried
    out, drawn = as_many_as_fit(sheet, MOST_LAYERS, partial(_rows, sheet, optics, cells))
    caption = [_caption(optics, drawn), caution(optics)]
    title = optics.attrs["title"] if title is None else title
    return build(sheet, out, title, "\n".join(filter(None, caption)))


def _rows(sheet, optics, cells, most):
    """The rows of so many layers, or of all if there are fewer, and the number of these."""
    axis, out = _axis(optics), []
    layers = spread(optics.sizes[axis], most)
    for layer in layers[::-1] if axis == "altitude" else layers:
        out += rows(sheet, cells(int(layer)), HIGH, sharey=False)
    return out, len(layers)


def _cells(optics, across, number):
    """The panels of a layer. limits: optics that hold all that is drawn on the same axes."""
    axis = _axis(optics)
    layer = optics.isel({axis: number})
    # Air thins out by more than an axis can show.
    limits = optics if axis == "depth" else layer
    totals = [("b_per_m", "all", "-"), ("bb_per_m", "all, backwards", "--")]
    draws = [
        ("absorption", partial(_spectra, layer, limits, [("a_per_m", "all", "-")], "absorption by ")),
        ("scattering", partial(_spectra, layer, limits, totals, "scattering by ")),
        ("phase function", partial(_phases, layer, limits)),
        ("light emitted", partial(_emission, layer, limits)),
    ]
    return [_cell(f"{_name(layer)}: {what}", draw) for what, draw in draws[:across]]


def _cell(title, draw, width=WIDE):
    """A panel with a legend of what is drawn in it."""
    scratch = Figure().subplots()
    draw(scratch)
    lines = [line for line in scratch.get_lines() if not line.get_label().startswith(UNNAMED)]
    return Cell(title, width, draw, Legend([_proxy(line) for line in lines]))


def _proxy(line):
    """A copy of a line, for the legend of another figure."""
    look = {"color": line.get_color(), "linewidth": line.get_linewidth()}
    marker = {"marker": line.get_marker(), "markersize": line.get_markersize()}
    face = {"linestyle": line.get_linestyle(), "markerfacecolor": line.get_markerfacecolor()}
    return Line2D([], [], label=line.get_label(), **look, **marker, **face)


def spectra(table, title=None, width_mm=None):
    """table: what photic.open gives for spectra of an oil, or for transmittances; width_mm: of the
    figure."""
    units = list(dict.fromkeys(table[name].attrs["units"] for name in _curves(table)))
    sheet = page(width_mm, 6.0 * len(units))
    cells = [_cell("", partial(_of_unit, table, unit), 6.0) for unit in units]
    caption = [table.attrs["source"] + _numbers(table), caution(table)]
    title = table.attrs["title"] if title is None else title
    return build(sheet, rows(sheet, cells, 4.2, sharey=False), title, "\n".join(filter(None, caption)))


def _of_unit(table, unit, panel):
    """The curves that change most of those in the unit."""
    names = [name for name in _curves(table) if table[name].attrs["units"] == unit]
    names.sort(key=lambda name: -float(abs(table[name] - table[name][0]).max()))
    for name, colour in zip(names[: len(COLOURS) - 1], COLOURS):
        look = {"color": colour, "linewidth": 1.5}
        _spectrum(panel, table[name], table[name].attrs["long_name"], **look)
    panel.set_xlabel("wavelength [nm]")
    panel.set_ylabel(_unit(unit))
    grid(panel)
    if unit == "m-1":
        panel.set_yscale("log")


def _unit(unit):
    return f"[{UNITS.get(unit, unit)}]"


def _curves(table):
    return [name for name in table.data_vars if table[name].dims == ("wavelength",)]


def _numbers(table):
    """The quantities with one number each, in words."""
    said = [
        f"; {table[name].attrs['long_name']}: {float(table[name]):.4g} {table[name].attrs['units']}"
        for name in table.data_vars
        if not table[name].dims
    ]
    return "".join(said).replace(" 1;", ";").removesuffix(" 1")


def _axis(optics):
    return "altitude" if "altitude" in optics.sizes else "depth"


def _name(layer):
    if "altitude" in layer.coords:
        return str(layer.layer_name.values)
    top, bottom = layer.depth_m_bounds.values
    where = f"from {top:g} m down" if numpy.isinf(bottom) else f"{top:g}\u2013{bottom:g} m"
    return f"{layer.layer_name.values}, {where}"


def _caption(optics, drawn):
    parts = [optics.attrs["source"]]
    layers = optics.sizes[_axis(optics)]
    if drawn < layers:
        which = f"{drawn} of its {layers} layers, from the first to the last"
        parts.append(which if drawn > 1 else f"the first of its {layers} layers")
    if "process" in optics.sizes:
        nm = float(optics.excitation_wavelength_nm)
        parts.append(f"light emitted: photons per metre and photon of {nm:.6g} nm (dotted)")
    return "; ".join(parts)


def _constituents(optics, verb):
    """The variables of constituents, with what the constituents are called."""
    said = {name: optics[name].attrs.get("long_name", "") for name in optics.data_vars}
    return {name: text[len(verb) :] for name, text in said.items() if text.startswith(verb)}


def _colours(known, names):
    """Each name has its own; those that have none take what others leave."""
    left = [colour for colour in COLOURS[:-1] if colour not in known.values()]
    unknown = [name for name in names if name not in known]
    return known | {name: left[i % len(left)] for i, name in enumerate(unknown)}


def _spectra(layer, limits, totals, verb, panel):
    """Coefficients of the layer, and those of its constituents that are above 0."""
    both = {**_constituents(layer, "absorption by "), **_constituents(layer, "scattering by ")}
    colours = _colours(OF_CONSTITUENT, dict.fromkeys(both.values()))
    for name, label, style in totals:
        fill = "black" if style == "-" else "white"
        _spectrum(panel, layer[name], label, linestyle=style, markerfacecolor=fill, **TOTAL)
    parts = _constituents(layer, verb)
    for name, constituent in parts.items():
        _spectrum(panel, layer[name], constituent, color=colours[constituent], linewidth=1.5)
    what = verb.removesuffix(" by ")
    if not panel.get_lines():
        say(panel, f"no {what}")
    _finish(panel, "wavelength [nm]", f"{what} coefficient [1/m]")
    _limit(panel, limits[[name for name, _, _ in totals] + list(parts)])


def _spectrum(panel, values, label, **look):
    values = values.where(values > 0)
    if values.sizes["wavelength"] <= FEW:  # and nothing is known of what lies between
        look |= {"marker": "o", "markersize": 5, "linewidth": 0.5}
    if values.notnull().any():
        panel.plot(values.wavelength, values, label=label, **look)


def _phases(layer, limits, panel):
    """Phase functions. What a file has at 0 is the mean over their core, which reaches to its next
    angle: flat there, and a step down to what stands behind it."""
    chosen = spread(layer.sizes["wavelength"], MOST_PHASES)
    shades = colormaps["viridis"](numpy.linspace(0.08, 0.9, len(chosen)))
    angles = layer.angle.values
    angles = numpy.concatenate([angles[:1], angles[1:2], angles[1:]])
    for index, shade in zip(chosen, shades):
        one = layer.phase_function_per_sr.isel(wavelength=index)
        values = numpy.concatenate([one.values[:1], one.values])
        panel.plot(angles, values, color=shade, label=f"{float(one.wavelength):.5g} nm")
    _finish(panel, "scattering angle [degree]", "phase function [1/sr]")
    values = limits.phase_function_per_sr.isel(wavelength=chosen).values
    panel.set_ylim(values[values > 0].min() / 2, 2 * values.max())
    # Between a linear axis, where the forward peak is a wall, and a logarithmic one, which has no
    # room for the light that comes back.
    panel.set_xscale("function", functions=(numpy.cbrt, lambda root: root**3))
    panel.set_xticks(ANGLES)
    panel.set_xlim(0, 180)
    low, high = panel.get_ylim()
    if high > 1000 * low:  # many decades of minor ticks take seconds to draw
        panel.minorticks_off()


def _emission(layer, limits, panel):
    """The lines that the layer emits, where they lie, and the light that excites them."""
    excitation = float(layer.excitation_wavelength_nm)
    panel.axvline(excitation, color="0.5", linestyle=":")
    processes = [str(process) for process in layer.process.values]
    colours = _colours(OF_PROCESS, processes)
    for process in processes:
        nm, per_m = _lines_of(layer, process)
        if len(nm) == 0:
            continue
        total = float(layer.emission_per_m.sel(process=process))
        thick, size = (2.2, 5) if len(nm) <= FEW else (0.8, 2)
        panel.vlines(nm, FLOOR, per_m, color=colours[process], linewidth=thick)
        label = f"{process}: {total:.3g} 1/m in all"
        panel.plot(nm, per_m, "o", color=colours[process], markersize=size, label=label)
    if len(panel.get_lines()) == 1:
        say(panel, NO_EMISSION)
    _finish(panel, "wavelength [nm]", "emission coefficient [1/m]")
    _limit(panel, limits[[name for name in ["emission_line_per_m"] if name in limits]])
    if "emission_wavelength_nm" in limits:
        drawn = [excitation, *limits.emission_wavelength_nm.values]
        margin = 0.1 * (max(drawn) - min(drawn))
        panel.set_xlim(min(drawn) - margin, max(drawn) + margin)


def _lines_of(layer, process):
    """Wavelengths and coefficients of a process's lines that are above 0."""
    if "emission_line" not in layer.sizes:
        return numpy.array([]), numpy.array([])
    per_m = layer.emission_line_per_m.values
    its = (layer.emission_line_process.values.astype(str) == process) & (per_m > 0)
    return layer.emission_wavelength_nm.values[its], per_m[its]


def _finish(panel, across, up):
    panel.set_xlabel(across)
    panel.set_ylabel(up)
    panel.set_yscale("log")
    grid(panel)


def _limit(panel, variables):
    """Holds all values above 0, but for those too many decades below the most; a decade or more."""
    values = [variables[name].values.ravel() for name in variables.data_vars]
    values = numpy.concatenate(values or [[]])
    values = values[values > 0]
    if len(values) > 0:
        low = min(values.min() / 2, values.max() / 20)
        panel.set_ylim(max(low, values.max() * 10.0**-DECADES), 3 * values.max())
