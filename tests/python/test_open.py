import os
import subprocess

import netCDF4
import numpy
import pytest
import xarray
from conftest import made
from test_run import SCENE

import photic


def test_names_are_indices(sample):
    ds = photic.open(sample)
    assert list(ds.telescope.values) == ["narrow", "wide"]
    assert list(ds.channel.values) == ["elastic", "raman", "chlorophyll"]
    assert list(ds.process.values) == ["elastic", "raman", "chlorophyll"]
    with netCDF4.Dataset(sample) as file:
        raman = file["echo"][1, 1, :]
        by_process = file["echo_by_process"][0, 2, 2, :]
    assert numpy.array_equal(ds.echo.sel(telescope="wide", channel="raman"), raman)
    narrow = ds.echo_by_process.sel(telescope="narrow")
    assert numpy.array_equal(narrow.sel(channel="chlorophyll", process="chlorophyll"), by_process)
    with pytest.raises(KeyError):
        ds.echo.sel(channel="green")


def test_coordinates(sample):
    ds = photic.open(sample)
    assert list(ds.order.values) == [0, 1, 2, 3, 4, 5, 6]
    echo = ds.echo.sel(telescope="narrow", channel="raman")
    assert echo.gate_depth.dims == ("gate",)
    assert echo.gate_depth.values[0] == pytest.approx(1.004 * 0.25, rel=1e-12)
    bounds = ds.gate_depth_bounds.sel(channel="raman")
    assert bounds.sel(telescope="narrow").values[0] == pytest.approx([0, 1.004 * 0.5])
    assert bounds.sel(telescope="wide").values[0] == pytest.approx([-1.004 * 2, -1.004 * 1.5])
    # Numbers of ns, not timedeltas.
    assert ds.gate_time.dtype == float and ds.gate_time.attrs["units"] == "ns"
    assert echo.channel_wavelength == 649.8


def test_what_a_run_goes_on_from_is_not_shown(sample):
    with netCDF4.Dataset(sample) as file:
        assert list(file.groups) == ["continuation"]
    ds = photic.open(sample)
    axes = {"telescope", "channel", "process", "order", "gate", "depth", "bnds", "batch_group"}
    assert set(ds.sizes) == axes
    assert not [name for name in ds.variables if "sums" in name]


# Seen red: left as bytes, where ~ gives -1 and -2, both true.
def test_converged_is_bool(sample):
    ds = photic.open(sample)
    assert ds.converged.dtype == bool
    assert numpy.array_equal(ds.converged, ds.convergence_flags == 0)
    elastic = ds.sel(telescope="narrow", channel="elastic")
    assert 0 < int((~elastic.converged).sum()) < elastic.sizes["gate"]


# Seen red: left as bytes; in results without them, as earlier programs wrote, without a look for them.
def test_parts_have_flags_of_their_own(sample, tmp_path):
    ds = photic.open(sample)
    for part in ("echo_by_process", "echo_by_order"):
        flags = ds[f"{part}_convergence_flags"]
        assert ds[f"{part}_converged"].dtype == bool
        assert flags.dims == ds[part].dims
        assert numpy.array_equal(ds[f"{part}_converged"], flags == 0)
        assert numpy.array_equal(flags == 1, ds[part] == 0)
    raman = ds.echo_by_process_converged.sel(telescope="wide", channel="raman")
    assert raman.sel(process="raman").any() and not raman.sel(process="elastic").any()
    with xarray.open_dataset(sample, decode_timedelta=False) as file:
        earlier = file.drop_vars([name for name in file if name.startswith("echo_by") and "converge" in name])
        earlier.to_netcdf(tmp_path / "earlier.nc")
    assert "echo_by_order_converged" not in photic.open(tmp_path / "earlier.nc")


# Seen red: with environments left under their numbers; with their convergence left as bytes.
def test_environments_go_by_their_names(sample, sample_in_other_water):
    ds = photic.open(sample_in_other_water)
    assert list(ds.environment.values) == ["more algae", "no $ _CDOM_", "bloom"]
    bloom = ds.environment_echo.sel(environment="bloom", channel="raman", telescope="wide")
    with netCDF4.Dataset(sample_in_other_water) as file:
        assert numpy.array_equal(bloom, file["environment_echo"][2, 1, 1, :])
    assert ds.environment_converged.dtype == bool
    assert numpy.array_equal(ds.environment_converged, ds.environment_convergence_flags == 0)
    change = ds.environment_echo - ds.echo
    assert numpy.allclose(change, ds.environment_difference, rtol=1e-9, atol=0)
    assert not [name for name in photic.open(sample).variables if "environment" in name]


CHLOROPHYLL, CDOM = "sea.layer.0.chlorophyll_mg_m3", "sea.layer.0.cdom_a440_per_m"


# Seen red: with the paths left under their numbers; with the values of the first path for both.
def test_environments_go_by_their_values(sample, sample_in_other_water):
    ds = photic.open(sample_in_other_water)
    assert list(ds.environment_path.values) == [CHLOROPHYLL, CDOM]
    assert ds.environment_value.dims == ("environment", "environment_path")
    assert list(ds.environment_value.sel(environment_path=CHLOROPHYLL)) == pytest.approx([0.1, 0.2, 0.3])
    assert {CHLOROPHYLL, CDOM} <= set(ds.coords) and ds[CDOM].dims == ("environment",)
    assert numpy.array_equal(ds[CDOM], [numpy.nan, 0.01, 0.02 / 3], equal_nan=True)
    one = ds.environment_echo.swap_dims(environment=CHLOROPHYLL).sel({CHLOROPHYLL: 0.2}, method="nearest")
    assert numpy.array_equal(one, ds.environment_echo.sel(environment="no $ _CDOM_"))
    assert not [name for name in photic.open(sample).variables if "path" in name or name.startswith("sea.")]


# Seen red: with parameters left under their numbers; with their convergence left as bytes.
def test_parameters_go_by_their_paths(sample, sample_with_parameters):
    ds = photic.open(sample_with_parameters)
    paths = ["sea.layer.0.chlorophyll_mg_m3", "sea.$_x_"]
    assert list(ds.parameter.values) == paths and list(ds.environment.values) == ["bloom"]
    assert list(ds.parameter_value.values) == [0.1, 0.2]
    one = ds.sensitivity.sel(parameter="sea.$_x_", channel="raman", telescope="wide")
    assert float(one.parameter_value) == 0.2
    with netCDF4.Dataset(sample_with_parameters) as file:
        assert numpy.array_equal(one, file["sensitivity"][1, 1, 1, :])
    assert ds.sensitivity_converged.dtype == bool
    assert numpy.array_equal(ds.sensitivity_converged, ds.sensitivity_convergence_flags == 0)
    lit = ds.echo > 0
    again = (ds.sensitivity * ds.parameter_value / ds.echo).where(lit)
    assert numpy.allclose(again, ds.logarithmic_sensitivity, rtol=1e-12, equal_nan=True)
    names = [name for name in photic.open(sample).variables if "sensitivity" in name or "parameter" in name]
    assert not names


def test_missing_numbers_are_nan(sample):
    ds = photic.open(sample)
    assert numpy.isnan(ds.variance_of_variance.values[0, 0, -1])
    assert not numpy.isnan(ds.echo.values).any()


def test_attributes(sample):
    ds = photic.open(sample)
    assert ds.attrs["photons"] == 20_000_000
    assert ds.attrs["scene"].startswith("title = ")
    assert ds.attrs["warnings"].startswith("3 photons were lost")


def test_the_file_is_closed(sample, tmp_path):
    path = tmp_path / "out.nc"
    path.write_bytes(sample.read_bytes())
    ds = photic.open(path)
    path.unlink()
    assert float(ds.echo_by_depth.sum()) > 0


def test_round_trip(sample, tmp_path):
    ds = photic.open(sample)
    ds.to_netcdf(tmp_path / "copy.nc")


def test_missing_file(tmp_path):
    with pytest.raises(photic.Error, match="none.nc: no such file") as error:
        photic.open(tmp_path / "none.nc")
    assert error.value.exit_code == 2


def test_directory(tmp_path):
    with pytest.raises(photic.Error, match="is a directory"):
        photic.open(tmp_path)


def test_not_netcdf(tmp_path):
    (tmp_path / "notes.nc").write_text("notes")
    with pytest.raises(photic.Error, match="notes.nc: not a netCDF file, or a damaged one"):
        photic.open(tmp_path / "notes.nc")


def test_torn(sample, tmp_path):
    (tmp_path / "torn.nc").write_bytes(sample.read_bytes()[:3000])
    with pytest.raises(photic.Error, match="torn.nc: not a netCDF file, or a damaged one"):
        photic.open(tmp_path / "torn.nc")


def test_other_netcdf(tmp_path):
    netCDF4.Dataset(tmp_path / "sst.nc", "w").close()
    with pytest.raises(photic.Error, match="not a result of Photic"):
        photic.open(tmp_path / "sst.nc")


def test_newer_format(sample, tmp_path):
    path = tmp_path / "new.nc"
    path.write_bytes(sample.read_bytes())
    with netCDF4.Dataset(path, "a") as file:
        file.photic_format = 4
    with pytest.raises(photic.Error) as error:
        photic.open(path)
    reason = "written by a newer Photic (result format 4; this package reads up to 3)"
    assert str(error.value) == f"{path}: {reason}"


def with_other_types(dataset):
    """Attributes as other tools and netCDF-3 have them: int64 or double for every count."""
    attrs = {}
    for name, value in dataset.attrs.items():
        whole = isinstance(value, numpy.integer)
        attrs[name] = numpy.int64(value) if whole and name != "photons" else float(value) if whole else value
    return dataset.assign_attrs(attrs)


# Seen red: with names looked for under `telescope_name` alone; with counts that have to be uint64.
@pytest.mark.parametrize("read", [xarray.open_dataset, photic.open], ids=["xarray", "photic"])
@pytest.mark.parametrize("change", [lambda ds: ds, with_other_types], ids=["as it is", "other types"])
def test_a_result_that_xarray_wrote_again(real, tmp_path, read, change):
    copy = tmp_path / "copy.nc"
    with read(real) as dataset:
        change(dataset).to_netcdf(copy)
    original, again = photic.open(real), photic.open(copy)
    assert again.equals(original)
    assert again.converged.dtype == bool and list(again.telescope.values) == list(original.telescope.values)
    assert set(again.coords) == set(original.coords)

    shown = [program("show", path).stdout for path in (real, copy)]
    assert shown[0] == shown[1] and "[source]" in shown[0]
    going_on = program("run", "--continue", copy, "--photons", "40000", "-o", tmp_path / "new.nc")
    assert going_on.returncode == 2
    assert going_on.stderr.startswith(
        f"{copy}: a result that no run can continue: it has no group continuation, which is lost where another "
    )
    scene = tmp_path / "other.toml"
    scene.write_text(SCENE)
    over = program("run", scene, "-o", copy, "--photons", "4000")
    assert over.returncode == 2 and "copy.nc: holds 20000 photons of this scene" in over.stderr


def program(*arguments):
    return subprocess.run([os.environ["PHOTIC_PROGRAM"], *map(str, arguments)], capture_output=True, text=True, check=False)


@pytest.fixture
def real(tmp_path):
    """A result of the program itself."""
    scene = tmp_path / "scene.toml"
    scene.write_text(SCENE)
    done = program("run", scene, "-o", tmp_path / "out.nc")
    assert done.returncode == 0, done.stderr
    return tmp_path / "out.nc"


@pytest.mark.parametrize("names", [(), ("bloom", "--", "sea.x")], ids=["plain", "environments and parameters"])
def test_what_photic_opened_and_xarray_wrote_opens_again(tmp_path, names):
    original = photic.open(made(tmp_path / "sample.nc", *names))
    original.to_netcdf(tmp_path / "copy.nc")
    again = photic.open(tmp_path / "copy.nc")
    assert again.equals(original)
    assert {name: again[name].dtype for name in again if "converged" in name} == {
        name: bool for name in original if "converged" in name
    }
