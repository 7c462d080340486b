"""photic analyse: options, what is refused, what cannot be written, help and completion."""

import os
import subprocess

import pytest
from analysed_results import CHLOROPHYLL, ELASTIC
from photic.analysis import FUNCTIONS

pytest_plugins = ["analysed_results"]


REFUSED = {
    ("waters.nc", "k-lider"): "there is no function 'k-lider' (did you mean 'k-lidar'?)",
    ("nowhere.nc", "ratio"): "nowhere.nc: no such file",
    ("waters.nc", "z90"): "waters.nc: z90 takes one --channel NAME; there are: elastic, raman, chlorophyll",
    ("waters.nc", "z90", *ELASTIC, "--channel", "raman"): "waters.nc: z90 takes one --channel NAME; there are: ",
    ("waters.nc", "k-lidar", "--channel", "elastik"): "waters.nc: there is no channel 'elastik' (did you mean 'elastic'?)",
    ("waters.nc", "overlap", "--channel", "elastik"): "waters.nc: there is no channel 'elastik' (did you mean 'elastic'?)",
    ("waters.nc", "ratio", "--telescope", "narow"): "waters.nc: there is no telescope 'narow' (did you mean 'narrow'?)",
    ("waters.nc", "ratio", "--environment", "blom"): "waters.nc: there is no environment 'blom' (did you mean 'bloom'?)",
    ("waters.nc", "ratio", "--reference", "blom"): "waters.nc: there is no environment 'blom' (did you mean 'bloom'?)",
    ("waters.nc", "linear-fit", "--against", "sea.layer.0.chlorophyl"): f"(did you mean '{CHLOROPHYLL}'?)",
    ("plain.nc", "ratio", "--of", "elastic", "--environment", "bloom"): "add [[environment]] to the scene",
    ("plain.nc", "linear-fit"): "plain.nc: linear-fit: no environments that set numbers: add [[environment]] or [environment_grid]",
    ("bare.nc", "z90", *ELASTIC): "bare.nc: a result without echo_by_group: run its scene again with simulation.keep_groups = true",
    ("air.nc", "z90", *ELASTIC): "air.nc: z90: no gate of this result is in the water",
    ("waters.nc", "linear-fit", "--environment", "clear", "--environment", "bloom"): "linear_fit: 2 values: a line with errors takes 3",
    ("waters.nc", "k-lidar", *ELASTIC, "--depths", "1", "3"): "k_lidar: a fit of three gates at least: 2 in the water",
    ("waters.nc", "k-lidar", *ELASTIC, "--depths", "3", "1"): "depths = (3, 1): the first depth of a fit is above the last",
    ("waters.nc", "k-lidar", *ELASTIC, "--depths", "-1", "x"): "--depths: 'x' is not a number (write --depths 0 20)",
    ("waters.nc", "z90", *ELASTIC, "--share", "x"): "--share: 'x' is not a number (write --share 0.9)",
    ("waters.nc", "z90", *ELASTIC, "--share", "1.5"): "share = 1.5: a share of the light is above 0 and below 1",
    ("waters.nc", "k-lidar", *ELASTIC, "--share", "0.5"): "--share does not belong to k-lidar, whose options are --telescope, ",
    ("waters.nc", "overlap", "--environment", "bloom"): "--environment does not belong to overlap",
    ("waters.nc", "linear-fit", *ELASTIC, "--of", "raman"): "linear-fit: --channel and --of exclude each other",
    ("waters.nc", "linear-fit", "--share", "0.5"): "linear-fit: --share without --channel",
    ("film.nc", "oil-thickness"): "film.nc: oil-thickness takes --clean NAME",
    ("film.nc", "oil-thickness", "--clean", "nowhere.nc"): "nowhere.nc: no such file",
    ("film.nc", "oil-thickness", "--clean", "clean", "--formula", "papper"): "there is no formula 'papper' (did you mean 'paper'?)",
    ("waters.toml", "ratio"): "waters.toml: a scene, and ratio takes the result of a run: photic run waters.toml",
    ("nowhere.toml", "overlap"): "nowhere.toml: there is no such file",
    ("waters.nc", "overlap", "-o", "x.dat"): "x.dat: outputs are .nc, .csv, .png, .pdf or .svg (write -o x.dat.nc)",
    ("waters.nc", "overlap", "-o", "."): ".: is a folder: name a file in it, as in ./overlap.nc",
}
BY_PROGRAM = {
    ("waters.nc",): "function is required",
    ("waters.nc", "overlap", "-o", ""): "--output: a name is empty",
    ("waters.nc", "ratio", "--chanel", "raman"): "--chanel: did you mean '--channel'?",
    ("waters.nc", "k-lidar", *ELASTIC, "--depths", "1"): "--depths: At least 2 required but received 1",
    ("waters.nc", "k-lider"): "there is no function 'k-lider' (did you mean 'k-lidar'?)",
}


# Seen red: with options that no function checks; without the file in messages of functions.
@pytest.mark.parametrize("words", REFUSED, ids=" ".join)
def test_what_is_refused(analyse, folder, words):
    before = sorted(folder.iterdir())
    done = analyse(*words)
    assert (done.returncode, done.stdout) == (2, "")
    assert REFUSED[words] in done.stderr
    assert sorted(folder.iterdir()) == before


# Seen red: with any number of depths.
@pytest.mark.parametrize("words", BY_PROGRAM, ids=" ".join)
def test_what_the_program_refuses(by_program, words):
    done = by_program(*words)
    assert (done.returncode, done.stdout) == (2, "")
    assert BY_PROGRAM[words] in done.stderr


OPTIONS = {
    "k-lidar": [*ELASTIC, "--depths", "-1", "8", "--environment", "green", "--environment", "bloom", "--telescope", "wide", "--json"],
    "z90": ["--channel=raman", "--share", "0.5", "--environment=green"],
    "ratio": ["--of", "elastic", "--over", "chlorophyll", "--reference", "green"],
    "linear-fit": ["--against", CHLOROPHYLL, "--json"],
    "lidar-equation": ["--channel", "raman", "--channel", "elastic"],
}


@pytest.mark.parametrize("name", OPTIONS)
def test_options_reach_the_package(by_program, analyse, name):
    # Seen red: with --share, and then with the second of two environments, left out by the program.
    done = by_program("waters.nc", name, *OPTIONS[name])
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout == analyse("waters.nc", name, *OPTIONS[name]).stdout


def test_an_environment_that_fails(by_program, tmp_path):
    # Seen red: with the exit code of bad input.
    done = by_program("waters.nc", "overlap", "-o", tmp_path / "nowhere" / "o.nc")
    assert (done.returncode, done.stderr) == (1, f"{tmp_path}/nowhere/o.nc: cannot write it: No such file or directory\n")
    with open("/dev/full", "w", encoding="utf-8") as full:
        done = by_program("waters.nc", "overlap", capture_output=False, stdout=full, stderr=-1)
    assert (done.returncode, done.stderr) == (1, "photic: cannot write to standard output: No space left on device\n")
    done = by_program("waters.nc", "overlap", env=os.environ | {"PHOTIC_PYTHON": "/nowhere/python3"})
    assert done.returncode == 1 and "no Python that can analyse results: /nowhere/python3 is not there" in done.stderr


@pytest.mark.parametrize("name", ["k.nc", "k.csv", "k.png"])
def test_what_cannot_be_written_leaves_what_was_there(program, folder, by_program, tmp_path, name):
    """Written whole or not at all: a file size limit ends the writing in its middle."""
    # Seen red: .nc and .csv, with the file opened where it goes.
    path = tmp_path / name
    assert by_program("waters.nc", "k-lidar", *ELASTIC, "-o", path).returncode == 0
    before = path.read_bytes()
    limited = 'ulimit -f 1; trap "" XFSZ; exec "$@" 2>/dev/null'
    words = [program, "analyse", folder / "waters.nc", "k-lidar", *ELASTIC, "-o", path]
    done = subprocess.run(["bash", "-c", limited, "limited", *words], stdin=subprocess.DEVNULL, capture_output=True, check=False)
    assert done.returncode == 1
    assert path.read_bytes() == before
    assert [each.name for each in tmp_path.iterdir()] == [name]


def test_completion_has_functions_and_files(photic):
    # Seen red: without the choices of the function.
    def candidates(*words):
        return [line.partition("\t")[0] for line in photic("complete", "--", *words).stdout.splitlines()]

    assert candidates("analyse", "") == ["*.nc", "*.toml"]
    assert candidates("analyse", "my.nc", "k") == ["k-lidar"]
    assert candidates("analyse", "my.nc", "oil-thickness", "--clean", "") == ["*.nc"]
    assert "--channel" in candidates("analyse", "my.nc", "z90", "--channel", "raman", "--ch")


def test_help_names_every_function_and_its_options(photic):
    # Seen red: with lidar-equation left out of the program's choices.
    text = photic("analyse", "--help").stdout
    for name, function in FUNCTIONS.items():
        assert name in text
        assert name in [line.partition("\t")[0] for line in photic("complete", "--", "analyse", "my.nc", "").stdout.splitlines()]
        assert all(f"--{option}" in text for option in function.options)
