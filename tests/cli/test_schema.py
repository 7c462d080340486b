"""photic schema: good JSON Schema, which takes the scenes that photic takes and refuses what it refuses."""

import json
import tomllib

import jsonschema
import pytest
from conftest import QUICK_SCENE, SOURCE


@pytest.fixture
def validator(photic):
    done = photic("schema")
    assert (done.returncode, done.stderr) == (0, "")
    schema = json.loads(done.stdout)
    jsonschema.Draft202012Validator.check_schema(schema)
    return jsonschema.Draft202012Validator(schema)


def test_its_name_has_the_version(photic, validator):
    version = photic("--version").stdout.split()[1]
    assert validator.schema["$id"] == f"urn:photic:scene:{version}"
    assert validator.schema["$schema"] == "https://json-schema.org/draft/2020-12/schema"


def test_shipped_scenes_are_valid(photic, validator):
    # Seen red: with shortest_nm = 600.
    scenes = sorted((SOURCE / "scenes").glob("*.toml"))
    assert len(scenes) >= 6
    for path in scenes:
        validator.validate(tomllib.loads(path.read_text()))
        effective = json.loads(photic("show", path, "--json").stdout)
        validator.validate(effective)


# What replaces what in the quick scene.
GOOD = {
    "steps": ('process = "elastic"', "centre_nm = { from = 500, to = 600, step = 50 }\nfwhm_nm = 3"),
    "profile": (
        "chlorophyll_mg_m3 = 0.1",
        'chlorophyll_mg_m3 = { depth_m = [0, 5], value = [1, 2], above = "constant" }',
    ),
    "word": (
        "chlorophyll_mg_m3 = 0.1",
        'iop = [{ wavelength_nm = 400, a_per_m = 1, b_per_m = 1 }, { wavelength_nm = 800, a_per_m = 1, b_per_m = 1 }]\n'
        'phase_function = "petzold"',
    ),
    "float": ("photons = 20000", "photons = 1e7"),
    "waves": ("[gates]", '[sea.surface]\nmodel = "cox-munk"\nwind_speed_m_s = 5\nslick = true\n[gates]'),
    "waves of one's own": (
        "[gates]",
        '[sea.surface]\nmodel = "gaussian"\nupwind_slope_variance = 0.01\ncrosswind_slope_variance = 0\n[gates]'),
    "calm": ("[gates]", '[sea.surface]\nmodel = "paper"\nwind_speed_m_s = 0\nwhitecaps = false\n[gates]'),
    "bed": ("[gates]", "bottom_depth_m = 20.0\n[bottom]\nalbedo = 0.1\n[gates]"),
    "bed by angle": ("[gates]", "bottom_depth_m = 20.0\n[bottom]\nalbedo = { zenith_deg = [0, 90], albedo = [0.1, 0.2] }\n[gates]"),
    "air": ("[gates]", '[atmosphere]\nprofile = "us-standard"\naerosol = "maritime"\n[gates]'),
    "levels of air": (
        "[gates]",
        "[atmosphere]\nprofile = { z_km = [0, 9], p_hpa = [1000, 300], t_k = [290, 230] }\ntop_km = 9\n[gates]"),
    "air of an optical depth": ("[gates]", '[atmosphere]\nprofile = "us-standard"\naerosol_optical_depth_550 = 0.2\n[gates]'),
    "a Gaussian beam": ("[source]", '[source]\nprofile = "gaussian"'),
    "a strength": ("[source]", "[source]\nenergy_j = 0.1"),
    "a tally beside a telescope": ("[gates]", '[[tally]]\nkind = "irradiance"\nheight_m = [0]\ndepth_m = [1, 2]\n[gates]'),
    "a tally of boundaries": ("[gates]", '[[tally]]\nkind = "boundaries"\nzenith_deg = [0, 45, 90]\n[gates]'),
    "facets": ("[gates]", '[sea.surface]\nmodel = "cox-munk"\nwind_speed_m_s = 5\nfacets = "reciprocal"\n[gates]'),
    "a focus": ("detector_shift_m = 0.0", "focus_m = 12.0"),
    "no shift": ("detector_shift_m = 0.0", ""),
    "columns": (
        "[[sea.layer]]\nbottom_depth_m = 5.0\nchlorophyll_mg_m3 = 0.1\n[[sea.layer]]\n",
        "[sea]\ny_min_m = -9\n[[sea.column]]\nx_max_m = 0\n[[sea.column.layer]]\n[[sea.column]]\n[[sea.column.layer]]\n"),
    "layers of air": (
        "[gates]",
        "[[atmosphere.layer]]\nbottom_height_m = 0\ntop_height_m = 9\n"
        "iop = [{ wavelength_nm = 300, a_per_m = 0, b_per_m = 0 }, { wavelength_nm = 900, a_per_m = 0, b_per_m = 0 }]\n[gates]"),
}
FAULTY = {
    "unknown key": ("diameter_m = 0.04", "diameter_m = 0.04\ndiametre_m = 0.04"),
    "missing key": ("diameter_m = 0.04", ""),
    "text for a number": ("diameter_m = 0.04", 'diameter_m = "4 cm"'),
    "below 0": ("diameter_m = 0.04", "diameter_m = -0.04"),
    "wavelength in um": ("wavelength_nm = 532.0", "wavelength_nm = 0.532"),
    "angle too wide": ("half_divergence_mrad = 5.0", "half_divergence_mrad = 1571"),
    "vector of two": ("position_m = [0.0, 0.0, 12.0]", "position_m = [0.0, 12.0]"),
    "unknown choice": ('process = "elastic"', 'process = "ELASTIC"'),
    "keys of a laser": ("[source]", '[source]\nkind = "cone"\nhalf_angle_deg = 5'),
    "sun below the horizon": (
        'position_m = [0.0, 0.0, 12.0]\ndirection = [0.0, 0.0, -1.0]\ndiameter_m = 0.04\nhalf_divergence_mrad = 5.0',
        'kind = "beam"\nzenith_deg = 90'),
    "two strengths": ("[source]", "[source]\nenergy_j = 0.1\nphotons_per_pulse = 1e15"),
    "unknown profile": ("[source]", '[source]\nprofile = "flat"'),
    "strength of another kind": ("[source]", "[source]\npower_w = 1"),
    "columns beside layers": ("[gates]", "[[sea.column]]\n[[sea.column.layer]]\n[gates]"),
    "a width of layers": ("[gates]", "[sea]\ny_min_m = -9\n[gates]"),
    "a column without layers": (
        "[[sea.layer]]\nbottom_depth_m = 5.0\nchlorophyll_mg_m3 = 0.1\n[[sea.layer]]\nchlorophyll_mg_m3 = 1.0\n",
        "[[sea.column]]\nx_max_m = 0\n"),
    "levels of no tally": ("[gates]", "[[tally]]\ndepth_m = [1]\n[gates]"),
    "one level without a list": ("[gates]", '[[tally]]\nkind = "irradiance"\ndepth_m = 1\n[gates]'),
    "no level": ("[gates]", '[[tally]]\nkind = "irradiance"\n[gates]'),
    "fluence by depth and height": (
        "[gates]", '[[tally]]\nkind = "fluence"\ndepth_m = [1, 2]\nheight_m = [1, 2]\nx_m = [0, 1]\n[gates]'),
    "direction of three angles": (
        "[gates]", '[[tally]]\nkind = "radiance"\ndepth_m = [1]\ndirection_deg = [[0, 0, 0]]\n[gates]'),
    "ground in place of a sea that is there": (
        "[gates]", '[atmosphere]\nprofile = "us-standard"\nsurface = { albedo = 0.1 }\n[gates]'),
    "unknown word": (
        "chlorophyll_mg_m3 = 0.1",
        'iop = [{ wavelength_nm = 532, a_per_m = 1, b_per_m = 1 }]\nphase_function = "petzhold"',
    ),
    "word that needs more": (
        "chlorophyll_mg_m3 = 0.1",
        'iop = [{ wavelength_nm = 532, a_per_m = 1, b_per_m = 1 }]\nphase_function = "rayleigh"',
    ),
    "two that exclude each other": ("photons = 20000", "photons = 20000\n[sea]\nsurface = { model = 'waves' }"),
    "both fields of view": ("detector_diameter_m = 0.04", "detector_diameter_m = 0.04\nhalf_field_of_view_mrad = 10"),
    "a shift and a focus": ("detector_shift_m = 0.0", "detector_shift_m = 0.0\nfocus_m = 12.0"),
    "gates of two kinds": ("depth_step_m = 1.0", "depth_step_m = 1.0\nrange_min_m = 3"),
    "no end": ("photons = 20000", ""),
    "a share above 1": ("photons = 20000", "target_relative_error = 2"),
    "half a photon": ("photons = 20000", "photons = 0.5"),
    "key of another section": ("photons = 20000", "photons = 20000\ndepth_step_m = 1"),
    "air of no kind": ("[gates]", "[atmosphere]\ntop_km = 9\n[gates]"),
    "air of two kinds": (
        "[gates]",
        '[atmosphere]\nprofile = "us-standard"\n[[atmosphere.layer]]\nbottom_height_m = 0\ntop_height_m = 9\n'
        "iop = [{ wavelength_nm = 532, a_per_m = 0, b_per_m = 0 }]\n[gates]"),
    "a visibility in metres": ("[gates]", '[atmosphere]\nprofile = "us-standard"\nvisibility_km = 23000\n[gates]'),
    "an optical depth of per cent": ("[gates]", '[atmosphere]\nprofile = "us-standard"\naerosol_optical_depth_550 = 20\n[gates]'),
    "no section": ("[simulation]", "[simulations]"),
    "profile of one depth": (
        "chlorophyll_mg_m3 = 0.1", "chlorophyll_mg_m3 = { depth_m = [0], value = [1], above = 'constant' }"),
    "bed that reflects more than it gets": ("[gates]", "bottom_depth_m = 20.0\n[bottom]\nalbedo = 1.1\n[gates]"),
    "bed without albedo": ("[gates]", "bottom_depth_m = 20.0\n[bottom]\n[gates]"),
    "bed of nothing known": ("[gates]", "bottom_depth_m = 20.0\n[bottom]\nalbedo = { albedo = [0.1, 0.2] }\n[gates]"),
    "bed of a file and more": ("[gates]", "bottom_depth_m = 20.0\n[bottom]\nalbedo = { file = 'a.csv', albedo = [0.1, 0.2] }\n[gates]"),
    "waves without wind": ("[gates]", '[sea.surface]\nmodel = "cox-munk"\n[gates]'),
    "wind on a flat sea": ("[gates]", "[sea.surface]\nwind_speed_m_s = 5\n[gates]"),
    "yes as text": ("[gates]", '[sea.surface]\nmodel = "cox-munk"\nwind_speed_m_s = 5\nslick = "yes"\n[gates]'),
    "key of another surface": (
        "[gates]",
        '[sea.surface]\nmodel = "gaussian"\nupwind_slope_variance = 0.01\ncrosswind_slope_variance = 0\nslick = true\n[gates]'),
    "file without its choice": ("[gates]", '[optics]\nphytoplankton_file = "a.csv"\n[gates]'),
}


def edited(old, new):
    assert old in QUICK_SCENE
    return QUICK_SCENE.replace(old, new, 1)


@pytest.mark.parametrize("what", GOOD)
def test_what_photic_takes_is_valid(photic, scene, validator, what):
    text = edited(*GOOD[what])
    scene.write_text(text)
    assert photic("check", scene).stdout.endswith("no problems\n")
    validator.validate(tomllib.loads(text))


@pytest.mark.parametrize("what", FAULTY)
def test_what_photic_refuses_is_not_valid(photic, scene, validator, what):
    # Seen red: with all words for a phase function, those that need parameters, too.
    text = edited(*FAULTY[what])
    scene.write_text(text)
    assert photic("check", scene).returncode == 2
    assert not validator.is_valid(tomllib.loads(text))
