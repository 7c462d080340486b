"""photic new and photic schema."""

import json


def test_a_starter_scene_is_a_good_scene(photic, tmp_path):
    done = photic("new", "ship")
    assert (done.returncode, done.stderr) == (0, "")
    (tmp_path / "mine.toml").write_text(done.stdout)
    check = photic("check", "mine.toml")
    assert (check.returncode, check.stdout, check.stderr) == (0, "mine.toml: no problems\n", "")


def test_a_starter_scene_goes_to_a_file(photic, tmp_path, program):
    done = photic("new", "ship", "-o", "mine.toml")
    assert done.returncode == 0
    assert done.stdout == f"mine.toml: written; check it with: {program} check mine.toml\n"
    assert (tmp_path / "mine.toml").read_text() == photic("new", "ship").stdout


def test_the_same_file_may_be_asked_for_again(photic, tmp_path, program):
    # Seen red: refused, as before.
    photic("new", "ship", "-o", "mine.toml")
    done = photic("new", "ship", "-o", "mine.toml")
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout == f"mine.toml: is there already; check it with: {program} check mine.toml\n"


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
    assert "ship" in done.stderr
    assert not (tmp_path / "mine.toml").exists()


def test_the_schema_is_json(photic):
    done = photic("schema")
    assert (done.returncode, done.stderr) == (0, "")
    schema = json.loads(done.stdout)
    assert schema["$schema"] == "https://json-schema.org/draft/2020-12/schema"
    assert "simulation" in schema["properties"]
