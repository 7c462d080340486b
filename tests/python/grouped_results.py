"""Results with groups of batches, made up by hand."""

import numpy
import xarray

GATES, GROUPS = 4, 64


def result_of(means, photons=None, error=None, flagged=()):
    """A result of one telescope and two channels with these means [channel, group, gate]."""
    means = numpy.asarray(means, dtype=float)[None]
    photons = numpy.full(means.shape[1:3], 1000.0) if photons is None else numpy.asarray(photons, dtype=float)
    weights = photons[None, :, :, None]
    echo = (numpy.nan_to_num(means) * weights).sum(axis=2) / weights.sum(axis=2)
    groups = (photons > 0).sum(axis=1)[None, :, None]
    spread = (weights * (numpy.nan_to_num(means) - echo[:, :, None]) ** 2 * (weights > 0)).sum(axis=2)
    own = numpy.sqrt(spread / weights.sum(axis=2) / numpy.where(groups > 1, groups - 1, numpy.nan))
    where = ("telescope", "channel", "gate")
    by_group = ("telescope", "channel", "batch_group", "gate")
    converged = numpy.ones(echo.shape, dtype=bool)
    for gate in flagged:
        converged[..., gate] = False
    return xarray.Dataset(
        {
            "echo": (where, echo),
            "echo_standard_error": (where, own if error is None else error * own),
            "converged": (where, converged),
            "echo_by_group": (by_group, means),
            "group_photons": (by_group[:3], photons[None]),
        },
        coords={"telescope": ["t"], "channel": ["raman", "chlorophyll"], "batch_group": numpy.arange(means.shape[2])},
    )


def correlated(seed=1, groups=GROUPS, correlation=0.8):
    """Means of two channels about 1, with a scatter of 5 % that neighbours and channels share."""
    random = numpy.random.default_rng(seed)
    shared = random.normal(size=(1, groups, 1))
    own = random.normal(size=(2, groups, GATES))
    return 1 + 0.05 * (numpy.sqrt(correlation) * shared + numpy.sqrt(1 - correlation) * own)
