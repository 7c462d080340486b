"""Quantities beside echoes, as photic.open gives them."""

import netCDF4
import numpy
import pytest
import xarray

import photic

QUANTITIES = ["irradiance_down", "absorbed", "escaped", "balance", "radiance", "fluence_lamp"]


@pytest.mark.parametrize("name", QUANTITIES)
def test_values_errors_and_flags(sample_with_tallies, name):
    ds = photic.open(sample_with_tallies)
    with netCDF4.Dataset(sample_with_tallies) as file:
        assert numpy.array_equal(ds[name], file[name][...])
        assert numpy.array_equal(ds[name + "_standard_error"], file[name + "_standard_error"][...])
    assert ds[name].attrs["normalisation"] == "per unit irradiance across the beam"
    assert ds[name].attrs["strength_scale"] == 50
    assert ds[name + "_converged"].dtype == bool
    assert numpy.array_equal(ds[name + "_converged"], ds[name + "_convergence_flags"] == 0)


# Seen red: without names of layers.
def test_coordinates(sample_with_tallies):
    ds = photic.open(sample_with_tallies)
    assert ds.absorbed.sel(layer="haze", constituent="aerosol") > 0
    assert ds.absorbed.sel(layer="haze", constituent="water") == 0
    by_depth = ds.irradiance_down.swap_dims(level="level_depth")
    assert by_depth.sel(level_depth=-10) == ds.irradiance_down[0]
    assert ds.escaped.sel(escape_zenith=85) == ds.escaped[8]
    assert list(ds.radiance.direction_zenith) == [0, 30, 180]
    assert "fluence_lamp_radius_bounds" in ds.coords
    assert ds.attrs["source_strength"] == 50 and ds.attrs["source_strength_units"] == "W m-2"


# Seen red: "a result of Photic that lacks 'telescope_name'".
def test_without_echoes(sample_of_tallies):
    ds = photic.open(sample_of_tallies)
    assert not [name for name in ds.variables if "echo" in name or "gate" in name]
    assert ds.balance.dims == ()
    assert not ds.irradiance_down_converged[-1]


# Seen red: with every file that has no echo taken for one of tallies.
def test_a_result_that_lost_its_echoes_is_refused(sample, tmp_path):
    with xarray.open_dataset(sample, engine="netcdf4", decode_timedelta=False) as file:
        file.drop_vars(["echo", "telescope_name"]).to_netcdf(tmp_path / "less.nc")
    with pytest.raises(photic.Error, match="lacks 'telescope_name'"):
        photic.open(tmp_path / "less.nc")
