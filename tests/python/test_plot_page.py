"""Figures as pages: what stands where, and how much of a result they show."""

import itertools
from functools import cache

import matplotlib.image
import numpy
import pytest
import xarray
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.collections import PolyCollection
from matplotlib.colors import to_rgb

import photic
from photic import panels, plot
from photic.errors import Error


def titles(drawing):
    return [" ".join(panel.get_title(loc="left").split()) for panel in drawing.axes]


def caption(drawing):
    return " ".join(drawing._supxlabel.get_text().split())


def legends(drawing):
    return [each for part in drawing.subfigs for each in part.legends]


def with_channels(ds, count):
    """So many channels, each less bright than the one before."""
    many = ds.isel(channel=[k % ds.sizes["channel"] for k in range(count)])
    names = [f"f_{400 + 5 * k}" for k in range(count)]
    dim = xarray.DataArray(0.8 ** numpy.arange(count), dims="channel", coords={"channel": names})
    many = many.assign_coords(channel=names)
    for name in ("echo", "echo_standard_error", "echo_by_order", "echo_by_process"):
        many[name] = many[name] * dim
    return many


def of_every_channel(ds, **look):
    """The panels of channels that are asked for, each of them."""
    names = [str(name) for name in ds.channel.values]
    return plot.figure([ds], [str(len(names))], ["wide"], names, **look)


def two_dark(ds):
    ds.echo.loc[{"channel": ["f_400", "f_405"]}] = 0
    return ds


def overlap(one, other, slack):
    across = min(one.x1, other.x1) - max(one.x0, other.x0)
    along = min(one.y1, other.y1) - max(one.y0, other.y0)
    return across > slack and along > slack


def check_page(drawing):
    """Nothing is cut, and no legend, panel, title or caption lies over another."""
    renderer = FigureCanvasAgg(drawing).get_renderer()
    things = {f"panel {k}": each.get_tightbbox(renderer) for k, each in enumerate(drawing.axes)}
    things |= {f"legend {k}": each.get_window_extent() for k, each in enumerate(legends(drawing))}
    things["caption"] = drawing._supxlabel.get_window_extent()
    if drawing._suptitle is not None:
        things["title"] = drawing._suptitle.get_window_extent()
    width, height = drawing.get_size_inches() * drawing.dpi
    slack = 0.01 * drawing.dpi
    for name, box in things.items():
        assert -slack <= box.x0 and box.x1 <= width + slack, f"{name} is cut: {box}"
        assert -slack <= box.y0 and box.y1 <= height + slack, f"{name} is cut: {box}"
    for (name, box), (other, its) in itertools.combinations(things.items(), 2):
        assert not overlap(box, its, slack), f"{name} and {other} overlap"


FIGURES = {
    "one": lambda ds, **look: plot.figure([ds], ["one"], **look),
    "one telescope": lambda ds, **look: plot.figure([ds], ["one"], telescopes=["wide"], **look),
    "three": lambda ds, **look: plot.figure([ds] * 3, ["a", "b", "a long name of a result"], **look),
    "33": lambda ds, **look: of_every_channel(two_dark(with_channels(ds, 33)), **look),
    "64": lambda ds, **look: of_every_channel(with_channels(ds, 64), **look),
    "64, twice": lambda ds, **look: plot.figure([with_channels(ds, 64)] * 2, ["a", "b"], **look),
}


IMPORTS = "ignore:numpy.ndarray size changed"  # by a library that is read late; numpy hides it, too
PAGES = {
    "one": [None, 84],
    "one telescope": [None],
    "three": [None, 84],
    "33": [None, 174],
    "64": [84],
    "64, twice": [174],
}


@pytest.fixture(scope="module")
def drawn(sample):
    """Figures that several tests look at, each drawn once."""

    @cache
    def draw(name, width_mm=None):
        drawing = FIGURES[name](photic.open(sample), width_mm=width_mm)
        drawing.draw_without_rendering()
        return drawing

    return draw


# Seen red: with legends that reach into the panels; with titles that are not folded; with all lines of
# a legend side by side; "64": with as many rows as there are groups.
@pytest.mark.filterwarnings("error", IMPORTS)
@pytest.mark.parametrize("name, width_mm", [(name, width) for name in PAGES for width in PAGES[name]])
def test_nothing_is_covered_or_cut(drawn, name, width_mm):
    drawing = drawn(name, width_mm)
    check_page(drawing)
    if width_mm is not None:
        assert drawing.get_size_inches()[0] == pytest.approx(width_mm / 25.4, abs=1e-9)
    longest = 270 / 25.4 if name in ("33", "64") and width_mm is not None else 30
    assert drawing.get_size_inches()[1] < longest


@pytest.mark.filterwarnings("error", IMPORTS)
@pytest.mark.parametrize("telescopes, width_mm", [(["wide"], None), ([], 84)])
def test_nothing_of_environments_and_sensitivities_is_covered(sample_with_parameters, telescopes, width_mm):
    drawing = plot.figure([photic.open(sample_with_parameters)], ["one"], telescopes, width_mm=width_mm)
    drawing.draw_without_rendering()
    check_page(drawing)


# Seen red: with the sizes of a free page.
def test_letters_of_a_column_are_of_7_to_9_points(drawn):
    drawing = drawn("one", 84)
    words = [drawing._suptitle, drawing._supxlabel]
    for panel in drawing.axes:
        words += [panel.xaxis.label, panel.yaxis.label, panel._left_title]
        words += panel.get_xticklabels() + panel.get_yticklabels()
    for each in legends(drawing):
        words += [*each.get_texts(), each.get_title()]
    sizes = {each.get_fontsize() for each in words if each.get_text()}
    assert min(sizes) == 7 and max(sizes) == 9


# Seen red: with a figure wider by a thousandth.
@pytest.mark.parametrize("ending, width_mm", [("png", 84), ("png", 174), ("pdf", 174), ("svg", 84)])
def test_pictures_have_the_width_asked_for(command, sample, tmp_path, ending, width_mm):
    path = tmp_path / f"out.{ending}"
    chosen = ["--telescope", "wide", "--channel", "raman", "--width-mm", width_mm]
    assert command("plot", sample, "-o", path, *chosen) == (0, "")
    if ending == "png":
        assert matplotlib.image.imread(path).shape[1] == int(width_mm / 25.4 * 300)
    elif ending == "pdf":
        box = path.read_bytes().split(b"/MediaBox [")[1].split(b"]")[0].split()
        assert float(box[2]) == pytest.approx(width_mm / 25.4 * 72, abs=0.01)
    else:
        width = path.read_text().split('width="')[1].split('pt"')[0]
        assert float(width) == pytest.approx(width_mm / 25.4 * 72, abs=0.01)


def drawn_at(collections, depth):
    """Which of them have the depth between their ends."""
    ends = [each.get_paths() for each in collections]
    return [
        any(path.vertices[:, 1].min() < depth < path.vertices[:, 1].max() for path in paths)
        for paths in ends
    ]


# Seen red: with one opacity for all gates; with faded bands under all gates.
def test_what_has_not_converged_is_faded(sample):
    ds = photic.open(sample).sel(channel=["elastic"])
    drawing = plot.figure([ds], ["one"], telescopes=["narrow"])
    panel = drawing.axes[0]
    good, faded = [each for each in panel.collections if isinstance(each, PolyCollection)]
    assert faded.get_alpha() < good.get_alpha() / 2
    one = ds.sel(telescope="narrow", channel="elastic")
    depth = one.gate_depth.values
    lit, settled = one.echo.values > 0, one.converged.values
    assert 0 < settled.sum() < lit.sum()
    for k in range(len(depth) - 1):
        if lit[k] and lit[k + 1]:
            both = settled[k] and settled[k + 1]
            assert drawn_at([good, faded], depth[k : k + 2].mean()) == [both, not both]
    thick, thin, circles = panel.get_lines()
    assert thick.get_alpha() is None and thin.get_alpha() < 0.6 and circles.get_alpha() < 0.6
    assert [text.get_text() for text in legends(drawing)[0].get_texts()][-1] == "faded: not converged"
    veil = [each for each in drawing.axes[1].collections if each.get_hatch()][0]
    assert to_rgb(veil.get_facecolor()[0]) == (1, 1, 1) and 0.4 < veil.get_facecolor()[0][3] < 0.8


# Seen red: with the echoes of the first for all.
def test_all_telescopes_are_drawn_or_those_asked_for(sample, drawn):
    ds = photic.open(sample)
    drawing = drawn("one")
    of_each = ["{}: Echo by channel (one process each)", "{}: elastic echo by order of scattering"]
    of_each.append("{}: raman echo by order of scattering")
    assert titles(drawing) == [words.format(name) for name in ("narrow", "wide") for words in of_each]
    for panel, name in ((drawing.axes[0], "narrow"), (drawing.axes[3], "wide")):
        elastic = ds.sel(telescope=name, channel="elastic")
        thin = panel.get_lines()[1]
        assert thin.get_xdata()[0] == elastic.echo[0] and thin.get_ydata()[0] == elastic.gate_depth[0]
    assert drawing.axes[0].get_ylim() != drawing.axes[3].get_ylim()
    wide = drawn("one telescope")
    assert titles(wide) == [words.format("wide").removeprefix("wide: ") for words in of_each]
    assert "telescope wide" in caption(wide)
    both = plot.figure([ds], ["one"], telescopes=["wide", "narrow"])
    assert titles(both)[0].startswith("wide:") and titles(both)[3].startswith("narrow:")


def test_results_share_the_panels_of_telescopes_of_one_name(sample):
    ds = photic.open(sample)
    drawing = plot.figure([ds, ds.sel(telescope=["wide"])], ["a", "b"], channels=["raman"])
    assert titles(drawing) == ["narrow: raman echo", "a by order", "wide: raman echo", "a by order", "b by order"]
    assert [len(drawing.axes[k].get_lines()) for k in (0, 2)] == [3, 6 + 1]  # and the sea, which "wide" sees from above


# Seen red: without the look for unknown depths.
def test_depths_and_times_are_not_mixed_on_an_axis(sample):
    ds = photic.open(sample).isel(telescope=[0])
    up = ds.copy()
    for name in ("gate_depth", "gate_depth_bounds"):
        up[name] = up[name] * numpy.nan
    panel = plot.figure([ds, up], ["down", "up"], channels=["elastic"]).axes[0]
    assert panel.get_ylabel() == "time [ns]"
    assert all(panel.get_lines()[k].get_ydata()[0] == ds.gate_time[0] for k in (1, 4))


# Seen red: with all channels in one panel; with those drawn that have no light.
def test_many_channels_have_panels_of_seven(sample, drawn):
    channels = with_channels(photic.open(sample), 33).channel.values
    drawing = drawn("33")
    groups = [panel for panel, title in zip(drawing.axes, titles(drawing)) if title.startswith("Echo: ")]
    assert [len(panel.get_lines()) // 3 for panel in groups] == [7, 6, 6, 6, 6]
    assert titles(drawing)[0] == "Echo: f_410 to f_440"
    assert len({panel.get_xlim() for panel in groups}) == 1
    assert "No light in any gate: f_400, f_405." in caption(drawing)
    assert "Orders of scattering are of 2 of 33 channels: --channel NAME" in caption(drawing)
    named = [text.get_text().split()[0] for each in legends(drawing)[:5] for text in each.get_texts()]
    assert [name for name in named if name != "faded:"] == list(channels[2:])


# Seen red: without the notes of what has no place.
def test_what_has_no_room_is_stated(sample, drawn):
    said = caption(drawn("64", 84))
    assert "Drawn are 28 of 64 channels: --channel NAME, which may be repeated, chooses others." in said
    ds = with_channels(photic.open(sample), 64)
    chosen = plot.figure([ds], ["64"], telescopes=["wide"], channels=["f_500", "f_450"])
    texts = [text.get_text() for text in legends(chosen)[0].get_texts()]
    assert [words.split()[0] for words in texts[:2]] == ["f_500", "f_450"]
    with pytest.raises(Error, match=r"no channel 'g'; there are: f_400, .* and 52 more"):
        plot.figure([ds], ["64"], channels=["g"])


# Seen red: with all of them named.
def test_legends_of_many_environments_are_bounded():
    lines = [(f"water {k}", "black") for k in range(1000)]
    names = [handle.get_label() for handle in panels.lines_legend(lines, True).handles]
    assert names[0] == "water 0" and names[-3:] == ["water 999", "24 of 1000 are named", panels.NOT_CONVERGED]
    assert len(names) == 26
