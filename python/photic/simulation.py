"""Runs: their flags, their progress, their end."""

from __future__ import annotations

import atexit
import numbers
import os
import shutil
import sys
import threading
import warnings
import weakref
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any, Union

import numpy
import xarray

from photic.core import PACKAGE, PROCESS, context, core, refuse_in_fork
from photic.errors import Error, Interrupted
from photic.names import file_name, suggestion
from photic.result import of_arrays

if TYPE_CHECKING:
    from photic import _core as compiled

BETWEEN_LOOKS_MS = 100
STOPPED = 130  # the program's exit code
ENGINES = ["lanes", "scalar"]
MAX_THREADS = 4096

_TRUTHS = (bool, numpy.bool_)

Number = Union[int, float, str]
File = Union[str, "os.PathLike[str]"]
Watcher = Union[bool, Callable[["compiled.Progress"], object]]


def changes_of(photons: Number | None, target: Number | None, max_time: Number | None, seed: Number | None) -> dict[str, Any]:
    """The flags that are values of the scene, by their paths."""
    flags = {
        "photons": (photons, "simulation.photons", int),
        "target": (target, "simulation.target_relative_error", float),
        "max_time": (max_time, "simulation.max_time_s", float),
        "seed": (seed, "simulation.seed", int),
    }
    return {path: kind(_quantity(name, value)) for name, (value, path, kind) in flags.items() if value is not None}


def _quantity(name: str, value: Any) -> str:
    """The number that the program reads in a flag's text; a time without a unit is in seconds."""
    if isinstance(value, (bool, numpy.timedelta64)) or not isinstance(value, (str, numbers.Real)):
        raise Error(f"{name}: {value!r} is no number")
    readers = {"photons": "photons_value", "target": "share_value", "seed": "seed_value"}
    is_time = name not in readers
    text = f"{value}s" if is_time and not isinstance(value, str) else text_of(name, value)
    try:
        return str(getattr(core(), readers.get(name, "seconds_value"))(text))
    except ValueError as error:
        raise Error(f"{name}: {error}") from None


def text_of(name: str, value: Any) -> str:
    """A keyword's value as text that the library takes. Raises photic.Error."""
    text = str(value)
    if "\0" in text:
        raise Error(f"{name}: {value!r} has a null byte")
    if any("\ud800" <= c <= "\udfff" for c in text):
        raise Error(f"{name}: {value!r} has a character that UTF-8 does not have")
    return text


def refuse_unknown(unknown: dict[str, Any], known: list[str]) -> None:
    """Raises photic.Error for a keyword that there is none of."""
    for name in unknown:
        raise Error(f"there is no keyword {name!r}{suggestion(name, known)}")


def start(
    document: compiled.Document,
    scene_file: str | None,
    *,
    threads: int | None,
    engine: str | None,
    isa: str | None,
    output: File | None,
    continue_from: File | None,
    force: bool,
    checkpoint: Number | None,
    command: str,
) -> Run:
    """Begins a run. Raises photic.Error where it cannot."""
    refuse_in_fork("run scenes")
    is_number = isinstance(threads, numbers.Integral) and not isinstance(threads, bool)
    if threads is not None and not (is_number and 1 <= threads <= MAX_THREADS):
        raise Error(f"threads: {threads!r} is not a whole number from 1 to {MAX_THREADS}")
    if not isinstance(force, _TRUTHS):
        raise Error(f"force: {force!r} is neither True nor False")
    if engine is not None and engine not in ENGINES:
        raise Error(f"engine: there is no {engine!r}{suggestion(str(engine), ENGINES)}")
    try:
        work = core().Run(
            context(),
            document,
            threads=int(threads or 0),
            engine=engine or "",
            isa="" if isa is None else text_of("isa", isa),
            earlier=b"" if continue_from is None else _earlier(continue_from),
            command=command,
            output=_output(output, scene_file, force, checkpoint),
        )
    except ValueError as error:
        raise Error(f"isa: {error}") from None
    return Run(work)


def _earlier(path: File) -> bytes:
    """The name of a result that the library opens. Raises photic.Error."""
    name = file_name("continue_from", path)
    core().expect_netcdf(name, True)
    return name


def _output(output: File | None, scene_file: str | None, force: bool, checkpoint: Number | None) -> Any:
    if output is None:
        if force or checkpoint is not None:
            flag = "force" if force else "checkpoint"
            raise Error(f"{flag}: the run has no output (write output='my.nc')")
        return None
    every = None if checkpoint is None else float(_quantity("checkpoint", checkpoint))
    path = file_name("output", output)
    if (os.path.isdir(path) or path.endswith(b"/")) and scene_file is None:
        name = os.fsdecode(path)
        raise Error(f"{name}: a folder, and the scene has no file that the result could be named after")
    return core().Output(path, os.fsencode(scene_file or ""), bool(force), every)


def warn(line: str) -> None:
    """A Python warning at the first line outside this package."""
    level, frame = 1, sys._getframe()
    while frame.f_back is not None and Path(frame.f_code.co_filename).parent == PACKAGE:
        level, frame = level + 1, frame.f_back
    warnings.warn(line, stacklevel=level)


class _Silent:
    """Watches a run without a word."""

    def show(self, progress: compiled.Progress) -> object:
        return None

    def wipe(self) -> None:
        pass


class _Line(_Silent):
    """The progress as a line on standard error, drawn again and again."""

    def __init__(self) -> None:
        self._length = 0

    def show(self, progress: compiled.Progress) -> object:
        # A last column left free keeps terminals from wrapping.
        text = progress.line(shutil.get_terminal_size().columns - 1)
        self._draw("\r" + text.ljust(self._length))
        self._length = len(text)
        return None

    def wipe(self) -> None:
        if self._length > 0:
            self._draw("\r" + " " * self._length + "\r")
        self._length = 0

    def _draw(self, text: str) -> None:
        sys.stderr.write(text)
        sys.stderr.flush()


class _Called(_Silent):
    """The progress handed to a function."""

    def __init__(self, function: Callable[[compiled.Progress], object]) -> None:
        self._function = function

    def show(self, progress: compiled.Progress) -> object:
        return self._function(progress)


def watcher_of(progress: Watcher | None) -> _Silent:
    """What `progress` of a run asks for. Raises photic.Error."""
    if progress is None or progress is False:
        return _Silent()
    if progress is True:
        return _Line()
    if callable(progress):
        return _Called(progress)
    raise Error(f"progress: {progress!r} is neither True nor False nor a function of a photic.Progress")


class Run:
    """A run at work on threads of its own; photic.Scene.start makes it.

        with scene.start(target=0.01) as run:
            while run.progress.gates_converged < 10: ...
            echo = run.so_far()
        run.stop(); echo = run.result()

    Its functions may be called from any thread. The end of `with` stops it, and so does the end of
    Python, or of the last name for it: then it ends within a fraction of a second. result() writes the
    `output`: of a run that has ended and is not asked for it, only checkpoints are left. Others may write
    there until then; the result goes beside what another run is writing, with a warning. A process that
    was forked has no part in it.
    """

    def __init__(self, work: compiled.Run) -> None:
        self._work: compiled.Run | None = work
        self._last: compiled.Progress = work.progress()
        self._result: xarray.Dataset | None = None
        self._path = ""
        self._failure: BaseException | None = None
        self._watched = False  # a thread waits for its end
        self._lock = threading.Lock()
        _at_work.add(self)
        if _python_ends:  # and a daemon thread does not know
            self.end()
        self._warn(work, _Silent())

    def __enter__(self) -> Run:
        return self

    def __exit__(self, *_: object) -> None:
        if os.getpid() == PROCESS:  # the run goes on in the process that a fork comes from
            self.end()

    @property
    def progress(self) -> compiled.Progress:
        """How far the run is, a photic.Progress: as of the last batch end, and at no cost."""
        work = self._work
        return self._last if work is None or os.getpid() != PROCESS else work.progress()

    def so_far(self) -> xarray.Dataset | None:
        """The result so far, as photic.open gives results, with the attribute partial = 1. None before
        the first batch has ended, and once the run has. Waits for the end of a batch at most."""
        refuse_in_fork("have a result of a run")
        work = self._work
        arrays = None if work is None else work.so_far()
        return None if arrays is None else of_arrays(arrays)

    def stop(self) -> None:
        """Asks the run to end at once, with what there is; result() has that."""
        work = self._work
        if work is not None and os.getpid() == PROCESS:
            work.stop()

    def result(self) -> xarray.Dataset:
        """Waits for the end of the run, and returns its result, as photic.open gives results; the same
        at every call. That of a run that was stopped has the attribute partial = 1.

        Raises photic.Error for a run that was stopped before there was anything (exit_code 130), and
        where the result cannot be written (it is in `partial` of the exception then). Ctrl-C stops
        the run and raises photic.Interrupted, with the result so far in `partial`.
        """
        return self.watched(_Silent())

    def watched(self, watcher: _Silent) -> xarray.Dataset:
        """The result, with the progress shown meanwhile."""
        if self._work is not None:
            refuse_in_fork("have the result of a run")
        self._watched = True
        try:
            try:
                self._wait(watcher)
            finally:
                watcher.wipe()
            return self._take()
        except KeyboardInterrupt:
            raise self._interrupted() from None
        except BaseException:
            self.end()
            raise

    def end(self) -> None:
        """Stops the run, and waits for its end."""
        if self._work is not None:
            refuse_in_fork("end a run")
        with self._lock:
            if self._work is not None:
                self._work.end()

    def _wait(self, watcher: _Silent) -> None:
        work = self._work
        while work is not None:
            ended = work.wait(BETWEEN_LOOKS_MS)
            self._warn(work, watcher)
            seen = watcher.show(work.progress())
            if isinstance(seen, _TRUTHS) and not seen:
                work.stop()
                watcher = _Silent()
            if ended:
                return

    def _warn(self, work: compiled.Run, watcher: _Silent) -> None:
        for line in work.lines():
            watcher.wipe()
            warn(line)

    def _take(self) -> xarray.Dataset:
        """The result of a run that has ended. Raises what it ended with."""
        first = self._keep()
        if self._failure is not None:
            raise self._failure
        assert self._result is not None
        if first:
            for line in str(self._result.attrs["warnings"]).splitlines():
                warn(line)
        return self._result

    def _keep(self) -> bool:
        """Keeps the result or the failure, and nothing else of the run. Returns whether that is new.
        Where Ctrl-C breaks it off, it can be called again."""
        with self._lock:
            work = self._work
            if work is None:
                return False
            try:
                end = work.finish()
                if end is None:
                    message = "stopped before the end of the first batch: there is no result yet"
                    self._failure = Error(message, exit_code=STOPPED)
                else:
                    arrays, self._path, problem = end
                    self._result = of_arrays(arrays)
                    if problem:
                        self._failure = Error(problem, exit_code=1, partial=self._result)
            except Exception as error:
                self._failure = error
            self._last = work.progress()
            self._work = None
        self._warn(work, _Silent())
        return True

    def _interrupted(self) -> Interrupted:
        """Ends the run. A second Ctrl-C does not wait for that."""
        self.stop()
        self._wait(_Silent())
        self._keep()
        if self._failure is not None and self._result is None:
            return Interrupted(f"interrupted: {self._failure}", None)
        partial = self._result
        assert partial is not None
        ended = "was ended" if partial.attrs["partial"] else "had ended"
        message = f"the run {ended} after {int(partial.attrs['photons'])} photons; "
        message += f"the result{' so far' if partial.attrs['partial'] else ''} is in `partial` of this exception"
        return Interrupted(message + (f" and in {self._path}" if self._path else ""), partial)


_at_work: weakref.WeakSet[Run] = weakref.WeakSet()


_python_ends = False


@atexit.register
def _end_all() -> None:
    global _python_ends
    if os.getpid() != PROCESS:
        return  # a fork has none of the threads
    _python_ends = True
    runs = list(_at_work)
    for run in runs:
        run.stop()
    for run in runs:
        run.end()
        if not run._watched:
            run._work = None  # so that no lock of an output is left
