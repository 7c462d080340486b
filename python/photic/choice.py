"""Which telescopes and channels a figure shows, and on which axis."""

import difflib
from dataclasses import dataclass

from photic.errors import Error
from photic.page import spread
from photic.panels import axis_of

MOST_TELESCOPES = 4  # in a figure
MOST_LISTED = 12  # names in a message


def chosen(results, names, axis, wanted):
    """Names along the axis that any of the results has: those wanted, or all if none are told.

    Raises photic.Error for a name that no result has, and for a result that has none of them.
    """
    known = list(dict.fromkeys(str(name) for result in results for name in result[axis].values))
    where = names[0] if len(names) == 1 else "results"
    for name in wanted:
        if name not in known:
            raise Error(f"{where}: there is no {axis} {name!r}{_suggestion(name, known)}")
    if not wanted:
        return known
    for result, name in zip(results, names):
        if not set(wanted) & set(result[axis].values):
            there = listed([str(each) for each in result[axis].values])
            raise Error(f"{name}: has no {axis} of those asked for; there are: {there}")
    return list(dict.fromkeys(wanted))


def _suggestion(name, known):
    near = difflib.get_close_matches(name, known, n=1)
    return f" (did you mean {near[0]!r}?)" if near else f"; there are: {listed(known)}"


def listed(known):
    """Names, as far as they have room in a line."""
    more = len(known) - MOST_LISTED
    return ", ".join(known[:MOST_LISTED]) + (f" and {more} more" if more > 0 else "")


@dataclass(frozen=True)
class Drawn:
    """What a figure shows of its results: telescopes and channels by name. The telescope None stands
    for the only one of each result, whatever its name is."""

    telescopes: list
    channels: list

    def title(self, telescope, words):
        """Of a panel: with the telescope's name where there are several."""
        return f"{telescope}: {words}" if len(self.telescopes) > 1 else words


def drawn(results, names, telescopes, channels, notes):
    """What is drawn of what is wanted (nothing: all); to the notes: what has no place.

    Raises photic.Error as chosen does.
    """
    seen = chosen(results, names, "telescope", telescopes)
    alone = all(result.sizes["telescope"] == 1 for result in results)
    if alone and not telescopes and len(seen) > 1:
        seen = [None]
    seen = kept(seen, MOST_TELESCOPES, "telescope", notes)
    return Drawn(seen, chosen(results, names, "channel", channels))


def kept(every, most, axis, notes, what="Drawn are"):
    """So many of the names, from the first to the last, with a note of the rest."""
    some = [every[k] for k in spread(len(every), most)]
    if len(some) < len(every):
        notes.append(f"{what} {len(some)} of {len(every)} {axis}s: {_choose(axis)}.")
    return some


def _choose(axis):
    return f"--{axis} NAME, which may be repeated, chooses others"


def through(results, telescope, channels):
    """For each result what of the channels its telescope sees, None if it has no such telescope or
    channel. All are on one axis: of depths or ranges if all gates have them, else of times."""
    seen = [_view(result, telescope, channels) for result in results]
    there = [one for one in seen if one is not None]
    unknown = any(bool(one.gate_depth.isnull().any()) for one in there)
    if unknown or len({axis_of(one) for one in there}) > 1:
        seen = [one if one is None else _by_time(one) for one in seen]
    return seen


def _view(result, telescope, channels):
    if telescope is not None and telescope not in result.telescope.values:
        return None
    one = result.isel(telescope=0) if telescope is None else result.sel(telescope=telescope)
    there = [channel for channel in channels if channel in one.channel.values]
    return one.sel(channel=there) if there else None


def _by_time(result):
    """The gates placed by their time."""
    for name in ("gate_depth", "gate_depth_bounds"):
        times = result[name.replace("depth", "time")].broadcast_like(result[name])
        times = times.transpose(*result[name].dims)
        result = result.assign_coords({name: (times.dims, times.values, {"units": "ns"})})
    return result
