"""What ./demo and ./test show of what they do (tools/steps.sh)."""

import os
import pty
import subprocess

from conftest import SOURCE

NINJA = "for i in $(seq 8); do echo \"[$i/8] Building CXX object $i.o\"; done; echo 'a warning'"


def steps(script, folder, **options):
    command = ["bash", "-c", f"set -euo pipefail; source {SOURCE}/tools/steps.sh; touch log; {script}"]
    return subprocess.run(command, cwd=folder, check=False, **options)


def test_a_build_tells_a_few_lines_in_a_pipe(tmp_path):
    # Seen red: with every line of ninja told.
    done = steps(f"building log bash -c '{NINJA}'; echo done", tmp_path, capture_output=True, text=True)
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout.splitlines() == [f"built {n} of 8 files" for n in (2, 4, 6, 8)] + ["done"]
    assert (tmp_path / "log").read_text().count("Building CXX object") == 8


def test_on_a_terminal_one_line_moves(tmp_path):
    # Seen red: with a newline after each.
    ours, theirs = pty.openpty()
    done = steps(f"building log bash -c '{NINJA}'; echo done", tmp_path, stdout=theirs, stderr=theirs)
    os.close(theirs)
    told = os.read(ours, 100_000).decode()
    os.close(ours)
    assert done.returncode == 0
    assert "\r\x1b[Kbuilding 5 of 8 files\r\x1b[Kbuilding 6 of 8 files" in told
    assert told.endswith("building 8 of 8 files\r\x1b[Kdone\r\n") and told.count("\n") == 1


def test_what_fails_is_shown_with_all_it_said_and_ends_the_script(tmp_path):
    # Seen red: with the exit code of the last part of the pipe.
    fails = "echo '[1/8] Building'; echo 'error: no such thing' >&2; exit 3"
    for how in ("quietly", "building"):
        done = steps(f'{how} log bash -c "{fails}"; echo still here', tmp_path, capture_output=True, text=True)
        assert done.returncode == 3
        assert "still here" not in done.stdout
        assert "[1/8] Building\nerror: no such thing\nfailed (3): bash -c" in done.stderr


def test_what_works_is_not_shown(tmp_path):
    done = steps("echo before >>log; quietly log echo noise", tmp_path, capture_output=True, text=True)
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")
    assert (tmp_path / "log").read_text() == "before\nnoise\n"
