"""photic.oil_thickness of films that are those of environments, on results of made-up numbers."""

import numpy
import pytest
from oil_results import (
    ATTENUATION,
    CLEAN_ECHO,
    FILM_UM,
    RATIO,
    agrees,
    drawn_gates,
    refused,
    run_over_the_sea,
    same,
    with_environments,
)

import photic

THICK_UM = 5.0
SETS = {"thick": f'"oil.thickness_um" = {THICK_UM}', "as the scene": '"sea.layer.0.chlorophyll_mg_m3" = 0.5'}


def thick_echo():
    return CLEAN_ECHO * RATIO[:, :, None] * numpy.exp(-1e-6 * THICK_UM * ATTENUATION[:, :, None])


def with_films(oily, sets=None, **options):
    echoes = {"thick": thick_echo(), "clean": CLEAN_ECHO, "as the scene": oily.echo.values}
    return with_environments(oily.drop_dims("environment"), echoes, sets=SETS | (sets or {}), **options)


# Seen red: with the scene's echo, or its flags; with the clean sea of the first environment; with the coordinates of an
# environment kept.
@pytest.mark.parametrize("by_run", [False, True], ids=["environment", "another run"])
def test_the_film_of_an_environment(oily, clean, by_run):
    films = with_films(oily).assign_coords({"oil.thickness_um": ("environment", [THICK_UM, 0.0, FILM_UM])})
    films.environment_converged[0, 1, 1, 2] = False
    films.converged[0] = False
    found = photic.oil_thickness(films, clean if by_run else "clean", environment="thick")
    assert same(found.thickness, THICK_UM)
    assert found.reliable.values.tolist() == [[True, True, True], [True, True, False]]
    own = photic.oil_thickness(films, clean if by_run else "clean")
    assert found.coords.to_dataset().equals(own.coords.to_dataset())


# Seen red: with the thickness of the scene's film; with what the environment sets alone.
@pytest.mark.parametrize(("name", "film_um"), [("thick", THICK_UM), ("as the scene", FILM_UM)])
def test_a_measured_ratio_is_compared_with_that_over_the_environments_film(oily, name, film_um):
    films = with_films(oily)
    echo = films.environment_echo.sel(environment=name, channel="raman").values
    ratio = numpy.exp(-1e-6 * ATTENUATION[0, 1] * 3.0) * (echo / CLEAN_ECHO[:, 1])[0]
    found = photic.oil_thickness(films, "clean", environment=name, ratio=ratio, ratio_error=0.01)
    assert same(found.thickness[0], film_um + 3.0)


# The scene's echo is neither of both, and has no part in it.
# Seen red: with that echo; with the clean sea's left as it is whatever group is left out; with both errors as independent.
@pytest.mark.parametrize("correlation", [-0.5, 0.9, 0.99])
def test_errors_of_two_environments_are_correlated(correlation):
    oily, bare, w = drawn_gates(20_000, numpy.array([0.02, 0.015]), correlation)
    of_film = {name: oily[name] for name in ("film_attenuation", "film_interface_ratio")}
    scene = run_over_the_sea(oily.echo.values + 1e-7, 1e-9, **of_film)
    echoes, errors = {"thick": oily.echo.values, "clean": bare}, numpy.array([2e-7 * 0.02, w])
    films = with_environments(scene, echoes, errors[:, None, None, None], correlation, SETS)
    films.environment_echo_by_group[0] = oily.echo_by_group.values
    assert agrees(photic.oil_thickness(films, "clean", environment="thick"))


# Seen red: with the error of the scene's echo; without that of the clean sea; with both added up.
def test_errors_of_an_environment_and_another_run_are_not(oily, clean):
    films = with_films(oily, errors=0.04 * numpy.stack([thick_echo(), CLEAN_ECHO, CLEAN_ECHO]))
    found = photic.oil_thickness(films, clean, environment="thick")
    expected = 1e6 / ATTENUATION[:, 1, None] * numpy.hypot(0.04, 0.03)
    assert same(found.thickness_standard_error, numpy.broadcast_to(expected, (2, 3)))


# Seen red: with names that are no text taken as they are.
def test_unknown_environments(oily, clean):
    assert refused(with_films(oily), "clean", environment="thik") == "result: there is no environment 'thik' (did you mean 'thick'?)"
    assert refused(with_films(oily), "clean", environment=["thick"]).startswith("result: there is no environment \"['thick']\"")
    reason = "result: there is no environment 'thick', nor any other: add [[environment]] to the scene"
    assert refused(oily.drop_dims("environment"), clean, environment="thick") == reason


# Seen red: without the look at it; with a look at all keys; with keys refused whatever their values are.
def test_the_oil_of_environments_is_the_scenes(oily):
    other = with_films(oily, {"thick": '"oil.thickness_um" = 5.0, "oil.absorption_factor" = 2.0'})
    assert refused(other, "clean", environment="thick") == (
        "environment: 'thick' sets oil.absorption_factor, too, and what is known of absorption is that of the scene's "
        "own film: let them differ in oil.thickness_um"
    )
    for harmless in ('"oil.absorption_factor" = 1.0', '"oil.yield" = 0.01'):
        films = with_films(oily, {"thick": f'"oil.thickness_um" = 5.0, {harmless}'})
        assert same(photic.oil_thickness(films, "clean", environment="thick").thickness, THICK_UM)


# Seen red: without either look at the thickness; with what environments set alone.
def test_environments_with_a_film_and_without(oily):
    films = with_films(oily)
    reason = "environment: 'clean' has no film of oil: its oil.thickness_um is 0"
    assert refused(films, "clean", environment="clean") == reason
    for name in ("thick", "as the scene"):
        reason = f"clean: environment {name!r} has a film of oil itself: take one with oil.thickness_um = 0"
        assert refused(films, name) == reason
