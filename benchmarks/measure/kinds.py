"""A measurement, and a row of its table."""

from collections.abc import Callable
from dataclasses import dataclass


@dataclass(frozen=True)
class Row:
    """One line of a table. `held`: whether what was measured is within what is allowed; None where nothing is bounded."""

    what: str
    measured: str
    allowed: str = ""
    held: bool | None = None

    def stated(self):
        return self.measured + (" (**not held**)" if self.held is False else "")


@dataclass(frozen=True)
class Measurement:
    """`measure(runner)` gives raw numbers that JSON can hold, `rows(raw)` what a page says of them."""

    name: str
    title: str
    claim: str
    how: str
    measure: Callable
    rows: Callable


def within(measured, low, high):
    return low <= measured <= high


def percent(share, digits=1):
    return f"{100 * share:.{digits}f} %"


def number(value):
    """Two digits: 0.036, 4.1, 1.9e+06."""
    return f"{value:.2g}"
