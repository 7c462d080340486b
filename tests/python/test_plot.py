import subprocess
import sys
from functools import cache

import matplotlib.image
import numpy
import pytest
from matplotlib.collections import PolyCollection
from matplotlib.figure import Figure

import photic
from drawings import FADED, legends, titles, visible
from photic import panels, plot


SMALL = ["--telescope", "narrow", "--channel", "raman"]


@pytest.fixture(scope="module")
def drawn(sample, sample_in_other_water):
    """Figures that several tests look at, each drawn once."""
    paths = {"sample": sample, "in other water": sample_in_other_water}
    return cache(
        lambda name, telescope: plot.figure([photic.open(paths[name])], ["sample"], [telescope])
    )


def test_one_result(sample, tmp_path):
    line = [sys.executable, "-m", "photic", "plot", sample, "-o", tmp_path / "out.png"]
    process = subprocess.run(line, capture_output=True, text=True)
    assert (process.returncode, process.stderr) == (0, "")
    picture = matplotlib.image.imread(tmp_path / "out.png")
    assert picture.shape[0] > 800 and picture.shape[1] > 1500
    colours = (255 * picture).astype(numpy.uint32) @ (1 << 8 * numpy.arange(picture.shape[2], dtype=numpy.uint32))
    assert len(numpy.unique(colours)) > 1000


def test_several_results(command, sample, tmp_path):
    copy = tmp_path / "again.nc"
    copy.write_bytes(sample.read_bytes())
    picture = tmp_path / "out.png"
    assert command("plot", sample, copy, "-o", picture, "--title", "A $ in _it_", *SMALL) == (0, "")
    assert picture.stat().st_size > 30_000


@pytest.mark.parametrize("ending", ["pdf", "svg"])
def test_other_formats(command, sample, tmp_path, ending):
    assert command("plot", sample, "-o", tmp_path / f"out.{ending}", *SMALL) == (0, "")
    assert (tmp_path / f"out.{ending}").stat().st_size > 10_000


def test_panels_of_one_result(drawn):
    drawing = drawn("sample", "narrow")
    assert titles(drawing) == [
        "Echo by channel (one process each)",
        "elastic echo by order of scattering",
        "raman echo by order of scattering",
    ]
    assert drawing.axes[0].get_xscale() == "log"
    top, bottom = reversed(drawing.axes[0].get_ylim())
    assert top == 0 and bottom == pytest.approx(49, abs=0.5)  # down, to the last gate with light
    channels = ["elastic (532 nm)", "raman (649.8 nm)", "chlorophyll (685 nm)"]
    assert legends(drawing)[0] == channels + [FADED]
    assert "20\u2009000\u2009000 photons, seed 1" in drawing._supxlabel.get_text()


# Seen red: `converged` negated.
def test_only_converged_gates_are_drawn_thick(sample, drawn):
    ds = photic.open(sample)
    drawing = drawn("sample", "wide")
    elastic = ds.sel(telescope="wide", channel="elastic")
    thick, thin, circles = drawing.axes[0].get_lines()[:3]
    assert visible(thick) == int(elastic.converged.sum())
    assert visible(thin) == int((elastic.echo > 0).sum())
    drawn = numpy.isin(elastic.echo.values, circles.get_xdata())
    assert drawn.any() and not (drawn & elastic.converged.values).any()


CHANNELS = ["elastic", "raman", "chlorophyll"]


def test_environments_have_a_row_for_each_channel(drawn):
    drawing = drawn("in other water", "narrow")
    without = titles(drawn("sample", "narrow"))
    rows = [[f"{name} echo in the environments", f"{name} echo: change from the scene's"] for name in CHANNELS]
    assert titles(drawing) == without + sum(rows, [])
    names = ["the scene", "more algae", "no \\$ _CDOM_", "bloom", FADED]
    assert legends(drawing)[2:] == [names]
    assert drawing.axes[3].get_ylim() == drawing.axes[4].get_ylim()


def at_the_sea(panel):
    return [line for line in panel.get_lines() if list(line.get_ydata()) == [0, 0]]


def curves(panel, count):
    """The thick line, the thin one and the circles of each."""
    lines = [line for line in panel.get_lines() if line not in at_the_sea(panel)][-3 * count :]
    return [lines[3 * k : 3 * k + 3] for k in range(count)]


# Seen red: with the gates that converged in the scene drawn thick; with the scene's echo for all.
def test_echoes_in_the_environments(drawn, sample_in_other_water):
    ds = photic.open(sample_in_other_water)
    drawing = drawn("in other water", "wide")
    chlorophyll = ds.sel(telescope="wide", channel="chlorophyll")
    scene, *others = curves(drawing.axes[7], 4)
    assert visible(scene[0]) == int(chlorophyll.converged.sum())
    for (thick, thin, _), name in zip(others, ds.environment.values):
        one = chlorophyll.sel(environment=name)
        assert visible(thick) == int(one.environment_converged.sum()) < int(one.converged.sum())
        lit = one.environment_echo.values > 0
        assert numpy.array_equal(thin.get_xdata()[lit], one.environment_echo.values[lit])


def bands(panel):
    """Those of gates that have converged, one for each line."""
    return [each for each in panel.collections if each.get_alpha() == panels.BAND]


def with_changes(path, per_cent):
    ds = photic.open(path)
    for name, change in zip(ds.environment.values, per_cent):
        one = {"environment": name}
        ds.environment_difference.loc[one] = change / 100 * ds.echo
        ds.environment_difference_standard_error.loc[one] = 0.01 * ds.echo
        ds.environment_echo.loc[one] = (1 + change / 100) * ds.echo
    return ds


# Seen red: with the standard error of the environment's echo; with the scene's echo in the place of
# the difference.
def test_changes_in_per_cent_with_the_bands_of_differences(sample_in_other_water):
    ds = with_changes(sample_in_other_water, [2, -5, 10])
    panel = plot.figure([ds], ["sample"], ["narrow"], ["elastic"]).axes[3]
    assert panel.get_xscale() == "linear" and "[%]" in panel.get_xlabel()
    for (thick, thin, _), change in zip(curves(panel, 3), [2, -5, 10]):
        assert thin.get_xdata()[:40] == pytest.approx(change)
        assert 0 < visible(thick) < visible(thin)
    for band, change in zip(bands(panel), [2, -5, 10]):
        ends = band.get_paths()[0].vertices[:, 0]
        assert (ends.min(), ends.max()) == pytest.approx((change - 1.96, change + 1.96))
    low, high = panel.get_xlim()
    assert -9 < low < -6.96 and 11.96 < high < 14


def test_large_changes_as_factors(sample_in_other_water):
    ds = with_changes(sample_in_other_water, [300, -90, 0])
    panel = plot.figure([ds], ["sample"], ["narrow"], ["elastic"]).axes[3]
    assert panel.get_xscale() == "log" and "%" not in panel.get_xlabel()
    factors = [thin.get_xdata()[0] for _, thin, _ in curves(panel, 3)]
    assert factors == pytest.approx([4, 0.1, 1])


def test_more_environments_than_colours_are_shades():
    assert panels.family(6) == panels.COLOURS[:6] and panels.COLOURS[6] == "#000000"
    shades = panels.family(12)
    assert len({tuple(shade) for shade in shades}) == 12


FEW = {"telescopes": ["wide"], "channels": ["elastic"]}


@pytest.mark.filterwarnings("error:::numpy", "error::RuntimeWarning")
def test_environments_without_light(sample_in_other_water):
    ds = photic.open(sample_in_other_water)
    ds["environment_echo"] = 0 * ds.environment_echo
    ds["environment_difference"] = -ds.echo + 0 * ds.environment_difference
    ds["environment_converged"] = ds.environment_converged & False
    plot.figure([ds], ["dark"], **FEW).draw_without_rendering()
    ds["echo"] = 0 * ds.echo
    plot.figure([ds], ["darker"], **FEW).draw_without_rendering()


# Seen red: with 1.96 standard errors; with the scene's convergence; with the first parameter for all.
def test_sensitivities_have_a_panel_for_each_channel(sample_with_parameters):
    ds = photic.open(sample_with_parameters)
    drawing = plot.figure([ds], ["sample"], telescopes=["wide"])
    last = drawing.axes[-3:]
    assert titles(drawing)[-3:] == [f"{name} echo: sensitivities" for name in CHANNELS]
    assert "elastic echo in the environments" in titles(drawing)
    assert legends(drawing)[-1] == ["sea.layer.0.chlorophyll_mg_m3", "sea.\\$_x_", FADED]
    assert last[0].get_ylim() == last[2].get_ylim()
    raman = ds.sel(telescope="wide", channel="raman")
    for (thick, thin, _), band, name in zip(curves(last[1], 2), bands(last[1]), ds.parameter.values):
        one = raman.sel(parameter=name)
        assert visible(thick) == int(one.sensitivity_converged.sum()) < int(one.converged.sum())
        lit = one.echo.values > 0
        assert numpy.array_equal(thin.get_xdata()[lit], one.logarithmic_sensitivity.values[lit])
        vertices = numpy.concatenate([path.vertices for path in band.get_paths()])
        first = one.isel(gate=0)
        at_first = vertices[vertices[:, 1] == float(first.gate_depth), 0]
        width = 2 * 1.96 * float(first.logarithmic_sensitivity_standard_error)
        assert at_first.max() - at_first.min() == pytest.approx(width, rel=1e-9)
    assert "Bands: 95 % intervals" in drawing._supxlabel.get_text()


def test_several_results_say_what_they_leave_out(sample, sample_with_parameters, sample_in_other_water):
    results = [photic.open(path) for path in (sample, sample_with_parameters, sample_in_other_water)]
    lines = plot.figure(results, ["a", "b", "c"], **FEW)._supxlabel.get_text().splitlines()
    assert "not drawn" not in lines[0]
    assert lines[1].endswith("; its environments and sensitivities are drawn only where it is drawn alone")
    assert lines[2].endswith("; its environments are drawn only where it is drawn alone")


# A run of one batch. Seen red: with curves whose error is not known left out of the axes.
@pytest.mark.filterwarnings("error:::numpy", "error::RuntimeWarning")
def test_errors_that_are_not_known(sample_with_parameters):
    ds = photic.open(sample_with_parameters)
    for name in [each for each in ds.variables if each.endswith("_standard_error")]:
        ds[name] = numpy.nan * ds[name]
    for name in ("converged", "environment_converged", "sensitivity_converged"):
        ds[name] = ds[name] & False
    drawing = plot.figure([ds], ["one batch"], **FEW)
    drawing.draw_without_rendering()
    assert panels.NO_LIGHT not in [text.get_text() for panel in drawing.axes for text in panel.texts]
    last = drawing.axes[-1]
    for _, thin, _ in curves(last, 2):
        drawn = thin.get_xdata()[~numpy.isnan(thin.get_xdata())]
        low, high = last.get_xlim()
        assert len(drawn) > 0 and low < drawn.min() and drawn.max() < high


@pytest.mark.filterwarnings("error:::numpy", "error::RuntimeWarning")
def test_sensitivities_without_light(sample_with_parameters):
    ds = photic.open(sample_with_parameters)
    for name in ("echo", "environment_echo", "environment_difference", "sensitivity"):
        ds[name] = 0 * ds[name]
    for name in ("logarithmic_sensitivity", "logarithmic_sensitivity_standard_error"):
        ds[name] = numpy.nan * ds[name]
    for name in ("converged", "environment_converged", "sensitivity_converged"):
        ds[name] = ds[name] & False
    plot.figure([ds], ["dark"], **FEW).draw_without_rendering()


def test_every_stretch_of_open_gates_is_marked():
    chosen = numpy.array([True, False, True, True, True, True, False, True])
    assert panels.thinned(chosen, 3) == [0, 2, 5, 7]
    assert panels.thinned(~chosen, 3) == [1, 6]


# Seen red: standard errors drawn without the factor 1.96.
def test_bands_are_95_percent_intervals(sample, drawn):
    ds = photic.open(sample)
    drawing = drawn("sample", "narrow")
    band = next(c for c in drawing.axes[0].collections if isinstance(c, PolyCollection))
    vertices = numpy.concatenate([path.vertices for path in band.get_paths()])
    first = ds.sel(telescope="narrow", channel="elastic").isel(gate=0)
    at_first = vertices[vertices[:, 1] == float(first.gate_depth), 0]
    half_width = 1.96 * float(first.echo_standard_error)
    assert at_first.min() == pytest.approx(float(first.echo) - half_width, rel=1e-9)
    assert at_first.max() == pytest.approx(float(first.echo) + half_width, rel=1e-9)


# Seen red: the orders not summed up from the left.
def test_orders_are_shares_side_by_side(sample, drawn):
    ds = photic.open(sample)
    drawing = drawn("sample", "narrow")
    one = ds.sel(telescope="narrow", channel="elastic").isel(gate=10)
    at_gate = float(one.gate_depth_bounds.mean())
    expected = 100 * numpy.cumsum(one.echo_by_order) / one.echo_by_order.sum()
    areas = [area for area in drawing.axes[1].collections if isinstance(area, PolyCollection)][:7]
    right_ends = []
    for area in areas:
        (path,) = area.get_paths()
        bounds = path.vertices[numpy.abs(path.vertices[:, 1] - at_gate) < 0.2501]
        inner = bounds[numpy.isclose(bounds[:, 1], float(one.gate_depth_bounds[1]))]
        right_ends.append(inner[:, 0].max())
    assert right_ends == pytest.approx(expected.values, rel=0.02)


def test_a_channel_of_several_processes_is_broken_down(sample):
    ds = photic.open(sample)
    ds.echo_by_process.loc[{"channel": "elastic", "process": "raman"}] = 1e-13
    drawing = plot.figure([ds], ["sample"], telescopes=["narrow"])
    assert titles(drawing) == [
        "Echo by channel",
        "elastic echo by process",
        "elastic echo by order of scattering",
    ]
    assert legends(drawing)[1] == ["elastic", "raman", FADED]


def test_processes_are_faded_by_flags_of_their_own(sample):
    # Seen red: with the flags of the gates for every process; with results of earlier programs, which have no others, refused.
    ds = photic.open(sample)
    raman = {"channel": "elastic", "process": "raman"}
    ds.echo_by_process.loc[raman] = 1e-13
    ds["converged"] = ds.converged | True
    ds["echo_by_process_converged"] = ds.echo_by_process_converged | True
    ds.echo_by_process_converged.loc[raman | {"gate": [3, 4]}] = False
    earlier = ds.drop_vars("echo_by_process_converged")
    for result, faded in ((ds, [FADED]), (earlier, [])):
        drawing = plot.figure([result], ["sample"], telescopes=["narrow"])
        assert legends(drawing)[1] == ["elastic", "raman", *faded]
        one = result.sel(telescope="narrow", channel="elastic")
        (elastic, *_), (thick, *_) = curves(drawing.axes[1], 2)
        assert visible(elastic) == int((one.echo_by_process.sel(process="elastic") > 0).sum())
        assert visible(thick) == one.sizes["gate"] - 2 * len(faded)


def test_light_of_the_air_has_a_colour_of_its_own():
    # Seen red: with the colours in their order, where the first line of this list is green.
    for names in (["air"], ["elastic", "air"], ["elastic", "surface", "bottom", "air"], list("abcdefgh") + ["air"]):
        lines = panels.of_processes(names)
        assert [name for name, _ in lines] == names
        *others, (_, colour) = lines
        assert colour == panels.OF_AIR and all(other is not colour for _, other in others)
    assert panels.of_processes(["elastic", "raman"]) == list(zip(["elastic", "raman"], panels.COLOURS))


def test_the_sea_is_a_line_between_depths_and_heights(sample, drawn):
    # Seen red: without the line; with one for all gates by depth.
    for name, lines, label in (("narrow", 0, "depth [m]"), ("wide", 1, "depth [m]; above the line: air")):
        panel = drawn("sample", name).axes[0]
        assert (len(at_the_sea(panel)), panel.get_ylabel()) == (lines, label)
    ds = photic.open(sample)
    several = plot.figure([ds, ds], ["one", "two"], telescopes=["wide"])
    assert all(len(at_the_sea(panel)) == 1 for panel in several.axes)


def test_heights_alone_have_no_line(sample):
    # Seen red: with the line for all gates by depth.
    ds = photic.open(sample)
    for name in ("gate_depth", "gate_depth_bounds"):
        ds[name] = ds[name].copy(data=ds[name].values - 1000)
    panel = plot.figure([ds], ["high"], telescopes=["narrow"]).axes[0]
    assert (at_the_sea(panel), panel.get_ylabel()) == ([], "depth [m]; negative: in the air")
    ds.gate_depth.attrs = {"units": "m"}
    assert plot.figure([ds], ["high"], telescopes=["narrow"]).axes[0].get_ylabel() == "range [m]"


@pytest.mark.filterwarnings("error:::numpy", "error::RuntimeWarning")
def test_no_light_at_all(sample):
    ds = photic.open(sample)
    for name in ("echo", "echo_by_process", "echo_by_order"):
        ds[name] = 0 * ds[name]
    plot.figure([ds], ["dark"], **FEW).draw_without_rendering()
    plot.figure([ds, ds], ["dark", "darker"], **FEW).draw_without_rendering()


def test_same_file_names_are_distinguished(sample, tmp_path):
    from photic.__main__ import _names

    assert _names(["a/out.nc", "b/ship.nc"]) == ["out", "ship"]
    assert _names(["a/out.nc", "b/out.nc"]) == ["a/out.nc", "b/out.nc"]


def test_gates_without_depths_are_placed_by_time(sample):
    # A telescope that looks up. Seen red: with no gates drawn.
    ds = photic.open(sample)
    for name in ("gate_depth", "gate_depth_bounds"):
        ds[name] = ds[name].where(ds.telescope != "wide")
    drawing = plot.figure([ds], ["sample"], telescopes=["wide"])
    assert drawing.axes[0].get_ylabel() == "time [ns]"
    low, high = sorted(drawing.axes[0].get_ylim())
    assert low == pytest.approx(float(ds.gate_time_bounds.min())) and high > low
    assert visible(drawing.axes[0].get_lines()[0]) > 0
    assert plot.figure([ds], ["sample"], channels=["raman"]).axes[0].get_ylabel() == "depth [m]"


def test_each_telescope_has_its_own_depths(sample, drawn):
    # Seen red: with those of the first telescope.
    ds = photic.open(sample)
    for name in ("narrow", "wide"):
        first = drawn("sample", name).axes[0].get_lines()[0]
        assert first.get_ydata()[0] == ds.gate_depth.sel(telescope=name, channel="elastic").values[0]


def test_a_gate_that_has_converged_alone_is_seen():
    # Seen red: as part of a line, which needs two gates.
    panel = Figure().add_subplot()
    settled = numpy.array([True, False, True, False, False, True, True])
    depth, middle = numpy.arange(7.0), numpy.linspace(2, 1, 7)
    panels._curve(panel, depth, middle, (middle - 0.1, middle + 0.1), settled, "black")
    assert panel.lines[0].get_marker() == "o" and panel.lines[0].get_markevery() == [0, 2]


def test_a_gate_that_has_light_alone_is_seen():
    # The surface's own echo fills one gate. Seen red: with marks for gates between those that have not converged alone.
    panel = Figure().add_subplot()
    depth, middle = numpy.arange(4.0), numpy.array([1.0, numpy.nan, numpy.nan, numpy.nan])
    panels._curve(panel, depth, middle, (middle, middle), numpy.full(4, True), "black")
    assert panel.lines[0].get_markevery() == [0]
