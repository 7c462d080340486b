"""Ctrl-C and SIGTERM: the photons so far are kept and the exit code says so; a second one ends at once."""

import os
import pty
import signal
import subprocess
import time

import netCDF4
import pytest


def start(program, scene, **options):
    """A run that would take years. A shell's background jobs ignore SIGINT; this one must not."""
    return subprocess.Popen(
        [program, "run", scene.name, "--photons", "1e15"],
        cwd=scene.parent, stdin=subprocess.DEVNULL, text=True,
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.default_int_handler),
        **{"stdout": subprocess.PIPE, "stderr": subprocess.PIPE} | options,
    )


def listens(process):
    """The program catches SIGINT and SIGTERM by now (proc(5): SigCgt)."""
    for line in open(f"/proc/{process.pid}/status", encoding="ascii"):
        if line.startswith("SigCgt:"):
            caught = int(line.split()[1], 16)
            return all(caught >> (number - 1) & 1 for number in (signal.SIGINT, signal.SIGTERM))
    return False


def wait_until_it_listens(process):
    limit = time.monotonic() + 60
    while not listens(process):
        assert process.poll() is None, process.stderr.read()
        assert time.monotonic() < limit
        time.sleep(0.02)
    time.sleep(0.3)
    time.sleep(1)  # until its first batches have ended: before, there is no result


@pytest.mark.parametrize(("number", "code"), [(signal.SIGINT, 130), (signal.SIGTERM, 143)])
def test_the_partial_result_is_written(program, scene, tmp_path, number, code):
    # Seen red: with exit code 0 for a partial result.
    process = start(program, scene)
    wait_until_it_listens(process)
    process.send_signal(number)
    out, errors = process.communicate(timeout=60)
    assert process.returncode == code
    assert errors == ""
    assert "stopped by: interrupt; this is a partial result" in out
    assert "Result (partial: the run was interrupted): quick.nc" in out
    with netCDF4.Dataset(tmp_path / "quick.nc") as result:
        assert 0 < result.photons < 1e15
        assert result.stopped_by == "interrupt"
    assert sorted(p.name for p in tmp_path.iterdir()) == ["quick.nc", "quick.toml"]


def test_the_second_signal_ends_at_once(program, scene, tmp_path):
    # Seen red: with a handler that does not raise the second signal again.
    process = start(program, scene)
    wait_until_it_listens(process)
    process.send_signal(signal.SIGSTOP)  # both wait for the program, which meets them one after the other
    process.send_signal(signal.SIGINT)
    process.send_signal(signal.SIGTERM)
    process.send_signal(signal.SIGCONT)
    process.communicate(timeout=60)
    assert process.returncode in (-signal.SIGTERM, -signal.SIGINT)
    assert not (tmp_path / "quick.nc").exists()


def test_the_progress_bar_on_a_terminal(program, scene):
    ours, theirs = pty.openpty()
    process = start(program, scene, stderr=theirs)
    os.close(theirs)
    text = ""
    limit = time.monotonic() + 60
    while text.count(" gates ") < 2 and time.monotonic() < limit:
        text += os.read(ours, 4096).decode()
    process.send_signal(signal.SIGINT)
    try:
        while chunk := os.read(ours, 4096).decode():
            text += chunk
    except OSError:  # EIO: the program is gone
        pass
    process.communicate(timeout=60)
    os.close(ours)
    assert process.returncode == 130
    assert text.count(" gates ") >= 2
    for word in ["%", "worst gate", "left"]:
        assert word in text
    assert text.endswith("\r\x1b[K"), "the bar is wiped at the end"
