"""What the program refuses, the Python module refuses in the same words; and values that no file can hold."""

import copy
import datetime
import decimal
import pathlib
import pickle
import re
import subprocess
import sys
import tomllib

import numpy
import photic as package
import pytest
import xarray
from conftest import QUICK_SCENE
from test_optics_problems import PROBLEMS
from test_schema import FAULTY, edited
from test_spherical import REFUSED

TEXTS = {what: edited(*FAULTY[what]) for what in FAULTY}
TEXTS |= {what: QUICK_SCENE.replace(old, new) for what, (old, new, *_) in PROBLEMS.items() if what != "more light than absorbed"}
TEXTS |= {what: text for what, (text, *_) in REFUSED.items()}
TEXTS |= {
    "nothing": "",
    "not TOML": QUICK_SCENE.replace("photons = 20000", "photons = = 20000"),
    "a date": QUICK_SCENE.replace("photons = 20000", "photons = 2000-01-01"),
    "no number": QUICK_SCENE.replace("diameter_m = 0.04", "diameter_m = nan"),
    "without end": QUICK_SCENE.replace("depth_max_m = 10.0", "depth_max_m = inf"),
    "a file that is missing": QUICK_SCENE.replace("[gates]", "bottom_depth_m = 20.0\n[bottom]\nalbedo = { file = 'none.csv' }\n[gates]"),
}


# Seen red: with a problem's suggestion left out of the text.
@pytest.mark.parametrize("what", TEXTS)
def test_the_words_are_the_programs(photic, tmp_path, monkeypatch, what):
    monkeypatch.chdir(tmp_path)  # of the files that scenes name
    text = TEXTS[what]
    (tmp_path / "scene").write_text(text)
    words = photic("check", "scene").stderr.splitlines()[:-1]
    with pytest.raises(package.SceneError) as of_text:
        package.Scene(text)
    assert str(of_text.value).splitlines() == words
    for problem, line in zip(of_text.value.problems, words, strict=True):
        advice = f" ({problem.suggestion})" if problem.suggestion else ""
        assert line == f"{problem.file}:{problem.line}:{problem.column}: {problem.reason}{advice}"
    with pytest.raises(package.SceneError, match="^" + re.escape(words[0].replace("scene:", f"{tmp_path}/scene:"))):
        package.Scene.load(tmp_path / "scene")
    if what == "not TOML":
        return
    with pytest.raises(package.SceneError) as of_dict:
        package.Scene(tomllib.loads(text))
    said = [[(problem.reason, problem.suggestion) for problem in each.value.problems] for each in (of_text, of_dict)]
    assert sorted(said[1]) == sorted(said[0])
    assert all(problem.line == 0 for problem in of_dict.value.problems)


def test_places_in_a_dict_are_paths():
    values = tomllib.loads(QUICK_SCENE)
    values["sea"]["layer"][1]["chlorophyll_mg_m3"] = -1
    values["source"]["diameter_m"] = "4 cm"
    with pytest.raises(package.SceneError) as error:
        package.Scene(values)
    assert [problem.path for problem in error.value.problems] == ["source.diameter_m", "sea.layer.1.chlorophyll_mg_m3"]
    assert str(error.value).startswith("source.diameter_m: ")


# Seen red: with values that are set one after another.
def test_a_change_that_is_refused_leaves_the_scene_as_it_was():
    scene = package.Scene(QUICK_SCENE)
    for change in [
        lambda: scene.update({"gates.depth_max_m": 20.0, "gates.depth_step_m": -1.0}),
        lambda: scene.__setitem__("sea.layer.0.chlorophyl", 1.0),
        lambda: scene.__delitem__("source.diameter_m"),
        lambda: scene.__delitem__("sea.nothing"),
        lambda: scene.update({"gates.depth_max_m": 20.0, "sea.layer.7.chlorophyll_mg_m3": 1.0}),
        lambda: scene.update({"gates.depth_max_m": {1, 2}}),
        lambda: scene.update({"gates.depth_max_m": 20.0, 3: 1}),
    ]:
        with pytest.raises(package.SceneError) as error:
            change()
        assert len(error.value.problems) == 1
        assert scene.toml() == QUICK_SCENE and scene["gates.depth_max_m"] == 10.0


def test_values_by_paths():
    scene = package.Scene(QUICK_SCENE)
    scene["channel.raman.name"] = "R"
    assert scene["channel.1.name"] == "R" and scene["channel.R"]["process"] == "raman"
    assert scene["source.kind"] == "laser"  # by default
    scene["sea.salinity_psu"] = 30
    del scene["sea.salinity_psu"]
    assert scene["sea.salinity_psu"] == 35.0
    assert "sea.layer.1" in scene and "sea.layer.2" not in scene and 3 not in scene
    with pytest.raises(KeyError, match="sea.layer.2"):
        scene["sea.layer.2"]
    other = scene.copy()
    other["gates.depth_max_m"] = 5.0
    assert scene["gates.depth_max_m"] == 10.0
    again = package.Scene(scene.toml())
    assert again["channel.R.process"] == "raman"
    keys = scene._ipython_key_completions_()
    assert {"gates.depth_max_m", "channel.R.process", "sea.layer.1.chlorophyll_mg_m3"} <= set(keys)


TAKEN = {
    "float64": (numpy.float64(1.5), 1.5),
    "float32": (numpy.float32(1.5), 1.5),
    "int": (2, 2),
    "int32": (numpy.int32(2), 2),
    "array of one": (numpy.array(1.5), 1.5),
    "xarray": (xarray.DataArray(1.5), 1.5),
    "decimal": (decimal.Decimal("1.5"), 1.5),
    "long double": (numpy.longdouble(1.5), 1.5),
    "array of one long double": (numpy.array(1.5, "g"), 1.5),
}


@pytest.mark.parametrize("what", TAKEN)
def test_numbers_that_are_taken(what):
    scene = package.Scene(QUICK_SCENE)
    value, number = TAKEN[what]
    scene["sea.layer.0.chlorophyll_mg_m3"] = value
    assert scene["sea.layer.0.chlorophyll_mg_m3"] == number


def test_arrays_texts_and_truths_that_are_taken(tmp_path):
    scene = package.Scene(QUICK_SCENE)
    for vector in [numpy.array([0, 0.5, -1]), (0, 0.5, -1), xarray.DataArray([0, 0.5, -1]), numpy.array([0, 0.5, -1], "f4")]:
        scene["source.direction"] = vector
        assert scene["source.direction"] == [0, 0.5, -1]
    scene["title"] = numpy.str_("häß")
    assert scene["title"] == "häß"
    scene["sea.surface"] = {"model": "cox-munk", "wind_speed_m_s": 5, "whitecaps": numpy.bool_(False)}
    assert scene["sea.surface.whitecaps"] is False
    (tmp_path / "bed.csv").write_text("zenith_deg,albedo\n0,0.1\n90,0.2\n")
    scene.update({"sea.layer.1.bottom_depth_m": 20.0, "bottom": {"albedo": {"file": tmp_path / "bed.csv"}}})
    assert scene["bottom.albedo.file"] == str(tmp_path / "bed.csv")


ITSELF = []
ITSELF.append(ITSELF)
DEEP = 1.0
for _ in range(100):
    DEEP = [DEEP]
ARRAY_IN_ITSELF = numpy.empty((), object)
ARRAY_IN_ITSELF[()] = ARRAY_IN_ITSELF


class NoPairs(dict):
    def items(self):
        return [1, 2]


# Seen red, the last ten but xarray's dates: arrays in themselves without end, nanoseconds taken for numbers, what others raise.
REFUSED_VALUES = {
    "none": (None, "a scene holds no value of Python's type NoneType"),
    "set": ({1.0}, "a scene holds no value of Python's type set"),
    "bytes": (b"1", "a scene holds no value of Python's type bytes"),
    "complex": (1j, "a scene holds no value of Python's type complex"),
    "date": (datetime.date(2000, 1, 1), "must be a finite number"),
    "datetime64": (numpy.datetime64("2000-01-01"), "must be a finite number"),
    "nan": (float("nan"), "must be a finite number"),
    "numpy's nan": (numpy.float32("nan"), "must be a finite number"),
    "masked": (numpy.ma.masked, "a scene holds no value of Python's type NoneType"),
    "beyond 64 bits": (2**63, "is a whole number beyond 64 bits"),
    "itself": (ITSELF, "is a value that holds itself"),
    "deep": (DEEP, "is more than 64 values deep"),
    "a key that is no text": ({1: 2.0}, "has the key 1 (keys are text)"),
    "half a character": ("\ud800", "is text with a character that UTF-8 does not have"),
    "path": (pathlib.Path("a"), "must be a finite number"),
    "class": (float, "a scene holds no value of Python's type type"),
    "class of arrays": (numpy.ndarray, "a scene holds no value of Python's type type"),
    "complex long double": (numpy.clongdouble(1), "a scene holds no value of Python's type"),
    "array in itself": (ARRAY_IN_ITSELF, "a scene holds no value of Python's type ndarray"),
    "nanoseconds": (numpy.timedelta64(3, "ns"), "a scene holds no value of Python's type timedelta64"),
    "array of nanoseconds": (numpy.array([3], "m8[ns]"), "a scene holds no value of Python's type timedelta64"),
    "datetime64 in ns": (numpy.datetime64(3, "ns"), "must be a finite number"),
    "dates of xarray": (xarray.DataArray(numpy.array([3], "M8[ns]")), "must be a finite number"),
    "no pairs": (NoPairs(a=1), "has items that are no pairs"),
    "signaling nan": (decimal.Decimal("sNaN"), "cannot convert signaling NaN to float"),
    "null byte": ("a\0b", "is text with a null byte"),
}


@pytest.mark.parametrize("what", REFUSED_VALUES)
def test_values_that_are_refused(what):
    value, reason = REFUSED_VALUES[what]
    scene = package.Scene(QUICK_SCENE)
    with pytest.raises(package.SceneError) as error:
        scene["sea.layer.0.chlorophyll_mg_m3"] = value
    assert reason in str(error.value)
    assert error.value.problems[0].path.startswith("sea.layer.0.chlorophyll_mg_m3")
    values = tomllib.loads(QUICK_SCENE)
    values["sea"]["layer"][0]["chlorophyll_mg_m3"] = value
    with pytest.raises(package.SceneError, match="^sea.layer.0.chlorophyll_mg_m3"):
        package.Scene(values)


OTHERS = {
    "a file for text": (lambda: package.Scene("my.toml"), r"Scene.load reads a file"),
    "a path for text": (lambda: package.Scene(pathlib.Path("my.toml")), r"Scene.load reads a file"),
    "a list": (lambda: package.Scene([1]), "a scene is TOML text or a dict, not list"),
    "half a character": (lambda: package.Scene("title = '\udcff'\n"), "is no text that UTF-8 has"),
    "no such file": (lambda: package.Scene.load("none.toml"), "none.toml"),
    "no such kind": (lambda: package.Scene.new("shp"), r"there is no starter scene 'shp' \(did you mean 'ship'\?\)"),
    "no dict": (lambda: package.Scene(QUICK_SCENE).update([1]), "values by their paths are a dict, not list"),
    "no scene": (lambda: package.run(None), "scene: None is no name of a file"),
}


@pytest.mark.parametrize("what", OTHERS)
def test_other_mistakes(what):
    call, reason = OTHERS[what]
    with pytest.raises(package.Error, match=reason):
        call()


def test_files_and_starters(tmp_path, monkeypatch):
    scene = package.Scene.new("argo")
    with pytest.raises(package.SceneError, match="argo-profile.csv"):
        scene.save(tmp_path / "my.toml")
    assert not (tmp_path / "my.toml").exists()
    quick = package.Scene(QUICK_SCENE)
    quick["gates.depth_max_m"] = 12.0
    quick.save(tmp_path / "quick.toml")
    assert package.Scene.load(tmp_path / "quick.toml")["gates.depth_max_m"] == 12.0
    with pytest.raises(package.Error, match="cannot write the file") as error:
        quick.save(tmp_path / "none" / "quick.toml")
    assert error.value.exit_code == 1


def test_remarks_are_those_of_the_program_and_warnings_of_runs(photic, tmp_path):
    text = QUICK_SCENE.replace("depth_max_m = 10.0", "depth_max_m = 10.5")
    (tmp_path / "scene").write_text(text)
    remarks = [line for line in photic("run", "scene", "-o", "a.nc").stderr.splitlines() if line.startswith("scene:")]
    scene = package.Scene(text)
    assert remarks and scene.remarks == remarks
    with pytest.warns(UserWarning, match=re.escape(remarks[0])) as warned:
        scene.run(photons=500)
    assert {warning.filename for warning in warned} == {__file__}


# Seen red: names and texts without these checks.
NAMES = {
    "nothing": (lambda s: s.run(continue_from=""), "^continue_from: '' is no name of a file"),
    "no output": (lambda s: s.run(output=""), "^output: '' is no name of a file"),
    "null byte": (lambda s: s.run(output="a\0.nc"), r"^output: 'a\\x00.nc' has a null byte"),
    "null byte in save": (lambda s: s.save("a\0"), "^path: .* has a null byte"),
    "null byte in load": (lambda s: s.load("a\0"), "^scene: .* has a null byte"),
    "null byte in open": (lambda s: package.open("a\0"), "^path: .* has a null byte"),
    "null byte in a number": (lambda s: s.run(photons="1e3\0"), r"^photons: '1e3\\x00' has a null byte"),
    "null byte in a path": (lambda s: s.update({"a\0b": 1}), r"^'a\\x00b': has a null byte"),
    "null byte in a key": (lambda s: s.update({"sea": {"a\0b": 1}}), "^sea: is text with a null byte"),
    "null byte in TOML": (lambda s: package.Scene(QUICK_SCENE + '[x."a\\u0000b"]'), r"unknown key 'x' in the scene"),
    "half a character": (lambda s: s.run(output="\ud800.nc"), "^output: .* has a character that names of files do not have"),
    "half a character in save": (lambda s: s.save("\ud800"), "^path: .* has a character that names"),
    "half a character in load": (lambda s: s.load("\ud800"), "^scene: .* has a character that names"),
    "half a character in isa": (lambda s: s.run(isa="\ud800"), "^isa: .* has a character that UTF-8 does not have"),
    "half a character in new": (lambda s: s.new("\ud800"), "^kind: .* has a character that UTF-8 does not have"),
    "number for a kind": (lambda s: s.new(3), "^kind: 3 is no text"),
}


@pytest.mark.parametrize("what", NAMES)
def test_names_that_are_refused(what):
    call, reason = NAMES[what]
    with pytest.raises(package.Error, match=reason):
        call(package.Scene(QUICK_SCENE))
    assert "\ud800" not in package.Scene(QUICK_SCENE)


# Seen red: with exceptions that end at a null byte.
def test_messages_go_on_after_a_null_byte():
    with pytest.raises(package.SceneError) as error:
        package.Scene(QUICK_SCENE + '"a\\u0000b" = 1\n')
    assert "unknown key 'a\\u0000b' in [simulation]" in str(error.value)


DEEP_SCENES = {
    "key": "a." * 30000 + "b = 1",
    "header": "[" + "a." * 30000 + "b]\nc = 1",
    "tables in each other": "x = " + "{ a.b.c.d.e = " * 100 + "1" + " }" * 100,
    "header and key": "[[" + "a." * 200 + "b]]\n" + "c." * 57 + "x = 1",
}
DEEP_CALLS = """
import sys, photic
scene, text = photic.Scene(sys.stdin.read()), %r
for call in [lambda: photic.Scene(text), lambda: scene.update({"a." * 50000 + "b": 1}), lambda: scene["a." * 50000 + "b"]]:
    try: call()
    except (photic.SceneError, KeyError) as error: print(str(error)[:100])
"""


# In a process of its own: without the look at keys, it runs out of stack. Seen red.
@pytest.mark.parametrize("what", DEEP_SCENES)
def test_paths_that_are_too_deep(photic, scene, what):
    code = DEEP_CALLS % DEEP_SCENES[what]
    done = subprocess.run([sys.executable, "-c", code], input=QUICK_SCENE, capture_output=True, text=True, check=False)
    text, path, none = done.stdout.splitlines()
    assert text.startswith("scene:") and "more than 256 tables lie in each other here" in text
    assert "the path has 50001 parts (at most 256 are possible)" in path and none.startswith("'a.a.a.")
    refused = photic("check", scene, "--set", "a." * 30000 + "b=1")
    assert refused.returncode == 2 and "the path has 30001 parts" in refused.stderr


LAYERS = [
    {"name": "top", "bottom_depth_m": 10, "cdom_a440_per_m": 0.07, "chlorophyll_mg_m3": {"depth_m": [0, 3, 10], "value": [1, 2, 3.0]}},
    {"name": "deep", "chlorophyll_mg_m3": 0.1},
]


# Seen red: with the layers by default counted as they are cut.
def test_defaults_are_those_of_the_layer_that_is_asked_for():
    scene = package.Scene.new("airborne")
    scene["sea"] = {"layer": LAYERS}
    assert scene["sea.layer.1.cdom_a440_per_m"] == scene["sea.layer.deep.cdom_a440_per_m"] == 0.0
    assert scene["sea.layer.top.cdom_a440_per_m"] == 0.07
    for path in ("sea.layer.1.bottom_depth_m", "sea.layer.7.name", "sea.layer.2", "sea.layer.1.chlorophyll_mg_m3.value"):
        with pytest.raises(KeyError):
            scene[path]
    assert package.Scene.new("argo")["sea.layer.0.name"] == "layer0"


# Seen red: without __reduce__; with a copy that shares the scene.
def test_scenes_and_errors_are_copied_and_pickled(tmp_path, monkeypatch):
    scene = package.Scene.new("argo")  # with a file beside it
    monkeypatch.chdir(tmp_path)
    for made in (copy.copy(scene), copy.deepcopy(scene), pickle.loads(pickle.dumps(scene))):
        assert made.toml() == scene.toml() and repr(made) == repr(scene)
        made["gates.depth_max_m"] = 5.0
        assert scene["gates.depth_max_m"] != 5.0
    problem = package.Problem("a.toml", 1, 2, "sea", "is wrong", "mend it")
    interrupted = package.Interrupted("stopped", xarray.Dataset({"a": 1}))
    for error in (package.SceneError("text", [problem]), package.Error("no", 1, interrupted.partial), interrupted):
        for made in (copy.copy(error), copy.deepcopy(error), pickle.loads(pickle.dumps(error))):
            assert type(made) is type(error) and str(made) == str(error)
            assert repr(vars(made)) == repr(vars(error))
