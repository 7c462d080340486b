"""Photic: what an oceanographic lidar will see.

    import photic
    scene = photic.Scene.new("airborne")
    scene["sea.layer.0.chlorophyll_mg_m3"] = 0.5
    echo = scene.run(target=0.01, max_time="60s")
    echo.echo.sel(telescope="airborne", channel="raman")

Scene is what is simulated; run(scene) computes, open(path) reads a result file; both return an
xarray.Dataset whose telescopes, channels and processes are indexed by their names. oil_thickness
finds the thickness of a film of oil. optics.of(scene) has the optics of its water, lidar_equation(scene)
and overlap(scene) are closed forms, range_corrected(result) is the echo without its fall with distance.
`photic plot out.nc -o out.png` draws a result.
"""

from photic import optics
from photic.core import VERSION as __version__
from photic.core import is_there
from photic.errors import Error, Interrupted, Problem, SceneError
from photic.first_order import lidar_equation, overlap
from photic.locks import netcdf_lock
from photic.oil import oil_thickness
from photic.range_correction import range_corrected
from photic.result import open
from photic.scene import Scene, run
from photic.simulation import Run

__all__ = [
    "Error", "Interrupted", "Problem", "Run", "Scene", "SceneError", "__version__", "lidar_equation", "netcdf_lock",
    "oil_thickness", "open", "optics", "overlap", "range_corrected", "run",
]  # fmt: skip
if is_there():
    from photic._core import Progress

    __all__ += ["Progress"]
