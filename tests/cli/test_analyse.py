"""photic analyse: functions of the package as tables, files and pictures."""

import csv
import io
import json
import os
import re
import subprocess
from dataclasses import dataclass

import numpy
import photic as package
import pytest
import xarray
from conftest import QUICK_SCENE
from photic.__main__ import main
from photic.analysis import FUNCTIONS

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


def matches(numbers, dataset, name, reliable="reliable"):
    """Numbers in the order of telescopes, the axis across and places, against a variable of the package."""
    values = numpy.array([numpy.nan if each["value"] is None else each["value"] for each in numbers])
    errors = numpy.array([numpy.nan if each["standard_error"] is None else each["standard_error"] for each in numbers])
    numpy.testing.assert_array_equal(values, dataset[name].values.ravel())
    numpy.testing.assert_array_equal(errors, dataset[f"{name}_standard_error"].values.ravel())
    assert [each["reliable"] for each in numbers] == dataset[reliable].values.ravel().tolist()


def test_range_corrected(found, result):
    # Seen red: with --telescope left out.
    numbers = found("waters.nc", "range-corrected")["range_corrected"]
    assert len(numbers) == 2 * 3 * 10  # no gate is dropped
    matches(numbers, package.range_corrected(result), "range_corrected")
    assert {each["units"] for each in numbers} == {"sr-1"}
    chosen = found("waters.nc", "range-corrected", "--telescope", "wide", "--channel", "raman", "--channel", "elastic")
    expected = package.range_corrected(result).sel(telescope=["wide"], channel=["raman", "elastic"])
    matches(chosen["range_corrected"], expected, "range_corrected")


def test_k_lidar(found, analyse, result):
    # Seen red: with depths that do not reach the function.
    numbers = found("waters.nc", "k-lidar", *ELASTIC, "--depths", "1", "7", "--telescope", "narrow")
    expected = package.k_lidar(result, "elastic", depths=(1, 7), telescope="narrow")
    matches(numbers["k"], expected, "k")
    matches(numbers["k_fitted"], expected, "k_fitted", "k_fitted_reliable")
    assert [each["place"] for each in numbers["k"]] == pytest.approx(range(1, 10))
    lines = analyse("waters.nc", "k-lidar", *ELASTIC, "--depths", "1", "7").stdout.splitlines()
    assert lines[-2:] == [
        f"telescope {name}: fitted through 6 gates from 1.50 to 6.50 m (errors of echoes below 10 %)" for name in ("narrow", "wide")
    ]


def test_gates_that_a_fit_leaves_out_are_named(program, folder, analyse, result):
    # Seen red: with the gates that the fit takes.
    spoilt = result.copy(deep=True)
    spoilt.echo_standard_error[0, 0, 4] = 0.2 * spoilt.echo[0, 0, 4]
    spoilt.to_netcdf(folder / "spoilt.nc")
    notes = json.loads(analyse("spoilt.nc", "k-lidar", *ELASTIC, "--telescope", "narrow", "--json").stdout)["notes"]
    assert len(notes) == 1 and ", less those at 4.50 m (" in notes[0]


def test_z90_in_several_waters(found, result):
    # Seen red: with the scene's own depth in each.
    waters = ["bloom", "clear"]
    given = [word for name in waters for word in ("--environment", name)]
    numbers = found("waters.nc", "z90", *ELASTIC, "--share", "0.5", *given)["z90"]
    for number, (telescope, water) in zip(numbers, [(t, w) for t in ("narrow", "wide") for w in waters], strict=True):
        assert (number["telescope"], number["environment"], number["channel"]) == (telescope, water, "elastic")
        one = package.z90(result, "elastic", 0.5, telescope=telescope, environment=water)
        expected = [float(one.z90[0]), float(one.z90_standard_error[0])]
        assert [number["value"], number["standard_error"]] == pytest.approx(expected, rel=1e-12)
    assert numbers[0]["value"] < numbers[1]["value"]


def test_ratio(found, result):
    # Seen red: with channels that do not reach the function.
    numbers = found("waters.nc", "ratio", "--of", "elastic", "--over", "raman", "--environment", "green", "--reference", "clear")
    expected = package.ratio(result, "elastic", "raman", environment=["green"], reference="clear")
    matches(numbers["ratio"], expected, "ratio")
    matches(numbers["ratio_of_sums"], expected, "ratio_of_sums", "ratio_of_sums_reliable")
    assert found("waters.nc", "ratio")["ratio"][0]["value"] == float(package.ratio(result).ratio[0, 0])


def test_oil_thickness(found, folder):
    # Seen red: with a formula that does not reach the function.
    film = package.open(folder / "film.nc")
    numbers = found("film.nc", "oil-thickness", "--clean", "clean", "--formula", "paper")["thickness"]
    matches(numbers, package.oil_thickness(film, "clean", formula="paper"), "thickness")
    other = found("film.nc", "oil-thickness", "--clean", "plain.nc", "--channel", "raman")["thickness"]
    matches(other, package.oil_thickness(film, package.open(folder / "plain.nc")), "thickness")


@pytest.mark.parametrize("name", ["overlap", "lidar-equation"])
def test_of_a_result_s_scene_and_of_a_scene_file(found, result, name):
    # Seen red: with the channels in another order.
    function, variable = {"overlap": (package.overlap, "overlap"), "lidar-equation": (package.lidar_equation, "echo")}[name]
    expected = function(package.Scene(result.attrs["scene"]))[variable].values.ravel()
    numbers = found("waters.nc", name)[variable]
    assert [each["value"] for each in numbers] == expected.tolist()
    assert {(each["standard_error"], each["reliable"]) for each in numbers} == {(None, None)}
    assert [each["value"] for each in found("waters.toml", name)[variable]] == pytest.approx(expected, rel=1e-12)


def test_a_line_through_ratios(found, result):
    # Seen red: with environments in the order of their names.
    numbers = found("waters.nc", "linear-fit", "--telescope", "wide", "--of", "chlorophyll", "--against", CHLOROPHYLL)
    ratios = package.ratio(result, environment=list(WATERS), telescope="wide").isel(telescope=0)
    fit = package.linear_fit(list(WATERS.values()), ratios, "ratio_of_sums")
    for name in ("slope", "offset"):
        matches(numbers[name], fit, name)
    assert numbers["chi_squared"][0]["value"] == float(fit.chi_squared)
    assert [each["value"] for each in numbers["residual"]] == fit.residual.values.tolist()
    matches(numbers["ratio_of_sums"], ratios, "ratio_of_sums", "ratio_of_sums_reliable")
    places = {each["environment"]: each["place"] for each in numbers["ratio_of_sums"]}
    assert places == WATERS


def test_a_line_through_depths_of_some_waters(found, result):
    # Seen red: with all waters.
    chosen = ["clear", "green", "bloom"]
    given = [word for name in chosen for word in ("--environment", name)]
    numbers = found("waters.nc", "linear-fit", *ELASTIC, *given, "--telescope", "narrow")
    assert {name: each["environment"] for name, each in zip(chosen, numbers["z90"])} == {name: name for name in chosen}
    assert numbers["degrees_of_freedom"][0]["value"] == 1
    assert numbers["z90"][2]["value"] == float(package.z90(result, "elastic", telescope="narrow", environment="bloom").z90[0])


def test_other_numbers_that_differ_are_noted(program, folder, analyse):
    # Seen red: without the note.
    run = calls(program, folder)
    grid = ["--set", f"environment_grid.{CHLOROPHYLL}=[0.1, 0.3, 0.6]", "--set", "environment_grid.sea.layer.1.chlorophyll_mg_m3=[0.5, 1]"]
    (folder / "grid.toml").write_text(SCENE.replace(LEVELS, ""))
    assert run("run", "grid.toml", "-q", "--photons", "4000", *grid).returncode == 0
    done = analyse("grid.nc", "linear-fit")
    assert done.returncode == 2 and f"linear-fit takes --against PATH, one of the numbers that environments set: {CHLOROPHYLL}" in done.stderr
    done = analyse("grid.nc", "linear-fit", "--against", CHLOROPHYLL)
    assert done.stdout.splitlines()[-1] == "The environments differ in sea.layer.1.chlorophyll_mg_m3, too (--environment NAME chooses some)"


CELL = re.compile(r"^ +(\d+\.\d\d)(?: +(\S+?)±(\S+?)(\*?)(?= |$))+$")


def test_the_table(analyse, result):
    """Aligned, a row for each gate, and a star behind what is not reliable."""
    # Seen red: with no room for a star behind what is reliable.
    lines = analyse("waters.nc", "ratio", "--telescope", "narrow").stdout.splitlines()
    assert lines[0] == "Ratio of echoes: a quick scene"
    start = lines.index("telescope narrow")
    rows = lines[start + 2 : start + 12]
    assert all(CELL.match(row) for row in rows)
    assert len({row.index("±") for row in rows}) <= 3 and len({len(row.rstrip("*")) for row in rows}) == 1
    expected = package.ratio(result, telescope="narrow")
    assert [row.endswith("*") for row in rows] == (~expected.reliable[0]).values.tolist()
    shown = [float(CELL.match(row)[2]) for row in rows]
    assert shown == pytest.approx(expected.ratio[0].values, abs=5e-5, rel=0.02)
    assert "* not reliable: a gate that it is made of has not converged, or its error is not known" in lines


def test_columns_that_do_not_fit_stand_below_each_other(analyse):
    # Seen red: with one part for all.
    waters = [word for name in WATERS for word in ("--environment", name)] * 2
    lines = analyse("waters.nc", "k-lidar", *ELASTIC, "--telescope", "narrow", *waters, "--depths", "0", "5").stdout.splitlines()
    assert all(len(line) <= 100 for line in lines if "±" in line)
    numbers = analyse("waters.nc", "range-corrected", "--telescope", "narrow").stdout
    assert numbers.count("depth [m]") == 1 and numbers.count("±") == 30


def test_a_netcdf_file(analyse, folder, result, tmp_path):
    # Seen red: without the scene.
    path = tmp_path / "k.nc"
    done = analyse("waters.nc", "k-lidar", *ELASTIC, "-o", path)
    assert (done.returncode, done.stderr) == (0, "")
    with xarray.open_dataset(path) as file:
        written = file.load()
    xarray.testing.assert_equal(written, package.k_lidar(result, "elastic"))
    about = written.attrs
    assert about["command"] == f"photic analyse waters.nc k-lidar --channel elastic -o {path}"
    assert about["history"].endswith(about["command"]) and about["result"] == "waters.nc"
    assert about["scene"] == result.attrs["scene"] and about["photic_content"] == "analysis"
    assert [each.name for each in tmp_path.iterdir()] == ["k.nc"]


def test_a_csv_file(analyse, found, tmp_path):
    # Seen red: with True for true.
    path = tmp_path / "ratio.CSV"
    assert analyse("waters.nc", "ratio", "-o", path).returncode == 0
    head = path.read_text().splitlines()[:3]
    assert head[1].endswith(f"written by photic analyse: photic analyse waters.nc ratio -o {path}") and head[2] == "# place: depth [m]"
    rows = list(csv.DictReader(io.StringIO("".join(path.read_text().splitlines(keepends=True)[3:]))))
    numbers = [number for of in ("ratio", "ratio_of_sums") for number in found("waters.nc", "ratio")[of]]
    key = lambda each: (each["quantity"], each["telescope"], int(each["gate"] or 0))  # noqa: E731
    for row, number in zip(sorted(rows, key=key), sorted(numbers, key=key), strict=True):
        assert (float(row["value"]), float(row["standard_error"])) == (number["value"], number["standard_error"])
        assert row["reliable"] == str(number["reliable"]).lower()


PICTURES = {
    "k.svg": ["k-lidar", *ELASTIC],
    "z.svg": ["z90", *ELASTIC],
    "r.svg": ["ratio", "--environment", "clear", "--environment", "bloom"],
    "f.svg": ["linear-fit"],
    "x.svg": ["range-corrected"],
    "o.svg": ["overlap"],
}


@pytest.mark.parametrize("name", PICTURES)
def test_pictures(analyse, tmp_path, name):
    # Seen red: without the caption; without the panel of quotients.
    done = analyse("waters.nc", *PICTURES[name], "-o", tmp_path / name)
    assert (done.returncode, done.stderr) == (0, "")
    text = (tmp_path / name).read_text()
    assert "written by photic analyse" in text
    words = re.findall(r"<!-- (.*?) -->", text)
    assert ("Bars: 95 % intervals. Open circles: not reliable." in words) == (name != "o.svg")
    expected = {"k.svg": "k [1/m]", "z.svg": "telescope", "r.svg": "bloom", "f.svg": f"over {CHLOROPHYLL}", "x.svg": "raman", "o.svg": "overlap"}
    assert expected[name] in words


@pytest.mark.parametrize(("name", "head"), [("a.png", b"\x89PNG"), ("a.pdf", b"%PDF")])
def test_an_earlier_output_is_replaced_and_nothing_else(analyse, tmp_path, name, head):
    # Seen red: without the mark in pictures; with any file replaced.
    path = tmp_path / name
    for _ in range(2):
        assert analyse("waters.nc", "overlap", "-o", path).returncode == 0
    assert path.read_bytes().startswith(head)
    path.write_text("mine")
    done = analyse("waters.nc", "overlap", "-o", path)
    assert (done.returncode, done.stdout) == (2, "") and path.read_text() == "mine"
    assert done.stderr == f"{path}: is there already, no file of photic analyse, and is left as it is (--force replaces it)\n"
    assert analyse("waters.nc", "overlap", "-o", path, "--force").returncode == 0
    assert path.read_bytes().startswith(head)


def test_results_are_not_replaced(analyse, folder):
    # Seen red: with --force over the result itself.
    before = (folder / "plain.nc").read_bytes(), (folder / "waters.nc").read_bytes()
    for output, more in (("plain.nc", []), ("waters.nc", []), ("waters.nc", ["--force"])):
        assert analyse("waters.nc", "overlap", "-o", output, *more).returncode == 2
    assert ((folder / "plain.nc").read_bytes(), (folder / "waters.nc").read_bytes()) == before


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
