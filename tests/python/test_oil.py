"""photic.oil_thickness, on results of made-up numbers."""

import subprocess
import sys

import numpy
import pytest
import xarray
from oil_results import (
    ATTENUATION,
    CLEAN_ECHO,
    GROUPS,
    RATIO,
    TELESCOPES,
    THICKNESS_UM,
    agrees,
    drawn_gates,
    refused,
    run_over_the_sea,
    same,
    with_environments,
)

import photic


# Seen red: with ln(E / W); with ln(r) subtracted; in m; with the first environment; with attenuation or
# ratio of the first channel; with the attenuation of the first telescope.
@pytest.mark.parametrize("by_run", [False, True], ids=["environment", "another run"])
def test_the_thickness_of_the_film_comes_back(oily, clean, by_run):
    found = photic.oil_thickness(oily, clean if by_run else "clean")
    assert same(found.thickness, THICKNESS_UM)
    assert found.reliable.values.all()
    elastic = photic.oil_thickness(oily, clean if by_run else "clean", channel="elastic")
    assert same(elastic.thickness, THICKNESS_UM)


# Seen red: with the interfaces counted by both formulas.
def test_the_papers_formula_takes_no_account_of_interfaces(oily):
    found = photic.oil_thickness(oily, "clean", formula="paper")
    off = -1e6 * numpy.log(RATIO[:, 1]) / ATTENUATION[:, 1]
    assert same(found.thickness, THICKNESS_UM + off[:, None])
    both = photic.oil_thickness(oily, "clean")
    assert same(found.thickness_standard_error, both.thickness_standard_error)
    assert (found.attrs["formula"], both.attrs["formula"]) == ("paper", "interfaces")


# Seen red: with the coordinates of the other run, which differ by rounding, or of the environment kept;
# without the order of axes; with gates compared in the order that their axes have.
@pytest.mark.parametrize("by_run", [False, True], ids=["environment", "another run"])
def test_shape_coordinates_and_units(oily, clean, by_run):
    clean = clean.assign_coords(gate_time=clean.gate_time * (1 + 1e-15))
    clean["gate_time_bounds"] = clean.gate_time_bounds * (1 + 1e-15)
    found = photic.oil_thickness(oily, clean if by_run else "clean")
    assert {"telescope": 2, "gate": 3}.items() <= found.sizes.items()
    for name in ("thickness", "thickness_standard_error", "reliable"):
        assert found[name].dims == ("telescope", "gate")
    assert found.thickness.attrs == {"long_name": "thickness of the film of oil", "units": "um"}
    assert found.thickness_standard_error.attrs["units"] == "um" and found.reliable.dtype == bool
    assert list(found.telescope.values) == TELESCOPES
    assert found.gate_time.attrs["units"] == "ns" and found.gate_depth.dims == ("telescope", "gate")
    assert found.channel == "raman" and "environment" not in found.coords
    assert found.equals(photic.oil_thickness(oily.transpose(), clean if by_run else "clean"))


# Seen red: with the clean sea's echo left as it is whatever group is left out; with both errors as independent.
@pytest.mark.parametrize("correlation", [-0.5, 0.0, 0.9, 0.99])
def test_errors_of_one_runs_echoes_are_correlated(correlation):
    oily, _, _ = drawn_gates(20_000, numpy.array([0.02, 0.015]), correlation)
    assert agrees(photic.oil_thickness(oily, "clean"))


# Seen red: without the clean echo's error; with both added up; with groups that must be there.
def test_errors_of_another_run_are_not():
    oily, bare, w = drawn_gates(20_000, numpy.array([0.02, 0.015]), 0.0)
    clean = run_over_the_sea(bare, w)
    without = ["echo_by_group", "group_photons"]  # which no two runs need
    found = photic.oil_thickness(oily.drop_dims("environment").drop_vars(without), clean.drop_vars(without))
    assert agrees(found)
    expected = 1e6 / 2e5 * numpy.hypot(2e-7 * 0.02 / oily.echo, w / clean.echo).isel(channel=0)
    assert same(found.thickness_standard_error, expected)


# Seen red: as those above.
def test_echoes_that_are_off_together_have_no_error(oily):
    one = with_environments(oily.drop_dims("environment"), {"clean": CLEAN_ECHO}, correlation=1.0)
    found = photic.oil_thickness(one, "clean")
    assert found.thickness_standard_error.values == pytest.approx(numpy.zeros((2, 3)), abs=1e-12)
    assert found.reliable.values.all()


# Seen red: with the value and its error alone.
def test_what_groups_show_of_one_run(oily, clean):
    found = photic.oil_thickness(oily, "clean")
    assert found.thickness_replicates.dims == ("batch_group", "telescope", "gate")
    of_replicates = numpy.sqrt(GROUPS - 1) * found.thickness_replicates.std("batch_group")
    assert same(found.thickness_standard_error, of_replicates)
    assert (abs(found.thickness_bias) < 0.05 * found.thickness_standard_error).all()
    assert set(photic.oil_thickness(oily, clean)) == set(found) - {"thickness_bias", "thickness_replicates"}


# Seen red: with both errors as independent, which needs no groups.
def test_without_groups_the_errors_of_one_run_are_not_known(oily):
    reason = "a result without echo_by_group: run its scene again with simulation.keep_groups = true, and with no "
    reason += "more gates, channels and environments than keep it within 64 MB"
    assert refused(oily.drop_dims("batch_group"), "clean") == reason
    reason = "environment_echo: its groups of batches are not kept; an error is known of echo and environment_echo"
    assert refused(oily.drop_vars("environment_echo_by_group"), "clean") == reason


# Seen red: with 0 taken for light; with either echo not looked at; with the flags alone in `reliable`.
@pytest.mark.parametrize("value", [0.0, -1e-9, numpy.nan])
@pytest.mark.filterwarnings("error")
def test_gates_without_light_are_nan(oily, clean, value):
    oily.echo[0, 1, 0] = value
    oily.environment_echo[1, 1, 1, 2] = value
    clean.echo[1, 1, 2] = value
    dark = numpy.array([[True, False, False], [False, False, True]])
    for of in ("clean", clean):
        found = photic.oil_thickness(oily, of)
        assert numpy.array_equal(numpy.isnan(found.thickness), dark)
        assert numpy.array_equal(numpy.isnan(found.thickness_standard_error), dark)
        assert numpy.array_equal(found.reliable, ~dark)


# Seen red: without a look at the ratio; without one at the attenuation; with the flags alone in `reliable`.
@pytest.mark.parametrize("formula", ["interfaces", "paper"])
@pytest.mark.parametrize("name, value", [("film_interface_ratio", numpy.nan), ("film_attenuation", 0.0)])
@pytest.mark.filterwarnings("error")
def test_instruments_in_the_water_and_films_that_absorb_nothing(oily, formula, name, value):
    oily[name][0, 1] = value
    found = photic.oil_thickness(oily, "clean", formula=formula)
    for unknown in (found.thickness, found.thickness_standard_error):
        assert numpy.isnan(unknown[0]).all() and not numpy.isnan(unknown[1]).any()
    assert not found.reliable[0].any() and found.reliable[1].all()


# Seen red: with either of the two not looked at; with the first environment's.
def test_reliable_is_what_both_echoes_are(oily, clean):
    oily.converged[0, 1, 0] = False
    oily.converged[1, 0, :] = False  # of another channel
    oily.environment_converged[1, 1, 1, 2] = False
    oily.environment_converged[0] = False  # in other water
    clean.converged[1, 1, 2] = False
    for of in ("clean", clean):
        found = photic.oil_thickness(oily, of)
        assert found.reliable.values.tolist() == [[False, True, True], [True, True, False]]
        assert same(found.thickness, THICKNESS_UM)


# Seen red: with telescopes taken in the order of each run.
def test_telescopes_of_another_run_go_by_their_names(oily, clean):
    assert same(photic.oil_thickness(oily, clean.isel(telescope=[1, 0])).thickness, THICKNESS_UM)


def test_no_film(oily, clean):
    reason = (
        "result: no film of oil: its scene itself has no [oil], or oil.thickness_um = 0, and what a film absorbs is in "
        "results of scenes that have one; take the run over the film as result, and the sea without it as clean"
    )
    assert refused(clean, oily) == refused(clean, "clean") == reason


# Seen red: with a film in both runs let through.
def test_a_clean_sea_with_a_film(oily):
    reason = "clean: has a film of oil itself: run the same scene with oil.thickness_um = 0 for it"
    assert refused(oily, oily) == reason


def test_unknown_environment(oily):
    assert refused(oily, "clear") == "result: there is no environment 'clear' (did you mean 'clean'?)"
    assert refused(oily, "x") == "result: there is no environment 'x'; there are: more algae, clean"
    assert refused(oily.drop_dims("environment"), "clean") == (
        "result: there is no environment 'clean', nor any other: add [[environment]] with "
        'set = { "oil.thickness_um" = 0 } to the scene, or run the same scene with oil.thickness_um = 0 '
        "and take that result as clean"
    )


def test_unknown_channel(oily, clean):
    reason = "there is no channel 'rahman' (did you mean 'raman'?)"
    assert refused(oily, "clean", channel="rahman") == f"result: {reason}"
    reason = "there is no channel 'x'; there are: elastic, raman"
    assert refused(oily, "clean", channel="x") == f"result: {reason}"
    reason = "clean: there is no channel 'raman'; there are: elastic"
    assert refused(oily, clean.sel(channel=["elastic"])) == reason


def test_unknown_formula(oily):
    reason = "there is no formula 'papers' (did you mean 'paper'?)"
    assert refused(oily, "clean", formula="papers") == reason
    assert refused(oily, "clean", formula=None) == "there is no formula None; there are: interfaces, paper"


# Seen red: without the look at them.
def test_other_telescopes(oily, clean):
    reason = "clean: other telescopes than those of result: narrow in place of narrow, wide; "
    reason += "run the same scene with oil.thickness_um = 0"
    assert refused(oily, clean.isel(telescope=[0])) == reason


# Seen red: with their number alone compared, or not; with their centres compared; without depths.
def test_other_gates(oily, clean):
    reason = "clean: other gates than those of result; run the same scene with oil.thickness_um = 0"
    assert refused(oily, clean.isel(gate=[0, 1])) == reason
    wide = clean.copy(deep=True)
    wide.gate_time_bounds[0] += [-0.5, 0.5]  # about the same centre
    assert refused(oily, wide) == reason
    deep = clean.copy(deep=True)
    deep.gate_depth_bounds[1, 1] += 0.01
    assert refused(oily, deep) == reason


# Behind a filter of 14 nm about 404 nm, the mean wavelength of a run over 1 um of oil was 0.17 nm longer than that of
# the clean sea, and a gate that ended at 5 m was 0.09 mm deeper. Seen red: with depths to 1e-9.
def test_depths_of_a_filter_are_not_quite_the_same_under_a_film(oily, clean):
    clean.gate_depth_bounds[:] = clean.gate_depth_bounds * (1 + 2e-5)
    assert same(photic.oil_thickness(oily, clean).thickness, THICKNESS_UM)


def test_instruments_in_the_water_have_the_same_gates_without_depths(oily, clean):
    # Seen red: with NaN unlike NaN.
    for result in (oily, clean):
        result.gate_depth_bounds[0] = numpy.nan
    assert same(photic.oil_thickness(oily, clean).thickness, THICKNESS_UM)


# Seen red: without the look at its type; at its axes; at its coordinates.
@pytest.mark.parametrize(
    "change",
    [
        lambda result: "oily.nc",
        lambda result: None,
        lambda result: result.echo,
        lambda result: result.sel(channel="raman"),
        lambda result: result.isel(telescope=0),
        lambda result: result.drop_vars(["telescope", "gate_time_bounds"]),
        lambda result: xarray.Dataset(),
        lambda result: xarray.Dataset(result.data_vars, result.coords),
    ],
    ids=["path", "None", "echo", "one channel", "one telescope", "without coordinates", "empty", "without a scene"],
)
def test_what_is_no_whole_result(oily, clean, change):
    reason = "the whole result of a run over the sea: take what photic.open or photic.run returns"
    assert refused(change(oily), "clean") == f"result: not {reason}"
    if not isinstance(change(clean), str):
        neither = "clean: neither the name of an environment nor"
        assert refused(oily, change(clean)) == f"{neither} {reason}"


def test_the_result_is_written_and_read_again(oily, tmp_path):
    found = photic.oil_thickness(oily, "clean")
    found.to_netcdf(tmp_path / "thickness.nc")
    with xarray.open_dataset(tmp_path / "thickness.nc", decode_timedelta=False) as again:
        assert again.load().equals(found) and again.reliable.dtype == bool


def test_no_matplotlib_is_needed():
    # Seen red: with the names looked for by photic.choice, which draws.
    call = "import sys; sys.modules['matplotlib'] = None; import photic; photic.oil_thickness(None, 'clean')"
    done = subprocess.run([sys.executable, "-c", call], capture_output=True, text=True, check=False)
    assert "photic.errors.Error: result: not the whole result" in done.stderr
