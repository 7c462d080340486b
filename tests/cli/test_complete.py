"""Completion: what photic complete lists, and what the shells make of it."""

import os
import pty
import re
import select
import subprocess
from pathlib import Path

import pytest
from conftest import SOURCE

COMPLETIONS = SOURCE / "completions"


@pytest.fixture
def candidates(photic):
    """The words that may take the place of the last one."""

    def candidates(*words):
        done = photic("complete", "--", *words)
        assert (done.returncode, done.stderr) == (0, "")
        return [line.partition("\t")[0] for line in done.stdout.splitlines()]

    return candidates


# Seen red: each with the branch of complete.cpp that it is about taken out.
@pytest.mark.parametrize(
    "words, expected",
    [
        (("ru",), ["run"]),
        (("--vers",), ["--version"]),
        (("run", ""), ["*.toml"]),
        (("run", "--continue", ""), ["*.nc"]),
        (("run", "-o", ""), ["*"]),
        (("show", ""), ["*.toml", "*.nc"]),
        (("run", "my.toml", "--engine", ""), ["scalar", "lanes"]),
        (("run", "my.toml", "--engine=l"), ["--engine=lanes"]),
        (("run", "--engine", "lanes", ""), ["*.toml"]),
        (("run", "my.toml", "--pho"), ["--photons"]),
        (("run", "my.toml", "--photons", "5", "--pho"), []),
        (("run", "--set", "a=1", "--se"), ["--seed", "--set"]),
        (("run", "my.toml", "--photons", ""), []),
        (("optics", "--water", "chlorophyll_mg_m3=0.5", "cdom_a"), ["cdom_a440_per_m="]),
        (("optics", "--water", "chlorophyll_mg_m3=0.5", "--las"), ["--laser"]),
        (("run", "my.toml", "--set", "sea.layer.12.chlorophyll_m"), ["sea.layer.12.chlorophyll_mg_m3="]),
        (("run", "my.toml", "--set", "telescope.ship.obs"), ["telescope.ship.obstruction_diameter_m="]),
        (("run", "my.toml", "--set", "simulation.estimator=f"), ["simulation.estimator=forward"]),
        (("plot", "my.nc", ""), ["*.nc"]),
        (("plot", "--telescope", "a", "--telescope", "b", "--tel"), ["--telescope"]),
        (("help", "op"), ["optics"]),
        (("schema", "x"), []),
        (("nothing", "x"), []),
    ],
)
def test_candidates(candidates, words, expected):
    assert candidates(*words) == expected


def test_what_may_follow_whatever_was_typed(candidates):
    assert candidates("run", "my.toml", "") == candidates("run", "my.toml", "-")  # no second scene
    assert {"sea.layer.0.chlorophyll_mg_m3=", "sea.salinity_psu="} <= set(candidates("run", "my.toml", "--set", ""))


def test_every_subcommand_and_option_is_listed_with_what_it_does(photic, candidates):
    commands = candidates("")
    assert {"run", "bench", "check", "show", "optics", "new", "schema"} <= set(commands)
    assert not {"complete", "manual"} & set(commands)
    output = photic("complete", "--", "").stdout + photic("complete", "--", "run", "-").stdout
    assert all(len(line.split("\t")) == 2 for line in output.splitlines())
    for command in commands:
        assert "--help" in candidates(command, "-")


def test_kinds_of_starter_scenes(photic, candidates, tmp_path):
    kinds = candidates("new", "")
    assert "ship" in kinds
    for kind in kinds:
        assert photic("new", kind, "-o", f"{kind}.toml").returncode == 0


def test_help_says_nothing_of_what_is_for_shells(photic):
    assert "complete" not in photic("--help").stdout
    assert "complete" not in photic("nothing").stderr


@pytest.fixture
def folder(tmp_path):
    """With some files."""
    for name in ("my scene.toml", "my.nc", "other.txt"):
        (tmp_path / name).touch()
    (tmp_path / "more").mkdir()
    return tmp_path


@pytest.fixture
def environment(program, folder):
    """With photic in PATH."""
    return os.environ | {"PATH": f"{Path(program).parent}:/usr/bin:/bin", "HOME": str(folder), "LC_ALL": "C.UTF-8", "TERM": "dumb"}


def read_until(terminal, wanted):
    output = ""
    while not (found := re.search(wanted, output)):
        assert select.select([terminal], [], [], 10)[0], output
        output += os.read(terminal, 4096).decode()
    return found


START = {
    "bash": ["bash", "--norc", "-i"],
    "zsh": ["zsh", "-f", "-i"],
}
SETUP = {
    "bash": f"source {COMPLETIONS}/photic.bash; PS1='REA''DY'",
    "zsh": f"fpath=({COMPLETIONS} $fpath); autoload -U compinit; compinit -u -D; PS1='REA''DY'",
}


LINES = [
    ("photic ru", ["photic", "run"]),
    ("photic run my", ["photic", "run", "my scene.toml"]),
    ("photic run --continue m", ["photic", "run", "--continue", "m"]),  # more/ and my.nc
    ("photic run --continue my", ["photic", "run", "--continue", "my.nc"]),
    ("photic run -o ot", ["photic", "run", "-o", "other.txt"]),
    ("photic run my.nc --engine=l", ["photic", "run", "my.nc", "--engine=lanes"]),
    ("photic run --set simulation.estimator=fo", ["photic", "run", "--set", "simulation.estimator=forward"]),
    ("photic run --set sea.salin\t35", ["photic", "run", "--set", "sea.salinity_psu=35"]),
    ("photic optics --wavelengths 400:700:10 my", ["photic", "optics", "--wavelengths", "400:700:10", "my scene.toml"]),
]


@pytest.mark.parametrize("shell", ["bash", "zsh"])
def test_lines_that_are_typed(environment, folder, shell):
    # Seen red: in bash with words that are not put together again at '=' and ':'; in zsh with `_describe` alone.
    process, terminal = pty.fork()
    if process == 0:
        os.chdir(folder)
        os.execvpe(shell, START[shell], environment)
    try:
        os.write(terminal, f"{SETUP[shell]}\n".encode())
        read_until(terminal, "READY")
        for typed, completed in LINES:
            # The line is completed, and then made one that shows its words.
            os.write(terminal, f"{typed}\t\x01printf '<%s>' \r".encode())
            words = read_until(terminal, "((?:<[^>%]*>)+)[^<]*READY")[1]
            assert re.findall("<([^>]*)>", words) == completed
    finally:
        os.close(terminal)
        os.waitpid(process, 0)


@pytest.mark.parametrize(
    "line, expected",
    [
        ("photic ru", ["run"]),
        ("photic run my.toml --engine ", ["lanes", "scalar"]),
        ("photic run my.toml --engine=l", ["--engine=lanes"]),
        ("photic run my.toml --set simulation.estimator=fo", ["simulation.estimator=forward"]),
        ("photic run my", ["my scene.toml", "my.nc"]),  # fish offers other files after those of the right name
    ],
)
def test_fish(environment, folder, line, expected):
    done = subprocess.run(
        ["fish", "--no-config", "-c", f"source {COMPLETIONS}/photic.fish; complete -C '{line}'"],
        cwd=folder, env=environment, stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=60, check=False,
    )
    assert (done.returncode, done.stderr) == (0, "")
    assert sorted(line.partition("\t")[0] for line in done.stdout.splitlines()) == expected
