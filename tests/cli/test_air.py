"""The air of scenes from end to end: profiles in other units, and aerosols by their optical depth."""

import netCDF4
import pytest
from test_optics import as_json

AIR = '[atmosphere]\nprofile = "us-standard"\naerosol = "maritime"\n'


def with_air(scene, air):
    scene.write_text(scene.read_text().replace('[[channel]]\nname = "raman"\nprocess = "raman"\n', "") + air)


def depth_at_550(photic, *more):
    """Of all aerosols, by the layers that light meets."""
    layers = as_json(photic, "--air", "quick.toml", "--wavelengths", "550", *more)["layers"]
    aerosols = [layer["parts"]["aerosols"] for layer in layers]
    thickness = [layer["top_altitude_m"] - layer["altitude_m"] for layer in layers]
    return sum(m * sum(values[0] for values in part.values()) for m, part in zip(thickness, aerosols))


# An optical depth of 17.5 for 0.47, in silence. Seen red: without fault_of() in air_profile().
def test_altitudes_in_metres_are_refused(photic, scene, tmp_path):
    (tmp_path / "levels.csv").write_text("z_km,p_hpa,t_k\n0,1012,289\n9000,309,231\n95000,8e-4,190\n")
    with_air(scene, '[atmosphere]\nprofile = "levels.csv"\n')
    done = photic("check", "quick.toml")
    assert (done.returncode, done.stdout) == (2, "")
    assert done.stderr.startswith(
        f"{tmp_path}/levels.csv:3:1: the pressure falls from 1012 to 309 hPa between 0 and 9000 km: in hydrostatic air of "
        "260 K that takes 9.03 km (are the altitudes in m, and not in km?)\n")
    (tmp_path / "levels.csv").write_text("z_km,p_hpa,t_k\n0,1012,289\n9,309,231\n95,8e-4,190\n")
    done = photic("show", "quick.toml", "--set", "atmosphere.top_km=95")
    assert (done.returncode, done.stderr) == (0, "")
    assert "from the sea to the top: 0.4" in done.stdout


# Seen red: with four digits; with the depth of the boundary layer alone.
@pytest.mark.parametrize("depth", [0.1, 0.2, 1.234567])
def test_an_optical_depth_is_given_back(photic, scene, depth):
    with_air(scene, f"{AIR}aerosol_optical_depth_550 = {depth}\n")
    done = photic("show", "quick.toml")
    assert (done.returncode, done.stderr) == (0, "")
    assert f"#   optical depth of the aerosols at 550 nm: {depth}\n" in done.stdout
    assert depth_at_550(photic) == pytest.approx(depth, rel=1e-9)
    assert "visibility_km" not in done.stdout


# LOWTRAN 7 prints 1.170 for 5 km. Seen red: with layers that are exponential where the profile goes straight to 0.
def test_visibilities_have_their_optical_depths(photic, scene):
    with_air(scene, AIR)
    for km, depth in {5: 1.171, 10: 0.674, 23: 0.325, 40: 0.195}.items():
        reported = depth_at_550(photic, "--set", f"atmosphere.visibility_km={km}")
        assert reported == pytest.approx(depth, abs=6e-4)
        if km == 23:
            assert depth_at_550(photic) == reported


# From the scene's histories, in results that read back. Seen red: without take_out_replaced().
def test_environments_and_derivatives_know_the_optical_depth(photic, scene, tmp_path):
    with_air(scene, AIR + '[[environment]]\nname = "haze"\nset = { "atmosphere.aerosol_optical_depth_550" = 0.6 }\n'
             '[[environment]]\nname = "clean"\nset = { "atmosphere.aerosol" = "none" }\n')
    assert photic("run", "quick.toml", "-o", "out.nc").returncode == 0
    assert photic("show", "out.nc").returncode == 0
    done = photic("run", "--continue", "out.nc", "--photons", "40000")
    assert done.returncode == 0, done.stderr
    scene.write_text(scene.read_text().split("[[environment]]")[0])
    asked = ["--set", "atmosphere.aerosol_optical_depth_550=0.2", "--set", "sensitivity=['atmosphere.aerosol_optical_depth_550']"]
    done = photic("run", "quick.toml", *asked, "-o", "by-depth.nc")
    assert done.returncode == 0, done.stderr
    with netCDF4.Dataset(tmp_path / "by-depth.nc") as file:
        assert (file["logarithmic_sensitivity"][:] < 0).any()


REFUSED = {
    "both": ("visibility_km = 23\naerosol_optical_depth_550 = 0.2", "quick.toml:32:29: it takes the place of visibility_km"),
    "none": ('aerosol_optical_depth_550 = 0.2\naerosol = "none"', "aerosol = \"none\" says that there are no aerosols"),
    "negative": ("aerosol_optical_depth_550 = -0.2", "must be a finite number, at least 0 and at most 5, not -0.2"),
    "too much": ("aerosol_optical_depth_550 = 5.5", "must be a finite number, at least 0 and at most 5, not 5.5"),
    "too little": ("aerosol_optical_depth_550 = 0.08", "aerosols above the boundary layer alone, 0.08837 (write at least 0.0884,"),
}


@pytest.mark.parametrize("what", REFUSED)
def test_refuses_an_optical_depth(photic, scene, what):
    keys, message = REFUSED[what]
    with_air(scene, f'[atmosphere]\nprofile = "us-standard"\n{keys}\n')
    done = photic("check", "quick.toml")
    assert (done.returncode, done.stdout) == (2, "")
    assert "quick.toml:" in done.stderr and message in done.stderr


# Seen red: without the remark on fractions.
def test_remarks_on_units(photic, scene):
    with_air(scene, AIR)
    for key, question in {"relative_humidity_percent=0.8": "is it a fraction?", "visibility_km=250": "is it in m?"}.items():
        done = photic("check", "quick.toml", "--set", f"atmosphere.{key}")
        assert done.returncode == 0 and question in done.stdout + done.stderr
    layer = 'atmosphere={ layer = [{ bottom_height_m = 0, top_height_m = 99, refractive_index = 2, iop = [{ wavelength_nm = 532, a_per_m = 0, b_per_m = 1e-4 }] }] }'
    done = photic("check", "quick.toml", "--set", layer)
    assert done.returncode == 0 and "no air has a refractive index of 2" in done.stdout + done.stderr
