"""photic optics: the same numbers on the terminal, as JSON, CSV and netCDF; files after CF-1.10; and what is refused."""

import csv
import json
import os
import re

import netCDF4
import numpy
import pytest
from conftest import QUICK_SCENE

LAYERS = [(0.0, 5.0), (5.0, numpy.inf)]
WAVELENGTHS = [355.0, 400.0, 450.0, 500.0, 532.0]
LIST = "355,400:500:50,532"
TOTALS = ["a_per_m", "b_per_m", "c_per_m", "bb_per_m", "albedo", "mean_cosine", "a_phytoplankton_per_m"]
PARTS = {"water": "water", "phytoplankton": "phytoplankton_and_detritus", "CDOM": "cdom"}


def as_json(photic, *arguments):
    done = photic("optics", *arguments, "--json")
    assert (done.returncode, done.stderr) == (0, "")
    return json.loads(done.stdout)


def rows_of(path):
    lines = [line for line in path.read_text().splitlines() if not line.startswith("#")]
    return list(csv.DictReader(lines))


@pytest.fixture
def library(photic, scene, tmp_path):
    """The optics of the quick scene with some CDOM at the bottom, as netCDF."""
    done = photic("optics", "quick.toml", "--set", "sea.layer.1.cdom_a440_per_m=0.05", "--wavelengths", LIST, "-o", "lib.nc")
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout.startswith("lib.nc: the optics of 2 layers at 5 wavelengths\n")
    with netCDF4.Dataset(tmp_path / "lib.nc") as file:
        file.set_auto_mask(False)
        yield file


# Seen red: with the depth of a layer's lower edge in the first column.
def test_the_same_numbers_in_every_form(photic, library, tmp_path):
    arguments = ["quick.toml", "--set", "sea.layer.1.cdom_a440_per_m=0.05", "--wavelengths", LIST]
    out = as_json(photic, *arguments)
    assert out["wavelength_nm"] == list(library["wavelength_nm"][:]) == WAVELENGTHS
    assert out["angle_deg"] == list(library["angle_deg"][:])
    assert photic("optics", *arguments, "-o", "lib.csv").returncode == 0
    rows = rows_of(tmp_path / "lib.csv")
    assert list(rows[0])[:6] == ["depth_m", "wavelength_nm", "a_per_m", "b_per_m", "c_per_m", "bb_per_m"]
    cells = [(depth, nm) for depth, _ in LAYERS for nm in WAVELENGTHS]
    assert [(float(row["depth_m"]), float(row["wavelength_nm"])) for row in rows] == cells
    for k, layer in enumerate(out["layers"]):
        assert (layer["depth_m"], layer["bottom_depth_m"]) == (LAYERS[k][0], [5.0, None][k])
        for name in TOTALS:
            assert layer[name] == list(library[name][k]) == [float(row[name]) for row in rows[5 * k : 5 * k + 5]]
        assert layer["phase_function_per_sr"] == library["phase_function_per_sr"][k].tolist()
        assert list(layer["parts"]) == list(PARTS)
        for part, values in layer["parts"].items():
            for quantity, numbers in values.items():
                name = f"{quantity.removesuffix('_per_m')}_{PARTS[part]}_per_m"
                assert numbers == list(library[name][k]) == [float(row[name]) for row in rows[5 * k : 5 * k + 5]]
        emission = layer["emission"]
        assert list(emission) == list(library["process_name"][:]) == ["raman", "chlorophyll", "cdom"]
        assert [one["coefficient_per_m"] for one in emission.values()] == list(library["emission_per_m"][k])
        lines = sum((one["line_per_m"] for one in emission.values()), [])
        assert lines == list(library["emission_line_per_m"][k])
    text = photic("optics", *arguments).stdout
    assert f"{out['layers'][1]['a_per_m'][4]:#.5g}" in text
    assert f"{out['layers'][1]['backscatter_fraction'][4]:.5f}" in text


# Seen red: with b in the place of bb. c = a + b, parts are all of it, phase functions are 1 over the sphere: as far as their angles reach.
def test_numbers_go_together(library):
    a, b, c, bb = (library[name][:] for name in ["a_per_m", "b_per_m", "c_per_m", "bb_per_m"])
    assert c == pytest.approx(a + b, rel=1e-15)
    assert library["albedo"][:] == pytest.approx(b / c, rel=1e-15)
    assert sum(library[f"a_{part}_per_m"][:] for part in PARTS.values()) == pytest.approx(a)
    assert sum(library[f"b_{part}_per_m"][:] for part in list(PARTS.values())[:2]) == pytest.approx(b)
    assert sum(library[f"bb_{part}_per_m"][:] for part in list(PARTS.values())[:2]) == pytest.approx(bb, rel=1e-4)
    emitted = library["emission_per_m"][:, list(library["process_name"][:]).index("chlorophyll")]
    assert emitted == pytest.approx(0.01 * library["a_phytoplankton_per_m"][:, -1], rel=1e-5)  # yield 0.01, 532 nm; a spectrum to 4.5 sigma
    angle = numpy.radians(library["angle_deg"][:])
    back = angle >= numpy.radians(89.9)
    p = library["phase_function_per_sr"][:] * 2 * numpy.pi * numpy.sin(angle)
    assert numpy.trapz(p[:, :, back], angle[back]) == pytest.approx(bb / b, rel=3e-3)


# As tests/unit/io/test_cf.cpp does for results (CF-1.10; sections are named). Seen red: without the units of albedo;
# with a misspelt name in `coordinates`; with the bounds' units.
def follows_the_cf_conventions(library):
    assert library.Conventions == "CF-1.10"  # 2.6
    for name in ["title", "source", "history", "references"]:
        assert library.getncattr(name)
    bounds = {v.bounds for v in library.variables.values() if "bounds" in v.ncattrs()}
    for name, variable in library.variables.items():
        assert re.fullmatch(r"[A-Za-z][A-Za-z0-9_]*", name)  # 2.3
        assert len(variable.long_name) > 10  # 3.2
        if variable.dtype == str or name in bounds:  # 7.1: bounds have the units of their parent
            assert "units" not in variable.ncattrs()
        else:
            assert variable.units in {"m-1", "1", "m", "nm", "degree", "sr-1", "nm-1", "ns"}  # 3.1
            assert ("_per_m" in name) == (variable.units == "m-1")
        if "_FillValue" not in variable.ncattrs() and variable.dtype == float:
            assert not numpy.isnan(variable[...]).any()  # 2.5.1
        described = set()
        for coordinate in getattr(variable, "coordinates", "").split():  # 5
            assert coordinate != name
            assert set(library[coordinate].dimensions) <= set(variable.dimensions)
            described |= set(library[coordinate].dimensions)
        if len(variable.dimensions) > 1 and name not in bounds:
            assert described == set(variable.dimensions)


def test_follows_the_cf_conventions(library):
    follows_the_cf_conventions(library)
    assert library.scene and (library.photic_format, library.photic_content) == (3, "optics")
    assert {v.bounds for v in library.variables.values() if "bounds" in v.ncattrs()} == {"depth_m_bounds"}
    assert library["depth_m"].positive == "down"
    standard = {v.standard_name for v in library.variables.values() if "standard_name" in v.ncattrs()}
    assert "volume_absorption_coefficient_of_radiative_flux_in_sea_water" in standard
    assert library["depth_m_bounds"][:].tolist() == [list(edges) for edges in LAYERS]
    assert "Mason" in library["a_water_per_m"].source and "Bricaud" in library.references


def test_the_file_holds_its_scene(photic, library):
    shown = photic("show", "lib.nc")
    assert shown.returncode == 0
    assert "cdom_a440_per_m = 0.05" in shown.stdout


# Seen red: reported as a damaged result.
def test_nothing_goes_on_from_optics(photic, library):
    done = photic("run", "quick.toml", "--continue", "lib.nc")
    assert (done.returncode, done.stdout) == (2, "")
    assert done.stderr.startswith("lib.nc: holds the optics of layers, and no echoes (a result is what")


# Infrared light so far from water's band that none is emitted. Seen red: with a dimension of no lines.
def test_light_that_nothing_is_emitted_of(photic, scene, tmp_path):
    iop = 'iop = [ { wavelength_nm = 3000.0, a_per_m = 10.0, b_per_m = 0.0 } ]\nphase_function = "isotropic"'
    text = QUICK_SCENE.replace("532.0", "3000.0").replace("chlorophyll_mg_m3 = 0.1", iop).replace(
        "chlorophyll_mg_m3 = 1.0", iop).replace('[[channel]]\nname = "raman"\nprocess = "raman"\n', "")
    scene.write_text(text.replace("[[sea.layer]]", "[sea]\nrefractive_index = 1.3\ngroup_index = 1.3\n[[sea.layer]]", 1))
    assert "raman: nothing" in photic("optics", "quick.toml").stdout
    assert photic("optics", "quick.toml", "-o", "ir.nc").returncode == 0
    with netCDF4.Dataset(tmp_path / "ir.nc") as file:
        assert "emission_line" not in file.dimensions
        assert file["emission_per_m"][:].tolist() == [[0, 0, 0], [0, 0, 0]]
        assert file["albedo"][:].tolist() == [[0], [0]]


def test_lists_sources_and_what_stands_behind_them(photic, scene):
    text = photic("optics", "quick.toml").stdout
    sources = " ".join(text[text.index("Where the numbers come from") :].split())
    assert "a of water, 532-648.853 nm: Mason" in sources
    assert "[verified]" in sources and "[from memory]" in sources
    shown = photic("show", "quick.toml").stdout
    for source in re.findall(r"(?:b of water|a of water) = [^:]*: (.*)", shown):
        assert source in sources


# Those of the laser and of the channels' light. Seen red: with 685 nm, which no channel counts.
def test_wavelengths_by_default(photic, scene):
    nm = as_json(photic, "quick.toml")["wavelength_nm"]
    assert nm == [532, pytest.approx(648.853, abs=1e-3)]
    text = photic("optics", "quick.toml").stdout
    assert "raman: 0.0001709 1/m at 631.02 to 667.15 nm, in 9 lines" in text
    assert "chlorophyll: " in text  # emitted whether or not a channel counts it


# Seen red: without the keys of the water; with --laser left out.
def test_water_without_a_scene(photic, scene):
    keys = ["chlorophyll_mg_m3=0.5", "cdom_a440_per_m=0.02"]
    more = ["--wavelengths", "400:700:10", "--set", "optics.set=paper", "--set", "sea.salinity_psu=20"]
    out = as_json(photic, "--water", *keys, *more, "--laser", "355")
    scene.write_text(QUICK_SCENE.replace("chlorophyll_mg_m3 = 1.0", "\n".join(keys)))
    same = as_json(photic, "quick.toml", *more, "--set", "source.wavelength_nm=355.0")
    del out["layers"][0]["name"], same["layers"][1]["name"]
    assert out["layers"][0] == same["layers"][1] | {"depth_m": 0}
    assert out["sources"] == [s for s in same["sources"] if s in out["sources"]]
    assert out["excitation_nm"] == 355 and len(out["wavelength_nm"]) == 31


def test_pure_water(photic):
    out = as_json(photic, "--water", "--wavelengths", "500,532")
    assert list(out["layers"][0]["parts"]) == ["water"]
    # Zhang, Hu & He 2009 for 35 PSU and 20 C.
    assert out["layers"][0]["b_per_m"] == pytest.approx([2.54734e-3, 1.96231e-3], rel=1e-4)
    assert out["layers"][0]["bottom_depth_m"] is None
    assert "constituent" in photic("optics", "--water").stdout


REFUSED = {
    "neither scene nor water": ([], "scene, --water, --oil or --air is required"),
    "both": (["quick.toml", "--water"], "exclude each other"),
    "an oil and water": (["--oil", "light-refined", "--water"], "--oil and --water exclude each other"),
    "air under a laser": (["--air", "us-standard", "--laser", "355"], "--air and --laser exclude each other"),
    "no oil": (["--oil", "gasolene"], "there are: light-refined"),
    "water that is no pair": (["--water", "0.5"], "--water: '0.5' is not KEY=VALUE"),
    "an unknown key": (["--water", "chlorophyl=1"], "--set sea.layer.0.chlorophyl: unknown key 'chlorophyl'"),
    "a negative concentration": (["--water", "chlorophyll_mg_m3=-1"], "--set sea.layer.0.chlorophyll_mg_m3: "),
    "not ascending": (["quick.toml", "--wavelengths", "532,355"], "is not ascending: 355 nm follows 532 nm"),
    "ranges that overlap": (["quick.toml", "--wavelengths", "400:500:50,450"], "is not ascending: 450 nm follows 500 nm"),
    "twice": (["quick.toml", "--wavelengths", "355,532,532"], "has 532 nm twice"),
    "negative": (["quick.toml", "--wavelengths=-355"], "'-355' is not above 0 nm"),
    "zero": (["quick.toml", "--wavelengths", "0,355"], "'0' is not above 0 nm"),
    "none": (["quick.toml", "--wavelengths", ""], "'' is not a wavelength in nm"),
    "one left out": (["quick.toml", "--wavelengths", "355,,532"], "'' is not a wavelength in nm"),
    "not a number": (["quick.toml", "--wavelengths", "nan"], "'nan' is not a wavelength in nm"),
    "with its unit": (["quick.toml", "--wavelengths", "532nm"], "'532nm' is not a wavelength in nm"),
    "half a range": (["quick.toml", "--wavelengths", "400:700"], "'400:700' is not from:to:step"),
    "a range backwards": (["quick.toml", "--wavelengths", "700:400:10"], "'700:400:10' ends before it begins"),
    "a step of nothing": (["quick.toml", "--wavelengths", "400:700:0"], "'0' is not above 0 nm"),
    "too many": (["quick.toml", "--wavelengths", "400:700:0.01"], "is more than 10000 wavelengths"),
    "too many by far": (["quick.toml", "--wavelengths", "400:700:1e-300"], "is more than 10000 wavelengths"),
    "no data": (["quick.toml", "--wavelengths", "532,1200"], "--wavelengths: no water absorption data at 1200 nm: Mason "
                "2016 / IOCCG 2018 cover 200-1100 nm"),
    "a laser without data": (["--water", "--laser", "3000"], "no water absorption data at 3000 nm"),
    "a laser that is no number": (["--water", "--laser", "green"], "--laser: 'green' is not a wavelength in nm"),
    "an output of no kind": (["quick.toml", "-o", "lib.txt"], "lib.txt: the result's name ends neither in .nc nor in .csv"),
}


# What was there stays as it was, and nothing half-made beside it. Seen red: with the output opened first.
@pytest.mark.parametrize("what", REFUSED)
def test_refuses(photic, scene, tmp_path, what):
    arguments, message = REFUSED[what]
    (tmp_path / "lib.nc").write_text("as it was")
    before = sorted(os.listdir(tmp_path))
    output = [] if "-o" in arguments else ["-o", "lib.nc"]
    done = photic("optics", *arguments, *output)
    assert (done.returncode, done.stdout) == (2, "")
    assert message in done.stderr
    assert "bug" not in done.stderr
    assert (tmp_path / "lib.nc").read_text() == "as it was"
    assert sorted(os.listdir(tmp_path)) == before


def test_reports_the_problems_of_a_scene_at_their_places(photic, scene):
    scene.write_text(QUICK_SCENE.replace("532.0", "1200.0"))
    done = photic("optics", "quick.toml", "--wavelengths", "532")
    assert (done.returncode, done.stdout) == (2, "")
    assert done.stderr.startswith("quick.toml:3:17: no refractive index data at 1200 nm")
    assert done.stderr.endswith("problem in quick.toml\n") or done.stderr.endswith("problems in quick.toml\n")


# Seen red: without looking at these files, in each of the two.
@pytest.mark.parametrize("subcommand", ["optics", "run"])
def test_replaces_no_file_that_it_reads(photic, scene, tmp_path, subcommand):
    table = "angle_deg,phase_function_per_sr\n0,0.0795774715\n180,0.0795774715\n"
    (tmp_path / "vsf.csv").write_text(table)
    iop = 'iop = [ { wavelength_nm = 532.0, a_per_m = 0.06, b_per_m = 0.1 }, { wavelength_nm = 700.0, a_per_m = 0.6, ' \
          'b_per_m = 0.1 } ]\nphase_function = { model = "table", file = "vsf.csv" }'
    text = QUICK_SCENE.replace("chlorophyll_mg_m3 = 1.0", iop)
    scene.write_text(text)
    os.link(tmp_path / "vsf.csv", tmp_path / "same.csv")
    os.link(scene, tmp_path / "scene.csv")
    for name in ["vsf.csv", "same.csv", "scene.csv"]:
        done = photic(subcommand, "quick.toml", "-o", name)
        assert (done.returncode, done.stdout) == (2, "")
        assert done.stderr.startswith(f"{name}: the result would replace ")
    assert (tmp_path / "vsf.csv").read_text() == table and scene.read_text() == text


def test_a_folder_that_cannot_be_written(photic, scene, tmp_path):
    done = photic("optics", "quick.toml", "-o", "nowhere/lib.csv")
    assert (done.returncode, done.stdout) == (1, "")
    assert "nowhere" in done.stderr
    assert os.listdir(tmp_path) == ["quick.toml"]


# The paper's LIBSEA: what is written is read as water. Seen red: with c_per_m refused beside b_per_m.
@pytest.mark.parametrize("name", ["lib.nc", "lib.csv"])
def test_writes_what_scenes_can_read_as_water(photic, scene, tmp_path, name):
    water = ["chlorophyll_mg_m3=0.5", "cdom_a440_per_m=0.02", "minerals_g_m3=0.3"]
    assert photic("optics", "--water", *water, "--wavelengths", "440:740:4", "-o", name).returncode == 0
    layers = re.search(r"\[\[sea.layer\]\].*?(?=\[gates\])", QUICK_SCENE, re.DOTALL)
    scene.write_text(QUICK_SCENE.replace(layers.group(), f'[sea]\niop_table = "{name}"\n'))
    there, back = as_json(photic, "--water", *water, "--wavelengths", "532,680"), as_json(photic, "quick.toml", "--wavelengths", "532,680")
    for quantity in ["a_per_m", "b_per_m", "bb_per_m", "a_phytoplankton_per_m"]:
        assert back["layers"][0][quantity] == pytest.approx(there["layers"][0][quantity], rel=0.02), quantity
    assert back["layers"][0]["emission"]["raman"]["coefficient_per_m"] > 0
