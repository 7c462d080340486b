"""The command line itself: help, version, what it refuses, and its exit codes."""

import json
import os
import re
from pathlib import Path

import pytest


def test_version(photic):
    done = photic("--version")
    assert (done.returncode, done.stderr) == (0, "")
    version, compiler, sets, data = done.stdout.splitlines()
    assert re.fullmatch(r"photic \d+\.\d+\.\d+", version)
    assert re.fullmatch(r"compiler: (GCC|Clang) \d+\.\d+.*, \w+", compiler)
    assert re.fullmatch(r"instruction sets: (\w+( \(not on this processor\))?, )*baseline", sets)
    assert (Path(data.removeprefix("data: ")) / "water_mason_2016.csv").is_file()


# Seen red: with the environment's folder not looked at; with only that.
def test_version_names_the_folder_of_the_data(photic, tmp_path):
    unset = {key: value for key, value in os.environ.items() if key != "PHOTIC_DATA"}
    own = Path(__file__).parents[2] / "data"
    for environment in (unset, unset | {"PHOTIC_DATA": ""}):
        [*_, data] = photic("--version", env=environment).stdout.splitlines()
        assert Path(data.removeprefix("data: ")).samefile(own)
    (tmp_path / "water_mason_2016.csv").touch()
    [*_, data] = photic("--version", env=unset | {"PHOTIC_DATA": str(tmp_path)}).stdout.splitlines()
    assert data == f"data: {tmp_path}"


def test_version_where_the_data_are_missing(photic, tmp_path):
    done = photic("--version", env=os.environ | {"PHOTIC_DATA": str(tmp_path)})
    assert done.returncode == 0
    wrong = f"data: no data tables in {tmp_path} (named by PHOTIC_DATA): it has no water_mason_2016.csv"
    assert done.stdout.splitlines()[-1] == wrong


COMMANDS = ["run", "plot", "analyse", "new", "check", "show", "optics", "bench", "schema", "help"]


def test_help_shows_every_subcommand_and_an_example(photic):
    done = photic("--help")
    assert (done.returncode, done.stderr) == (0, "")
    for word in [*COMMANDS, "photic run my.toml", "Exit codes", "PHOTIC_PYTHON"]:
        assert word in done.stdout


@pytest.mark.parametrize("words", [(), ("help",)])
def test_no_arguments_show_the_commands(photic, words):
    done = photic(*words)
    assert (done.returncode, done.stderr) == (0, "")
    assert all(f"\n  {command} " in done.stdout for command in COMMANDS)
    assert len(done.stdout.splitlines()) < 25


@pytest.mark.parametrize("command", COMMANDS)
def test_help_of_a_subcommand(photic, command):
    done = photic(command, "--help")
    assert (done.returncode, done.stderr) == (0, "")
    assert f"Usage: photic {command}" in done.stdout
    assert photic("help", command).stdout == done.stdout
    # Examples are of this command alone. Seen red: with the program's examples below each.
    examples = re.findall(r"^  photic (\w+)", done.stdout, re.MULTILINE)
    assert set(examples) <= {command}


REFUSED = {
    ("quick.toml",): "there is no subcommand 'quick.toml' (did you mean: photic run quick.toml?)",
    ("run", "quick.toml", "--photns", "5"): "--photns: did you mean '--photons'?",
    ("run", "quick.toml", "-o", ""): "--output: a name is empty",
    ("run", "--continue", "nowhere.nc"): "nowhere.nc: there is no such file",
    ("help", "runn"): "there is no subcommand 'runn' (did you mean 'run'?)",
    ("rnu", "quick.toml"): "there is no subcommand 'rnu' (did you mean 'run'?)",
    ("simulate", "quick.toml"): "there is no subcommand 'simulate' (there are: run, plot, analyse, "
    "new, check, show, optics, bench, schema, help)",
    ("run",): "scene is required",
    ("run", "quick.toml", "--photon", "5"): "--photon",
    ("run", "quick.toml", "--photons", "many"): "--photons: 'many' is not a whole number from 1 to 2^63 - 1 "
    "(write 10000000 or 1e7)",
    ("run", "quick.toml", "--photons", "0"): "--photons: '0' is not a whole number from 1",
    ("run", "quick.toml", "--photons", "1.5"): "--photons: '1.5' is not a whole number from 1",
    ("run", "quick.toml", "--photons", "1e19"): "--photons: '1e19' is not a whole number from 1",
    ("run", "quick.toml", "--photons", "9223372036854775808"): "is not a whole number from 1",
    ("run", "quick.toml", "--photons", "1e7x"): "--photons: '1e7x' is not a whole number from 1",
    ("run", "quick.toml", "--target", "1"): "--target: '1' is not between 0 and 100 % (write 1% or 0.01)",
    ("run", "quick.toml", "--target", "0%"): "--target: '0%' is not between 0 and 100 %",
    ("run", "quick.toml", "--target", "nan"): "--target: 'nan' is not a share (write 1% or 0.01)",
    ("run", "quick.toml", "--max-time", "60"): "--max-time: '60' is not a time with its unit "
    "(write 60s, 10min or 2h)",
    ("run", "quick.toml", "--max-time", "60m"): "--max-time: '60m' is not a time with its unit",
    ("run", "quick.toml", "--max-time", "0s"): "--max-time: '0s' is not above 0",
    ("run", "quick.toml", "--checkpoint", "5"): "--checkpoint: '5' is not a time with its unit (write 60s, 10min or 2h)",
    ("run", "quick.toml", "--checkpoint", "0s"): "--checkpoint: '0s' is not above 0",
    ("run", "--photons", "5"): "scene is required",
    ("run", "quick.toml", "--seed", "-1"): "--seed: '-1' is not a whole number from 0 to 2^63 - 1",
    ("run", "quick.toml", "--threads", "0"): "--threads",
    ("run", "quick.toml", "-o", "echo.dat"): "echo.dat: the result's name ends in none of .nc, .csv and .txt "
    "(write -o echo.dat.nc, or -o echo.dat/ for a folder)",
    ("run", "quick.toml", "--table", "long"): "--table: long not in {short,full,none}",
    ("optics", "quick.toml", "-o", "water.txt"): "water.txt: the result's name ends neither in .nc nor in .csv",
    ("plot",): "results is required",
    ("check", "quick.toml", "other.toml"): "other.toml",
    ("new",): "kind is required",
    ("schema", "extra"): "extra",
}


@pytest.mark.parametrize("arguments", REFUSED, ids=" ".join)
def test_a_command_line_that_cannot_be_followed(photic, scene, tmp_path, arguments):
    done = photic(*arguments)
    assert done.returncode == 2
    assert REFUSED[arguments] in done.stderr
    assert done.stdout == ""
    assert [p.name for p in tmp_path.iterdir()] == ["quick.toml"]


GIVEN = {
    ("--photons", "1e3"): {"photons": 1000},
    ("--photons", "1000"): {"photons": 1000},
    ("--photons", "9223372036854775807", "--max-time", "0.1s"): {"photons": 9223372036854775807, "max_time_s": 0.1},
    ("--target", "5%"): {"target_relative_error": 0.05},
    ("--target", "0.05"): {"target_relative_error": 0.05},
    ("--max-time", "90s"): {"max_time_s": 90},
    ("--max-time", "1.5min"): {"max_time_s": 90},
    ("--max-time", "2h"): {"max_time_s": 7200},
    ("--seed", "7"): {"seed": 7},
    ("--set", "simulation.seed=3", "--seed", "7"): {"seed": 7},
    ("--set", "simulation.seed=3", "--set", "simulation.orders_kept=2"): {"seed": 3, "orders_kept": 2},
}


@pytest.mark.parametrize("flags", GIVEN, ids=" ".join)
def test_a_flag_is_a_value_of_the_effective_scene(photic, scene, tmp_path, flags):
    # Seen red: with --set after the flags; with 5% taken for 5.
    done = photic("run", "quick.toml", *flags)
    assert done.returncode == 0, done.stderr
    simulation = json.loads(photic("show", "quick.nc", "--json").stdout)["simulation"]
    assert {key: simulation[key] for key in GIVEN[flags]} == GIVEN[flags]


def test_standard_output_that_is_full(photic):
    with open("/dev/full", "w", encoding="utf-8") as full:
        done = photic("schema", capture_output=False, stdout=full, stderr=-1)
    assert done.returncode == 1
    assert done.stderr == "photic: cannot write to standard output: No space left on device\n"
