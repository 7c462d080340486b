"""Ctrl-C and SIGTERM during photic.run: the photons so far can be had."""

import os
import pty
import re
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
from test_run import SCENE

import photic

CATCHING = """
import sys
import photic
from photic import program
program.PATIENCE_S = float(sys.argv[2])
try:
    photic.run("scene.toml", photons=1e15, output=sys.argv[1] or None)
except KeyboardInterrupt as end:
    print("interrupt", type(end).__name__, end, sep="|")
    partial = end.partial
except photic.Error as end:
    print("error", end.exit_code, end, sep="|")
    partial = end.partial
echo = partial.echo.sel(telescope="ship", channel="elastic")
print(partial.attrs["partial"], int(partial.attrs["photons"]), float(echo[0]) > 0)
"""
LEAVING = 'import photic; photic.run("scene.toml", photons=1e15, output="kept.nc")'


def wait_for(condition, process):
    limit = time.monotonic() + 60
    while not (found := condition()):
        assert process.poll() is None, process.communicate()
        assert time.monotonic() < limit
        time.sleep(0.02)
    return found


def program_of(python):
    """The id of the program that a Python process runs, once it catches SIGINT (proc(5): SigCgt)."""
    for child in Path(f"/proc/{python.pid}/task/{python.pid}/children").read_text().split():
        status = Path(f"/proc/{child}/status").read_text()
        caught = int(re.search(r"^SigCgt:\s*(\w+)", status, re.MULTILINE).group(1), 16)
        if status.startswith("Name:\tphotic\n") and caught >> (signal.SIGINT - 1) & 1:
            return int(child)
    return None


@pytest.fixture
def start(tmp_path):
    """Starts Python in a session of its own; whatever is left of it is killed at the end."""
    (tmp_path / "scene.toml").write_text(SCENE)
    started = []

    def call(code, *arguments, **options):
        # A shell's background jobs ignore SIGINT; this one must not.
        python = subprocess.Popen(
            [sys.executable, "-c", code, *arguments], cwd=tmp_path, text=True, start_new_session=True,
            preexec_fn=lambda: signal.signal(signal.SIGINT, signal.default_int_handler),
            **{"stdin": subprocess.DEVNULL, "stdout": subprocess.PIPE, "stderr": subprocess.PIPE} | options,
        )  # fmt: skip
        started.append(python)
        program = wait_for(lambda: program_of(python), python)
        time.sleep(0.3)
        return python, program

    yield call
    for python in started:
        try:
            os.killpg(python.pid, signal.SIGKILL)
        except ProcessLookupError:
            pass
        python.communicate()


def caught(python):
    out, errors = python.communicate(timeout=60)
    assert errors == ""
    said, partial = out.splitlines()
    flag, photons, lit = partial.split()
    assert (flag, lit) == ("1", "True") and 0 < int(photons) < 1e15
    return said.replace(photons, "N").split("|")


def gone(process_id):
    return not Path(f"/proc/{process_id}").exists()


SO_FAR = "the run was ended after N photons; the result so far is in `partial` of this exception"


# Seen red: with the program killed when the signal came.
def test_ctrl_c_keeps_the_photons_so_far(start, tmp_path):
    python, program = start(CATCHING, "kept.nc", "60")
    os.killpg(python.pid, signal.SIGINT)  # as a terminal does
    assert caught(python) == ["interrupt", "Interrupted", SO_FAR + " and in kept.nc"]
    assert photic.open(tmp_path / "kept.nc").attrs["stopped_by"] == "interrupt"
    assert gone(program)


def test_ctrl_c_without_an_output(start, tmp_path):
    python, _ = start(CATCHING, "", "60")
    os.killpg(python.pid, signal.SIGINT)
    assert caught(python) == ["interrupt", "Interrupted", SO_FAR]
    assert [path.name for path in tmp_path.iterdir()] == ["scene.toml"]


# Seen red: without the signal passed on.
def test_a_signal_to_python_alone_is_passed_on(start):
    python, program = start(CATCHING, "kept.nc", "0.5")
    python.send_signal(signal.SIGINT)
    assert caught(python) == ["interrupt", "Interrupted", SO_FAR + " and in kept.nc"]
    assert gone(program)


def test_uncaught_it_ends_python_and_names_the_file(start, tmp_path):
    python, _ = start(LEAVING)
    os.killpg(python.pid, signal.SIGINT)
    _, errors = python.communicate(timeout=60)
    assert python.returncode != 0
    assert re.search(r"Interrupted: the run was ended after \d+ photons; .* and in kept.nc\n$", errors)
    assert (tmp_path / "kept.nc").exists()


# Seen red: with the program left alone after the second one.
def test_a_second_ctrl_c_ends_at_once(start, tmp_path):
    python, program = start(LEAVING)
    os.kill(program, signal.SIGSTOP)  # it does not get to the end of its batch
    os.killpg(python.pid, signal.SIGINT)
    time.sleep(1)
    os.killpg(python.pid, signal.SIGINT)
    _, errors = python.communicate(timeout=60)
    assert errors.endswith("KeyboardInterrupt\n")
    assert gone(program)
    assert not (tmp_path / "kept.nc").exists()


def test_a_program_ended_by_sigterm_is_an_error_with_the_photons_so_far(start, tmp_path):
    python, program = start(CATCHING, "kept.nc", "60")
    os.kill(program, signal.SIGTERM)
    assert caught(python) == ["error", "143", SO_FAR + " and in kept.nc"]
    assert (tmp_path / "kept.nc").exists()


def test_ctrl_c_on_a_terminal(start, tmp_path):
    ours, theirs = pty.openpty()
    code = "import fcntl, termios; fcntl.ioctl(0, termios.TIOCSCTTY, 0)\n" + CATCHING
    python, _ = start(code, "kept.nc", "60", stdin=theirs)
    os.close(theirs)
    os.write(ours, b"\x03")
    assert caught(python) == ["interrupt", "Interrupted", SO_FAR + " and in kept.nc"]
    os.close(ours)
