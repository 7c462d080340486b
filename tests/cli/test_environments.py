"""photic run of a scene with environments: other water, from the same histories."""

import netCDF4
import pytest

ENVIRONMENTS = """\
[[environment]]
name = "more algae"
set = { "sea.layer.1.chlorophyll_mg_m3" = 2.0 }
[[environment]]
name = "the same"
set = {}
"""


@pytest.fixture
def environments(scene):
    scene.write_text(scene.read_text() + ENVIRONMENTS)
    return scene


def test_run_prints_and_writes_them(photic, environments, tmp_path):
    done = photic("run", "quick.toml", "-o", "out.nc")
    assert done.returncode == 0, done.stderr
    assert "Environments: echo over that of the scene" in done.stdout
    assert "  A more algae: sea.layer.1.chlorophyll_mg_m3 = 2.0 (" in done.stdout
    with netCDF4.Dataset(tmp_path / "out.nc") as file:
        assert list(file["environment_name"][:]) == ["more algae", "the same"]
        assert (file["environment_echo"][1] == file["echo"][:]).all()
        assert (file["environment_echo"][0] != file["echo"][:]).any()
        assert abs(file["environment_difference"][0] + file["echo"][:] - file["environment_echo"][0]).max() < 1e-20


@pytest.mark.parametrize("estimator", ["forward", "bidirectional"])
def test_both_estimators_have_them(photic, environments, tmp_path, estimator):
    done = photic("run", "quick.toml", "--set", f"simulation.estimator={estimator}", "-o", "out.nc")
    assert done.returncode == 0, done.stderr
    with netCDF4.Dataset(tmp_path / "out.nc") as file:
        assert file.estimator == estimator
        assert (file["environment_echo"][1] == file["echo"][:]).all()
        assert (file["environment_echo"][0] != file["echo"][:]).any()


def test_a_run_goes_on_with_them(photic, environments, tmp_path):
    for photons, more in ((9000, ()), (21000, ("--continue", "first.nc")), (21000, ())):
        name = "first.nc" if photons == 9000 else ("next.nc" if more else "once.nc")
        scene = () if more else ("quick.toml", "--set", "simulation.batch_photons=250")
        done = photic("run", *scene, "--photons", photons, *more, "-o", name)
        assert done.returncode == 0, done.stderr
    with netCDF4.Dataset(tmp_path / "next.nc") as then, netCDF4.Dataset(tmp_path / "once.nc") as once:
        names = ("environment_echo", "environment_difference_standard_error", "environment_convergence_flags")
        for name in (*names, "environment_value"):
            assert (then[name][:] == once[name][:]).all(), name


def test_water_that_histories_never_see_is_reported_at_its_place(photic, environments):
    text = environments.read_text()
    text = text.replace('"raman"\nprocess = "raman"', '"chl"\nprocess = "chlorophyll"')
    environments.write_text(text.replace("chlorophyll_mg_m3 = 1.0", "").replace("chlorophyll_mg_m3 = 0.1", ""))
    done = photic("check", "quick.toml")
    assert done.returncode == 2
    line = 1 + environments.read_text().splitlines().index("[[environment]]")
    assert f'quick.toml:{line}:1: environment "more algae": layer "layer1" emits chlorophyll light' in done.stderr


def test_waves_without_a_ratio_to_those_of_the_scene_are_refused_at_their_place(photic, scene):
    # Seen red: taken, with ratios that are no numbers.
    scene.write_text(scene.read_text() + '[[environment]]\nset = { "sea.surface.crosswind_slope_variance" = 0.0, "oil.thickness_um" = 2.0 }\n')
    oil = ("--set", 'oil={ class = "weakly-absorbing-crude", thickness_um = 1.0 }')

    def waves(across):
        return ("--set", f'sea.surface={{ model = "gaussian", upwind_slope_variance = 0.02, crosswind_slope_variance = {across} }}')

    done = photic("check", "quick.toml", *oil, *waves(0.01))
    assert done.returncode == 2
    line = 1 + scene.read_text().splitlines().index("[[environment]]")
    assert f"quick.toml:{line}:1: environment \"environment0\": along or across the wind its facets or the scene's, but not both, are all level" in done.stderr
    assert photic("check", "quick.toml", *oil, *waves(0.0)).returncode == 0


GRID = """\
[environment_grid]
"sea.layer.1.chlorophyll_mg_m3" = [1.0, 2.0]
"sea.layer.1.cdom_a440_per_m" = [0.01, 0.02, 0.03]
"""


# Seen red: with the last path changing slowest.
def test_a_grid_runs_as_its_environments(photic, environments, tmp_path):
    environments.write_text(environments.read_text() + GRID)
    done = photic("run", "quick.toml", "-o", "out.nc")
    assert done.returncode == 0, done.stderr
    assert "  3 more are in the file, and printed with --table full\n" in done.stdout
    assert "  C chlorophyll_mg_m3 = 1.0, cdom_a440_per_m = 0.01 (" in done.stdout
    with netCDF4.Dataset(tmp_path / "out.nc") as file:
        names = list(file["environment_name"][:])
        assert names[:3] == ["more algae", "the same", "chlorophyll_mg_m3 = 1.0, cdom_a440_per_m = 0.01"]
        assert names[6] == "chlorophyll_mg_m3 = 2.0, cdom_a440_per_m = 0.02" and len(names) == 8
        elastic = file["environment_echo"][2:, 0, 0, :].sum(axis=1)
        assert list(elastic[:3]) == sorted(elastic[:3], reverse=True)  # darker and darker
        paths = ["sea.layer.1.chlorophyll_mg_m3", "sea.layer.1.cdom_a440_per_m"]
        assert list(file["environment_path_name"][:]) == paths
        values = file["environment_value"][:].tolist()
        assert values[:2] == [[2.0, 0.0], [1.0, 0.0]]  # of the scene where nothing is set
        assert values[2:] == [[chlorophyll, cdom] for chlorophyll in (1.0, 2.0) for cdom in (0.01, 0.02, 0.03)]
        alone = float(file["environment_echo"][6, 0, 0, 3])
    (tmp_path / "alone.toml").write_text(photic("show", "out.nc").stdout)
    done = photic("run", "alone.toml", "-o", "again.nc")
    assert done.returncode == 0, done.stderr
    with netCDF4.Dataset(tmp_path / "again.nc") as file:
        assert float(file["environment_echo"][6, 0, 0, 3]) == alone


def test_what_is_wrong_with_a_grid_is_reported_at_the_value(photic, environments):
    text = environments.read_text() + GRID.replace("0.02", "-0.02")
    environments.write_text(text)
    done = photic("check", "quick.toml")
    assert done.returncode == 2
    line = len(text.splitlines())
    assert done.stderr.startswith(f"quick.toml:{line}:40: 'cdom_a440_per_m' must be a finite number, at least 0, not -0.02")
