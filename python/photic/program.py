"""Running the program `photic`."""

import contextlib
import json
import numbers
import os
import re
import shutil
import signal
import subprocess
import tempfile
import warnings
from pathlib import Path

from photic.errors import Error, Interrupted
from photic.result import open as open_result


INTERRUPTED, TERMINATED = 128 + signal.SIGINT, 128 + signal.SIGTERM  # the result is partial
PATIENCE_S = 10  # for the program to end a batch, after a signal


def run(
    scene,
    set=None,
    photons=None,
    threads=None,
    output=None,
    program=None,
    continue_from=None,
    force=False,
):
    """Simulates a scene file and returns the result as photic.open does.

    set      values that replace the scene's, e.g. {"sea.layer.0.chlorophyll_mg_m3": 0.5}; a number
             in the path counts from 0; the name of a layer, telescope or channel also works
    photons  how many to emit; threads: how many to use (default: all cores)
    output   where to keep the result file (.nc); not kept by default
    continue_from  a result of the same scene to continue; photons are the total then
    force    replaces whatever is at `output`; otherwise the run is refused where that took longer or
             is of another scene, or leaves it with this result beside it, and warns
    program  the program to run; otherwise $PHOTIC_PROGRAM, the one this package was installed or
             built with, or the one in PATH

    Warnings of the run are issued as Python warnings. Raises photic.Error with the program's
    message. Ctrl-C raises photic.Interrupted, a KeyboardInterrupt: the photons so far are in its
    `partial`, as photic.open gives them, and in `output`. A program that SIGTERM ended raises
    photic.Error with `partial`.
    """
    with tempfile.TemporaryDirectory(prefix="photic-") as folder:
        result = os.fspath(output) if output is not None else os.path.join(folder, "out.nc")
        if not result.lower().endswith(".nc"):
            raise Error(f"{result}: the output is a netCDF file; give it a name that ends in .nc")
        command = [find_program(program), "run", os.fspath(scene), "-o", result]
        for path, value in (set or {}).items():
            command += ["--set", f"{path}={toml_value(value)}"]
        if photons is not None:
            command += ["--photons", _count(photons)]
        if threads is not None:
            command += ["--threads", str(threads)]
        if continue_from is not None:
            command += ["--continue", os.fspath(continue_from)]
        if force:
            command.append("--force")
        code, remarks, output_text = _call(command)
        path = _result_of(output_text) or result
        dataset = open_result(path)
    if code != 0:
        _raise_ended(code, dataset, path if output is not None else None)
    for warning in remarks + dataset.attrs["warnings"].splitlines():
        warnings.warn(warning, stacklevel=2)
    return dataset


def _call(command):
    """Runs a program that writes a result; returns its exit code, its remarks, and its output."""
    pipes = {"stdin": subprocess.DEVNULL, "stdout": subprocess.PIPE, "stderr": subprocess.PIPE}
    try:
        process = subprocess.Popen(command, encoding="utf-8", errors="surrogateescape", **pipes)
    except OSError as error:
        message = f"{command[0]}: cannot run the program: {error.strerror}"
        raise Error(message, exit_code=1) from error
    with process:
        try:
            output_text, errors = process.communicate()
        except KeyboardInterrupt:
            output_text = _finish(process)
            if process.returncode not in (0, INTERRUPTED, TERMINATED):
                raise
            return INTERRUPTED, [], output_text
        except BaseException:
            process.kill()
            raise
    if process.returncode not in (0, INTERRUPTED, TERMINATED):
        message = errors.strip() or f"{command[0]} ended with code {process.returncode}"
        raise Error(message, exit_code=process.returncode)
    return process.returncode, errors.splitlines(), output_text


def _finish(process):
    """Lets an interrupted program write its partial result, and returns what it printed; a second
    Ctrl-C ends it."""
    output_text = ""
    try:
        # A terminal or a notebook has sent the signal to the program as well, and a second one
        # would end it at once: only a program that goes on has not got it.
        with contextlib.suppress(subprocess.TimeoutExpired):
            output_text = process.communicate(timeout=PATIENCE_S)[0]
        if process.poll() is None:
            process.send_signal(signal.SIGINT)
            with contextlib.suppress(subprocess.TimeoutExpired):
                output_text = process.communicate(timeout=PATIENCE_S)[0]
        return output_text
    finally:
        process.kill()  # nothing, if it has ended
        process.wait()


def _result_of(output_text):
    """The place of the result according to the program: beside the output, if more photons were there."""
    places = re.findall(r"^Result(?: \(.*\))?: (.+)$", output_text, re.MULTILINE)
    return places[-1] if places else None


def _raise_ended(code, partial, output):
    message = f"the run was ended after {int(partial.attrs['photons'])} photons; "
    message += "the result so far is in `partial` of this exception"
    if output is not None:
        message += f" and in {os.fspath(output)}"
    if code == INTERRUPTED:
        raise Interrupted(message, partial)
    raise Error(message, exit_code=code, partial=partial)


def _count(number):
    """1e7 as 10000000; what is not a whole number is left for the program to refuse."""
    return str(int(number)) if number == int(number) else str(number)


def find_program(program=None):
    """The path of the program to run: the one requested or an error, never another one."""
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
        raise Error(f"{value!r} is not a value that a scene can hold") from None
