"""Profiles in netCDF files of other programs than floats': servers, gliders, models, ragged arrays."""

import json
import re

import netCDF4
import numpy as np
import pytest

DEPTHS = np.array([0.0, 2.0, 4.0, 6.0, 8.0])
FLAGS = [1, 1, 4, 1, 1]
QARTOD = {"flag_values": np.array([1, 2, 3, 4, 9], "i1"), "flag_meanings": "PASS NOT_EVALUATED SUSPECT FAIL MISSING"}


def add(file, name, kind, dimensions, values, **attributes):
    variable = file.createVariable(name, kind, dimensions)
    variable.setncatts(attributes)
    variable[:] = values
    return variable


@pytest.fixture
def profile_file(tmp_path):
    """A file that a function fills, after its depths and values."""

    def write(more, values=(0.1, 0.15, 5.0, 0.25, 0.3), depths=DEPTHS, format="NETCDF4"):
        with netCDF4.Dataset(tmp_path / "profile.nc", "w", format=format) as file:
            file.createDimension("obs", len(depths))
            add(file, "depth", "f4", ("obs",), depths, units="m", positive="down")
            add(file, "chl", "f4", ("obs",), values, units="mg m-3")
            more(file)

    return write


@pytest.fixture
def column(photic, scene):
    """The mean chlorophyll of the layer, and the remarks."""
    text = scene.read_text()

    def column(more=""):
        keys = f'{{ file = "profile.nc", depth = "depth", variable = "chl"{more} }}'
        scene.write_text(text.replace("chlorophyll_mg_m3 = 0.1", f"chlorophyll_mg_m3 = {keys}"))
        done = photic("show", "--json", "quick.toml")
        if done.returncode != 0:
            return done.returncode, done.stderr
        layers = json.loads(done.stdout)["sea"]["layer"][:-1]
        tops = [0.0] + [layer["bottom_depth_m"] for layer in layers[:-1]]
        total = sum(layer["chlorophyll_mg_m3"] * (layer["bottom_depth_m"] - top) for layer, top in zip(layers, tops))
        return total / 5, done.stderr

    return column


def lower_case(file):
    add(file, "chl_qc", "i4", ("obs",), FLAGS, long_name="quality flag")


def characters(file):
    add(file, "chl_qc", "S1", ("obs",), np.array([str(x) for x in FLAGS], "S1"))


def listed(file):
    file["chl"].ancillary_variables = "chl_checked"
    add(file, "chl_checked", "i1", ("obs",), FLAGS, standard_name="quality_flag", **QARTOD)


def bits(file):
    file["chl"].ancillary_variables = "tests"
    add(file, "tests", "i2", ("obs",), [0, 1, 257, 1, 1], flag_masks=np.array([1, 256], "i2"),
        flag_meanings="interpolated spike_test_failed")


def letters(file):
    """Codes of characters, as SeaDataNet has them."""
    file["chl"].ancillary_variables = "chl_SEADATANET_QC"
    add(file, "chl_SEADATANET_QC", "i1", ("obs",), [49, 49, 52, 81, 49], flag_values=np.array([49, 52, 81], "i1"),
        flag_meanings="good_value bad_value value_below_limit_of_quantification")


# A value of 5.0 that is flagged. Seen red: with _QC as the only name; with ancillary_variables not looked at.
@pytest.mark.parametrize("flags", [lower_case, characters, listed, bits, letters])
@pytest.mark.parametrize("format", ["NETCDF4", "NETCDF3_CLASSIC"])
def test_flags_of_other_names(profile_file, column, flags, format):
    profile_file(flags, format=format)
    mean, remarks = column()
    z = np.linspace(0, 5, 5001)
    expected = np.trapz(np.interp(z, DEPTHS[[0, 1, 3, 4]], [0.1, 0.15, 0.25, 0.3]), z) / 5
    assert mean == pytest.approx(expected, rel=1e-4)
    assert re.search(r"quick.toml:\d+:21: .*profile.nc: \w+ flags 1 of 5 levels of chl as bad", remarks)
    assert ("count as good: 81" in remarks) == (flags is letters)


# Seen red: without the remark.
def test_flags_that_are_not_understood_are_named(profile_file, column):
    profile_file(lambda file: add(file, "chl_flag", "i1", ("obs",), FLAGS))
    mean, remarks = column()
    assert mean > 1
    assert "profile.nc: chl_flag does not explain its flags: no level is left out by these flags" in remarks


def index(file):
    add(file, "profile_index", "i4", ("obs",), [0] * 5 + [1] * 5)


def cycle(file):
    add(file, "cycle_number", "i4", ("obs",), [57] * 5 + [58] * 5, cf_role="profile_id")


def names(file):
    file.createDimension("length", 4)
    add(file, "station", "S1", ("obs", "length"), netCDF4.stringtochar(np.array(["A1"] * 5 + ["B12"] * 5, "S4")))


def contiguous(file):
    file.createDimension("profile", 2)
    add(file, "rowSize", "i4", ("profile",), [5, 5], sample_dimension="obs")


def indexed(file):
    """A dimension that no variable has."""
    file.createDimension("profile", 2)
    add(file, "parent", "i4", ("obs",), [0] * 5 + [1] * 5, instance_dimension="profile")


def times(file):
    add(file, "time", "f8", ("obs",), [100.0] * 5 + [200.0] * 5, units="s")


# Seen red: with all values taken for one cast, 1.05 throughout.
@pytest.mark.parametrize("casts", [index, cycle, names, contiguous, indexed, times])
@pytest.mark.parametrize("format", ["NETCDF4", "NETCDF3_CLASSIC"])
def test_casts_in_one_dimension(profile_file, column, casts, format):
    profile_file(casts, [0.1] * 5 + [2.0] * 5, [*DEPTHS, *DEPTHS], format)
    status, problem = column()
    assert status == 2
    assert re.search(r"quick.toml:\d+:30: .*profile.nc: chl\(obs\): holds 2 casts, divided by \w+", problem)
    assert "(choose one of them: profile = 0 or 1)" in problem
    assert column(", profile = 0")[0] == pytest.approx(0.1, rel=1e-6)
    assert column(", profile = 1")[0] == pytest.approx(2.0, rel=1e-6)
    status, problem = column(", profile = 2")
    assert (status, "chl(obs): there is no profile 2: it has 2, counted from 0" in problem) == (2, True)


def test_counts_that_do_not_add_up(profile_file, column):
    def wrong(file):
        file.createDimension("profile", 2)
        add(file, "rowSize", "i4", ("profile",), [5, 4], sample_dimension="obs")

    profile_file(wrong, [0.1] * 10, [*DEPTHS, *DEPTHS])
    status, problem = column(", profile = 0")
    assert status == 2
    assert "profile.nc: rowSize: its counts add up to 9, and the dimension obs has 10 values" in problem


# Seen red: with four dimensions refused.
@pytest.mark.parametrize("dimensions", [("time", "depth", "lat", "lon"), ("lat", "depth"), ("depth", "x")])
def test_dimensions_of_length_one(tmp_path, column, dimensions):
    with netCDF4.Dataset(tmp_path / "profile.nc", "w") as file:
        for name in dimensions:
            file.createDimension(name, 5 if name == "depth" else 1)
        add(file, "depth", "f4", ("depth",), DEPTHS, units="m")
        values = np.linspace(0.1, 0.3, 5).reshape([5 if name == "depth" else 1 for name in dimensions])
        add(file, "chl", "f4", dimensions, values, units="mg m-3")
        if len(dimensions) == 4:
            add(file, "chl_qc", "i1", ("time", "depth"), np.array([[1, 4, 1, 1, 1]]))
    mean, remarks = column()
    assert mean == pytest.approx(0.1 + 0.2 * 2.5 / 8, rel=1e-5)
    assert ("chl_qc flags 1 of 5 levels" in remarks) == (len(dimensions) == 4)
