"""Several results in one figure."""

import numpy
import pytest
from matplotlib.collections import PolyCollection

import photic
from drawings import FADED, legends, titles
from photic import plot


def test_several_results_share_a_panel_for_each_channel(sample):
    ds = photic.open(sample)
    drawing = plot.figure([ds, ds.sel(channel=["raman"])], ["one", "_two"], telescopes=["narrow"])
    assert titles(drawing) == [
        *["elastic echo", "one by order"],
        *["raman echo", "one by order", " _two by order"],
        *["chlorophyll echo", "one by order"],
    ]
    open_gates = ["one", FADED]
    assert legends(drawing)[::2] == [open_gates, ["one", " _two"], open_gates]


def right_ends(panel, ds, gate):
    """Where the areas of the orders end at a gate [%]."""
    ends = []
    for area in [each for each in panel.collections if isinstance(each, PolyCollection)][:-1]:
        (path,) = area.get_paths()
        at_gate = numpy.isclose(path.vertices[:, 1], float(ds.gate_depth_bounds[gate, 1]))
        ends.append(path.vertices[at_gate, 0].max())
    return ends


# Seen red: with the orders of the first result for all; with shades that depend on the result.
def test_several_results_are_distinguished_by_order(sample):
    ds = photic.open(sample)
    fewer = ds.isel(order=slice(0, 4)).copy(deep=True)
    fewer.echo_by_order[:] = 0
    fewer.echo_by_order[:, :, 1], fewer.echo_by_order[:, :, 3] = 1e-9, 3e-9
    drawing = plot.figure([ds, fewer], ["one", "two"], telescopes=["narrow"])
    names = [" ".join(title.split()) for title in titles(drawing)[:3]]
    assert names == ["elastic echo", "one by order", "two by order (3 includes all above)"]
    echo, of_one, of_two = drawing.axes[:3]
    one = ds.sel(telescope="narrow", channel="elastic")
    shares = 100 * one.echo_by_order.isel(gate=10).cumsum() / one.echo_by_order.isel(gate=10).sum()
    assert right_ends(of_one, one, 10) == pytest.approx(shares.values, rel=0.02)
    assert right_ends(of_two, one, 10) == pytest.approx([0, 25, 25, 100])
    assert of_one.get_ylim() == of_two.get_ylim() == echo.get_ylim()
    shades = [[tuple(area.get_facecolor()[0]) for area in panel.collections[:3]] for panel in (of_one, of_two)]
    assert shades[0] == shades[1]
    assert legends(drawing)[1] == ["1", "2", "3", "4", "5", "6 and above", FADED]


def test_results_of_one_telescope_each_are_drawn_over_each_other(sample):
    ds = photic.open(sample)
    apart = [ds.isel(telescope=[0]), ds.isel(telescope=[1])]
    drawing = plot.figure(apart, ["one", "two"], channels=["elastic"])
    thins = [drawing.axes[0].get_lines()[i].get_xdata() for i in (1, 4)]
    assert thins[0][0] == float(ds.echo[0, 0, 0]) and thins[1][0] == float(ds.echo[1, 0, 0])
    lines = drawing._supxlabel.get_text().splitlines()
    assert lines[0].endswith("telescope narrow") and lines[1].endswith("telescope wide")
