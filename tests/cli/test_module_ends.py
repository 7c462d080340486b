"""Ends of runs of the Python module: interrupts, locks of outputs, processes that were forked; and files that are damaged."""

import random
import subprocess
import sys
import time

import numpy
import photic as package
import pytest
from conftest import QUICK_SCENE
from photic import simulation

pytestmark = pytest.mark.filterwarnings("ignore::UserWarning")  # so few photons leave warnings

FOR_EVER = 1e15


@pytest.fixture
def quick():
    return package.Scene(QUICK_SCENE)


def interrupting_once(monkeypatch, name):
    """Has Ctrl-C come in the first call of a function of photic.simulation."""
    function = getattr(simulation, name)

    def interrupted(*arguments):
        monkeypatch.setattr(simulation, name, function)
        raise KeyboardInterrupt

    monkeypatch.setattr(simulation, name, interrupted)


# Seen red: with the result put together after the last look at Ctrl-C.
def test_an_interrupt_while_the_result_is_put_together_loses_nothing(quick, tmp_path, monkeypatch):
    interrupting_once(monkeypatch, "of_arrays")
    with pytest.raises(package.Interrupted, match="the run had ended after 500 photons; the result is in") as error:
        quick.run(photons=500, output=tmp_path / "a.nc")
    assert error.value.partial.identical(package.open(tmp_path / "a.nc"))
    run = quick.start(photons=500)
    interrupting_once(monkeypatch, "of_arrays")
    with pytest.raises(package.Interrupted) as error:
        run.result()
    assert run.result() is error.value.partial


def test_an_interrupt_outside_of_the_wait_can_be_tried_again(quick, monkeypatch):
    run = quick.start(photons=500)
    by_itself(run)
    interrupting_once(monkeypatch, "of_arrays")
    with pytest.raises(KeyboardInterrupt):
        run._keep()
    assert run.result().attrs["photons"] == 500


def by_itself(run):
    while run.progress.phase != "ended":
        time.sleep(0.01)


def by_with(run):
    with run:
        while run.progress.photons == 0:
            time.sleep(0.01)


def by_exception(run):
    def fail(progress):
        raise ValueError

    with pytest.raises(ValueError):
        run.watched(simulation.watcher_of(fail))


# Seen red: with the lock kept until the run is gone.
@pytest.mark.parametrize("end", [by_itself, by_with, by_exception])
def test_a_run_that_has_ended_lets_others_write(quick, tmp_path, end):
    run = quick.start(photons=5000 if end is by_itself else FOR_EVER, output=tmp_path / "a.nc")
    end(run)
    for _ in range(100):
        if not list(tmp_path.glob(".*.lock")):
            break
        time.sleep(0.02)
    assert quick.run(photons=100, output=tmp_path / "a.nc").attrs["photons"] == 100
    if end is by_itself:
        assert run.result().attrs["photons"] == 5000  # more than those there
        assert package.open(tmp_path / "a.nc").attrs["photons"] == 5000
    assert not list(tmp_path.glob(".*.lock"))


def test_a_result_goes_beside_what_another_run_is_writing(quick, tmp_path):
    run = quick.start(photons=2000, output=tmp_path / "a.nc")
    by_itself(run)
    while list(tmp_path.glob(".*.lock")):
        time.sleep(0.01)
    with quick.start(photons=FOR_EVER, output=tmp_path / "a.nc"):
        with pytest.warns(UserWarning, match=r"another run is at work on it, and is left as it is: see .*a-2\.nc"):
            run.result()
    assert package.open(tmp_path / "a-2.nc").attrs["photons"] == 2000 and not (tmp_path / "a.nc").exists()


def test_messages_name_keywords(quick, tmp_path):
    quick.run(photons=500, output=tmp_path / "a.nc")
    with pytest.raises(package.Error, match="add to them with continue_from=.*a.nc, choose another name with output=, or force=True"):
        quick.run(photons=100, output=tmp_path / "a.nc")
    with pytest.raises(package.Error, match=r"photons= is the total"):
        quick.run(photons=100, continue_from=tmp_path / "a.nc")
    with pytest.raises(package.Error, match=r"isa=baseline: only lanes .* \(engine=lanes, or leave it out\)"):
        quick.run(photons=100, isa="baseline", engine="scalar")
    with pytest.raises(package.Error, match=r"\(write output=.*a.pdf.nc, or output=.*a.pdf/ for a folder\)"):
        quick.run(photons=100, output=tmp_path / "a.pdf")


FORKED = """
import os, sys, threading
import photic
scene = photic.Scene.new("ship")
def forked(work):
    child = os.fork()
    if child == 0:
        try:
            work()
        except photic.Error as error:
            print(str(error)[:80])
        sys.stdout.flush()
        os._exit(0)
    assert os.waitpid(child, 0)[1] == 0
run = scene.start(photons=1e15)
def leave():
    with run: pass
    print("left")
for work in (run.result, run.end, run.so_far, leave, run.stop, lambda: run.progress): forked(work)
run.stop()
run.end()
scene.run(photons=100, output="a.nc")
begun, over = threading.Event(), threading.Event()
def hold():
    with photic.netcdf_lock:
        begun.set()
        over.wait()
thread = threading.Thread(target=hold)
thread.start()
begun.wait()
forked(lambda: photic.open("a.nc"))
over.set()
thread.join()
forked(lambda: print(photic.open("a.nc").attrs["photons"]))
with photic.netcdf_lock:
    forked(lambda: print(photic.open("a.nc").attrs["photons"]))
"""


# Seen red: with any of the calls made in the child, which waits for ever.
def test_a_fork_has_no_part_in_runs_and_locks(tmp_path):
    done = subprocess.run(
        [sys.executable, "-W", "ignore", "-c", FORKED], cwd=tmp_path, capture_output=True, text=True, timeout=60, check=False
    )
    assert done.returncode == 0, done.stderr
    result, end, so_far, left, lost, *opened = done.stdout.splitlines()
    assert result.startswith("a process that was forked cannot have the result of a run")
    assert end.startswith("a process that was forked cannot end a run")
    assert so_far.startswith("a process that was forked cannot have a result of a run")
    assert left == "left" and lost.startswith("this process was forked while another thread used netCDF")
    assert opened == ["100", "100"]


DAMAGED = """
import glob, photic
for name in sorted(glob.glob("*.nc")):
    for use in (photic.open, lambda name: photic.Scene.load("scene.toml").run(continue_from=name, photons=600)):
        try: use(name)
        except photic.Error as error: print(error)
"""


# HDF5 1.10 crashes on ten of these files. Seen red: without the process of their own in which they are read first.
def test_damaged_files_are_refused(quick, tmp_path):
    quick.save(tmp_path / "scene.toml")
    quick.run(photons=500, output=tmp_path / "good.nc")
    good = (tmp_path / "good.nc").read_bytes()
    source = random.Random(1)
    for number in range(25):
        damaged = bytearray(good)
        for _ in range(20):
            damaged[source.randrange(len(good))] = source.randrange(256)
        (tmp_path / f"{number}.nc").write_bytes(damaged)
    done = subprocess.run(
        [sys.executable, "-W", "ignore", "-c", DAMAGED], cwd=tmp_path, capture_output=True, text=True, timeout=300, check=False
    )
    assert (done.returncode, done.stderr) == (0, "")
    assert len(done.stdout.splitlines()) >= 40 and "good.nc" not in done.stdout


TRUTHS = {"force": "no", "threads": True}


@pytest.mark.parametrize("name", TRUTHS)
def test_truths_and_numbers_are_not_mixed_up(quick, tmp_path, name):
    with pytest.raises(package.Error, match=f"^{name}: "):
        quick.run(**{"photons": 100, "output": tmp_path / "a.nc", name: TRUTHS[name]})


# Seen red, as a run without an end: with False alone for one.
def test_a_false_of_numpy_ends_a_run(quick):
    echo = quick.run(photons=FOR_EVER, progress=lambda progress: numpy.bool_(progress.photons < 1000))
    assert echo.attrs["partial"] == 1
