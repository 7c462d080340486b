"""What tests of plots read from figures."""

import numpy


def titles(drawing):
    return [panel.get_title(loc="left") for panel in drawing.axes]


def legends(drawing):
    """What is written in the legends of a figure, from above."""
    found = [part.legends for part in drawing.subfigs]
    return [[text.get_text() for text in each.get_texts()] for part in found for each in part]


FADED = "faded: not converged"


def visible(line):
    """The points of a line that are drawn."""
    return int((~numpy.isnan(line.get_xdata().astype(float))).sum())
