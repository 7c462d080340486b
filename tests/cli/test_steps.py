"""The progress that ./demo and ./test print (tools/steps.sh)."""

import contextlib
import os
import pty
import subprocess

from conftest import SOURCE

NINJA = "for i in $(seq 8); do echo \"[$i/8] Building CXX object $i.o\"; done; echo 'a warning'"


def command_of(script):
    return ["bash", "-c", f"set -euo pipefail; source {SOURCE}/tools/steps.sh; touch log; {script}"]


def steps(script, folder):
    return subprocess.run(command_of(script), cwd=folder, check=False, capture_output=True, text=True)


def everything_of(terminal):
    # A terminal hands its text over in pieces, and ends with an error when its other end is closed.
    pieces = []
    with contextlib.suppress(OSError):
        while piece := os.read(terminal, 4096):
            pieces.append(piece)
    os.close(terminal)
    return b"".join(pieces).decode()


def test_a_build_prints_a_few_lines_in_a_pipe(tmp_path):
    # Seen red: with every line of ninja printed.
    done = steps(f"building log bash -c '{NINJA}'; echo done", tmp_path)
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout.splitlines() == [f"built {n} of 8 files" for n in (2, 4, 6, 8)] + ["done"]
    assert (tmp_path / "log").read_text().count("Building CXX object") == 8


def test_on_a_terminal_one_line_moves(tmp_path):
    # Seen red: with a newline after each.
    ours, theirs = pty.openpty()
    with subprocess.Popen(command_of(f"building log bash -c '{NINJA}'; echo done"), cwd=tmp_path, stdout=theirs) as done:
        os.close(theirs)
        shown = everything_of(ours)
    assert done.returncode == 0
    assert "\r\x1b[Kbuilding 5 of 8 files\r\x1b[Kbuilding 6 of 8 files" in shown
    assert shown.endswith("building 8 of 8 files\r\x1b[Kdone\r\n") and shown.count("\n") == 1


def test_what_fails_is_shown_with_all_it_said_and_ends_the_script(tmp_path):
    # Seen red: with the exit code of the last part of the pipe.
    fails = "echo '[1/8] Building'; echo 'error: no such thing' >&2; exit 3"
    for how in ("quietly", "building"):
        done = steps(f'{how} log bash -c "{fails}"; echo still here', tmp_path)
        assert done.returncode == 3
        assert "still here" not in done.stdout
        assert "[1/8] Building\nerror: no such thing\nfailed (3): bash -c" in done.stderr


def test_jobs_fit_the_memory(tmp_path):
    # Seen red: with cores alone.
    cores = len(os.sched_getaffinity(0))
    for kilobytes, jobs in ((100_000, 1), (2_500_000, min(2, cores)), (10**9, cores)):
        (tmp_path / "meminfo").write_text(f"MemTotal: 9 kB\nMemAvailable: {kilobytes} kB\n")
        assert steps("jobs meminfo", tmp_path).stdout == f"{jobs}\n"
    assert steps("jobs none", tmp_path).stdout == f"{cores}\n"


def test_what_works_is_not_shown(tmp_path):
    done = steps("echo before >>log; quietly log echo noise", tmp_path)
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")
    assert (tmp_path / "log").read_text() == "before\nnoise\n"
