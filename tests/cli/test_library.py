"""Other programs can be built on what `cmake --install` puts under a prefix."""

import subprocess

import netCDF4
import numpy
import pytest
from conftest import SOURCE


@pytest.fixture(scope="module")
def echo(prefix, tmp_path_factory):
    """A program of twenty lines on photic::photic."""
    build = tmp_path_factory.mktemp("echo")
    for command in (
        ["cmake", "-S", SOURCE / "tests/cli/library", "-B", build, "-G", "Ninja", f"-DCMAKE_PREFIX_PATH={prefix}"],
        ["cmake", "--build", build],
    ):
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stdout + done.stderr
    return build / "echo"


def test_a_program_runs_a_scene_with_the_programs_bits(echo, prefix, scene, photic, tmp_path):
    # Seen red: with headers left out of the installation.
    done = subprocess.run([echo, prefix / "share/photic/data", scene], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    mean, error = numpy.array([line.split() for line in done.stdout.splitlines()], float).T
    assert photic("run", scene, "-o", tmp_path / "out.nc", "--engine", "scalar").returncode == 0
    with netCDF4.Dataset(tmp_path / "out.nc") as file:
        assert numpy.array_equal(mean, file["echo"][:].ravel())
        assert numpy.array_equal(error, file["echo_standard_error"][:].ravel())


def test_a_scene_that_is_wrong_is_reported(echo, prefix, tmp_path):
    (tmp_path / "bad.toml").write_text("[sea]\nsalinity_psu = -1\n")
    done = subprocess.run([echo, prefix / "share/photic/data", tmp_path / "bad.toml"], capture_output=True, text=True, check=False)
    assert done.returncode == 1
    assert "bad.toml:2:16: " in done.stderr
