"""The text between two markers of a page, which a script writes anew."""

import re

from measure.program import Failed

END = "<!-- end -->"


def _place(name):
    return re.compile(f"(<!-- measured: {re.escape(name)} -->\n)(.*?)({re.escape(END)})", re.DOTALL)


def read(page, text, name):
    found = _place(name).findall(text)
    if len(found) != 1:
        raise Failed(f"{page}: {len(found)} places between '<!-- measured: {name} -->' and '{END}', not one")
    return found[0][1]


def written(page, text, name, new):
    """`text` of a page with `new` in the place of that name."""
    read(page, text, name)
    return _place(name).sub(lambda found: found[1] + new + found[3], text)
