"""The spectrum that filters see, in figures of results."""

import numpy
import pytest
import xarray

import photic
from photic import panels, plot, spectrum

# Ten filters in disorder, of several widths, and a channel of a process among them.
CENTRES = [450, 410, 490, 430, 470, 510, 530, 550, 570, 590]
WIDTHS = [10, 20, 10, 5, 10, 10, 10, 10, 10, 40]
PARTS = {"raman": 0.75, "chlorophyll": 0.25}


def with_filters(ds, count=10, shapes=("top-hat",)):
    """The sample seen through so many filters, each as bright as its wavelength."""
    names = [f"f{k}" for k in range(count)] + ["raman"]
    many = ds.isel(channel=[1] * len(names)).assign_coords(channel=names)
    bright = xarray.DataArray([*(centre / 500 for centre in CENTRES[:count]), 1.0], dims="channel")
    for name in [each for each in many.data_vars if "echo" in each or each.startswith("environment_diff")]:
        if many[name].dtype == float:
            many[name] = many[name] * bright
    share = xarray.DataArray([PARTS.get(str(name), 0.0) for name in many.process.values], dims="process")
    for end in ("", "_standard_error"):
        parts = many["echo" + end] * share
        many["echo_by_process" + end] = parts.transpose(*many["echo_by_process" + end].dims)
    lines = ["[[channel]]", 'name = "raman"', 'process = "raman"']
    for k in range(count):
        lines += ["[[channel]]", f'name = "f{k}"', f"centre_nm = {CENTRES[k]}", f"fwhm_nm = {WIDTHS[k]}"]
        lines.append(f'filter = "{shapes[k % len(shapes)]}"')
    return many.assign_attrs(scene="\n".join(lines))


@pytest.fixture
def filtered(sample):
    return with_filters(photic.open(sample))


def view(ds):
    return ds.sel(telescope="narrow")


def found_in(ds):
    return spectrum.filters(ds, names_of(ds))


def names_of(ds):
    return [str(name) for name in ds.channel.values]


def close(values, rel=1e-12):
    """Echoes are far below what approx takes for 0 by itself."""
    return pytest.approx(values, rel=rel, abs=0)


def titles(drawing):
    return [panel.get_title(loc="left") for panel in drawing.axes]


def caption(drawing):
    return drawing._supxlabel.get_text()


def curves(panel):
    """The thick line, the thin one and the circles of each spectrum."""
    lines = panel.get_lines()
    return [lines[k : k + 3] for k in range(0, len(lines), 3)]


# Seen red: in the order of the channels; with the channel of a process; with those not asked for.
def test_filters_are_those_of_the_scene_by_wavelength(filtered):
    assert [each["centre_nm"] for each in found_in(filtered)] == sorted(CENTRES)
    assert len(spectrum.filters(filtered, [f"f{k}" for k in range(8)])) == 8


# Seen red: with one more for few.
def test_few_filters_are_no_spectrum(sample):
    ds = photic.open(sample)
    assert found_in(ds) == []  # its scene has no channels
    assert found_in(with_filters(ds, 7)) == [] and len(found_in(with_filters(ds, 8))) == 8


# Seen red: with the errors added by their squares; with the width of a filter left out, or of another.
def test_a_spectrum_is_the_sum_over_gates_for_each_nm(filtered):
    one = spectrum.seen(view(filtered), found_in(filtered))
    assert one.wavelength.tolist() == sorted(CENTRES)
    for centre, width, k in zip(CENTRES, WIDTHS, range(10)):
        part = view(filtered).sel(channel=f"f{k}")
        at = one.wavelength.tolist().index(centre)
        assert one.density[at] == close(float(part.echo.values.sum()) / width)
        error = float(part.echo_standard_error.values.sum()) / width
        assert one.standard_error[at] == close(error)


def test_the_error_of_a_sum_is_not_above_that_which_is_stated():
    """Gates whose errors are correlated by 1, as by few rare photons that all of them see."""
    gates = numpy.array([3.0, 2.0, 1.0]) * numpy.random.default_rng(1).normal(1, 0.1, (1000, 1))
    error = gates.std(axis=0)
    axes = ("channel", "gate")
    ds = xarray.Dataset(
        {"echo": (axes, [gates[0]]), "echo_standard_error": (axes, [error]), "converged": (axes, [[True] * 3])},
        coords={"channel": ["f"]},
    )
    # Seen red: with the errors added by their squares.
    one = spectrum.seen(ds, [{"name": "f", "centre_nm": 400.0, "fwhm_nm": 1.0}])
    assert one.standard_error[0] == close(gates.sum(axis=1).std())


# Seen red: with the full width at half maximum for the area of both.
def test_a_gaussian_passes_its_area(sample):
    ds = photic.open(sample)
    flat, round_ = (with_filters(ds, shapes=(shape,)) for shape in ("top-hat", "gaussian"))
    ratio = spectrum.seen(view(flat), found_in(flat)).density / spectrum.seen(view(round_), found_in(round_)).density
    area = 1e-3 * (2.0 ** (-4 * numpy.linspace(-10, 10, 20001) ** 2)).sum()  # of a half at half the width
    assert ratio == close(area, 1e-9)


# Seen red: with `any` for `all`; with gates without light looked at.
def test_a_filter_is_settled_where_all_its_gates_with_light_are(filtered):
    filtered.converged[:] = True
    filtered.converged.loc[{"telescope": "narrow", "channel": "f2", "gate": 3}] = False
    dark = {"telescope": "narrow", "channel": "f5", "gate": 4}
    filtered.echo.loc[dark] = 0
    filtered.converged.loc[dark] = False
    one = spectrum.seen(view(filtered), found_in(filtered))
    assert one.wavelength[~one.settled].tolist() == [490]


# Seen red: with the standard errors for 1.96 of them; with the scene's total for that of a process;
# with the note left out.
def test_a_figure_has_the_spectrum_by_process(filtered):
    filtered.converged.loc[{"channel": ["f0", "f3"], "gate": 2}] = False
    drawing = plot.figure([filtered], ["sample"], ["narrow"], names_of(filtered))
    assert titles(drawing)[0] == "Spectrum by process" and titles(drawing).count("Spectrum by process") == 1
    assert spectrum.CAPTION in caption(drawing)
    panel = drawing.axes[0]
    assert panel.get_yscale() == "log" and panel.get_xlabel() == "wavelength [nm]"
    legend = drawing.subfigs[1].legends[0]
    assert [text.get_text() for text in legend.get_texts()][:3] == ["raman", "chlorophyll", "all light"]
    one = spectrum.seen(view(filtered), found_in(filtered))
    assert one.wavelength[~one.settled].tolist() == [430, 450]
    for (thick, thin, circles), part in zip(curves(panel), [*PARTS.values(), 1.0], strict=True):
        assert thin.get_xdata().tolist() == sorted(CENTRES)
        assert thin.get_ydata() == close(part * one.density)
        assert numpy.isfinite(thick.get_ydata()).tolist() == one.settled.tolist()
        assert circles.get_xdata().tolist() == one.wavelength[~one.settled].tolist()
    vertices = numpy.concatenate([path.vertices for path in panel.collections[-1].get_paths()])
    at = vertices[vertices[:, 0] == sorted(CENTRES)[0], 1]
    ends = one.density[0] + numpy.array([-1.96, 1.96]) * one.standard_error[0]
    assert (at.min(), at.max()) == close(tuple(ends), 1e-9)


def test_a_figure_of_few_filters_has_none(sample):
    # Seen red: with an empty panel.
    drawing = plot.figure([with_filters(photic.open(sample), 7)], ["sample"], ["narrow"])
    assert "Spectrum by process" not in titles(drawing) and "Spectra" not in caption(drawing)


# Seen red: with the scene's echo for all; with the scene's flags.
def test_spectra_in_the_environments(sample_in_other_water):
    ds = with_filters(photic.open(sample_in_other_water))
    ds.converged[:] = True
    ds.environment_converged[:] = True
    ds.environment_converged.loc[{"environment": "bloom", "channel": "f1"}] = False
    drawing = plot.figure([ds], ["sample"], ["narrow"], names_of(ds))
    assert titles(drawing)[:2] == ["Spectrum by process", "Spectrum in the environments"]
    assert drawing.axes[0].get_ylim() == drawing.axes[1].get_ylim()
    found = found_in(ds)
    scene, *others = curves(drawing.axes[1])
    assert scene[1].get_ydata() == close(spectrum.seen(view(ds), found).density)
    for (thick, thin, _), name in zip(others, ds.environment.values, strict=True):
        part = view(ds).sel(environment=name)
        sums = [float(part.environment_echo.sel(channel=each["name"]).sum()) / each["fwhm_nm"] for each in found]
        assert thin.get_ydata() == close(sums)
        unsettled = [410] if name == "bloom" else []
        assert [x for x, y in zip(thick.get_xdata(), thick.get_ydata()) if numpy.isnan(y)] == unsettled


# Seen red: with the filters as the first result's scene has them for all.
def test_several_results_have_their_spectra_over_each_other(filtered):
    narrower = filtered.attrs["scene"].replace("fwhm_nm = 40", "fwhm_nm = 20")
    fewer = filtered.isel(channel=[0, 2, 4, 5, 6, 7, 8, 9]).assign_attrs(scene=narrower)
    drawing = plot.figure([filtered, fewer], ["one", "two"], ["narrow"])
    assert titles(drawing)[0] == "Spectrum" and caption(drawing).count(spectrum.CAPTION) == 1
    first, second = curves(drawing.axes[0])
    assert [len(line.get_xdata()) for line in (first[1], second[1])] == [10, 8]
    assert second[1].get_ydata()[-1] == close(2 * first[1].get_ydata()[-1])
    assert first[1].get_color() == panels.COLOURS[0] and second[1].get_color() == panels.COLOURS[1]


@pytest.mark.filterwarnings("error:::numpy", "error::RuntimeWarning")
def test_no_light_and_errors_that_are_not_known(filtered):
    dark = filtered.copy(deep=True)
    for name in ("echo", "echo_by_process", "echo_by_order"):
        dark[name] = 0 * dark[name]
    drawing = plot.figure([dark], ["dark"], ["narrow"], names_of(dark))
    drawing.draw_without_rendering()
    assert panels.NO_LIGHT in [text.get_text() for text in drawing.axes[0].texts]
    filtered["echo_standard_error"] = numpy.nan * filtered.echo
    assert numpy.isnan(spectrum.seen(view(filtered), found_in(filtered)).standard_error).all()
    plot.figure([filtered], ["one batch"], ["narrow"], names_of(filtered)).draw_without_rendering()
