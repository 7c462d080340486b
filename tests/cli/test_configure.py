"""How CMake is configured: the packages and the instruction sets."""

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


def chosen_isas(folder, asked):
    (folder / "choose.cmake").write_text(
        f"cmake_minimum_required(VERSION 3.25)\nset(CMAKE_SYSTEM_PROCESSOR x86_64)\nset(PHOTIC_ISAS {asked})\ninclude({SOURCE}/cmake/isas.cmake)\n"
        'photic_choose_isas(chosen)\nphotic_native_isa(native)\nmessage("${chosen} ${native}")\n')
    return subprocess.run(["cmake", "-P", "choose.cmake"], cwd=folder, capture_output=True, text=True, check=False)


def test_instruction_sets_are_chosen(tmp_path):
    # Seen red: with "native" taken for a set, and without the baseline.
    def sets(asked):
        chosen, native = chosen_isas(tmp_path, asked).stderr.split()
        return chosen.split(";"), native

    every = ["baseline", "avx2", "avx512"]
    assert sets("all")[0] == every
    assert sets("avx512 baseline")[0] == ["baseline", "avx512"]
    assert sets("avx2")[0] == ["baseline", "avx2"]
    chosen, native = sets("baseline native")
    assert native in every and chosen == [isa for isa in every if isa in ("baseline", native)]
    done = chosen_isas(tmp_path, "avx3")
    assert done.returncode == 1
    assert 'no instruction set "avx3" here (choose from all, native, baseline, avx2, avx512)' in " ".join(done.stderr.split())


def test_the_demo_installs_no_package_that_the_tests_alone_need():
    # Without dpkg-query the script lists all names.
    command = ["/bin/bash", SOURCE / "tools/install_packages"]
    said = {kind: subprocess.run([*command, kind], env={"PATH": ""}, capture_output=True, text=True, check=False).stderr
            for kind in ("demo", "test")}
    assert "libnetcdf-dev" in said["demo"] and "random123" not in said["demo"]
    assert "librandom123-dev" in said["test"]
