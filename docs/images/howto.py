"""Pictures of the how-tos, and the numbers in their texts."""

import math
import sys

import numpy
from look import ARROW, NOTE, WIDTH, emptied
from matplotlib.figure import Figure
from matplotlib.patches import Arc
from results import run

import photic
from photic import panels

SCENE = "minimal.toml"
NORTH_WEST = 315  # degrees of a compass, from where the wind comes
EAST = 90  # the same of the x axis
BEARINGS = tuple(range(0, 361, 15))
TILTS = {10: panels.COLOURS[0], 15: panels.COLOURS[2]}  # degrees
RADIUS = 1.0  # of the compass


def _wind_direction(bearing, x_axis=EAST):
    """The direction of a wind from there, as docs/howto/waves.md has it."""
    return (x_axis - bearing) % 360


def _along(bearing, x_axis=EAST):
    """The x and y of a compass bearing."""
    angle = math.radians(x_axis - bearing)
    return numpy.array([math.cos(angle), math.sin(angle)])


def wind():
    """A wind on the compass and in the scene, and the surface's own echo by where a tilted lidar looks."""
    drawing = Figure(figsize=(WIDTH, 3.9), layout="constrained")
    left, right = drawing.subplots(1, 2, width_ratios=[1, 1.35])
    _compass(left)
    for tilt, colour in TILTS.items():
        seen = [_glint(tilt, bearing) for bearing in BEARINGS]
        echo, error = (numpy.array(each) for each in zip(*seen))
        right.errorbar(BEARINGS, echo, error, color=colour, marker="o", markersize=4, label=f"tilted by {tilt} degrees")
        _say(f"{tilt} degrees: {', '.join(f'{b}: {e:.3g}' for b, e in zip(BEARINGS, echo))}")
    right.set(xticks=range(0, 361, 45), xlabel="compass bearing that the lidar looks to [degrees]", ylim=(0, None))
    right.set(ylabel="photons detected per photon emitted", title="The surface's own echo, wind of 8 m/s")
    for bearing, words in ((NORTH_WEST, "into\nthe wind"), (NORTH_WEST - 180, "with\nthe wind")):
        right.axvline(bearing, color="0.3", linewidth=1, linestyle="--")
        right.annotate(words, (bearing, 0.02), (4, 0), xycoords=right.get_xaxis_transform(), textcoords="offset points", **NOTE)
    right.legend(fontsize=8)
    emptied(right)
    return drawing


def _compass(panel):
    for bearing, name in ((0, "N"), (90, "E"), (180, "S"), (270, "W")):
        panel.text(*(1.13 * _along(bearing)), name, ha="center", va="center", fontweight="bold")
        panel.plot(*zip(0.97 * _along(bearing), 1.03 * _along(bearing)), color="0.3", linewidth=1)
    panel.add_patch(Arc((0, 0), 2 * RADIUS, 2 * RADIUS, color="0.6"))
    axis = {"arrowstyle": "-|>", "color": "0.15", "linewidth": 1.2, "shrinkA": 0, "shrinkB": 0}
    for bearing, name in ((EAST, "x"), (EAST - 90, "y")):
        panel.annotate("", 0.75 * _along(bearing), (0, 0), arrowprops=axis)
        panel.text(*(0.83 * _along(bearing)), name, ha="center", va="center")
    blue = panels.COLOURS[2]
    blows = axis | {"color": blue, "linewidth": 2.2}
    panel.annotate("", (0, 0), 0.95 * _along(NORTH_WEST), arrowprops=blows)
    panel.text(*(0.62 * _along(NORTH_WEST) + (-0.08, -0.08)), "wind", color=blue, ha="right", va="top")
    direction = _wind_direction(NORTH_WEST)
    panel.add_patch(Arc((0, 0), 0.7, 0.7, theta1=0, theta2=direction, color=panels.COLOURS[1], linewidth=1.8))
    at = 0.35 * _along(EAST - direction / 4)
    words = f"wind_direction_deg\n= {EAST} - {NORTH_WEST} = {EAST - NORTH_WEST},\nor {direction}"
    panel.annotate(words, at, (-0.55, -0.2), arrowprops=ARROW, va="top", **(NOTE | {"color": panels.COLOURS[1]}))
    panel.set(xlim=(-1.25, 1.25), ylim=(-1.25, 1.25), aspect="equal", title="A wind from the north-west")
    panel.set_axis_off()


def _glint(tilt_deg, bearing):
    """The surface's own echo and its standard error."""
    sine, cosine = math.sin(math.radians(tilt_deg)), math.cos(math.radians(tilt_deg))
    down = [*map(float, sine * _along(bearing)), -cosine]
    surface = {"model": "cox-munk", "wind_speed_m_s": 8.0, "wind_direction_deg": float(_wind_direction(NORTH_WEST))}
    changes = {"source.direction": down, "telescope.0.direction": down, "sea.surface": surface}
    changes["gates"] = {"depth_min_m": -2.0, "depth_max_m": 2.0, "depth_step_m": 4.0}
    one = run(SCENE, 1e5, "forward", **changes).sel(channel="elastic", process="surface")
    return float(one.echo_by_process.sum()), float(one.echo_by_process_standard_error.sum())


BED = 9.5  # m
BEDS = tuple(round(9.0 + 0.1 * k, 1) for k in range(13))
SHOWN = {9.5: "#7a5230", 10.5: panels.COLOURS[1]}  # middles of gates


def _over_a_bed(depth, photons):
    changes = {"sea.layer.0.bottom_depth_m": depth, "bottom": {"albedo": 0.15}}
    changes["gates"] = {"depth_max_m": 12.0, "depth_step_m": 1.0}
    return run(SCENE, photons, "bidirectional", **changes).sel(channel="elastic")


def bed_in_gate():
    """The echo of a bed in the middle of a gate, and what gates see of beds at other depths."""
    drawing = Figure(figsize=(WIDTH, 3.9), layout="constrained")
    left, right = drawing.subplots(1, 2)
    one = _over_a_bed(BED, 3e5)
    parts = {"elastic": ("the water", panels.COLOURS[0]), "bottom": ("the bed", SHOWN[9.5])}
    panels.processes(left, one, [(process, colour) for process, (_, colour) in parts.items()])
    panels.finish_lines(left, [one.echo_by_process.sel(process=process) for process in parts])
    left.axhspan(9, 10, color="0.9", zorder=0)
    left.text(0.03, 9.5, "gate of the bed", transform=left.get_yaxis_transform(), va="center", **NOTE)
    left.set(ylim=(12, 0), ylabel="depth [m]", title="A bed at 9.5 m, gates of 1 m")
    left.legend(handles=panels.lines_legend(list(parts.values()), False).handles, fontsize=8, loc="center left")
    every = [_over_a_bed(depth, 5e4) for depth in BEDS]
    for middle, colour in SHOWN.items():
        gate = int(middle)
        echo = [float(each.echo.isel(gate=gate)) for each in every]
        error = [float(each.echo_standard_error.isel(gate=gate)) for each in every]
        look = {"color": colour, "marker": "o", "markersize": 4, "label": f"gate from {gate} to {gate + 1} m"}
        right.errorbar(BEDS, echo, error, **look)
        _say(f"gate {gate}: {', '.join(f'{d}: {e:.3g}' for d, e in zip(BEDS, echo))}")
    right.axvline(BED, color="0.3", linewidth=1, linestyle="--")
    right.set(yscale="log", xlabel="depth of the bed [m]", ylabel="photons detected per photon emitted")
    right.set_title("Two gates, by the depth of the bed")
    right.legend(fontsize=8, loc="center left")
    for panel in (left, right):
        emptied(panel)
    return drawing


RATIOS = (0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9)
RATIO, ERROR = 0.5, 0.02  # one of them, and its standard deviation
ERRORS = tuple(numpy.geomspace(1e-4, 0.1, 10))
FILM = {"class": "strongly-absorbing-crude", "thickness_um": 1.0}
GATE = 2  # from 1 to 2 m
OIL = "#7a5230"
RUNS = {2e4: panels.COLOURS[1], 1e6: panels.COLOURS[0]}  # photons


def _over_a_film(photons):
    clean = [{"name": "clean", "set": {"oil.thickness_um": 0}}]
    waves = {"model": "cox-munk", "wind_speed_m_s": 5.0}
    changes = {"source.wavelength_nm": 355.0, "channel": [{"name": "raman", "process": "raman"}]}
    changes |= {"oil": FILM, "environment": clean, "sea.surface": waves}
    changes["gates"] = {"depth_min_m": -1.0, "depth_max_m": 5.0, "depth_step_m": 1.0}
    return run(SCENE, photons, "forward", slice(None), **changes)


def film():
    """Raman echoes of one run, and the thickness of a measured ratio with its error."""
    drawing = Figure(figsize=(WIDTH, 3.6), layout="constrained")
    left, middle, right = drawing.subplots(1, 3)
    _raman(left, _over_a_film(max(RUNS)).isel(telescope=0).sel(channel="raman"))
    found = [_thickness(max(RUNS), ratio, ERROR) for ratio in RATIOS]
    _say(f"thicknesses: {', '.join(f'{r}: {v:.3f} +- {e:.3f}' for r, (v, e) in zip(RATIOS, found))}")
    look = {"capsize": 3, "linestyle": "none", "marker": "o", "markersize": 4}
    middle.errorbar(RATIOS, *zip(*found), color=OIL, **look)
    middle.set(xlabel="measured E / W", ylabel="thickness [um]", title=f"E / W \u00b1 {ERROR}", ylim=(0, None))
    for photons, colour in RUNS.items():
        errors = [_thickness(photons, RATIO, error)[1] for error in ERRORS]
        label = f"{photons:,.0f} photons".replace(",", "\u2009")
        right.plot(ERRORS, errors, color=colour, marker="o", markersize=4, label=label)
        _say(f"{label}: {', '.join(f'{e:.4f}: {found:.4f}' for e, found in zip(ERRORS, errors))}")
    per_um = float(_over_a_film(max(RUNS)).film_attenuation.squeeze()) * 1e-6
    alone = numpy.array(ERRORS) / RATIO / per_um
    right.plot(ERRORS, alone, color="0.3", linewidth=1, linestyle="--", label="measurement alone")
    right.set(xscale="log", yscale="log", xlabel="standard deviation of E / W")
    right.set(ylabel="standard error of the thickness [um]", title=f"Both errors, E / W = {RATIO}")
    right.legend(fontsize=8, loc="upper left", handlelength=1.4)
    for panel in (left, middle, right):
        emptied(panel)
    return drawing


def _raman(panel, one):
    """The echo under the film, and that of the clean sea."""
    clean = one.sel(environment="clean")
    panels.line(panel, one, clean.environment_echo, clean.environment_echo_standard_error, panels.COLOURS[2])
    panels.line(panel, one, one.echo, one.echo_standard_error, OIL)
    panels.finish_lines(panel, [one.echo, clean.environment_echo])
    names = [("W: the clean sea", panels.COLOURS[2]), ("E: under 1 um of oil", OIL)]
    panel.legend(handles=panels.lines_legend(names, False).handles, fontsize=8, loc="upper left")
    panel.set(ylim=(5, -1), ylabel="depth [m]; above the line: air", title="Raman light of one run")
    panel.set_xlabel("photons per photon emitted")
    panel.axhline(0, **panels.SEA_LEVEL)


def _thickness(photons, ratio, error):
    found = photic.oil_thickness(_over_a_film(photons), "clean", ratio=ratio, ratio_error=error)
    one = found.isel(telescope=0, gate=GATE)
    return float(one.thickness), float(one.thickness_standard_error)


def _say(words):
    print(words, file=sys.stderr)
