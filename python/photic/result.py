"""Reading result files."""

from __future__ import annotations

import numbers
import os
import tomllib
from typing import Any

import xarray
from xarray.backends.netCDF4_ import NETCDF4_PYTHON_LOCK

from photic.core import core, is_there
from photic.errors import Error, SceneError
from photic.locks import netcdf_lock
from photic.names import file_name

FORMAT = 3  # the newest layout this package reads


def open(path: str | os.PathLike[str]) -> xarray.Dataset:
    """Returns the result in a netCDF file as an xarray.Dataset, in memory; the file is closed again.

    Dimensions: telescope, channel and process (indexed by name), order (0, 1, … and above), gate,
    depth (of the last scattering) [m], unless the scene left it out. Coordinates: gate_time [ns],
    gate_depth [m] of each telescope and channel, channel_wavelength [nm], and the bounds of gates.
    Variables: echo, echo_by_process, echo_by_order, echo_by_depth, each with _standard_error, and
    converged (bool), convergence_flags
    with their meanings, the same of parts as echo_by_process_converged, echo_by_order_converged and
    their _convergence_flags, … If the scene has environments: the dimension environment (indexed by name),
    environment_echo and environment_difference (from echo), with _standard_error, and
    environment_converged. If environments set numbers: the dimension environment_path (indexed by path),
    environment_value, and for each path a coordinate of that name along environment, so that
    swap_dims(environment="sea.layer.0.chlorophyll_mg_m3") puts values in place of names. If it has sensitivities: the dimension parameter (indexed by path), with
    parameter_value, sensitivity and logarithmic_sensitivity, with _standard_error, and
    sensitivity_converged. By groups of batches, for photic.error_of: the dimension batch_group,
    echo_by_group, group_photons and environment_echo_by_group, unless the scene leaves them out. Over a
    film of oil: film_attenuation [1/m] and film_interface_ratio, which
    oil_thickness uses. Attributes: the run, and the scene as text.

    If the scene has tallies, there are their quantities, each with _standard_error, _converged and
    _convergence_flags, and the attributes units and normalisation, and strength_scale and
    strength_units if the source has a strength: value * value.attrs["strength_scale"] is in these.
    irradiance_down, irradiance_up, scalar_irradiance_down and scalar_irradiance_up have the dimension
    level (coordinate level_depth [m], negative in the air); radiance has direction (direction_zenith and
    direction_azimuth [degree], where the light travels) and radiance_level; absorbed has layer and
    constituent (indexed by name); escaped has escape_zenith [degree]; fluence, or fluence_NAME, has
    fluence_depth and fluence_radius or fluence_x [m]. Numbers: reflected_by_surface, left_water,
    absorbed_by_bottom, absorbed_by_film, absorbed_by_ground and balance. Without telescopes there is
    nothing about echoes.

    What `photic optics` wrote is opened too. Dimensions: depth (the layers' upper edges) [m],
    wavelength [nm], angle [degree], process (indexed by name), emission_line. Variables: a_per_m,
    b_per_m, c_per_m, bb_per_m, albedo, mean_cosine, phase_function_per_sr, those of constituents
    (a_water_per_m …), emission_per_m, emission_line_per_m; the attribute photic_content is "optics".
    Layers of air have altitude (their lower edges) [m] in place of depth, refractive_index, and
    emit nothing. Spectra of an oil and transmittances have only the dimension wavelength;
    photic_content is then "spectra".

    Any number of threads may call it, beside runs of this package, too; photic.netcdf_lock is for others.
    Raises photic.Error if there is no such file or it was not written by Photic. Source: docs/guide.md,
    "Results".
    """
    path = os.fsdecode(file_name("path", path))
    dataset = _load(path)
    if "photic_format" not in dataset.attrs:
        raise Error(
            f"{path}: a netCDF file, but not a result of Photic: it has no attribute photic_format"
        )
    is_number = isinstance(dataset.attrs["photic_format"], numbers.Real)
    if not is_number:
        raise Error(f"{path}: a damaged result: its photic_format is no number")
    if dataset.attrs["photic_format"] > FORMAT:
        raise Error(
            f"{path}: written by a newer Photic (result format {dataset.attrs['photic_format']}; "
            f"this package reads up to {FORMAT})"
        )
    if is_optics(dataset) or is_spectra(dataset):
        return _indexed(dataset)
    try:
        return _named(dataset)
    except KeyError as error:
        raise Error(f"{path}: a result of Photic that lacks {error}") from error
    except (AttributeError, IndexError, TypeError, ValueError) as error:
        raise Error(f"{path}: a damaged result of Photic: {error}") from error


def of_arrays(arrays: dict[str, Any]) -> xarray.Dataset:
    """The result in arrays of the module _core: the same as photic.open of its file."""
    return _named(_decoded(arrays))


def optics_of_arrays(arrays: dict[str, Any]) -> xarray.Dataset:
    """The optics in arrays of the module _core: the same as photic.open of their file."""
    return _indexed(_decoded(arrays))


def _decoded(arrays):
    dataset = xarray.Dataset(arrays["variables"], attrs=arrays["attributes"])
    return xarray.decode_cf(dataset, decode_timedelta=False).load()


def scene_of(result):
    """The scene of a result, every default in it, as dicts and lists."""
    return tomllib.loads(result.attrs["scene"])


def tallies(dataset):
    """The names of the quantities tallied beside echoes."""
    named = [name for name, each in dataset.data_vars.items() if "normalisation" in each.attrs]
    return [name for name in named if name + "_standard_error" in dataset]


def has_echoes(dataset):
    """Returns whether a result has echoes, as all have but those of scenes with tallies alone."""
    return "echo" in dataset or not tallies(dataset)


def _named(dataset):
    """Echoes by the names of telescopes, channels and processes, and tallies by those of layers."""
    named = [axis for axis in dataset.dims if axis + "_name" in dataset]
    of_echoes = ["telescope", "channel", "process"] if has_echoes(dataset) else []
    for axis in dict.fromkeys([*of_echoes, *named]):
        if axis + "_name" not in dataset and axis in dataset.coords:
            continue  # a dataset of this function, written by xarray
        names = dataset[axis + "_name"]
        dataset = dataset.assign_coords({axis: (axis, names.values.astype(str), names.attrs)})
        dataset = dataset.drop_vars(axis + "_name")
    parts = [name for name in dataset.data_vars if name.endswith("_converged")]
    for name in ["converged", *parts] if of_echoes else parts:
        # With bytes, ~ds.converged would be true everywhere.
        converged = dataset[name].astype(bool)
        converged.attrs = {"long_name": dataset[name].attrs["long_name"]}
        dataset[name] = converged
    if "environment_path" in dataset.dims:
        for one in dataset.environment_value.transpose("environment_path", ...):
            path = str(one.environment_path.values)
            dataset = dataset.assign_coords({path: ("environment", one.values, {"long_name": path})})
    for each in dataset.variables.values():
        # They name what has another name now; xarray writes its own.
        each.encoding.pop("coordinates", None)
    return dataset.set_coords([name for name in dataset.data_vars if name.endswith("_bounds")])


def is_optics(dataset):
    """Returns whether a dataset holds the optics of layers, and no echoes."""
    return dataset.attrs.get("photic_content") == "optics"


def is_spectra(dataset):
    """Returns whether a dataset holds spectra of an oil or transmittances of air."""
    return dataset.attrs.get("photic_content") == "spectra"


def _indexed(dataset):
    """Optics by depth or altitude, wavelength, angle and the names of processes."""
    names = {"depth": "depth_m", "altitude": "altitude_m", "wavelength": "wavelength_nm"}
    for axis, name in (names | {"angle": "angle_deg", "process": "process_name"}).items():
        if name not in dataset:
            continue
        values = dataset[name]
        values = values.astype(str) if values.dtype == object else values
        dataset = dataset.assign_coords({axis: (axis, values.values, dataset[name].attrs)})
        dataset = dataset.drop_vars(name)
    bounds = [name for name in ("depth_m_bounds", "altitude_m_bounds") if name in dataset]
    return dataset.set_coords(bounds)


def _expect_netcdf(path):
    """Raises photic.Error for what the library does not open: HDF5 may crash where xarray does."""
    if not is_there():
        return
    try:
        core().expect_netcdf(os.fsencode(path), False)
    except SceneError:
        raise _damaged(path) from None


def _load(path):
    if not os.path.isfile(path):
        raise Error(f"{path}: is a directory" if os.path.isdir(path) else f"{path}: no such file")
    _expect_netcdf(path)
    try:
        # Not with xarray's lock for each array: it is held already, and bears no second time.
        options = {"engine": "netcdf4", "decode_timedelta": False, "lock": False}
        with netcdf_lock, NETCDF4_PYTHON_LOCK, xarray.open_dataset(path, **options) as file:
            return file.load()
    except Error:
        raise
    except PermissionError as error:
        raise Error(f"{path}: {error.strerror}", exit_code=1) from error
    except Exception as error:  # of a damaged file it may be any
        raise _damaged(path) from error


def _damaged(path):
    return Error(f"{path}: not a netCDF file, or a damaged one (results end in .nc)")
