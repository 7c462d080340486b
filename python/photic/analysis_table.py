"""Numbers of `photic analyse` as text: a table, CSV and JSON. None is left out."""

import csv
import io
import json
import math

import numpy

from photic.columns import decimals_of, letters, with_error, with_unit

PLACE = 10  # columns of the text
LONGEST_LABEL = 18  # of a column: longer ones get a letter
NARROWEST = 40
FLAG = "* not reliable: a gate that it is made of has not converged, or its error is not known"
FIELDS = ["quantity", "units", "telescope", "channel", "environment", "gate", "place", "value", "standard_error", "reliable"]


def table(analysis, title, width):
    """Aligned columns for a terminal."""
    parts = [title, *_meanings(analysis.blocks)]
    for block in analysis.blocks:
        parts += ["", f"telescope {block.telescope}", *_columns(block, max(width, NARROWEST)), *_numbers(block)]
    notes = [FLAG] * any(_flagged(block) for block in analysis.blocks) + analysis.notes
    return "\n".join(parts + [""] * bool(notes) + notes) + "\n"


def _meanings(blocks):
    """A line for each quantity: what it is, and its unit."""
    every = [column for block in blocks for column in (*block.columns, *block.numbers)]
    first = {column.quantity: column for column in every}
    return [f"{_shown(name)}: {with_unit(column.meaning, column.units)}" for name, column in first.items() if column.meaning]


def _shown(quantity):
    return quantity.replace("_", " ")


def _flagged(block):
    every = [column.reliable for column in (*block.columns, *block.numbers) if column.reliable is not None]
    return any(not numpy.all(flags) for flags in every)


def _columns(block, width):
    """The rows of a block, as many columns abreast as there is room for."""
    if not block.columns:
        return []
    labels = [column.label for column in block.columns]
    lines = []
    if max(map(len, labels)) > LONGEST_LABEL:
        lines = [f"  {letters(k)}: {label}" for k, label in enumerate(labels)]
        labels = [letters(k) for k in range(len(labels))]
    cells = [[label, *_cells(column)] for label, column in zip(labels, block.columns)]
    places = [block.place, *(f"{_positive(each):.2f}" if not block.environments else f"{each:g}" for each in block.places)]
    # The quantity that rows are by stands at the left of each part.
    place = _justified(places, PLACE)
    columns = [_justified(each, 0) for each in cells]
    for part in _abreast(columns, width - len(place[0])):
        lines += ["".join(row).rstrip() for row in zip(place, *part)]
    return lines


def _positive(place):
    """Not "-0.00"."""
    return 0.0 if abs(place) < 0.005 else place


def _justified(texts, least):
    width = max(least, 2 + max(map(len, texts)))
    return [text.rjust(width) for text in texts]


def _abreast(columns, room):
    """Parts of the columns, each of which fits."""
    parts, left = [], 0
    for column in columns:
        if not parts or len(column[0]) > left:
            parts.append([])
            left = room
        parts[-1].append(column)
        left -= len(column[0])
    return parts


def _cells(column):
    """The numbers of a column, alike in form, with room for a flag behind each. Its heading has that room, too."""
    values = numpy.atleast_1d(column.values).astype(float)
    errors = [None] * len(values) if column.errors is None else numpy.atleast_1d(column.errors)
    flags = numpy.ones(len(values), bool) if column.reliable is None else numpy.atleast_1d(column.reliable)
    decimals = decimals_of(list(numpy.abs(values[numpy.isfinite(values) & (values != 0)])))
    return [with_error(value, error, decimals) + (" " if flag else "*") for value, error, flag in zip(values, errors, flags)]


def _numbers(block):
    """The numbers of no row, a line each."""
    names = [_line_name(column) for column in block.numbers]
    width = max(map(len, names), default=0)
    return [f"  {name:<{width}}  {_alone(column)}" for name, column in zip(names, block.numbers)]


def _alone(column):
    """A number of no row; of what is exact five digits."""
    return f"{float(column.values):.5g}" if column.errors is None else _cells(column)[0].rstrip()


def _line_name(column):
    where = [each for each in (column.channel, column.environment) if each]
    return ", ".join([_shown(column.quantity), *where])


def rows(analysis):
    """All numbers, one after another, as dicts with the keys FIELDS."""
    return [row for block in analysis.blocks for row in _rows_of(block)]


def _rows_of(block):
    for column in block.columns:
        for k, place in enumerate(block.places):
            of = {"environment": block.environments[k]} if block.environments else {"gate": k}
            yield _row(block, column, k, of | {"place": float(place)})
    for column in block.numbers:
        yield _row(block, column, 0, {})


def _row(block, column, k, of):
    def at(values):
        return None if values is None else numpy.atleast_1d(values)[k].item()

    about = {"quantity": column.quantity, "units": column.units, "telescope": block.telescope, "channel": column.channel}
    numbers = {"value": at(column.values), "standard_error": at(column.errors), "reliable": at(column.reliable)}
    return dict.fromkeys(FIELDS) | about | {"environment": column.environment} | of | numbers


def as_csv(analysis, title, command):
    """One row for each number; empty cells where it has no gate, no error or no value."""
    out = io.StringIO()
    out.write(f"# {title}\n# {command}\n# {place_meaning(analysis)}\n")
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow(FIELDS)
    for row in rows(analysis):
        writer.writerow([_csv_cell(row[name]) for name in FIELDS])
    return out.getvalue()


def place_meaning(analysis):
    places = [block.place for block in analysis.blocks if block.place]
    return f"place: {places[0]}" if places else "place: none"


def _csv_cell(value):
    if value is None or (isinstance(value, float) and math.isnan(value)):
        return ""
    return str(value).lower() if isinstance(value, bool) else value


def as_json(analysis, title, command):
    """All numbers; null where one is not known."""
    numbers = [{key: _json_value(value) for key, value in row.items()} for row in rows(analysis)]
    about = {"title": title, "command": command, "place": place_meaning(analysis).removeprefix("place: ")}
    return json.dumps(about | {"numbers": numbers, "notes": analysis.notes}, indent=2, ensure_ascii=False) + "\n"


def _json_value(value):
    return None if isinstance(value, float) and not math.isfinite(value) else value
