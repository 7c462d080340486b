"""Flags are of what they say: none stays set however long a run is."""

import netCDF4
import numpy as np
import pytest

# A film of oil that shines over water that sends back Raman light.
SHINING = """\
channel = [{ name = "film", process = "oil" }, { name = "water", process = "raman" }]
gates = { depth_min_m = -1, depth_max_m = 5, depth_step_m = 2 }
simulation = { target_relative_error = 0.05, estimator = "bidirectional" }
telescope = [{ position_m = [0, 0, 12], direction = [0, 0, -1], diameter_m = 0.4, focal_length_m = 2, \
half_field_of_view_mrad = 10 }]
source = { wavelength_nm = 355, position_m = [0, 0, 12], direction = [0, 0, -1], diameter_m = 0.04, \
half_divergence_mrad = 5 }
sea.layer = [{ chlorophyll_mg_m3 = 1.0, cdom_a440_per_m = 0.05 }]
oil = { class = "weakly-absorbing-crude", thickness_um = 1.0 }
"""


def test_light_that_no_walk_carries_meets_its_target(photic, tmp_path):
    # Without a limit of time. Seen red: with beam_missed raised whatever walks carry, as it was; the run did not end.
    (tmp_path / "film.toml").write_text(SHINING)
    done = photic("run", "film.toml", "--threads", "1", "-o", "film.nc")
    assert done.returncode == 0
    assert "converged: film 3 of 3, water 3 of 3 gates\n" in done.stdout
    assert "stopped by: target\n" in done.stdout
    assert "beam_missed" not in done.stdout
    with netCDF4.Dataset(tmp_path / "film.nc") as file:
        echo, error = np.array(file["echo"][0, 0]), np.array(file["echo_standard_error"][0, 0])
    # By the forward estimator with 4e6 photons, known to 0.2 %.
    assert echo == pytest.approx([4.65e-9, 8.2e-10, 1.94e-11], rel=0.01)
    assert (error < 0.01 * echo).all()


@pytest.mark.parametrize(("estimator", "photons"), [("forward", 4e5), ("bidirectional", 8e4)])
def test_a_glint_that_is_known_has_no_heavy_tail(photic, tmp_path, estimator, photons):
    # Seen red (bidirectional): without the look at the echo.
    (tmp_path / "glint.toml").write_text(
        f"""\
channel = [{{ name = "elastic", process = "elastic" }}]
gates = {{ depth_min_m = -0.5, depth_max_m = 3.5, depth_step_m = 1 }}
simulation = {{ photons = {photons}, estimator = "{estimator}" }}
source = {{ wavelength_nm = 532, position_m = [0, 0, 10], direction = [0, 0, -1], diameter_m = 0.001, \
half_divergence_mrad = 3 }}
telescope = [{{ position_m = [0, 0, 10], direction = [0, 0, -1], diameter_m = 0.3, focal_length_m = 1.5, \
half_field_of_view_mrad = 20 }}]
sea.surface = {{ model = "gaussian", upwind_slope_variance = 0.015, crosswind_slope_variance = 0.015, whitecaps = false }}
[[sea.layer]]
iop = [{{ wavelength_nm = 532, a_per_m = 0.08, b_per_m = 0.1 }}]
phase_function = {{ model = "henyey-greenstein", g = 0.8 }}
"""
    )
    assert photic("run", "glint.toml", "-o", "glint.nc").returncode == 0
    with netCDF4.Dataset(tmp_path / "glint.nc") as file:
        assert file["echo_standard_error"][0, 0, 0] < 1e-4 * file["echo"][0, 0, 0]
        assert file["convergence_flags"][0, 0, 0] == 0
