"""What `python3 -m photic plot` says of input that it cannot draw."""

import subprocess
import sys

import matplotlib.image
import netCDF4
import pytest

import photic


def test_missing_file(command, tmp_path):
    assert command("plot", "none.nc", "-o", tmp_path / "out.png") == (2, "none.nc: no such file\n")


def test_unknown_names(command, sample, tmp_path):
    code, error = command("plot", sample, "-o", tmp_path / "out.png", "--telescope", "far")
    assert (code, error) == (2, "sample: there is no telescope 'far'; there are: narrow, wide\n")
    code, error = command("plot", sample, "-o", tmp_path / "out.png", "--channel", "rahman")
    assert (code, error) == (2, "sample: there is no channel 'rahman' (did you mean 'raman'?)\n")


def test_unknown_ending(command, sample, tmp_path):
    code, error = command("plot", sample, "-o", "out.doc")
    assert (code, error) == (2, "out.doc: pictures are .png, .pdf or .svg\n")


def test_missing_folder(command, sample, tmp_path):
    path = tmp_path / "none" / "out.png"
    code, error = command("plot", sample, "-o", path)
    assert (code, error) == (1, f"{path}: cannot write the picture: No such file or directory\n")


def test_bad_arguments(command, sample):
    code, error = command("plot", sample)
    assert code == 2 and "-o/--output" in error and "Traceback" not in error
    assert command()[0] == 2


# Seen red: with the ending compared as it is written.
def test_endings_in_capitals(command, sample, tmp_path):
    small = ["--telescope", "wide", "--channel", "raman"]
    assert command("plot", sample, "-o", tmp_path / "out.PNG", *small) == (0, "")
    assert matplotlib.image.imread(tmp_path / "out.PNG", format="png").shape[1] > 1000


def test_a_folder_for_a_picture(command, sample, tmp_path):
    said = f"{tmp_path}: is a folder: name a picture in it, as in {tmp_path}/echoes.png\n"
    assert command("plot", sample, "-o", tmp_path) == (2, said)
    code, error = command("plot", sample, "-o", f"{tmp_path}/none/")
    assert code == 2 and "is a folder" in error


@pytest.mark.parametrize("width", ["10", "501", "nan"])
def test_widths_that_no_page_has(command, sample, tmp_path, width):
    code, error = command("plot", sample, "-o", tmp_path / "out.png", "--width-mm", width)
    assert (code, error) == (2, f"--width-mm {width}: widths are from 60 to 500 mm\n")


def test_files_that_are_no_results(command, sample, tmp_path):
    path = tmp_path / "other.nc"
    path.write_bytes(b"")
    code, error = command("plot", path, "-o", tmp_path / "out.png")
    assert (code, error) == (2, f"{path}: not a netCDF file, or a damaged one (results end in .nc)\n")
    with netCDF4.Dataset(path, "w") as file:
        file.title = "no result"
    code, error = command("plot", path, "-o", tmp_path / "out.png")
    assert code == 2 and "not a result of Photic" in error and error.count("\n") == 1


# Seen red: without the look at what the file lacks.
def test_a_result_without_its_variables(command, tmp_path):
    path = tmp_path / "empty.nc"
    with netCDF4.Dataset(path, "w") as file:
        file.photic_format = 2
    code, error = command("plot", path, "-o", tmp_path / "out.png")
    assert (code, error) == (2, f"{path}: a result of Photic that lacks 'telescope_name'\n")


# Seen red: without the look at sizes.
@pytest.mark.parametrize("axis", ["gate", "channel", "telescope"])
def test_an_empty_result(command, sample, tmp_path, axis):
    path = tmp_path / "empty.nc"
    empty = photic.open(sample).isel({axis: []})
    for name in empty.variables:
        empty[name].encoding = {}  # its chunks are larger than what is left
    empty.to_netcdf(path)
    code, error = command("plot", path, "-o", tmp_path / "out.png")
    assert (code, error) == (2, "empty: holds no echoes: there is nothing to draw\n")


def test_results_without_what_is_asked_for(command, sample, tmp_path):
    path = tmp_path / "wide.nc"
    photic.open(sample).isel(telescope=[1]).to_netcdf(path)
    code, error = command("plot", sample, path, "-o", tmp_path / "out.png", "--telescope", "narrow")
    assert (code, error) == (2, "wide: has no telescope of those requested; there are: wide\n")


def test_letters_that_the_font_lacks_are_named_once(sample, tmp_path):
    # Seen red: with Matplotlib's own warnings, one for each time that a letter is measured.
    call = [sys.executable, "-m", "photic", "plot", sample, "-o", tmp_path / "p.png", "--title", "油油 and 膜"]
    done = subprocess.run([*call, "--channel", "raman"], capture_output=True, text=True, check=True)
    assert done.stderr == "letters that the font of plots lacks are drawn as boxes\n"
