"""Numbers and headings of columns, as the program's own tables have them."""

import math

MOST_DECIMALS = 4  # of columns whose numbers are about 1
UNITS = {"1": "", "m-1": "1/m", "sr-1": "1/sr"}


def with_error(value, error, decimals):
    """"0.8123±0.0012": two digits of the error, as many as it deserves, and so many decimals at most; for None
    "1.235e-08±2.2e-10". error: None of what is exact. "-" where the value is not known, "?" where its error is not."""
    if not math.isfinite(value):
        return "-"
    if decimals is None:
        return f"{value:.3e}" + ("" if error is None else f"±{error:.1e}" if math.isfinite(error) else "±?")
    if error is None or not math.isfinite(error):
        return f"{value:.{decimals}f}" + ("" if error is None else "±?")
    shown = min(max(1 - math.floor(math.log10(error)), 0), decimals) if error > 0 else decimals
    least = 10.0**-decimals if error > 0 else 0.0
    return f"{value:.{shown}f}±{max(error, least):.{shown}f}"


def decimals_of(sizes):
    """The decimals of a column of numbers of these sizes, above 0, at most; None: with exponents."""
    if sizes and not all(1e-3 <= each < 1e5 for each in sizes):
        return None
    return max(MOST_DECIMALS, MOST_DECIMALS - 1 - math.floor(math.log10(max(sizes, default=1.0))))


def with_unit(words, units):
    """"attenuation [1/m]": of what has a unit."""
    shown = UNITS.get(units, units)
    return f"{words} [{shown}]" if shown else words


def letters(column):
    """A, B, …, Z, AA, …"""
    out, left = "", column + 1
    while left > 0:
        left, digit = divmod(left - 1, 26)
        out = chr(ord("A") + digit) + out
    return out
