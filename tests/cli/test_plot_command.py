"""photic plot: the Python package, started wherever it is."""

import os

import pytest


@pytest.fixture
def result(photic, scene, tmp_path):
    assert photic("run", "quick.toml", "--photons", "8000", "-q").returncode == 0
    return tmp_path / "quick.nc"


def without_python_path(**more):
    return {name: value for name, value in os.environ.items() if not name.startswith("PYTHON")} | more


def test_a_picture(photic, result, tmp_path):
    # Seen red: without the package's place.
    done = photic("plot", "quick.nc", env=without_python_path())
    assert (done.returncode, done.stderr) == (0, "")
    assert (tmp_path / "quick.png").read_bytes().startswith(b"\x89PNG")


def test_options_reach_the_package(photic, result, tmp_path):
    done = photic("plot", "quick.nc", "-o", "p.svg", "--title", "A title of mine", env=without_python_path())
    assert (done.returncode, done.stderr) == (0, "")
    assert "A title of mine" in (tmp_path / "p.svg").read_text()


def test_what_the_package_refuses(photic, result):
    done = photic("plot", "nowhere.nc", env=without_python_path())
    assert done.returncode == 2
    assert "nowhere.nc" in done.stderr
    assert len(done.stderr.splitlines()) == 1


def test_the_python_that_is_named_and_is_none(photic, result):
    done = photic("plot", "quick.nc", env=without_python_path(PHOTIC_PYTHON="/nowhere/python3"))
    assert done.returncode == 1
    assert done.stderr == (
        "photic: no Python that can draw plots: /nowhere/python3 is not there, or does not start "
        "(PHOTIC_PYTHON names it)\n"
    )


def test_what_is_missing_is_named(photic, result, tmp_path):
    """A Python without modules but its own."""
    bare = tmp_path / "bare python"
    bare.write_text('#!/bin/sh\nexec /usr/bin/python3 -I -S "$@"\n')
    bare.chmod(0o755)
    done = photic("plot", "quick.nc", env=without_python_path(PHOTIC_PYTHON=str(bare)))
    assert done.returncode == 1
    assert f"{bare} lacks numpy xarray netCDF4 matplotlib (PHOTIC_PYTHON names it)" in done.stderr


def test_a_program_that_is_no_python(photic, result):
    # Seen red: with the exit code alone.
    done = photic("plot", "quick.nc", env=without_python_path(PHOTIC_PYTHON="/bin/true"))
    assert done.returncode == 1
    assert "/bin/true is not there, or does not start" in done.stderr


def test_names_that_begin_like_options(photic, program, scene, tmp_path):
    # Seen red: with the names as they are in the hint, and in the default name of the picture.
    done = photic("run", "quick.toml", "--photons", "8000", "--table", "none", "-o", "./-w.nc")
    assert f"Plot it:  {program} plot ./-w.nc -o ./-w.png\n" in done.stdout
    done = photic("plot", "./-w.nc", env=without_python_path())
    assert (done.returncode, done.stderr) == (0, "")
    assert (tmp_path / "-w.png").exists()
