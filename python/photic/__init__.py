"""Photic: what an oceanographic lidar will see.

    import photic
    scene = photic.Scene.new("airborne")
    scene["sea.layer.0.chlorophyll_mg_m3"] = 0.5
    echo = scene.run(target=0.01, max_time="60s")
    echo.echo.sel(telescope="airborne", channel="raman")

Scene is what is simulated; run(scene) computes, open(path) reads a result file; both return an
xarray.Dataset whose telescopes, channels and processes are indexed by their names. What is made of
echoes has errors of its own: error_of(result, function) finds them. Functions of results are
range_corrected, k_lidar, z90, ratio and oil_thickness; linear_fit draws a straight line through
ratios. Of a scene alone optics.of has the optics of its water, and lidar_equation and overlap are
closed forms. `photic plot out.nc -o out.png` draws a result.
"""

from photic import optics
from photic.attenuation import k_lidar
from photic.core import VERSION as __version__
from photic.core import is_there
from photic.errors import Error, Interrupted, Problem, SceneError
from photic.first_order import lidar_equation, overlap
from photic.fits import linear_fit
from photic.jackknife import error_of
from photic.locks import netcdf_lock
from photic.oil import oil_thickness
from photic.penetration import z90
from photic.range_correction import range_corrected
from photic.ratios import ratio
from photic.result import open
from photic.scene import Scene, run
from photic.simulation import Run

__all__ = [
    "Error", "Interrupted", "Problem", "Run", "Scene", "SceneError", "__version__", "error_of", "k_lidar",
    "lidar_equation", "linear_fit", "netcdf_lock", "oil_thickness", "open", "optics", "overlap", "range_corrected",
    "ratio", "run", "z90",
]  # fmt: skip
if is_there():
    from photic._core import Progress

    __all__ += ["Progress"]
