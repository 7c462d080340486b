"""Intervals of what is made of several echoes hold the truth: experiments/coverage_of_what_is_made.py, of one scene and few seeds."""

import sys

import numpy
import photic as package
import pytest
from conftest import SOURCE

sys.path.insert(0, str(SOURCE / "experiments"))
import coverage_of_what_is_made as experiment  # noqa: E402

SEEDS = 50


@pytest.fixture(scope="module")
def runs():
    scene = package.Scene.new("ship")
    scene.update({
        "channel": [{"name": name, "process": name} for name in ("elastic", "raman")],
        "gates.depth_max_m": 12, "simulation.estimator": "bidirectional", "simulation.batch_photons": 250,
    })  # fmt: skip
    scene["environment"] = [experiment.MORE_ALGAE]
    return experiment.runs_of(scene, SEEDS, photons=8500, threads=2)


# Within four deviations of 95 %, the seeds being independent; the median of errors over the scatter of 50 seeds is known to 10 %.
# Seen red: with errors of half the size; with errors of the gates in quadrature (K).
@pytest.mark.parametrize("number", range(5))
def test_what_is_made_of_echoes_scatters_as_its_errors_say(runs, number):
    function = list(experiment.made("elastic", "raman").values())[number]
    z, claimed = experiment.intervals(runs, function)
    share, scatter = experiment.coverage(z)
    assert numpy.isfinite(z).sum() > SEEDS / 2
    assert abs(share - 0.95) < 4 * max(scatter, numpy.sqrt(0.95 * 0.05 / numpy.isfinite(z).sum()))
    assert 0.7 < numpy.nanmedian(claimed) < 1.3
