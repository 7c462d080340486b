"""photic.optics.of: what `photic optics` writes of a scene, in memory."""

import numpy
import photic as package
import pytest
from conftest import QUICK_SCENE, SOURCE
from test_module_results import alike

AIR_ALONE = """\
source = { kind = "beam", wavelength_nm = 532.0, zenith_deg = 30.0 }
atmosphere = { profile = "us-standard", surface = { albedo = 0.1 } }
tally = [{ kind = "boundaries" }]
simulation = { photons = 1000 }
"""
SEAS = [kind for kind in sorted(package.Scene.kinds()) if "[sea" in (SOURCE / f"scenes/{kind}.toml").read_text()]


def of_program(photic, scene, path, *flags):
    done = photic("optics", scene, "-o", path, *flags)
    assert done.returncode == 0, done.stderr
    return package.open(path)


# Seen red: with axes that are not indexed.
@pytest.mark.filterwarnings("ignore::UserWarning")
@pytest.mark.parametrize("kind", SEAS)
def test_it_is_what_the_program_writes(photic, tmp_path, kind):
    theirs = of_program(photic, SOURCE / f"scenes/{kind}.toml", tmp_path / "optics.nc")
    assert alike(package.optics.of(package.Scene.new(kind)), theirs)


# Seen red: with wavelengths in the order given.
def test_at_wavelengths_in_any_order(photic, scene, tmp_path):
    theirs = of_program(photic, scene, tmp_path / "optics.nc", "--wavelengths", "450,532,650")
    for asked in ([650, 450.0, 532, 450], numpy.array([532, 650, 450]), (450, 532, 650)):
        ours = package.optics.of(scene, asked)
        assert alike(ours, theirs)
        assert "photic.optics.of(scene, [450.0, 532.0, 650.0])" in ours.attrs["history"]
    assert list(package.optics.of(package.Scene(QUICK_SCENE), 550).wavelength.values) == [550.0]


# Seen red: with the scene of the file after it was changed.
def test_of_the_scene_as_it_is_now(scene):
    changed = package.Scene.load(scene)
    before = package.optics.of(changed)
    changed["sea.layer.1.chlorophyll_mg_m3"] = 2.0
    after = package.optics.of(changed)
    assert bool((after.c_per_m[1] > before.c_per_m[1]).all()) and after.c_per_m[0].identical(before.c_per_m[0])
    assert "chlorophyll_mg_m3 = 2.0" in after.attrs["scene"]


@pytest.mark.parametrize(("asked", "reason"), [
    ("green", "wavelength_nm: 'green' are no numbers (write 532, or [532, 650])"),
    ([], "wavelength_nm: [] has no number, or one that is no wavelength in nm"),
    ([532, -1], "wavelength_nm: [532, -1] has no number, or one that is no wavelength in nm"),
    (float("nan"), "wavelength_nm: nan has no number, or one that is no wavelength in nm"),
    (5000.0, "wavelength_nm: "),
])  # fmt: skip
def test_wavelengths_that_are_refused(scene, asked, reason):
    with pytest.raises(package.Error) as refused:
        package.optics.of(scene, asked)
    assert str(refused.value).startswith(reason) and refused.value.exit_code == 2
    assert type(refused.value) is package.Error  # nothing is wrong with the scene


@pytest.mark.parametrize(("scene", "reason"), [
    (532, "scene: of type int, neither a photic.Scene nor the path of a scene file"),
    ("none.toml", "none.toml"),
    (package.Scene(AIR_ALONE), "the scene has no water: it is of air alone"),
])  # fmt: skip
def test_scenes_that_are_refused(scene, reason):
    with pytest.raises(package.Error) as refused:
        package.optics.of(scene)
    assert str(refused.value).startswith(reason)
