"""What cmake --install puts under a prefix works there: the program, its data, the Python package."""

import importlib.metadata
import re
import shutil
import subprocess
import sys

import pytest
from conftest import SOURCE

PACKAGES = "lib/python3/dist-packages"


@pytest.fixture
def call(tmp_path, installed_environment):
    def call(*command, **environment):
        return subprocess.run(
            command, cwd=tmp_path, env=installed_environment | environment, capture_output=True, text=True, check=False
        )

    return call


def test_the_program_works_wherever_it_was_put_and_reads_its_own_data(prefix, scene, tmp_path, call):
    # Seen red: with a program that looks into the source tree alone.
    moved = tmp_path / "moved"
    shutil.copytree(prefix, moved)
    done = call(moved / "bin/photic", "run", scene)
    assert done.returncode == 0, done.stderr
    # The source tree's tables are still there: only a program that reads its own notices these.
    for table in (moved / "share/photic/data").glob("*.csv"):
        table.write_text("spoilt")
    done = call(moved / "bin/photic", "run", scene)
    assert done.returncode == 1
    assert str(moved) in done.stderr


def test_the_package_simulates_wherever_it_was_put_with_the_data_beside_it(prefix, scene, tmp_path, call):
    script = (
        "import photic, sys\n"
        f"assert photic.__file__.startswith(sys.argv[1]), photic.__file__\n"
        f"result = photic.run({str(scene)!r}, set={{'simulation.seed': 4}})\n"
        "assert result.echo.sel(channel='raman').sum() > 0\n"
        "assert photic.Scene.new('argo')['sea.temperature_c'] > 0\n"
    )
    done = call(sys.executable, "-c", script, str(prefix), PYTHONPATH=str(prefix / PACKAGES))
    assert done.returncode == 0, done.stderr
    moved = tmp_path / "moved"
    shutil.copytree(prefix, moved, symlinks=True)
    for table in (moved / "share/photic/data").glob("*.csv"):
        table.write_text("spoilt")
    done = call(sys.executable, "-c", script, str(moved), PYTHONPATH=str(moved / PACKAGES))
    assert done.returncode == 1
    assert f"photic.errors.Error: a data table of Photic is missing or damaged: {moved}" in done.stderr


def test_editors_find_the_schema(prefix, tmp_path, call):
    """From the scenes that came along, and from those that the program writes elsewhere."""
    # Seen red: with the schema left out of the installation; with the source's scenes.
    schema = prefix / "share/photic/scenes/scene.schema.json"
    assert schema.read_text() == call("photic", "schema").stdout
    scenes = sorted(schema.parent.glob("*.toml"))
    assert "ship" in [scene.stem for scene in scenes]
    for scene in scenes:
        assert scene.read_text().startswith("#:schema ./scene.schema.json\n# ")
    assert call("photic", "new", "ship", "-o", "my.toml").returncode == 0
    assert (tmp_path / "my.toml").read_text().startswith(f"#:schema {schema}\n# The ship lidar")


def test_the_program_draws_with_the_package_beside_it(prefix, scene, tmp_path, call):
    # Seen red: with the package's folder taken away, and with one that has been spoilt.
    assert call("photic", "run", scene, "-o", "out.nc").returncode == 0
    done = call("photic", "plot", "out.nc", "-o", "out.png")
    assert done.returncode == 0, done.stderr
    assert (tmp_path / "out.png").read_bytes().startswith(b"\x89PNG")
    moved = tmp_path / "moved"
    shutil.copytree(prefix, moved)
    (moved / PACKAGES / "photic/plot.py").write_text("raise ImportError('spoilt')")
    done = call(moved / "bin/photic", "plot", "out.nc", "-o", "out.png")
    assert done.returncode == 1 and "spoilt" in done.stderr


def test_python_and_the_program_know_one_version(prefix, call):
    # Seen red: with another number in METADATA.in, and in CITATION.cff.
    version = call("photic", "--version").stdout.split()[1]
    ask = "import photic; print(photic.__version__)"
    assert call(sys.executable, "-c", ask, PYTHONPATH=str(prefix / PACKAGES)).stdout.strip() == version
    [package] = importlib.metadata.distributions(path=[str(prefix / PACKAGES)])
    assert (package.metadata["Name"], package.version) == ("photic", version)
    assert re.search(r"^version: (.+)$", (SOURCE / "CITATION.cff").read_text(), re.MULTILINE)[1] == version


def test_what_else_is_there(prefix):
    for file in [
        "share/photic/scenes/ship.toml", "share/photic/scenes/argo-profile.csv", "share/photic/data/README.md", "share/doc/photic/LICENSE",
        "share/bash-completion/completions/photic", "share/zsh/site-functions/_photic",
        "share/fish/vendor_completions.d/photic.fish", "share/man/man1/photic.1",
    ]:
        assert (prefix / file).is_file(), file
    assert not list(prefix.rglob("*.pyc"))


def test_links_of_the_pages_lead_somewhere(prefix):
    # Seen red: without docs/images, and without the link to the data.
    pages = prefix / "share/doc/photic"
    missing, seen = [], 0
    for page in [pages / "README.md", *pages.glob("docs/**/*.md")]:
        for target in re.findall(r"\]\(([^)#]+)", page.read_text()):
            # The source stays in the repository.
            if re.match(r"https?:|(\.\./)*(src|apps|cmake|tests|tools|benchmarks|experiments)(/|$)", target):
                continue
            seen += 1
            if not (page.parent / target).exists():
                missing.append(f"{page.name}: {target}")
    assert not missing
    assert seen > 20
