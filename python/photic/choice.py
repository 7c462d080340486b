"""The telescopes and channels that a figure shows, and their axis."""

from dataclasses import dataclass

from photic.names import chosen
from photic.page import spread
from photic.panels import axis_of

MOST_TELESCOPES = 4  # in a figure


@dataclass(frozen=True)
class Drawn:
    """The content of a figure: telescopes and channels by name. The telescope None is
    the only one of each result, whatever its name is."""

    telescopes: list
    channels: list

    def title(self, telescope, words):
        """The title of a panel: with the telescope's name where there are several."""
        return f"{telescope}: {words}" if len(self.telescopes) > 1 else words

    def title_of(self, group, words):
        """The title of a panel that telescopes share: with their names where there are others."""
        if len(group) == 1:
            return self.title(group[0], words)
        return f"{', '.join(group)}: {words}" if len(group) < len(self.telescopes) else words


def drawn(results, names, telescopes, channels, notes):
    """Returns the part of the choice that is drawn (nothing: all); the rest goes to the notes.

    Raises photic.Error as chosen does.
    """
    seen = chosen(results, names, "telescope", telescopes)
    alone = all(result.sizes["telescope"] == 1 for result in results)
    if alone and not telescopes and len(seen) > 1:
        seen = [None]
    seen = kept(seen, MOST_TELESCOPES, "telescope", notes)
    return Drawn(seen, chosen(results, names, "channel", channels))


def kept(every, most, axis, notes, what="Drawn are"):
    """At most this many of the names, from the first to the last, with a note of the rest."""
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
