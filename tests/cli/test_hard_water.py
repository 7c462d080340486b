"""Water that hardly scatters, or does little else, and runs too short for an error: what is not known is said."""

import csv
import json
import math

import netCDF4
import pytest
from conftest import SOURCE

GATES = "[gates]\ndepth_max_m = 4.0\ndepth_step_m = 0.5\n"


@pytest.fixture
def water(scene):
    """Writes the quick scene with water of the given absorption and scattering, and its elastic channel alone."""

    head = scene.read_text().split('[[channel]]\nname = "raman"')[0]

    def write(a_per_m, b_per_m, gates=GATES):
        scene.write_text(
            f"{head}[[sea.layer]]\n"
            f"iop = [{{ wavelength_nm = 532.0, a_per_m = {a_per_m}, b_per_m = {b_per_m} }}]\n"
            f'phase_function = {{ model = "henyey-greenstein", g = 0.924 }}\n{gates}'
            "[simulation]\nphotons = 80000\n"
        )

    return write


def estimator(name):
    return "--set", f"simulation.estimator={name}"


def test_the_error_of_one_batch_is_not_known(photic, scene, tmp_path):
    # Seen red: with an error of 0 of a single batch.
    run = ("run", "quick.toml", "--photons", "8000", "--set", "simulation.batch_photons=8000", "-o")
    table = photic(*run, "one.nc").stdout
    shallow = next(line for line in table.splitlines() if line.startswith("        0.50"))
    assert shallow.split()[2:4] == ["-", "*"]
    with netCDF4.Dataset(tmp_path / "one.nc") as file:
        file.set_auto_mask(False)
        assert (file["echo"][:] > 0).any()
        for name in ("echo", "echo_by_order", "echo_by_process", "echo_by_depth"):
            assert not (file[f"{name}_standard_error"][:] > -1).any()
    assert photic(*run, "one.csv").returncode == 0
    rows = csv.DictReader(line for line in (tmp_path / "one.csv").open() if not line.startswith("#"))
    assert all(math.isnan(float(row["standard_error"])) for row in rows)
    for echo in json.loads(photic(*run, "one.nc", "--json").stdout)["echoes"]:
        assert echo["standard_error"] is None and echo["relative_error"] is None
        assert "few_batches" in echo["reasons"] or echo["reasons"] == ["no_score"]


def ledger_warnings(done):
    out = json.loads(done.stdout)
    return sum(out["ledger"].values()), [text for text in out["warnings"] if "weights add up" in text]


def test_a_ledger_that_is_not_whole_is_reported(photic, water):
    # Seen red: with a bound of a hundred errors.
    water(0.1, 5.0)
    forward = ("run", "quick.toml", "--json", *estimator("forward"))
    whole, warned = ledger_warnings(photic(*forward))
    assert whole < 0.8 and len(warned) == 1
    assert warned[0].startswith(f"the photons' weights add up to {whole:.2f}, not 1")
    assert "set directed_fraction = 0" in warned[0]
    whole, warned = ledger_warnings(photic(*forward, "--set", "simulation.directed_fraction=0"))
    assert abs(whole - 1) < 0.01 and warned == []


def test_a_ledger_of_few_photons_is_no_reason_to_worry(photic):
    # Which scatters by more than 2 %. Seen red: without a look at its own error.
    scene = SOURCE / "scenes/three-layers.toml"
    few = ("--photons", "80000", "--set", "simulation.batch_photons=8000")  # ten batches
    run = ("run", scene, "--json", *estimator("forward"), *few, "-o", "few.nc", "--seed")
    ledgers = [ledger_warnings(photic(*run, seed)) for seed in range(1, 7)]
    assert [warned for _, warned in ledgers if warned] == []
    assert max(abs(whole - 1) for whole, _ in ledgers) > 0.02


def test_walks_take_more_of_the_attenuation_where_it_is_scattering(photic, water, scene):
    # Seen red: with 0.6 for all.
    water(0.1, 5.0)
    bidirectional = estimator("bidirectional")

    def shown(*more):
        done = photic("show", "quick.toml", "--json", *bidirectional, *more)
        return json.loads(done.stdout)["simulation"]["walk_attenuation"], done.stderr

    assert shown() == (0.9, "")
    assert shown("--set", "simulation.walk_attenuation=0.7")[0] == 0.7
    done = photic("check", "quick.toml", *bidirectional, "--set", "simulation.walk_attenuation=0.7")
    assert done.returncode == 0
    assert "0.7 is small for water where scattering is 0.98 of the attenuation" in done.stderr
    water(0.1, 0.1)
    assert shown()[0] == 0.6


def test_a_run_with_the_usual_walks_goes_on(photic, water, tmp_path):
    # A scene that leaves open what its result states. Seen red: with the scene compared as it is written.
    water(0.1, 5.0)
    run = ("run", "quick.toml", *estimator("bidirectional"), "--photons")
    assert photic(*run, "2000", "-o", "old.nc").returncode == 0
    done = photic(*run, "4000", "--continue", "old.nc", "-o", "new.nc")
    assert (done.returncode, done.stderr) == (0, "")
    refused = photic(*run, "4000", "--continue", "old.nc", "--set", "simulation.walk_attenuation=0.95")
    assert refused.returncode == 2
    assert "walk_attenuation was 0.9 and is 0.95 now" in refused.stderr


@pytest.mark.parametrize("coefficient", ["1e-7", "1e-12"])
def test_auto_takes_what_sees_something(photic, water, tmp_path, coefficient):
    # Water so clear that the forward estimator's pilot sees next to nothing. Seen red: as it was, when seeing nothing cost nothing.
    water(coefficient, coefficient, "[gates]\ndepth_max_m = 50.0\ndepth_step_m = 5.0\n")
    done = photic("run", "quick.toml", "-o", "clear.nc")
    assert done.returncode == 0
    with netCDF4.Dataset(tmp_path / "clear.nc") as file:
        assert file.estimator == "bidirectional"
        assert (file["echo"][:] > 0).all()


def test_auto_says_that_it_saw_nothing(photic, water, tmp_path):
    # Seen red: with the forward estimator.
    water(0.1, 0.1, "[gates]\nstart_ns = 80.0\nstop_ns = 120.0\nstep_ns = 10.0\n")
    done = photic("run", "quick.toml", "-o", "dark.nc", "--set", "telescope.0.direction=[0, 0, 1]")
    assert done.returncode == 0
    assert "saw no light at all" in done.stdout
    with netCDF4.Dataset(tmp_path / "dark.nc") as file:
        assert file.estimator == "bidirectional"
        assert "walk_attenuation = 0.6\n" in file.scene
        assert 'estimator_reason = "no pilot run saw any light, so that nothing could be compared"' in file.scene
