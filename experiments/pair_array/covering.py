"""A covering array: few scenes in which each pair of values of two features that can be combined stands at least once."""

import itertools
import random

from pair_array.features import FEATURES, NEEDS

CANDIDATES = 30  # scenes that are tried for each that is taken
TRIES = 20  # to place a pair, until it counts as one that no scene can hold


def plainest(*chosen):
    """The scene that is about some (feature, value) alone: of all others the first value, or what these need."""
    values = {feature: of_it[0] for feature, of_it in FEATURES.items()}
    for one in chosen:
        values |= NEEDS.get(one, {})
    return values | dict(chosen)


def all_pairs(features=None):
    """Pairs of values, as pairs of (feature, value)."""
    features = FEATURES if features is None else features
    for one, other in itertools.combinations(features, 2):
        yield from itertools.product(((one, value) for value in features[one]), ((other, value) for value in features[other]))


def pairs_of(values):
    return set(itertools.combinations(values.items(), 2))


class Refusals:
    """The findings of `photic check` on scenes; each is asked once. `problems(values)`: lines, none where a scene is accepted."""

    def __init__(self, problems):
        self._problems, self._known = problems, {}
        self._accepted, self.refused = set(), set()  # pairs, as far as is known

    def of(self, values):
        key = tuple(values.items())
        if key not in self._known:
            self._known[key] = self._problems(values)
            if not self._known[key]:
                self._accepted |= pairs_of(values)
        return self._known[key]

    def of_pair(self, pair):
        """Of the scene that is about a pair alone; a pair that stands in any accepted scene is accepted."""
        if pair in self._accepted:
            return []
        problems = self.of(plainest(*pair))
        if problems:
            self.refused.add(pair)
        return problems


def _fill(values, missing, refused, rng):
    """A scene with some values, in which further ones are chosen, feature by feature, for as many as possible of the missing pairs."""
    values = dict(values)
    left = [feature for feature in FEATURES if feature not in values]
    rng.shuffle(left)
    for feature in left:
        pairs = {value: [_pair(one, (feature, value)) for one in values.items()] for value in FEATURES[feature]}
        gains = {value: sum(pair in missing for pair in of_it) for value, of_it in pairs.items() if refused.isdisjoint(of_it)}
        if not gains:
            return None
        values[feature] = rng.choice([value for value in gains if gains[value] == max(gains.values())])
    return {feature: values[feature] for feature in FEATURES}


def _pair(one, other):
    """In the order of the features."""
    order = list(FEATURES)
    return (one, other) if order.index(one[0]) < order.index(other[0]) else (other, one)


def _scene(target, missing, refused, rng, try_number):
    """The best of some scenes with a pair; from the second try on one of all, as `check` may refuse more than two features together."""
    if try_number > 0:
        return _fill(dict(target), set(), refused, rng)
    candidates = [_fill(dict(target), missing, refused, rng) for _ in range(CANDIDATES)]
    return max(filter(None, candidates), key=lambda values: len(pairs_of(values) & missing), default=None)


def make(refusals, seed):
    """The scenes, and the pairs that `check` accepts alone, but in none of the scenes that were tried."""
    rng = random.Random(seed)
    missing, tries = set(all_pairs()), {}
    scenes, nowhere = [], []
    while missing:
        target = min(missing)
        values = _scene(target, missing, refusals.refused, rng, tries.get(target, 0))
        if values and not refusals.of(values):
            scenes.append(values)
            missing -= pairs_of(values)
            continue
        for pair in sorted(pairs_of(values or plainest(*target))):
            refusals.of_pair(pair)
        missing -= refusals.refused
        tries[target] = tries.get(target, 0) + 1
        if target in missing and tries[target] >= TRIES:
            missing.discard(target)
            nowhere.append(target)
    return scenes, nowhere
