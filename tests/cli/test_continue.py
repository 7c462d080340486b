"""photic run --continue: a run in several sittings equals one long run; what cannot be gone on from is refused."""

import math
import tomllib

import netCDF4
import pytest
from test_reproducible import contents


@pytest.fixture
def run(photic):
    def call(*arguments, code=0):
        done = photic("run", *arguments)
        assert done.returncode == code, done.stderr
        return done

    return call


SMALLEST = ["--set", "simulation.batch_photons=250"]  # of few photons


# 23600 photons end within a batch of 500, 24000 with one.
@pytest.mark.parametrize("earlier", [23600, 24000])
@pytest.mark.parametrize("threads", [1, 3])
def test_two_sittings_equal_one_long_run(run, scene, tmp_path, earlier, threads):
    # Seen red: with the incomplete batch left in the state; with the state of by_depth as floats in the file; with
    # batch_photons chosen anew by the photons of the longer run.
    run("quick.toml", "--photons", "61500", "-o", "long.nc", "--set", "simulation.batch_photons=500")
    run("quick.toml", "--photons", earlier, "-o", "old.nc", "--threads", threads)
    done = run("quick.toml", "--photons", "61500", "--continue", "old.nc", "-o", "new.nc", "--threads", threads)
    assert done.stderr == ""
    assert contents(tmp_path / "new.nc") == contents(tmp_path / "long.nc")
    assert len(contents(tmp_path / "new.nc")[0]) > 30
    assert contents(tmp_path / "old.nc") != contents(tmp_path / "long.nc")
    with netCDF4.Dataset(tmp_path / "new.nc") as new, netCDF4.Dataset(tmp_path / "old.nc") as old:
        assert new.wall_time_s > old.wall_time_s
        first, second = new.history.splitlines()
        assert first.endswith(f"photic run quick.toml --photons {earlier} -o old.nc --threads {threads}")
        assert "--continue old.nc" in second


def test_the_scene_may_be_left_out_and_the_result_replaced(run, scene, tmp_path):
    run("quick.toml", "--set", "sea.layer.0.chlorophyll_mg_m3=0.4", "--photons", "41000", "-o", "long.nc", *SMALLEST)
    run("quick.toml", "--set", "sea.layer.0.chlorophyll_mg_m3=0.4", "--photons", "7000", "-o", "echo.nc")
    scene.unlink()
    run("--continue", "echo.nc", "--photons", "9000")
    done = run("--continue", "echo.nc", "--photons", "41000")
    assert "Result: echo.nc\n" in done.stdout
    assert contents(tmp_path / "echo.nc") == contents(tmp_path / "long.nc")
    assert sorted(p.name for p in tmp_path.iterdir()) == ["echo.nc", "long.nc"]


def test_without_a_scene_and_with_a_checkpoint_the_result_has_the_result_s_name(run, scene, tmp_path):
    # Seen red: with the name of the checkpoint.
    run("quick.toml", "-o", "echo.checkpoint.nc")
    assert "Result: echo.nc\n" in run("--continue", "echo.checkpoint.nc", "--photons", "30000").stdout


def test_a_run_ended_by_time_goes_on(run, scene, tmp_path):
    run("quick.toml", "--photons", "1e15", "--max-time", "0.4s")
    with netCDF4.Dataset(tmp_path / "quick.nc") as old:
        total = int(old.photons) + 12345
        batch = tomllib.loads(old.scene)["simulation"]["batch_photons"]
    run("quick.toml", "--photons", total, "--continue", "quick.nc", "-o", "new.nc", "--max-time", "1h")
    run("quick.toml", "--photons", total, "-o", "long.nc", "--max-time", "1h", "--set", f"simulation.batch_photons={batch}")
    assert contents(tmp_path / "new.nc") == contents(tmp_path / "long.nc")


def test_the_same_total_again_changes_nothing(run, scene, tmp_path):
    run("quick.toml", "--photons", "5000")
    before = contents(tmp_path / "quick.nc")
    done = run("quick.toml", "--photons", "5000", "--continue", "quick.nc")
    assert done.stderr == "quick.nc: already holds all 5000 photons requested (--photons is the total)\n"
    assert contents(tmp_path / "quick.nc") == before


REFUSED = {
    ("--photons", "19999"): "old.nc: holds 20000 photons already, more than the 19999 requested "
    "(--photons is the total, not what is added)\n1 problem in old.nc\n",
    ("--set", "simulation.batch_photons=1000"): "old.nc: simulation.batch_photons was 500 and is 1000 now (a continued "
    "run may change only photons, target_relative_error and max_time_s)\n1 problem in old.nc\n",
    ("--seed", "2"): "old.nc: simulation.seed was 1 and is 2 now (a continued run may change only photons, "
    "target_relative_error and max_time_s)\n1 problem in old.nc\n",
    ("--set", "sea.layer.1.cdom_a440_per_m=0.5", "--set", "simulation.max_order=3"):
    "old.nc: sea.layer.1.cdom_a440_per_m was 0 and is 0.5 now\n"
    "old.nc: simulation.max_order was not given and is 3 now "
    "(a continued run may change only photons, target_relative_error and max_time_s)\n2 problems in old.nc\n",
}  # fmt: skip


@pytest.mark.parametrize("flags", REFUSED, ids=" ".join)
def test_another_scene_is_refused(run, scene, tmp_path, flags):
    # Seen red: without the comparison; with the seed among what may change.
    run("quick.toml", "-o", "old.nc")
    before = (tmp_path / "old.nc").read_bytes()
    for arguments in [("quick.toml",), ()]:  # the scene's file, or the scene in the result
        done = run(*arguments, *flags, "--continue", "old.nc", "-o", "old.nc", code=2)
        assert (done.stdout, done.stderr) == ("", REFUSED[flags])
    assert (tmp_path / "old.nc").read_bytes() == before


def test_what_only_ends_a_run_may_change(run, scene):
    # Seen red: with the time compared.
    run("quick.toml", "-o", "old.nc")
    run("quick.toml", "--continue", "old.nc", "--photons", "30000", "--target", "30%", "--max-time", "1h")


def test_another_version_is_refused(run, scene, tmp_path):
    # Seen red: without the check.
    run("quick.toml", "-o", "old.nc")
    with netCDF4.Dataset(tmp_path / "old.nc", "a") as old:
        now = old.version
        old.setncattr("version", "0.0.9")
    done = run("quick.toml", "--continue", "old.nc", code=2)
    assert done.stderr == (
        f"old.nc: made by Photic 0.0.9; this one, {now}, may simulate other photons "
        "(continue with Photic 0.0.9, or start anew)\n1 problem in old.nc\n"
    )


def test_another_phase_function_behind_the_same_name_is_refused(run, scene, tmp_path):
    def table(forward):
        phase = [(angle, (1 + forward * math.cos(math.radians(angle))) / (4 * math.pi)) for angle in range(181)]
        rows = "".join(f"{angle},{value}\n" for angle, value in phase)
        (tmp_path / "phase.csv").write_text("angle_deg,phase_function_per_sr\n" + rows)

    table(0.5)
    text = scene.read_text().replace("chlorophyll_mg_m3 = 1.0", (
        'iop = [{wavelength_nm = 532.0, a_per_m = 0.06, b_per_m = 0.1}, {wavelength_nm = 660.0, a_per_m = 0.4, '
        'b_per_m = 0.1}]\nphase_function = {model = "table", file = "phase.csv"}'))
    scene.write_text(text)
    run("quick.toml", "-o", "old.nc")
    run("quick.toml", "-o", "new.nc", "--continue", "old.nc", "--photons", "24000")
    table(0.6)
    done = run("quick.toml", "-o", "new.nc", "--continue", "old.nc", "--photons", "24000", code=2)
    assert done.stderr.startswith(
        "old.nc: sea.layer.1.phase_function.file.phase_function_per_sr was an array of 181 and is one with 180 other "
        "values now ("
    )


def test_files_that_hold_no_run(run, scene, tmp_path):
    (tmp_path / "notes.nc").write_text("these are notes")
    with netCDF4.Dataset(tmp_path / "sst.nc", "w"):
        pass
    done = run("quick.toml", "--continue", "notes.nc", code=2)
    assert done.stderr.splitlines()[0].startswith("notes.nc: not a netCDF file (")
    assert done.stderr.splitlines()[1] == "1 problem in notes.nc"
    done = run("quick.toml", "--continue", "sst.nc", code=2)
    assert done.stderr.startswith("sst.nc: a netCDF file, but not a result of Photic: ")
    run("quick.toml", "-o", "echo.csv")
    done = run("quick.toml", "--continue", "echo.csv", code=2)
    assert done.stderr.startswith("echo.csv: not a netCDF file")
    done = run("quick.toml", "--continue", "none.nc", code=2)
    assert done.stderr.startswith("none.nc: there is no such file (a result is what")
    assert sorted(p.name for p in tmp_path.iterdir()) == ["echo.csv", "notes.nc", "quick.toml", "sst.nc"]


def test_a_torn_result_is_refused(run, scene, tmp_path):
    run("quick.toml", "-o", "old.nc")
    whole = (tmp_path / "old.nc").read_bytes().rstrip(b"\0")
    for share in (0.1, 0.5, 0.9, 0.99):
        (tmp_path / "old.nc").write_bytes(whole[: int(share * len(whole))])
        done = run("quick.toml", "--continue", "old.nc", code=2)
        assert done.stderr.startswith("old.nc: a damaged ")
