"""Pictures of what the air does to echoes, and the numbers on it in the guide."""

import sys

from look import ARROW, NOTE, WIDTH, emptied
from matplotlib.figure import Figure
from results import run

from photic import panels

VISIBILITIES = {40.0: "#0072B2", 23.0: "#E69F00", 10.0: "#D55E00"}  # km
CLEAR = 23.0
AMOUNTS = {None: "0.35", 0.12: panels.COLOURS[2], 0.5: panels.COLOURS[1]}  # aerosol optical depths; None: no air
HEIGHT = 3000.0  # m
PARTS = {
    "elastic": ("light that has\nbeen in the water", panels.COLOURS[0]),
    "air": ("light of\nthe air alone", panels.OF_AIR),
}


def _through(scene, photons, visibility_km, low, high, step):
    """The elastic echo of an upright lidar through maritime air, in gates between two depths."""
    changes = {
        "atmosphere": {"profile": "us-standard", "aerosol": "maritime", "visibility_km": visibility_km},
        "channel": [{"name": "elastic", "process": "elastic"}],
        "gates": {"depth_min_m": low, "depth_max_m": high, "depth_step_m": step},
    }
    return run(scene, photons, "forward", **changes).sel(channel="elastic")


def _finish(panel, low, high, echoes):
    panels.finish_lines(panel, [echoes])
    panel.axhline(0, **panels.SEA_LEVEL)
    panel.set_ylim(high, low)
    emptied(panel)


def haze():
    """The view of a satellite into the water and the air, by the visibility."""
    drawing = Figure(figsize=(WIDTH, 4.4), layout="constrained")
    left, right = drawing.subplots(1, 2, sharey=True)
    lines = []
    for visibility, colour in VISIBILITIES.items():
        one = _through("spaceborne.toml", 16e6, visibility, -40.0, 40.0, 5.0)
        panels.processes(left, one, [("elastic", colour)])
        panels.processes(right, one, [("air", colour)])
        lines.append((f"visibility {visibility:g} km", colour))
        _print(f"space, {visibility:g} km", one)
    left.set_title("Light that has been in the water")
    right.set_title("Light of the air alone")
    left.legend(handles=panels.lines_legend(lines, False).handles, fontsize=8, loc="upper left")
    for panel in (left, right):
        _finish(panel, -40, 40, one.echo)
        panel.set_xlim(1e-18, 1e-13)
    at = (1.3e-14, 2.5)
    right.annotate("scattered in the air,\nmirrored by the sea", at, (2.5e-16, 22), arrowprops=ARROW, **NOTE)
    left.set_ylabel("depth [m]; above the line: air")
    return drawing


def mirrored():
    """The light that the air adds to the first gates of a ship's lidar, and from high up."""
    drawing = Figure(figsize=(WIDTH, 4.4), layout="constrained")
    left, right = drawing.subplots(1, 2)
    views = [(left, "ship.toml", "A ship, 12 m up", -11.0, 6.0, 0.5, 4e6)]
    views.append((right, "airborne-high.toml", "An aircraft, 9 km up", -20.0, 20.0, 2.0, 16e6))
    for panel, scene, title, low, high, step, photons in views:
        one = _through(scene, photons, CLEAR, low, high, step)
        panels.processes(panel, one, [(process, colour) for process, (_, colour) in PARTS.items()])
        _finish(panel, low, high, one.echo)
        panel.set_title(title)
        _print(scene, one)
    left.set_xlim(1e-13, 1e-6)
    right.set_xlim(1e-16, 1e-10)
    for process, at in (("elastic", (2e-13, 14)), ("air", (8e-15, -10))):
        words, colour = PARTS[process]
        right.text(*at, words, color=colour, fontweight="bold")
    left.set_ylabel("depth [m]; above the line: air")
    return drawing


def _from_the_height(photons, depth, low, high, step):
    """The elastic echo of an upright lidar over aerosols of that optical depth, in gates between two depths."""
    at = [0.0, 0.0, HEIGHT]
    changes = {"source.position_m": at, "telescope.0.position_m": at}
    changes["gates"] = {"depth_min_m": low, "depth_max_m": high, "depth_step_m": step}
    if depth is not None:
        air = {"profile": "us-standard", "aerosol": "maritime", "aerosol_optical_depth_550": depth}
        changes["atmosphere"] = air
    return run("minimal.toml", photons, "forward", **changes).sel(channel="elastic")


def aerosols():
    """The view of an aircraft into the air and the water, by the amount of aerosol."""
    drawing = Figure(figsize=(WIDTH, 3.6), layout="constrained")
    left, right = drawing.subplots(1, 2)
    above, below, lines = [], [], []
    for depth, colour in AMOUNTS.items():
        water = _from_the_height(4e6, depth, 3.0, 30.0, 3.0)  # from where the air has no part in the echo
        panels.processes(right, water, [("elastic", colour)])
        below.append(water.echo_by_process.sel(process="elastic"))
        _print(f"3 km, {depth}", water)
        lines.append(("no air" if depth is None else f"aerosol optical depth {depth}", colour))
        if depth is None:
            continue
        air = _from_the_height(8e6, depth, -1500.0, 0.0, 50.0)
        panels.processes(left, air, [("air", colour)])
        above.append(air.echo_by_process.sel(process="air"))
        _print(f"3 km, {depth}", air)
    panels.finish_lines(left, above)
    panels.finish_lines(right, below)
    left.set(ylim=(0, -1500), ylabel="depth [m]; negative: height", title="Light of the air alone")
    right.set(ylim=(30, 0), ylabel="depth [m]", title="Light that has been in the water")
    left.legend(handles=panels.lines_legend(lines, False).handles, fontsize=8, loc="lower right")
    for panel in (left, right):
        emptied(panel)
    return drawing


def _print(name, one):
    """The numbers in the guide."""
    for process in one.process.values:
        part = one.sel(process=process)
        for k, depth in enumerate(one.gate_depth.values):
            echo, error = float(part.echo_by_process[k]), float(part.echo_by_process_standard_error[k])
            if echo > 0:
                print(f"{name}, {process} {depth:g} m: {echo:.4g} +- {100 * error / echo:.1f} %", file=sys.stderr)
