"""Opening and drawing what `photic optics` writes."""

import os
import subprocess
from pathlib import Path

import matplotlib.image
import netCDF4
import numpy
import pytest

import photic
from photic import optics_plot

SCENES = Path(__file__).resolve().parents[2] / "scenes"


def made(path, *arguments):
    line = [os.environ["PHOTIC_PROGRAM"], "optics", *map(str, arguments), "-o", path]
    subprocess.run(line, check=True, capture_output=True)
    return path


@pytest.fixture(scope="module")
def library(tmp_path_factory):
    path = tmp_path_factory.mktemp("optics") / "lib.nc"
    return made(path, SCENES / "three-layers.toml", "--wavelengths", "400:700:10")


@pytest.fixture(scope="module")
def drawn(library):
    return optics_plot.figure(photic.open(library))


def curves(panel):
    """What is drawn under each name."""
    return {line.get_label(): line for line in panel.get_lines() if line.get_label()[0] != "_"}


def legends(drawing):
    """What is written in the legends of a figure, from above, and from the left in each row."""
    found = [part.legends for part in drawing.subfigs]
    return [[text.get_text() for text in each.get_texts()] for part in found for each in part]


# Seen red: without the index of wavelengths.
def test_optics_open_by_depth_and_wavelength(library):
    ds = photic.open(library)
    assert list(ds.layer_name.values) == ["surface", "maximum", "deep"]
    one = ds.sel(depth=8, wavelength=550)
    with netCDF4.Dataset(library) as file:
        assert one.a_per_m == file["a_per_m"][1, 15]
        assert one.phase_function_per_sr.sel(angle=180) == file["phase_function_per_sr"][1, 15, -1]
        assert ds.emission_per_m.sel(process="chlorophyll", depth=15) == file["emission_per_m"][2, 1]
    assert ds.wavelength.attrs["units"] == "nm" and ds.depth.attrs["positive"] == "down"
    assert numpy.isinf(ds.depth_m_bounds.values[2, 1])


def test_a_picture(command, tmp_path):
    path = made(tmp_path / "one.nc", "--water", "chlorophyll_mg_m3=0.5", "--wavelengths", "400:700:10")
    assert command("plot", path, "-o", tmp_path / "out.png") == (0, "")
    picture = matplotlib.image.imread(tmp_path / "out.png")
    assert picture.shape[0] > 500 and picture.shape[1] > 2500
    shades = (255 * picture).astype(numpy.uint32) @ (1 << 8 * numpy.arange(picture.shape[2], dtype=numpy.uint32))
    assert len(numpy.unique(shades)) > 300


# Seen red: with the first layer in all rows; with the scattering in the panel of the absorption.
def test_a_row_for_each_layer(library, drawn):
    ds, drawing = photic.open(library), drawn
    titles = [panel.get_title(loc="left") for panel in drawing.axes]
    assert titles[:4] == [f"surface, 0\u20138 m: {what}" for what in
                          ("absorption", "scattering", "phase function", "light emitted")]
    assert titles[8] == "deep, from 15 m down: absorption"
    rows = numpy.array(drawing.axes).reshape(3, 4)
    for k, (absorption, scattering, phases, emission) in enumerate(rows):
        one = ds.isel(depth=k)
        below = legends(drawing)[4 * k : 4 * k + 4]
        assert below[0] == ["all", "water", "phytoplankton", "CDOM"]
        assert below[1] == ["all", "all, backwards", "water", "phytoplankton"]
        drawn = curves(absorption)
        assert numpy.array_equal(drawn["all"].get_ydata(), one.a_per_m)
        assert numpy.array_equal(drawn["CDOM"].get_ydata(), one.a_cdom_per_m)
        assert numpy.array_equal(drawn["CDOM"].get_xdata(), one.wavelength)
        drawn = curves(scattering)
        assert numpy.array_equal(drawn["all, backwards"].get_ydata(), one.bb_per_m)
        assert below[2] == ["400 nm", "480 nm", "550 nm", "620 nm", "700 nm"]
        green = one.phase_function_per_sr.sel(wavelength=550)
        assert numpy.array_equal(curves(phases)["550 nm"].get_ydata()[1:], green)
        raman, chlorophyll = list(curves(emission).values())[:2]
        assert sum(raman.get_ydata()) == pytest.approx(float(one.emission_per_m.sel(process="raman")))
        assert 640 < min(chlorophyll.get_xdata()) < 685 < max(chlorophyll.get_xdata()) < 730
        assert absorption.get_ylim()[0] < one.a_water_per_m.min()
        for panel in (absorption, scattering, phases, emission):
            assert panel.get_yscale() == "log" and panel.get_ylabel().endswith("/m]" if panel is not phases else "/sr]")
    assert [panel.get_xlabel() for panel in rows[-1]] == [
        "wavelength [nm]", "wavelength [nm]", "scattering angle [degree]", "wavelength [nm]"]


# 0 has no place on a logarithmic axis. Seen red: with a line for all constituents of the file.
def test_what_is_not_there_is_not_drawn(tmp_path):
    path = made(tmp_path / "pure.nc", "--water", "--wavelengths", "500,600", "--laser", "900")
    drawing = optics_plot.figure(photic.open(path))
    absorption, _, _, emission = drawing.axes
    assert legends(drawing)[:2] == [["all", "water"], ["all", "all, backwards", "water"]]
    assert curves(absorption)["water"].get_marker() == "o"  # of two wavelengths
    assert len(emission.get_lines()) == 2  # the laser, and Raman light at 1294 nm
    path = made(tmp_path / "clear.nc", SCENES / "three-layers.toml", "--set", "sea.layer.0.chlorophyll_mg_m3=0")
    drawing = optics_plot.figure(photic.open(path))
    assert legends(drawing)[:2] == [["all", "water", "CDOM"], ["all", "all, backwards", "water"]]
    path = made(tmp_path / "given.nc", SCENES / "benchmark-hg.toml")
    assert legends(optics_plot.figure(photic.open(path)))[0] == ["all"]
    clear = photic.open(path)
    clear = clear.assign(b_per_m=0 * clear.b_per_m, bb_per_m=0 * clear.bb_per_m)
    drawing = optics_plot.figure(clear.drop_dims("emission_line"))
    assert [text.get_text() for text in drawing.axes[1].texts] == ["no scattering"]
    assert len(legends(drawing)) == 2  # of the absorption and the phase functions


# The file has the mean over the core at 0. Seen red: with a line from there to the next angle.
def test_phase_functions_are_flat_in_their_core(library, drawn):
    ds = photic.open(library)
    line = curves(drawn.axes[2])["550 nm"]
    angles, values = line.get_xdata(), line.get_ydata()
    inside = ds.phase_function_per_sr.sel(wavelength=550).isel(depth=0)
    core = float(ds.angle[1])
    assert core == pytest.approx(0.01) and float(inside[0]) > 2 * float(inside[1])
    assert list(angles[:3]) == [0, core, core] and list(values[:3]) == [inside[0], inside[0], inside[1]]
    assert numpy.interp(0.999 * core, angles, values) == inside[0]
    assert numpy.array_equal(angles[2:], ds.angle[1:]) and numpy.array_equal(values[2:], inside[1:])


# Seen red: with the mark of placeholders misspelt.
def test_the_caption_says_what_is_not_verified(drawn, tmp_path):
    said = drawn._supxlabel.get_text()
    assert "Optical data from memory: raman light, chlorophyll light." in said
    oil = photic.open(made(tmp_path / "oil.nc", "--oil", "light-refined", "--wavelengths", "300:600:10"))
    said = optics_plot.spectra(oil)._supxlabel.get_text()
    assert "from memory: refractive_index, quantum_yield, lifetime. Placeholders for optical data: absorption_337_nm" in said


@pytest.mark.parametrize("what, width_mm", [("library", 84), ("air", 174)])
def test_optics_of_a_width_stay_on_a_page(request, what, width_mm):
    drawing = optics_plot.figure(photic.open(request.getfixturevalue(what)), width_mm=width_mm)
    assert drawing.get_size_inches()[0] == pytest.approx(width_mm / 25.4)
    assert drawing.get_size_inches()[1] < 260 / 25.4
    assert "of its" in drawing._supxlabel.get_text()


# From the first to the last, and the caption says so.
def test_of_many_layers_some_are_drawn(library):
    ds = photic.open(library).isel(depth=[0, 0, 1, 1, 1, 0, 1, 0, 2])
    ds = ds.assign_coords(layer_name=("depth", [f"l{k}" for k in range(9)]))
    drawing = optics_plot.figure(ds, title="Many $ layers")
    names = [panel.get_title(loc="left").split(",")[0] for panel in drawing.axes[::4]]
    assert names == ["l0", "l2", "l3", "l5", "l6", "l8"]
    assert "6 of its 9 layers" in drawing._supxlabel.get_text()
    assert drawing._suptitle.get_text() == "Many \\$ layers"


def test_optics_are_drawn_alone(command, library, sample, tmp_path):
    picture = tmp_path / "out.png"
    code, message = command("plot", library, sample, "-o", picture)
    assert code == 2 and message.startswith("optics are drawn alone")
    code, message = command("plot", library, "-o", picture, "--telescope", "narrow")
    assert code == 2 and "holds optics, and no telescopes" in message
    code, message = command("plot", library, "-o", picture, "--channel", "raman")
    assert code == 2 and "holds optics, and no channels" in message
    assert not picture.exists()


def test_a_result_is_not_taken_for_optics(command, sample, tmp_path):
    assert "echo" in photic.open(sample)
    small = ["--telescope", "wide", "--channel", "raman"]
    assert command("plot", sample, "-o", tmp_path / "out.png", *small) == (0, "")


@pytest.fixture(scope="module")
def air(tmp_path_factory):
    path = tmp_path_factory.mktemp("optics") / "air.nc"
    return made(path, "--air", "us-standard", "--visibility", "23", "--wavelengths", "300:1000:50")


# Seen red: with the highest layer below; with one range of coefficients for all layers.
def test_air_has_a_row_for_each_layer_the_lowest_below(command, air):
    ds = photic.open(air)
    assert ds.sel(altitude=0, wavelength=550).c_per_m > ds.sel(altitude=5000, wavelength=550).c_per_m
    assert ds.altitude.attrs["positive"] == "up" and "altitude_m_bounds" in ds.coords
    drawing = optics_plot.figure(ds)
    rows = numpy.array(drawing.axes).reshape(6, 3)
    assert rows[0, 0].get_title(loc="left") == "115 to 120 km: absorption"
    assert rows[5, 2].get_title(loc="left") == "0 to 1 km: phase function"
    lowest = [["all", "ozone", "aerosols"], ["all", "all, backwards", "molecules", "aerosols"]]
    assert legends(drawing)[-3:-1] == lowest
    for row, layer in [(rows[5], 0), (rows[0], 48)]:
        low, high = row[1].get_ylim()
        b = ds.b_per_m.isel(altitude=layer)
        assert low < b.min() and b.max() < high
        assert numpy.array_equal(curves(row[1])["all"].get_ydata(), b)
    assert "6 of its 49 layers" in drawing._supxlabel.get_text()
    assert command("plot", air, "-o", air.with_suffix(".svg"), "--width-mm", "84") == (0, "")


# Seen red: with all spectra in one panel.
def test_spectra_have_a_panel_for_each_unit(command, tmp_path):
    ds = photic.open(made(tmp_path / "oil.nc", "--oil", "light-refined", "--wavelengths", "300:600:10"))
    drawing = optics_plot.spectra(ds)
    assert [panel.get_ylabel() for panel in drawing.axes] == ["[1]", "[1/m]", "[1/nm]"]
    (line,) = curves(drawing.axes[2]).values()
    assert numpy.array_equal(line.get_ydata(), ds.emission_per_nm)
    assert "photons emitted per photon absorbed: 0.059;" in drawing._supxlabel.get_text()
    assert command("plot", tmp_path / "oil.nc", "-o", tmp_path / "oil.png") == (0, "")
    code, said = command("plot", tmp_path / "oil.nc", tmp_path / "oil.nc", "-o", tmp_path / "two.png")
    assert code == 2 and "drawn alone" in said
