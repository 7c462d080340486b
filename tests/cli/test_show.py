"""photic check and photic show."""

import json
import re

import pytest


def test_a_good_scene(photic, scene):
    done = photic("check", "quick.toml")
    assert (done.returncode, done.stdout, done.stderr) == (0, "quick.toml: no problems\n", "")
    as_json = photic("check", "quick.toml", "--json")
    assert as_json.returncode == 0
    assert json.loads(as_json.stdout) == {"scene": "quick.toml", "valid": True, "problems": [], "remarks": []}


def test_every_problem_at_once(photic, scene):
    scene.write_text(scene.read_text().replace("depth_step_m = 1.0", "depth_step_m = -1.0\ndepth_stpe_m = 1.0"))
    lines = scene.read_text().splitlines()
    done = photic("check", "quick.toml")
    assert (done.returncode, done.stdout) == (2, "")
    first, second, count = done.stderr.splitlines()
    assert first.startswith(f"quick.toml:{lines.index('depth_step_m = -1.0') + 1}:")
    assert second.startswith(f"quick.toml:{lines.index('depth_stpe_m = 1.0') + 1}:1: ")
    assert "depth_step_m" in second
    assert count == "2 problems in quick.toml"
    assert photic("run", "quick.toml").stderr == done.stderr
    assert photic("run", "quick.toml").returncode == 2


def test_problems_as_json(photic, scene):
    scene.write_text(scene.read_text() + "photosn = 5\n")
    text = photic("check", "quick.toml").stderr.splitlines()[0]
    done = photic("check", "quick.toml", "--json")
    assert (done.returncode, done.stderr) == (2, "")
    out = json.loads(done.stdout)
    assert (out["scene"], out["valid"], len(out["problems"])) == ("quick.toml", False, 1)
    problem = out["problems"][0]
    assert text == "{file}:{line}:{column}: {reason} ({suggestion})".format(**problem)


@pytest.mark.parametrize("subcommand", ["run", "check", "show"])
def test_a_scene_that_is_missing(photic, subcommand):
    done = photic(subcommand, "nowhere.toml")
    assert done.returncode == 2
    assert done.stdout == ""
    assert done.stderr.startswith("nowhere.toml: there is no such file")


def test_set_problems_name_the_flag(photic, scene):
    done = photic("check", "quick.toml", "--set", "sea.layer.1.chlorophyll_mg_m3=-1", "--set", "gates.depht_max_m=3")
    assert done.returncode == 2
    first, second, count = done.stderr.splitlines()
    assert first.startswith("--set sea.layer.1.chlorophyll_mg_m3: ")
    assert second.startswith("--set gates.depht_max_m: ")
    assert "depth_max_m" in second
    assert count == "2 problems in quick.toml"


def test_set_changes_the_scene(photic, scene):
    done = photic("show", "quick.toml", "--json", "--set", "sea.layer.1.chlorophyll_mg_m3=0.5")
    assert done.returncode == 0
    assert [layer["chlorophyll_mg_m3"] for layer in json.loads(done.stdout)["sea"]["layer"]] == [0.1, 0.5]


def test_show_writes_a_scene_that_reads_back_the_same(photic, scene, tmp_path):
    shown = photic("show", "quick.toml")
    assert (shown.returncode, shown.stderr) == (0, "")
    (tmp_path / "again.toml").write_text(shown.stdout)
    assert photic("check", "again.toml").stdout == "again.toml: no problems\n"
    assert photic("show", "again.toml").stdout == shown.stdout
    assert photic("show", "again.toml", "--json").stdout == photic("show", "quick.toml", "--json").stdout


def test_show_describes_the_air(photic, scene):
    """Seen red: without the notes on air."""
    head = "# The air above the sea:\n"
    assert head not in photic("show", "quick.toml").stdout
    shown = photic("show", "quick.toml", "--set", 'atmosphere={ profile = "us-standard", aerosol = "maritime" }').stdout
    reported = " ".join(line.lstrip("# ") for line in shown.split(head)[1].split("\n\n")[0].splitlines())
    assert re.match(r"\d+ layers of the profile us-standard, up to 100 km; above them a vacuum ", reported)
    all_, *parts = re.search(r"at 532 nm .* top: ([\d.]+), of which molecules (.*), ozone (.*), aerosols ([\d.]+)", reported).groups()
    assert float(parts[0]) == pytest.approx(0.1112, abs=2e-4)
    assert float(all_) == pytest.approx(sum(map(float, parts)), abs=2e-4)
    assert reported.endswith("left out: the absorption lines of water vapour, oxygen, carbon dioxide and other gases")
    assert "Bodhaine et al. 1999" in shown and "Ciddor 1996" in shown
    layers = ('atmosphere={ layer = [{ bottom_height_m = 0, top_height_m = 100, '
              "iop = [{ wavelength_nm = 300, a_per_m = 1e-4, b_per_m = 1e-3 }, "
              "{ wavelength_nm = 900, a_per_m = 1e-4, b_per_m = 1e-3 }] }] }")
    shown = photic("show", "quick.toml", "--set", layers).stdout
    assert "optical depth at 532 nm from the sea to the top: 0.11\n" in shown


def test_show_lists_which_telescopes_share_their_light(photic, scene):
    """Seen red: with these lines left out."""
    head = "# Telescopes that share their light:\n"
    assert head not in photic("show", "quick.toml").stdout
    text = scene.read_text()
    telescope = text[text.index("[[telescope]]") :].split("\n[", 1)[0]
    narrow = re.sub("detector_diameter_m = .*", "detector_diameter_m = 0.001", telescope)
    assert narrow != telescope
    scene.write_text(f"{text}\n{narrow}\nname = \"narrow\"\n")
    reported = photic("show", "quick.toml").stdout
    assert head + "#   telescopes narrow and telescope0 have views inside each other: what is drawn for one serves all\n" in reported
    assert head not in photic("show", "quick.toml", "--set", "simulation.reception=overlap").stdout


def test_show_of_a_result_is_the_scene_that_ran(photic, scene):
    assert photic("run", "quick.toml", "--seed", "5").returncode == 0
    from_result = photic("show", "quick.nc")
    assert (from_result.returncode, from_result.stderr) == (0, "")
    assert from_result.stdout == photic("show", "quick.toml", "--set", "simulation.seed=5").stdout


def test_show_of_what_is_no_result(photic, scene, tmp_path):
    (tmp_path / "fake.nc").write_text("not a netCDF file")
    done = photic("show", "fake.nc")
    assert done.returncode in (1, 2)
    assert "fake.nc" in done.stderr
    assert "bug" not in done.stderr


def test_environments_are_shown_with_what_they_set(photic, scene, tmp_path):
    """Seen red: with the environments left out of what is written."""
    scene.write_text(scene.read_text() + """[[environment]]
name = "more algae"
set = { "sea.layer.1.chlorophyll_mg_m3" = 2, 'optics.phytoplankton' = "prieur-sathyendranath" }
""")
    shown = photic("show", "quick.toml")
    assert shown.returncode == 0
    lines = ["[[environment]]", 'name = "more algae"',
             'set = { "sea.layer.1.chlorophyll_mg_m3" = 2, "optics.phytoplankton" = "prieur-sathyendranath" }']
    assert "\n".join(lines) in shown.stdout
    (tmp_path / "shown.toml").write_text(shown.stdout)
    assert photic("show", "shown.toml").stdout == shown.stdout
    as_json = json.loads(photic("show", "quick.toml", "--json").stdout)
    assert as_json["environment"][0]["set"] == {"sea.layer.1.chlorophyll_mg_m3": 2, "optics.phytoplankton": "prieur-sathyendranath"}


def test_how_paths_are_drawn(photic, scene):
    # Seen red: with nothing said of a scene that names the estimator.
    named = ("--set", "simulation.estimator=bidirectional")
    lines = photic("show", "quick.toml", *named).stdout.splitlines()
    at = lines.index("# How the bidirectional estimator draws paths:")
    assert lines[at + 1] == "#   walks from telescopes connected to the laser: yes"
    assert "draws paths" not in photic("show", "quick.toml", "--set", "simulation.estimator=forward").stdout


def test_the_beds_albedo_and_where_it_comes_from(photic, scene, tmp_path):
    """Seen red: with every bed's albedo given."""
    (tmp_path / "sand.csv").write_text("wavelength_nm,albedo\n500,0.1\n700,0.25\n")
    scene.write_text(scene.read_text().replace("[gates]", "bottom_depth_m = 20.0\n[bottom]\nalbedo = 0.1\n[gates]"))
    reported = "albedo of the sea bed, "
    lines = [line for line in photic("show", "quick.toml").stdout.splitlines() if reported in line]
    assert len(lines) == 1
    assert lines[0].startswith(f"#   {reported}532-")
    assert lines[0].endswith(" nm: 0.1, given")
    of_file = photic("show", "quick.toml", "--set", 'bottom.albedo={ file = "sand.csv" }').stdout
    assert "[bottom]\nalbedo = { wavelength_nm = [500.0, 700.0], albedo = [0.1, 0.25] }\n" in of_file
    assert f"nm: 0.1 to 0.25, given in {tmp_path / 'sand.csv'}" in of_file.replace("\n#     ", " ")
    refused = photic("show", "quick.toml", "--set", "bottom.albedo=1.5")
    assert refused.returncode == 2
    assert refused.stderr.startswith(
        "--set bottom.albedo: 'albedo' must be a finite number, at least 0 and at most 1, not 1.5")
