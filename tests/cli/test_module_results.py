"""Results in memory are those of the files that the program writes, to the last bit and attribute."""

import numpy
import photic as package
import pytest
from conftest import QUICK_SCENE, SOURCE

STARTERS = sorted(package.Scene.kinds())
OF_THE_SITTING = {"history", "wall_time_s", "collisions_per_second", "scene_file", "threads"}

pytestmark = pytest.mark.filterwarnings("ignore::UserWarning")  # so few photons leave warnings


def alike(one, other):
    """Returns whether results are identical, with the types of attributes, but for what each run has its own of."""
    both = [result.copy() for result in (one, other)]
    for result in both:
        result.attrs = {name: value for name, value in result.attrs.items() if name not in OF_THE_SITTING}
    types = [
        [{name: type(value) for name, value in each.attrs.items()} for each in (result, *result.variables.values())]
        + [each.dtype for each in result.variables.values()]
        for result in both
    ]
    return both[0].identical(both[1]) and types[0] == types[1]


def of_program(program, scene, path, *flags):
    done = program("run", scene, "-o", path, "--table", "none", *flags)
    assert done.returncode == 0, done.stderr
    return package.open(path)


# Seen red: with attributes of Python's types in the place of numpy's, without decode_cf, with the encoding "coordinates".
@pytest.mark.parametrize("kind", STARTERS)
def test_starters(photic, tmp_path, kind):
    scene = package.Scene.new(kind)
    ours = scene.run(photons=200, seed=3)
    theirs = of_program(photic, SOURCE / f"scenes/{kind}.toml", tmp_path / "out.nc", "--photons", "200", "--seed", "3")
    assert alike(ours, theirs)
    ours.to_netcdf(tmp_path / "again.nc")
    assert ours.identical(package.open(tmp_path / "again.nc"))


MORE = {
    "environments": '[[environment]]\nname = "algae"\nset = { "sea.layer.0.chlorophyll_mg_m3" = 0.5 }\n'
    '[[environment]]\nname = "clear"\nset = { "sea.layer.0.chlorophyll_mg_m3" = 0.01 }\n',
    "sensitivities": 'sensitivity = ["sea.layer.0.chlorophyll_mg_m3"]\n',
    "film": '[oil]\nclass = "weakly-absorbing-crude"\nthickness_um = 1.0\n',
    "tallies": '[[tally]]\nkind = "boundaries"\n[[tally]]\nkind = "irradiance"\ndepth_m = [1.0, 2.0]\n',
}


@pytest.mark.parametrize("engine", ["lanes", "scalar"])
@pytest.mark.parametrize("estimator", ["forward", "bidirectional", "auto"])
@pytest.mark.parametrize("more", ["", *MORE])
def test_engines_and_features(photic, tmp_path, engine, estimator, more):
    if more == "tallies" and estimator == "bidirectional":
        return  # which has none
    part = MORE.get(more, "")
    text = QUICK_SCENE.replace('"forward"', f'"{estimator}"')
    text = part + text if part.startswith("sens") else text + part
    (tmp_path / "a.toml").write_text(text)
    flags = ["--photons", "500", "--engine", engine]
    theirs = of_program(photic, tmp_path / "a.toml", tmp_path / "out.nc", *flags)
    assert alike(package.Scene(text).run(photons=500, engine=engine), theirs)


def test_arrays_are_the_results_own():
    result = package.Scene(QUICK_SCENE).run(photons=500)
    assert result.echo.values.flags.writeable
    again = result.copy(deep=True)
    result.echo[:] = 0.0
    assert float(numpy.abs(again.echo).max()) > 0
