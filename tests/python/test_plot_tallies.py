"""Pictures of quantities beside echoes."""

import numpy
import pytest
from drawings import legends, titles

import photic
import photic.result
from photic import plot, tallies

PANELS = [
    "Irradiance",
    "Radiance of scattered light",
    "Light absorbed in a layer by a constituent",
    "Light that goes away for good",
    "fluence_lamp",
    "fluence_across",
]


@pytest.fixture
def sun(sample_of_tallies):
    return photic.open(sample_of_tallies)


def figure(result, name="sun", **how):
    return plot.figure([result], [name], **how)


def panel(drawing, title):
    return next(each for each in drawing.axes if each.get_title(loc="left") == title)


# Seen red: refused, as holding no echoes.
def test_without_echoes_all_panels_are_of_tallies(sun):
    drawing = figure(sun)
    assert [title for title in titles(drawing) if title] == PANELS
    caption = drawing._supxlabel.get_text()
    assert "2\u2009000\u2009000 photons" in caption and "Balance" in caption


def test_below_the_echoes_of_one_result(sample_with_tallies, sample):
    drawing = figure(photic.open(sample_with_tallies))
    drawn = [title for title in titles(drawing) if title]
    assert drawn[-len(PANELS) :] == PANELS
    assert drawn[: -len(PANELS)] == [title for title in titles(figure(photic.open(sample))) if title]


# Seen red: without the scale of the strength.
def test_values_are_by_the_strength_of_the_source(sun):
    one = panel(figure(sun), "Irradiance")
    assert one.get_xlabel() == "W m-2"
    lines = [line for line in one.lines if line.get_marker() == "None" and len(line.get_xdata()) == 8]
    assert numpy.allclose(lines[0].get_xdata(), 50 * sun.irradiance_down.values)
    assert numpy.allclose(lines[0].get_ydata(), sun.level_depth.values)
    for name in photic.result.tallies(sun):
        for key in ("strength_scale", "strength_units"):
            del sun[name].attrs[key]
    one = panel(figure(sun), "Radiance of scattered light")
    assert one.get_xlabel() == "sr-1 per unit irradiance across the beam"


# Seen red: with up at the bottom.
def test_depth_is_down_and_air_is_named(sun):
    one = panel(figure(sun), "Irradiance")
    bottom, top = one.get_ylim()
    assert bottom > 60 and top < -10
    assert one.get_ylabel() == "depth [m]; above the line: air"
    assert panel(figure(sun), "Radiance of scattered light").get_ylabel() == "depth [m]"


# Seen red: without hatches.
def test_what_has_not_converged_is_open_or_hatched(sun):
    drawing = figure(sun)
    bars = panel(drawing, "Light that goes away for good").patches
    hatched = sorted(bar.get_x() for bar in bars if bar.get_hatch())
    assert hatched == [70, 80] and len(bars) == 9
    open_points = [line for line in panel(drawing, "Irradiance").lines if line.get_markerfacecolor() == "white"]
    assert sum(len(line.get_xdata()) for line in open_points) == 4
    assert panel(drawing, "fluence_lamp").collections[1].get_hatch()
    said = [text for legend in legends(drawing) for text in legend]
    assert "open: not converged" in said and tallies.OPEN_LABEL in said and "hatched: not converged" in said


def test_what_has_all_converged_has_no_mark(sun):
    for name in photic.result.tallies(sun):
        sun[name + "_converged"] = sun[name + "_converged"] | True
    drawing = figure(sun)
    assert not any(bar.get_hatch() for one in drawing.axes for bar in one.patches)
    assert not [text for legend in legends(drawing) for text in legend if "converged" in text]


# Seen red: with the values of layers the other way round.
def test_absorbed_by_layer_and_constituent(sun):
    one = panel(figure(sun), PANELS[2])
    assert [text.get_text() for text in one.get_yticklabels()] == ["upper", "lower", "haze"]
    haze = [bar for bar in one.patches if bar.get_y() + bar.get_height() / 2 == pytest.approx(2)]
    assert [bar.get_width() for bar in haze] == pytest.approx([50 * float(sun.absorbed[2, 3])])
    upper = [bar for bar in one.patches if bar.get_y() + bar.get_height() / 2 == pytest.approx(0)]
    assert max(bar.get_x() + bar.get_width() for bar in upper) == pytest.approx(50 * float(sun.absorbed[0].sum()))


# Seen red: with the names as they are.
def test_names_are_no_formulas(sun, tmp_path):
    sun = sun.assign_coords(layer=["$a", "b$_{", "_c"])
    drawing = figure(sun)
    drawing.savefig(tmp_path / "sun.png")
    names = [text.get_text() for text in panel(drawing, PANELS[2]).get_yticklabels()]
    assert names == ["\\$a", "b\\$_{", " _c"]


def test_without_light(sun):
    for name in photic.result.tallies(sun):
        sun[name][...] = 0
    drawing = figure(sun)
    said = [text.get_text() for one in drawing.axes for text in one.texts]
    assert said.count("no light at any level") == 2 and said.count("no light in any cell") == 2


def test_errors_that_are_not_known_are_no_bars(sun):
    for name in photic.result.tallies(sun):
        sun[name + "_standard_error"][...] = numpy.nan
    assert panel(figure(sun), "Irradiance").lines


def test_fits_a_column(sun):
    assert figure(sun, width_mm=85).get_figwidth() == pytest.approx(85 / 25.4)


def test_written_as_a_picture(command, sample_of_tallies, tmp_path):
    assert command("plot", sample_of_tallies, "-o", tmp_path / "sun.png") == (0, "")
    assert (tmp_path / "sun.png").stat().st_size > 10_000


# Seen red: without a look at --channel.
def test_channels_and_comparisons_are_refused(command, sample_of_tallies, sample, tmp_path):
    def refusal(*arguments):
        code, said = command("plot", *arguments, "-o", tmp_path / "no.png")
        assert code == 2 and not (tmp_path / "no.png").exists()
        return said.strip()

    alone = f"{sample_of_tallies.stem}: holds no echoes, and no channels (leave out --channel)"
    assert refusal(sample_of_tallies, "--channel", "raman") == alone
    for two in ([sample, sample_of_tallies], [sample_of_tallies, sample_of_tallies]):
        assert "holds no echoes, by which results are compared: draw it alone" in refusal(*two)


def test_several_with_echoes_leave_tallies_out_and_say_so(sample_with_tallies, sample):
    results = [photic.open(path) for path in (sample_with_tallies, sample)]
    drawing = plot.figure(results, ["a", "b"])
    assert "Irradiance" not in titles(drawing)
    assert "its tallies are drawn only where it is drawn alone" in drawing._supxlabel.get_text()
