"""The picture of a scene file: instrument, sea and gates with the keys that describe them."""

import tomllib

import numpy
from look import ARROW, NOTE, SCENES, WIDTH
from matplotlib.figure import Figure
from matplotlib.patches import Polygon

HEIGHT = 6.2  # inches
INDEX = 1.34  # of sea water, to the width of a line
EDGE = 1.6  # of the sea drawn [m]
GREEN, BLUE = "#009E73", "#0072B2"
OF_LASER, OF_TELESCOPE = {**NOTE, "color": "#00664b"}, {**NOTE, "color": "#004f7c"}


def scene():
    with open(SCENES / "three-layers.toml", "rb") as file:
        said = tomllib.load(file)
    laser, telescope, gates = said["source"], said["telescope"][0], said["gates"]
    height, bottom = laser["position_m"][2], gates["depth_max_m"]
    drawing = Figure(figsize=(WIDTH, HEIGHT))
    panel = drawing.add_axes([0.08, 0.01, 0.91, 0.98])
    panel.set(xlim=(-2.0, 2.25), ylim=(-bottom - 2.6, height + 5.2))
    _sea(panel, said["sea"]["layer"], bottom)
    half_view = telescope["detector_diameter_m"] / 2 / telescope["focal_length_m"]
    _cone(panel, telescope["diameter_m"] / 2, half_view, height, bottom, BLUE, 0.13)
    half_beam = laser["half_divergence_mrad"] / 1000
    _cone(panel, laser["diameter_m"] / 2, half_beam, height, bottom, GREEN, 0.45)
    for one, z, colour in ((telescope, height, BLUE), (laser, height + 0.35, GREEN)):
        ends = [-one["diameter_m"] / 2, one["diameter_m"] / 2]
        panel.plot(ends, [z, z], color=colour, linewidth=5, solid_capstyle="butt")
    _name_instrument(panel, laser, telescope, height, half_view)
    _gates(panel, gates)
    down = [layer["bottom_depth_m"] for layer in said["sea"]["layer"] if "bottom_depth_m" in layer]
    panel.set_yticks([height, 0, *(-depth for depth in down), -bottom])
    panel.set_ylabel("z [m]")
    panel.set_xticks([])
    panel.spines[["top", "right", "bottom"]].set_visible(False)
    return drawing


def _cone(panel, radius, angle, height, bottom, colour, opacity):
    """From a disc down, bent at the surface; dotted where it would go straight on."""
    heights = numpy.array([height, 0.0, -bottom])
    # Snell's law for angles as small as these: in the water they are divided by the index.
    widths = radius + angle * numpy.array([0, height, height + bottom / INDEX])
    corners = [*zip(-widths, heights), *zip(widths[::-1], heights[::-1])]
    panel.add_patch(Polygon(corners, facecolor=colour, alpha=opacity, linewidth=0))
    straight = radius + angle * (height + bottom)
    for side in (-1, 1):
        ends = [side * widths[1], side * straight]
        panel.plot(ends, [0, -bottom], ":", color=colour, linewidth=1.1)


def _sea(panel, layers, bottom):
    """Layers as bands, the greener the more chlorophyll."""
    top = 0.0
    for layer in layers:
        end = layer.get("bottom_depth_m", bottom)
        green = {"color": "#8fcfa8", "alpha": 0.12 + 0.2 * layer["chlorophyll_mg_m3"]}
        panel.fill_between([-EDGE, EDGE], -end, -top, linewidth=0, **green)
        words = f'[[sea.layer]]\nname = "{layer["name"]}"\n'
        words += f"chlorophyll_mg_m3 = {layer['chlorophyll_mg_m3']}\n"
        words += f"bottom_depth_m = {end}" if "bottom_depth_m" in layer else "(bottomless)"
        panel.text(-EDGE + 0.03, -(top + end) / 2, words, va="center", **NOTE)
        panel.plot([-EDGE, EDGE], [-end, -end], color="0.6", linewidth=0.8)
        top = end
    panel.plot([-EDGE, EDGE], [0, 0], color=BLUE, linewidth=1.6)
    panel.text(0.36, -1.0, "sea surface, z = 0", va="center", **NOTE)


def _name_instrument(panel, laser, telescope, height, half_view):
    at = ", ".join(f"{x:g}" for x in laser["position_m"])
    words = f"[source]\nposition_m = [{at}]\ndiameter_m = {laser['diameter_m']}\n"
    words += f"half_divergence_mrad = {laser['half_divergence_mrad']}"
    arrow = {"arrowprops": ARROW}
    panel.annotate(words, (-0.02, height + 0.35), (-1.9, height + 0.7), **arrow, **OF_LASER)
    words = f"[[telescope]]\nposition_m = [{at}]\ndiameter_m = {telescope['diameter_m']:.2f}"
    panel.annotate(words, (0.2, height), (0.7, height + 1.2), **arrow, **OF_TELESCOPE)
    view = f"field of view:\nfocal_length_m = {telescope['focal_length_m']}\n"
    view += f"detector_diameter_m = {telescope['detector_diameter_m']}\n"
    view += f"or half_field_of_view_mrad = {1000 * half_view:g}"
    panel.annotate(view, (0.25, 7.0), (0.7, 5.2), **arrow, **OF_TELESCOPE)
    panel.annotate("laser's cone", (-0.055, 8.0), (-0.9, 7.7), **arrow, **OF_LASER)
    bent = f"light is bent at the surface\n(dotted: straight on):\nsin θ = {INDEX} sin θ'"
    panel.annotate(bent, (-0.325, 0), (-1.6, 1.7), **arrow, **NOTE)
    (left, right), (low, high) = panel.get_xlim(), panel.get_ylim()
    place = panel.get_position()
    stretch = (high - low) / (right - left) * place.width * WIDTH / (place.height * HEIGHT)
    words = f"Not to scale: widths are drawn {stretch:.0f} times as large as heights."
    panel.text(-EDGE, low + 0.6, words, **NOTE)


def _gates(panel, gates):
    """The gates, as a ruler beside the water."""
    first, last, step = gates.get("depth_min_m", 0.0), gates["depth_max_m"], gates["depth_step_m"]
    for k in range(round((last - first) / step)):
        ends = -(first + k * step), -(first + (k + 1) * step)
        shade = "0.80" if k % 2 else "0.55"
        panel.fill_between([EDGE + 0.03, EDGE + 0.11], *ends, color=shade, linewidth=0)
    words = [(first, f"[gates]\ndepth_min_m\n= {first}", "top")]
    words += [((first + last) / 2, f"depth_step_m\n= {step}", "center")]
    words += [(last, f"depth_max_m\n= {last}", "bottom")]
    for depth, text, side in words:
        panel.text(EDGE + 0.14, -depth, text, va=side, **NOTE)
