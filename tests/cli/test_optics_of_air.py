"""photic optics of air and oil: the same numbers on the terminal, as JSON, CSV and netCDF; tape7; and what is refused."""

import os
import re

import netCDF4
import numpy
import pytest
from test_optics import as_json, follows_the_cf_conventions, rows_of

LAYERS_OF_AIR = ["a_per_m", "b_per_m", "c_per_m", "bb_per_m", "albedo", "mean_cosine", "refractive_index"]
HAZY = ["--air", "us-standard", "--visibility", "23", "--aerosol", "opac-waso-80", "--wavelengths", "355,532"]
TAPE7 = """\
T F 1    2    0    0    1    1
   10000.0   25000.0      10.0      20.0NW
    FREQ COMBIN    H2O     O3 MOLEC AER+CLD    -LOG  CLOUD    CO2
    CM-1  TRANS  TRANS  TRANS  SCAT  TRANS  COMBIN  TRANS  TRANS
18000.00 0.7000 0.9900 0.9000 0.9000 0.8730   0.357 0.0000 1.0000
19000.00 0.6000 1.0000 0.9500 0.8800 0.7177   0.511 0.0000 1.0000
20000.00 0.5000 1.0000 0.9900 0.8500 0.5942   0.693 0.0000 1.0000
 -9999.
"""


@pytest.fixture
def air(photic, tmp_path):
    """Hazy air as netCDF."""
    done = photic("optics", *HAZY, "-o", "air.nc")
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout.startswith("air.nc: the optics of 49 layers at 2 wavelengths\n")
    with netCDF4.Dataset(tmp_path / "air.nc") as file:
        file.set_auto_mask(False)
        yield file


@pytest.fixture
def tape7(tmp_path):
    (tmp_path / "tape7").write_text(TAPE7)


# Seen red: with the altitude of a layer's upper edge in the first column.
def test_air_is_the_same_in_every_form(photic, air, tmp_path):
    out = as_json(photic, *HAZY)
    assert out["wavelength_nm"] == list(air["wavelength_nm"][:]) == [355, 532]
    assert photic("optics", *HAZY, "-o", "air.csv").returncode == 0
    rows = rows_of(tmp_path / "air.csv")
    assert list(rows[0])[:3] == ["altitude_m", "wavelength_nm", "a_per_m"]
    assert [float(row["altitude_m"]) for row in rows[:4]] == [0, 0, 1000, 1000]
    assert "excitation_nm" not in out and "scene" not in air.ncattrs()
    for k, layer in enumerate(out["layers"]):
        assert [layer["altitude_m"], layer["top_altitude_m"]] == list(air["altitude_m_bounds"][k])
        for name in LAYERS_OF_AIR:
            assert layer[name] == list(air[name][k]) == [float(row[name]) for row in rows[2 * k : 2 * k + 2]]
        assert layer["phase_function_per_sr"] == air["phase_function_per_sr"][k].tolist()
        assert list(layer["parts"]) == ["molecules", "ozone", "aerosols"] and "emission" not in layer
        for part, values in layer["parts"].items():
            for quantity, numbers in values.items():
                assert numbers == list(air[f"{quantity[0]}_{part}_per_m"][k])
    text = photic("optics", *HAZY).stdout
    first = out["layers"][0]
    assert f"{first['a_per_m'][0]:.4g}" in text and f"{first['mean_cosine'][0]:.4f}" in text
    assert "a of ozone, 355-532 nm: Serdyuchenko" in text and "OPAC" in text


# Phase functions as far as their angles reach: of sea salt with its peak straight ahead and its glory.
# Seen red: with the molecules' phase function for all.
def test_the_airs_numbers_go_together(air):
    a, b, c, bb = (air[name][:] for name in ["a_per_m", "b_per_m", "c_per_m", "bb_per_m"])
    assert c == pytest.approx(a + b, rel=1e-15) and air["albedo"][:] == pytest.approx(b / c, rel=1e-15)
    assert air["a_ozone_per_m"][:] + air["a_aerosols_per_m"][:] == pytest.approx(a)
    assert air["b_molecules_per_m"][:] + air["b_aerosols_per_m"][:] == pytest.approx(b)
    angle = numpy.radians(air["angle_deg"][:])
    p = air["phase_function_per_sr"][:] * 2 * numpy.pi * numpy.sin(angle)
    assert numpy.trapz(p, angle) == pytest.approx(numpy.ones(b.shape), rel=1e-2)
    back = angle >= numpy.radians(89.9)
    assert numpy.trapz(p[:, :, back], angle[back]) == pytest.approx(bb / b, rel=2e-2)
    assert numpy.trapz(p * numpy.cos(angle), angle) == pytest.approx(air["mean_cosine"][:], abs=1e-2)


# Seen red: with `positive` down; without the units of the refractive index.
def test_air_and_spectra_follow_the_cf_conventions(photic, air, tape7, tmp_path):
    follows_the_cf_conventions(air)
    assert air["altitude_m"].positive == "up" and air["altitude_m"].standard_name == "altitude"
    assert "volume_absorption" not in str(air)
    assert "Bodhaine" in air["b_molecules_per_m"].source and "OPAC" in air.references
    for arguments in [["--oil", "light-refined"], ["--air", "tape7"]]:
        assert photic("optics", *arguments, "-o", "out.nc").returncode == 0
        with netCDF4.Dataset(tmp_path / "out.nc") as file:
            follows_the_cf_conventions(file)
            assert file.photic_content == "spectra"


def test_files_of_air_are_no_scenes(photic, air, tape7, tmp_path):
    assert photic("optics", "--air", "tape7", "-o", "out.nc").returncode == 0
    for name, what in [("air.nc", "the optics of layers"), ("out.nc", "spectra")]:
        done = photic("show", name)
        assert (done.returncode, done.stdout) == (2, "") and f"{name}: holds {what} of what is no scene" in done.stderr
        done = photic("run", "--continue", name)
        assert (done.returncode, done.stdout) == (2, "") and f"{name}: holds {what}, and no echoes" in done.stderr


# The depths that Bodhaine et al. 1999 print hold at 1013.25 hPa; the standard atmosphere has 0.02 % more.
# Seen red: with the thickness of layers in km.
def test_shows_air(photic, tmp_path):
    def depths(*arguments):
        done = photic("optics", "--air", *arguments, "--wavelengths", "355,532")
        assert (done.returncode, done.stderr) == (0, "")
        rows = [line.split() for line in done.stdout.splitlines() if re.match(r" +(355|532) ", line)]
        return [[float(cell) for cell in row] for row in rows]

    clear, hazy = depths("us-standard"), depths("us-standard", "--visibility", "5", "--aerosol", "maritime")
    assert [row[1] for row in clear] == pytest.approx([0.5938, 0.1112], abs=2e-4)
    assert clear[1][3] == 0 and hazy[1][3] > 0.3 and hazy[1][1] == clear[1][1]
    for row in clear + hazy:
        assert row[5] == pytest.approx(numpy.exp(-sum(row[1:5])), abs=2e-5)
    (tmp_path / "mine.csv").write_text("z_km,p_hpa,t_k\n0,1000,290\n10,250,220\n")
    assert depths("mine.csv")[1][1] < clear[1][1]
    for arguments, message in [(["mars"], "us-standard"), (["us-standard", "--aerosol", "martian"], "maritime"),
                               (["us-standard", "--visibility", "-1"], "visibility")]:
        done = photic("optics", "--air", *arguments, *(["--visibility", "23"] if "--aerosol" in arguments else []))
        assert (done.returncode, done.stdout) == (2, "") and message in done.stderr
    assert photic("optics", "--water", "--visibility", "5").returncode == 2


# Placeholders say so. Seen red: without the sources.
def test_shows_oils(photic, tmp_path):
    done = photic("optics", "--oil", "strongly-absorbing-crude", "--wavelengths", "337,355")
    assert (done.returncode, done.stderr) == (0, "")
    assert "placeholder" in done.stdout and "[1/nm]" in done.stdout
    (tmp_path / "mine.csv").write_text("# yield: 0.02\n# lifetime_ns: 4\nwavelength_nm,n,a_per_m,emission_per_nm\n"
                                       "300,1.48,3e5,0\n400,1.48,1e5,1\n500,1.48,2e4,0\n")
    mine = photic("optics", "--oil", "mine.csv", "--wavelengths", "350,450")
    assert (mine.returncode, mine.stderr) == (0, "")
    assert "0.02 photons are emitted per photon absorbed, after 4 ns" in mine.stdout
    unknown = photic("optics", "--oil", "gasolene")
    assert (unknown.returncode, unknown.stdout) == (2, "")
    assert "light-refined" in unknown.stderr


# What is written is an oil again. Seen red: without the yield in the head.
def test_oils_are_the_same_in_every_form(photic, tmp_path):
    oil = ["--oil", "strongly-absorbing-crude"]
    out = as_json(photic, *oil, "--wavelengths", "300:1000:5")
    for name in ["oil.nc", "oil.csv"]:
        done = photic("optics", *oil, "--wavelengths", "300:1000:5", "-o", name)
        assert (done.returncode, done.stderr) == (0, "")
    rows = rows_of(tmp_path / "oil.csv")
    with netCDF4.Dataset(tmp_path / "oil.nc") as file:
        for name in ["wavelength_nm", "n", "a_per_m", "emission_per_nm"]:
            assert out[name] == list(file[name][:]) == [float(row[name]) for row in rows]
        assert (file["yield"][:], file["lifetime_ns"][:]) == (out["yield"], out["lifetime_ns"]) == (0.0019, 2)
        assert "[placeholder]" in file.references
    again = as_json(photic, "--oil", "oil.csv", "--wavelengths", "450,530")
    there = as_json(photic, *oil, "--wavelengths", "450,530")
    assert again["yield"] == there["yield"] and again["lifetime_ns"] == there["lifetime_ns"]
    for name in ["n", "a_per_m", "emission_per_nm"]:
        assert again[name] == pytest.approx(there[name], rel=2e-3)


# Half way between two wavenumbers in depth; what is printed as 0 stays 0. Seen red: with transmittances
# interpolated themselves.
def test_shows_what_a_tape7_holds(photic, tape7, tmp_path):
    every = as_json(photic, "--air", "tape7")
    assert every["wavelength_nm"] == pytest.approx([500, 1e7 / 19000, 1e7 / 18000])
    assert every["o3_trans"] == pytest.approx([0.99, 0.95, 0.9]) and every["cloud_trans"] == [0, 0, 0]
    assert "log_combin" not in every and every["combin_trans"] == pytest.approx([0.5, 0.6, 0.7], abs=5e-4)
    one = as_json(photic, "--air", "tape7", "--wavelengths", str(1e7 / 18500))
    assert one["aer_cld_trans"] == pytest.approx([(0.8730 * 0.7177) ** 0.5])
    text = photic("optics", "--air", "tape7").stdout
    assert re.search(r"526\.32 .* 0\.95\n", text) and "1 throughout: CO2 TRANS" in text
    assert photic("optics", "--air", "tape7", "-o", "out.csv").returncode == 0
    assert [float(row["molec_scat"]) for row in rows_of(tmp_path / "out.csv")] == every["molec_scat"]


TAPE6 = """\
 1                   *****  MODTRAN4  *****

 ATMOSPHERIC PROFILES

   I     Z       P       T        N2       CNTMSLF MOL SCAT     N-1     O3 (UV)   O2 (UV)
        (KM)    (MB)    (K)            (MOL/CM2 KM)   (-)       (-)    (  ATM CM/KM  )

   1   0.0000 1013.000  288.0  8.000E-01 1.000E+20 9.470E-01 2.700E-04 3.000E-03 3.500E+04
   2  12.0000  200.000  217.0  9.000E-02 1.000E+16 2.480E-01 9.000E-05 8.000E-03 3.500E+03

 ATMOSPHERIC PROFILES

   I     Z       P       T      AEROSOL 1 AEROSOL 2 AEROSOL 3 AEROSOL 4  AER1*RH      RH
        (KM)    (MB)    (K)       (-)       (-)       (-)        (-)       (-)        (%)

   1   0.0000 1013.000  288.0  1.000E-01 0.000E+00 0.000E+00 0.000E+00 6.000E+00  60.00000
   2  12.0000  200.000  217.0  0.000E+00 2.000E-03 0.000E+00 0.000E+00 0.000E+00  20.00000
"""
SPECTRA = """
  FREQ   WAVLEN    PATH_THERMAL    SURFACE_EMISSION  TOTAL
 (CM-1) (MICRN)   (CM-1)  (MICRN)   (CM-1)  (MICRN)  TRANS

 18700.   0.535 1.00E-11 1.00E-08 1.00E-13 1.00E-09 0.60000
 18800.   0.532 1.00E-11 1.00E-08 1.00E-13 1.00E-09 0.60000
"""


# The standard atmosphere's molecules, 0.1112 as above, would fill 8.013 km at 0 C and 1013.25 hPa. Seen red: with a tape7
# known by FREQ alone.
def test_a_tape6_is_one_whether_spectra_follow_or_not(photic, tmp_path):
    (tmp_path / "profiles").write_text(TAPE6)
    (tmp_path / "all").write_text(TAPE6 + SPECTRA)
    (tmp_path / "spectra").write_text(TAPE6.splitlines()[0] + SPECTRA)
    reported = [photic("optics", "--air", name, "--wavelengths", "532").stdout for name in ["profiles", "all"]]
    assert reported[0].replace("profiles", "all") == reported[1]
    molecules, ozone, scattered, absorbed = [float(cell) for cell in re.search(r"\n +532 (.*)", reported[1])[1].split()[:4]]
    km = 12 * (0.947 - 0.248) / numpy.log(0.947 / 0.248)
    assert molecules == pytest.approx(0.1112 * km / 8.013, rel=1e-3)
    assert ozone > 0 and scattered > 0.3 and absorbed > 0.01
    done = photic("optics", "--air", "spectra")
    assert (done.returncode, done.stdout) == (2, "") and 'no block "ATMOSPHERIC PROFILES"' in done.stderr


# Seen red: without the remarks; with those of scenes alone.
def test_remarks_on_profiles(photic, tmp_path):
    (tmp_path / "dry.csv").write_text("z_km,p_hpa,t_k,relative_humidity_percent\n0,1000,290,0.7\n2,790,278,\n10,265,223,0.3\n")
    done = photic("optics", "--air", "dry.csv", "--wavelengths", "532")
    assert done.returncode == 0
    assert done.stderr == (
        "dry.csv: relative_humidity_percent is missing at 1 of 3 levels, the first at 2 km: there it follows from the "
        "levels beside it\ndry.csv: the relative humidity is 0.7 % at most: is it a fraction?\n")
    rows = TAPE6.splitlines(keepends=True)
    low, high, low_aerosols, high_aerosols = [row for row in rows if row[:4] in ("   1", "   2")]
    from_the_top = [{low: high, high: low, low_aerosols: high_aerosols.replace("20.00000", "        "),
                     high_aerosols: low_aerosols}.get(row, row) for row in rows]
    for name, text in {"tape6": TAPE6, "turned": "".join(from_the_top) + "\n"}.items():
        (tmp_path / name).write_text(text)
    up, down = [photic("optics", "--air", name, "--wavelengths", "532") for name in ["tape6", "turned"]]
    assert down.stderr == "turned: RH is missing at 1 of 2 levels, the first at 12 km: there it follows from the levels beside it\n"
    assert (up.returncode, up.stderr) == (0, "") and len(up.stdout.splitlines()) == len(down.stdout.splitlines())


REFUSED = {
    "no atmosphere": (["mars"], 2, "there are: us-standard"),
    "no file": (["./none"], 2, "./none: cannot be read"),
    "no table": (["none.csv"], 2, "none.csv: cannot be read"),
    "a folder": (["folder"], 2, "folder: no regular file"),
    "an empty file": (["empty"], 2, "empty: neither a tape6 of MODTRAN"),
    "an empty table": (["empty.csv"], 2, "empty.csv:1:1: no table of numbers: no rows of data"),
    "half a tape7": (["half"], 2, "half:6:1: the file ends without -9999: is it truncated?"),
    "outside a tape7": (["tape7", "--wavelengths", "499"], 2, "tape7: no transmittances at 499 nm: the file covers 500-555.556 nm"),
    "a tape7 with haze": (["tape7", "--visibility", "5"], 2, "tape7: a tape7 holds transmittances, and no profile"),
    "outside": (["us-standard", "--wavelengths", "532,1200"], 2, "no air scattering data at 1200 nm"),
    "outside OPAC": (["us-standard", "--visibility", "5", "--aerosol", "opac-sscm-80", "--wavelengths", "240"], 2, "cover 250-2000 nm"),
    "altitudes in metres": (["metres.csv"], 2, "metres.csv:3:1: the pressure falls from 1000 to 250 hPa between 0 and 10000 km"),
    "a folder that is not there": (["us-standard", "-o", "nowhere/air.nc"], 1, "nowhere does not exist"),
    "an output of no kind": (["us-standard", "-o", "air.txt"], 2, "neither in .nc nor in .csv"),
    "itself": (["mine.csv", "-o", "mine.csv"], 2, "mine.csv: the result would replace a file that it is made of"),
}


@pytest.mark.parametrize("what", REFUSED)
def test_refuses_air(photic, tape7, tmp_path, what):
    arguments, code, message = REFUSED[what]
    (tmp_path / "folder").mkdir()
    for name, text in {"empty": "", "empty.csv": "", "half": TAPE7[: TAPE7.index("20000")], "mine.csv": "z_km,p_hpa,t_k\n0,1000,290\n10,250,220\n",
                       "metres.csv": "z_km,p_hpa,t_k\n0,1000,290\n10000,250,220\n"}.items():
        (tmp_path / name).write_text(text)
    before = sorted(os.listdir(tmp_path))
    done = photic("optics", "--air", *arguments, *([] if "-o" in arguments else ["-o", "air.nc"]))
    assert (done.returncode, done.stdout) == (code, "")
    assert message in done.stderr and "bug" not in done.stderr
    assert sorted(os.listdir(tmp_path)) == before


# Seen red: with the layers of the profile for those of the scene.
def test_shows_the_air_of_a_scene(photic, scene, tmp_path):
    alone = photic("optics", "--air", "quick.toml")
    assert (alone.returncode, alone.stdout) == (2, "") and "no air above the sea" in alone.stderr
    scene.write_text(scene.read_text() + '[atmosphere]\nprofile = "us-standard"\naerosol = "maritime"\nvisibility_km = 5.0\n'
                     "[[atmosphere.gases]]\ntop_km = 2.5\nfile = { wavelength_nm = [500, 800], optical_depth = [0.0, 0.3] }\n")
    done = photic("optics", "quick.toml", "--wavelengths", "532")
    assert (done.returncode, done.stderr) == (0, "")
    water, air = done.stdout.split("\nThe air above it (by itself: photic optics --air quick.toml)\n\n")
    assert "b_b/b" in water and "gases" in air and "maritime" in air
    shown = photic("show", "quick.toml").stdout
    layers = int(re.search(r"(\d+) layers of the profile us-standard", shown).group(1))
    asked = ["--air", "quick.toml", "--wavelengths", "532,650"]
    out = as_json(photic, *asked)
    assert len(out["layers"]) == layers > 49
    assert photic("optics", *asked, "-o", "of-scene.nc").returncode == 0
    with netCDF4.Dataset(tmp_path / "of-scene.nc") as file:
        edges, gases = file["altitude_m_bounds"][:], file["a_gases_per_m"][:]
        assert "visibility_km = 5.0" in file.scene
    depth = ((edges[:, 1] - edges[:, 0])[:, None] * gases).sum(axis=0)
    assert depth.tolist() == pytest.approx([0.3 * 32 / 300, 0.15], rel=1e-9)
    hazy = as_json(photic, *asked, "--set", "atmosphere.visibility_km=2")
    assert hazy["layers"][0]["b_per_m"][0] > 2 * out["layers"][0]["b_per_m"][0]
    refused = photic("optics", *asked, "--visibility", "23")
    assert (refused.returncode, refused.stdout) == (2, "") and "--set atmosphere.visibility_km" in refused.stderr
