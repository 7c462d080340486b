"""photic.overlap and photic.range_corrected: against formulas by hand, and against runs."""

import numpy
import photic as package
import pytest
from conftest import QUICK_SCENE
from test_lidar_equation import EDGES, GROUP, HEIGHT, PENCIL, REFUSED, N, layer, pencil

pytestmark = pytest.mark.filterwarnings("ignore::UserWarning")

# A thin beam beside or on the axis of a lens of 40 cm and 2 m; gates by range in the air, 3 km above the sea.
LENS, FOCUS = 0.2, 2.0
IN_AIR = PENCIL.replace(f"{HEIGHT}]", "3000.0]").replace("depth_m", "range_m").replace("depth_", "range_")
IN_AIR += '[atmosphere]\nprofile = "us-standard"\naerosol = "none"\n'
IN_AIR = IN_AIR.replace("range_max_m = 21.0", "range_max_m = 1001.0").replace("range_step_m = 2.0", "range_step_m = 50.0")
RANGES = numpy.arange(1.0, 1002.0, 50.0)


def in_air(changes):
    scene = package.Scene(IN_AIR.replace("{raman}", "") + layer(0.1, 0.1, 0.5))
    scene.update(changes)
    return scene


def mean_in_gates(edges, of):
    return numpy.array([of(numpy.linspace(low, high, 4001)).mean() for low, high in zip(edges, edges[1:])])


def blur(z, distance):
    """The radius of the image of a point on the axis."""
    return LENS * numpy.abs(1 - distance * (1 / FOCUS - 1 / z))


# Seen red: with the detector's shift the other way; with the shadow left out.
@pytest.mark.parametrize(("what", "distance", "obstruction"), [
    ({}, FOCUS, 0.0),
    ({"telescope.0.detector_shift_m": 0.01}, FOCUS + 0.01, 0.0),
    ({"telescope.0.focus_m": 300.0}, FOCUS + FOCUS**2 / (300.0 - FOCUS), 0.0),
    ({"telescope.0.obstruction_diameter_m": 0.1}, FOCUS, 0.05),
])  # fmt: skip
def test_a_thin_beam_on_the_axis(what, distance, obstruction):
    detector = 0.002

    def share(z):  # of the image, a disc with a hole, within the detector
        rim = blur(z, distance)
        hole = rim * obstruction / LENS
        return (numpy.minimum(detector, rim) ** 2 - numpy.minimum(detector, hole) ** 2) / numpy.maximum(rim**2 - hole**2, 1e-30)

    found = package.overlap(in_air({"telescope.0.detector_diameter_m": 2 * detector} | what)).overlap
    assert found.dims == ("telescope", "channel", "gate") and found.attrs["units"] == "1"
    assert found.values[0, 0] == pytest.approx(mean_in_gates(RANGES, share), abs=3e-3)  # it has bends


# Harms 1978: the image is aside by f d / z, and its radius is f r / z: near the detector of radius D nothing is
# seen before z = f (d - r) / D, and all from f (d + r) / D on.
# Seen red: with the image's distance from the axis halved.
def test_a_thin_beam_beside_the_axis_comes_into_view():
    d, detector = 1.0, 0.004
    found = package.overlap(in_air({"source.position_m": [d, 0.0, 3000.0], "telescope.0.detector_diameter_m": 2 * detector}))
    eta, low, high = found.overlap[0, 0].values, RANGES[:-1], RANGES[1:]
    first, last = FOCUS * (d - LENS) / detector, FOCUS * (d + LENS) / detector  # 400 and 600 m
    assert (eta[high < first] == 0).all() and eta[low > last] == pytest.approx(1, abs=1e-12)
    points = numpy.linspace(-1, 1, 201)
    x, y = (each[numpy.hypot(*numpy.meshgrid(points, points)) < 1] for each in numpy.meshgrid(points, points))

    def share(z):  # of points of the image, one by one
        return (numpy.hypot(FOCUS * (d + LENS * x) / z, FOCUS * LENS * y / z) < detector).mean()

    expected = [numpy.mean([share(z) for z in numpy.linspace(*gate, 50)]) for gate in zip(low, high)]
    assert eta == pytest.approx(expected, abs=0.01)


# A cone is seen as far as the detector's rim leads: the share of its solid angle. Far away the blur counts little.
# Seen red: with the laser's rings crowded about its axis.
def test_a_cone_wider_than_the_view():
    scene = in_air({"source.half_divergence_mrad": 2.0, "telescope.0.detector_diameter_m": 0.004, "telescope.0.focus_m": 900.0})
    seen = package.overlap(scene).overlap[0, 0].values[-4:]
    assert seen == pytest.approx(numpy.full(4, (1.0 / 2.0) ** 2), rel=0.02)


# Turned as a whole, an instrument sees the same at the same ranges of the air. Seen red: with the axis of the telescope down.
def test_tilted_as_a_whole():
    changes = {"source.half_divergence_mrad": 2.0, "telescope.0.detector_diameter_m": 0.006}
    upright = package.overlap(in_air(changes | {"source.position_m": [0.0, 0.5, 3000.0]}))
    tilt = [0.6, 0.0, -0.8]  # about y, along which the laser is aside
    turned = package.overlap(in_air(changes | {
        "source.position_m": [0.0, 0.5, 3000.0], "source.direction": tilt, "telescope.0.direction": tilt,
    }))  # fmt: skip
    assert upright.overlap.min() < 0.1 and upright.overlap.max() > 0.5
    assert turned.overlap.values == pytest.approx(upright.overlap.values, abs=1e-3)


def test_in_water_points_seem_nearer():
    # Seen red: with the way in the water whole.
    found = package.overlap(pencil(layer(0.1, 0.1, 0.5)))
    with_detector = pencil(layer(0.1, 0.1, 0.5))
    with_detector["telescope.0.detector_diameter_m"] = 0.03
    narrow = package.overlap(with_detector).overlap

    def share(z):
        return numpy.minimum(1, (0.015 / blur(HEIGHT + z / N, FOCUS)) ** 2)

    assert (found.overlap == 1).all()
    for channel in ("elastic", "raman"):  # of the same index here
        assert narrow.sel(channel=channel).values[0] == pytest.approx(mean_in_gates(EDGES, share), rel=3e-4)  # it has a bend


@pytest.mark.parametrize("kind", ["ship", "biaxial", "three-layers", "airborne", "fluorosensor-355", "plume", "airborne-high"])
def test_it_has_the_coordinates_of_a_result(kind):
    scene = package.Scene.new(kind)
    found, run = package.overlap(scene), scene.run(photons=200)
    assert found.sizes["gate"] == run.sizes["gate"] and list(found.channel.values) == list(run.channel.values)
    assert ("gate_time" in found.coords) == ("atmosphere" not in scene)  # which delays pulses
    if "gate_time" in found.coords:
        assert found.gate_time_bounds.values == pytest.approx(run.gate_time_bounds.values, rel=1e-9)
    filters = [f"channel.{name}.centre_nm" in scene for name in found.channel.values]
    close = 1e-2 if any(filters) else 1e-9  # of filters the light's mean is not known, but the centre
    assert found.gate_depth.values == pytest.approx(run.gate_depth.values, abs=close)
    seen = found.overlap.values[~numpy.isnan(found.overlap.values)]
    assert seen.size and (seen >= 0).all() and (seen <= 1 + 1e-12).all()


@pytest.mark.parametrize("function", ["overlap", "range_corrected"])
@pytest.mark.parametrize("what", ["waves", "in the water", "laser in the water", "looks up"])
def test_instruments_that_are_refused(function, what):
    changes, reason = REFUSED[what]
    scene = package.Scene(QUICK_SCENE)
    scene.update(changes)
    with pytest.raises(package.Error) as refused:
        package.overlap(scene) if function == "overlap" else package.range_corrected(scene.run(photons=200))
    assert str(refused.value).startswith(f"{function}: ") and reason in str(refused.value)


def test_gates_in_time_under_air_are_refused():
    scene = package.Scene(QUICK_SCENE)
    scene.update({"atmosphere": {"profile": "us-standard"}, "gates": {"start_ns": 70, "stop_ns": 250, "step_ns": 15}})
    with pytest.raises(package.Error, match="overlap: the air delays pulses by what is not known here"):
        package.overlap(scene)
    assert package.range_corrected(scene.run(photons=200)).sizes["gate"] == 12


def test_a_filter_given_as_a_table_has_no_known_light(tmp_path):
    (tmp_path / "filter.csv").write_text("wavelength_nm,transmission\n640,0.5\n660,0.9\n")
    scene = package.Scene(QUICK_SCENE)
    scene["channel.1"] = {"name": "coloured", "transmission_file": str(tmp_path / "filter.csv")}
    with pytest.raises(package.Error, match='channel "coloured" has a filter without a centre'):
        package.overlap(scene)
    assert package.range_corrected(scene.run(photons=2000)).sizes["channel"] == 2


# Of single scattering into clear water, X is what the gate turns back, times what the surface and the water leave.
# Seen red: with n left out of the spread; with the area of the whole lens; with the error not scaled.
def test_range_correction_undoes_distance_and_overlap():
    b, c, obstruction = 0.01, 0.02, 0.1
    scene = pencil(layer(c - b, b, 0.5), raman="")
    scene.update({
        "telescope.0.detector_diameter_m": 0.03, "telescope.0.obstruction_diameter_m": obstruction, "simulation.photons": 1e5,
        "simulation.estimator": "forward", "simulation.reception": "overlap", "gates.depth_step_m": 1.0,
    })  # fmt: skip
    run = scene.run()
    found = package.range_corrected(run)
    equation = run.assign(echo=package.lidar_equation(scene).echo)
    corrected = package.range_corrected(equation).range_corrected[0, 0].values
    z = run.gate_depth[0, 0].values
    passed = (1 - ((N - 1) / (N + 1)) ** 2) ** 2
    p = (1 - 0.25) / 1.5**3 / (4 * numpy.pi)
    assert corrected == pytest.approx(passed * b * p * numpy.exp(-2 * c * z), rel=3e-3, abs=0)  # gates of 1 m
    eta = package.overlap(scene).overlap[0, 0].values
    area = numpy.pi * (0.2**2 - (obstruction / 2) ** 2)
    factor = (N * HEIGHT + z) ** 2 / (area * eta)
    for name in ("", "_standard_error"):
        expected = run["echo" + name][0, 0].values * factor
        assert found["range_corrected" + name][0, 0].values == pytest.approx(expected, rel=1e-9, abs=0)
    assert found.range_corrected.attrs["units"] == "sr-1" and "long_name" in found.reliable.attrs
    assert found.reliable.dtype == bool and (found.reliable == run.converged).all()


# Slanted, S_s and S_t differ. Seen red: with S_s for both.
def test_range_correction_along_a_slanted_axis():
    scene = package.Scene.new("ship-tilted")
    scene.update({"source.direction": [0.6, 0.0, -0.8], "telescope.0.direction": [0.6, 0.0, -0.8]})
    scene.update({"gates.range_min_m": 14.0, "gates.range_max_m": 20.0, "sea.refractive_index": N, "sea.group_index": GROUP})
    run = scene.run(photons=1000)
    found = package.range_corrected(run).range_corrected[0, 0].values
    in_water = (1 - (0.6 / N) ** 2) ** 0.5
    air = HEIGHT / 0.8
    water = numpy.maximum(run.gate_depth[0, 0].values - air, 0)
    dipped = water > 0
    s, t = air + water / N, air + water / N * (0.8 / in_water) ** 2
    factor = N**2 * s * t * in_water / 0.8 / (numpy.pi * 0.2**2) / package.overlap(scene).overlap[0, 0].values
    assert dipped.sum() > 3
    assert found[dipped] == pytest.approx((run.echo[0, 0].values * factor)[dipped], rel=1e-9, abs=0)


def test_of_a_part_of_a_result():
    run = package.Scene.new("three-layers").run(photons=500)
    whole = package.range_corrected(run)
    part = package.range_corrected(run.sel(telescope=["beside"], channel=["raman", "elastic"]).isel(gate=slice(3, 7)))
    assert part.identical(whole.sel(telescope=["beside"], channel=["raman", "elastic"]).isel(gate=slice(3, 7)))


def test_gates_without_light_are_not_reliable():
    scene = in_air({"source.position_m": [1.0, 0.0, 3000.0], "telescope.0.detector_diameter_m": 0.008, "simulation.photons": 200})
    found = package.range_corrected(scene.run())
    assert numpy.isnan(found.range_corrected[0, 0, :5]).all() and not found.reliable[0, 0, :5].any()


@pytest.mark.parametrize("thing", ["a result", None, package.Scene(QUICK_SCENE), package.optics.of(package.Scene(QUICK_SCENE))])
def test_what_is_no_result(thing):
    with pytest.raises(package.Error, match="range_corrected: not a result with the axes telescope, channel and gate"):
        package.range_corrected(thing)


def test_a_telescope_that_the_scene_does_not_have():
    run = package.Scene.new("three-layers").run(photons=500)
    renamed = run.assign_coords(telescope=["coaxal", "beside"])
    with pytest.raises(package.Error, match=r"the result's scene has no telescope 'coaxal' \(did you mean 'coaxial'\?\)"):
        package.range_corrected(renamed)


# Air delays pulses, and the gates with them. Seen red: with places by the time of gates.
def test_air_does_not_move_the_places_of_gates():
    factors = []
    for scene in (package.Scene.new("airborne-high"), package.Scene.new("airborne-high")):
        if factors:
            del scene["atmosphere"]
        scene.update({"telescope.0.position_m": [1.0, 0.0, scene["source.position_m"][2]], "simulation.photons": 2000})
        run = scene.run()
        factors.append((package.range_corrected(run).range_corrected / run.echo).values)
    there = ~numpy.isnan(factors[0]) & ~numpy.isnan(factors[1])
    assert there.sum() > 10
    assert factors[0][there] == pytest.approx(factors[1][there], rel=1e-9, abs=0)
