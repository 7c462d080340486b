"""What CMake needs where: Random123 for the tests alone."""

import subprocess

import pytest
from conftest import SOURCE

# Headers in /usr/include are not looked for; those that the program needs are named.
WITHOUT_RANDOM123 = [
    "-DCMAKE_IGNORE_PATH=/usr/include",
    *(f"-D{name}_INCLUDE=/usr/include" for name in ("BOOST", "CLI11", "TOMLPLUSPLUS")),
]


@pytest.mark.parametrize("tests, code", [("OFF", 0), ("ON", 1)])
def test_only_the_tests_need_random123(tmp_path, tests, code):
    # Seen red: with Random123 looked for in any case.
    done = subprocess.run(
        ["cmake", "-S", SOURCE, "-B", tmp_path, "-G", "Ninja", f"-DPHOTIC_TESTS={tests}", *WITHOUT_RANDOM123],
        stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=120, check=False,
    )
    assert done.returncode == code, done.stderr
    assert ("RANDOM123_INCLUDE" in done.stderr) == (tests == "ON")


def test_the_demo_installs_no_package_that_the_tests_alone_need():
    # Without dpkg-query the script tells all names.
    command = ["/bin/bash", SOURCE / "tools/install_packages"]
    told = {kind: subprocess.run([*command, kind], env={"PATH": ""}, capture_output=True, text=True, check=False).stderr
            for kind in ("demo", "test")}
    assert "libnetcdf-dev" in told["demo"] and "random123" not in told["demo"]
    assert "librandom123-dev" in told["test"]
