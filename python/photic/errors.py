"""Errors, as reported to the user."""

from __future__ import annotations

from typing import NamedTuple

import xarray


class Error(Exception):
    """A request that cannot be met; the message gives the place, the reason and a remedy.

    exit_code  as of the program: 2 bad input, 1 failed environment (a file, memory), 130 a run that
               was stopped before it had a result
    partial    the result so far, where a run has one that is lost otherwise; else None
    """

    def __init__(self, message: str, exit_code: int = 2, partial: xarray.Dataset | None = None) -> None:
        super().__init__(message)
        self.exit_code = exit_code
        self.partial = partial


class Problem(NamedTuple):
    """One thing wrong with a scene."""

    file: str  # or the path of the value, where it is in no file
    line: int  # from 1; 0 where there are no lines
    column: int  # from 1; 0 where there are no lines
    path: str  # of the value, as "sea.layer.0.chlorophyll_mg_m3"; empty where it has none
    reason: str
    suggestion: str  # may be empty


class SceneError(Error):
    """A scene that cannot be simulated. The text is the program's, a line for each of `problems`,
    in the order of the file."""

    def __init__(self, message: str, problems: list[Problem]) -> None:
        super().__init__(message)
        self.problems = problems

    def __reduce__(self) -> tuple[object, ...]:
        return type(self), (str(self), self.problems), self.__dict__


class Interrupted(KeyboardInterrupt):
    """Ctrl-C during a run.

    partial  the result so far, as photic.open gives it; None if there was none yet
    """

    def __init__(self, message: str, partial: xarray.Dataset | None) -> None:
        super().__init__(message)
        self.partial = partial

    def __reduce__(self) -> tuple[object, ...]:
        return type(self), (str(self), self.partial), self.__dict__
