"""The manual page photic(1), as photic manual prints it."""

import os
import re
import subprocess
from pathlib import Path

import pytest

SECTIONS = [
    "NAME", "SYNOPSIS", "DESCRIPTION", "OPTIONS", "COMMANDS", "EXAMPLES", "EXIT STATUS", "ENVIRONMENT", "FILES", "SEE ALSO",
]


@pytest.fixture
def page(photic, tmp_path):
    done = photic("manual")
    assert (done.returncode, done.stderr) == (0, "")
    (tmp_path / "photic.1").write_text(done.stdout)
    environment = {"PATH": "/usr/bin:/bin", "LC_ALL": "C.UTF-8", "MANWIDTH": "80", "MANROFFSEQ": ""}
    shown = subprocess.run(
        ["man", "--warnings", "-l", tmp_path / "photic.1"],
        env=environment, stdin=subprocess.DEVNULL, capture_output=True, text=True, check=True,
    )
    assert shown.stderr == ""  # Seen red: with a macro that groff does not have.
    return shown.stdout


def test_it_has_the_sections_of_a_manual(page):
    assert re.findall(r"^[A-Z].*[A-Z]$", page, re.MULTILINE) == SECTIONS


def test_it_lists_every_command_and_option_that_help_lists(page, photic):
    # Seen red: with the options of `show` left out.
    written = " ".join(page.replace("\u2010\n", "").split())
    listed = photic("--help").stdout.partition("\nCommands\n")[2].partition("\n\n")[0]
    commands = re.findall(r"^  (\w+)", listed, re.MULTILINE)
    assert {"run", "check", "optics"} <= set(commands)
    for command in commands:
        part = page.partition(f"\n   photic {command}\n")[2].partition("\n   photic ")[0]
        help_text = photic(command, "--help").stdout.partition("\nExamples\n")[0]
        assert part and help_text.splitlines()[0][:40] in written
        for option in re.findall(r"(?<![\w-])--[a-z][a-z-]*", help_text.partition("\nOptions\n")[2]):
            assert option in part, (command, option)


def test_text_is_shown_as_it_was_written(page, photic):
    for command in ("run", "optics"):
        examples = photic(command, "--help").stdout.partition("\nExamples\n")[2]
        commands = re.findall(r"^  (photic .*?)(?:  |$)", examples, re.MULTILINE)
        assert any(" --" in command for command in commands)
        for example in commands:
            assert example in page
    # A bare "-" is a hyphen to groff where Debian has not changed that. Seen red: with those.
    assert re.search(r"\\-\\-set\b", photic("manual").stdout)
    assert re.search(r"^ +130 +ended by Ctrl-C", page, re.MULTILINE)
    assert re.search(r"^ +PHOTIC_DATA\n", page, re.MULTILINE)


def test_the_build_makes_it(photic):
    # Seen red: with a page that an earlier program has made.
    built = Path(os.environ["PHOTIC_PROGRAM"]).parent / "photic.1"
    assert built.read_text() == photic("manual").stdout
