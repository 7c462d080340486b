"""The forward estimator's tools, and analog photons, at the command line."""

import netCDF4

TOOLS = """\
[simulation.tools]
forced_collisions = 3
local_forced_collisions = "all"
weight_threshold = 0.3
at_threshold = "analog-absorption"
importance = [ { depth_m = 2.0, value = 2.5 }, { depth_m = 5.0, value = 6.0 } ]
[[environment]]
set = { "sea.layer.1.chlorophyll_mg_m3" = 2.0 }
"""


def test_bits_do_not_depend_on_threads_or_sittings(photic, scene, tmp_path):
    scene.write_text(scene.read_text() + TOOLS)
    for engine in ("scalar", "lanes"):
        runs = {"one": (20000, "--threads", 1), "two": (20000, "--threads", 2), "seven": (20000, "--threads", 7),
                "first": (8000,), "both": (20000, "--continue", "first.nc")}
        for name, (photons, *more) in runs.items():
            where = () if "--continue" in more else ("quick.toml", "--set", "simulation.batch_photons=250")
            done = photic("run", *where, "--photons", photons, "--engine", engine, *more, "-o", f"{name}.nc")
            assert done.returncode == 0, done.stderr
        with netCDF4.Dataset(tmp_path / "one.nc") as one:
            for name in ("two", "seven", "both"):
                with netCDF4.Dataset(tmp_path / f"{name}.nc") as other:
                    for variable in ("echo", "echo_standard_error", "environment_difference"):
                        assert (one[variable][:] == other[variable][:]).all(), (engine, name, variable)
                    assert one.ledger_roulette == other.ledger_roulette


def test_auto_takes_the_estimator_that_has_them(photic, scene, tmp_path):
    scene.write_text(scene.read_text().replace('"forward"', '"auto"') + "[simulation.tools]\nforced_collisions = 1\n")
    done = photic("run", "quick.toml", "-o", "out.nc")
    assert done.returncode == 0, done.stderr
    with netCDF4.Dataset(tmp_path / "out.nc") as file:
        assert file.estimator == "forward"
        assert "the only one with the requested tools in this version" in file.scene


def test_they_are_refused_where_they_mean_nothing(photic, scene):
    scene.write_text(scene.read_text() + TOOLS)
    for estimator in ("bidirectional", "analog"):
        done = photic("check", "quick.toml", "--set", f"simulation.estimator={estimator}")
        assert done.returncode == 2
        assert f"--set simulation.estimator: the {estimator} estimator cannot use simulation.tools" in done.stderr
    scene.write_text(scene.read_text().split("[simulation.tools]", maxsplit=1)[0] + "[[environment]]\nset = {}\n")
    done = photic("check", "quick.toml", "--set", "simulation.estimator=analog")
    assert done.returncode == 2
    assert "the analog estimator cannot use environments: its photons have no weights" in done.stderr


def test_what_ending_histories_cuts_is_reported(photic, scene, tmp_path):
    scene.write_text(scene.read_text() + '[simulation.tools]\nweight_threshold = 0.5\nat_threshold = "end"\n')
    done = photic("run", "quick.toml", "-o", "out.nc")
    assert done.returncode == 0, done.stderr
    assert "of the launched weight: echoes are low" in " ".join(done.stdout.split())
    with netCDF4.Dataset(tmp_path / "out.nc") as file:
        assert 0.001 < file.ledger_cut_by_weight < 1


def test_analog_photons_are_counted_one_by_one(photic, scene, tmp_path):
    text = scene.read_text().replace('"forward"', '"analog"').replace("diameter_m = 0.40", "diameter_m = 8.0")
    scene.write_text(text.replace("detector_diameter_m = 0.04", "detector_diameter_m = 4.0"))
    done = photic("run", "quick.toml", "-o", "out.nc")
    assert done.returncode == 0, done.stderr
    with netCDF4.Dataset(tmp_path / "out.nc") as file:
        counts = file["echo"][0, 0] * 20000
        assert counts.sum() > 0
        assert abs(counts - counts.round()).max() < 1e-6
