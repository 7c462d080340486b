"""docs/images/make, which makes the pictures of README and guide."""

import subprocess
import sys
from pathlib import Path

import matplotlib.image
import pytest

IMAGES = Path(__file__).resolve().parents[2] / "docs" / "images"


def make(*arguments):
    line = [sys.executable, IMAGES / "make", *arguments]
    return subprocess.run(line, capture_output=True, text=True)


# Seen red: with a picture of another name in the folder, and with one left out of the list.
def test_every_picture_there_is_listed():
    listed = make("--list").stdout.split()
    assert sorted(listed) == sorted(path.name for path in IMAGES.glob("*.png"))
    assert all(path.stat().st_size < 150_000 for path in IMAGES.glob("*.png"))


# Seen red: with a name of a channel that the scene has not.
@pytest.mark.parametrize("name", ["scene.png", "echo.png", "oil.png", "haze.png", "aerosols.png", "wind.png", "film.png"])
def test_pictures_are_made(tmp_path, name):
    made = make(name, "-o", tmp_path, "--fewer", "20")
    assert (made.returncode, made.stdout.split()) == (0, [str(tmp_path / name)]), made.stderr
    picture = matplotlib.image.imread(tmp_path / name)
    assert picture.shape[1] == matplotlib.image.imread(IMAGES / name).shape[1]
    assert picture[..., :3].min() < 0.2 and (picture[0, :10, :3] == 1).all()


def test_a_picture_that_there_is_not():
    refused = make("ships.png")
    assert refused.returncode == 2 and "no picture ships.png; there are: scene.png" in refused.stderr
