"""The picture of films of oil, and the numbers on them in the guide."""

import sys

import numpy
from look import WIDTH, emptied
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from results import run

import photic
from photic import panels

THICKNESSES = (0.1, 0.2, 0.5, 1, 2, 5, 10)  # um
OILS = {"weakly-absorbing-crude": panels.COLOURS[4], "strongly-absorbing-crude": panels.COLOURS[2]}
PHOTONS = 2e6
FILTERS = {"below": 386, "filter": 404, "above": 422}  # the Raman line lies in the middle one
CHANNELS = [{"name": "raman", "process": "raman"}]
CHANNELS += [{"name": name, "centre_nm": centre, "fwhm_nm": 14} for name, centre in FILTERS.items()]
GATES = {"depth_min_m": -1.0, "depth_max_m": 5.0, "depth_step_m": 6.0}  # one, with all the light
OFFSET = 0.01  # of the clean sea's echo, which a receiver might not get rid of


def _over_oil(seed, **changes):
    changes |= {"channel": CHANNELS, "gates": GATES}
    return run("oil-spill.toml", PHOTONS, "forward", slice(None), seed, **changes)


def _under(result, thickness):
    """The result with the echo of that environment, and its error, in the place of the scene's."""
    one = result.sel(environment=_name(thickness))
    return result.assign(echo=one.environment_echo, echo_standard_error=one.environment_echo_standard_error)


def _name(thickness):
    return f"{thickness} um"


def _runs():
    """The clean sea, and for each oil a run whose environments are films of it. They have no photons
    in common with the clean sea, as two places have none."""
    films = [{"name": _name(d), "set": {"oil.thickness_um": d}} for d in THICKNESSES]
    films.append({"name": "clean", "set": {"oil.thickness_um": 0}})
    changes = {"environment": films}
    clean = _over_oil(1, **{"oil.thickness_um": 0.0})
    return clean, {oil: _over_oil(2 + k, **{"oil.class": oil}, **changes) for k, oil in enumerate(OILS)}


def oil():
    clean, runs = _runs()
    drawing = Figure(figsize=(WIDTH, 4.4), layout="constrained")
    left, right = drawing.subplots(1, 2)
    right.plot([0.05, 20], [0.05, 20], color="0.5", linewidth=0.9, linestyle="--")
    for (name, result), colour in zip(runs.items(), OILS.values()):
        _print(name, result, clean)
        _missing(left, name, result, clean, colour)
        for formula, look in (("paper", {"markerfacecolor": "white"}), ("interfaces", {})):
            found = [_found(result, clean, d, formula=formula) for d in THICKNESSES]
            values = [float(one.thickness) for one in found]
            errors = [float(one.thickness_standard_error) for one in found]
            right.errorbar(THICKNESSES, values, errors, color=colour, **_marks(), **look)
    left.set(xscale="log", ylim=(0, 1.05), ylabel="relative to the clean sea", title="Raman light through a film")
    right.set(xscale="log", yscale="log", xlim=(0.07, 14), ylim=(0.03, 20))
    right.set(ylabel="thickness found [um]", title="Thickness from the missing light")
    handles = [Line2D([], [], color="0.3", label="with the interfaces", **_marks())]
    handles.append(Line2D([], [], color="0.3", markerfacecolor="white", label="without (the paper's)", **_marks()))
    left.legend(fontsize=8, loc="lower left")
    right.legend(handles=handles, fontsize=8, loc="upper left")
    for panel in (left, right):
        panel.set_xlabel("thickness of the film [um]")
        panel.xaxis.set_major_formatter("{x:g}")
        emptied(panel)
    right.yaxis.set_major_formatter("{x:g}")
    return drawing


def _found(result, clean, thickness, **options):
    return photic.oil_thickness(result, clean, environment=_name(thickness), **options)


def _marks():
    return {"linestyle": "none", "marker": "o", "markersize": 5}


def _missing(panel, name, result, clean, colour):
    """Raman light over that of the clean sea: points, and the formula as a line."""
    water = clean.sel(channel="raman")
    parts = [_under(result, d).sel(channel="raman") for d in THICKNESSES]
    values = [float(part.echo / water.echo) for part in parts]
    relative = [float(numpy.hypot(*(one.echo_standard_error / one.echo for one in (part, water)))) for part in parts]
    errors = numpy.multiply(values, relative)
    panel.errorbar(THICKNESSES, values, errors, color=colour, label=name, **_marks())
    d = numpy.geomspace(0.07, 14, 100)
    panel.plot(d, _formula(result, d), color=colour, linewidth=1.2)


def _formula(result, thickness):
    """The share of the Raman light that the film lets pass: eq. 97 of docs/theory.md."""
    of = result.sel(channel="raman").squeeze()
    return float(of.film_interface_ratio) * numpy.exp(-1e-6 * thickness * float(of.film_attenuation))


def _print(name, result, clean):
    """The numbers in the guide."""
    of = result.sel(channel="raman").squeeze()
    _say(f"{name}: {float(of.film_attenuation):.4g} 1/m, interfaces {float(of.film_interface_ratio):.4f}")
    same = photic.oil_thickness(result, "clean")
    _say(f"  1 um, the same photons: {float(same.thickness):.4f} +- {float(same.thickness_standard_error):.4f} um")
    _say("  [um]  E/W   formula  found +- error       without interfaces  filter  less neighbours  offset")
    for d in THICKNESSES:
        film = _under(result, d)
        e, w = (one.echo.squeeze() for one in (film, clean))
        with_, without = (_found(result, clean, d, formula=each) for each in ("interfaces", "paper"))
        seen = _found(result, clean, d, channel="filter")
        alone = [one.sel(channel="filter") - one.sel(channel=["below", "above"]).mean("channel") for one in (e, w)]
        um = 1e6 / float(of.film_attenuation)
        ratio = float(of.film_interface_ratio)
        left = float(e.sel(channel="raman") / w.sel(channel="raman"))
        _say(
            f"  {d:4}  {left:.4f} {_formula(result, d):.4f}  {float(with_.thickness):.4f} +- "
            f"{float(with_.thickness_standard_error):.4f} ({bool(with_.reliable)})  {float(without.thickness):.4f}"
            f"  {float(seen.thickness):.3f}  {um * numpy.log(ratio * float(alone[1] / alone[0])):.3f}"
            f"  {um * numpy.log(ratio / (left + OFFSET)):.3f}"
        )


def _say(words):
    print(words, file=sys.stderr)
