"""Results of made-up numbers over a sea with a film of oil and without."""

import numpy
import pytest
import xarray

import photic

TELESCOPES = ["narrow", "wide"]
CHANNELS = ["elastic", "raman"]
# By telescope and channel: absorption along both ways [1/m], and share passing over that of bare water.
ATTENUATION = numpy.array([[3e5, 2e5], [3.5e5, 2.5e5]])
RATIO = numpy.array([[0.97, 0.98], [0.99, 1.01]])
CLEAN_ECHO = numpy.array([[[9e-6, 4e-6, 1e-6], [3e-7, 2e-7, 5e-8]], [[8e-6, 5e-6, 2e-6], [6e-7, 3e-7, 7e-8]]])
THICKNESS_UM = numpy.array([[1.0, 2.5, 0.01], [5.0, 0.3, 20.0]])  # by telescope and gate
AXES = ("telescope", "channel", "gate")
FILM_UM = 2.0  # of the scene
OIL = f'[oil]\nclass = "weakly-absorbing-crude"\nthickness_um = {FILM_UM}\nabsorption_factor = 1.0\n'
GROUPS = 64
# Deviations of groups: orthogonal, without a mean, and such that the error of the mean (eq. 36) is 1.
TURN = 2 * numpy.pi * numpy.arange(GROUPS) / GROUPS
PATTERNS = numpy.sqrt(2 * (GROUPS - 1)) * numpy.stack([numpy.cos(TURN), numpy.sin(TURN)])


def by_group(echo, error, correlation=1.0):
    """Means of groups by which echoes have exactly these errors, with a correlation with those of 1."""
    scatter = numpy.array([correlation, numpy.sqrt(1 - correlation**2)]) @ PATTERNS
    return echo[..., None, :] + error[..., None, :] * scatter[:, None]


def run_over_the_sea(echo, error=None, **more):
    """A result as photic.open gives it, with relative errors of 0.02 unless errors are given."""
    telescopes, channels, gates = echo.shape
    edges = numpy.arange(gates + 1.0)
    bounds = numpy.stack([edges[:-1], edges[1:]], axis=1)
    depths = numpy.tile(0.1 * bounds, (telescopes, channels, 1, 1))
    error = 0.02 * abs(echo) if error is None else numpy.broadcast_to(error, echo.shape)
    return xarray.Dataset(
        {
            "echo": (AXES, echo.copy()),
            "echo_standard_error": (AXES, error.copy()),
            "converged": (AXES, numpy.full(echo.shape, True)),
            "echo_by_group": (("telescope", "channel", "batch_group", "gate"), by_group(echo, error)),
            "group_photons": (("telescope", "channel", "batch_group"), numpy.full((telescopes, channels, GROUPS), 1000.0)),
            **more,
        },
        coords={
            "telescope": TELESCOPES[:telescopes],
            "channel": CHANNELS[-channels:],
            "channel_wavelength": ("channel", [355.0, 404.0][-channels:], {"units": "nm"}),
            "gate_time": ("gate", bounds.mean(axis=-1), {"units": "ns"}),
            "gate_time_bounds": (("gate", "bnds"), bounds),
            "gate_depth": (AXES, depths.mean(axis=-1), {"units": "m"}),
            "gate_depth_bounds": ((*AXES, "bnds"), depths),
        },
        attrs={"scene": OIL if "film_attenuation" in more else ""},
    )


def film(attenuation, ratio):
    axes = ("telescope", "channel")
    return {
        "film_attenuation": (axes, numpy.array(attenuation)),
        "film_interface_ratio": (axes, numpy.array(ratio)),
    }


def with_environments(result, echoes, errors=None, correlation=0.5, sets=None):
    """The same with environments, by name: with relative errors of 0.02 unless errors are given, with a correlation
    with those of the scene, and with what they set."""
    axes = ("environment", *AXES)
    echo = numpy.stack(list(echoes.values()))
    error = 0.02 * abs(echo) if errors is None else numpy.broadcast_to(errors, echo.shape)
    usual = {"clean": '"oil.thickness_um" = 0', "more algae": '"sea.layer.0.chlorophyll_mg_m3" = 0.5'}
    set_in = usual | (sets or {})
    texts = [f'[[environment]]\nname = "{name}"\nset = {{ {set_in[name]} }}\n' for name in echoes]
    return result.assign(
        environment_echo=(axes, echo),
        environment_echo_standard_error=(axes, error.copy()),
        environment_converged=(axes, numpy.full(echo.shape, True)),
        environment_echo_by_group=((*axes[:3], "batch_group", "gate"), by_group(echo, error, correlation)),
    ).assign_coords(environment=list(echoes)).assign_attrs(scene=result.attrs["scene"] + "".join(texts))


def same(found, expected):
    return numpy.allclose(found.values, expected, rtol=1e-12, atol=1e-12)


def drawn_gates(count, errors, correlation):
    """Echoes under a film and of the clean sea, in as many gates as they were drawn: 2e-7 and 3e-7 on
    average, with relative errors and a correlation, which groups have as well. Returns the run over the
    film, with the clean sea as an environment, the echo there and its error."""
    means = numpy.array([2e-7, 3e-7])
    e, w = means * errors
    covariance = correlation * e * w
    random = numpy.random.default_rng(20260501)
    echoes = random.multivariate_normal(means, [[e**2, covariance], [covariance, w**2]], count)
    under, bare = (echoes[:, i].reshape(1, 1, count) for i in (0, 1))
    oily = run_over_the_sea(under, e, **film([[2e5]], [[0.98]]))
    return with_environments(oily, {"clean": bare}, w, correlation), bare, w


def agrees(found):
    """Returns whether the thicknesses scatter as their errors state. Those of 20 000 gates give the scatter to
    0.5 %, and terms of the second order are below 0.1 %: 2.6 % is passed by chance in 1 of 1e6 cases."""
    predicted = float(numpy.sqrt((found.thickness_standard_error**2).mean()))
    return float(found.thickness.std()) == pytest.approx(predicted, rel=0.026)


def refused(*arguments, **options):
    with pytest.raises(photic.Error) as error:
        photic.oil_thickness(*arguments, **options)
    assert error.value.exit_code == 2
    return str(error.value)
