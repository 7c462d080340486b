"""What the tests of the Python package share. CTest sets PHOTIC_BUILD and PHOTIC_PROGRAM; without
them tests fail."""

import os
import subprocess
from pathlib import Path

import pytest


@pytest.fixture(scope="session")
def sample(tmp_path_factory):
    """A result of made-up numbers, written by the library (tests/unit/io/sample_result.cpp)."""
    return made(tmp_path_factory.mktemp("sample") / "sample.nc")


@pytest.fixture(scope="session")
def sample_in_other_water(tmp_path_factory):
    """The same with environments."""
    environments = ["more algae", "no $ _CDOM_", "bloom"]
    return made(tmp_path_factory.mktemp("sample") / "sample.nc", *environments)


@pytest.fixture(scope="session")
def sample_with_parameters(tmp_path_factory):
    """The same with derivatives, and one environment."""
    parameters = ["sea.layer.0.chlorophyll_mg_m3", "sea.$_x_"]
    return made(tmp_path_factory.mktemp("sample") / "sample.nc", "bloom", "--", *parameters)


def made(path, *environments):
    maker = Path(os.environ["PHOTIC_BUILD"]) / "tests" / "unit" / "io" / "make_sample_result"
    subprocess.run([maker, path, *environments], check=True)
    return path
