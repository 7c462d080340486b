"""photic.oil_thickness by a measured ratio of echoes, on results of made-up numbers."""

import numpy
import pytest
import xarray
from oil_results import (
    ATTENUATION,
    AXES,
    CLEAN_ECHO,
    TELESCOPES,
    agrees,
    drawn_gates,
    refused,
    same,
)

import photic


# Seen red: with the ratio and its inverse exchanged; with the film's thickness left out; with that of another unit.
@pytest.mark.parametrize("by_run", [False, True], ids=["environment", "another run"])
def test_a_measured_ratio_is_compared_with_that_of_the_run(oily, clean, by_run):
    """Over a film of 2 um the run has ratios of its own, with a factor that no formula knows."""
    unknown = numpy.array([[1.1, 1.0, 0.9], [1.0, 0.95, 1.0]])
    absorbed = numpy.exp(-1e-6 * ATTENUATION[:, 1, None] * numpy.array([2.0, 5.0])[:, None, None])
    oily["echo"] = (AXES, CLEAN_ECHO * unknown[:, None, :])
    oily.echo[:, 1] = CLEAN_ECHO[:, 1] * unknown * absorbed[0]
    axes = ("telescope", "gate")
    there = {"telescope": TELESCOPES[::-1]}  # by their names, in any order
    ratio = xarray.DataArray((unknown * absorbed[1])[::-1], dims=axes, coords=there)
    found = photic.oil_thickness(oily, clean if by_run else "clean", ratio=ratio, ratio_error=0.01)
    assert same(found.thickness, numpy.full((2, 3), 5.0))
    assert found.reliable.values.all() and found.thickness.dims == axes and found.attrs == {}
    own = photic.oil_thickness(oily, clean if by_run else "clean").thickness_standard_error
    measured = 1e6 / ATTENUATION[:, 1, None] * (0.01 / ratio.values[::-1])
    assert same(found.thickness_standard_error, numpy.hypot(own, measured))


# Seen red: with the measurement's error alone; with the run's alone; with both added up; with that of the ratio for
# that of its logarithm.
@pytest.mark.parametrize("correlation", [0.0, 0.9])
@pytest.mark.parametrize("relative", [0.002, 0.015], ids=["measured well", "measured as the run"])
def test_the_error_of_a_measured_ratio_contains_the_runs(correlation, relative):
    """Thicknesses of measurements and runs that are drawn at random scatter as their errors say."""
    oily, _, _ = drawn_gates(20_000, numpy.array([0.02, 0.015]), correlation)
    measured = 0.4 * numpy.random.default_rng(20260502).normal(1, relative, 20_000)
    given = {"ratio": measured, "ratio_error": 0.4 * relative}
    found = photic.oil_thickness(oily, "clean", **given)
    assert agrees(found)
    assert float(found.thickness.mean()) == pytest.approx(2 - 5 * numpy.log(0.4 / (2 / 3)), abs=0.005)


# Seen red: with the flags of the run alone in `reliable`.
@pytest.mark.filterwarnings("error")
def test_gates_where_nothing_was_measured_are_nan(oily):
    given = {"ratio": [0.5, numpy.nan, 0.4], "ratio_error": [0.01, 0.01, numpy.nan]}
    found = photic.oil_thickness(oily, "clean", **given)
    assert numpy.isnan(found.thickness).values.tolist() == [[False, True, False]] * 2
    assert numpy.isnan(found.thickness_standard_error).values.tolist() == [[False, True, True]] * 2
    assert found.reliable.values.tolist() == [[True, False, False]] * 2


# Seen red: with values under the mask; with all errors that are numbers taken to be reliable.
def test_masked_ratios_and_infinite_errors_are_not_reliable(oily):
    masked = numpy.ma.array([0.5, 0.6, 0.4], mask=[False, True, False])
    found = photic.oil_thickness(oily, "clean", ratio=masked, ratio_error=0.01)
    assert found.thickness.isnull().values.tolist() == 2 * [[False, True, False]]
    assert found.reliable.values.tolist() == 2 * [[True, False, True]]
    found = photic.oil_thickness(oily, "clean", ratio=0.5, ratio_error=1e308)
    assert not found.reliable.values.any()


def test_a_measured_ratio_needs_its_error(oily):
    both = "give both, the measured ratio and its standard deviation"
    assert refused(oily, "clean", ratio=0.5) == f"ratio without ratio_error: {both}"
    assert refused(oily, "clean", ratio_error=0.5) == f"ratio_error without ratio: {both}"


# Seen red: without the look at either end.
@pytest.mark.parametrize("ratio", [0.0, -0.1, 83.0, numpy.inf, [0.5, 0.6, 83.0]])
def test_ratios_that_can_be_none(oily, ratio):
    reason = "ratio: not above 0, or too large: it is the echo under the film over that of the clean sea, "
    reason += "as 0.83 and not 83 per cent"
    assert refused(oily, "clean", ratio=ratio, ratio_error=0.01) == reason


@pytest.mark.parametrize("error", [-0.01, numpy.inf])
def test_errors_of_ratios_that_can_be_none(oily, error):
    reason = "ratio_error: below 0 or infinite: it is a standard deviation"
    assert refused(oily, "clean", ratio=0.5, ratio_error=error) == reason


# Seen red: with the telescopes' names not looked at, which leaves one of two; without the number of gates.
@pytest.mark.parametrize(
    "ratio",
    [
        "0.5",
        [0.5, 0.6],
        [[0.5] * 3] * 2,
        xarray.DataArray([0.5, 0.6], dims="channel"),
        xarray.DataArray([0.5, 0.6], dims="telescope", coords={"telescope": ["narrow", "high"]}),
    ],
    ids=["text", "two gates", "without names", "by channel", "another telescope"],
)
def test_ratios_that_do_not_fit_the_gates(oily, ratio):
    forms = "give a number, one for each of the 3 gates, or a DataArray on telescope and gate"
    assert refused(oily, "clean", ratio=ratio, ratio_error=0.01) == f"ratio: {forms}"
    assert refused(oily, "clean", ratio=0.5, ratio_error=ratio) == f"ratio_error: {forms}"


def test_a_measured_ratio_has_the_interfaces_in_it(oily):
    reason = "formula 'paper' with a measured ratio: that is compared with the run's, which has the interfaces in it "
    reason += "(leave out formula)"
    assert refused(oily, "clean", formula="paper", ratio=0.5, ratio_error=0.01) == reason
