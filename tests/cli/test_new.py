"""photic new."""

import re
import shutil
import subprocess

import netCDF4
import pytest
from conftest import SOURCE

KINDS = sorted(path.stem for path in (SOURCE / "scenes").glob("*.toml"))
PROFILE = (SOURCE / "scenes/argo-profile.csv").read_text()




def remark(kind, name):
    """What is said of a good scene: of oils little is known."""
    placeholders = 'for the oil "weakly-absorbing-crude" these are placeholders, not data: absorption_337_nm, absorption_slope'
    lines = {"oil-spill": 43, "oil-spill-airborne": 46}
    if kind not in lines:
        return ""
    return f'{name}:{lines[kind]}:9: {placeholders}; give your own oil as file = "….csv"\n'


@pytest.mark.parametrize("kind", KINDS)
def test_every_scene_is_a_starter_and_a_good_one(photic, tmp_path, kind):
    assert photic("new", kind, "-o", "mine.toml").returncode == 0
    check = photic("check", "mine.toml")
    assert (check.returncode, check.stdout, check.stderr) == (0, "mine.toml: no problems\n", remark(kind, "mine.toml"))
    done = photic("new", kind)
    assert done.returncode == 0
    first, rest = done.stdout.split("\n", 1)
    assert rest == (SOURCE / f"scenes/{kind}.toml").read_text()
    # The build has a schema, beside its copies of the scenes.
    assert first.startswith("#:schema /") and first.endswith("/scenes/scene.schema.json")
    with open(first.removeprefix("#:schema "), encoding="utf-8") as schema:
        assert schema.read() == photic("schema").stdout


@pytest.mark.parametrize("kind", KINDS)
def test_every_scene_runs_as_its_comments_say(photic, tmp_path, kind):
    """For a few photons: experiments/instruments.py runs them whole."""
    # Seen red: with 'rov.nc' in the comment of airborne.toml; with the profile's path wrong in argo.toml.
    assert photic("new", kind, "-o", f"{kind}.toml").returncode == 0
    commands = re.findall(r"^#   photic (\w+) (\S+) ", (tmp_path / f"{kind}.toml").read_text(), re.MULTILINE)
    assert kind.startswith("benchmark") or {word for word, _ in commands} >= {"run"}
    assert all(name == f"{kind}.toml" for _, name in commands), commands
    done = photic("run", f"{kind}.toml", "--photons", "4000", "--max-time", "60s")
    assert (done.returncode, done.stderr) == (0, remark(kind, f"{kind}.toml"))
    with netCDF4.Dataset(tmp_path / f"{kind}.nc") as result:
        tallies = [one for one in result.variables.values() if "normalisation" in one.ncattrs()]
        assert tallies or result["echo"][:].sum(axis=-1).min() > 0, "a channel that no light reaches"
        assert all(one[:].max() > 0 for one in tallies), "a tally that no light reaches"
    echoes_go_to = re.findall(r"the echoes go to (\S+)", (tmp_path / f"{kind}.toml").read_text())
    assert echoes_go_to in ([], [f"{kind}.nc"])


def test_a_file_that_a_scene_reads_comes_along(photic, tmp_path, program):
    # Seen red: with the files written to the current folder.
    (tmp_path / "there").mkdir()
    done = photic("new", "argo", "-o", "there/mine.toml")
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout == (
        "there/argo-profile.csv: written\n"
        f"there/mine.toml: written; check it with: {program} check there/mine.toml\n"
    )
    assert (tmp_path / "there/argo-profile.csv").read_text() == PROFILE
    assert photic("new", "argo", "-o", "there/mine.toml").stdout.startswith("there/argo-profile.csv: exists already\n")


def test_a_file_of_that_name_stays_as_it_is(photic, tmp_path):
    # Seen red: with the scene written first.
    (tmp_path / "argo-profile.csv").write_text("precious")
    done = photic("new", "argo", "-o", "mine.toml")
    assert done.returncode == 2
    assert done.stderr == "argo-profile.csv: exists already and was left as it is (choose another folder with -o)\n"
    assert (tmp_path / "argo-profile.csv").read_text() == "precious"
    assert not (tmp_path / "mine.toml").exists()


def test_a_scene_on_standard_output_names_the_file_that_it_reads(photic, tmp_path):
    done = photic("new", "argo")
    assert done.stderr == "the scene reads argo-profile.csv: photic new argo -o FILE writes both\n"
    assert photic("new", "ship").stderr == ""
    assert not list(tmp_path.iterdir())


def test_the_list(photic):
    done = photic("new", "--list")
    assert (done.returncode, done.stderr) == (0, "")
    lines = dict(line.split(": ", 1) for line in done.stdout.splitlines())
    assert sorted(lines) == KINDS
    assert done.stdout.startswith("ship: ")
    assert lines["rov"].startswith("A lidar on a remotely operated vehicle 3 m below the surface")


def test_a_program_alone_writes_no_line_for_editors(program, tmp_path):
    # Seen red: with the line without a look at the file.
    alone = tmp_path / "deep/er/alone"
    alone.parent.mkdir(parents=True)
    shutil.copy(program, alone)
    done = subprocess.run([alone, "new", "ship"], capture_output=True, text=True, check=False)
    assert (done.returncode, done.stdout) == (0, (SOURCE / "scenes/ship.toml").read_text())


def test_a_starter_scene_goes_to_a_file(photic, tmp_path, program):
    done = photic("new", "ship", "-o", "mine.toml")
    assert done.returncode == 0
    assert done.stdout == f"mine.toml: written; check it with: {program} check mine.toml\n"
    # Its comments name the file. Seen red: with "ship.toml" in them.
    text = photic("new", "ship").stdout
    assert "photic run ship.toml" in text
    text = text.replace("ship.toml", "mine.toml").replace("ship.nc", "mine.nc")
    assert (tmp_path / "mine.toml").read_text() == text


def test_a_name_of_two_lines_leaves_a_good_scene(photic, tmp_path):
    # Seen red: with the name in the comments, whose second line is no comment.
    assert photic("new", "ship", "-o", "a\nb.toml").returncode == 0
    assert photic("check", "a\nb.toml").returncode == 0


def test_the_same_file_may_be_asked_for_again(photic, tmp_path, program):
    # Seen red: refused, as before.
    photic("new", "ship", "-o", "mine.toml")
    done = photic("new", "ship", "-o", "mine.toml")
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout == f"mine.toml: exists already; check it with: {program} check mine.toml\n"


def test_an_existing_file_stays_as_it_is(photic, tmp_path):
    # Seen red: with the file opened for writing rather than for a new one.
    (tmp_path / "mine.toml").write_text("precious")
    done = photic("new", "ship", "-o", "mine.toml")
    assert done.returncode == 2
    assert done.stderr == "mine.toml: exists already and was left as it is (choose another name with -o)\n"
    assert (tmp_path / "mine.toml").read_text() == "precious"


def test_a_folder_that_is_missing(photic):
    done = photic("new", "ship", "-o", "nowhere/mine.toml")
    assert done.returncode == 1
    assert done.stderr == "photic: cannot write nowhere/mine.toml: No such file or directory\n"


def test_a_kind_that_does_not_exist(photic, tmp_path):
    done = photic("new", "shp", "-o", "mine.toml")
    assert done.returncode == 2
    assert done.stderr == "there is no starter scene 'shp' (did you mean 'ship'?)\n"
    assert not (tmp_path / "mine.toml").exists()
