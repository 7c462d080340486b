"""The compiled part of the package, and what all runs of a process share."""

from __future__ import annotations

import os
import threading
from pathlib import Path
from typing import TYPE_CHECKING, Any

from photic.errors import Error

if TYPE_CHECKING:
    from photic import _core as compiled

PACKAGE = Path(__file__).parent
DATA = os.environ.get("PHOTIC_DATA") or str(PACKAGE / "data")
SCENES = PACKAGE / "scenes"
PROCESS = os.getpid()

_problem: ImportError | None = None
try:
    from photic import _core as _compiled
except ImportError as error:
    _problem = error
_lock = threading.Lock()
_context: compiled.Context | None = None


VERSION = _compiled.version if _problem is None else "unknown"


def is_there() -> bool:
    """Returns whether the package can simulate."""
    return _problem is None


def core() -> Any:
    """The module _core. Raises photic.Error where the package was installed without it."""
    if _problem is not None:
        message = (
            f"this package can open and draw results, but not simulate: {_problem} (build Photic where "
            "pybind11-dev and python3-dev are installed, for this Python)"
        )
        raise Error(message, exit_code=1) from _problem
    return _compiled


def refuse_in_fork(what: str) -> None:
    """Raises photic.Error in a process that was forked after it imported this package."""
    if os.getpid() != PROCESS:
        raise Error(
            f"a process that was forked cannot {what}, since it lacks the threads of the one it was forked "
            'from: start it by "spawn", as with multiprocessing.get_context("spawn")'
        )


def context() -> compiled.Context:
    """The data tables, read when first asked for. Raises photic.Error where they are missing."""
    global _context
    with _lock:
        if _context is None:
            made: compiled.Context = core().Context(DATA)
            _context = made
        return _context
