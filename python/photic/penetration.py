"""The depth that a lidar sees to."""

from __future__ import annotations

import numpy
import xarray

from photic.errors import Error
from photic.jackknife import described, estimate
from photic.names import chosen
from photic.ratios import expect_environment, of_telescope

BEYOND = 0.1  # of the light that is left out: more behind the last gate, and the depth is a property of the gates


def z90(
    result: xarray.Dataset,
    channel: str,
    share: float = 0.9,
    *,
    telescope: str | None = None,
    environment: str | None = None,
) -> xarray.Dataset:
    """The depth above which a share of a channel's light comes, of all its light from the gates of the water.

    Within a gate light counts as spread evenly over its depths (gate_depth_bounds), of a gate that the surface cuts
    over those in the water.

    result       of a run, as photic.open and photic.run return it, with groups of batches; or a part of it
    channel      the name of the channel
    share        above 0 and below 1
    telescope    a name; by default all
    environment  a name, in the place of the scene itself

    On (telescope):
    z90, z90_standard_error, z90_bias  [m] the depth, by groups of batches (photic.error_of)
    reliable        [bool] whether all gates in the water have converged, and no more than a tenth of the light that the
                    share leaves out (1 % of all, of 90 %) is to be expected behind the last gate: that of an exponential which falls as the light does from the last
                    quarter of the gates' first half to its second

    Raises photic.Error for names that there are not, a share out of range, gates of which none is in the water,
    ranges in place of depths, and a result without groups.
    Source: Barbini et al. 2000 (PREMAR-2F), note 2, with 90 %.
    """
    result = of_telescope(result, telescope)
    chosen([result], ["result"], "channel", [channel])
    if environment is not None:
        expect_environment(result, environment)
    if not 0 < share < 1:
        raise Error(f"share = {share:g}: a share of the light is above 0 and below 1")
    part = result.sel(channel=[channel])
    part = part.isel(gate=numpy.argsort(part.gate_depth.isel(telescope=0, channel=0).values))
    edges = _edges(part)

    def depth(e):
        echo = e.echo if environment is None else e.environment_echo.sel(environment=environment, drop=True)
        light = echo.transpose("telescope", "channel", "gate").values[:, 0]
        return xarray.DataArray(
            [_depth_of(share, one, edge) for one, edge in zip(light, edges)], dims="telescope", coords={"telescope": e.telescope}
        )

    found = estimate(part, depth)
    found.reliable = found.reliable & _ends_within(part, environment, edges, BEYOND * (1 - share))
    name = f"depth above which {100 * share:g} % of the light of {channel} comes"
    return described(found, "z90", long_name=name, units="m")


def _edges(part):
    """[telescope, gate, 2]: the depths of each gate in the water; its edges are the same where it is in the air."""
    depth = part.gate_depth
    if depth.attrs.get("standard_name") != "depth" or bool(part.gate_depth_bounds.isnull().any()):
        raise Error("z90: gates of this result have ranges, or no depths: it takes a lidar that looks down")
    edges = part.gate_depth_bounds.transpose("telescope", "channel", "gate", "bnds").values[:, 0].clip(min=0)
    if not (edges[..., 1] > edges[..., 0]).any(axis=1).all():
        raise Error("z90: no gate of this result is in the water")
    return edges


def _depth_of(share, light, edges):
    """The depth where the sum of the light passes the share, linear between the edges of gates."""
    light = numpy.where(edges[:, 1] > edges[:, 0], light, 0.0)
    total = light.sum()
    if not total > 0:
        return numpy.nan
    sums = numpy.cumsum(light)
    gate = int(numpy.argmax(sums >= share * total))
    within = (share * total - (sums[gate] - light[gate])) / light[gate]
    return edges[gate, 0] + within * (edges[gate, 1] - edges[gate, 0])


def _ends_within(part, environment, edges, tolerated):
    """Returns whether so little light is to be expected behind the last gate."""
    echo = part.echo if environment is None else part.environment_echo.sel(environment=environment)
    out = []
    for light, edge in zip(echo.transpose("telescope", "channel", "gate").values[:, 0], edges):
        light = light[edge[:, 1] > edge[:, 0]]
        half = max(1, len(light) // 8)
        late, later = light[-2 * half : -half].sum(), light[-half:].sum()
        falls = later / late if late > 0 else numpy.inf if later > 0 else 0.0
        behind = later * falls / (1 - falls) if falls < 1 else numpy.inf
        out.append(behind <= tolerated * light.sum())
    return xarray.DataArray(out, dims="telescope", coords={"telescope": part.telescope})
