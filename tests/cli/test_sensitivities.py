"""Derivatives of echoes, as far as scenes define them."""

import json


def asking(scene, paths):
    """The scene with the key on top: the first path stands in line 1, column 16."""
    scene.write_text(f"sensitivity = [{paths}]\n" + scene.read_text())


def test_what_is_wrong_is_reported_at_the_path(photic, scene):
    asking(scene, '"sea.layer.0.chlorophyl_mg_m3",\n "sea.layer.1.cdom_a440_per_m", "gates.depth_step_m"')
    done = photic("check", "quick.toml")
    assert done.returncode == 2
    assert done.stderr.splitlines()[:-1] == [
        "quick.toml:1:16: there is no 'chlorophyl_mg_m3' in 'sea.layer.0' (did you mean 'chlorophyll_mg_m3'?)",
        "quick.toml:2:2: 'sea.layer.1.cdom_a440_per_m' is 0: the derivative may be infinite there, "
        "and no step is small relative to it (give it a small value instead)",
        "quick.toml:2:33: there is no derivative with respect to 'gates.depth_step_m': "
        "only the water, the bed, a film of oil and the air may differ, since the histories are the same "
        "(name paths that begin with sea., optics., bottom., oil. or atmosphere.)",
    ]


# The optics look at the steps, too: an only entry reaches 1 nm. Seen red: with the optics not asked.
def test_steps_without_data_are_refused(photic, scene):
    text = scene.read_text().replace("chlorophyll_mg_m3 = 1.0", "iop = [{ wavelength_nm = 533.0, a_per_m = 0.1, b_per_m = 0.1 }]\n"
                                     'phase_function = "petzold"')
    scene.write_text(text.replace('[[channel]]\nname = "raman"\nprocess = "raman"\n', ""))
    asking(scene, '"sea.layer.1.iop.0.wavelength_nm"')
    done = photic("check", "quick.toml")
    assert done.returncode == 2
    assert done.stderr.startswith("quick.toml:1:16: no step of 'sea.layer.1.iop.0.wavelength_nm' to 533.533 can be made: ")
    assert "covers 532.533 to 534.533 nm, not 532 nm" in done.stderr


def test_a_scene_may_have_them(photic, scene):
    asking(scene, '"sea.layer.0.chlorophyll_mg_m3"')
    assert photic("check", "quick.toml").returncode == 0


def test_set_and_schema(photic, scene):
    done = photic("check", "quick.toml", "--set", 'sensitivity=["sea.layer.0.name"]')
    assert done.returncode == 2
    assert done.stderr.startswith("--set sensitivity: 'sea.layer.0.name' is text \"layer0\", not a number (name the path")
    schema = json.loads(photic("schema").stdout)
    assert schema["properties"]["sensitivity"]["type"] == "array"
    assert schema["properties"]["environment_grid"]["type"] == "object"
