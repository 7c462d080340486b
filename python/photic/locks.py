"""Threads and files: netCDF and HDF5 bear one thread at a time."""

from __future__ import annotations

import threading
from typing import Any

from photic.core import core, is_there


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

    def __enter__(self) -> None:
        if not is_there():
            self._without_core.acquire()
            return
        self._of_thread.held.append(core().NetcdfLock())

    def __exit__(self, *_: object) -> None:
        if not is_there():
            self._without_core.release()
            return
        self._of_thread.held.pop().release()


netcdf_lock = NetcdfLock()
