"""A telescope's focus: echoes, what is shown and remarked, and that focus_m goes wherever other keys go."""

import csv
import json
import math
import re

import netCDF4
import pytest

SCENE = """\
title = "a view of 10 mrad from a ship"
channel = [{{ name = "elastic", process = "elastic" }}]
gates = {{ depth_min_m = -1, depth_max_m = 5, depth_step_m = 2 }}
simulation = {{ photons = 60000, estimator = "forward" }}
sea.surface = {{ model = "cox-munk", wind_speed_m_s = 5, whitecaps = false }}
sea.layer = [{{ chlorophyll_mg_m3 = 0.1 }}]
sea.refractive_index = 1.34
[[telescope]]
position_m = [0, 0, 12]
direction = [0, 0, -1]
diameter_m = 0.4
focal_length_m = 2
half_field_of_view_mrad = 10
{}
[source]
wavelength_nm = 532
position_m = [0, 0, 12]
direction = [0, 0, -1]
diameter_m = 0.04
half_divergence_mrad = 5
"""
REMARK = (
    "ship.toml:8:1: the sea's surface, 12 m away, is out of focus: its light reaches the detector through 0.36 of the open "
    "lens; focus_m = 12 puts it in focus, detector_shift_m = 0 leaves it so\n"
)
SHARES = "# The share of each open lens whose rays reach the detector, from points on its axis:\n"


@pytest.fixture
def ship(tmp_path):
    path = tmp_path / "ship.toml"
    path.write_text(SCENE.format(""))
    return path


def echoes(photic, tmp_path, *arguments):
    done = photic("run", "ship.toml", *arguments, "-o", "out.nc", "--force")
    assert done.returncode == 0, done.stderr
    with netCDF4.Dataset(tmp_path / "out.nc") as result:
        return result["echo"][0, 0].tolist()


def glint_straight_down(height, wind):
    """docs/theory.md, eqs. 87 and 91, of a lens of 0.4 m."""
    across, up = math.sqrt(0.003 + 0.00192 * wind), math.sqrt(0.00316 * wind)
    bracket = 1 + 0.40 / 24 * 3 + 0.12 / 4 + 0.23 / 24 * 3
    density = bracket / (2 * math.pi * across * up)
    reflectance = ((1.34 - 1) / (1.34 + 1)) ** 2
    return reflectance * density * math.pi * 0.2**2 / (4 * height**2)


def test_the_surface_s_echo_is_that_of_the_closed_form_in_focus(photic, ship, tmp_path):
    """The wind's signal, and 0.36 of it where the detector stands in the focal plane.

    Seen red: with the detector left in the focal plane; with f^2 / d for the shift.
    """
    glint = glint_straight_down(12, 5)
    focused = echoes(photic, tmp_path, "--set", "telescope.0.focus_m=12")
    assert focused[0] == pytest.approx(glint, rel=0.02)
    assert echoes(photic, tmp_path, "--set", "telescope.0.detector_shift_m=0.4") == focused
    assert echoes(photic, tmp_path)[0] == pytest.approx(0.36 * glint, rel=0.02)


def test_what_is_out_of_focus_is_remarked_on_and_shown(photic, ship):
    """Seen red: without the notes; without the remark."""
    done = photic("check", "ship.toml")
    assert (done.stdout, done.stderr) == ("ship.toml: no problems\n", REMARK)
    shown = photic("show", "ship.toml").stdout
    assert SHARES + "#   telescope0, focused at infinity: 0.36 from the sea's surface, 0.56 from the last gate (depth 4\n" in shown
    focused = photic("check", "ship.toml", "--set", "telescope.0.focus_m=12")
    assert (focused.stdout, focused.stderr) == ("ship.toml: no problems\n", "")


def test_the_effective_scene_has_the_focus_as_it_was_given(photic, ship, tmp_path):
    """Seen red: with detector_shift_m beside it."""
    ship.write_text(SCENE.format("focus_m = 12"))
    shown = photic("show", "ship.toml")
    telescope = json.loads(photic("show", "ship.toml", "--json").stdout)["telescope"][0]
    assert (telescope["focus_m"], "detector_shift_m" in telescope) == (12, False)
    (tmp_path / "again.toml").write_text(shown.stdout)
    assert photic("show", "again.toml").stdout == shown.stdout
    echoes(photic, tmp_path)
    assert photic("show", "out.nc").stdout == shown.stdout


def test_a_run_with_a_focus_goes_on(photic, ship, tmp_path):
    """Seen red: with focus_m left out of the scene that is written."""
    ship.write_text(SCENE.format("focus_m = 12"))
    whole = echoes(photic, tmp_path, "--set", "simulation.batch_photons=500")
    echoes(photic, tmp_path, "--photons", "20000", "--force")
    assert echoes(photic, tmp_path, "--continue", "out.nc") == whole
    for other, was, now in [("12.5", "12", "12.5"), ("13", "12", "13")]:
        done = photic("run", "ship.toml", "--continue", "out.nc", "--photons", "90000", "--set", f"telescope.0.focus_m={other}")
        assert done.returncode == 2
        assert f"telescope.0.focus_m was {was} and is {now} now" in done.stderr


def test_environments_have_the_scene_s_focus(photic, ship):
    ship.write_text(SCENE.format("focus_m = 12") + '[[environment]]\nset = { "telescope.0.focus_m" = 13 }\n')
    done = photic("check", "ship.toml")
    assert done.returncode == 2
    assert "telescope.0.focus_m" in done.stderr


def test_a_gate_about_the_surface_is_at_0(photic, ship, tmp_path):
    """Edges of gates come of paths that round: the middle of the first one was -2e-16 m.

    Seen red: with the depth of the edge's path as it is.
    """
    for wide in [2, 0.2]:
        gates = ["--set", f"gates={{ depth_min_m = {-wide / 2}, depth_max_m = {2.5 * wide}, depth_step_m = {wide} }}"]
        run = ["run", "ship.toml", "--photons", "4000", *gates, "--force"]
        table = photic(*run, "-o", "out.nc").stdout
        assert "-0.00" not in table
        assert re.search(r"^ *0\.00 +\d", table, re.MULTILINE)
        assert photic(*run, "-o", "out.csv").returncode == 0
        first = json.loads(photic(*run, "--json", "-o", "out.nc").stdout)["echoes"][0]["depth_m"]
        assert (first, math.copysign(1, first)) == (0, 1)
        with netCDF4.Dataset(tmp_path / "out.nc") as result:
            first = float(result["gate_depth"][0, 0, 0])
            assert (first, math.copysign(1, first)) == (0, 1)
            assert result["gate_depth_bounds"][0, 0, 0].tolist() == [-wide / 2, wide / 2]
        with open(tmp_path / "out.csv", newline="") as lines:
            row = next(csv.DictReader(line for line in lines if not line.startswith("#")))
        assert row["depth_m"] == "0"
