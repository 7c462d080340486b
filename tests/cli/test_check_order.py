"""tools/check_include_order.py holds on this tree, and sees what it is there to see."""

import subprocess
import sys

import pytest
from conftest import SOURCE


def check(root):
    return subprocess.run(
        [sys.executable, SOURCE / "tools/check_include_order.py", root], capture_output=True, text=True, check=False
    )


def test_the_house_keeps_its_floors():
    done = check(SOURCE)
    assert done.returncode == 0, done.stdout


PLANTED = {
    ("src/optics/x.hpp", '#include "scene/scene.hpp"'): "optics must not include scene, which stands above it",
    ("src/core/x.cpp", '  #  include "io/csv.hpp"'): "core must not include io, which stands above it",
    ("src/io/x.cpp", '#include "csv.hpp"'): '"csv.hpp" must be named from src/, as "io/..."',
    ("src/io/x.cpp", '#include "photic/output.hpp"'): '"photic/output.hpp" must be named from src/, as "io/..."',
    ("src/io/x.cpp", "#include <toml++/toml.h>"): "<toml++/toml.h> belongs to scene alone",
    ("src/tally/x.cpp", "#include <nlohmann/json.hpp>"): "<nlohmann/json.hpp> belongs to scene and io and apps alone",
    ("apps/photic/x.cpp", "#include <netcdf.h>"): "<netcdf.h> belongs to io alone",
    ("src/estimator/analog/x.hpp", '#include "estimator/forward/history.hpp"'): "analog must not include estimator/forward",
    ("src/estimator/x.hpp", '#include "estimator/analog/analog.hpp"'):
        "what all estimators stand on must not include estimator/analog",
    ("src/estimator/tallies/x.hpp", '#include "estimator/forward/history.hpp"'):
        "what all estimators stand on must not include estimator/forward",
    ("apps/photic/x.cpp", '#include "output.hpp"'): '"output.hpp" is in no floor of src/',
    ("src/run/x.cpp", '  std::fprintf(stderr, "x");'): "prints: that is for applications",
    ("src/run/x.cpp", "  std::cout << 1;"): "prints: that is for applications",
    ("src/run/x.cpp", "  std::exit(2);"): "ends the process: that is for applications",
    ("src/run/x.cpp", '  const char* folder = std::getenv("PHOTIC_DATA");'): "reads the environment: that is for applications",
    ("src/run/x.cpp", "  static int calls = 0;"): "has a variable that all runs would share: that is for applications",
    ("src/run/x.cpp", "thread_local int calls;"): "has a variable that all runs would share: that is for applications",
}


@pytest.mark.parametrize("planted", PLANTED, ids=lambda p: f"{p[0]} {p[1]}")
def test_a_planted_violation_is_found(tmp_path, planted):
    file, line = planted
    path = tmp_path / file
    path.parent.mkdir(parents=True)
    path.write_text(f'#include <vector>\n#include "core/error.hpp"\n{line}\n')
    done = check(tmp_path)
    assert done.stdout == f"{file}:3: {PLANTED[planted]}\n"
    assert done.returncode == 1


def test_a_folder_that_is_no_floor(tmp_path):
    (tmp_path / "src/attic").mkdir(parents=True)
    (tmp_path / "src/attic/x.hpp").write_text("")
    done = check(tmp_path)
    assert done.stdout == "src/attic/x.hpp:1: src/attic is no floor of the house\n"
    assert done.returncode == 1


def test_an_empty_tree_is_no_success(tmp_path):
    done = check(tmp_path)
    assert done.returncode == 1
    assert "no C++ files" in done.stdout


def test_what_leaves_the_process_alone_may_stay(tmp_path):
    (tmp_path / "src/run").mkdir(parents=True)
    (tmp_path / "src/run/x.hpp").write_text(
        "  static const int all = 3;\n  static constexpr int all = 3;\n  static double mean(const std::vector<double>& x);\n"
        "  std::snprintf(text, 3, form);  // not printf()\n"
    )
    assert check(tmp_path).returncode == 0
