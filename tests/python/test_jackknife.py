"""Errors of what is made of several echoes, on echoes made up by hand."""

import numpy
import photic
import pytest
import xarray
from grouped_results import GROUPS, correlated, result_of

def of_raman(gate):
    return lambda e: e.echo.sel(telescope="t", channel="raman", gate=gate)


# Seen red: without the scale.
@pytest.mark.parametrize("error", [None, 1.7])
def test_an_echo_has_its_own_error(error):
    photons = numpy.full((2, GROUPS), 1000.0)
    photons[:, -1] = 300
    result = result_of(correlated(), photons, error)
    found = photic.error_of(result, lambda e: e.echo)
    numpy.testing.assert_allclose(found.value_standard_error, result.echo_standard_error, rtol=1e-12)
    assert (abs(found.value_bias) < 0.01 * found.value_standard_error).all()
    assert found.reliable.all()


# Unscaled, the jackknife of a gate is what eq. 36 is of groups: scaled to what eq. 36 gives, it is left as it is.
def test_a_scale_of_one_changes_nothing():
    means = correlated()
    found = photic.error_of(result_of(means), lambda e: e.echo.sum("gate"))
    of_sums = means.sum(axis=2).std(axis=1, ddof=1) / numpy.sqrt(GROUPS)
    numpy.testing.assert_allclose(found.value_standard_error[0], of_sums, rtol=2e-3)
    in_quadrature = numpy.sqrt((means.std(axis=1, ddof=1) ** 2).sum(axis=1) / GROUPS)
    assert (found.value_standard_error[0] > 1.5 * in_quadrature).all()


# The variance of a ratio to the first order: v_x/x^2 + v_y/y^2 - 2 cov/(x y).
def test_a_ratio_has_the_error_of_the_first_order():
    means = correlated()
    found = photic.error_of(result_of(means), lambda e: e.echo.sel(channel="chlorophyll") / e.echo.sel(channel="raman"))
    relative = means[1] / means[1].mean(axis=0) - means[0] / means[0].mean(axis=0)
    expected = found.value.values[0] * relative.std(axis=0, ddof=1) / numpy.sqrt(GROUPS)
    numpy.testing.assert_allclose(found.value_standard_error[0], expected, rtol=5e-3)


# x^2 is too large by the variance of x.
def test_the_bias_of_a_square():
    result = result_of(correlated(), error=1)
    found = photic.error_of(result, lambda e: e.echo**2)
    numpy.testing.assert_allclose(found.value_bias, result.echo_standard_error**2, rtol=1e-9)


# Seen red: without the scale; with NaN of groups that a channel rested in.
def test_a_channel_that_rested_has_the_groups_it_was_scored_in():
    means = correlated()
    photons = numpy.full((2, GROUPS), 1000.0)
    photons[0, 40:] = 0
    means[0, 40:] = numpy.nan
    result = result_of(means, photons)
    found = photic.error_of(result, lambda e: e.echo)
    numpy.testing.assert_allclose(found.value_standard_error, result.echo_standard_error, rtol=1e-12)
    ratio = photic.error_of(result, lambda e: e.echo.sel(channel="chlorophyll") / e.echo.sel(channel="raman"))
    assert numpy.isfinite(ratio.value_standard_error).all()


# Seen red: with all gates asked for; with a change by one factor, of which ratios know nothing.
def test_only_gates_that_a_value_is_made_of_must_have_converged():
    result = result_of(correlated(), flagged=[2, 3])
    gates = photic.error_of(result, lambda e: e.echo.isel(telescope=0, channel=0))
    assert gates.reliable.values.tolist() == [True, True, False, False]
    assert not photic.error_of(result, lambda e: e.echo.sum()).reliable
    assert photic.error_of(result, lambda e: e.echo.isel(gate=[0, 1]).sum()).reliable
    ratio = photic.error_of(result, lambda e: e.echo.isel(gate=2) / e.echo.isel(gate=3))
    assert not ratio.reliable.any()


def test_few_groups_are_not_relied_on():
    assert not photic.error_of(result_of(correlated(groups=29)), lambda e: e.echo).reliable.any()
    assert photic.error_of(result_of(correlated(groups=30)), lambda e: e.echo).reliable.all()
    one = photic.error_of(result_of(correlated(groups=1), error=numpy.nan), lambda e: e.echo)
    assert numpy.isnan(one.value_standard_error).all() and not one.reliable.any()


# Seen red: with those coordinates alone that the echoes have the axes of.
def test_a_function_has_all_coordinates():
    result = result_of(correlated()).assign_coords(bounds=(("gate", "bnds"), numpy.arange(8.0).reshape(4, 2)))
    found = photic.error_of(result, lambda e: (e.echo * e.bounds.isel(bnds=1)).sum("gate"))
    assert numpy.isfinite(found.value_standard_error).all()


def test_gates_without_light_are_known_to_have_none():
    means = correlated()
    means[..., 3] = 0
    found = photic.error_of(result_of(means), lambda e: e.echo.sum("gate"))
    assert numpy.isfinite(found.value_standard_error).all()


# Of 2000 runs made up, as telescopes of one, 95 % of the intervals (63 degrees of freedom) hold the truth, within three
# deviations of that number. Seen red: with
# groups of other gates, each by itself.
def test_intervals_hold_the_truth():
    runs = [result_of(correlated(seed)).assign_coords(telescope=[f"run {seed}"]) for seed in range(2000)]
    together = xarray.concat(runs, dim="telescope")
    found = photic.error_of(together, lambda e: e.echo.isel(gate=0) / e.echo.isel(gate=1)).isel(channel=0)
    held = int((abs(found.value - 1) < 1.998 * found.value_standard_error).sum())
    assert abs(held / 2000 - 0.95) < 3 * numpy.sqrt(0.95 * 0.05 / 2000)


@pytest.mark.parametrize(
    ("result", "function", "message"),
    [
        (result_of(correlated()).drop_vars("echo_by_group"), of_raman(0), "a result without echo_by_group: run its scene again with"),
        (xarray.Dataset(), of_raman(0), "no result of a run with echoes"),
        (result_of(correlated()), lambda e: e.converged, "converged: its groups of batches are not kept"),
        (result_of(correlated()), lambda e: e["echo_standard_error"], "echo_standard_error: its groups of batches are not kept"),
        (result_of(correlated()), lambda e: "much", "a function whose value is not a number"),
    ],
)
def test_what_is_refused(result, function, message):
    with pytest.raises(photic.Error) as error:
        photic.error_of(result, function)
    assert str(error.value).startswith(message)


def test_a_function_has_one_form():
    forms = iter([1.0, [1.0, 2.0]])
    with pytest.raises(photic.Error, match="a function whose value had the form"):
        photic.error_of(result_of(correlated()), lambda e: next(forms))


def with_environment(result, factor, unseen=1.0):
    """With an environment of so many times the light, whose reported errors have a share that is not seen."""
    where = ("environment", "telescope", "channel", "gate")
    groups = result.echo_by_group.values[None] * factor
    return result.assign(
        environment_echo=(where, result.echo.values[None] * factor),
        environment_echo_standard_error=(where, unseen * factor * result.echo_standard_error.values[None]),
        environment_difference_standard_error=(where, abs(factor - 1) * result.echo_standard_error.values[None]),
        environment_converged=(where, result.converged.values[None]),
        environment_echo_by_group=((*where[:3], "batch_group", "gate"), groups),
    ).assign_coords(environment=["other"])


# Seen red: with environments scaled by their own errors alone.
@pytest.mark.parametrize("factor", [1.0, 1.02, 0.9])
def test_what_waters_have_in_common_cancels(factor):
    result = with_environment(result_of(correlated()), factor, unseen=1.2)
    difference = photic.error_of(result, lambda e: e.environment_echo - e.echo)
    numpy.testing.assert_allclose(difference.value_standard_error, result.environment_difference_standard_error, rtol=1e-6, atol=1e-12)


# Of water with hardly any light the scene's error is no measure. Seen red: with environments scaled as the scene everywhere.
def test_another_water_has_its_own_error():
    result = with_environment(result_of(correlated()), 0.01, unseen=1.2)
    found = photic.error_of(result, lambda e: e.environment_echo)
    numpy.testing.assert_allclose(found.value_standard_error, result.environment_echo_standard_error, rtol=1e-9)


def squared_in_place(e):
    e.echo.values[...] = e.echo.values**2
    return e.echo.sum()


def squared_anew(e):
    e["echo"] = e.echo**2
    e["half"] = e.echo / 2
    return 2 * e["half"].sum()


# Seen red: with the result's own arrays given to the function.
@pytest.mark.parametrize("function", [squared_in_place, squared_anew])
def test_a_function_may_change_what_it_is_given(function):
    result = result_of(correlated())
    before = result.copy(deep=True)
    found, expected = photic.error_of(result, function), photic.error_of(result, lambda e: (e.echo**2).sum())
    assert float(found.value_standard_error) == pytest.approx(float(expected.value_standard_error), rel=1e-9)
    assert result.identical(before)
