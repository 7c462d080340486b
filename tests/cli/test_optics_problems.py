"""What the optics find wrong with a scene is reported like all else: file:line:column: reason (suggestion), by every
command, and before a run."""

import json
import os
import re

import pytest
from conftest import QUICK_SCENE

LAYER = "chlorophyll_mg_m3 = 1.0"  # of the last layer
IOP = "iop = [ { wavelength_nm = 532.0, a_per_m = 0.06, b_per_m = 0.1 } ]\nphase_function = "
TABLE = IOP + '{ model = "table", file = "vsf.csv" }'
WATER = "no water absorption data at 1150 nm: Mason 2016 / IOCCG 2018 cover 200-1100 nm"
INDEX = "no refractive index data at 1150 nm: Quan & Fry 1995, Appl. Opt. 34, 3477, eq. (3) [verified] cover 200-1100 nm"

# What is replaced by what; then the text at which, so many characters on, the problem is reported, and the problem.
PROBLEMS = {
    "the laser in the water": ("532.0", "1150.0", "1150.0", 0, WATER),
    "the laser in the algae": ("532.0", "810.0", "810.0", 0, "no phytoplankton absorption data at 810 nm"),
    "the laser in the iop": (LAYER, IOP.replace("532.0", "500.0") + '"petzold"', "[ {", 0,
                             'the iop of layer "layer1" covers 499 to 501 nm, not 532 nm; the source emits there'),
    "raman light in the iop": (LAYER, IOP + '"petzold"', "[ {", 0, 'the iop of layer "layer1" covers 531 to 533 nm, '
                               'not 648.793 nm; channel "raman" counts raman light there (add an entry for it)'),
    "raman light in the algae": ("532.0", "780.0", '"raman"\n[[sea', 0,
                                 'no phytoplankton absorption data at 1006.27 nm: Bricaud et al. 1998'),
    "more light than absorbed": ("532.0", "355.0", "[[sea.layer]]", 0,
                                 'layer "layer0" emits more Raman and fluorescence light'),
    "a mean cosine too low": (LAYER, IOP + '{ model = "henyey-greenstein", g = -0.9 }', "g = -0.9", 4,
                              "'g' must be a finite number, at least -0.4 and less than 1, not -0.9"),
    "particles too light": (LAYER, IOP + '{ model = "fournier-forand", refractive_index = 1.004, slope = 3.5 }',
                            "1.004", 0, "'refractive_index' must be a finite number, at least 1.005 and at most 1.35"),
}


def place_of(text, mark, shift):
    before = text[: text.index(mark) + shift]
    return f"quick.toml:{before.count(chr(10)) + 1}:{len(before) - before.rfind(chr(10))}: "


@pytest.mark.parametrize("name", PROBLEMS)
def test_has_its_place_in_every_command(photic, scene, tmp_path, name):
    old, new, mark, shift, reason = PROBLEMS[name]
    text = QUICK_SCENE.replace(old, new)
    if name == "more light than absorbed":
        text = text.replace("chlorophyll_mg_m3 = 0.1", "chlorophyll_mg_m3 = 0.0")
    scene.write_text(text)
    reported = photic("check", "quick.toml")
    assert (reported.returncode, reported.stdout) == (2, "")
    assert place_of(text, mark, shift) + reason in reported.stderr
    assert all(line.startswith("quick.toml:") for line in reported.stderr.splitlines()[:-1])
    for command in ["run", "show"]:
        done = photic(command, "quick.toml")
        assert (done.returncode, done.stdout, done.stderr) == (2, "", reported.stderr)
    assert [p.name for p in tmp_path.iterdir()] == ["quick.toml"]


def test_is_reported_with_all_else(photic, scene):
    scene.write_text(QUICK_SCENE.replace("532.0", "1150.0").replace("depth_step_m = 1.0", "depth_step_m = -1.0"))
    first, *_, last, count = photic("check", "quick.toml").stderr.splitlines()
    assert first.startswith(f"quick.toml:3:17: {INDEX} (")
    assert last.startswith("quick.toml:28:16: 'depth_step_m' must be a finite number")
    assert not count.startswith("quick.toml")


def test_of_an_environment_is_reported_at_its_change(photic, scene):
    """Seen red: with the check of the optics not asked about environments."""
    iop = "iop = [{ wavelength_nm = 500.0, a_per_m = 0.06, b_per_m = 0.1 }]"
    text = QUICK_SCENE.replace('"raman"\n[[sea', '"elastic"\n[[sea')
    text += f"""[[environment]]
[environment.set]
"sea.layer.0.chlorophyll_mg_m3" = 0.5
"sea.layer.1" = {{ {iop}, phase_function = "petzold" }}
"""
    scene.write_text(text)
    reason = 'the iop of layer "layer1" covers 499 to 501 nm, not 532 nm; the source emits there (add an entry for it)'
    reported = photic("check", "quick.toml").stderr.splitlines()
    assert reported == [place_of(text, '"sea.layer.1"', 0) + reason, "1 problem in quick.toml"]
    # What is wrong with the scene, too, is reported of the scene alone.
    scene.write_text(text.replace("532.0", "1064.0").replace("500.0", "1064.0"))
    reported = photic("check", "quick.toml").stderr.splitlines()
    assert [line.split(": ")[0] for line in reported[:-1]] == ["quick.toml:3:17"] * (len(reported) - 1)


def test_names_the_set_that_asks_for_it(photic, scene):
    done = photic("run", "quick.toml", "--set", "source.wavelength_nm=1150")
    assert done.returncode == 2
    assert done.stderr.startswith(f"--set source.wavelength_nm: {INDEX} (")


def test_a_phase_table_is_refused_at_its_own_lines(photic, scene, tmp_path):
    table = tmp_path / "vsf.csv"
    table.write_text("angle_deg,phase_function_per_sr\n0,0.0796\n90,x\n120;0.1\n180,0.0796\n")
    scene.write_text(QUICK_SCENE.replace(LAYER, TABLE).replace('"raman"\n[[sea', '"elastic"\n[[sea'))
    expected = [
        f"{table}:4:1: 1 fields where 2 columns are named (separate them by commas, as the names are)",
        "1 problem in quick.toml",
    ]
    for command in ["check", "run", "show"]:
        done = photic(command, "quick.toml")
        assert (done.returncode, done.stdout, done.stderr.splitlines()) == (2, "", expected)


def test_a_phase_table_that_is_scaled_is_remarked_on(photic, scene, tmp_path):
    table = tmp_path / "vsf.csv"
    table.write_text("angle_deg,phase_function_per_sr\n0,0.0799\n180,0.0799\n")
    text = QUICK_SCENE.replace(LAYER, TABLE).replace('"raman"\n[[sea', '"elastic"\n[[sea')
    scene.write_text(text)
    place = place_of(text, '"vsf.csv"', 0)
    remark = f"{place}{table}: the phase function integrates to 1.00405; scaled to 1"
    done = photic("check", "quick.toml")
    assert (done.returncode, done.stdout, done.stderr) == (0, "quick.toml: no problems\n", remark + "\n")
    assert json.loads(photic("check", "quick.toml", "--json").stdout)["remarks"] == [remark]
    done = photic("run", "quick.toml")
    assert (done.returncode, done.stderr) == (0, remark + "\n")


def test_a_step_that_is_changed_is_remarked_on(photic, scene):
    scene.write_text(QUICK_SCENE.replace("depth_step_m = 1.0", "depth_step_m = 0.3"))
    remark = "quick.toml:28:16: steps of 0.3 m do not fill the 10 m from 0 to 10 m: the 34 gates are 0.294118 m long instead\n"
    for command in ["check", "run"]:
        done = photic(command, "quick.toml")
        assert (done.returncode, done.stderr) == (0, remark)


# Seen red: without the remarks; with a result's scene that keeps the setting.
def test_a_setting_without_effect_is_remarked_on_once(photic, scene):
    scene.write_text(QUICK_SCENE + "walks = 3\n")
    remark = (
        "quick.toml:32:9: 'walks' has no effect: the forward estimator has no walks; "
        'leave it out, or write estimator = "bidirectional"\n'
    )
    for command in [["check"], ["run", "-o", "quick.nc", "--photons", "1000"]]:
        done = photic(*command, "quick.toml")
        assert (done.returncode, done.stderr) == (0, remark)
    scene.write_text(photic("show", "quick.nc").stdout)
    done = photic("check", "quick.toml")
    assert (done.returncode, done.stdout, done.stderr) == (0, "quick.toml: no problems\n", "")


def test_missing_data_do_not_hide_what_is_wrong_with_the_scene(photic, scene, tmp_path):
    missing = {"env": {"PHOTIC_DATA": str(tmp_path)}}
    assert photic("check", "quick.toml", **missing).returncode == 1
    done = photic("check", "quick.toml", "--set", "gates.depth_step_m=-1", **missing)
    assert done.returncode == 2
    assert done.stderr.startswith("--set gates.depth_step_m: ")


SECRETS = {"prose": "my secret pass word\nand more of it\n", "keys": "secret = 5\npass = word\n", "shadow": "secret:$6$word:1:0:\n"}
NAMED_BY = [
    'sea.layer.0.phase_function={ model = "table", file = "FILE" }',
    "sea.layer.0.chlorophyll_mg_m3={ file = 'FILE', depth = 1, column = 2 }",
    'oil={ file = "FILE", thickness_um = 1 }',
    'atmosphere={ profile = "./FILE" }',
    'atmosphere={ profile = "us-standard", gases = [{ top_km = 2, file = "FILE" }] }',
    'optics={ phytoplankton = "table", phytoplankton_file = "FILE" }',
]


@pytest.mark.parametrize("setting", NAMED_BY)
def test_a_pipe_is_not_waited_for(photic, scene, tmp_path, setting):
    """Seen red: with folders alone refused."""
    os.mkfifo(tmp_path / "pipe")
    for name in ["./pipe", "/dev/zero"]:
        done = photic("check", "quick.toml", "--set", setting.replace("./FILE", "FILE").replace("FILE", name))
        assert done.returncode == 2
        assert "names no regular file: " in done.stderr


@pytest.mark.parametrize("setting", NAMED_BY)
@pytest.mark.parametrize("text", SECRETS.values(), ids=SECRETS)
def test_a_file_that_is_no_table_is_not_quoted(photic, scene, tmp_path, setting, text):
    """Seen red: with all files quoted."""
    (tmp_path / "kept.txt").write_text(text)
    done = photic("check", "quick.toml", "--set", setting.replace("FILE", "kept.txt"))
    assert done.returncode == 2
    assert "no table of numbers" in done.stderr
    assert not re.search("secret|pass|word", done.stderr)
