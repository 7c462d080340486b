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


def run_over_the_sea(echo, relative_error=0.02, **more):
    """A result as photic.open gives it."""
    telescopes, channels, gates = echo.shape
    edges = numpy.arange(gates + 1.0)
    bounds = numpy.stack([edges[:-1], edges[1:]], axis=1)
    depths = numpy.tile(0.1 * bounds, (telescopes, channels, 1, 1))
    return xarray.Dataset(
        {
            "echo": (AXES, echo.copy()),
            "echo_standard_error": (AXES, relative_error * abs(echo)),
            "converged": (AXES, numpy.full(echo.shape, True)),
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
    )


def film(attenuation, ratio):
    axes = ("telescope", "channel")
    return {
        "film_attenuation": (axes, numpy.array(attenuation)),
        "film_interface_ratio": (axes, numpy.array(ratio)),
    }


def with_environments(result, echoes, error=0.02, error_of_difference=0.02):
    """The same with environments, by name; errors are relative to their echoes."""
    axes = ("environment", *AXES)
    echo = numpy.stack(list(echoes.values()))
    return result.assign(
        environment_echo=(axes, echo),
        environment_echo_standard_error=(axes, error * abs(echo)),
        environment_difference=(axes, echo - result.echo.values),
        environment_difference_standard_error=(axes, error_of_difference * abs(echo)),
        environment_converged=(axes, numpy.full(echo.shape, True)),
    ).assign_coords(environment=list(echoes))


def same(found, expected):
    return numpy.allclose(found.values, expected, rtol=1e-12, atol=1e-12)


def drawn_gates(count, errors, correlation):
    """Echoes under a film and of the clean sea, in as many gates as they were drawn: 2e-7 and 3e-7 on
    average, with relative errors and a correlation. An error of each, and of the difference."""
    means = numpy.array([2e-7, 3e-7])
    e, w = means * errors
    covariance = correlation * e * w
    random = numpy.random.default_rng(20260501)
    echoes = random.multivariate_normal(means, [[e**2, covariance], [covariance, w**2]], count)
    of_difference = numpy.sqrt(e**2 + w**2 - 2 * covariance)
    under, bare = (echoes[:, i].reshape(1, 1, count) for i in (0, 1))
    oily = run_over_the_sea(under, **film([[2e5]], [[0.98]]))
    oily["echo_standard_error"] = oily.echo * 0 + e
    return with_environments(oily, {"clean": bare}), bare, e, w, of_difference


def agrees(found):
    """Whether the thicknesses scatter as their errors say. Those of 2e5 gates give the scatter to
    0.16 %, and terms of the second order are below 0.1 %: 1 % is passed by chance in 1 of 1e8 cases."""
    predicted = float(numpy.sqrt((found.thickness_standard_error**2).mean()))
    return float(found.thickness.std()) == pytest.approx(predicted, rel=0.01)


def refused(*arguments, **options):
    with pytest.raises(photic.Error) as error:
        photic.oil_thickness(*arguments, **options)
    assert error.value.exit_code == 2
    return str(error.value)
