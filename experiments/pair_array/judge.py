"""The runs of a scene over its seeds, and their verdict: agreement, disagreement, or none."""

import math
import sys
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from pair_array import compare
from pair_array.features import BATCH, scene_of
from pair_array.program import ESTIMATORS

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "benchmarks"))
from measure.accuracy import family_wise_z  # noqa: E402

RMS = (0.7, 1.4)
UNFLAGGED_SEEDS = 0.9  # for a quantity to be compared, by its mean over all: seeds that lack rare large scores are the unflagged ones
UNFLAGGED_GATES = 0.5  # of those with light, for a scene to be conclusive
PHOTONS = {"forward": 2_500_000, "bidirectional": 500_000}
FEWEST_BATCHES = 60  # below 30 all gates are flagged
COSTS = {  # of a photon, over that of the plainest scene: scenes with these have as many fewer; more have wide views, whose tails are long
    ("view", "wide"): 0.4, ("air", "molecules"): 2.5, ("air", "haze"): 3, ("air", "refraction"): 2, ("water", "profile"): 2, ("light", "filter"): 1.5,
    ("run", "environments"): 2, ("run", "environments of other surfaces"): 2, ("run", "derivatives"): 3,
    ("run", "scalar"): 2.5, ("run", "continued"): 1.5, ("instruments", "both below"): 0.7,
}


@dataclass
class Outcome:
    """Of one scene: differences, errors and what is known, arrays of all seeds by family, and what else is wrong."""

    values: dict
    seeds: int
    families: dict = field(default_factory=dict)
    faults: list = field(default_factory=list)
    lit: int = 0  # gates with light
    flagged: dict = field(default_factory=dict)  # of these, by estimator, in most seeds

    def add(self, family, one, other):
        rows = self.families.setdefault(family, ([], [], []))
        for row, of_seed in zip(rows, (one.value - other.value, np.hypot(one.error, other.error), one.known & other.known)):
            row.append(of_seed)

    def _rows(self, family):
        """Differences and errors by seed, NaN where a quantity is flagged in either too often to be compared."""
        difference, error, known = (np.array(rows) for rows in self.families[family])
        enough = (known.mean(axis=0) >= UNFLAGGED_SEEDS) & (error > 0).all(axis=0)
        return np.where(enough, difference, np.nan), np.where(enough, error, np.nan)

    def compared(self, family):
        """z of the means over the seeds; NaN for what is not compared."""
        difference, error = self._rows(family)
        return difference.sum(axis=0) / np.sqrt(np.square(error).sum(axis=0))

    def of_seeds(self):
        """The z of every seed, of all that is compared."""
        z = np.concatenate([(difference / error).ravel() for difference, error in map(self._rows, self.families)])
        return z[np.isfinite(z)]

    @property
    def count(self):
        return sum(int(np.isfinite(self.compared(family)).sum()) for family in self.families)

    @property
    def rms(self):
        z = self.of_seeds()
        return float(np.sqrt(np.mean(z**2))) if z.size else float("nan")

    @property
    def unflagged(self):
        """The number of gates that neither estimator flags, as the mean over seeds."""
        return float(np.array(self.families["gates"][2]).sum() / self.seeds)

    @property
    def conclusive(self):
        return self.lit > 0 and self.unflagged >= UNFLAGGED_GATES * self.lit

    def largest(self):
        """(|z|, where) of the comparison that is farthest off."""
        found = [(0.0, "nothing compared")]
        for family in self.families:
            z = self.compared(family)
            if np.isfinite(z).any():
                place = np.unravel_index(np.nanargmax(np.abs(z)), z.shape)
                found.append((float(z[place]), f"{family} {list(map(int, place))}"))
        return max(found, key=lambda one: abs(one[0]))

    def beyond(self, bound):
        """All comparisons farther off than a bound, by family."""
        for family in self.families:
            z = self.compared(family)
            for place in np.argwhere(np.abs(np.nan_to_num(z)) > bound):
                yield f"{family} {place.tolist()}: z {z[tuple(place)]:+.2f}"

    def held(self, bound):
        return not self.faults and abs(self.largest()[0]) <= bound and (self.count == 0 or RMS[0] <= self.rms <= RMS[1])


def _count_light(outcome, results):
    """Gates with light in any seed, and those flagged in most seeds."""
    lit = np.any([result["echo"] > 0 for of_seed in results for result in of_seed.values()], axis=0)
    outcome.lit = int(lit.sum())
    for estimator in ESTIMATORS:
        known = np.mean([of_seed[estimator]["converged"] == 1 for of_seed in results], axis=0)
        outcome.flagged[estimator] = int((lit & (known < 0.5)).sum())


def photons_of(values, estimator, share):
    cost = math.prod(COSTS.get(one, 1) for one in values.items())
    return BATCH * max(FEWEST_BATCHES, round(share * PHOTONS[estimator] / cost / BATCH))


def outcome_of(program, values, seeds, share=1.0):
    """Runs a scene by both estimators with seeds from 1 on; `share`: of the photons."""
    scene, kind = scene_of(values), values["run"]
    outcome, all_results = Outcome(values, seeds), []
    for seed in range(1, seeds + 1):
        def run(of_scene, estimator, n=0, **more):
            photons = photons_of(values, estimator, share)
            return program.run(of_scene, estimator, photons, seed + n * compare.OTHER_SEED, **more)

        engine = {"engine": ("--engine", "scalar")} if kind == "scalar" else {}
        results = {estimator: run(scene, estimator, **engine) for estimator in ESTIMATORS}
        all_results.append(results)
        for family, one, other in compare.comparisons(scene, results, run):
            outcome.add(family, one, other)
        more = {"sittings": 2} if kind == "continued" else {}
        outcome.faults += compare.faults(kind, results, lambda estimator: run(scene, estimator, **more))
    _count_light(outcome, all_results)
    return outcome


def bound_of(outcomes):
    """What all comparisons of an array stay below, but for a chance of 1 in 100."""
    return family_wise_z(max(1, sum(outcome.count for outcome in outcomes)))
