"""Telescopes that differ in view alone: at one place behind the same lens, with detectors of other
sizes. Their lines share a panel."""

import math

from photic.result import scene_of

STYLES = ["-", "--", ":", "-."]  # of their lines, from the widest view on
OF_VIEW = ("name", "detector_diameter_m", "half_field_of_view_mrad")


def grouped(result, telescopes):
    """Lists of the names of telescopes that differ in view alone, the widest view first; in the order of
    the first of each. The scene of a result says what a telescope is."""
    by_name = {each["name"]: each for each in scene_of(result).get("telescope", [])}
    groups = {}
    for name in telescopes:
        same = {key: value for key, value in by_name[name].items() if key not in OF_VIEW} if name in by_name else name
        groups.setdefault(repr(same), []).append(name)
    width = {name: _width(each) for name, each in by_name.items()}
    return [sorted(group, key=lambda name: -width.get(name, 0)) for group in groups.values()]


def _width(telescope):
    """The width of its view, over that of another one behind the same lens."""
    if "detector_diameter_m" in telescope:
        return telescope["detector_diameter_m"]
    return 2 * telescope["focal_length_m"] * math.tan(1e-3 * telescope["half_field_of_view_mrad"])
