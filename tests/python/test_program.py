"""photic.run with stand-ins for the program, that say what they were called with."""

import os
import warnings
from pathlib import Path

import numpy
import pytest

import photic
from photic import program


def stand_in(path, body):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(f"#!/bin/sh\n{body}\n")
    path.chmod(0o755)
    return path


@pytest.fixture
def recorder(sample, tmp_path):
    """Writes its arguments, one a line, to `arguments` and the sample where -o says."""
    body = f'printf "%s\\n" "$@" > {tmp_path}/arguments\ncp {sample} "$4"'
    return stand_in(tmp_path / "photic", body)


def call(recorder, *arguments, **keywords):
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        result = photic.run(*arguments, program=recorder, **keywords)
    return result, (recorder.parent / "arguments").read_text().splitlines()


def test_arguments(recorder, tmp_path):
    _, arguments = call(
        recorder,
        Path("ship.toml"),
        set={"sea.layer.0.chlorophyll_mg_m3": 0.5, "simulation.estimator": "forward"},
        photons=1e7,
        threads=2,
        output=tmp_path / "kept.nc",
    )
    assert arguments == [
        "run", "ship.toml", "-o", str(tmp_path / "kept.nc"),
        "--set", "sea.layer.0.chlorophyll_mg_m3=0.5", "--set", 'simulation.estimator="forward"',
        "--photons", "10000000", "--threads", "2",
    ]
    assert (tmp_path / "kept.nc").exists()


def test_result_without_output_leaves_no_file(recorder):
    result, arguments = call(recorder, "ship.toml")
    assert list(result.channel.values) == ["elastic", "raman", "chlorophyll"]
    assert arguments[:3] == ["run", "ship.toml", "-o"] and len(arguments) == 4
    assert not os.path.exists(os.path.dirname(arguments[3]))


def test_warnings_of_the_run_reach_python(recorder):
    with pytest.warns(UserWarning, match="3 photons were lost"):
        photic.run("ship.toml", program=recorder)


# Seen red: with what the program says beside a result dropped.
def test_remarks_on_the_scene_reach_python(sample, tmp_path):
    remark = "ship.toml:50:16: steps of 3 m do not fill the 50"
    remarking = stand_in(tmp_path / "photic", f"echo '{remark}' >&2\ncp {sample} \"$4\"")
    with pytest.warns(UserWarning, match=f"^{remark}"):
        photic.run("ship.toml", program=remarking)


def test_errors_carry_message_and_code(tmp_path):
    failing = stand_in(tmp_path / "photic", "echo 'a.toml:3:1: no such key' >&2; exit 2")
    with pytest.raises(photic.Error, match="^a.toml:3:1: no such key$") as error:
        photic.run("a.toml", program=failing)
    assert error.value.exit_code == 2
    silent = stand_in(tmp_path / "silent", "exit 1")
    with pytest.raises(photic.Error, match="silent ended with code 1"):
        photic.run("a.toml", program=silent)


def test_output_must_be_netcdf(recorder):
    with pytest.raises(photic.Error, match="ends in .nc"):
        photic.run("a.toml", output="a.csv", program=recorder)


def test_a_program_asked_for_is_taken_or_an_error(tmp_path, monkeypatch):
    other = stand_in(tmp_path / "other", "exit 0")
    monkeypatch.setenv("PHOTIC_PROGRAM", str(other))
    assert program.find_program() == str(other)
    asked = stand_in(tmp_path / "asked", "exit 0")
    assert program.find_program(asked) == str(asked)
    monkeypatch.setenv("PHOTIC_PROGRAM", str(tmp_path / "none"))
    with pytest.raises(photic.Error, match="none: there is no such program") as error:
        program.find_program()
    assert error.value.exit_code == 1


@pytest.mark.parametrize(
    "package, executable",
    [
        ("prefix/lib/python3/dist-packages/photic", "prefix/bin/photic"),
        ("tree/python/photic", "tree/build/release/apps/photic/photic"),
    ],
)
def test_the_program_beside_the_package(tmp_path, monkeypatch, package, executable):
    monkeypatch.delenv("PHOTIC_PROGRAM")
    in_path = stand_in(tmp_path / "bin" / "photic", "exit 0")
    monkeypatch.setenv("PATH", str(tmp_path / "bin"))
    monkeypatch.setattr(program, "__file__", str(tmp_path / package / "program.py"))
    assert program.find_program() == str(in_path)
    beside = stand_in(tmp_path / executable, "exit 0")
    assert program.find_program() == str(beside)
    beside.unlink()
    in_path.unlink()
    with pytest.raises(photic.Error, match="the program photic was not found"):
        program.find_program()


def test_a_program_that_cannot_run(tmp_path):
    broken = tmp_path / "broken"
    broken.write_bytes(b"\x7fELF nonsense")
    broken.chmod(0o755)
    with pytest.raises(photic.Error, match="broken: cannot run the program") as error:
        photic.run("a.toml", program=broken)
    assert error.value.exit_code == 1


@pytest.mark.parametrize(
    "value, text",
    [
        (True, "true"),
        (numpy.bool_(False), "false"),
        (3, "3"),
        (numpy.int64(3), "3"),
        (0.1, "0.1"),
        (numpy.float64(1e-5), "1e-05"),
        (float("inf"), "inf"),
        ("1", '"1"'),
        ('say "häß"\\\n', '"say \\"häß\\"\\\\\\n"'),
        ([1, 2.5, "x"], '[1, 2.5, "x"]'),
        (numpy.array([0.0, 1.0]), "[0.0, 1.0]"),
        ({"model": "rayleigh", "slope": 0.5}, '{"model" = "rayleigh", "slope" = 0.5}'),
    ],
)
def test_values_as_toml(value, text):
    assert program.toml_value(value) == text


def test_a_value_no_scene_can_hold():
    with pytest.raises(photic.Error, match="not a value that a scene can hold"):
        program.toml_value(None)
