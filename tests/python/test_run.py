"""photic.run with the program itself."""

import os

import numpy
import pytest

import photic

SCENE = """
title = "A run from Python"
[source]
wavelength_nm = 532.0
position_m = [0.0, 0.0, 12.0]
direction = [0.0, 0.0, -1.0]
diameter_m = 0.04
half_divergence_mrad = 5.0
[[telescope]]
name = "ship"
position_m = [0.0, 0.0, 12.0]
direction = [0.0, 0.0, -1.0]
diameter_m = 0.40
focal_length_m = 2.0
detector_diameter_m = 0.04
detector_shift_m = 0.0
[[channel]]
name = "elastic"
process = "elastic"
[[sea.layer]]
iop = [{ wavelength_nm = 532.0, a_per_m = 0.06, b_per_m = 0.10 }]
phase_function = { model = "henyey-greenstein", g = 0.924 }
[gates]
depth_max_m = 10.0
depth_step_m = 1.0
[simulation]
estimator = "forward"
photons = 20000
seed = 1
"""


@pytest.fixture
def scene(tmp_path):
    path = tmp_path / "scene.toml"
    path.write_text(SCENE)
    return path


@pytest.fixture(autouse=True)
def the_program_of_this_build():
    assert os.path.isfile(os.environ["PHOTIC_PROGRAM"])


pytestmark = pytest.mark.filterwarnings("ignore::UserWarning")  # so few photons leave warnings


def test_returns_the_echo(scene):
    ds = photic.run(scene)
    assert ds.attrs["photons"] == 20000 and ds.attrs["title"] == "A run from Python"
    echo = ds.echo.sel(telescope="ship", channel="elastic")
    assert echo.shape == (10,)
    assert float(echo[0]) > 0
    assert echo.gate_depth.values == pytest.approx(numpy.arange(0.5, 10), abs=1e-6)


def test_set_changes_the_scene(scene):
    black = photic.run(scene, set={"sea.layer.0.iop.0.a_per_m": 1.06}, photons=1e4, threads=1)
    assert black.attrs["photons"] == 10000 and black.attrs["threads"] == 1
    clear = photic.run(scene, photons=1e4)
    # Two ways of more than 4 m through 1/m more absorption.
    assert float(black.echo[0, 0, 5]) < float(clear.echo[0, 0, 5]) * numpy.exp(-8)


def test_threads_do_not_change_the_result(scene):
    one, two = photic.run(scene, threads=1), photic.run(scene, threads=2)
    assert numpy.array_equal(one.echo, two.echo)


def test_output_is_kept(scene, tmp_path):
    ds = photic.run(scene, output=tmp_path / "kept.nc")
    assert ds.identical(photic.open(tmp_path / "kept.nc"))


# Seen red: without passing it on.
def test_a_run_goes_on(scene, tmp_path):
    smallest = {"simulation.batch_photons": 250}
    photic.run(scene, photons=6000, output=tmp_path / "old.nc")
    ds = photic.run(scene, continue_from=tmp_path / "old.nc")
    assert ds.attrs["photons"] == 20000
    assert len(ds.attrs["history"].splitlines()) == 2
    assert numpy.array_equal(ds.echo, photic.run(scene, set=smallest).echo)


def test_all_errors_of_a_scene(scene):
    with pytest.raises(photic.Error) as error:
        photic.run(scene, set={"sea.layer.0.chlorophyl": 1.0, "source.diameter_m": -1.0})
    assert error.value.exit_code == 2
    assert "chlorophyl" in str(error.value) and "diameter_m" in str(error.value)


def test_missing_scene(tmp_path):
    with pytest.raises(photic.Error, match="none.toml"):
        photic.run(tmp_path / "none.toml")


# Seen red: with the longer result returned in the place of this run's.
def test_a_longer_result_is_left_and_this_one_is_beside(scene, tmp_path):
    photic.run(scene, photons=3e6, output=tmp_path / "kept.nc")
    with pytest.raises(photic.Error, match="holds 3000000 photons of this scene, more than the 10000"):
        photic.run(scene, photons=1e4, output=tmp_path / "kept.nc")
    time_limit = {"simulation.max_time_s": 0.001}
    with pytest.warns(UserWarning, match="left as it is: see .*kept-2.nc"):
        ds = photic.run(scene, photons=1e12, set=time_limit, output=tmp_path / "kept.nc")
    assert ds.attrs["photons"] < 3e6
    assert ds.identical(photic.open(tmp_path / "kept-2.nc"))
    assert photic.open(tmp_path / "kept.nc").attrs["photons"] == 3e6
    photic.run(scene, photons=1e4, output=tmp_path / "kept.nc", force=True)
    assert photic.open(tmp_path / "kept.nc").attrs["photons"] == 1e4
