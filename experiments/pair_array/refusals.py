"""The pairs that `photic check` refuses, and the table of them in docs/guide.md."""

from dataclasses import dataclass

from pair_array.covering import all_pairs, plainest
from pair_array.features import FOAM_ON_OIL, NEEDS

HEAD = ["of these", "with these", "`photic check` says"]
WORDS = {  # by which a message names a value, else its feature; in the text, the path or the suggestion
    "surface": ["surface", "waves", "model ="], "film": ["oil"], "shining film": ["oil"], "whitecaps": ["whitecap"], "slick": ["slick"],
    "bed": ["bed", "bottom"], "air": ["air", "atmosphere"], "instruments": ["instrument", "source", "telescope", "laser"],
    "lens": ["lens", "detector", "obstruction"], "overlap": ["reception"], "view": ["view"], "water": ["water", "layer"], "profile": ["profile"],
    "light": ["channel", "light"], "environments": ["environment"], "environments of other surfaces": ["environment"], "derivatives": ["derivative", "sensitivity"],
    "tools": ["tools"], "forced collisions": ["forced_collisions", "tools"], "continued": ["continue"], "gates": ["gates"],
}


@dataclass
class Refusal:
    """Of pairs of one value of a feature with one of another, for one reason."""

    pairs: list
    problems: list

    @property
    def text(self):
        return "; ".join(dict.fromkeys(self.problems))

    @property
    def sides(self):
        """The values of both features."""
        return tuple([*dict.fromkeys(side)] for side in zip(*self.pairs))

    def unnamed(self):
        """The values that the message does not name."""
        for feature, value in {one for pair in self.pairs for one in pair}:
            if not any(word in self.text for word in WORDS.get(value, WORDS.get(feature, [value]))):
                yield feature, value


def _follows(pair, refusals):
    """Whether a pair is refused because of what one of its values needs, which has a refusal of its own."""
    for one, other in (pair, pair[::-1]):
        for need in NEEDS.get(one, {}).items():
            if need[0] != other[0] and refusals.of(plainest(need, other)) == refusals.of_pair(pair):
                return True
    return False


def refused(refusals):
    """All refusals, those of one reason as one."""
    found = {}
    for pair in all_pairs():
        problems = refusals.of_pair(pair)
        if problems and not _follows(pair, refusals):
            found.setdefault((pair[0][0], pair[1][0], tuple(problems)), []).append(pair)
    foam = refusals.of(plainest(("surface", "cox-munk"), ("on the surface", " and ".join(FOAM_ON_OIL))))
    if foam:
        oil, whitecaps = (("on the surface", value) for value in FOAM_ON_OIL)
        found[*oil, tuple(foam)] = [(oil, whitecaps)]
    return [Refusal(pairs, list(problems)) for (_, _, problems), pairs in found.items()]


def rows(found):
    for refusal in found:
        yield [*(f"{side[0][0]}: {', '.join(value for _, value in side)}" for side in refusal.sides), refusal.text]
