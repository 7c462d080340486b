"""The same bits for any number of threads, from any folder, and from the scene a result carries."""

import netCDF4
import numpy as np
import pytest

# What may differ between two runs of one scene.
ABOUT_THE_RUN = {"history", "scene_file", "wall_time_s", "threads", "collisions_per_second"}


def contents(path):
    """Every variable as bytes, those of groups too, and every global attribute that is not about the run itself."""
    with netCDF4.Dataset(path) as file:
        file.set_auto_maskandscale(False)
        variables, attributes = {}, {}
        for group in [file, *file.groups.values()]:
            for name, variable in group.variables.items():
                values = variable[:]
                key = f"{group.path}:{name}"
                variables[key] = values.tobytes() if variable.dtype is not str else tuple(np.ravel(values))
            for name in set(group.ncattrs()) - ABOUT_THE_RUN:
                attributes[f"{group.path}:{name}"] = str(group.getncattr(name))
    return variables, attributes


@pytest.fixture
def result(photic, tmp_path):
    def call(name, *arguments, **options):
        done = photic("run", *arguments, "-o", tmp_path / name, **options)
        assert done.returncode == 0, done.stderr
        return contents(tmp_path / name)

    return call


def test_threads_change_no_bit(result, scene):
    # Seen red: with batches merged as they finish instead of in their order.
    one = result("1.nc", "quick.toml", "--threads", "1")
    assert len(one[0]) > 10
    for threads in (2, 7):
        other = result(f"{threads}.nc", "quick.toml", "--threads", threads)
        assert other == one, f"{threads} threads"


def test_the_seed_does_change_them(result, scene):
    variables, _ = result("1.nc", "quick.toml")
    others, _ = result("2.nc", "quick.toml", "--seed", "2")
    assert variables["/:echo"] != others["/:echo"]
    assert variables["/:gate_time"] == others["/:gate_time"]


def test_the_scene_of_a_result_gives_the_same_result(photic, result, scene, tmp_path):
    first = result("first.nc", "quick.toml", "--seed", "9")
    (tmp_path / "shown.toml").write_text(photic("show", "first.nc").stdout)
    assert result("second.nc", "shown.toml") == first


def test_another_folder_changes_nothing(result, scene, tmp_path):
    first = result("first.nc", "quick.toml")
    assert result("second.nc", scene, cwd="/") == first


def test_a_run_ended_by_time_equals_one_of_that_many_photons(result, scene, tmp_path):
    by_time, _ = result("time.nc", "quick.toml", "--photons", "1e15", "--max-time", "0.3s")
    with netCDF4.Dataset(tmp_path / "time.nc") as file:
        photons = int(file.photons)
    by_photons, _ = result("photons.nc", "quick.toml", "--photons", photons, "--set", "simulation.batch_photons=8000")
    assert by_time == by_photons
