"""Results that photic analyse is tested on, and the command, by the program and in this process."""

import json
import os
import subprocess
from dataclasses import dataclass

import photic as package
import pytest
from conftest import QUICK_SCENE
from photic.__main__ import main

CHLOROPHYLL = "sea.layer.0.chlorophyll_mg_m3"
WATERS = {"clear": 0.1, "green": 0.2, "turbid": 0.4, "bloom": 0.8}
LEVELS = "".join(f'[[environment]]\nname = "{name}"\nset = {{ "{CHLOROPHYLL}" = {value} }}\n' for name, value in WATERS.items())
FLUORESCENCE = '[[channel]]\nname = "chlorophyll"\nprocess = "chlorophyll"\n'
WIDE = QUICK_SCENE.partition("[[telescope]]")[2].partition("[[channel]]")[0].replace("0.04", "0.4")
SCENE = QUICK_SCENE.replace("[[channel]]", f'name = "narrow"\n[[telescope]]\nname = "wide"{WIDE}[[channel]]', 1)
SCENE = SCENE.replace("[[sea.layer]]", f"{FLUORESCENCE}[[sea.layer]]", 1) + LEVELS
FILM = '[oil]\nclass = "weakly-absorbing-crude"\nthickness_um = 1.0\n[[environment]]\nname = "clean"\nset = { "oil.thickness_um" = 0 }\n'
ELASTIC = ["--channel", "elastic"]


def calls(program, folder):
    def call(*arguments, **options):
        options = {"cwd": folder, "capture_output": True, "text": True, "timeout": 120, "check": False} | options
        return subprocess.run([program, *map(str, arguments)], stdin=subprocess.DEVNULL, **options)

    return call


@pytest.fixture(scope="session")
def folder(tmp_path_factory):
    """With results: of two telescopes over five waters, over a film, without groups, of a single telescope without
    environments, and with gates in the air."""
    folder = tmp_path_factory.mktemp("analysed")
    run = calls(os.environ["PHOTIC_PROGRAM"], folder)
    air = QUICK_SCENE.replace("depth_max_m = 10.0", "depth_min_m = -9.0\ndepth_max_m = -2.0") + '[atmosphere]\nprofile = "us-standard"\n'
    scenes = {"waters": (SCENE, "20000"), "film": (QUICK_SCENE + FILM, "4000"), "plain": (QUICK_SCENE, "4000"), "air": (air, "4000")}
    for name, (text, photons) in scenes.items():
        (folder / f"{name}.toml").write_text(text)
        done = run("run", f"{name}.toml", "--photons", photons, "-q")
        assert done.returncode == 0, done.stderr
    done = run("run", "plain.toml", "-q", "--photons", "4000", "-o", "bare.nc", "--set", "simulation.keep_groups=false")
    assert done.returncode == 0, done.stderr
    return folder


@pytest.fixture
def by_program(program, folder):
    """photic analyse in the folder."""
    call = calls(program, folder)
    return lambda *arguments, **options: call("analyse", *arguments, **options)


@dataclass
class Done:
    returncode: int
    stdout: str
    stderr: str


@pytest.fixture
def analyse(folder, monkeypatch, capsys):
    """The same by the package in this process, which need not begin anew."""
    monkeypatch.chdir(folder)

    def analyse(*words):
        code = main(["analyse", *map(str, words)])
        return Done(code, *capsys.readouterr())

    return analyse


@pytest.fixture
def found(analyse):
    """The numbers that it prints as JSON, by quantity."""

    def found(*arguments):
        done = analyse(*arguments, "--json")
        assert (done.returncode, done.stderr) == (0, "")
        numbers = {}
        for number in json.loads(done.stdout)["numbers"]:
            numbers.setdefault(number["quantity"], []).append(number)
        return numbers

    return found


@pytest.fixture
def result(folder):
    return package.open(folder / "waters.nc")
