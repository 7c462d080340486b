"""The pairs that `photic check` refuses, and the table of them in docs/guide.md."""

import itertools
import textwrap
from dataclasses import dataclass

from pair_array.covering import all_pairs, plainest
from pair_array.features import FOAM_ON_OIL, NEEDS

HEAD = ["of these", "with these", "reason"]
WIDTH = 100  # of a page's lines
WORDS = {  # by which a message names a value, else its feature; in the text, the path or the suggestion
    "surface": ["surface", "waves", "model ="],
    "film": ["oil"], "shining film": ["oil"], "whitecaps": ["whitecap"], "slick": ["slick"],
    "bed": ["bed", "bottom"], "air": ["air", "atmosphere"], "instruments": ["instrument", "source", "telescope", "laser"],
    "lens": ["lens", "detector", "obstruction"], "overlap": ["reception"],
    "view": ["view"], "water": ["water", "layer"], "profile": ["profile"],
    "light": ["channel", "light"],
    "environments": ["environment"], "environments of other surfaces": ["environment"], "derivatives": ["derivative", "sensitivity"],
    "tools": ["tools"], "forced collisions": ["forced_collisions", "tools"], "continued": ["continue"], "gates": ["gates"],
}


@dataclass
class Refusal:
    """Of any of these (feature, value) with any of others, for one reason."""

    these: list
    others: list
    problems: list

    @property
    def text(self):
        return "; ".join(dict.fromkeys(self.problems))

    def unnamed(self):
        """The values that the message does not name."""
        for feature, value in self.these + self.others:
            if not any(word in self.text for word in WORDS.get(value, WORDS.get(feature, [value]))):
                yield feature, value


def _follows(pair, refusals):
    """Whether a pair is refused because of what one of its values needs, which has a refusal of its own."""
    for one, other in (pair, pair[::-1]):
        for need in NEEDS.get(one, {}).items():
            if need[0] != other[0] and refusals.of(plainest(need, other)) == refusals.of_pair(pair):
                return True
    return False


def _foam_on_oil(refusals):
    problems = refusals.of(plainest(("surface", "cox-munk"), ("on the surface", " and ".join(FOAM_ON_OIL))))
    return [Refusal(*([("on the surface", value)] for value in FOAM_ON_OIL), problems)] if problems else []


def refused(refusals):
    """All refusals; those of one feature with another for one reason are one where each value is refused with each."""
    found = {}
    for one, other in all_pairs():
        problems = refusals.of_pair((one, other))
        if problems and not _follows((one, other), refusals):
            found.setdefault((one[0], other[0], tuple(problems)), {}).setdefault(one, []).append(other)
    out = []
    for (*_, problems), others in found.items():
        same = {}
        for one, of_it in others.items():
            same.setdefault(tuple(of_it), []).append(one)
        out += [Refusal(these, list(of_them), list(problems)) for of_them, these in same.items()]
    return out + _foam_on_oil(refusals)


def _cell(side):
    return f"{side[0][0]}: {', '.join(value for _, value in side)}"


def reasons(found):
    return list(dict.fromkeys(refusal.text for refusal in found))


def rows(found):
    """Rows of a table; its last column are the numbers of the reasons, from 1 on."""
    return [[_cell(refusal.these), _cell(refusal.others), str(1 + reasons(found).index(refusal.text))] for refusal in found]


def numbered(found):
    """The reasons as a list in Markdown."""
    return ["\n".join(textwrap.wrap(text, WIDTH, initial_indent=f"{n}. ", subsequent_indent="   ", break_long_words=False, break_on_hyphens=False))
            for n, text in enumerate(reasons(found), 1)]


def _side(cell):
    feature, _, values = cell.strip().partition(": ")
    return [(feature, value) for value in values.split(", ")]


def listed(table):
    """The pairs of a table of such rows."""
    for line in [line for line in table.splitlines() if line.startswith("|")][2:]:
        these, others = line.strip("|").split("|")[:2]
        yield from itertools.product(_side(these), _side(others))
