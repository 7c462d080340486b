"""The types of the Python package, as mypy sees them."""

import os
import subprocess
import sys
from pathlib import Path

import photic

# mypy does not know the class that pybind11 makes classes of, and sees an __init__ in those that have none.
ALLOWED = r"""
photic\._core\.(Context|Document|NetcdfLock|Output|Progress|Run)
photic\._core\.(Document|Progress)\.__init__
"""
TYPED = [
    "photic", "photic.closed_form", "photic.core", "photic.errors", "photic.first_order", "photic.gate_scale", "photic.lens",
    "photic.locks", "photic.optics", "photic.phases", "photic.range_correction", "photic.rays", "photic.scene", "photic.seawater",
    "photic.simulation", "photic.single_scattering",
]  # fmt: skip


def checked(tmp_path, *arguments):
    folder = Path(photic.__file__).parents[1]
    done = subprocess.run(
        [sys.executable, "-m", *arguments], cwd=folder, env=os.environ | {"MYPY_CACHE_DIR": str(tmp_path)},
        capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert done.returncode == 0, done.stdout + done.stderr


# Seen red: with a function without types.
def test_the_package(tmp_path):
    settings = tmp_path / "mypy.ini"
    strict = "disallow_untyped_defs = True\ndisallow_incomplete_defs = True\nwarn_return_any = True\n"
    modules = "".join(f"[mypy-{module}]\n{strict}" for module in TYPED)
    settings.write_text(f"[mypy]\nignore_missing_imports = True\nwarn_unused_ignores = True\n{modules}")
    checked(tmp_path, "mypy", "-p", "photic", "--config-file", settings)


# Seen red: with a function left out of _core.pyi.
def test_the_compiled_module_is_what_its_stub_says(tmp_path):
    allowed = tmp_path / "allowed.txt"
    allowed.write_text(ALLOWED.strip() + "\n")
    checked(tmp_path, "mypy.stubtest", "photic._core", "--allowlist", allowed)
