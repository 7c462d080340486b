"""photic run in lanes: by default, the same bits on any number of threads, taken up in the same engine."""

import resource

import netCDF4
import pytest
from test_reproducible import contents


@pytest.fixture
def run(photic):
    def call(*arguments, code=0):
        done = photic("run", "quick.toml", *arguments)
        assert done.returncode == code, done.stderr
        return done

    return call


def engine_of(path):
    with netCDF4.Dataset(path) as file:
        return file.engine


def test_the_number_of_threads_does_not_matter(run, scene, tmp_path):
    for threads in (1, 3):
        run("--threads", threads, "-o", f"{threads}.nc")
    assert contents(tmp_path / "1.nc") == contents(tmp_path / "3.nc")
    assert engine_of(tmp_path / "1.nc").startswith("lanes (")
    run("--engine", "scalar", "-o", "scalar.nc")
    assert engine_of(tmp_path / "scalar.nc") == "scalar"
    assert contents(tmp_path / "1.nc") != contents(tmp_path / "scalar.nc")


def test_a_run_goes_on_in_its_engine(run, scene, tmp_path):
    # Seen red: with the scalar engine as the default of runs that go on.
    run("--isa", "baseline", "--photons", "21000", "-o", "long.nc", "--set", "simulation.batch_photons=250")
    run("--isa", "baseline", "--photons", "9000", "-o", "old.nc")
    run("--photons", "21000", "--continue", "old.nc", "-o", "new.nc")
    assert engine_of(tmp_path / "new.nc") == "lanes (baseline)"
    assert contents(tmp_path / "new.nc") == contents(tmp_path / "long.nc")
    done = run("--photons", "21000", "--continue", "old.nc", "-o", "x.nc", "--engine", "scalar", code=2)
    assert done.stderr.startswith(
        "old.nc: ran in the engine lanes (baseline), and is to continue in scalar (leave out --engine and --isa)\n"
    )


def test_estimators_are_chosen_as_ever(run, scene, tmp_path):
    run("--set", "simulation.estimator=auto", "-o", "lanes.nc")
    run("--engine", "scalar", "--set", "simulation.estimator=auto", "-o", "scalar.nc")
    with netCDF4.Dataset(tmp_path / "lanes.nc") as lanes, netCDF4.Dataset(tmp_path / "scalar.nc") as scalar:
        assert "pilot runs" in lanes.scene and lanes.scene == scalar.scene


def test_what_does_not_run_here_is_refused(run, photic, scene):
    # Seen red: with the check left out.
    sets = photic("--version").stdout.splitlines()[2]
    for isa in ("baseline", "avx2", "avx512"):
        if isa not in sets:
            done = run("--isa", isa, code=2)
            assert f"--isa {isa}: " in done.stderr
            assert "it was not built" in done.stderr or "this processor does not have it" in done.stderr
            assert ("cmake -DPHOTIC_ISAS=all" in done.stderr) == ("it was not built" in done.stderr)
        elif f"{isa} (not on this processor)" in sets:
            assert "this processor does not have it" in run("--isa", isa, code=2).stderr
        else:
            assert run("--isa", isa, "-o", f"{isa}.nc").returncode == 0


def test_instruction_sets_are_for_lanes(run, scene):
    # Seen red: with --isa taken and not used.
    done = run("--isa", "baseline", "--engine", "scalar", code=2)
    assert "--isa baseline: only lanes are made of instructions to choose" in done.stderr


def test_large_sets_take_no_more_memory(run, scene):
    # Seen red: with so many sets at once as of single walks (1.7 GB).
    run("--set", "simulation.estimator=bidirectional", "--set", "simulation.walks=100", "--photons", "600", "--threads", "2")
    assert resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss < 1_000_000  # kB
