"""Photic: what an oceanographic lidar will see.

    import photic
    ds = photic.run("ship.toml", set={"sea.layer.0.chlorophyll_mg_m3": 0.5}, photons=1e6)
    ds.echo.sel(telescope="ship", channel="raman")

run(scene) computes, open(path) reads a result file; both return an xarray.Dataset whose
telescopes, channels and processes are indexed by their names. oil_thickness(result, clean) finds
the thickness of a film of oil. `photic plot out.nc -o out.png` draws a result.
"""

from photic.errors import Error, Interrupted
from photic.oil import oil_thickness
from photic.program import run
from photic.result import open

__all__ = ["Error", "Interrupted", "oil_thickness", "open", "run"]
