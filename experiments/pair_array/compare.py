"""What the runs of a scene compare: two values of a quantity, and whether both are known, seed by seed."""

from dataclasses import dataclass

import numpy as np

from pair_array.features import own_scene
from pair_array.program import ESTIMATORS
from pair_array.scenes import changed, value_at, without

CONVERGED = {"echo": "converged", "environment_echo": "environment_converged", "logarithmic_sensitivity": "sensitivity_converged"}
ECHOES = {"gates": "echo", "processes": "echo_by_process", "orders": "echo_by_order"}
SAME_PHOTONS = 0.5  # from lanes in float to the scalar engine in double, in standard errors: rounding sends few photons another way
STEP = 0.15  # up and down, of the parameter of a derivative, relative
OTHER_SEED = 1000  # the seeds of runs that others are compared with: added once for each


@dataclass
class Values:
    """Numbers with their errors, and which of them no flag warns of."""

    value: np.ndarray
    error: np.ndarray
    known: np.ndarray

    @staticmethod
    def of(result, name, *index):
        known = result[CONVERGED.get(name, f"{name}_converged")][index] == 1
        error = result[f"{name}_standard_error"][index]
        return Values(result[name][index], error, known & np.isfinite(error) & (error > 0))


def _processes(result):
    """By process, but for processes that are all of their gate: these are compared as gates."""
    of_all = Values.of(result, "echo_by_process")
    lone = np.isclose(of_all.value, result["echo"][:, :, np.newaxis, :], rtol=1e-9, atol=0)
    return Values(of_all.value, of_all.error, of_all.known & ~lone)


def _by_estimators(results):
    for family, name in ECHOES.items():
        one, other = (_processes(result) if family == "processes" else Values.of(result, name) for result in results.values())
        yield family, one, other


def _environments(scene, results, run):
    for k, environment in enumerate(scene["environment"]):
        yield f"environment {k}", *(Values.of(result, "environment_echo", k) for result in results.values())
        alone = own_scene(scene, environment)
        for estimator, result in results.items():
            own = run(alone, estimator, 1 + k)
            yield f"environment {k} and its own run, {estimator}", Values.of(result, "environment_echo", k), Values.of(own, "echo")


def _slope(lower, upper):
    """The logarithmic derivative by a central difference: exact for echoes that are powers or exponentials."""
    width = np.log1p(STEP) - np.log1p(-STEP)
    a, b = Values.of(lower, "echo"), Values.of(upper, "echo")
    known = a.known & b.known & (a.value > 0) & (b.value > 0)
    with np.errstate(divide="ignore", invalid="ignore"):
        return Values(np.log(b.value / a.value) / width, np.hypot(a.error / a.value, b.error / b.value) / width, known)


def _sensitivities(scene, results, run):
    plain = without(scene, "sensitivity")
    for k, path in enumerate(scene["sensitivity"]):
        yield f"derivative {k}", *(Values.of(result, "logarithmic_sensitivity", k) for result in results.values())
        at = value_at(scene, path)
        ends = [changed(plain, {path: at * (1 + step)}) for step in (-STEP, STEP)]
        for estimator, result in results.items():
            slope = _slope(*(run(end, estimator, 1 + 2 * k + n) for n, end in enumerate(ends)))
            yield f"derivative {k} and a difference, {estimator}", Values.of(result, "logarithmic_sensitivity", k), slope


def comparisons(scene, results, run):
    """(family, one, other) of a seed; `results` by estimator; run(scene, estimator, n): the n-th further run."""
    yield from _by_estimators(results)
    if "environment" in scene:
        yield from _environments(scene, results, run)
    if "sensitivity" in scene:
        yield from _sensitivities(scene, results, run)


def differing(one, other):
    """The names of variables that are not equal to the last bit."""
    return [name for name in one if not np.array_equal(one[name], other.get(name), equal_nan=isinstance(one[name], np.ndarray))]


def _far_from_scalar(lanes, scalar):
    a, b = Values.of(lanes, "echo"), Values.of(scalar, "echo")
    both = a.known & b.known
    return float(np.max(np.abs(a.value - b.value)[both] / b.error[both], initial=0))


def faults(kind, results, again):
    """What differs although it is of the same photons; `kind`: of run; again(estimator): the same run in another way."""
    for estimator in ESTIMATORS if kind in ("scalar", "continued") else ():
        other = again(estimator)
        if kind == "continued" and (names := differing(results[estimator], other)):
            yield f"{estimator}, in two sittings: {', '.join(names)} differ"
        if kind == "scalar" and (far := _far_from_scalar(other, results[estimator])) > SAME_PHOTONS:
            yield f"{estimator}: lanes are {far:.2f} standard errors from the scalar engine"
