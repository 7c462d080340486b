"""Calls of the program: checks of scenes, and runs by both estimators."""

import re
import subprocess
import tempfile
import threading
from pathlib import Path

import netCDF4
import numpy as np

from pair_array.scenes import text_of, without

ESTIMATORS = ("forward", "bidirectional")
READING = threading.Lock()  # netCDF files are read by one thread at a time
FORWARD_ALONE = ("simulation.tools", "simulation.reception")


class Failed(Exception):
    """The program failed; the message states how."""


def for_estimator(scene, estimator):
    """The scene without what this estimator does not have."""
    scene = scene if estimator == "forward" else without(scene, *FORWARD_ALONE)
    return scene | {"simulation": scene["simulation"] | {"estimator": estimator}}


class Program:
    """The program at a path, which computes on one thread."""

    def __init__(self, path):
        self.path = path

    def _call(self, *arguments):
        return subprocess.run([self.path, *map(str, arguments)], capture_output=True, text=True, stdin=subprocess.DEVNULL, check=False)

    def problems(self, scene):
        """What `photic check` refuses in a scene by either estimator: lines without their places in the file, none where it is accepted."""
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "scene.toml"
            for estimator in ESTIMATORS:
                path.write_text(text_of(for_estimator(scene, estimator)))
                done = self._call("check", path)
                if done.returncode not in (0, 2):
                    raise Failed(f"photic check: {done.stderr or done.stdout}\n{path.read_text()}")
                if done.returncode == 2:
                    return re.findall(rf"^{re.escape(str(path))}:\d+:\d+: (?!remark)(.*)", done.stderr, re.MULTILINE)
        return []

    def run(self, scene, estimator, photons, seed, sittings=1, engine=()):
        """The result of a run: values, errors and flags by name; in two sittings, one of half of the photons and one that continues it."""
        with tempfile.TemporaryDirectory() as folder:
            path, out = Path(folder) / "scene.toml", Path(folder) / "out.nc"
            path.write_text(text_of(for_estimator(scene, estimator)))
            for sitting in range(1, sittings + 1):
                more = ("--continue", out) if sitting > 1 else ()
                done = self._call("run", path, "-o", out, "--seed", seed, "--photons", photons * sitting // sittings, "--threads", 1,
                                  "--quiet", "--table", "none", "--force", *engine, *more)
                if done.returncode != 0:
                    raise Failed(f"photic run, {estimator}, seed {seed}: {done.stderr}\n{path.read_text()}")
            with READING, netCDF4.Dataset(out) as file:
                file.set_auto_mask(False)
                names = [name for name, variable in file.variables.items() if variable.dtype != str]
                result = {name: np.array(file[name][:]) for name in names}
                return result | {"process_name": list(file["process_name"][:]), "collisions": int(file.collisions)}
