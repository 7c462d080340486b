"""What a run finds where its result is to go: nothing is lost that took longer, and two runs do not share a name."""

import resource
import shutil
import signal
import socket
import subprocess

import netCDF4
import pytest
from test_checkpoint import killed, photons_in
from test_interrupt import wait_until_it_listens

OTHER_WATER = ("--set", "sea.layer.0.chlorophyll_mg_m3=0.4")
LEFT = "choose another name with -o, or --force to replace it)\n"


@pytest.fixture
def run(photic):
    def call(*arguments, code=0, **options):
        done = photic("run", *arguments, **options)
        assert done.returncode == code, done.stderr
        return done

    return call


def names(folder):
    return sorted(p.name for p in folder.iterdir())


def chlorophyll_in(path):
    with netCDF4.Dataset(path) as file:
        return [line for line in file.scene.splitlines() if line.startswith("chlorophyll_mg_m3")][0]


# --- The same scene ------------------------------------------------------------------------------


def test_the_same_command_works_twice(run, scene, tmp_path):
    run("quick.toml")
    assert run("quick.toml").stderr == ""
    assert run("quick.toml", "--photons", "30000").stderr == ""
    assert photons_in(tmp_path / "quick.nc") == 30000
    assert names(tmp_path) == ["quick.nc", "quick.toml"]


def test_more_photons_of_the_same_scene_are_not_replaced(run, scene, tmp_path):
    # Seen red: with the look after the run only.
    run("quick.toml", "--photons", "40000")
    before = (tmp_path / "quick.nc").read_bytes()
    done = run("quick.toml", "--photons", "39999", code=2)
    assert done.stdout == ""
    assert done.stderr == (
        "quick.nc: holds 40000 photons of this scene, more than the 39999 requested, and is left as it is (add to them "
        "with --continue quick.nc, " + LEFT
    )
    assert (tmp_path / "quick.nc").read_bytes() == before
    assert names(tmp_path) == ["quick.nc", "quick.toml"]
    run("quick.toml", "--photons", "6000", "--force")
    assert photons_in(tmp_path / "quick.nc") == 6000


def test_they_are_of_the_same_scene_whatever_its_file_is_called(run, scene, tmp_path):
    run("quick.toml", "--photons", "40000")
    scene.rename(tmp_path / "renamed.toml")
    assert "holds 40000 photons" in run("renamed.toml", "-o", "quick.nc", code=2).stderr
    assert run("renamed.toml", "-o", "quick.nc", "--photons", "50000").stderr == ""


def test_a_run_that_time_ends_too_early_is_written_beside(run, scene, tmp_path):
    # Seen red: with the result in the place of more photons; with a fixed number.
    run("quick.toml", "--photons", "3e7", "--max-time", "5s")
    before = photons_in(tmp_path / "quick.nc")
    for name in ("quick-2.nc", "quick-3.nc"):
        done = run("quick.toml", "--photons", "1e15", "--max-time", "0.01s")
        assert photons_in(tmp_path / name) < before == photons_in(tmp_path / "quick.nc")
        assert done.stderr == (
            f"quick.nc: holds {before} photons of this scene, more than this run's {photons_in(tmp_path / name)}, and is "
            f"left as it is: see {name}\n"
        )
        assert f"Result: {name}\n" in done.stdout
    assert names(tmp_path) == ["quick-2.nc", "quick-3.nc", "quick.nc", "quick.toml"]


def test_a_name_beside_that_another_run_has_is_passed_over(run, start, scene, tmp_path):  # noqa: F811
    # Seen red: refused after all the work.
    run("quick.toml", "--photons", "3e7", "--max-time", "3s")
    other = start("--photons", "1e15", "-o", "quick-2.nc")
    wait_until_it_listens(other)
    done = run("quick.toml", "--photons", "1e15", "--max-time", "0.01s")
    assert "Result: quick-3.nc\n" in done.stdout
    other.send_signal(signal.SIGINT)
    other.communicate(timeout=60)


def test_an_interrupted_run_does_not_replace_a_longer_one(run, start, scene, tmp_path, program):  # noqa: F811
    run("quick.toml", "--photons", "3e7", "--max-time", "5s")
    before = photons_in(tmp_path / "quick.nc")
    process = start("--photons", "1e15")
    wait_until_it_listens(process)
    process.send_signal(signal.SIGINT)
    out, errors = process.communicate(timeout=60)
    assert process.returncode == 130
    assert errors.endswith("left as it is: see quick-2.nc\n")
    assert f"Continue: {program} run --continue quick-2.nc -o quick-2.nc\n" in out
    assert photons_in(tmp_path / "quick.nc") == before > photons_in(tmp_path / "quick-2.nc")


# --- The scene file, edited ----------------------------------------------------------------------


def test_of_an_edited_scene_the_older_result_is_kept_once(run, scene, tmp_path):
    # Seen red: with the older result gone.
    run("quick.toml", "--photons", "40000")
    scene.write_text(scene.read_text().replace("chlorophyll_mg_m3 = 0.1", "chlorophyll_mg_m3 = 0.2"))
    done = run("quick.toml", "--photons", "6000")
    assert done.stderr == "quick.previous.nc: what quick.nc held before\n"
    assert photons_in(tmp_path / "quick.previous.nc") == 40000
    assert chlorophyll_in(tmp_path / "quick.nc") == "chlorophyll_mg_m3 = 0.2"
    assert run("quick.toml", "--photons", "6000").stderr == ""
    # Seen red: with 6000 photons in the place of 40000.
    done = run("quick.toml", *OTHER_WATER, "--photons", "50000")
    assert done.stderr == "quick.previous.nc: holds 40000 photons and stays; the 6000 of quick.nc are replaced\n"
    assert photons_in(tmp_path / "quick.previous.nc") == 40000
    assert run("quick.toml", "--photons", "6000").stderr == "quick.previous.nc: what quick.nc held before\n"
    assert photons_in(tmp_path / "quick.previous.nc") == 50000
    assert names(tmp_path) == ["quick.nc", "quick.previous.nc", "quick.toml"]
    assert run("quick.toml", *OTHER_WATER, "--force").stderr == ""
    assert photons_in(tmp_path / "quick.previous.nc") == 50000


def test_a_link_is_followed(run, scene, tmp_path):
    (tmp_path / "disk").mkdir()
    (tmp_path / "quick.nc").symlink_to("disk/real.nc")
    run("quick.toml")
    assert (tmp_path / "quick.nc").is_symlink()
    assert "disk/real.previous.nc: what quick.nc held before\n" in run("quick.toml", *OTHER_WATER).stderr
    assert (tmp_path / "quick.nc").is_symlink()
    assert names(tmp_path / "disk") == ["real.nc", "real.previous.nc"]


def test_a_full_disk_moves_nothing(photic, run, scene, tmp_path):
    # Seen red: with the older result renamed before the new one is written.
    run("quick.toml")
    run("quick.toml", *OTHER_WATER)
    before = {p.name: p.read_bytes() for p in tmp_path.iterdir()}
    full = {"preexec_fn": lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (4096, 4096)), "restore_signals": False}
    done = photic("run", "quick.toml", **full)  # EFBIG for ENOSPC
    assert done.returncode == 1
    assert done.stderr == "photic: quick.nc: cannot write the file: File too large\n"
    assert {p.name: p.read_bytes() for p in tmp_path.iterdir()} == before


def test_nobody_else_s_file_is_taken_for_an_older_result(run, scene, tmp_path):
    run("quick.toml")
    (tmp_path / "quick.previous.nc").write_text("notes")
    done = run("quick.toml", *OTHER_WATER, code=2)
    assert done.stderr.startswith("quick.previous.nc: not a netCDF file; quick.nc would be kept under this name, and is ")
    assert (tmp_path / "quick.previous.nc").read_text() == "notes"


# --- Another scene file, or none -----------------------------------------------------------------


def test_the_result_of_another_scene_file_is_not_replaced(run, scene, tmp_path):
    # Seen red: without a name of the scene in the result; with the name alone, without its folder.
    run("quick.toml", "-o", "echo.nc")
    other = tmp_path / "campaign" / "quick.toml"
    other.parent.mkdir()
    other.write_text(scene.read_text().replace("chlorophyll_mg_m3 = 0.1", "chlorophyll_mg_m3 = 0.2"))
    before = (tmp_path / "echo.nc").read_bytes()
    done = run("campaign/quick.toml", "-o", "echo.nc", code=2)
    assert done.stdout == "", "printed before the run"
    assert done.stderr == (
        "echo.nc: is the result of another scene file, quick.toml, and is left as it is (" + LEFT
    )
    assert (tmp_path / "echo.nc").read_bytes() == before
    run("campaign/quick.toml", "-o", "echo.nc", "--force")
    assert chlorophyll_in(tmp_path / "echo.nc") == "chlorophyll_mg_m3 = 0.2"
    done = run("../quick.toml", "-o", "../echo.nc", code=2, cwd=other.parent)
    assert "another scene file, campaign/quick.toml, and" in done.stderr


def test_a_folder_that_moved_has_the_same_scene(run, scene, tmp_path):
    # Seen red: without a look at whether the scene is still where it was.
    campaign = tmp_path / "campaign"
    campaign.mkdir()
    shutil.move(scene, campaign / "quick.toml")
    run("quick.toml", cwd=campaign)
    run("campaign/quick.toml", "-o", "out.nc")
    moved = tmp_path / "archive"
    campaign.rename(moved)
    assert run("quick.toml", *OTHER_WATER, cwd=moved).stderr == "quick.previous.nc: what quick.nc held before\n"
    done = run("archive/quick.toml", "-o", "out.nc", *OTHER_WATER)
    assert done.stderr == "out.previous.nc: what out.nc held before\n"


def test_the_scene_of_a_continued_run_keeps_its_file(run, scene, tmp_path):
    # Seen red: with whole paths in the result.
    (tmp_path / "out").mkdir()
    run("quick.toml", "-o", "old.nc")
    run("--continue", "old.nc", "--photons", "24000", "-o", "out/new.nc")
    with netCDF4.Dataset(tmp_path / "out/new.nc") as file:
        assert file.scene_file == "../quick.toml"
    assert run("quick.toml", "-o", "out/new.nc", *OTHER_WATER).stderr.startswith("out/new.previous.nc: ")


def test_what_is_no_result_is_not_replaced(run, photic, scene, tmp_path):
    # Seen red: with every file taken for a result.
    (tmp_path / "notes.nc").write_text("notes")
    (tmp_path / "notes.csv").write_text("notes\n# Photic\n")
    with netCDF4.Dataset(tmp_path / "sst.nc", "w"):
        pass
    for name in ("optics.nc", "optics.csv"):
        assert photic("optics", "quick.toml", "-o", name).returncode == 0
    before = {p.name: p.read_bytes() for p in tmp_path.iterdir()}
    for name, reason in {
        "notes.nc": "not a netCDF file",
        "notes.csv": "is no result of a run",
        "sst.nc": "a netCDF file, but not a result of Photic: it has no attribute photic_format",
        "optics.nc": "holds the optics of layers, and no echoes",
        "optics.csv": "is no result of a run",
    }.items():
        done = run("quick.toml", "-o", name, code=2)
        assert done.stdout == ""
        assert done.stderr == f"{name}: {reason}, and is left as it is ({LEFT}"
    assert {p.name: p.read_bytes() for p in tmp_path.iterdir()} == before
    run("quick.toml", "-o", "notes.nc", "--force")
    assert photons_in(tmp_path / "notes.nc") == 20000


def test_an_empty_file_is_nobody_s(run, scene, tmp_path):
    (tmp_path / "quick.nc").touch()
    assert run("quick.toml").stderr == ""
    assert names(tmp_path) == ["quick.nc", "quick.toml"]


def test_force_never_replaces_the_scene_or_its_files(photic, scene, tmp_path):
    scene.rename(tmp_path / "scene.csv")
    before = (tmp_path / "scene.csv").read_text()
    assert photic("run", "scene.csv", "-o", "scene.csv", "--force").returncode == 2
    assert (tmp_path / "scene.csv").read_text() == before


def test_optics_never_replace_a_result(run, photic, scene, tmp_path):
    # Seen red: without the look.
    run("quick.toml")
    run("quick.toml", "-o", "quick.csv")
    before = {p.name: p.read_bytes() for p in tmp_path.iterdir()}
    for name in ("quick.nc", "quick.csv"):
        done = photic("optics", "quick.toml", "-o", name)
        assert done.returncode == 2
        assert done.stderr == f"{name}: holds echoes of a run, and is left as it is (choose another name with -o)\n"
    assert {p.name: p.read_bytes() for p in tmp_path.iterdir()} == before
    for _ in range(2):
        assert photic("optics", "quick.toml", "-o", "optics.nc").returncode == 0


# --- CSV -----------------------------------------------------------------------------------------


def test_a_csv_does_not_name_its_scene_and_is_kept(run, scene, tmp_path):
    # Seen red: with the older one gone.
    run("quick.toml", "-o", "echo.csv")
    before = (tmp_path / "echo.csv").read_bytes()
    done = run("quick.toml", "-o", "echo.csv", "--photons", "6000")
    assert done.stderr == "echo.previous.csv: what echo.csv held before\n"
    assert (tmp_path / "echo.previous.csv").read_bytes() == before


def test_an_interrupted_run_does_not_replace_a_longer_csv(run, start, scene, tmp_path):  # noqa: F811
    run("quick.toml", "-o", "echo.csv", "--photons", "3e7", "--max-time", "5s")
    before = (tmp_path / "echo.csv").read_bytes()
    process = start("--photons", "1e15", "-o", "echo.csv")
    wait_until_it_listens(process)
    process.send_signal(signal.SIGINT)
    process.communicate(timeout=60)
    assert (tmp_path / "echo.csv").read_bytes() == before
    assert (tmp_path / "echo-2.csv").exists()


# --- Checkpoints ---------------------------------------------------------------------------------


def test_the_checkpoint_of_an_edited_scene_is_kept_once(run, start, scene, tmp_path):  # noqa: F811
    # Seen red: with the older checkpoint gone.
    checkpoint = tmp_path / "quick.checkpoint.nc"
    photons = killed(start, checkpoint, "--checkpoint", "0.2s", "--seed", "2")
    done = run("quick.toml", "--photons", "1e15", "--max-time", "1s", "--checkpoint", "0.1s")
    assert done.stderr == "quick.checkpoint.previous.nc: what quick.checkpoint.nc held before\n"
    assert photons_in(tmp_path / "quick.checkpoint.previous.nc") == photons
    assert names(tmp_path) == ["quick.checkpoint.previous.nc", "quick.nc", "quick.toml"]


def test_the_checkpoint_of_another_scene_stays(run, start, scene, tmp_path):  # noqa: F811
    # Seen red: with the checkpoint of this run in its place.
    checkpoint = tmp_path / "echo.checkpoint.nc"
    killed(start, checkpoint, "-o", "echo.nc", "--checkpoint", "0.2s", "--seed", "2")
    before = checkpoint.read_bytes()
    shutil.copy(scene, tmp_path / "other.toml")
    done = run("other.toml", "-o", "echo.nc", "--photons", "1e15", "--max-time", "1s", "--checkpoint", "0.1s")
    assert done.stderr == (
        "echo.checkpoint.nc: is the result of another scene file, quick.toml, and is left as it is: this run's "
        "checkpoint is echo.checkpoint-2.nc\n"
    )
    assert checkpoint.read_bytes() == before
    assert names(tmp_path) == ["echo.checkpoint.nc", "echo.nc", "other.toml", "quick.toml"]


# --- Two runs at once ----------------------------------------------------------------------------


def test_the_second_of_two_runs_is_warned(run, start, scene, tmp_path):  # noqa: F811
    # Seen red: without a lock; with another one for the checkpoint than for the result.
    process = start("--photons", "1e15")
    wait_until_it_listens(process)
    who = f"process {process.pid} on {socket.gethostname()}"
    (tmp_path / "link.nc").symlink_to("quick.nc")
    for name in ("quick.nc", "quick.csv", "quick.checkpoint.nc", "./quick.nc", "link.nc"):
        done = run("quick.toml", "-o", name, "--photons", "4000", "--force", code=2)
        assert done.stderr == f"{name}: {who} is at work on it (wait for its end, or choose another name with -o)\n"
    assert run("quick.toml", "--photons", "4000", "-o", "other.nc").stderr == ""
    process.send_signal(signal.SIGINT)
    process.communicate(timeout=60)
    assert names(tmp_path) == ["link.nc", "other.nc", "quick.nc", "quick.toml"]
    assert run("quick.toml", "--photons", "1e9", "--max-time", "2s").returncode == 0


def test_kill_9_leaves_no_lock(run, start, scene, tmp_path):  # noqa: F811
    # Seen red: with the lock's file left at the end of a run.
    process = start("--photons", "1e15")
    wait_until_it_listens(process)
    process.kill()
    process.communicate()
    assert run("quick.toml").stderr == ""
    assert names(tmp_path) == ["quick.nc", "quick.toml"]


def test_of_many_runs_that_begin_at_once_one_has_the_name(program, scene, tmp_path):
    # Seen red: without a lock. They open and remove its file in each other's way as long as the first has not begun.
    command = [program, "run", "quick.toml", "--photons", "1e15", "--max-time", "8s", "--threads", "1"]
    pipes = {"cwd": tmp_path, "stdin": subprocess.DEVNULL, "stdout": subprocess.PIPE, "stderr": subprocess.PIPE}
    runs = [subprocess.Popen(command, text=True, **pipes) for _ in range(6)]
    ends = [(process.communicate(timeout=120)[1], process.returncode) for process in runs]
    assert sorted(code for _, code in ends) == [0, 2, 2, 2, 2, 2]
    for errors, code in ends:
        assert errors == "" if code == 0 else "is at work on it" in errors
    assert names(tmp_path) == ["quick.nc", "quick.toml"]
