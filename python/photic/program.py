"""Running the program `photic`."""

import json
import numbers
import os
import shutil
import subprocess
import tempfile
import warnings
from pathlib import Path

from photic.errors import Error
from photic.result import open as open_result


def run(scene, set=None, photons=None, threads=None, output=None, program=None):
    """Simulates a scene file and returns the result as photic.open does.

    set      values that replace the scene's, e.g. {"sea.layer.0.chlorophyll_mg_m3": 0.5}; a number
             in the path counts from 0, a name of a layer, telescope or channel serves too
    photons  how many to emit; threads: how many to use (default: all cores)
    output   where to keep the result file (.nc); not kept by default
    program  the program to run; otherwise $PHOTIC_PROGRAM, the one this package was installed or
             built with, or the one in PATH

    Warnings of the run are issued as Python warnings. Raises photic.Error with the program's
    message.
    """
    with tempfile.TemporaryDirectory(prefix="photic-") as folder:
        result = os.fspath(output) if output is not None else os.path.join(folder, "out.nc")
        if not result.endswith(".nc"):
            raise Error(f"{result}: the output is a netCDF file; give it a name that ends in .nc")
        command = [find_program(program), "run", os.fspath(scene), "-o", result]
        for path, value in (set or {}).items():
            command += ["--set", f"{path}={toml_value(value)}"]
        if photons is not None:
            command += ["--photons", _count(photons)]
        if threads is not None:
            command += ["--threads", str(threads)]
        _call(command)
        dataset = open_result(result)
    for warning in dataset.attrs["warnings"].splitlines():
        warnings.warn(warning, stacklevel=2)
    return dataset


def _call(command):
    try:
        process = subprocess.run(
            command, stdin=subprocess.DEVNULL, capture_output=True, text=True, check=False
        )
    except OSError as error:
        message = f"{command[0]}: cannot run the program: {error.strerror}"
        raise Error(message, exit_code=1) from error
    if process.returncode != 0:
        message = process.stderr.strip() or f"{command[0]} ended with code {process.returncode}"
        raise Error(message, exit_code=process.returncode)


def _count(number):
    """1e7 as 10000000; what is no whole number is left for the program to refuse."""
    return str(int(number)) if number == int(number) else str(number)


def find_program(program=None):
    """The path of the program to run: what was asked for or an error, never another one."""
    asked = program if program is not None else os.environ.get("PHOTIC_PROGRAM")
    if asked is not None:
        found = shutil.which(os.fspath(asked))
        if found is None:
            raise Error(f"{asked}: there is no such program", exit_code=1)
        return found
    package = Path(__file__).resolve().parent
    near = [
        package.parents[3] / "bin" / "photic",  # PREFIX/lib/python3/dist-packages/photic
        package.parents[1] / "build" / "release" / "apps" / "photic" / "photic",  # the source tree
    ]
    for candidate in near:
        if candidate.is_file():
            return str(candidate)
    found = shutil.which("photic")
    if found is None:
        message = "the program photic was not found: build it, or set PHOTIC_PROGRAM to its path"
        raise Error(message, exit_code=1)
    return found


def toml_value(value):
    """A Python value as TOML, for --set: text in quotes, so that "1" stays a text."""
    if isinstance(value, bool) or type(value).__name__ == "bool_":
        return "true" if value else "false"
    if isinstance(value, numbers.Integral):
        return str(int(value))
    if isinstance(value, numbers.Real):
        return repr(float(value))  # also TOML's inf and nan
    if isinstance(value, (str, os.PathLike)):
        return json.dumps(os.fspath(value), ensure_ascii=False).replace("\x7f", "\\u007f")
    if isinstance(value, dict):
        pairs = (f"{toml_value(key)} = {toml_value(item)}" for key, item in value.items())
        return "{" + ", ".join(pairs) + "}"
    try:
        return "[" + ", ".join(toml_value(item) for item in value) + "]"
    except TypeError:
        raise Error(f"{value!r} is nothing that a scene can hold") from None
