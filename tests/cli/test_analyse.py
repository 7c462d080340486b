"""photic analyse: functions of the package as tables, files and pictures."""

import csv
import io
import json
import re

import numpy
import photic as package
import pytest
import xarray
from analysed_results import CHLOROPHYLL, ELASTIC, LEVELS, SCENE, WATERS, calls

pytest_plugins = ["analysed_results"]


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
