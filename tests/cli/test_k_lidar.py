"""photic.k_lidar, on echoes of the first order in closed form, whose K is the attenuation c of the water."""

import numpy
import photic as package
import pytest

pytestmark = pytest.mark.filterwarnings("ignore::UserWarning")  # so few photons leave warnings

A, B = 0.08, 0.12  # 1/m


def scene_of(tilt_deg=0.0, **changes):
    slope = float(numpy.tan(numpy.radians(tilt_deg)))
    scene = package.Scene.new("ship")
    scene.update({
        "sea.layer": [{"iop": [{"wavelength_nm": 532, "a_per_m": A, "b_per_m": B}], "phase_function": {"model": "henyey-greenstein", "g": 0.9}}],
        "channel": [{"name": "elastic", "process": "elastic"}],
        "source.direction": [slope, 0, -1], "telescope.0.direction": [slope, 0, -1],
        "gates.depth_max_m": 20, "gates.depth_step_m": 1, "simulation.estimator": "bidirectional", **changes,
    })  # fmt: skip
    return scene


def of_first_order(scene, photons=9000):
    """A result whose gates have the light of the closed form, with the relative errors and the scatter of a run."""
    result = scene.run(photons=photons)
    scale = package.lidar_equation(scene).echo.values / result.echo
    grouped = scale.expand_dims(batch_group=result.sizes["batch_group"], axis=2)
    return result.assign(
        echo=result.echo * scale, echo_standard_error=result.echo_standard_error * scale,
        echo_by_group=(result.echo_by_group.dims, result.echo_by_group.values * grouped.values),
    )  # fmt: skip


# Seen red: with 2 z of tilted axes; without the range correction; with the way there alone.
@pytest.mark.parametrize("tilt_deg", [0.0, 25.0])
def test_k_of_the_first_order_is_the_attenuation(tilt_deg):
    found = package.k_lidar(of_first_order(scene_of(tilt_deg)), "elastic", depths=(3, 15))
    numpy.testing.assert_allclose(found.k[0, 2:], A + B, rtol=0.01)
    assert float(found.k_fitted[0]) == pytest.approx(A + B, rel=0.005)
    assert found.depth[0].values == pytest.approx(numpy.arange(1.0, 20.0), abs=1e-6)


# Of neighbours in a run: between the absorption with what is scattered back, and all that a narrow view loses.
def test_k_of_a_run_and_its_errors():
    result = scene_of().run(photons=30000, seed=2)
    found = package.k_lidar(result, "elastic", depths=(3, 10))
    assert A < float(found.k_fitted[0]) < A + B
    by_hand = package.error_of(result, lambda e: numpy.log(e.echo.isel(channel=0)).diff("gate") / 2)
    numpy.testing.assert_allclose(found.k_standard_error[0], by_hand.value_standard_error[0], rtol=1e-6)
    assert found.reliable[0].values.tolist() == (result.converged[0, 0].values[:-1] & result.converged[0, 0].values[1:]).tolist()


# Seen red: with gates of any error.
def test_a_fit_leaves_out_what_is_not_known_to_ten_per_cent():
    result = of_first_order(scene_of())
    worse = result.assign(echo_standard_error=result.echo_standard_error.copy())
    worse.echo_standard_error[0, 0, 8] = 0.2 * worse.echo[0, 0, 8]
    found = package.k_lidar(worse, "elastic", depths=(3, 15))
    gates = numpy.flatnonzero(found.k_fitted_gate[0])
    assert gates.tolist() == [3, 4, 5, 6, 7, 9, 10, 11, 12, 13, 14]


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"channel": "elastik"}, "there is no channel 'elastik' (did you mean 'elastic'?)"),
        ({"telescope": "shop"}, "there is no telescope 'shop' (did you mean 'ship'?)"),
        ({"environment": "oil"}, "there is no environment 'oil', nor any other"),
        ({"depths": (9, 3)}, "depths = (9, 3): the first depth of a fit is above the last"),
        ({"depths": (3, 4.6)}, "k_lidar: a fit of three gates at least: 2 in the water have errors below 10 %"),
    ],
)
def test_what_is_refused(arguments, message):
    result = of_first_order(scene_of())
    with pytest.raises(package.Error) as error:
        package.k_lidar(result, **{"channel": "elastic", **arguments})
    assert message in str(error.value)


def test_waves_and_ranges_are_refused():
    waves = scene_of(**{"sea.surface": {"model": "cox-munk", "wind_speed_m_s": 5}}).run(photons=2000)
    with pytest.raises(package.Error, match="k_lidar: the closed form has no waves"):
        package.k_lidar(waves, "elastic")
    ranges = scene_of(gates={"range_min_m": 12, "range_max_m": 30, "range_step_m": 1}).run(photons=2000)
    with pytest.raises(package.Error, match="k_lidar: gates of this result have ranges, and no depths"):
        package.k_lidar(ranges, "elastic")
