"""Ratios of the echoes of two channels."""

from __future__ import annotations

from collections.abc import Sequence

import xarray

from photic.errors import Error
from photic.jackknife import described, estimate
from photic.names import chosen


def ratio(
    result: xarray.Dataset,
    of: str = "chlorophyll",
    over: str = "raman",
    *,
    telescope: str | None = None,
    environment: str | Sequence[str] | None = None,
    reference: str | None = None,
) -> xarray.Dataset:
    """The echo of one channel over that of another: by gate, and of sums over gates.

        ratio = E_of / E_over        ratio_of_sums = sum of E_of / sum of E_over

    result       of a run, as photic.open and photic.run return it, with groups of batches; or a part of it: sums
                 are over the gates that it has
    of, over     names of channels. Gates are intervals of time: where the group indices of channels differ, the
                 light of a gate comes from depths that differ by some tenths of a per cent (gate_depth)
    telescope    a name; by default all
    environment  a name, or several, in the place of the scene itself
    reference    an environment: all ratios are divided by those there

    On (environment, telescope, gate), ratio_of_sums on (environment, telescope); without `environment` unless several
    are named. Each has _standard_error, by groups of batches (photic.error_of), _bias, _replicates, and
    reliable or ratio_of_sums_reliable: whether all gates that it is made of have converged. Dimensionless; NaN where
    the lower echo is 0.

    Raises photic.Error for a channel, telescope or environment that there is not, and for a result without groups.
    Sources: Hoge & Swift 1981, Appl. Opt. 20, 3197 [from memory]; Barbini et al. 2000 (PREMAR-2F).
    """
    result = of_telescope(result, telescope)
    for channel in (of, over):
        chosen([result], ["result"], "channel", [channel])
    names = [environment] if isinstance(environment, str) else list(environment or [])
    for name in [*names, *([reference] if reference is not None else [])]:
        expect_environment(result, name)

    def at_gates(e):
        values = _of_waters(e, names, lambda echo: echo.sel(channel=of, drop=True) / _nonzero(echo.sel(channel=over, drop=True)))
        return values if reference is None else values / _nonzero(_ratio_in(e, reference, of, over))

    def of_sums(e):
        return at_gates(e.sum("gate"))

    one = len(names) == 1 and isinstance(environment, str)
    by_gate = described(estimate(result, at_gates), "ratio", long_name=f"echo of {of} over that of {over}", units="1")
    sums = described(estimate(result, of_sums), "ratio_of_sums", long_name=f"sum of the echo of {of} over that of {over}", units="1")
    out = by_gate.merge(sums.rename(reliable="ratio_of_sums_reliable"), compat="override")
    return out.isel(environment=0) if one else out


def _ratio_in(e, environment, of, over):
    echo = e.environment_echo.sel(environment=environment, drop=True)
    return echo.sel(channel=of, drop=True) / _nonzero(echo.sel(channel=over, drop=True))


def _of_waters(e, names, function):
    """A function of the scene's echo, or of those of environments by their names."""
    return function(e.environment_echo.sel(environment=names)) if names else function(e.echo)


def _nonzero(echo):
    return echo.where(echo != 0)


def of_telescope(result: xarray.Dataset, telescope: str | None) -> xarray.Dataset:
    """The part of a result that is of a telescope, or all of it."""
    if telescope is None:
        return result
    chosen([result], ["result"], "telescope", [telescope])
    return result.sel(telescope=[telescope])


def expect_environment(result: xarray.Dataset, name: str) -> None:
    """Raises photic.Error for an environment that the result does not have."""
    if "environment" not in result.dims:
        raise Error(f"result: there is no environment {name!r}, nor any other: add [[environment]] to the scene")
    chosen([result], ["result"], "environment", [name])
