"""The coverage of intervals, against their claims."""

import math

KINDS = {  # what a row of a result holds, its error
    "echoes": ("echo", "standard_error"),
    "environment_echoes": ("difference", "difference_standard_error"),
    "sensitivities": ("sensitivity", "sensitivity_standard_error"),
}
TWO_SIDED_95 = 1.96
KNOWN = 0.025  # half of the 5 % that such runs are for


def cells(result, kind):
    """(value, standard error, whether it is flagged converged) by telescope, channel and gate."""
    value, error = KINDS[kind]
    return {
        (row["telescope"], row["channel"], row["gate"]): (row[value], row[error], row["converged"]) for row in result[kind]
    }


def compare(runs, reference):
    """Counts, run by run, of cells against those of a long run, whose own error widens every interval.

    Both are lists of what `cells` gives; cells that have not converged in the long run are left out.
    """
    known = [cell for cell, (_, _, converged) in reference.items() if converged]
    out = {"cells": len(reference), "in_reference": len(known), "converged": [], "covered": [], "wild": [], "beyond": []}
    off = {cell: [] for cell in known}
    flagged = dict.fromkeys(known, 0)
    for run in runs:
        counts = dict.fromkeys(("converged", "covered", "wild", "beyond"), 0)
        for cell in known:
            truth, true_error, _ = reference[cell]
            value, error, converged = run[cell]
            away = abs(value - truth)
            off[cell].append(away / abs(truth) if truth else math.inf)
            flagged[cell] += not converged
            if not converged:
                continue
            both = math.hypot(error, true_error)
            counts["converged"] += 1
            counts["covered"] += away < TWO_SIDED_95 * both
            counts["wild"] += away > 4 * both
            counts["beyond"] += away > 4 * KNOWN * abs(truth)
        for name, count in counts.items():
            out[name].append(count)
    small = [cell for cell in known if math.sqrt(math.fsum(x * x for x in off[cell]) / len(runs)) < KNOWN]
    return out | {"known": len(small) * len(runs), "known_but_flagged": sum(flagged[cell] for cell in small)}


def share(part, whole):
    """The share of all, and its standard error by how it scatters from run to run: cells of a run are no strangers."""
    total = sum(whole)
    if total == 0:
        return math.nan, math.nan
    mean = sum(part) / total
    squares = math.fsum((p - mean * w) ** 2 for p, w in zip(part, whole))
    runs = len(whole)
    return mean, math.sqrt(squares * runs / max(1, runs - 1)) / total
