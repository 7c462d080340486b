"""Pictures of results, each from runs of its own."""

import functools
import json
import math
import os
import subprocess
import warnings

import numpy
from look import ARROW, NOTE, SCENES, WIDTH, downwards, emptied
from matplotlib import colormaps
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.ticker import LogLocator

import photic
from photic import panels, plot

ELASTIC, RAMAN, CHLOROPHYLL = panels.COLOURS[:3]
ORANGE, BLUE = panels.COLOURS[1:3]
LARGEST_ERROR = 0.10  # above it a gate is flagged large_error: src/tally/result.cpp


PROGRAM = os.environ.get("PHOTIC_PROGRAM", SCENES.parent / "build/release/apps/photic/photic")
SHIP = 5e5  # photons of the runs that two pictures share


def run(scene, photons, estimator="auto", telescope=0, seed=1, **changes):
    """The echo that a telescope of a scene sees; changes: values by their paths. Nothing but the
    photons ends it, not the time, so that it is the same anywhere."""
    changes["simulation"] = {"seed": seed, "photons": int(photons / run.fewer), "estimator": estimator}
    return _run(scene, json.dumps(changes)).isel(telescope=telescope)


run.fewer = 1  # divides all numbers of photons, for drafts


@functools.cache
def _run(scene, changes):
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # of gates that have not converged: the pictures show them
        return photic.run(SCENES / scene, set=json.loads(changes))


def ship():
    """The figure that `photic plot` draws."""
    result = run("ship.toml", SHIP).expand_dims("telescope")
    return plot.figure([result], ["ship"], width_mm=25.4 * WIDTH)


def echo():
    result = run("ship.toml", 1e5)
    drawing = Figure(figsize=(WIDTH, 5.0), layout="constrained")
    left, right = drawing.subplots(1, 2, sharey=True, width_ratios=[2.3, 1])
    elastic, chlorophyll = (result.sel(channel=name) for name in ("elastic", "chlorophyll"))
    for one, colour in ((elastic, ELASTIC), (chlorophyll, CHLOROPHYLL)):
        panels.line(left, one, one.echo, one.echo_standard_error, colour)
    panels.finish_lines(left, [elastic.echo, chlorophyll.echo])
    left.set_title("Echoes of a ship lidar")
    _explain_lines(left, elastic, chlorophyll)
    _explain_gate(left, elastic, 15)
    _explain_orders(right, elastic)
    downwards(left, 50)
    for panel in (left, right):
        emptied(panel)
    return drawing


def _explain_lines(panel, elastic, chlorophyll):
    bold = {"ha": "right", "va": "center", "fontweight": "bold"}
    panel.text(float(elastic.echo[3]) / 4, 7, "elastic", color=ELASTIC, **bold)
    words = "fluorescence\nof chlorophyll"
    panel.text(float(chlorophyll.echo[3]) / 6, 7, words, color=CHLOROPHYLL, **bold)
    words = "light is lost on its way down\nand up: absorbed, scattered"
    at = (float(elastic.echo[10]) / 1.5, float(elastic.gate_depth[10]))
    panel.annotate(words, at, (1.5e-15, 24.5), arrowprops=ARROW, **NOTE)
    faded = numpy.flatnonzero((~chlorophyll.converged & (chlorophyll.echo > 0)).values)
    if len(faded) > 0:
        k = faded[len(faded) // 2]
        at = (1.3 * float(chlorophyll.echo[k]), float(chlorophyll.gate_depth[k]))
        words = "faded, open circles:\ngates that have\nnot converged"
        panel.annotate(words, at, (3e-17, 45), arrowprops=ARROW, **NOTE)


def _explain_gate(panel, one, k):
    """One gate, and its echo once more where its error is seen."""
    top, bottom = one.gate_depth_bounds.values[k]
    echo, error = float(one.echo[k]), float(one.echo_standard_error[k])
    panel.axhspan(top, bottom, color="0.87", zorder=0)
    panel.text(1e-15, (top + bottom) / 2, f"a gate: {top:.0f} to {bottom:.0f} m", va="center", **NOTE)
    look = {"color": ELASTIC, "marker": "o", "markersize": 6}
    panel.plot(echo, float(one.gate_depth[k]), **look)
    zoom = panel.inset_axes([0.74, 0.09, 0.25, 0.12])
    zoom.set_facecolor("0.87")
    power = math.floor(math.log10(echo))
    unit = 10.0**power
    zoom.errorbar(echo / unit, 0, xerr=error / unit, capsize=4, **look)
    zoom.set(xlim=((echo - 5 * error) / unit, (echo + 5 * error) / unit), yticks=[])
    zoom.set_xticks([echo / unit], [rf"${echo / unit:.3g} \times 10^{{{power}}}$"])
    said = f"its echo \u00b1 one\nstandard error, {100 * error / echo:.1f} %"
    zoom.set_title(said, fontsize=8, color=NOTE["color"])
    line = {**ARROW, "arrowstyle": "-"}
    panel.annotate("", (echo, bottom), (0.80, 0.31), textcoords="axes fraction", arrowprops=line)


def _explain_orders(panel, one):
    share = (100 * one.echo_by_order.sel(order=1) / one.echo).values
    depth = one.gate_depth.values
    panel.plot(share, depth, color=ELASTIC, linewidth=1.8)
    panel.fill_betweenx(depth, share, 100, color=ELASTIC, alpha=0.18, linewidth=0)
    half = numpy.interp(-50, -share, depth)
    panel.plot([50, 50], [0, half], color="0.5", linewidth=0.8, linestyle="--")
    panel.plot(50, half, "o", color="black", markersize=5)
    words = f"from {half:.0f} m down\nmost light was\nscattered more\nthan once"
    panel.annotate(words, (50, half), (44, half + 12), arrowprops=ARROW, **NOTE)
    panel.text(8, 4, "scattered\nonce", va="center", **NOTE)
    panel.set(xlim=(0, 100), xlabel="share of the elastic echo [%]")
    panel.set_title("Orders of scattering")


def flags():
    """Runs of the forward estimator, whose rare large scores are what the flags are for."""
    runs = [run("ship.toml", photons, "forward") for photons in (3e5, 3e6)]
    short, long = (one.sel(channel="elastic") for one in runs)
    truth = run("ship.toml", SHIP).sel(channel="elastic")
    drawing = Figure(figsize=(WIDTH, 4.8), layout="constrained")
    left, middle, *strips = drawing.subplots(1, 4, sharey=True, width_ratios=[3, 2.4, 0.8, 0.8])
    looks = [(short, ORANGE, "first run"), (long, BLUE, "ten times\nlonger")]
    for one, colour, _ in looks:
        depth, good = one.gate_depth.values, one.converged.values
        error, ratio = 100 * one.echo_standard_error / one.echo, one.echo / truth.echo.values
        _gate_by_gate(left, error.values, depth, good, colour)
        _gate_by_gate(middle, ratio.values, depth, good, colour)
    left.axvline(100 * LARGEST_ERROR, color="0.3", linewidth=1, linestyle="--")
    left.text(110 * LARGEST_ERROR, 1.6, f"{100 * LARGEST_ERROR:.0f} %", **NOTE)
    left.set(xscale="log", xlabel="relative standard error [%]", title="The error that a run reports")
    left.xaxis.set_major_formatter("{x:g}")
    middle.axvline(1, color="0.3", linewidth=1, linestyle="--")
    middle.set(xlabel="ratio to the converged echo", title="How far its echo is off")
    for panel, (one, colour, name) in zip(strips, looks):
        _strip(panel, one, colour, [short, long])
        panel.set_title(name, fontsize=8.5, color=colour)
    downwards(left, 50)
    for panel in (left, middle):
        emptied(panel)
    lines = [(f"{photons_of(one):,} photons".replace(",", "\u2009"), colour) for one, colour, _ in looks]
    handles = panels.lines_legend(lines, False).handles
    look = {"color": "0.2", "marker": "o", "markersize": 5, "linestyle": "none"}
    handles += [Line2D([], [], label="converged", **look)]
    handles += [Line2D([], [], label="flagged", markerfacecolor="white", **look)]
    left.legend(handles=handles, fontsize=8, loc="lower left", framealpha=0.9)
    return drawing


def photons_of(result):
    return int(result.attrs["photons"])


def _gate_by_gate(panel, values, depth, good, colour, label=None):
    """A line with a full circle at each gate that has converged, an open one at the others."""
    panel.plot(values, depth, color=colour, linewidth=1, alpha=0.6)
    look = {"color": colour, "linestyle": "none", "marker": "o", "markersize": 5}
    panel.plot(values[good], depth[good], label=label, **look)
    panel.plot(values[~good], depth[~good], markerfacecolor="white", **look)


def _reasons(one):
    """The meanings of flags, each with the gates that have it."""
    named = one.convergence_flags.attrs
    flags = one.convergence_flags.values
    pairs = zip(named["flag_meanings"].split(), named["flag_masks"])
    return {meaning: (flags & mask) > 0 for meaning, mask in pairs}


def _strip(panel, one, colour, every):
    """A column for each reason that any of the runs has, with a mark at each gate it flags."""
    seen = [name for name in _reasons(one) if any(_reasons(each)[name].any() for each in every)]
    for k, name in enumerate(seen):
        for (top, bottom), raised in zip(one.gate_depth_bounds.values, _reasons(one)[name]):
            if raised:
                panel.fill_between([k - 0.4, k + 0.4], top + 0.2, bottom - 0.2, color=colour, linewidth=0)
    panel.set_xlim(-0.6, len(seen) - 0.4)
    panel.set_xticks(range(len(seen)), seen, rotation=90, fontsize=8)
    panel.tick_params(left=False, labelleft=False, bottom=False)
    panel.spines[["top", "right", "left"]].set_visible(False)


WATERS = {
    "chlorophyll 0.05 mg/m³": {"chlorophyll_mg_m3": 0.05},
    "chlorophyll 0.07 mg/m³": {"chlorophyll_mg_m3": 0.07},
    "chlorophyll 0.15 mg/m³": {"chlorophyll_mg_m3": 0.15},
    "chlorophyll 0.20 mg/m³": {"chlorophyll_mg_m3": 0.20},
    "CDOM 0.02 1/m added": {"cdom_a440_per_m": 0.02},
    "minerals 0.05 g/m³ added": {"minerals_g_m3": 0.05},
}
ONE_PER_CENT = "1 % more chlorophyll"
WATERS_TO = 24.0  # m


def waters():
    changes = WATERS | {ONE_PER_CENT: {"chlorophyll_mg_m3": 0.101}}
    environments = [
        {"name": name, "set": {f"sea.layer.0.{key}": value for key, value in change.items()}}
        for name, change in changes.items()
    ]
    result = run("ship.toml", 2e5, **{"environment": environments, "gates.depth_max_m": WATERS_TO})
    drawing = Figure(figsize=(WIDTH, 4.8), layout="constrained")
    above, below = drawing.subfigures(2, 1, height_ratios=[6, 1])
    *several, alone = above.subplots(1, 3, sharey=True)
    shown = result.sel(environment=list(WATERS))
    colours = [*colormaps["YlGn"]([0.42, 0.6, 0.8, 1.0]), ORANGE, "#7a5230"]
    for panel, channel in zip(several, ("elastic", "chlorophyll")):
        panels.changes(panel, shown.sel(channel=channel), colours)
        panel.set_title(f"{channel} echo")
    _one_per_cent(alone, result.sel(channel="elastic", environment=ONE_PER_CENT))
    downwards(several[0], WATERS_TO)
    for panel in (*several, alone):
        emptied(panel)
    faded = not (shown.environment_converged & shown.converged).sel(channel=["elastic", "chlorophyll"]).all()
    handles = panels.lines_legend(list(zip(WATERS, colours)), faded).handles
    scene = "the scene: chlorophyll 0.10 mg/m³"
    handles.insert(2, Line2D([], [], color="black", linewidth=1.2, label=scene))
    below.legend(handles=handles, loc="center", ncols=3, fontsize=8, frameon=False)
    return drawing


def _one_per_cent(panel, one):
    """A small change, and what of it two runs with other photons would have shown."""
    change = 100 * (one.environment_difference / one.echo).values
    own = 100 * (one.environment_difference_standard_error / one.echo).values
    apart = 100 * (math.sqrt(2) * one.echo_standard_error / one.echo).values
    depth = one.gate_depth.values
    for error, look in ((apart, {"color": "0.85"}), (own, {"color": ELASTIC, "alpha": 0.4})):
        width = panels.INTERVAL_95 * error
        label = "95 % band of\ntwo separate runs" if error is apart else None
        panel.fill_betweenx(depth, change - width, change + width, linewidth=0, label=label, **look)
    panel.plot(change, depth, color=ELASTIC, linewidth=1.8, label="the same photons")
    panel.axvline(0, color="black", linewidth=1.2)
    panel.set(xlabel="change from the scene's echo [%]", title="elastic: " + ONE_PER_CENT)
    panel.locator_params(axis="x", nbins=5)
    panel.legend(fontsize=8, loc="upper left", framealpha=0.9)


LAYERS_TO = 20.0  # m


def layers():
    """A profile of chlorophyll, and the ratio of its echo to that of Raman light."""
    result = run("three-layers.toml", 3e5, **{"gates.depth_max_m": LAYERS_TO})
    raman, chlorophyll = (result.sel(channel=name) for name in ("raman", "chlorophyll"))
    tops, emitted, excess = _emission(SCENES / "three-layers.toml")
    depth = chlorophyll.gate_depth.values
    ratio = (chlorophyll.echo / raman.echo.values).values * numpy.exp(excess * depth)
    ratio *= emitted[0] / ratio[0]
    drawing = Figure(figsize=(WIDTH, 4.6), layout="constrained")
    left, right = drawing.subplots(1, 2, sharey=True)
    for one, colour in ((raman, RAMAN), (chlorophyll, CHLOROPHYLL)):
        panels.line(left, one, one.echo, one.echo_standard_error, colour)
    panels.finish_lines(left, [raman.echo, chlorophyll.echo])
    left.xaxis.set_major_locator(LogLocator(numticks=6))
    left.set_title("Two echoes of three layers")
    names = [("Raman scattering by water", RAMAN), ("fluorescence of chlorophyll", CHLOROPHYLL)]
    good = raman.converged.values & chlorophyll.converged.values
    left.legend(handles=panels.lines_legend(names, not good.all()).handles, fontsize=8, loc="lower right")
    look = {"orientation": "horizontal", "baseline": None, "color": "0.25", "linewidth": 1.6}
    right.stairs(emitted, [*tops, LAYERS_TO], label="of the light that\nlayers emit", **look)
    label = "of the echoes, less\nthe absorption of\npure water"
    _gate_by_gate(right, ratio, depth, good, CHLOROPHYLL, label)
    right.set(xscale="log", xlim=(0.03, 5), xlabel="ratio of fluorescence to Raman light", title="The ratio shows the layers")
    right.legend(fontsize=8, loc="lower right")
    late = chlorophyll.echo_by_depth[-4]
    share = float(late.where(late.depth < tops[-1]).sum() / late.sum())
    words = f"delayed light: {100 * share:.0f} % was\nlast scattered in the\nlayers above"
    right.annotate(words, (ratio[-4], depth[-4]), (0.033, 12), arrowprops=ARROW, va="center", **NOTE)
    downwards(left, LAYERS_TO)
    for panel in (left, right):
        emptied(panel)
    return drawing


WIDE_VIEW = 1  # of the telescopes of bathymetric.toml
ALBEDOS = {0.05: "#7a5230", 0.3: ORANGE}  # beside the scene's 0.15


def bed():
    """The echo of a sea bed upon that of the water, and what other beds make of it."""
    environments = [{"name": str(albedo), "set": {"bottom.albedo": albedo}} for albedo in ALBEDOS]
    gates = {"depth_min_m": 9.65, "depth_max_m": 14.65, "depth_step_m": 0.5}  # the bed in the middle of one
    result = run("bathymetric.toml", 4e6, "bidirectional", WIDE_VIEW, environment=environments, gates=gates)
    one = result.sel(channel="elastic")
    drawing = Figure(figsize=(WIDTH, 4.6), layout="constrained")
    left, right = drawing.subplots(1, 2, sharey=True)
    parts = {"elastic": ("scattered in the water alone", ELASTIC), "bottom": ("touched the bed", "#7a5230")}
    panels.processes(left, one, [(process, colour) for process, (_, colour) in parts.items()])
    panels.finish_lines(left, [one.echo_by_process.sel(process=process) for process in parts])
    left.set_title("Light of two processes")
    left.legend(handles=panels.lines_legend(list(parts.values()), False).handles, fontsize=8, loc="upper left")
    depth = one.gate_depth.values
    for albedo, colour in ALBEDOS.items():
        other = one.sel(environment=str(albedo))
        good = (one.converged & other.environment_converged).values
        _gate_by_gate(right, (other.environment_echo / one.echo).values, depth, good, colour, f"albedo {albedo}")
    right.axvline(1, color="black", linewidth=1.2, label="the scene: 0.15")
    right.plot([], [], "o", color="0.4", markerfacecolor="white", markersize=5, label="not converged")
    right.set(xlabel="ratio to the scene's echo", title="Other beds, the same photons", xlim=(0, 2.2))
    right.legend(fontsize=8, loc="upper left")
    left.set(xlim=(5e-14, 3e-10), ylim=(15, 9), ylabel="depth [m]")
    for panel in (left, right):
        panel.axhline(12.4, color="0.4", linestyle=":", linewidth=1.0)
        emptied(panel)
    left.text(0.03, 12.35, "the bed", transform=left.get_yaxis_transform(), **NOTE)
    return drawing


WINDS = (1, 2, 3, 4, 5, 6, 8, 10, 12, 15)  # m/s
TILTS = (0, 2, 5, 8, 10, 12, 15, 18, 20, 25, 30)  # degrees


def _over_waves(photons, tilt_deg=0.0, **surface):
    """The elastic echo of the ship's lidar, tilted, over a surface: one gate above the sea."""
    sine, cosine = math.sin(math.radians(tilt_deg)), math.cos(math.radians(tilt_deg))
    down = [sine, 0.0, -cosine]
    changes = {"source.direction": down, "telescope.0.direction": down, "sea.surface": surface}
    changes |= {"gates.depth_min_m": -2.0, "gates.depth_max_m": 10.0, "gates.depth_step_m": 2.0}
    return run("ship.toml", photons, "forward", **changes).sel(channel="elastic")


def waves():
    """The surface's own echo by the wind and by the tilt, and what waves make of that of the water."""
    drawing = Figure(figsize=(WIDTH, 4.2), layout="constrained")
    left, right = drawing.subplots(1, 2)
    winds = [_over_waves(1e6, model="cox-munk", wind_speed_m_s=float(wind)) for wind in WINDS]
    surface = [float(one.echo_by_process.sel(process="surface").sum()) for one in winds]
    left.plot(WINDS, surface, color="0.35", marker="o", markersize=4, label="the surface's own")
    for gate, colour in ((1, ELASTIC), (3, BLUE)):
        water = [one.echo_by_process.sel(process="elastic").isel(gate=gate) for one in winds]
        error = [one.echo_by_process_standard_error.sel(process="elastic").isel(gate=gate) for one in winds]
        top, bottom = winds[0].gate_depth_bounds.values[gate]
        look = {"color": colour, "marker": "o", "markersize": 4, "label": f"water, {top:.0f} to {bottom:.0f} m"}
        left.errorbar(WINDS, [float(w) for w in water], yerr=[float(e) for e in error], **look)
    left.set(yscale="log", xlabel="wind [m/s]", ylabel="photons detected per photon emitted", title="Echoes by the wind")
    left.legend(fontsize=8, loc="center right")
    kinds = {
        "5 m/s": (dict(model="cox-munk", wind_speed_m_s=5.0, whitecaps=False), ELASTIC),
        "10 m/s": (dict(model="cox-munk", wind_speed_m_s=10.0, whitecaps=False), BLUE),
        "10 m/s, with whitecaps": (dict(model="cox-munk", wind_speed_m_s=10.0), ORANGE),
        "10 m/s, slick": (dict(model="cox-munk", wind_speed_m_s=10.0, slick=True), "0.35"),
    }
    for name, (kind, colour) in kinds.items():
        tilted = [_over_waves(1e5, tilt, **kind) for tilt in TILTS]
        echo = [float(one.echo_by_process.sel(process="surface").sum()) for one in tilted]
        right.plot(TILTS, echo, color=colour, marker="o", markersize=4, label=name)
    right.set(yscale="log", xlabel="tilt of laser and telescope [degrees]", title="The surface's own echo by the tilt")
    right.legend(fontsize=8, loc="lower left")
    for panel in (left, right):
        emptied(panel)
    return drawing


def _emission(scene):
    """The layers' upper edges [m]; in each the ratio of chlorophyll's light to Raman light emitted;
    and by how much pure water absorbs the first more than the second [1/m]."""
    line = [PROGRAM, "optics", str(scene), "--json"]
    shown = json.loads(subprocess.run(line, check=True, capture_output=True, text=True).stdout)
    emitted = []
    for layer in shown["layers"]:
        of = {process: each["coefficient_per_m"] for process, each in layer["emission"].items()}
        emitted.append(of["chlorophyll"] / of["raman"])
    _, raman, chlorophyll = shown["layers"][0]["parts"]["water"]["a_per_m"]
    return [layer["depth_m"] for layer in shown["layers"]], emitted, chlorophyll - raman
