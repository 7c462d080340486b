"""Names that the user gives, looked up among those of results."""

from __future__ import annotations

import difflib
import os

from photic.errors import Error

MOST_LISTED = 12  # names in a message


def file_name(what: str, path: object) -> bytes:
    """The name of a file as the system has it. Raises photic.Error for what is none."""
    try:
        name = os.fsencode(path)  # type: ignore[arg-type]
    except UnicodeEncodeError:
        raise Error(f"{what}: {path!r} has a character that names of files do not have") from None
    except TypeError:
        name = b""
    if not name:
        raise Error(f"{what}: {path!r} is no name of a file")
    if b"\0" in name:
        raise Error(f"{what}: {path!r} has a null byte")
    return name


def chosen(results, names, axis, wanted):
    """Names along the axis that any of the results has: those wanted, or all if none are given.

    Raises photic.Error for a name that no result has, and for a result that has none of them.
    """
    known = list(dict.fromkeys(str(name) for result in results for name in result[axis].values))
    where = names[0] if len(names) == 1 else "results"
    for name in wanted:
        if name not in known:
            raise Error(f"{where}: there is no {axis} {name!r}{suggestion(name, known)}")
    if not wanted:
        return known
    for result, name in zip(results, names):
        if not set(wanted) & set(result[axis].values):
            there = listed([str(each) for each in result[axis].values])
            raise Error(f"{name}: has no {axis} of those requested; there are: {there}")
    return list(dict.fromkeys(wanted))


def suggestion(name, known):
    """The end of a message about an unknown name."""
    near = difflib.get_close_matches(name, known, n=1)
    return f" (did you mean {near[0]!r}?)" if near else f"; there are: {listed(known)}"


def listed(known):
    """As many names as fit on a line."""
    more = len(known) - MOST_LISTED
    return ", ".join(known[:MOST_LISTED]) + (f" and {more} more" if more > 0 else "")
