"""Functions of results, on closed forms: z90, ratio, linear_fit."""

import numpy
import photic
import pytest
import xarray
from grouped_results import GROUPS, correlated, result_of
from photic.fits import chi_squared

STEP_M = 2.0


def at_depths(result, first_m=0.0, standard_name="depth"):
    """With gates of two metres below the first depth; channels alike."""
    edges = first_m + STEP_M * numpy.arange(result.sizes["gate"] + 1)
    shape = (result.sizes["telescope"], result.sizes["channel"], result.sizes["gate"])
    where = ("telescope", "channel", "gate")
    bounds = numpy.stack([edges[:-1], edges[1:]], axis=-1)
    return result.assign_coords(
        gate_depth=(where, numpy.broadcast_to(bounds.mean(axis=-1), shape), {"standard_name": standard_name}),
        gate_depth_bounds=((*where, "bnds"), numpy.broadcast_to(bounds, (*shape, 2))),
    )


def light_of(gates, seed=1, scatter=0.02):
    """A result whose gates have this light in the mean, with a scatter."""
    random = numpy.random.default_rng(seed)
    means = numpy.asarray(gates, dtype=float) * (1 + scatter * random.normal(size=(2, GROUPS, len(gates))))
    return at_depths(result_of(means))


# Light that is the same at all depths: linear within every gate.
@pytest.mark.parametrize("share", [0.1, 0.25, 0.6, 0.9])
def test_z90_of_even_light(share):
    found = photic.z90(light_of([1.0] * 20, scatter=1e-9), "raman", share)
    assert float(found.z90[0]) == pytest.approx(share * 20 * STEP_M, rel=1e-6)
    assert not found.reliable.any()  # it may go on for ever


# Light that falls off as exp(-k z), of which gates hold the integrals: exact at the edges of gates.
# Seen red: with light of gates in the middle; without the depths of gates in the air.
@pytest.mark.parametrize("first_m", [0.0, -4.0])
def test_z90_of_light_that_falls_off(first_m):
    k, gates = 0.2, 30
    edges = numpy.maximum(first_m + STEP_M * numpy.arange(gates + 1), 0)
    light = numpy.exp(-k * edges[:-1]) - numpy.exp(-k * edges[1:])
    light[light == 0] = 0.7  # of the air
    share = (1 - numpy.exp(-k * 10 * STEP_M)) / (1 - numpy.exp(-k * edges[-1]))
    found = photic.z90(at_depths(light_of(light, scatter=1e-9), first_m), "raman", share)
    assert float(found.z90[0]) == pytest.approx(10 * STEP_M, rel=1e-6)
    assert found.reliable.all()


# Seen red: without the order of depths; with 1 % behind the last gate for any share.
def test_z90_of_gates_in_another_order_and_of_most_light():
    k, edges = 0.2, STEP_M * numpy.arange(16)
    result = light_of(numpy.exp(-k * edges[:-1]) - numpy.exp(-k * edges[1:]), scatter=1e-9)
    forth, back = (photic.z90(each, "raman") for each in (result, result.isel(gate=slice(None, None, -1))))
    assert float(forth.z90[0]) == pytest.approx(float(back.z90[0])) and forth.reliable.all() and back.reliable.all()
    assert not photic.z90(result, "raman", 0.99).reliable.any()  # 0.25 % of the light is behind the last gate


# Of two gates with light a and b the depth is 2 m + 2 m (0.9 (a + b) - a) / b, whose derivatives are -0.2 m / b and 0.2 m a / b^2.
def test_z90_has_the_error_of_the_first_order():
    result = light_of([1.0, 2.0], scatter=0.05)
    a, b = result.echo.values[0, 0]
    by_group = result.echo_by_group.values[0, 0]
    slope_a, slope_b = -0.1 * STEP_M / b, 0.1 * STEP_M * a / b**2
    deviation = slope_a * by_group[:, 0] + slope_b * by_group[:, 1]
    found = photic.z90(result, "raman")
    assert float(found.z90[0]) == pytest.approx(STEP_M + STEP_M * (0.9 * (a + b) - a) / b)
    assert float(found.z90_standard_error[0]) == pytest.approx(deviation.std(ddof=1) / numpy.sqrt(GROUPS), rel=5e-3)


@pytest.mark.parametrize(
    ("result", "arguments", "message"),
    [
        (light_of([1, 1]), {"channel": "ramen"}, "result: there is no channel 'ramen' (did you mean 'raman'?)"),
        (light_of([1, 1]), {"telescope": "u"}, "result: there is no telescope 'u'; there are: t"),
        (light_of([1, 1]), {"environment": "oil"}, "result: there is no environment 'oil', nor any other"),
        (light_of([1, 1]), {"share": 1.0}, "share = 1: a share of the light is above 0 and below 1"),
        (at_depths(light_of([1, 1]), first_m=-4), {}, "z90: no gate of this result is in the water"),
        (at_depths(light_of([1, 1]), standard_name=""), {}, "z90: gates of this result have ranges, or no depths"),
        (light_of([1, 1]).drop_vars("group_photons"), {}, "a result without group_photons: run its scene again"),
    ],
)
def test_z90_refuses(result, arguments, message):
    with pytest.raises(photic.Error) as error:
        photic.z90(result, **{"channel": "raman", **arguments})
    assert str(error.value).startswith(message)


def in_waters(factors, seed=1):
    """A result with environments whose chlorophyll light is so many times the scene's, each with a scatter of its own."""
    result = at_depths(result_of(correlated(seed)))
    random = numpy.random.default_rng(seed + 1000)
    scatter = 1 + 0.01 * random.normal(size=(len(factors), 1, 1, GROUPS, 1))
    factor = numpy.ones((len(factors), 1, 2, 1, 1)) * scatter
    factor[:, :, 1] *= numpy.array(factors)[:, None, None, None]
    means = result.echo_by_group.values[None] * factor
    where = ("environment", "telescope", "channel", "gate")
    own = means.std(axis=3, ddof=1) / numpy.sqrt(GROUPS)
    return result.assign(
        environment_echo=(where, means.mean(axis=3)),
        environment_echo_standard_error=(where, own),
        environment_converged=(where, numpy.ones(own.shape, dtype=bool)),
        environment_echo_by_group=((*where[:3], "batch_group", "gate"), means),
    ).assign_coords(environment=[f"water {k}" for k in range(len(factors))])


# Seen red: with channels exchanged; with the mean of the gates' ratios.
def test_ratio():
    result = result_of(correlated())
    raman, chlorophyll = result.echo.values[0]
    found = photic.ratio(result)
    numpy.testing.assert_allclose(found.ratio[0], chlorophyll / raman)
    assert float(found.ratio_of_sums[0]) == pytest.approx(chlorophyll.sum() / raman.sum())
    expected = photic.error_of(result, lambda e: e.echo.sel(channel="chlorophyll").sum("gate") / e.echo.sel(channel="raman").sum("gate"))
    numpy.testing.assert_allclose(found.ratio_of_sums_standard_error, expected.value_standard_error)
    assert found.reliable.all() and found.ratio_of_sums_reliable.all()


def test_ratio_in_waters_and_over_one():
    result = in_waters([1.0, 2.0, 4.0])
    several = photic.ratio(result, environment=["water 0", "water 2"])
    assert several.ratio.dims[0] == "environment" and several.sizes["environment"] == 2
    one = photic.ratio(result, environment="water 2")
    numpy.testing.assert_allclose(one.ratio, several.ratio[1])
    over = photic.ratio(result, environment="water 2", reference="water 0")
    numpy.testing.assert_allclose(over.ratio, 4, rtol=1e-3)  # the same light, four times
    assert (over.ratio_standard_error < 0.05 * one.ratio_standard_error).all()
    with pytest.raises(photic.Error, match="there is no environment 'water 7'"):
        photic.ratio(result, environment="water 7")
    with pytest.raises(photic.Error, match="there is no environment ''"):
        photic.ratio(result, reference="")


PLACES = numpy.array([0.0, 1.0, 2.0, 4.0, 6.0])


def on_a_line(seed, shared=0.8, bend=0.0):
    """Values of five environments on 1 + 0.5 x, whose groups scatter together."""
    random = numpy.random.default_rng(seed)
    size = numpy.array([0.5, 0.1, 0.4, 0.2, 0.3])
    noise = numpy.sqrt(shared) * random.normal(size=(GROUPS, 1)) + numpy.sqrt(1 - shared) * random.normal(size=(GROUPS, 5))
    values = 1 + 0.5 * PLACES + bend * PLACES**2 + size * noise
    mean = values.mean(axis=0)
    replicates = (values.sum(axis=0) - values) / (GROUPS - 1)
    return xarray.Dataset(
        {
            "ratio": ("environment", mean),
            "ratio_standard_error": ("environment", values.std(axis=0, ddof=1) / numpy.sqrt(GROUPS)),
            "ratio_replicates": (("batch_group", "environment"), replicates),
            "reliable": ("environment", numpy.ones(5, dtype=bool)),
        }
    )


def test_an_exact_line():
    y = on_a_line(1)
    exact = y.assign(ratio=("environment", 1 + 0.5 * PLACES))
    found = photic.linear_fit(PLACES, exact)
    assert float(found.slope) == pytest.approx(0.5) and float(found.offset) == pytest.approx(1)
    numpy.testing.assert_allclose(found.residual, 0, atol=1e-12)
    assert float(found.r_squared) == pytest.approx(1) and float(found.chi_squared) == pytest.approx(0, abs=1e-12)
    assert int(found.degrees_of_freedom) == 3 and bool(found.reliable)


# Of 1000 runs intervals of 95 % of slope and offset hold the truth, within four deviations.
# Seen red: with values that scatter by themselves.
def test_lines_have_their_errors():
    found = [photic.linear_fit(PLACES, on_a_line(seed)) for seed in range(1000)]
    for name, truth in (("slope", 0.5), ("offset", 1.0)):
        held = numpy.mean([abs(float(one[name]) - truth) < 1.998 * float(one[f"{name}_standard_error"]) for one in found])
        assert abs(held - 0.95) < 4 * numpy.sqrt(0.95 * 0.05 / 1000)


# Of 10 000 runs chi squared has the mean of its three degrees of freedom, and exceeds their quantile of 95 % in 5 to 7 % (it has
# the tail of Hotelling's). Seen red: without the factor of the mean.
def test_chi_squared_is_one():
    found = []
    for seed in range(10000):
        y = on_a_line(seed)
        found.append(chi_squared(PLACES, y.ratio.values, y.ratio_replicates.values))
    found = numpy.array(found)
    assert abs(found.mean() - 3) < 4 * numpy.sqrt(6 / 10000)
    assert 0.05 - 0.0087 < (found > 7.815).mean() < 0.07


# Seen red: with squares of the places themselves.
@pytest.mark.parametrize("factor", [1e-100, 1e100])
def test_places_of_any_size(factor):
    found, usual = photic.linear_fit(PLACES * factor, on_a_line(1)), photic.linear_fit(PLACES, on_a_line(1))
    for name in ("slope", "slope_standard_error"):
        assert float(found[name]) * factor == pytest.approx(float(usual[name]), rel=1e-9)


def test_values_that_scatter_together_have_no_chi_squared():
    y = on_a_line(1)
    offset = y.ratio_replicates.isel(environment=0) - y.ratio_replicates.isel(environment=0).mean()
    together = y.assign(ratio_replicates=(y.ratio + offset).transpose("batch_group", "environment"))
    assert numpy.isnan(photic.linear_fit(PLACES, together).chi_squared)


def test_a_curve_is_no_line():
    found = photic.linear_fit(PLACES, on_a_line(1, bend=0.05))
    assert float(found.r_squared) > 0.97 and float(found.chi_squared) > 50


@pytest.mark.parametrize(
    ("x", "y", "name", "message"),
    [
        (PLACES[:2], on_a_line(1).isel(environment=[0, 1]), None, "linear_fit: 2 values: a line with errors takes 3 at least"),
        (PLACES[:4], on_a_line(1), None, "linear_fit: 4 places for 5 values"),
        (PLACES * 0, on_a_line(1), None, "linear_fit: places that are not finite, or all alike"),
        (list("abcde"), on_a_line(1), None, "linear_fit: places that are no numbers"),
        (PLACES, on_a_line(1), "ratios", "linear_fit: there is no value 'ratios' (did you mean 'ratio'?)"),
        (PLACES, on_a_line(1).expand_dims(telescope=2), None, "linear_fit: values on telescope and environment: leave one axis"),
        (PLACES, on_a_line(1).ratio, None, "linear_fit: y is no Dataset"),
        (PLACES, on_a_line(1).assign(ratio_standard_error=("environment", [0, 1, 1, 1, 1])), None, "linear_fit: values of ratio whose errors"),
    ],
)
def test_linear_fit_refuses(x, y, name, message):
    with pytest.raises(photic.Error) as error:
        photic.linear_fit(x, y, name)
    assert str(error.value).startswith(message)
