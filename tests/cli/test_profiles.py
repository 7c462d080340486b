"""Constituents that change with depth, and tables of optical properties."""

import json
import re

import netCDF4
import numpy as np
import pytest


def write_float(path, **variables):
    """What a BGC-Argo float measured, as it writes it: name=(units, rows, flags of each row or nothing)."""
    profiles, levels = np.shape(next(iter(variables.values()))[1])
    with netCDF4.Dataset(path, "w", format="NETCDF3_CLASSIC") as file:
        file.createDimension("N_PROF", profiles)
        file.createDimension("N_LEVELS", levels)
        file.createVariable("LATITUDE", "f8", ("N_PROF",))[:] = [45.0] * profiles
        for name, (units, rows, *flags) in variables.items():
            variable = file.createVariable(name, "f4", ("N_PROF", "N_LEVELS"), fill_value=99999.0)
            variable.units = units
            variable[:] = np.ma.masked_equal(np.array(rows, dtype="f4"), 99999)
            if flags:
                characters = file.createVariable(f"{name}_QC", "S1", ("N_PROF", "N_LEVELS"), fill_value=b" ")
                characters[:] = np.frombuffer(b"".join(flags), dtype="S1").reshape(profiles, levels)
    return path


@pytest.fixture
def float_file(tmp_path):
    """Two profiles, with gaps."""
    depths = [0, 2, 4, 6, 8, 10]
    return write_float(tmp_path / "float.nc",
                       PRES=("decibar", [depths, depths]),
                       CHLA=("mg/m3", [[9, 9, 9, 9, 9, 9], [0.2, 0.4, 99999, 0.8, 0.6, 0.4]]))


def with_profile(scene, profile):
    text = scene.read_text()
    scene.write_text(text.replace("chlorophyll_mg_m3 = 0.1", f"chlorophyll_mg_m3 = {profile}"))


FROM_FLOAT = '{ file = "float.nc", variable = "CHLA", depth = "PRES", profile = 1 }'


def shown_with_remarks(photic, *arguments):
    done = photic("show", "--json", *arguments)
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)


def shown(photic, *arguments):
    done = photic("show", "--json", *arguments)
    assert (done.returncode, done.stderr) == (0, "")
    return json.loads(done.stdout)


# Seen red: with the reader of netCDF files not handed to `photic run`.
def test_a_float_profile_from_end_to_end(photic, scene, float_file):
    with_profile(scene, FROM_FLOAT)
    done = photic("run", "quick.toml", "--photons", "4000")
    assert done.returncode == 0, done.stderr
    remark = r"quick.toml:\d+:21: .*float.nc: 1 of 6 levels of CHLA have no value or no depth and are left out; "
    assert re.search(remark + r"the widest gap is from 1.984 to 5.951 m", done.stderr)
    layers = shown_with_remarks(photic, "quick.toml")["sea"]["layer"]
    names = [layer["name"] for layer in layers]
    assert names == [f"layer0.{i}" for i in range(len(names) - 1)] + ["layer1"]
    assert len(names) > 5
    tops = [0.0] + [layer["bottom_depth_m"] for layer in layers[:-1]]
    depths = np.array([0, 2, 6, 8]) * 0.99187  # of 2 - 8 dbar at 45 degrees, to 1e-5
    chlorophyll = np.array([0.2, 0.4, 0.8, 0.6])
    z = np.linspace(0, 5, 200001)
    column = np.trapz(np.interp(z, depths, chlorophyll), z)
    cut = sum(layer["chlorophyll_mg_m3"] * (layer["bottom_depth_m"] - top) for layer, top in zip(layers[:-1], tops))
    assert cut == pytest.approx(column, rel=2e-5)
    # The result holds its layers and needs no other file.
    float_file.unlink()
    assert photic("check", "quick.toml").returncode == 2
    assert shown(photic, "quick.nc")["sea"]["layer"] == layers
    again = photic("run", "--continue", "quick.nc", "--photons", "8000", "-o", "more.nc")
    assert again.returncode == 0, again.stderr


@pytest.fixture
def bgc_file(tmp_path):
    """A profile with all that such a float measures, and the flags of it."""
    return write_float(tmp_path / "bgc.nc",
                       PRES=("decibar", [[0, 2, 4, 5, 8]], b"11111"),
                       CHLA=("mg/m3", [[0.2, 0.2, 0.2, 0.2, 0.2]], b"11111"),
                       TEMP=("degree_Celsius", [[21, 19, 99, 16, 13]], b"1132 "),
                       PSAL=("psu", [[38, 38, 37, 36.5, 35]], b"12589"))


def from_bgc(variable):
    return f'{{ file = "bgc.nc", variable = "{variable}", depth = "PRES" }}'


# Seen red: with the sea's temperature in all layers; with flag 9 taken for good.
def test_temperature_and_salinity_of_a_float(photic, scene, bgc_file):
    keys = f'{from_bgc("CHLA")}\ntemperature_c = {from_bgc("TEMP")}\nsalinity_psu = {from_bgc("PSAL")}'
    with_profile(scene, keys)
    scene.write_text(scene.read_text().replace("bottom_depth_m = 5.0", "bottom_depth_m = 4.9"))
    done = photic("run", "quick.toml", "--photons", "4000")
    assert done.returncode == 0, done.stderr
    assert "bgc.nc: TEMP_QC flags 1 of 5 levels of TEMP as bad (3, 4) or missing (9)" in done.stderr
    assert "bgc.nc: PSAL_QC flags 1 of 5 levels of PSAL as bad (3, 4) or missing (9)" in done.stderr
    layers = shown(photic, "quick.nc")["sea"]["layer"]
    assert [layer["temperature_c"] for layer in layers[:-1]] == pytest.approx([20, 18, 16.4], abs=0.6)
    assert layers[0]["salinity_psu"] == pytest.approx(38, abs=0.3)
    assert "temperature_c" not in layers[-1]
    done = photic("optics", "quick.toml", "--wavelengths", "600", "--json")
    reported = json.loads(done.stdout)["layers"]
    a_water = [layer["parts"]["water"]["a_per_m"][0] for layer in reported]
    # Their absorption rises with temperature there; the last layer has the sea's 20 C.
    assert a_water[0] > a_water[1] > a_water[2]
    flags = bgc_file.read_bytes()
    assert flags.count(b"12589") == 1
    bgc_file.write_bytes(flags.replace(b"12589", b"44499"))
    done = photic("check", "quick.toml")
    assert done.returncode == 2
    assert "bgc.nc: PSAL: profile 0 has values at 0 of 5 levels; it takes two: PSAL_QC flags 5 of 5 levels" in done.stderr


def as_it_is(data):
    return data


def as_doubles(data):
    """Flags as numbers, NaN where there are none."""
    digits = np.where(data["CHLA_QC"].values == b"", b"nan", data["CHLA_QC"].values)
    return data.assign(CHLA_QC=(data["CHLA_QC"].dims, digits.astype(float)))


def as_texts(data):
    return data.assign(CHLA_QC=(data["CHLA_QC"].dims, data["CHLA_QC"].values.astype(str).astype(object)))


def as_one_profile(data):
    return data.isel(N_PROF=0)


# Seen red: with texts of more than one character refused, "nan" among them.
@pytest.mark.parametrize("change", [as_it_is, as_doubles, as_texts, as_one_profile])
@pytest.mark.parametrize("format", ["NETCDF4", "NETCDF3_64BIT"])
def test_a_float_that_xarray_has_saved(photic, scene, tmp_path, change, format):
    import xarray
    original = write_float(tmp_path / "original.nc",
                           PRES=("decibar", [[0, 2, 4, 6, 8]], b"11111"),
                           CHLA=("mg/m3", [[0.2, 9.0, 0.2, 0.2, 0.2]], b"14 11"))
    with xarray.open_dataset(original) as data:
        change(data.load()).to_netcdf(tmp_path / "float.nc", format=format)
    with_profile(scene, '{ file = "float.nc", variable = "CHLA", depth = "PRES" }')
    done = photic("check", "quick.toml")
    assert done.returncode == 0, done.stderr
    assert "float.nc: CHLA_QC flags 1 of 5 levels of CHLA as bad (3, 4) or missing (9)" in done.stderr
    layers = shown_with_remarks(photic, "quick.toml")["sea"]["layer"]
    assert [layer["chlorophyll_mg_m3"] for layer in layers] == pytest.approx([0.2, 1.0])


# A float as it comes: dark counts too high, one pressure twice, no level above 1 dbar; to 4 m alone.
def test_keys_that_help_a_float(photic, scene, tmp_path):
    write_float(tmp_path / "float.nc",
                PRES=("decibar", [[1, 2, 2, 4]], b"1111"), CHLA=("mg/m3", [[0.2, 0.1, 0.3, -0.01]], b"1111"))
    keys = '{ file = "float.nc", variable = "CHLA", depth = "PRES"'
    with_profile(scene, keys + " }")
    assert '(negative = "zero" counts values below 0 as 0)' in photic("check", "quick.toml").stderr
    scene.write_text(scene.read_text().replace(keys, keys + ', negative = "zero"'))
    assert '(above = "constant" holds its first value up to the top; ' in photic("check", "quick.toml").stderr
    scene.write_text(scene.read_text().replace(keys, keys + ', above = "constant", below = "constant"'))
    done = photic("run", "quick.toml", "--photons", "4000")
    assert done.returncode == 0, done.stderr
    for remark in ("1 of 4 values of CHLA are below 0, the smallest of them -0.01, and count as 0",
                   "1 of 4 levels are at the depth of another one, the first at 1.984 m: they are merged into one",
                   "'chlorophyll_mg_m3' is held constant from 0 to 0.99188 m, at the 0.2 of 0.99188 m",
                   "'chlorophyll_mg_m3' is held constant from 3.96749 to 5 m, at the 0 of 3.96749 m"):
        assert remark in done.stderr
    layers = shown(photic, "quick.nc")["sea"]["layer"]
    tops = [0.0] + [layer["bottom_depth_m"] for layer in layers[:-1]]
    cut = sum(layer["chlorophyll_mg_m3"] * (layer["bottom_depth_m"] - top) for layer, top in zip(layers[:-1], tops))
    assert cut == pytest.approx(0.99188 * (2 * 0.2 + 2 * 0.1), rel=1e-4)  # 0.2 from 0 to 2 dbar, 0 at 4 dbar


def test_problems_of_a_float_profile(photic, scene, float_file):
    with_profile(scene, FROM_FLOAT.replace("CHLA", "CHL"))
    problem = json.loads(photic("check", "quick.toml", "--json").stdout)["problems"][0]
    assert problem["file"].endswith("quick.toml")
    line = scene.read_text().splitlines()[problem["line"] - 1]
    assert line[problem["column"] - 1:].startswith('"float.nc"')
    assert problem["reason"].endswith('float.nc: no variable "CHL"')
    assert problem["suggestion"] == "did you mean 'CHLA'?"
    float_file.write_bytes(float_file.read_bytes()[:100])
    done = photic("check", "quick.toml")
    assert done.returncode == 2
    assert "float.nc: " in done.stderr


def with_table(scene, table):
    head, rest = scene.read_text().split("[[sea.layer]]", 1)
    scene.write_text(f"{head}[sea]\niop_table = {table}\n[gates]" + rest.split("[gates]", 1)[1])


def test_a_table_in_netcdf_and_csv_give_the_same_echo(photic, scene, tmp_path):
    wavelengths, depths = np.array([500.0, 600.0, 700.0]), np.array([0.0, 5.0])
    a = np.array([[0.05, 0.25, 0.65], [0.04, 0.24, 0.64]])
    b = np.array([[0.2, 0.15, 0.1], [0.1, 0.08, 0.06]])
    with netCDF4.Dataset(tmp_path / "lib.nc", "w") as file:
        file.createDimension("depth", 2)
        file.createDimension("wavelength", 3)
        file.createVariable("depth_m", "f8", ("depth",))[:] = depths
        file.createVariable("wavelength_nm", "f8", ("wavelength",))[:] = wavelengths
        for name, values in [("a_per_m", a), ("c_per_m", a + b), ("bb_per_m", 0.02 * b)]:
            file.createVariable(name, "f8", ("depth", "wavelength"))[:] = values
    rows = ["depth_m, wavelength_nm, a_per_m, c_per_m, bb_per_m"]
    for i, depth in enumerate(depths):
        for j, nm in enumerate(wavelengths):
            values = (float(x[i, j]) for x in (a, a + b, 0.02 * b))
            rows.append(f"{depth}, {nm}, " + ", ".join(map(repr, values)))
    (tmp_path / "lib.csv").write_text("\n".join(rows))
    echoes = []
    with_table(scene, '"lib.nc"')
    for name in ("lib.nc", "lib.csv"):
        done = photic("run", "quick.toml", "--photons", "4000", "-o", "out.nc", "--set", f"sea.iop_table={name}")
        assert done.returncode == 0, done.stderr
        with netCDF4.Dataset(tmp_path / "out.nc") as result:
            echoes.append(np.array(result["echo"][:]))
    assert (echoes[0] == echoes[1]).all()
    assert (echoes[0][0, 0] > 0).all()
    layers = shown(photic, "out.nc")["sea"]["layer"]
    assert len(layers) == 2
    assert layers[1]["iop"][0]["b_per_m"] == pytest.approx(0.1, rel=1e-12)
    assert "phase_function" not in layers[1]
    sources = photic("show", "out.nc").stdout
    assert "given in the scene; b_b/b = 0.02, too: phase function Fournier-Forand" in sources


def test_problems_of_a_table_as_json(photic, scene, tmp_path):
    (tmp_path / "lib.csv").write_text("depth_m, wavelength_nm, a_per_m, b_per_m\n0, 532, -1, 0.1\n")
    with_table(scene, '{ file = "lib.csv", phase_function = "petzold" }')
    out = json.loads(photic("check", "quick.toml", "--json").stdout)
    problem = out["problems"][0]
    assert problem["file"].endswith("lib.csv")
    assert (problem["line"], problem["column"]) == (2, 8)
    assert problem["reason"] == "'a_per_m' must be a finite number, at least 0, not -1"
