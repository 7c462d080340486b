"""What the tallies take: in memory, as the limit counts it, and in files. Without sanitizers, which take more."""

import os
import re
import subprocess

import netCDF4
import pytest


@pytest.fixture
def write(scene, tmp_path):
    """A scene of the ship's lidar over clear water, with its telescope so many times."""
    head, telescope = scene.read_text().split("[[channel]]")[0].split("[[telescope]]")

    def call(name, telescopes, channel, gates, photons):
        path = tmp_path / name
        path.write_text(
            f"{head}{telescopes * ('[[telescope]]' + telescope)}[[channel]]\nname = \"c\"\n{channel}\n"
            f"[[sea.layer]]\nchlorophyll_mg_m3 = 0.1\n[gates]\ndepth_max_m = 50\n"
            f"depth_step_m = {50 / gates!r}\n[simulation]\nphotons = {photons}\n"
        )
        return path

    return call


def megabytes(program, scene, *arguments):
    """The most that a run has in memory."""
    run = [program, "run", scene, "-o", scene.with_suffix(".nc"), "--threads", "2", *arguments]
    process = subprocess.Popen(run, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    _, status, used = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    assert process.returncode == 0
    return used.ru_maxrss / 1024


SIXTY = "centre_nm = { from = 540, to = 658, step = 2 }\nfwhm_nm = 3.0"


def test_sixty_channels_of_a_thousand_gates(program, write, tmp_path):
    # Seen red: with as many cells of depth as gates, where it takes 3.3 GB; with tallies that are filled with zeros.
    scene = write("sixty.toml", 1, SIXTY, 1000, 20000)
    assert megabytes(program, scene) < 400
    with netCDF4.Dataset(tmp_path / "sixty.nc") as file:
        assert file["echo_by_depth"].shape == (1, 60, 1000, 100)


def test_files_of_many_gates_are_small(photic, write, tmp_path):
    # Seen red: with as many cells of depth as gates.
    write("many.toml", 1, 'process = "elastic"', 5000, 20000)
    assert photic("run", "many.toml").returncode == 0
    assert (tmp_path / "many.nc").stat().st_size < 20e6
    assert photic("run", "many.toml", "--set", "gates.depth_cells=0", "-o", "few.nc").returncode == 0
    with netCDF4.Dataset(tmp_path / "few.nc") as file:
        assert "depth" not in file.dimensions and "echo_by_depth" not in file.variables


def test_the_limit_counts_what_is_used(program, photic, write):
    # Seen red: without the counts of scores by octave; without the sums before an incomplete batch.
    lit = ["--set", "simulation.estimator=forward", "--set", "simulation.scored_points=16"]
    small = write("small.toml", 10, 'process = "elastic"', 2, 1000)
    rest = megabytes(program, small, *lit)
    scene = write("lit.toml", 10, 'process = "elastic"', 3000, 82000)
    used = megabytes(program, scene, *lit) - rest
    write("many.toml", 10, 'process = "elastic"', 60000, 1000)
    refused = photic("check", "many.toml", *lit).stderr
    stated = float(re.search(r"would take ([0-9.]+) GiB", refused)[1]) * 1024 * 3000 / 60000
    assert used == pytest.approx(stated, rel=0.3)
