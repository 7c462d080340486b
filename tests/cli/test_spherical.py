"""Spherical air from end to end: what is refused, the engine, what `photic show` reports, results in files."""

import netCDF4
import numpy as np
import pytest

LAYERS = """
[[atmosphere.layer]]
bottom_height_m = 0
top_height_m = 20000
iop = [{ wavelength_nm = 532, a_per_m = 0, b_per_m = 1e-5 }]
[[atmosphere.layer]]
bottom_height_m = 20000
top_height_m = 60000
iop = [{ wavelength_nm = 532, a_per_m = 0, b_per_m = 1e-6 }]
"""
SPHERICAL = 'surface = { albedo = 0.1 }\ngeometry = "spherical"\n'
SUN = 'kind = "beam"\nzenith_deg = 60\n'
PENCIL = 'kind = "beam"\nposition_m = [0, 0, 1e5]\ndirection = [0, 0, -1]\n'
BOUNDARIES = '[[tally]]\nkind = "boundaries"\n'
ZONES = '[[tally]]\nkind = "irradiance"\nheight_m = [0, 10000]\nzone_deg = [0, 60, 90, 180]\n'


def scene_of(source=PENCIL, tally=BOUNDARIES, air=SPHERICAL, layers=LAYERS, rest=""):
    return (f"[source]\nwavelength_nm = 532\n{source}{tally}[atmosphere]\n{air}{layers}{rest}"
            "[simulation]\nphotons = 2000\n")


@pytest.fixture
def check(photic, tmp_path):
    """What is wrong with a scene: the lines on standard error, with the line of the scene that each is about."""

    def call(text):
        (tmp_path / "air.toml").write_text(text)
        done = photic("check", "air.toml")
        assert done.returncode == 2, done.stdout
        problems = []
        for line in done.stderr.splitlines()[:-1]:
            name, number, _, message = line.split(":", 3)
            assert name == "air.toml"
            problems.append((text.splitlines()[int(number) - 1], message))
        return problems

    return call


TELESCOPE = """[[telescope]]
position_m = [0, 0, 1e5]
direction = [0, 0, -1]
diameter_m = 0.5
focal_length_m = 2
detector_diameter_m = 0.04
[[channel]]
name = "e"
process = "elastic"
[gates]
depth_max_m = 10
depth_step_m = 1
"""
LASER = "position_m = [0, 0, 1e5]\ndirection = [0, 0, -1]\ndiameter_m = 0.1\nhalf_divergence_mrad = 0.1\n"

# Each with the line that it is about, the reason and the suggestion.
REFUSED = {
    "water below": (
        scene_of(air='geometry = "spherical"\n', rest="[[sea.layer]]\nchlorophyll_mg_m3 = 1\n"),
        'geometry = "spherical"', "below spherical air there is a ground, and no water",
        "write surface = { albedo = 0.1 } into [atmosphere]"),
    "a planet that is too small": (
        scene_of(air=SPHERICAL + "planet_radius_km = 2000\n"), "planet_radius_km = 2000",
        "the planet's radius of 2000 km is less than 50 times the top of its air at 60 km", "write at least 3000"),
    "a radius of plane air": (
        scene_of(air="surface = { albedo = 0.1 }\nplanet_radius_km = 6371\n"), "planet_radius_km = 6371",
        "'planet_radius_km'", "plane"),
    "refraction in plane air above a ground": (
        scene_of(LASER, air="surface = { albedo = 0.1 }\nrefraction = true\n"), "refraction = true",
        "plane air above a ground does not bend light", 'write geometry = "spherical"'),
    "a planet of planes": (
        scene_of(air=SPHERICAL + "planet_radius_km = 1e10\n"), "planet_radius_km = 1e10", "'planet_radius_km'",
        "plane air is as good"),
    "a source too far away": (
        scene_of(PENCIL.replace("1e5", "1e14")), "position_m = [0, 0, 1e14]",
        "the source is more than 1e+12 m away", "leave position_m of a beam out"),
    "a zone without area": (
        scene_of(SUN, ZONES.replace("60", "0.0001")), "zone_deg = [0, 0.0001, 90, 180]",
        "the zone from 0 to 0.0001 degrees is narrower than 0.001 degrees", "make it wider"),
    "zones in plane air": (
        scene_of(SUN, ZONES, "surface = { albedo = 0.1 }\n"), "zone_deg = [0, 60, 90, 180]",
        "there are zones below spherical air alone", 'write geometry = "spherical"'),
    "zones of a pencil": (
        scene_of(PENCIL, ZONES), "zone_deg = [0, 60, 90, 180]", "zones are for light as wide as the planet",
        "take a beam without position_m"),
    "a planet without zones": (
        scene_of(SUN, '[[tally]]\nkind = "irradiance"\nheight_m = [0]\n'), "[[tally]]",
        "a beam without a place lights the whole planet", "zone_deg = [0, 30, 60, 90, 180]"),
    "zones that fall": (
        scene_of(SUN, ZONES.replace("90, 180", "90, 80")), "zone_deg = [0, 60, 90, 80]", "80 does not come after 90",
        "ascending"),
    "a radiance": (
        scene_of(SUN, '[[tally]]\nkind = "radiance"\nheight_m = [0]\ndirection_deg = [[0, 0]]\n'), 'kind = "radiance"',
        "radiances are known where the air is the same at all places", 'geometry = "plane"'),
    "a fluence": (
        scene_of(PENCIL, '[[tally]]\nkind = "fluence"\nheight_m = [0, 100]\nradius_m = [0, 1]\n'), 'kind = "fluence"',
        "the cells of a fluence are between planes", 'geometry = "plane"'),
    "a source below the ground": (
        scene_of('kind = "cone"\nposition_m = [1e5, 0, -1000]\ndirection = [0, 0, 1]\nhalf_angle_deg = 180\n'),
        "position_m = [1e5, 0, -1000]", "the source is not above the ground", "put it into the air"),
    "a lamp above the air": (
        scene_of('kind = "cone"\nposition_m = [1e6, 0, 0]\ndirection = [0, 0, 1]\nhalf_angle_deg = 180\n'),
        "position_m = [1e6, 0, 0]", "above the top of the air at 60000 m", 'kind = "beam"'),
    "bent light of the sun in plane air": (
        scene_of(SUN, air="refraction = true\n", rest="[[sea.layer]]\nchlorophyll_mg_m3 = 1\n"), "refraction = true",
        "in plane air bent light is known along the axes of lasers and telescopes alone",
        'write geometry = "spherical"'),
    "a telescope": (
        scene_of(LASER, TELESCOPE), "[[telescope]]", "echoes are known in plane air alone", "take geometry = \"plane\""),
    "importances": (
        scene_of(rest="[simulation.tools]\nimportance = [{ depth_m = 1, value = 2 }]\n"), "importance = ",
        "importances are of depths", "leave them out"),
    "a black sea below plane air": (
        scene_of(air='surface = "sea"\n'), 'surface = "sea"', "a sea that is black below its surface", "spherical"),
    "a sea beside the ground": (
        scene_of(rest='[sea]\nsurface = { model = "flat" }\n'), "[sea]", "a ground takes the place of the sea", ""),
}


@pytest.mark.parametrize("name", REFUSED)
def test_what_is_not_known_is_refused(check, name):
    text, line, reason, suggestion = REFUSED[name]
    problems = check(text)
    assert [problem for problem in problems if line in problem[0] and reason in problem[1] and suggestion in problem[1]], problems
    assert len(problems) == 1, problems


def test_the_engine_is_the_scalar_one(photic, tmp_path):
    (tmp_path / "air.toml").write_text(scene_of())
    for options in [["--engine", "lanes"], ["--isa", "baseline"]]:
        done = photic("run", "air.toml", *options)
        assert done.returncode == 2
        assert "spherical air is followed in double, by the scalar engine alone" in done.stderr
        assert "leave out --engine and --isa" in done.stderr
    done = photic("run", "air.toml", "-o", "air.nc")
    assert (done.returncode, done.stderr) == (0, "")
    assert "engine: scalar" in done.stdout
    again = photic("run", "--continue", "air.nc", "--photons", "4000", "-o", "more.nc")
    assert again.returncode == 0, again.stderr
    assert "engine: scalar" in again.stdout


# sin(i) = (R + h)/R sin(t): 3 degrees off nadir at 705 km are 3.3323 at the ground, 15 are 16.7059 (world.md C).
def test_show_has_the_zenith_angle_at_the_ground(photic, tmp_path):
    for off_nadir, zenith in [(3, "3.33230"), (15, "16.7059")]:
        angle = np.radians(off_nadir)
        source = (f'kind = "beam"\nposition_m = [0, 0, 705000]\n'
                  f"direction = [{np.sin(angle):.15f}, 0, {-np.cos(angle):.15f}]\n")
        (tmp_path / "air.toml").write_text(scene_of(source))
        shown = photic("show", "air.toml").stdout
        degrees = float(shown.split("meets the ground at a zenith angle of ")[1].split()[0])
        assert degrees == pytest.approx(float(zenith), abs=5e-5)
    (tmp_path / "air.toml").write_text(scene_of('kind = "beam"\nposition_m = [-2e6, 0, 30000]\ndirection = [1, 0, 0]\n'))
    assert "passes the planet at a height of 30 km" in photic("show", "air.toml").stdout
    (tmp_path / "air.toml").write_text(scene_of('kind = "point"\nposition_m = [0, 0, 300]\ndirection = [0, 0, 1]\n'))
    assert "leads away from the planet" in photic("show", "air.toml").stdout


def test_zones_are_a_dimension_of_files(photic, tmp_path):
    (tmp_path / "air.toml").write_text(scene_of(SUN + "irradiance_w_m2 = 2\n", ZONES + BOUNDARIES))
    done = photic("run", "air.toml", "-o", "air.nc")
    assert (done.returncode, done.stderr) == (0, "")
    with netCDF4.Dataset(tmp_path / "air.nc") as file:
        down = file["irradiance_down"]
        assert down.dimensions == ("level", "zone")
        assert np.array_equal(file["zone_bounds"][:], [[0, 60], [60, 90], [90, 180]])
        assert file["zone"].units == "degree"
        # In a vacuum 0.75, the mean cosine.
        assert 0.6 < down[1, 0] < 0.75
        assert down.strength_units == "W m-2"
        assert (file["escaped"].strength_units, file["balance"][:]) == ("W", pytest.approx(1, abs=1e-2))
        # 2 W/m2 on the disc of the planet and its air.
        assert file["escaped"].strength_scale == pytest.approx(2 * np.pi * 6431e3**2)
    # A panel for each irradiance, with a line for each zone. Seen red: drawn as a fluence.
    drawn = photic("plot", "air.nc", "-o", "air.svg")
    assert (drawn.returncode, drawn.stderr) == (0, "")
    assert (tmp_path / "air.svg").stat().st_size > 0


# A shell whose index is the greatest holds level light for ever, which meets nothing in clear air. Seen red: without
# the limit of legs, which a run does not survive.
def test_trapped_light_is_lost_and_counted(photic, tmp_path):
    clear = ("[[atmosphere.layer]]\nbottom_height_m = 0\ntop_height_m = 1000\nrefractive_index = 1.0003\n"
             "iop = [{ wavelength_nm = 532, a_per_m = 0, b_per_m = 0 }]\n")
    trapped = 'kind = "point"\nposition_m = [0, 0, 500]\ndirection = [1, 0, 0]\n'
    (tmp_path / "air.toml").write_text(scene_of(trapped, air=SPHERICAL + "refraction = true\n", layers=clear))
    done = photic("run", "air.toml", "--photons", "100", "-o", "air.nc")
    assert done.returncode == 0
    assert "100 photons were lost after too many events" in done.stdout
    with netCDF4.Dataset(tmp_path / "air.nc") as file:
        assert file.photons_lost_too_many_events == 100


# Seen red: balance 0.5, with the light that goes up lost.
def test_light_from_the_top_of_the_air_escapes_upwards(photic, tmp_path):
    lamp = 'kind = "cone"\nposition_m = [0, 0, 60000]\ndirection = [0, 0, 1]\nhalf_angle_deg = 180\n'
    (tmp_path / "air.toml").write_text(scene_of(lamp))
    done = photic("run", "air.toml", "-o", "air.nc")
    assert (done.returncode, done.stderr) == (0, "")
    with netCDF4.Dataset(tmp_path / "air.nc") as file:
        assert file["balance"][:] == pytest.approx(1, abs=1e-3)


# The air of a profile ends at 100 km by default, and the planet is the earth.
def test_the_defaults_of_air_do_for_the_earth(photic, tmp_path):
    (tmp_path / "air.toml").write_text(scene_of(SUN, ZONES, SPHERICAL + 'profile = "us-standard"\n', ""))
    done = photic("check", "air.toml")
    assert (done.returncode, done.stderr) == (0, "")


# The output of show is a scene again.
@pytest.mark.parametrize("ground", ['"sea"', "{ albedo = 0.3 }", '{ kind = "sea" }'])
def test_what_show_prints_is_the_scene(photic, tmp_path, ground):
    air = SPHERICAL.replace("{ albedo = 0.1 }", ground) + "planet_radius_km = 7000\nrefraction = true\n"
    (tmp_path / "air.toml").write_text(scene_of(SUN, ZONES, air))
    shown = photic("show", "air.toml")
    assert (shown.returncode, shown.stderr) == (0, "")
    assert "shells about a planet with a radius of 7000 km" in shown.stdout
    (tmp_path / "again.toml").write_text(shown.stdout)
    assert photic("show", "again.toml").stdout == shown.stdout
    assert ('"sea"' in shown.stdout) == ("sea" in ground)


# Air that absorbs nothing has no constituents. Seen red: with a dimension of length 0.
def test_air_without_absorption_has_a_file(photic, tmp_path):
    (tmp_path / "air.toml").write_text(scene_of(air="surface = { albedo = 0.1 }\n"))
    done = photic("run", "air.toml", "-o", "air.nc")
    assert done.returncode == 0, done.stderr
    with netCDF4.Dataset(tmp_path / "air.nc") as file:
        assert "absorbed" not in file.variables
        assert file["balance"][:] == pytest.approx(1, abs=1e-2)
