"""What the pages of docs/howto say of a scene is what a run of it does."""

import json
import math
import re

import netCDF4
from conftest import SOURCE


def scene_of(page):
    """The scene that a page writes first."""
    text = (SOURCE / "docs/howto" / page).read_text()
    return re.search(r"^cat >(\w+\.toml) <<'END'\n(.*?)^END$", text, re.MULTILINE | re.DOTALL)[2]


# Seen red: with the formula as "bearing that the wind comes from - bearing of the x axis", and 225 in the scene.
def test_a_wind_from_the_north_west(photic, tmp_path):
    """A lidar tilted by 15 degrees sees most of the surface where it looks along the wind, and more with it than
    against it (Cox & Munk's skewness): 3.2, 2.8 and 1.6e-6 on picture wind.png, with errors below 1 %."""
    page = (SOURCE / "docs/howto/waves.md").read_text()
    assert "wind_direction_deg = bearing of the x axis - bearing that the wind comes from" in page
    assert "With x to the east, 90 - 315 = -225, which is the direction\n135 of the scene above" in page
    scene = scene_of("waves.md")
    assert "wind_direction_deg = 135" in scene
    (tmp_path / "waves.toml").write_text(scene)
    seen = {}
    for bearing in (135, 315, 45, 225):
        along = math.radians(90 - bearing)
        down = [math.sin(math.radians(15)) * math.cos(along), math.sin(math.radians(15)) * math.sin(along), -math.cos(math.radians(15))]
        changes = {"source.direction": down, "telescope.0.direction": down, "sea.surface.wind_speed_m_s": 8}
        changes |= {"simulation.photons": 20000, "simulation.estimator": "forward", "gates.depth_max_m": 1}
        options = [each for key, value in changes.items() for each in ("--set", f"{key}={json.dumps(value)}")]
        done = photic("run", "waves.toml", "-o", "out.nc", "--force", *options)
        assert done.returncode == 0, done.stderr
        with netCDF4.Dataset(tmp_path / "out.nc") as file:
            surface = list(file["process_name"][:]).index("surface")
            seen[bearing] = float(file["echo_by_process"][0, 0, surface].sum())
    assert seen[135] > 1.05 * seen[315] and seen[315] > 1.3 * max(seen[45], seen[225])


# Seen red: with the bed at 10 m, where it is in the gate behind.
def test_the_bed_is_in_the_middle_of_a_gate(photic, tmp_path):
    (tmp_path / "bed.toml").write_text(scene_of("bed.md"))
    done = photic("run", "bed.toml", "--photons", "20000", "-o", "out.nc")
    assert done.returncode == 0, done.stderr
    with netCDF4.Dataset(tmp_path / "out.nc") as file:
        bottom = list(file["process_name"][:]).index("bottom")
        by_gate = file["echo_by_process"][0, 0, bottom]
        depth = file["gate_depth"][0, 0]
    assert by_gate[9] > 0.999 * by_gate.sum() and abs(depth[9] - 9.5) < 0.01
