"""What a person sees: widths, colour, progress, and how much of it."""

import re
import subprocess

import netCDF4
import pytest
from terminal import COLOUR, lines_shown, on_a_terminal, without_colour

GRID = """\
[environment_grid]
"sea.layer.1.chlorophyll_mg_m3" = [0.5, 1.5, 2.0]
"sea.layer.0.cdom_a440_per_m" = [0.01, 0.02, 0.04]
"""


@pytest.mark.parametrize("columns", [60, 80, 200])
def test_nothing_is_wider_than_the_terminal(program, scene, tmp_path, columns):
    # Seen red: with tables for 100 columns; with an example in the help that is longer.
    scene.write_text(scene.read_text() + GRID)
    for arguments in (
        ["run", "quick.toml", "-o", f"{columns}.nc", "--photons", "50000"],
        ["run", "quick.toml", "-o", f"{columns}.nc", "--photons", "50000", "--table", "full", "--target", "5%"],
        ["help"],
        ["help", "run"],
        ["help", "optics"],
    ):
        code, output = on_a_terminal([program, *arguments], columns, cwd=tmp_path)
        assert code == 0, output
        shown = [line for line in lines_shown(output) if not line.startswith("Plot it: ")]
        assert max(map(len, shown)) <= columns, (arguments, max(shown, key=len))


def test_progress_stands_still_and_shows_the_worst_gate(program, scene, tmp_path):
    # Seen red: with numbers of their own widths; with the target left out.
    command = [program, "run", "quick.toml", "--target", "0.3%", "--photons", "2e7", "--max-time", "2s"]
    code, output = on_a_terminal(command, 120, cwd=tmp_path)
    assert code == 0, output
    drawn = [line for line in lines_shown(output) if "worst gate" in line]
    assert len(drawn) > 2
    for field in ("%", "left", "worst gate"):
        assert len({line.index(field) for line in drawn}) == 1, field
    assert all("(target 0.3 %)" in line for line in drawn)
    assert all(re.search(r"\d+/20 gates", line) for line in drawn)
    # Other times left have other widths: "2 s left", "41 d left".
    long = ["timeout", "--foreground", "-s", "INT", "1", program, "run", "quick.toml", "--photons", "1e12", "-o", "long.nc"]
    _, output = on_a_terminal(long, 120, cwd=tmp_path)
    longs = [line for line in lines_shown(output) if "worst gate" in line]
    assert {line.index("worst gate") for line in longs} == {drawn[0].index("worst gate")}
    code, output = on_a_terminal([*command, "-o", "narrow.nc"], 60, cwd=tmp_path)
    narrow = [line for line in lines_shown(output) if " left" in line]
    assert narrow and all("worst" in line and len(line) < 60 for line in narrow)


def test_colour_is_for_terminals(program, scene, tmp_path):
    run = [program, "run", "quick.toml", "--photons", "8000"]
    _, output = on_a_terminal(run, cwd=tmp_path)
    assert "\x1b[33m*\x1b[0m" in output, "flags"
    assert re.search(r"\x1b\[1mconverged: [^\n]*\x1b\[0m", output), "summary"
    for no_colour in ({"NO_COLOR": "1"}, {"TERM": "dumb"}):
        _, output = on_a_terminal(run, environment=no_colour, cwd=tmp_path)
        assert not COLOUR.search(output)
    done = subprocess.run(run, cwd=tmp_path, capture_output=True, text=True, check=True)
    assert "\x1b" not in done.stdout + done.stderr


def test_errors_are_coloured_and_say_the_same(program, scene, tmp_path):
    scene.write_text(scene.read_text().replace("depth_step_m", "depth_stpe_m"))
    code, output = on_a_terminal([program, "check", "quick.toml"], 200, cwd=tmp_path)
    assert code == 2
    assert COLOUR.search(output)
    plain = subprocess.run([program, "check", "quick.toml"], cwd=tmp_path, capture_output=True, text=True, check=False)
    assert without_colour(output) == plain.stderr


def test_quiet_prints_warnings_alone(photic, scene, tmp_path):
    done = photic("run", "quick.toml", "--quiet", "--photons", "2e5", "--set", "simulation.max_order=2")
    assert done.returncode == 0
    assert done.stdout == ""
    assert done.stderr.startswith("max_order cuts off more than 0.1 % of the echo")
    assert (tmp_path / "quick.nc").exists()
    done = photic("run", "quick.toml", "-q", "--photons", "2e5", "-o", "other.nc")
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")


def test_how_much_of_the_table(photic, scene):
    scene.write_text(scene.read_text().replace("depth_step_m = 1.0", "depth_step_m = 0.2"))
    rows = {}
    for table in ("short", "full", "none"):
        done = photic("run", "quick.toml", "--photons", "8000", "--table", table)
        assert done.returncode == 0, done.stderr
        rows[table] = len(re.findall(r"^ +\d+\.\d\d  ", done.stdout, re.MULTILINE))
        assert "stopped by: photons" in done.stdout
        assert "estimator: forward; seed: 1; engine: lanes" in done.stdout
        assert ("Shown: 1 gate of 2; --table full shows all" in done.stdout) == (table == "short")
    assert rows == {"short": 25, "full": 50, "none": 0}


def test_the_summary_says_why_the_estimator_was_taken(photic, scene):
    scene.write_text(scene.read_text().replace('estimator = "forward"', 'estimator = "auto"'))
    done = photic("run", "quick.toml", "--photons", "8000", "--table", "none")
    assert re.search(r"^estimator: (forward|bidirectional) \(auto: pilot runs of", done.stdout, re.MULTILINE)


def test_text_is_the_table_as_printed(photic, scene, tmp_path):
    done = photic("run", "quick.toml", "--photons", "8000", "-o", "my.txt", "--table", "full")
    assert done.returncode == 0, done.stderr
    output = (tmp_path / "my.txt").read_text()
    head, table = output.split("\n\n", 1)
    assert head.startswith("# a quick scene\n# Photic ") and head.endswith(", photons 8000")
    assert done.stdout == table + "\nResult: my.txt\n"
    (tmp_path / "theirs.txt").write_text("my notes\n")
    done = photic("run", "quick.toml", "--photons", "8000", "-o", "theirs.txt")
    assert done.returncode == 2
    assert "theirs.txt: is no result of a run, and is left as it is" in done.stderr
    assert (tmp_path / "theirs.txt").read_text() == "my notes\n"


@pytest.mark.parametrize("output", ["out/", "deep/er/", "there", "there/"])
def test_a_folder_as_the_output(photic, scene, tmp_path, output):
    # Seen red: without a look whether the folder is there.
    (tmp_path / "there").mkdir()
    done = photic("run", "quick.toml", "--photons", "8000", "-o", output)
    assert done.returncode == 0, done.stderr
    assert (tmp_path / output / "quick.nc").is_file()


def test_a_folder_that_cannot_be_made(photic, scene):
    done = photic("run", "quick.toml", "-o", "quick.toml/")
    assert done.returncode == 1
    assert done.stderr.startswith("photic: cannot make the folder quick.toml/: ")


def test_endings_in_capitals(photic, scene, tmp_path):
    # Seen red: with .nc in small letters alone.
    done = photic("run", "quick.toml", "--photons", "8000", "-o", "MY.NC")
    assert done.returncode == 0, done.stderr
    with netCDF4.Dataset(tmp_path / "MY.NC") as file:
        assert file.photons == 8000
    assert 'title = "a quick scene"' in photic("show", "MY.NC").stdout
    done = photic("run", "--continue", "MY.NC", "--photons", "16000", "-o", "MY.NC")
    assert done.returncode == 0, done.stderr
    assert photic("run", "quick.toml", "--photons", "8000", "-o", "MY.CSV").returncode == 0
    assert (tmp_path / "MY.CSV").read_text().startswith("# a quick scene")


def test_hints_work_as_printed(program, scene, tmp_path):
    # Seen red: with names that are not quoted; with "photic" for a program that is not in the PATH.
    folder = tmp_path / "my results & more"
    folder.mkdir()
    done = subprocess.run(
        [program, "run", "quick.toml", "--photons", "8000", "-o", f"{folder.name}/"],
        cwd=tmp_path, capture_output=True, text=True, check=True,
    )
    hint = done.stdout.splitlines()[-1]
    assert hint.startswith("Plot it:  ")
    subprocess.run(hint.removeprefix("Plot it:  "), shell=True, cwd=tmp_path, check=True)
    assert (folder / "quick.png").read_bytes().startswith(b"\x89PNG")
