"""The functions of `photic analyse`: what each takes, and its numbers in blocks by telescope."""

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from typing import Any

import numpy
import xarray

from photic.attenuation import LARGEST_ERROR, k_lidar
from photic.errors import Error
from photic.first_order import lidar_equation, overlap
from photic.fits import linear_fit
from photic.names import chosen, listed, suggestion
from photic.oil import oil_thickness
from photic.penetration import z90
from photic.range_correction import range_corrected
from photic.ratios import ratio
from photic.result import has_echoes, is_optics, is_spectra
from photic.result import open as open_result
from photic.scene import Scene


@dataclass(frozen=True)
class Column:
    """Numbers of one kind, a row for each, or one alone: all arrays have the same form."""

    label: str  # "raman", or the name of an environment
    quantity: str  # the variable of the dataset
    meaning: str
    units: str
    values: Any
    errors: Any = None  # None: exact
    reliable: Any = None
    channel: str = ""
    environment: str = ""
    span: tuple = ()  # of a number: the first and the last place that it is of


@dataclass(frozen=True)
class Block:
    """The numbers of one telescope."""

    telescope: str
    place: str = ""  # what rows are by: "depth [m]"
    places: Any = ()
    environments: tuple = ()  # of rows; empty: they are gates
    columns: tuple = ()
    numbers: tuple = ()  # of no row


@dataclass(frozen=True)
class Analysis:
    """The findings of a function."""

    dataset: xarray.Dataset
    blocks: list
    notes: list = field(default_factory=list)


@dataclass(frozen=True)
class Function:
    """A function of a result, or (of_scene) of its scene, and the options that belong to it."""

    find: Callable
    options: tuple
    title: str
    of_scene: bool = False


def analysed(path, name, options):
    """The analysis, and the dataset or the scene that it is of.

    options  texts by the names of the flags: lists of telescope, channel and environment; None where they are
             not given

    Raises photic.Error, with the file in its message.
    """
    function = function_named(name)
    for flag, given in options.items():
        if given is not None and given != [] and flag not in function.options:
            has = ", ".join(f"--{each}" for each in function.options)
            raise Error(f"--{flag} does not belong to {name}, whose options are {has}")
    options = _read(options)
    subject = _subject(path, name, function.of_scene)
    try:
        return function.find(subject, options), subject
    except Error as error:
        if type(error) is not Error:
            raise
        raise Error(f"{path}: {str(error).removeprefix('result: ')}", exit_code=error.exit_code) from error


def _read(options):
    """The options with numbers, and with the other result, in the place of texts; each name once."""
    depths, share, clean = (options[name] for name in ("depths", "share", "clean"))
    return options | {
        "environment": list(dict.fromkeys(options["environment"])),
        "depths": None if depths is None else tuple(_number("depths", each) for each in depths),
        "share": None if share is None else _number("share", share),
        "clean": open_result(clean) if clean is not None and clean.lower().endswith(".nc") else clean,
    }


def function_named(name):
    if name not in FUNCTIONS:
        raise Error(f"there is no function {name!r}{suggestion(name, list(FUNCTIONS))}")
    return FUNCTIONS[name]


def _subject(path, name, of_scene):
    if path.lower().endswith(".toml"):
        if of_scene:
            return Scene.load(path)
        raise Error(f"{path}: a scene, and {name} takes the result of a run: photic run {path}")
    result = open_result(path)
    if is_optics(result) or is_spectra(result) or not has_echoes(result):
        raise Error(f"{path}: holds no echoes: take the result of a run with telescopes")
    return Scene(result.attrs["scene"]) if of_scene else result


def _range_corrected(result, options):
    result = _telescopes(result, options)
    found = _channels(range_corrected(result), options)
    return Analysis(found, [_by_channel(found, t, "range_corrected") for t in range(found.sizes["telescope"])])


def _of_scene(function, name):
    def find(scene, options):
        found = _channels(_telescopes(function(scene), options), options)
        return Analysis(found, [_by_channel(found, t, name) for t in range(found.sizes["telescope"])])

    return find


def _k_lidar(result, options):
    result, channel = _telescopes(result, options), _one_channel(result, "k-lidar", options)
    found = _in_waters(result, options, lambda water: k_lidar(result, channel, depths=options["depths"], environment=water))
    gate_depth = result.gate_depth.sel(channel=channel, drop=True)
    blocks, notes = [], []
    for t, telescope in enumerate(_names(result.telescope)):
        one = found.isel(telescope=t)
        depth, fits = gate_depth.isel(telescope=t).values, []
        for fit, gates in zip(_by_water(one, "k_fitted", channel), _each_water(one, "k_fitted_gate")):
            span = depth[gates.values].min(), depth[gates.values].max()
            where = f"telescope {telescope}" + (f", {fit.environment}" if fit.environment else "")
            notes.append(f"{where}: {_gates_of_fit(gates.values, depth, span)}")
            fits.append(replace(fit, span=span))
        blocks.append(Block(telescope, "depth [m]", one.depth.values, columns=_by_water(one, "k", channel), numbers=tuple(fits)))
    return Analysis(found, blocks, notes)


def _gates_of_fit(taken, depth, span):
    """A line on the gates of a fit."""
    first, last = span
    within = (depth >= first) & (depth <= last) & ~taken
    line = f"fitted through {taken.sum()} gates from {first:.2f} to {last:.2f} m"
    if within.any():
        line += f", less those at {listed([f'{each:.2f}' for each in depth[within]])} m"
    return line + f" (errors of echoes below {100 * LARGEST_ERROR:g} %)"


def _z90(result, options):
    result = _telescopes(result, options)
    channel = _one_channel(result, "z90", options)
    found = _depths_in_waters(result, channel, options)
    numbers = [_by_water(found.isel(telescope=t), "z90", channel) for t in range(found.sizes["telescope"])]
    return Analysis(found, [Block(name, numbers=each) for name, each in zip(_names(found.telescope), numbers)])


def _depths_in_waters(result, channel, options):
    share = {} if options["share"] is None else {"share": options["share"]}
    return _in_waters(result, options, lambda water: z90(result, channel, environment=water, **share))


def _ratio(result, options):
    result = _telescopes(result, options)
    chosen_ones = {key: options[key] for key in ("of", "over", "reference") if options[key] is not None}
    found = ratio(result, environment=options["environment"] or None, **chosen_ones)
    above = result.sel(channel=options["of"] or "chlorophyll")
    blocks = []
    for t, telescope in enumerate(_names(result.telescope)):
        one, (place, places) = found.isel(telescope=t), _places(above.isel(telescope=t))
        sums = _by_water(one, "ratio_of_sums")
        blocks.append(Block(telescope, place, places, columns=_by_water(one, "ratio"), numbers=sums))
    return Analysis(found, blocks)


def _oil_thickness(result, options):
    if options["clean"] is None:
        raise Error("oil-thickness takes --clean NAME, an environment without the film, or --clean RESULT.nc of another run")
    channel = {"channel": _one_channel(result, "oil-thickness", options)} if options["channel"] else {}
    formula = {"formula": options["formula"]} if options["formula"] is not None else {}
    found = _telescopes(oil_thickness(result, options["clean"], **channel, **formula), options)
    blocks = []
    for t, telescope in enumerate(_names(found.telescope)):
        one = found.isel(telescope=t)
        place, places = _places(one)
        column = _column(one, "thickness", "thickness", channel=str(found.channel.values))
        blocks.append(Block(telescope, place, places, columns=(column,)))
    return Analysis(found, blocks)


def _linear_fit(result, options):
    result = _telescopes(result, options)
    path = _path(result, options)
    waters = _waters_with(result, path, options)
    name, values = _fitted_values(result, options | {"environment": waters})
    values = values.assign_coords({path: ("environment", result[path].sel(environment=waters).values, {"long_name": path})})
    places = values[path].values
    fits = [linear_fit(places, values.isel(telescope=t), name) for t in range(values.sizes["telescope"])]
    found = values.drop_vars("reliable").merge(xarray.concat(fits, dim="telescope"), compat="override")
    found = found.assign({f"{name}_reliable": values[f"{name}_reliable"] if f"{name}_reliable" in values else values.reliable})
    of = {"channel": options["channel"][0]} if options["channel"] else {}
    blocks = [_fit_of(found.isel(telescope=t), name, path, of) for t in range(found.sizes["telescope"])]
    return Analysis(found, blocks, _other_paths(result, path, waters))


def _fit_of(one, name, path, of):
    columns = (_column(one, name, name.replace("_", " "), **of), _column(one, "residual", "residual", exact=True))
    numbers = [_column(one, "slope", "slope"), _column(one, "offset", "offset")]
    numbers += [_column(one, each, each.replace("_", " "), exact=True) for each in ("r_squared", "chi_squared", "degrees_of_freedom")]
    return Block(str(one.telescope.values), path, one[path].values, tuple(_names(one.environment)), columns, tuple(numbers))


def _fitted_values(result, options):
    """Ratios of sums, or depths of a share, by environment and telescope."""
    if not options["channel"]:
        if options["share"] is not None:
            raise Error("linear-fit: --share without --channel: give both for a line through depths as z90 finds them")
        chosen_ones = {key: options[key] for key in ("of", "over", "reference") if options[key] is not None}
        return "ratio_of_sums", ratio(result, environment=options["environment"], **chosen_ones)
    for flag in ("of", "over", "reference"):
        if options[flag] is not None:
            raise Error(f"linear-fit: --channel and --{flag} exclude each other: a line through depths, or through ratios")
    return "z90", _depths_in_waters(result, _one_channel(result, "linear-fit", options), options)


def _path(result, options):
    """The path of the number that environments set, which the line is against."""
    known = _names(result.environment_path) if "environment_path" in result.dims else []
    if not known:
        raise Error("linear-fit: no environments that set numbers: add [[environment]] or [environment_grid] to the scene")
    wanted = options["against"]
    if wanted is None and len(known) == 1:
        return known[0]
    if wanted is None:
        raise Error(f"linear-fit takes --against PATH, one of the numbers that environments set: {listed(known)}")
    if wanted not in known:
        raise Error(f"no environment sets {wanted!r}{suggestion(wanted, known)}")
    return wanted


def _waters_with(result, path, options):
    """The environments that set the number, or those of them that are chosen."""
    if options["environment"]:
        names = chosen([result], ["result"], "environment", options["environment"])
    else:
        names = _names(result.environment)
    values = {name: float(result[path].sel(environment=name)) for name in names}
    unset = [name for name, value in values.items() if numpy.isnan(value)]
    if options["environment"] and unset:
        raise Error(f"environment {unset[0]!r} does not set {path} to a number")
    return [name for name in names if name not in unset]


def _other_paths(result, path, waters):
    """A note on what else differs between the environments."""
    others = [each for each in _names(result.environment_path) if each != path]
    differ = [each for each in others if len(numpy.unique(result[each].sel(environment=waters).values)) > 1]
    return [f"The environments differ in {listed(differ)}, too (--environment NAME chooses some)"] if differ else []


FUNCTIONS = {
    "range-corrected": Function(_range_corrected, ("telescope", "channel"), "Range-corrected echo"),
    "k-lidar": Function(_k_lidar, ("telescope", "channel", "environment", "depths"), "Lidar attenuation coefficient"),
    "z90": Function(_z90, ("telescope", "channel", "environment", "share"), "Depth of the light"),
    "ratio": Function(_ratio, ("telescope", "environment", "of", "over", "reference"), "Ratio of echoes"),
    "oil-thickness": Function(_oil_thickness, ("telescope", "channel", "clean", "formula"), "Thickness of the film of oil"),
    "linear-fit": Function(
        _linear_fit,
        ("telescope", "channel", "environment", "of", "over", "reference", "share", "against"),
        "Straight line through environments",
    ),
    "overlap": Function(_of_scene(overlap, "overlap"), ("telescope", "channel"), "Overlap of laser and telescope", True),
    "lidar-equation": Function(_of_scene(lidar_equation, "echo"), ("telescope", "channel"), "Echo of light scattered once", True),
}


def _telescopes(dataset, options):
    names = options["telescope"]
    return dataset.sel(telescope=chosen([dataset], ["result"], "telescope", names)) if names else dataset


def _channels(dataset, options):
    names = options["channel"]
    return dataset.sel(channel=chosen([dataset], ["result"], "channel", names)) if names else dataset


def _one_channel(result, function, options):
    if len(options["channel"]) != 1:
        raise Error(f"{function} takes one --channel NAME; there are: {listed(_names(result.channel))}")
    return chosen([result], ["result"], "channel", options["channel"])[0]


def _number(flag, text):
    try:
        return float(text)
    except ValueError:
        example = "0 20" if flag == "depths" else "0.9"
        raise Error(f"--{flag}: {text!r} is not a number (write --{flag} {example})") from None


def _in_waters(result, options, function):
    """The datasets of a function of an environment's name, on one more axis, or that of the scene itself."""
    names = options["environment"]
    if not names:
        return function(None)
    return xarray.concat([function(name) for name in names], dim=xarray.DataArray(names, dims="environment", name="environment"))


def _names(axis):
    return [str(each) for each in numpy.atleast_1d(axis.values)]


def _by_channel(found, telescope, name):
    one = found.isel(telescope=telescope)
    place, places = _places(one.isel(channel=0))
    columns = tuple(_column(one.sel(channel=each), name, each, channel=each) for each in _names(one.channel))
    return Block(str(one.telescope.values), place, places, columns=columns)


def _each_water(one, name):
    """A variable in each environment, or the scene's alone."""
    return [one[name].sel(environment=each) for each in _names(one.environment)] if "environment" in one[name].dims else [one[name]]


def _by_water(one, name, channel=""):
    if "environment" not in one[name].dims:
        return (_column(one, name, channel or name.replace("_", " "), channel=channel),)
    names = _names(one.environment)
    return tuple(_column(one.sel(environment=each), name, each, channel=channel, environment=each) for each in names)


def _column(one, name, label, *, exact=False, **of):
    variable = one[name]
    errors = None if exact or f"{name}_standard_error" not in one else one[f"{name}_standard_error"].values
    flags = one[f"{name}_reliable"] if f"{name}_reliable" in one else one.get("reliable")
    reliable = None if errors is None or flags is None else flags.values
    meaning, units = variable.attrs.get("long_name", ""), str(variable.attrs.get("units", ""))
    return Column(label, name, meaning, units, variable.values, errors, reliable, **of)


def _places(one):
    """The quantity that rows are by, and the centres of gates: times where the telescope has no depths."""
    depth = one.gate_depth
    if bool(depth.isnull().any()):
        return "time [ns]", one.gate_time.values
    return ("depth [m]" if depth.attrs.get("standard_name") == "depth" else "range [m]"), depth.values


def scene_text(subject):
    """The scene that the numbers are of, as TOML."""
    return subject.toml() if isinstance(subject, Scene) else subject.attrs["scene"]
