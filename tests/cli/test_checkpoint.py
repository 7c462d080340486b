"""Checkpoints: what kill -9, a full disk and Ctrl-C leave of a run, and how it goes on."""

import resource
import signal
import time

import netCDF4
from test_interrupt import wait_until_it_listens
from test_reproducible import contents

YEARS = ("--photons", "1e15")
LARGEST = ["--set", "simulation.batch_photons=8000"]  # of that many


def photons_in(path):
    with netCDF4.Dataset(path) as file:
        return int(file.photons)


def wait_for(process, path):
    limit = time.monotonic() + 60
    while not path.exists():
        assert process.poll() is None, process.communicate()
        assert time.monotonic() < limit
        time.sleep(0.02)


def killed(start, path, *arguments):
    """The photons of the checkpoint that a killed run left."""
    process = start(*YEARS, *arguments)
    wait_for(process, path)
    process.kill()
    process.communicate()
    assert process.returncode == -signal.SIGKILL
    return photons_in(path)


def test_kill_9_loses_no_more_than_the_interval(photic, start, tmp_path):
    # Seen red: with the clock of the checkpoints started anew at every batch; with one checkpoint only.
    process = start(*YEARS, "--checkpoint", "1s")
    checkpoint = tmp_path / "quick.checkpoint.nc"
    wait_for(process, checkpoint)
    first = photons_in(checkpoint)
    time.sleep(2.5)
    process.kill()
    age = time.time() - checkpoint.stat().st_mtime
    process.communicate()
    assert age < 1 + 0.5, "half a second for a busy machine"
    photons = photons_in(checkpoint)
    assert photons > first
    assert not (tmp_path / "quick.nc").exists()
    with netCDF4.Dataset(checkpoint) as file:
        assert (file.stopped_by, file.partial) == ("checkpoint", 1)

    total = photons + 4321
    done = photic("run", "quick.toml", "--continue", "quick.checkpoint.nc", "--photons", total)
    assert (done.returncode, done.stderr) == (0, "")
    assert not checkpoint.exists(), "the result holds it all"
    assert photic("run", "quick.toml", "--photons", total, "-o", "long.nc", *LARGEST).returncode == 0
    assert contents(tmp_path / "quick.nc") == contents(tmp_path / "long.nc")


def test_a_run_that_ends_leaves_no_checkpoint(photic, scene, tmp_path):
    # Seen red: without the removal.
    done = photic("run", "quick.toml", *YEARS, "--max-time", "1s", "--checkpoint", "0.1s")
    assert (done.returncode, done.stderr) == (0, "")
    assert sorted(p.name for p in tmp_path.iterdir()) == ["quick.nc", "quick.toml"]


def test_a_short_run_writes_none(start, tmp_path):
    # Seen red: with the first one after a second.
    process = start(*YEARS)
    wait_until_it_listens(process)
    time.sleep(2)
    process.kill()
    process.communicate()
    # The lock's file, locked by nobody, goes with the next run of that name (test_kept.py).
    assert sorted(p.name for p in tmp_path.iterdir()) == [".quick.lock", "quick.toml"]


def test_a_csv_result_has_a_netcdf_checkpoint(photic, start, tmp_path):
    checkpoint = tmp_path / "echo.checkpoint.nc"
    total = killed(start, checkpoint, "-o", "echo.csv", "--checkpoint", "0.2s") + 5000
    done = photic("run", "quick.toml", "--continue", checkpoint.name, "--photons", total, "-o", "echo.csv")
    assert done.returncode == 0, done.stderr
    assert photic("run", "quick.toml", "--photons", total, "-o", "long.csv", *LARGEST).returncode == 0
    rows = [[line for line in (tmp_path / name).open() if not line.startswith("#")] for name in ("echo.csv", "long.csv")]
    assert rows[0] == rows[1]
    assert not checkpoint.exists()


def test_what_a_killed_run_left_is_reported_and_never_replaced_by_less(photic, start, tmp_path, program):
    # Seen red: without the line; with a checkpoint of fewer photons written over it; with the removal of what holds more
    # than the result.
    checkpoint = tmp_path / "quick.checkpoint.nc"
    photons = killed(start, checkpoint, "--checkpoint", "1s")
    done = photic("run", "quick.toml", "--photons", "4000", "--checkpoint", "0.001s")
    assert done.returncode == 0
    assert done.stderr == (
        f"quick.checkpoint.nc: left by a run of this scene that did not end, with {photons} photons "
        f"(continue it: {program} run --continue quick.checkpoint.nc -o quick.nc)\n"
    )
    assert photons_in(tmp_path / "quick.nc") == 4000, "not used by itself"
    assert photons_in(checkpoint) == photons

    total = photons + 2000
    done = photic("run", "--continue", "quick.checkpoint.nc", "-o", "quick.nc", "--photons", total)
    assert (done.returncode, done.stderr) == (0, "")
    assert photons_in(tmp_path / "quick.nc") == total
    assert not checkpoint.exists()


def test_a_checkpoint_of_another_scene_is_not_offered(photic, start, tmp_path):
    # Seen red: with the removal of what is no result.
    checkpoint = tmp_path / "quick.checkpoint.nc"
    killed(start, checkpoint, "--checkpoint", "0.2s", "--seed", "2")
    done = photic("run", "quick.toml")
    assert (done.returncode, done.stderr) == (0, "")
    checkpoint.write_text("no netCDF file")
    done = photic("run", "quick.toml")
    assert (done.returncode, done.stderr) == (0, "")
    assert checkpoint.read_text() == "no netCDF file", "not this run's to remove"


def test_a_full_disk_leaves_the_last_good_checkpoint_and_the_run_goes_on(start, tmp_path):
    # Seen red: with the error ending the run; with a warning for every checkpoint.
    process = start(*YEARS, "--checkpoint", "0.3s", restore_signals=False)  # Python ignores SIGXFSZ
    checkpoint = tmp_path / "quick.checkpoint.nc"
    wait_for(process, checkpoint)
    resource.prlimit(process.pid, resource.RLIMIT_FSIZE, (4096, resource.RLIM_INFINITY))  # EFBIG for ENOSPC
    time.sleep(0.5)
    photons = photons_in(checkpoint)
    time.sleep(1.5)
    assert process.poll() is None, process.communicate()
    assert photons_in(checkpoint) == photons
    resource.prlimit(process.pid, resource.RLIMIT_FSIZE, (resource.RLIM_INFINITY, resource.RLIM_INFINITY))
    time.sleep(1)
    assert photons_in(checkpoint) > photons
    process.send_signal(signal.SIGTERM)
    _, errors = process.communicate(timeout=60)
    assert process.returncode == 128 + signal.SIGTERM
    assert errors == (
        "quick.checkpoint.nc: cannot write the file: File too large (the run continues without this checkpoint)\n"
    )
    assert sorted(p.name for p in tmp_path.iterdir()) == ["quick.nc", "quick.toml"]


def test_a_disk_that_is_full_at_the_end_leaves_the_checkpoint(start, tmp_path):
    # Seen red: with the checkpoint removed before the result is written.
    process = start(*YEARS, "--checkpoint", "0.3s", restore_signals=False)
    checkpoint = tmp_path / "quick.checkpoint.nc"
    wait_for(process, checkpoint)
    resource.prlimit(process.pid, resource.RLIMIT_FSIZE, (4096, resource.RLIM_INFINITY))
    process.send_signal(signal.SIGTERM)
    out, errors = process.communicate(timeout=60)
    assert process.returncode == 1
    assert "stopped by: interrupt" in out
    assert f"quick.checkpoint.nc: left by a run of this scene that did not end, with {photons_in(checkpoint)} " in errors
    assert errors.endswith("photic: quick.nc: cannot write the file: File too large\n")
    assert sorted(p.name for p in tmp_path.iterdir()) == ["quick.checkpoint.nc", "quick.toml"]


def test_an_interrupted_run_goes_on(photic, start, tmp_path, program):
    # Seen red: without the line that says how.
    process = start(*YEARS)
    wait_until_it_listens(process)
    process.send_signal(signal.SIGTERM)
    out, _ = process.communicate(timeout=60)
    assert f"Continue: {program} run --continue quick.nc -o quick.nc\n" in out
    total = photons_in(tmp_path / "quick.nc") + 7777
    done = photic("run", "--continue", "quick.nc", "-o", "quick.nc", "--photons", total)
    assert (done.returncode, done.stderr) == (0, "")
    assert "Continue:" not in done.stdout
    assert photic("run", "quick.toml", "--photons", total, "-o", "long.nc", *LARGEST).returncode == 0
    assert contents(tmp_path / "quick.nc") == contents(tmp_path / "long.nc")


def test_an_interrupted_run_with_a_csv_result_keeps_its_checkpoint(start, tmp_path, program):
    # Seen red: with the checkpoint removed.
    process = start(*YEARS, "-o", "echo.csv", "--checkpoint", "0.2s")
    wait_for(process, tmp_path / "echo.checkpoint.nc")
    process.send_signal(signal.SIGTERM)
    out, _ = process.communicate(timeout=60)
    assert f"Continue: {program} run --continue echo.checkpoint.nc -o echo.csv\n" in out
    assert sorted(p.name for p in tmp_path.iterdir()) == ["echo.checkpoint.nc", "echo.csv", "quick.toml"]
