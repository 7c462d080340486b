"""The remarks of a file on data that are not verified."""

import re

MARKS = {"from memory": "Optical data from memory", "placeholder": "Placeholders for optical data"}
LAYER = re.compile(r"^layer \d+( at [\d.]+ nm)?: ")
WAVELENGTHS = re.compile(r",?( at)? [\d.]+((-| to )[\d.]+)? nm$")
MOST_NAMED = 6


def caution(dataset):
    """A sentence for each mark that any of the file's sources carries; "" if there is none."""
    lines = dataset.attrs.get("optics_sources") or dataset.attrs.get("references", "")
    said = []
    for mark, words in MARKS.items():
        bracket = re.compile(rf"\[[^\]]*{mark}[^\]]*\]")
        marked = dict.fromkeys(_quantity(line) for line in lines.split("\n") if bracket.search(line))
        if marked:
            more = f" and {len(marked) - MOST_NAMED} more" if len(marked) > MOST_NAMED else ""
            said.append(f"{words}: {', '.join(list(marked)[:MOST_NAMED])}{more}.")
    return " ".join(said)


def _quantity(line):
    """The quantity whose source a line gives."""
    return WAVELENGTHS.sub("", re.split(" = |: ", LAYER.sub("", line), maxsplit=1)[0])
