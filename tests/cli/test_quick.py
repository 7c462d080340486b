"""tools/quick_tests.py: the tests that ./test quick runs."""

import subprocess
import sys

import pytest
from conftest import SOURCE


def chosen(*folders):
    command = [sys.executable, SOURCE / "tools/quick_tests.py", *folders]
    return subprocess.run(command, capture_output=True, text=True, check=False)


@pytest.mark.parametrize(
    "folder, labels",
    [
        ("src/io", "io session"),
        ("tests/unit/tally/totals_test.cpp", "tally"),
        ("src/lanes/queue.hpp", "lanes estimator schedule run session"),
        ("tally", "tally lanes estimator schedule run io session"),
    ],
)
def test_folders_and_the_floors_that_include_them(folder, labels):
    # Seen red: without the floors above; with the floors above for a test, too.
    targets, expression = chosen(folder).stdout.splitlines()
    assert expression == f"^({'|'.join('unit/' + label for label in labels.split())})$"
    assert targets == " ".join(f"tests/unit/{label}/all" for label in labels.split())


def test_the_command_line_needs_the_program():
    assert chosen("apps/photic/run.cpp").stdout == "tests/cli/all photic photic_python\n^(cli)$\n"
    assert chosen("python/photic/plot.py").stdout == "tests/python/all photic photic_python make_sample_result\n^(python)$\n"


def test_what_has_no_tests_is_refused():
    done = chosen("src/talley")
    assert done.returncode == 2
    assert done.stderr.startswith("src/talley: no folder with tests of its own (one of core, optics")


def test_options_of_the_script():
    for options, code in ((["--help"], 0), (["fast"], 2)):
        done = subprocess.run([SOURCE / "test", *options], capture_output=True, text=True, check=False)
        assert done.returncode == code
        assert "usage: ./test, all tests; or ./test quick [FOLDER...]" in done.stdout + done.stderr
