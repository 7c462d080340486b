"""What cmake --install puts under a prefix works there: the program, its data, the Python package."""

import os
import shutil
import subprocess
import sys

import pytest


@pytest.fixture(scope="module")
def prefix(tmp_path_factory):
    folder = tmp_path_factory.mktemp("prefix")
    subprocess.run(
        ["cmake", "--install", os.environ["PHOTIC_BUILD"], "--prefix", folder],
        check=True, capture_output=True, stdin=subprocess.DEVNULL,
    )
    return folder


@pytest.fixture
def clean_environment(prefix):
    """Nothing of the build in it; only the prefix."""
    kept = {k: v for k, v in os.environ.items() if not k.startswith(("PHOTIC", "PYTHONPATH"))}
    return kept | {
        "PATH": f"{prefix / 'bin'}:/usr/bin:/bin",
        "PYTHONPATH": str(prefix / "lib/python3/dist-packages"),
    }


def test_the_program_works_wherever_it_was_put_and_reads_its_own_data(prefix, scene, tmp_path, clean_environment):
    # Seen red: with a program that looks into the source tree alone.
    moved = tmp_path / "moved"
    shutil.copytree(prefix, moved)
    command = [moved / "bin/photic", "run", scene]
    call = {"cwd": tmp_path, "env": clean_environment, "capture_output": True, "text": True, "check": False}
    done = subprocess.run(command, **call)
    assert done.returncode == 0, done.stderr
    # The source tree's tables are still there: only a program that reads its own notices these.
    for table in (moved / "share/photic/data").glob("*.csv"):
        table.write_text("spoilt")
    done = subprocess.run(command, **call)
    assert done.returncode == 1
    assert str(moved) in done.stderr


def test_the_package_runs_the_program(prefix, scene, tmp_path, clean_environment):
    script = (
        "import photic, sys\n"
        f"assert photic.__file__.startswith({str(prefix)!r}), photic.__file__\n"
        f"result = photic.run({str(scene)!r}, set={{'simulation.seed': 4}})\n"
        "assert result.echo.sel(channel='raman').sum() > 0\n"
    )
    done = subprocess.run(
        [sys.executable, "-c", script], cwd=tmp_path, env=clean_environment, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr


def test_editors_find_the_schema(prefix, clean_environment, tmp_path):
    """From the scenes that came along, and from those that the program writes elsewhere."""
    # Seen red: with the schema left out of the installation; with the source's scenes.
    call = {"env": clean_environment, "cwd": tmp_path, "capture_output": True, "text": True, "check": True}
    schema = prefix / "share/photic/scenes/scene.schema.json"
    assert schema.read_text() == subprocess.run([prefix / "bin/photic", "schema"], **call).stdout
    scenes = sorted(schema.parent.glob("*.toml"))
    assert "ship" in [scene.stem for scene in scenes]
    for scene in scenes:
        assert scene.read_text().startswith("#:schema ./scene.schema.json\n# ")
    subprocess.run([prefix / "bin/photic", "new", "ship", "-o", "my.toml"], **call)
    assert (tmp_path / "my.toml").read_text().startswith(f"#:schema {schema}\n# The ship lidar")


def test_licence_and_scenes_come_along(prefix):
    assert (prefix / "share/photic/scenes/ship.toml").is_file()
    assert (prefix / "share/doc/photic/LICENSE").is_file()
