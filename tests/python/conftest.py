"""What the tests of the Python package share. CTest sets PHOTIC_BUILD and PHOTIC_PROGRAM; without
them tests fail."""

import os
import subprocess
import warnings
from pathlib import Path

import numpy
import pytest
from oil_results import ATTENUATION, CLEAN_ECHO, RATIO, THICKNESS_UM, film, run_over_the_sea, with_environments

from photic.__main__ import main


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


@pytest.fixture(scope="session")
def sample_with_tallies(tmp_path_factory):
    """The same with quantities beside echoes (tests/unit/io/sample_tallies.cpp)."""
    return made(tmp_path_factory.mktemp("sample") / "sample.nc", "--tallies")


@pytest.fixture(scope="session")
def sample_of_tallies(tmp_path_factory):
    """These alone, without telescopes."""
    return made(tmp_path_factory.mktemp("sample") / "sun.nc", "--tallies-alone")


@pytest.fixture
def command(capsys):
    """`python3 -m photic` in this process, which need not begin anew: its exit code, and what it says.
    A warning, which the program would show, fails."""

    def run(*arguments):
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            # As Python and numpy have it by themselves.
            for kind in (DeprecationWarning, PendingDeprecationWarning):
                warnings.simplefilter("ignore", kind)
            warnings.filterwarnings("ignore", message="numpy.ndarray size changed")
            try:
                code = main([str(each) for each in arguments])
            except SystemExit as end:
                code = end.code
        return code, capsys.readouterr().err

    return run


def made(path, *environments):
    maker = Path(os.environ["PHOTIC_BUILD"]) / "tests" / "unit" / "io" / "make_sample_result"
    subprocess.run([maker, path, *environments], check=True)
    return path


@pytest.fixture
def oily():
    """Over a film, of another thickness in every gate, with the clean sea and other water."""
    share = RATIO[:, :, None] * numpy.exp(-ATTENUATION[:, :, None] * 1e-6 * THICKNESS_UM[:, None, :])
    result = run_over_the_sea(CLEAN_ECHO * share, **film(ATTENUATION, RATIO))
    return with_environments(result, {"more algae": 0.5 * CLEAN_ECHO, "clean": CLEAN_ECHO})


@pytest.fixture
def clean():
    return run_over_the_sea(CLEAN_ECHO, 0.03 * CLEAN_ECHO)
