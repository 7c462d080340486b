"""Drawing what `photic optics` wrote: absorption and scattering against wavelength, phase functions
against angle, and emitted light; a row for each layer. Air emits nothing: the lowest layer is at the
bottom. Spectra of an oil and transmittances have a panel for each unit."""

import numpy
from matplotlib import colormaps
from matplotlib.figure import Figure

from photic import panels
from photic.plot import COLOURS, LOOK

MOST_LAYERS = 6  # rows of a figure; of more layers so many are drawn, from the first to the last
MOST_PHASES = 5  # phase functions in a panel, of so many wavelengths
FEW = 12  # points or lines that are drawn one by one
DECADES = 6  # of an axis: what is less than all of them below the most is not seen
OF_CONSTITUENT = {
    **{"water": "#0072B2", "phytoplankton": "#009E73", "CDOM": "#D55E00"},
    **{"molecules": "#0072B2", "ozone": "#009E73", "aerosols": "#D55E00"},
}
OF_PROCESS = {"raman": "#0072B2", "chlorophyll": "#009E73", "cdom": "#D55E00"}
UNITS = {"m-1": "1/m", "nm-1": "1/nm"}
FLOOR = 1e-30  # 0 for a logarithmic axis
ANGLES = [0, 1, 10, 30, 60, 90, 120, 180]
TOTAL = {"color": "black", "linewidth": 2.0}
NO_EMISSION = "no light of other wavelengths"


def figure(optics, title=None):
    """optics: what photic.open gives for a file of `photic optics`; title: default the scene's."""
    axis = _axis(optics)
    layers = _spread(optics.sizes[axis], MOST_LAYERS)
    layers = layers[::-1] if axis == "altitude" else layers
    panels_across = 4 if "process" in optics.sizes else 3
    drawing = Figure(figsize=(4.5 * panels_across, 1.3 + 3.9 * len(layers)), **LOOK)
    together = "col" if axis == "depth" else "none"  # air thins out by more than an axis can show
    grid = drawing.subplots(
        len(layers), panels_across, sharex="col", sharey=together, squeeze=False
    )
    for row, layer in zip(grid, layers):
        absorption, scattering, phases = row[:3]
        one = optics.isel({axis: layer})
        name = _name(one)
        _spectra(absorption, one, [("a_per_m", "all", "-")], "absorption by ")
        totals = [("b_per_m", "all", "-"), ("bb_per_m", "all, backwards", "--")]
        _spectra(scattering, one, totals, "scattering by ")
        _phases(phases, one)
        for emission in row[3:]:
            _emission(emission, one)
        titles = ("absorption", "scattering", "phase function", "light emitted")
        for panel, what in zip(row, titles):
            panel.set_title(panels.text(f"{name}: {what}"), fontsize=10.5, loc="left")
    _finish(grid)
    for row, layer in zip(grid, layers):
        _limit_row(row, optics if together == "col" else optics.isel({axis: layer}))
    title = optics.attrs["title"] if title is None else title
    drawing.suptitle(panels.text(title), x=0.01, ha="left", fontsize=14, fontweight="bold")
    caption = panels.text(_caption(optics, len(layers)))
    drawing.supxlabel(caption, x=0.01, ha="left", fontsize=8, color="0.3")
    return drawing


def spectra(table, title=None):
    """table: what photic.open gives for spectra of an oil, or for transmittances."""
    units = list(dict.fromkeys(table[name].attrs["units"] for name in _curves(table)))
    drawing = Figure(figsize=(6.0 * len(units), 5.2), **LOOK)
    row = drawing.subplots(1, len(units), squeeze=False)[0]
    for panel, unit in zip(row, units):
        names = [name for name in _curves(table) if table[name].attrs["units"] == unit]
        names.sort(key=lambda name: -float(abs(table[name] - table[name][0]).max()))
        for name, colour in zip(names[: len(COLOURS) - 1], COLOURS):
            label = panels.text(table[name].attrs["long_name"])
            _spectrum(panel, table[name], label, color=colour, linewidth=1.5)
        panel.set_xlabel("wavelength [nm]", fontsize=9)
        panel.set_ylabel(panels.text(f"[{UNITS.get(unit, unit)}]"), fontsize=9)
        panel.grid(which="major", color="0.88", linewidth=0.7)
        if unit == "m-1":
            panel.set_yscale("log")
        if panel.get_legend_handles_labels()[0]:
            panel.legend(loc="best", fontsize=8.5, framealpha=0.92)
    title = table.attrs["title"] if title is None else title
    drawing.suptitle(panels.text(title), x=0.01, ha="left", fontsize=14, fontweight="bold")
    caption = panels.text(table.attrs["source"] + _numbers(table))
    drawing.supxlabel(caption, x=0.01, ha="left", fontsize=8, color="0.3")
    return drawing


def _curves(table):
    return [name for name in table.data_vars if table[name].dims == ("wavelength",)]


def _numbers(table):
    """What there is one number of."""
    said = [
        f"; {table[name].attrs['long_name']}: {float(table[name]):.4g} {table[name].attrs['units']}"
        for name in table.data_vars
        if not table[name].dims
    ]
    return "".join(said).replace(" 1;", ";").removesuffix(" 1")


def _axis(optics):
    return "altitude" if "altitude" in optics.sizes else "depth"


def _spread(count, most):
    """Indices below count: all, or so many of them, evenly from the first to the last."""
    return numpy.unique(numpy.linspace(0, count - 1, min(count, most)).round().astype(int))


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
        parts.append(f"{drawn} of its {layers} layers")
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


def _spectra(panel, layer, totals, verb):
    """Coefficients of the layer, and those of its constituents that are above 0."""
    both = {**_constituents(layer, "absorption by "), **_constituents(layer, "scattering by ")}
    colours = _colours(OF_CONSTITUENT, dict.fromkeys(both.values()))
    for name, label, style in totals:
        fill = "black" if style == "-" else "white"
        _spectrum(panel, layer[name], label, linestyle=style, markerfacecolor=fill, **TOTAL)
    for name, constituent in _constituents(layer, verb).items():
        look = {"color": colours[constituent], "linewidth": 1.5}
        _spectrum(panel, layer[name], panels.text(constituent), **look)


def _spectrum(panel, values, label, **look):
    values = values.where(values > 0)
    if values.sizes["wavelength"] <= FEW:  # and nothing is known of what lies between
        look |= {"marker": "o", "markersize": 5, "linewidth": 0.5}
    if values.notnull().any():
        panel.plot(values.wavelength, values, label=label, **look)


def _phases(panel, layer):
    chosen = _spread(layer.sizes["wavelength"], MOST_PHASES)
    shades = colormaps["viridis"](numpy.linspace(0.08, 0.9, len(chosen)))
    for index, shade in zip(chosen, shades):
        one = layer.phase_function_per_sr.isel(wavelength=index)
        panel.plot(one.angle, one, color=shade, label=f"{float(one.wavelength):.5g} nm")


def _emission(panel, layer):
    """The lines that the layer emits, where they lie, and the light that excites them."""
    panel.axvline(float(layer.excitation_wavelength_nm), color="0.5", linestyle=":")
    processes = [str(process) for process in layer.process.values]
    colours = _colours(OF_PROCESS, processes)
    for process in processes:
        nm, per_m = _lines_of(layer, process)
        if len(nm) == 0:
            continue
        total = float(layer.emission_per_m.sel(process=process))
        thick, size = (2.2, 5) if len(nm) <= FEW else (0.8, 2)
        panel.vlines(nm, FLOOR, per_m, color=colours[process], linewidth=thick)
        label = panels.text(f"{process}: {total:.3g} 1/m in all")
        panel.plot(nm, per_m, "o", color=colours[process], markersize=size, label=label)


def _lines_of(layer, process):
    """Wavelengths and coefficients of a process's lines that are above 0."""
    if "emission_line" not in layer.sizes:
        return numpy.array([]), numpy.array([])
    per_m = layer.emission_line_per_m.values
    its = (layer.emission_line_process.values.astype(str) == process) & (per_m > 0)
    return layer.emission_wavelength_nm.values[its], per_m[its]


def _finish(grid):
    """Axes and legends. All panels of a column have the same wavelengths or angles."""
    labels = [
        ("wavelength [nm]", "absorption coefficient [1/m]"),
        ("wavelength [nm]", "scattering coefficient [1/m]"),
        ("scattering angle [degree]", "phase function [1/sr]"),
        ("wavelength [nm]", "emission coefficient [1/m]"),
    ]
    for panel, (across, up) in zip(grid[-1], labels):
        panel.set_xlabel(across, fontsize=9)
    for row in grid:
        for panel, (_, up) in zip(row, labels):
            panel.set_ylabel(up, fontsize=9)
            panel.set_yscale("log")
            panel.grid(which="major", color="0.88", linewidth=0.7)
            panel.set_axisbelow(True)
        for panel, nothing in zip(row, ("no absorption", "no scattering", "", NO_EMISSION)):
            if panel.get_legend_handles_labels()[0]:
                panel.legend(loc="best", fontsize=8.5, framealpha=0.92)
            else:
                panel.text(0.5, 0.5, nothing, transform=panel.transAxes, ha="center", color="0.3")
        # Between a linear axis, where the forward peak is a wall, and a logarithmic one, which has
        # no room for the light that comes back.
        row[2].set_xscale("function", functions=(numpy.cbrt, lambda root: root**3))
        row[2].set_xticks(ANGLES)
        row[2].set_xlim(0, 180)
        low, high = row[2].get_ylim()
        if high > 1000 * low:  # many decades of minor ticks take seconds to draw
            row[2].minorticks_off()
        for emission in row[3:]:
            emission.margins(x=0.1)


def _limit_row(row, optics):
    a, b = _constituents(optics, "absorption by "), _constituents(optics, "scattering by ")
    _limit(row[0], optics[["a_per_m", *a]])
    _limit(row[1], optics[["b_per_m", "bb_per_m", *b]])
    for emission in row[3:]:
        _limit(emission, optics[[name for name in ["emission_line_per_m"] if name in optics]])


def _limit(panel, variables):
    """Holds all values above 0, but for those too many decades below the most; a decade or more."""
    values = [variables[name].values.ravel() for name in variables.data_vars]
    values = numpy.concatenate(values or [[]])
    values = values[values > 0]
    if len(values) > 0:
        low = min(values.min() / 2, values.max() / 20)
        panel.set_ylim(max(low, values.max() * 10.0**-DECADES), 3 * values.max())
