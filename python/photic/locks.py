"""Threads and files: netCDF and HDF5 bear one thread at a time."""

from __future__ import annotations

import os
import threading
from typing import Any

from xarray.backends.netCDF4_ import NETCDF4_PYTHON_LOCK

from photic.core import core, is_there
from photic.errors import Error


class _OfThread(threading.local):
    def __init__(self) -> None:
        self.held: list[Any] = []


class NetcdfLock:
    """Keeps netCDF files to one thread: `with photic.netcdf_lock:`.

    Two threads that use netCDF at once crash, in whatever files they are. The package's own calls,
    photic.open and runs with an output, keep out of each other's way. Where other code uses netCDF
    (xarray.open_dataset, to_netcdf, netCDF4.Dataset) in one thread while another runs with an output,
    opens results or reads scenes that name netCDF files, put that code into the lock; data that
    xarray reads late are to be loaded in it. A thread may take it several times. Simulation does not
    need it. It also has HDF5 print nothing in this thread about files that are good.
    """

    def __init__(self) -> None:
        self._of_thread = _OfThread()
        self._without_core = threading.RLock()
        self._is_lost = False

    def renew(self) -> None:
        """Makes it free in a process that has just been forked, or has it refuse where another thread
        may have left netCDF amid its work."""
        was_free = core().renew_netcdf_lock() if is_there() else True
        if xarrays_is_free := NETCDF4_PYTHON_LOCK.acquire(blocking=False):
            NETCDF4_PYTHON_LOCK.release()
        self._is_lost = not (was_free and xarrays_is_free) and not self._of_thread.held
        self._of_thread.held.clear()

    def __enter__(self) -> None:
        if self._is_lost:
            raise Error(
                "this process was forked while another thread used netCDF, which cannot go on here: start it "
                'by "spawn", as with multiprocessing.get_context("spawn")'
            )
        if not is_there():
            self._without_core.acquire()
            return
        self._of_thread.held.append(core().NetcdfLock())

    def __exit__(self, *_: object) -> None:
        if not is_there():
            self._without_core.release()
            return
        if self._of_thread.held:  # none where it was entered before a fork
            self._of_thread.held.pop().release()


netcdf_lock = NetcdfLock()
os.register_at_fork(after_in_child=netcdf_lock.renew)
