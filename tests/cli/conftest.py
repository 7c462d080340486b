"""What the tests of the command line share: the program, and a scene that runs in a blink."""

import os
import subprocess
from pathlib import Path

import pytest

pytest.register_assert_rewrite("analysed_results")
SOURCE = Path(__file__).resolve().parents[2]

QUICK_SCENE = """\
title = "a quick scene"
[source]
wavelength_nm = 532.0
position_m = [0.0, 0.0, 12.0]
direction = [0.0, 0.0, -1.0]
diameter_m = 0.04
half_divergence_mrad = 5.0
[[telescope]]
position_m = [0.0, 0.0, 12.0]
direction = [0.0, 0.0, -1.0]
diameter_m = 0.40
focal_length_m = 2.0
detector_diameter_m = 0.04
detector_shift_m = 0.0
[[channel]]
name = "elastic"
process = "elastic"
[[channel]]
name = "raman"
process = "raman"
[[sea.layer]]
bottom_depth_m = 5.0
chlorophyll_mg_m3 = 0.1
[[sea.layer]]
chlorophyll_mg_m3 = 1.0
[gates]
depth_max_m = 10.0
depth_step_m = 1.0
[simulation]
estimator = "forward"
photons = 20000
"""


@pytest.fixture
def scene(tmp_path):
    path = tmp_path / "quick.toml"
    path.write_text(QUICK_SCENE)
    return path


@pytest.fixture
def program():
    return os.environ["PHOTIC_PROGRAM"]


@pytest.fixture
def photic(program, tmp_path):
    """photic("check", path) runs the program in an empty folder and returns the finished process."""

    def call(*arguments, **options):
        options = {"cwd": tmp_path, "capture_output": True, "text": True, "timeout": 120} | options
        return subprocess.run([program, *map(str, arguments)], stdin=subprocess.DEVNULL, check=False, **options)

    return call


@pytest.fixture(scope="session")
def prefix(tmp_path_factory):
    """A folder into which this build has been installed."""
    folder = tmp_path_factory.mktemp("prefix")
    command = ["cmake", "--install", os.environ["PHOTIC_BUILD"], "--prefix", folder]
    subprocess.run(command, check=True, capture_output=True, stdin=subprocess.DEVNULL)
    return folder


def environment_without_build(program_folder):
    """Nothing of the build or of the source tree in it: PATH alone leads to Photic."""
    kept = {key: value for key, value in os.environ.items() if not key.startswith(("PHOTIC", "PYTHONPATH"))}
    return kept | {"PATH": f"{program_folder}:/usr/bin:/bin"}


@pytest.fixture
def installed_environment(prefix):
    return environment_without_build(prefix / "bin")


def pytest_sessionfinish(session):
    """A skipped test is a failed one: nothing here may go unseen."""
    reporter = session.config.pluginmanager.get_plugin("terminalreporter")
    if reporter.stats.get("skipped") and session.exitstatus == 0:
        session.exitstatus = pytest.ExitCode.TESTS_FAILED


@pytest.fixture
def start(program, tmp_path, scene):
    """Starts a run; whatever is left of it is killed at the end."""
    started = []

    def call(*arguments, **options):
        pipes = {"stdin": subprocess.DEVNULL, "stdout": subprocess.PIPE, "stderr": subprocess.PIPE}
        process = subprocess.Popen(
            [program, "run", "quick.toml", *map(str, arguments)], cwd=tmp_path, text=True, **(pipes | options)
        )
        started.append(process)
        return process

    yield call
    for process in started:
        process.kill()
        process.communicate()
