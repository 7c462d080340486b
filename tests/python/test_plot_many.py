"""Figures of one result with many channels: a map of depth and wavelength, and spectra at some depths."""

import numpy
import pytest
from matplotlib.collections import PolyCollection, QuadMesh
from matplotlib.colors import to_rgb
from test_plot_page import IMPORTS, caption, check_page, legends, titles, with_channels
from test_spectrum import CENTRES, WIDTHS, close, names_of, with_filters

import photic
from photic import maps, panels, plot, plot_many, spectrum, views

MAP, OTHERS, DEPTHS = "Echo by depth and wavelength", "Echo of the other channels", "Spectra at several depths"
EVEN = list(range(410, 600, 20))  # wavelengths of filters


@pytest.fixture
def filtered(sample):
    """Ten filters in disorder, of uneven steps, and a channel of a process."""
    return with_filters(photic.open(sample))


@pytest.fixture
def mixed(sample):
    """Nine channels of three wavelengths, none of which is a filter."""
    return with_channels(photic.open(sample), 9)


def with_views(ds):
    """Both telescopes at one place behind one lens."""
    depths = {name: ds[name].isel(telescope=[0, 0]) for name in ("gate_depth", "gate_depth_bounds")}
    depths = {name: (each.dims, each.values, each.attrs) for name, each in depths.items()}
    lines = ""
    for name, view in (("narrow", 5), ("wide", 20)):
        lines += f'\n[[telescope]]\nname = "{name}"\nfocal_length_m = 2\nhalf_field_of_view_mrad = {view}'
    return ds.assign_coords(depths).assign_attrs(scene=ds.attrs["scene"] + lines)


def figure(ds, telescopes=(), channels=(), **look):
    drawing = plot.figure([ds], ["many"], telescopes, channels, **look)
    drawing.draw_without_rendering()
    return drawing


def mesh_of(panel):
    (mesh,) = [each for each in panel.collections if isinstance(each, QuadMesh)]
    return mesh


def cells(panel):
    """The numbers that a map shows, by gate and column, without those between its columns."""
    across = mesh_of(panel).get_coordinates()[0, :, 0]
    rows = mesh_of(panel).get_coordinates().shape[0] - 1
    return mesh_of(panel).get_array().filled(numpy.nan).reshape(rows, len(across) - 1)[:, ::2]


def wavelengths_at(panel):
    across = mesh_of(panel).get_coordinates()[0, :, 0]
    return 0.5 * (across[::2] + across[1::2])


def panels_by_title(drawing):
    return dict(zip(titles(drawing), drawing.axes))


def texts(legend):
    return [each.get_text() for each in legend.get_texts()]


# Seen red: with more than eight for many; with the channels that are chosen drawn so, too.
def test_eight_channels_are_many_unless_they_are_chosen(sample):
    ds = photic.open(sample)
    assert titles(figure(with_channels(ds, 8), ["wide"]))[0] == MAP
    for few in (figure(with_channels(ds, 7), ["wide"]), figure(with_channels(ds, 8), ["wide"], names_of(with_channels(ds, 8)))):
        assert titles(few)[0].startswith("Echo") and MAP not in titles(few)


# Seen red: with the scene's total in place of an echo for each nm; with columns in the order of the channels; with
# the gates of the first channel for all; with cells where there is no light.
def test_a_map_has_the_echo_of_each_filter_and_gate(filtered):
    for name in ("gate_depth", "gate_depth_bounds"):
        filtered[name].loc[{"channel": "f1"}] *= 1.01  # behind the other filters
    drawing = figure(filtered, ["narrow"])
    assert titles(drawing)[:2] == [MAP, OTHERS] and DEPTHS in titles(drawing)
    panel = drawing.axes[0]
    order = numpy.argsort(CENTRES)
    view = filtered.sel(telescope="narrow", channel=[f"f{k}" for k in order]).transpose("channel", "gate", ...)
    expected = (view.echo.values / numpy.array(WIDTHS)[order, None]).T
    expected[expected == 0] = numpy.nan
    assert cells(panel) == pytest.approx(expected, rel=1e-12, abs=0, nan_ok=True)
    second_gate = mesh_of(panel).get_coordinates()[1, ::2, 1]
    assert second_gate == pytest.approx(view.gate_depth_bounds.values[:, 1, 0])
    assert second_gate[0] == pytest.approx(1.01 * second_gate[1])
    assert panel.get_xlabel() == "wavelength of the filter [nm]" and panel.get_ylabel() == "depth [m]"
    assert panel.get_ylim() == drawing.axes[1].get_ylim()
    bar = [each for each in drawing.axes if "emitted and nm" in each.get_ylabel() and each is not panel][0]
    assert " ".join(bar.get_ylabel().split()) == "photons detected per photon emitted and nm"


def evenly(ds):
    """The same filters in even steps."""
    scene = ds.attrs["scene"]
    for k, centre in enumerate(EVEN):
        scene = scene.replace(f'name = "f{k}"\ncentre_nm = {CENTRES[k]}\n', f'name = "f{k}"\ncentre_nm = {centre}\n')
    return ds.assign_attrs(scene=scene)


# Seen red: with uneven steps on an axis of wavelengths, where one column hides another.
def test_even_steps_are_an_axis_of_wavelengths_others_stand_side_by_side(filtered):
    even = figure(evenly(filtered), ["narrow"]).axes[0]
    assert wavelengths_at(even) == pytest.approx(EVEN)
    uneven = filtered.assign_attrs(scene=filtered.attrs["scene"].replace("centre_nm = 590", "centre_nm = 690"))
    panel = figure(uneven, ["narrow"]).axes[0]
    assert wavelengths_at(panel) == pytest.approx(numpy.arange(10))
    labels = [each.get_text() for each in panel.get_xticklabels()]
    assert labels == [f"{centre}" for centre in sorted(CENTRES[:-1])] + ["690"]


# Seen red: with all cells of a column that has any; with the flags of the first channel for all.
def test_cells_that_have_not_converged_are_hatched(filtered):
    filtered.converged[:] = True
    dark = {"telescope": "narrow", "channel": "f5", "gate": 4}
    filtered.echo.loc[dark] = 0
    for flagged in (dict(dark), {**dark, "channel": "f2", "gate": 3}, {**dark, "channel": "f2", "gate": 4}):
        filtered.converged.loc[flagged] = False
    drawing = figure(evenly(filtered), ["narrow"])
    (boxes,) = [each for each in drawing.axes[0].collections if each.get_hatch()]
    (box,) = [path.vertices for path in boxes.get_paths()]  # of two gates, one below the other
    bounds = filtered.gate_depth_bounds.sel(telescope="narrow", channel="f2").values
    assert (box[:, 0].min(), box[:, 0].max()) == pytest.approx((EVEN[2] - 10, EVEN[2] + 10))
    assert (box[:, 1].min(), box[:, 1].max()) == pytest.approx((bounds[3, 0], bounds[4, 1]))
    assert texts(legends(drawing)[0]) == ["hatched: not converged", "no light"]
    assert to_rgb(drawing.axes[0].get_facecolor()) == to_rgb(maps.DARK)


# Seen red: with colours from the least echo that there is, converged or not.
def test_colours_are_chosen_by_what_has_converged(filtered):
    filtered = filtered.isel(gate=slice(0, 30)).copy(deep=True)
    filtered.converged[:] = True
    filtered.converged.loc[{"channel": "f2", "gate": 3}] = False
    good = filtered.sel(telescope="narrow", channel=[f"f{k}" for k in range(10)])
    echo = good.echo.transpose("channel", "gate").values / numpy.array(WIDTHS)[:, None]
    least, largest = echo[echo > 0].min(), echo.max()
    assert least > 10 * largest / maps.LARGEST_RATIO
    filtered.echo.loc[{"channel": "f2", "gate": 3}] = least
    norm = mesh_of(figure(filtered, ["narrow"]).axes[0]).norm
    assert (norm.vmin, norm.vmax) == close((least, largest))
    filtered.echo.loc[{"channel": "f1", "gate": 3}] = 1e-10 * least  # more decades than colours
    assert mesh_of(figure(filtered, ["narrow"]).axes[0]).norm.vmin == close(largest / maps.LARGEST_RATIO)


# Seen red: with the spectra of the first gates; with standard errors for 1.96 of them.
def test_spectra_at_four_depths(filtered):
    filtered.converged[:] = False
    filtered.converged.loc[{"gate": [5, 20, 41, 62, 80, 90]}] = True
    view = filtered.sel(telescope="narrow")
    drawing = figure(filtered, ["narrow"])
    panel = panels_by_title(drawing)[DEPTHS]
    lines = panel.get_lines()
    assert len(lines) == 4 * 3 and panel.get_yscale() == "log" and panel.get_xlabel() == "wavelength [nm]"
    found = spectrum.filters(filtered, names_of(filtered))
    for gate, thin, band in zip([5, 41, 62, 90], lines[1::3], [each for each in panel.collections if each.get_alpha() == panels.BAND]):
        one = spectrum.seen(view.isel(gate=[gate]), found)
        assert thin.get_xdata().tolist() == sorted(CENTRES) and thin.get_ydata() == close(one.density)
        vertices = numpy.concatenate([path.vertices for path in band.get_paths()])
        at = vertices[vertices[:, 0] == sorted(CENTRES)[0], 1]
        ends = one.density[0] + numpy.array([-1.96, 1.96]) * one.standard_error[0]
        assert (at.min(), at.max()) == close((max(ends[0], 0.1 * one.density[0]), ends[1]), 1e-9)
    legend = next(each for each in legends(drawing) if each.get_title().get_text() == "depth [m]")
    assert texts(legend)[:4] == [label(view, gate) for gate in [5, 41, 62, 90]]


def label(view, gate):
    bounds = view.gate_depth_bounds.isel(gate=gate, channel=0).values
    return f"{bounds[0]:.3g} to {bounds[1]:.3g}"


def test_fewer_gates_than_four(filtered):
    one = filtered.isel(gate=[3])
    drawing = figure(one, ["narrow"])
    assert "Spectrum at one depth" in titles(drawing) and cells(drawing.axes[0]).shape == (1, 10)
    check_page(drawing)
    two = figure(filtered.isel(gate=[3, 4]), ["narrow"])
    assert len(panels_by_title(two)[DEPTHS].get_lines()) == 2 * 3


# Seen red: with the filters alone looked at, which has no map; with lines between points.
def test_channels_that_are_no_filters_are_points(mixed):
    drawing = figure(mixed, ["wide"])
    assert titles(drawing)[0] == MAP and OTHERS not in titles(drawing)
    panel = drawing.axes[0]
    labels = [each.get_text() for each in panel.get_xticklabels()]
    wavelength = mixed.channel_wavelength.values
    order = numpy.argsort(wavelength, kind="stable")
    assert labels == [f"{mixed.channel.values[k]}, {wavelength[k]:.4g}" for k in order]
    assert wavelengths_at(panel) == pytest.approx(numpy.arange(9))
    view = mixed.sel(telescope="wide").isel(channel=order)
    echo = view.echo.transpose("gate", "channel").values
    assert cells(panel) == pytest.approx(numpy.where(echo > 0, echo, numpy.nan), rel=1e-12, abs=0, nan_ok=True)
    points = panels_by_title(drawing)[DEPTHS]
    assert points.get_ylabel() == "photons detected per photon emitted"
    assert {line.get_linestyle() for line in points.get_lines()} == {"None"}
    there = numpy.concatenate([line.get_xdata() for line in points.get_lines() if line.get_marker() == "o"])
    assert set(there) == set(wavelength)


# Seen red: with a panel for each; with the narrow view's map.
def test_telescopes_that_differ_in_view_alone_share_panels(filtered):
    drawing = figure(with_views(filtered))
    found = panels_by_title(drawing)
    assert [title for title in titles(drawing) if title] == [f"wide: {MAP}", OTHERS, DEPTHS, "wide: Spectrum by process"]
    thin = found[OTHERS].get_lines()[1::3]
    for line, name, style in zip(thin, ["wide", "narrow"], ["-", "--"], strict=True):
        echo = filtered.sel(telescope=name, channel="raman").echo.values
        assert line.get_linestyle() == style
        assert line.get_xdata()[echo > 0] == close(echo[echo > 0])
    styles = [line.get_linestyle() for line in found[DEPTHS].get_lines()[1::3]]
    assert styles == ["-"] * (len(styles) // 2) + ["--"] * (len(styles) // 2)
    assert texts(legends(drawing)[1])[:3] == ["raman (649.8 nm)", "wide", "narrow"]
    apart = figure(filtered)
    assert [title for title in titles(apart) if MAP in title] == [f"narrow: {MAP}", f"wide: {MAP}"]


def test_few_channels_of_telescopes_that_differ_in_view_alone(sample):
    # Seen red: with a panel of echoes for each.
    ds = with_views(photic.open(sample))
    drawing = figure(ds)
    orders = [f"{name}: {channel} echo by order of scattering" for name in ("wide", "narrow") for channel in ("elastic", "raman")]
    assert titles(drawing) == ["Echo by channel (one process each)", *orders]
    thin = drawing.axes[0].get_lines()[1::3]
    assert [line.get_linestyle() for line in thin] == ["-"] * 3 + ["--"] * 3
    names = ["elastic (532 nm)", "raman (649.8 nm)", "chlorophyll (685 nm)", "wide", "narrow", panels.NOT_CONVERGED]
    assert texts(legends(drawing)[0]) == names
    check_page(drawing)


# Seen red: with detectors' diameters and angles compared as they stand; with the lens not looked at.
def test_views_are_grouped_by_what_else_the_scene_says(sample):
    ds = photic.open(sample)
    lens = {"focal_length_m": 2.0, "position_m": [0, 0, 12]}
    telescopes = {
        "a": {"half_field_of_view_mrad": 10.0, **lens},
        "b": {"detector_diameter_m": 0.05, **lens},
        "c": {"half_field_of_view_mrad": 20.0, **lens, "position_m": [0.1, 0, 12]},
        "d": {"half_field_of_view_mrad": 5.0, **lens},
    }
    scene = ""
    for name, keys in telescopes.items():
        scene += f'[[telescope]]\nname = "{name}"\n' + "".join(f"{key} = {value}\n" for key, value in keys.items())
    described = ds.assign_attrs(scene=scene)
    assert views.grouped(described, list("abcd")) == [["b", "a", "d"], ["c"]]
    assert views.grouped(described, list("cda")) == [["c"], ["a", "d"]]
    assert views.grouped(ds, ["narrow", "wide"]) == [["narrow"], ["wide"]]  # its scene says nothing


PAGES = {
    "filters": (lambda ds: with_filters(ds), None),
    "filters in a column": (lambda ds: with_filters(ds), 84),
    "filters in two columns": (lambda ds: with_filters(ds), 174),
    "two views": (lambda ds: with_views(with_filters(ds)), None),
    "any channels": (lambda ds: with_channels(ds, 9), None),
    "any channels in a column": (lambda ds: with_channels(ds, 9), 84),
    "64 channels": (lambda ds: with_channels(ds, 64), 174),
}


# Seen red: with the name of the colours not folded; with titles of all spectra on a narrow page.
@pytest.mark.filterwarnings("error", IMPORTS)
@pytest.mark.parametrize("name", PAGES)
def test_nothing_is_covered_or_cut_and_no_page_is_long(sample, name):
    change, width_mm = PAGES[name]
    drawing = figure(change(photic.open(sample)), ["wide"] if "views" not in name else [], width_mm=width_mm)
    check_page(drawing)
    for panel in drawing.axes:  # no name of colours reaches into another row
        own, row = panel.yaxis.label.get_window_extent(), panel.figure.bbox
        assert row.y0 - 2 <= own.y0 and own.y1 <= row.y1 + 2
    width, height = drawing.get_size_inches()
    assert height < (1.0 * width if width_mm is None else 270 / 25.4)


def test_environments_on_a_page(sample_in_other_water):
    ds = with_filters(photic.open(sample_in_other_water))
    wide, column = figure(ds, ["wide"]), figure(ds, ["wide"], width_mm=84)
    check_page(wide)
    assert titles(wide)[-1] == "Spectrum in the environments" and "A wider figure" not in caption(wide)
    assert plot_many.NO_ROOM in caption(column) and titles(column)[-1] == DEPTHS
    assert "Of 11 channels there are a map and spectra: --channel NAME" in caption(wide)


@pytest.mark.filterwarnings("error:::numpy", "error::RuntimeWarning")
@pytest.mark.parametrize("change", [with_filters, lambda ds: with_channels(ds, 9)], ids=["filters", "any"])
def test_no_light_errors_that_are_not_known_and_nothing_converged(sample, change):
    ds = change(photic.open(sample))
    dark = ds.copy(deep=True)
    for name in ("echo", "echo_by_process"):
        dark[name] = 0 * dark[name]
    assert panels.NO_LIGHT in [each.get_text() for each in figure(dark, ["narrow"]).axes[0].texts]
    unknown = ds.copy(deep=True)
    unknown["echo_standard_error"] = numpy.nan * ds.echo
    unknown["converged"] = ds.converged & False
    panel = figure(unknown, ["narrow"]).axes[0]
    assert numpy.isfinite(cells(panel)).any()
    assert [each for each in panel.collections if isinstance(each, PolyCollection) and each.get_hatch()]
