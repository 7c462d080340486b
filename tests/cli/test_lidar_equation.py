"""photic.lidar_equation: against formulas by hand, and against light of first order in runs."""

from statistics import NormalDist

import numpy
import photic as package
import pytest
from conftest import QUICK_SCENE

pytestmark = pytest.mark.filterwarnings("ignore::UserWarning")

N, GROUP, HEIGHT, RADIUS = 1.34, 1.36, 12.0, 0.2
# A beam as thin as a hair on the axis of a telescope that sees all of it.
PENCIL = f"""
[source]
wavelength_nm = 532.0
position_m = [0.0, 0.0, {HEIGHT}]
direction = [0.0, 0.0, -1.0]
diameter_m = 1e-6
half_divergence_mrad = 0.0
[[telescope]]
name = "one"
position_m = [0.0, 0.0, {HEIGHT}]
direction = [0.0, 0.0, -1.0]
diameter_m = {2 * RADIUS}
focal_length_m = 2.0
detector_diameter_m = 1.0
[[channel]]
name = "elastic"
process = "elastic"
{{raman}}
[sea]
refractive_index = {N}
group_index = {GROUP}
[gates]
depth_min_m = 1.0
depth_max_m = 21.0
depth_step_m = 2.0
[simulation]
photons = 1000
max_order = 1
"""
RAMAN = '[[channel]]\nname = "raman"\nprocess = "raman"\n'
EDGES = numpy.arange(1.0, 22.0, 2.0)


def layer(a, b, g, more=""):
    """At 532 nm; at the wavelengths of Raman light it absorbs twice as much."""
    iop = ", ".join(f"{{ wavelength_nm = {nm}, a_per_m = {k * a}, b_per_m = {b} }}" for nm, k in ((532.0, 1), (600.0, 2), (700.0, 2)))
    return f'[[sea.layer]]\n{more}iop = [{iop}]\nphase_function = {{ model = "henyey-greenstein", g = {g} }}\n'


def pencil(layers, raman=RAMAN):
    return package.Scene(PENCIL.replace("{raman}", raman) + layers)


def straight_back(g):
    return (1 - g * g) / (1 + g) ** 3 / (4 * numpy.pi)


def by_hand(edges, integrand):
    """The sum over fine steps of depth in each gate."""
    out = []
    for low, high in zip(edges, edges[1:]):
        z = numpy.linspace(low, high, 20001)
        z = (z[1:] + z[:-1]) / 2
        out.append(integrand(z).mean() * (high - low))
    return numpy.array(out)


PASSED = (1 - ((N - 1) / (N + 1)) ** 2) ** 2  # through the surface and back
AREA = numpy.pi * RADIUS**2


# Seen red: with n left out of the solid angle.
def test_straight_down_into_clear_water():
    b, g = 1e-9, 0.6
    found = package.lidar_equation(pencil(layer(1e-9, b, g), raman=""))
    far = N * HEIGHT + EDGES
    expected = PASSED * b * straight_back(g) * AREA * (1 / far[:-1] - 1 / far[1:])  # of dz / (n H + z)^2
    assert found.echo.dims == ("telescope", "channel", "gate") and found.echo.attrs["units"] == "1"
    assert found.echo.sel(telescope="one", channel="elastic").values == pytest.approx(expected, rel=1e-5, abs=0)


# Seen red: with the attenuation of the layer below for the way home; with gates across an edge left out.
def test_straight_down_into_three_layers():
    layers = [(0.05, 0.10, 0.3), (0.02, 0.30, 0.7), (0.10, 0.05, -0.2)]  # a, b, g
    tops = numpy.array([0.0, 4.5, 12.2])
    ends = ["bottom_depth_m = 4.5\n", "bottom_depth_m = 12.2\n", ""]
    found = package.lidar_equation(pencil("".join(layer(*each, end) for each, end in zip(layers, ends))))

    def depths(z, factor):
        inside = [numpy.clip(z - top, 0, bottom - top) for top, bottom in zip(tops, [*tops[1:], numpy.inf])]
        return sum((factor * a + b) * one for (a, b, _), one in zip(layers, inside))

    def elastic(z):
        b, p = ([of(*each) for each in layers] for of in (lambda a, b, g: b, lambda a, b, g: straight_back(g)))
        at = numpy.searchsorted(tops, z, side="right") - 1
        return PASSED * numpy.array(b)[at] * numpy.array(p)[at] * AREA / (N * HEIGHT + z) ** 2 * numpy.exp(-2 * depths(z, 1))

    assert found.echo[0, 0].values == pytest.approx(by_hand(EDGES, elastic), rel=1e-5, abs=0)
    optics = package.optics.of(pencil("".join(layer(*each, end) for each, end in zip(layers, ends))))
    emitted = float(optics.emission_per_m.sel(process="raman")[0])  # alike in all layers
    p_raman = 3 / (16 * numpy.pi) * 2.34 / 1.34  # (1 + 3 rho + 1 - rho) / (1 + 2 rho), rho = 0.17

    def raman(z):
        return PASSED * emitted * p_raman * AREA / (N * HEIGHT + z) ** 2 * numpy.exp(-depths(z, 1) - depths(z, 2))

    assert found.echo[0, 1].values == pytest.approx(by_hand(EDGES, raman), rel=1e-5, abs=0)


def test_a_black_sea_bed_ends_the_water():
    found = package.lidar_equation(pencil(layer(0.1, 0.1, 0.5, "bottom_depth_m = 8.0\n")))
    deeper = package.lidar_equation(pencil(layer(0.1, 0.1, 0.5)))
    assert found.echo[0, 0, :3].values == pytest.approx(deeper.echo[0, 0, :3].values, rel=1e-12, abs=0)
    assert 0 < found.echo[0, 0, 3] < deeper.echo[0, 0, 3] and not found.echo[0, 0, 4:].any()


OVERLAP = {"simulation.reception": "overlap", "simulation.estimator": "forward", "simulation.max_order": 1, "simulation.seed": 11}
SINE, COSINE = 0.5, -(0.75**0.5)
BESIDE = {"position_m": [0.5, 0.3, 12.5], "diameter_m": 0.3, "focal_length_m": 1.0, "half_field_of_view_mrad": 60.0}


def scene_of(kind, changes):
    scene = package.Scene.new(kind)
    scene.update(OVERLAP | changes)
    return scene


SCENES = {
    "ship": ("ship", {"gates.depth_max_m": 30.0}, 6e5),
    "three layers": ("three-layers", {"gates.depth_max_m": 20.0}, 4e5),
    "tilted": ("ship-tilted", {"gates.range_max_m": 30.0}, 4e5),
    "tilted by 30 degrees, beside, other tilts": ("ship-tilted", {
        "source.direction": [SINE, 0.0, COSINE], "telescope": [
            {"name": "a", "direction": [SINE, 0.0, COSINE], **BESIDE},
            {"name": "b", "direction": [0.45, -0.03, COSINE], **BESIDE, "obstruction_diameter_m": 0.1, "focus_m": 20.0},
        ], "gates.range_min_m": 14.0, "gates.range_max_m": 30.0,
    }, 4e5),
    "biaxial": ("biaxial", {}, 4e5),
    "Gaussian, gates in time": ("ship", {
        "source.profile": "gaussian", "gates": {"start_ns": 70.0, "stop_ns": 250.0, "step_ns": 15.0},
    }, 4e5),
}  # fmt: skip
LEVEL = 0.001  # by which a family of gates is beyond its limit by chance
PRECISE = 0.02  # of gates that are compared


# The gates of all channels and telescopes of a scene are one family, of a fixed seed. Seen red: with the attenuation 1 % larger
# on the way home; with the phase function straight back for all angles; with the transmittance at nadir for all; with ranges
# timed as if the source stood at the telescope.
@pytest.mark.parametrize("name", SCENES)
def test_light_of_first_order_in_runs(name):
    kind, changes, photons = SCENES[name]
    scene = scene_of(kind, changes)
    equation = package.lidar_equation(scene)
    run = scene.run(photons=photons)
    for coordinate in equation.coords:
        assert equation[coordinate].dims == run[coordinate].dims, coordinate
        if equation[coordinate].dtype.kind == "f":
            assert equation[coordinate].values == pytest.approx(run[coordinate].values, rel=1e-9, abs=1e-9), coordinate
            assert equation[coordinate].attrs == {k: v for k, v in run[coordinate].attrs.items() if k in equation[coordinate].attrs}
    first, error = run.echo_by_order.sel(order=1), run.echo_by_order_standard_error.sel(order=1)
    seen = (error < PRECISE * equation.echo).values
    assert seen.mean() > 0.5
    z = ((first - equation.echo) / error).values[seen]
    limit = NormalDist().inv_cdf(1 - (1 - (1 - LEVEL) ** (1 / z.size)) / 2)
    assert numpy.abs(z).max() < limit
    assert numpy.abs((first / equation.echo - 1).values[seen]).max() < 0.05
    assert not first.values[(equation.echo == 0).values].any()


REFUSED = {
    "waves": ({"sea.surface": {"model": "cox-munk", "wind_speed_m_s": 5.0}}, 'has no waves (sea.surface.model is "cox-munk"'),
    "film": ({"oil": {"class": "weakly-absorbing-crude", "thickness_um": 1.0}}, "has no film of oil (set oil.thickness_um to 0)"),
    "air": ({"atmosphere": {"profile": "us-standard"}}, "has no air that scatters or absorbs (leave out [atmosphere])"),
    "in the water": ({"telescope.0.position_m": [0, 0, -1], "gates.depth_min_m": 2.0}, 'telescope "telescope0" is in the water'),
    "laser in the water": ({"source.position_m": [0, 0, -1], "gates.depth_min_m": 2.0}, "the laser is in the water"),
    "looks up": ({"telescope.0.direction": [0, 0, 1], "gates": {"start_ns": 70, "stop_ns": 250, "step_ns": 15}},
                 'telescope "telescope0" does not look down to the sea'),
    "bed": ({"sea.layer.1.bottom_depth_m": 20.0, "bottom": {"albedo": 0.1}}, "has no light of the sea bed (leave out [bottom])"),
    "filter": ({"channel.1": {"name": "650 nm", "centre_nm": 650.0, "fwhm_nm": 5.0}}, 'channel "650 nm" has a filter'),
    "lifetime": ({"channel.1": {"name": "c", "process": "chlorophyll"}, "optics.chlorophyll_lifetime_ns": 1.0},
                 "has light that is emitted at once (set optics.chlorophyll_lifetime_ns to 0)"),
}  # fmt: skip


@pytest.mark.parametrize("what", REFUSED)
def test_what_is_not_in_the_equation_is_refused(what):
    changes, reason = REFUSED[what]
    scene = package.Scene(QUICK_SCENE)
    scene.update(changes)
    with pytest.raises(package.Error) as refused:
        package.lidar_equation(scene)
    assert str(refused.value).startswith("lidar_equation: ") and reason in str(refused.value)
    assert refused.value.exit_code == 2


def test_columns_are_refused():
    scene = package.Scene.new("plume")
    if "atmosphere" in scene:
        del scene["atmosphere"]
    with pytest.raises(package.Error, match="lidar_equation: the closed form has no columns side by side"):
        package.lidar_equation(scene)


def test_a_beam_that_does_not_come_down_is_refused():
    scene = package.Scene(QUICK_SCENE)
    scene.update({"source.direction": [1, 0, -0.003], "gates": {"start_ns": 80, "stop_ns": 9000, "step_ns": 100}})
    with pytest.raises(package.Error, match="lidar_equation: some light of the laser does not come down to the sea"):
        package.lidar_equation(scene)


def test_a_process_without_light_has_no_echo():
    scene = package.Scene(QUICK_SCENE)
    scene["channel.1"] = {"name": "cdom", "process": "cdom"}
    found = package.lidar_equation(scene)
    assert (found.echo.sel(channel="cdom") == 0).all() and (found.echo.sel(channel="elastic") > 0).all()
    assert found.channel_wavelength.values == pytest.approx(scene.run(photons=200).channel_wavelength.values)


def test_a_scene_without_telescopes_is_refused():
    with pytest.raises(package.Error, match=r"lidar_equation: the scene has no telescopes \(add \[\[telescope\]\]"):
        package.lidar_equation(package.Scene.new("sun"))
