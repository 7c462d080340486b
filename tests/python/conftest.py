"""What the tests of the Python package share. CTest sets PHOTIC_BUILD and PHOTIC_PROGRAM; without
them tests fail."""

import os
import subprocess
from pathlib import Path

import pytest


@pytest.fixture(scope="session")
def sample(tmp_path_factory):
    """A result of made-up numbers, written by the library (tests/unit/io/sample_result.cpp)."""
    path = tmp_path_factory.mktemp("sample") / "sample.nc"
    maker = Path(os.environ["PHOTIC_BUILD"]) / "tests" / "unit" / "io" / "make_sample_result"
    subprocess.run([maker, path], check=True)
    return path
