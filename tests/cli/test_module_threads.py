"""The Python module in many threads: results, files, memory, and what stops and calls cost."""

import ctypes
import gc
import os
import statistics
import subprocess
import sys
import threading
import time
from concurrent.futures import ThreadPoolExecutor
from itertools import pairwise

import photic as package
import pytest
from conftest import QUICK_SCENE
from photic.core import context, core

pytestmark = pytest.mark.filterwarnings("ignore::UserWarning")  # so few photons leave warnings

FOR_EVER = 1e15


class Mallinfo(ctypes.Structure):
    """struct mallinfo2 of mallinfo(3)."""

    _fields_ = [
        (name, ctypes.c_size_t)
        for name in "arena ordblks smblks hblks hblkhd usmblks fsmblks uordblks fordblks keepcost".split()
    ]


def bytes_in_use():
    """The bytes that malloc has given out and not got back; resident memory depends on where threads found theirs."""
    mallinfo2 = ctypes.CDLL(None).mallinfo2
    mallinfo2.restype = Mallinfo
    gc.collect()
    information = mallinfo2()
    return information.uordblks + information.hblkhd


def test_twenty_threads_of_different_scenes_are_each_alone():
    scenes = []
    for number in range(20):
        scene = package.Scene(QUICK_SCENE)
        scene.update({"sea.layer.0.chlorophyll_mg_m3": 0.05 + 0.01 * number, "simulation.seed": number})
        scenes.append(scene)
    alone = [scene.run(photons=2000, threads=1) for scene in scenes]
    with ThreadPoolExecutor(20) as pool:
        together = list(pool.map(lambda scene: scene.run(photons=2000, threads=2), scenes))
    assert all(one.echo.identical(other.echo) for one, other in zip(alone, together, strict=True))
    assert len({float(one.echo.sum()) for one in alone}) == 20


def test_one_scene_changed_and_read_by_many_threads():
    scene = package.Scene(QUICK_SCENE)

    def work(number):
        for step in range(20):
            scene.update({"gates.depth_max_m": 10.0 + number, "gates.depth_step_m": (10.0 + number) / 10})
            copy = scene.copy()
            assert copy["gates.depth_max_m"] == pytest.approx(10 * copy["gates.depth_step_m"])

    with ThreadPoolExecutor(8) as pool:
        list(pool.map(work, range(8)))


# Rounds of the test; a thousand by hand: PHOTIC_TEST_ROUNDS=1000.
ROUNDS = int(os.environ.get("PHOTIC_TEST_ROUNDS", "100"))
FILES = f"""
import sys, threading, warnings
from concurrent.futures import ThreadPoolExecutor
warnings.simplefilter("ignore")
import photic, xarray
scene = photic.Scene.load("scene.toml")
scene.run(photons=300, output="shared.nc")

def work(number):
    for _ in range({ROUNDS} // 10):
        made = scene.run(photons=300, output=f"{{number}}.nc", force=True)
        assert photic.open(f"{{number}}.nc").identical(made)
        assert photic.open("shared.nc").attrs["photons"] == 300
        with photic.netcdf_lock:
            made.to_netcdf(f"copy-{{number}}.nc")
            assert xarray.open_dataset(f"copy-{{number}}.nc", decode_timedelta=False).load().close() is None
        assert photic.open(f"copy-{{number}}.nc").identical(made)

with ThreadPoolExecutor(10) as pool:
    list(pool.map(work, range(10)))
"""


# Seen red: without netcdf_lock in photic.open, with xarray's lock or without it.
def test_ten_threads_run_write_and_open_at_once(tmp_path):
    (tmp_path / "scene.toml").write_text(QUICK_SCENE)
    done = subprocess.run(
        [sys.executable, "-c", FILES], cwd=tmp_path, capture_output=True, text=True, timeout=250 * max(1, ROUNDS // 100), check=False
    )
    assert (done.returncode, done.stderr) == (0, "")


# Fifty runs take less than three results do, once of four times: dictionaries of Python's own grow by a megabyte now and then.
# Seen red: with the result of each run kept.
def test_runs_leave_no_memory():
    scene = package.Scene(QUICK_SCENE)
    used = []
    for _ in range(5):
        results = [scene.run(photons=200) for _ in range(50)]
        size = results[0].nbytes
        del results
        used.append(bytes_in_use())
    assert min(after - before for before, after in pairwise(used)) < 3 * size


ENVIRONMENTS = package.Scene(QUICK_SCENE)
ENVIRONMENTS["environment_grid"] = {"sea.layer.0.chlorophyll_mg_m3": [0.1 + 0.01 * number for number in range(300)]}
STOPPED = {kind: package.Scene.new(kind) for kind in ("oil-spill", "spaceborne-waves", "three-layers")}
STOPPED["300 environments"] = ENVIRONMENTS


def cpu_of(call):
    """The median processor time of what a call takes, in s."""
    times = []
    for _ in range(7):
        before = time.process_time()
        call()
        times.append(time.process_time() - before)
    return statistics.median(times)


def pace():
    """The processor time of a million additions and products of Python, in s: 0.025 s where limits were set."""
    return cpu_of(lambda: sum(number * number for number in range(10**6)))


# 0.25 s of processor time where a million products take 0.025 s. Seen red, seven times: with a break_off_if that never throws.
@pytest.mark.parametrize("what", STOPPED)
@pytest.mark.parametrize("moment", [0.0, 0.1, 0.3, 0.8, 2.0])
def test_a_stop_costs_little(what, moment):
    run = STOPPED[what].start(photons=FOR_EVER, threads=1)
    begun = time.process_time()
    while time.process_time() - begun < moment:
        time.sleep(0.005)
    before = time.process_time()
    run.stop()
    run.end()
    assert time.process_time() - before < 10 * pace()


def test_setting_a_value_costs_at_most_five_readings():
    scene = package.Scene.new("ship")
    text = scene.toml()
    reading = cpu_of(lambda: package.Scene(text))
    assert cpu_of(lambda: scene.__setitem__("sea.layer.0.chlorophyll_mg_m3", 0.5)) < 5 * reading


# Against the compiled module alone, which hands over what the library has.
def test_a_short_run_costs_little_more_than_the_librarys():
    scene = package.Scene.new("ship")
    document = scene._document.changed({"simulation.photons": 1000})
    nothing = {"threads": 0, "engine": "", "isa": "", "earlier": b"", "command": "", "output": None}

    def of_the_library():
        run = core().Run(context(), document, **nothing)
        while not run.wait(1000):
            pass
        run.finish()

    alone = cpu_of(of_the_library)
    assert cpu_of(lambda: scene.run(photons=1000)) < 1.3 * alone


# The lock of Python is free while a scene is simulated. Seen red: with the wait made with the lock held.
def test_python_goes_on_meanwhile():
    with package.Scene(QUICK_SCENE).start(photons=FOR_EVER, threads=1) as run:
        waiting = threading.Thread(target=lambda: run.result(), daemon=True)
        waiting.start()
        begun = time.monotonic()
        for _ in range(50):
            time.sleep(0.001)
        assert time.monotonic() - begun < 5
        while run.progress.photons == 0:
            time.sleep(0.01)
        run.stop()
        waiting.join()


# Four times the environments take four times as long: phase functions are not looked at anew for each of them.
def test_environments_cost_by_their_number():
    scene = package.Scene.new("ship")

    def cost(number):
        same = [{"name": f"e{i}", "set": {"sea.layer.0.chlorophyll_mg_m3": 0.1}} for i in range(number)]
        return cpu_of(lambda: scene.update({"environment": same}))

    assert cost(2000) < 8 * cost(500)
