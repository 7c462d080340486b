"""photic run: what it prints and writes, and what happens when it cannot write."""

import csv
import json
import os
import resource

import netCDF4


def test_a_run(photic, program, scene, tmp_path):
    done = photic("run", "quick.toml")
    assert (done.returncode, done.stderr) == (0, "")
    assert "stopped by: photons" in done.stdout
    last = done.stdout.splitlines()[-2:]
    assert last == ["Result: quick.nc", f"Plot it:  {program} plot quick.nc -o quick.png"]
    assert sorted(p.name for p in tmp_path.iterdir()) == ["quick.nc", "quick.toml"]
    with netCDF4.Dataset(tmp_path / "quick.nc") as result:
        assert result.photons == 20000
        assert result.history.splitlines()[-1].endswith("photic run quick.toml")


def test_the_result_goes_to_the_current_folder(photic, scene, tmp_path):
    elsewhere = tmp_path / "elsewhere"
    elsewhere.mkdir()
    assert photic("run", "../quick.toml", cwd=elsewhere).returncode == 0
    assert [p.name for p in elsewhere.iterdir()] == ["quick.nc"]
    assert not (tmp_path / "quick.nc").exists()


def test_the_output_can_be_named(photic, scene, tmp_path):
    (tmp_path / "out").mkdir()
    done = photic("run", "quick.toml", "-o", "out/my echo.nc")
    assert done.returncode == 0
    assert "Result: out/my echo.nc" in done.stdout
    with netCDF4.Dataset(tmp_path / "out/my echo.nc") as result:
        assert result.history.splitlines()[-1].endswith("photic run quick.toml -o 'out/my echo.nc'")


def test_csv(photic, scene, tmp_path):
    done = photic("run", "quick.toml", "-o", "echo.csv")
    assert done.returncode == 0
    assert done.stdout.splitlines()[-1] == "Result: echo.csv"
    rows = list(csv.DictReader(line for line in (tmp_path / "echo.csv").open() if not line.startswith("#")))
    assert len(rows) == 2 * 10
    assert photic("run", "quick.toml").returncode == 0
    with netCDF4.Dataset(tmp_path / "quick.nc") as result:
        assert [float(row["echo"]) for row in rows] == result["echo"][:].ravel().tolist()


def test_json(photic, scene, tmp_path):
    done = photic("run", "quick.toml", "--json")
    assert done.returncode == 0
    assert len(json.loads(done.stdout)["echoes"]) == 2 * 10
    assert done.stderr.splitlines()[1] == "Result: quick.nc"


def test_no_progress_bar_without_a_terminal(photic, scene):
    assert photic("run", "quick.toml", "--photons", "2e6", "--max-time", "1s").stderr == ""


def test_a_time_limit_is_a_normal_end(photic, scene, tmp_path):
    done = photic("run", "quick.toml", "--photons", "1e15", "--max-time", "0.5s")
    assert done.returncode == 0, done.stderr
    assert "stopped by: time" in done.stdout
    with netCDF4.Dataset(tmp_path / "quick.nc") as result:
        assert 0 < result.photons < 1e15


def test_a_target_ends_the_run(photic, scene):
    done = photic("run", "quick.toml", "--target", "20%", "--photons", "1e9", "--max-time", "60s",
                  "--set", "gates.depth_max_m=3")
    assert done.returncode == 0, done.stderr
    assert "stopped by: target" in done.stdout


def expect_refusal(done, code, *words):
    assert done.returncode == code
    assert done.stdout == ""
    for word in words:
        assert word in done.stderr
    assert "bug" not in done.stderr


def test_a_folder_that_is_missing_is_reported_before_the_run(photic, scene):
    # 1e15 photons would take years: an answer at all is an answer before the run.
    # Seen red: without the check before the run.
    done = photic("run", "quick.toml", "--photons", "1e15", "-o", "nowhere/echo.nc")
    expect_refusal(done, 1, "nowhere/echo.nc", "nowhere does not exist")


def test_a_folder_in_place_of_a_file(photic, scene, tmp_path):
    (tmp_path / "quick.nc").mkdir()
    expect_refusal(photic("run", "quick.toml", "--photons", "1e15"), 1, "quick.nc", "directory")


def test_a_folder_nobody_can_write_to(photic, scene):
    # Not even root makes a file in /proc.
    expect_refusal(photic("run", "quick.toml", "--photons", "1e15", "-o", "/proc/echo.nc"), 1, "/proc/echo.nc")


def test_a_result_never_replaces_the_scene(photic, scene, tmp_path):
    scene.rename(tmp_path / "scene.csv")
    before = (tmp_path / "scene.csv").read_text()
    done = photic("run", "scene.csv", "-o", "scene.csv")
    expect_refusal(done, 2, "scene.csv: the result would replace the scene (choose another name with -o)")
    assert (tmp_path / "scene.csv").read_text() == before


def limit_file_size():
    """A write past 4 kB fails, as on a full disk (EFBIG instead of ENOSPC)."""
    resource.setrlimit(resource.RLIMIT_FSIZE, (4096, 4096))


def test_a_full_disk_leaves_the_old_result_and_prints_the_table(photic, scene, tmp_path):
    assert photic("run", "quick.toml", "--photons", "4000").returncode == 0
    older = (tmp_path / "quick.nc").read_bytes()
    # Seen red: without the table printed when the write fails.
    # restore_signals=False: Python ignores SIGXFSZ, and so does the program it starts.
    done = photic("run", "quick.toml", preexec_fn=limit_file_size, restore_signals=False)
    assert done.returncode == 1
    assert "quick.nc: cannot write the file: File too large" in done.stderr
    assert "stopped by: photons" in done.stdout
    assert "Result:" not in done.stdout
    assert (tmp_path / "quick.nc").read_bytes() == older
    assert sorted(p.name for p in tmp_path.iterdir()) == ["quick.nc", "quick.toml"]


def test_data_tables_that_are_missing(photic, scene, tmp_path):
    done = photic("run", "quick.toml", env=os.environ | {"PHOTIC_DATA": str(tmp_path)})
    expect_refusal(done, 1, str(tmp_path), "PHOTIC_DATA")
