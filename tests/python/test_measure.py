"""benchmarks/measure.py: the pages are what it makes of the committed results, and its statistics see what is wrong."""

import json
import os
import random
import re
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "benchmarks"))

from measure import accuracy, coverage, instruments, intervals, pages, program, readme, speed, stamp  # noqa: E402

RESULTS = json.loads((ROOT / "benchmarks/measured.json").read_text())
README = (ROOT / "README.md").read_text()


@pytest.fixture
def measure(tmp_path):
    """measure("run", …) in an empty folder."""

    def call(*arguments, **environment):
        command = [sys.executable, ROOT / "benchmarks/measure.py", *map(str, arguments)]
        return subprocess.run(
            command, cwd=tmp_path, env=os.environ | environment, capture_output=True, text=True, check=False, timeout=250
        )

    return call


def tables(text, name):
    block = re.search(f"<!-- measured: {name} -->\n(.*?)<!-- end -->", text, re.DOTALL).group(1)
    return [[cell.strip() for cell in line.strip("|").split(" | ")] for line in block.splitlines() if line.startswith("|")]


def test_nobody_types_in_the_pages():
    # Seen red: with one digit of each changed.
    for path, text in pages.documents(RESULTS).items():
        assert (ROOT / path).read_text() == text, f"{path} is not what benchmarks/measure.py write makes"
    assert pages.readme(RESULTS, README) == README


def test_the_results_hold_every_measurement():
    # Seen red: with one left out.
    for measurement in pages.ALL:
        assert "raw" in RESULTS["measurements"][measurement.name], measurement.name


def test_the_tables_of_the_readme():
    # Seen red: with a command written out in a cell; with four rows.
    trust, speeds = tables(README, "trust"), tables(README, "speed")
    assert trust[0] == ["claim", "allowed", "measured", "option of `benchmarks/measure.py run`"]
    assert speeds[0] == ["what", "measured"]
    assert len(trust) == len(speeds) == 2 + 5
    cells = [cell for line in trust + speeds for cell in line]
    assert "" not in cells
    assert [cell for cell in cells if len(cell) > 60] == []
    slowest = speed.slowest(RESULTS["measurements"]["time-to-target"]["raw"])[0]
    assert slowest in speeds[4][0]


def test_a_readme_without_a_place_for_a_table():
    with pytest.raises(program.Failed, match="0 places between '<!-- measured: speed -->'"):
        pages.readme(RESULTS, README.replace("<!-- measured: speed -->", ""))


def test_a_reduced_run_is_stated():
    for reduced in (True, False):
        results = RESULTS | {"stamp": RESULTS["stamp"] | {"reduced": reduced}}
        for text in pages.documents(results).values():
            assert ("(reduced run)" in text.splitlines()[0]) == reduced
        assert ("**A reduced run: do not quote.**" in pages.readme(results, README)) == reduced


def test_what_is_missing_failed_or_missed_is_stated():
    # Seen red: with failures left out of the page.
    slabs = RESULTS["measurements"]["slabs"]
    low = slabs | {"raw": slabs["raw"] | {"slab": slabs["raw"]["slab"] | {"escaped": 0.05}}}
    results = RESULTS | {"measurements": {"slabs": low, "ledger": {"failed": "photic run: exit code 1: no disk"}}}
    text = pages.documents(results)["docs/accuracy.md"]
    assert "| 0.0500 (**not held**) |" in text
    assert "**Not measured**: photic run: exit code 1: no disk" in text
    assert text.count("**Not measured.**") == len(accuracy.MEASUREMENTS + intervals.MEASUREMENTS) - 2
    written = pages.readme(results, README)
    assert tables(written, "trust")[6][2].endswith("(**not held**)")
    assert [line[2] for line in tables(written, "trust")[2:6]] == ["not measured"] * 4


def made_up(seeds, cells, shrunk=1.0, flagged=lambda seed, cell: False):
    """Counts of runs whose echoes are normal about 1 with an error of 0.01, and report that error `shrunk`."""
    chance = random.Random(5)
    runs = [
        {("t", "c", k): (chance.gauss(1, 0.01), 0.01 * shrunk, not flagged(seed, k)) for k in range(cells)} for seed in range(seeds)
    ]
    return coverage.compare(runs, {("t", "c", k): (1.0, 1e-6, True) for k in range(cells)})


def test_coverage_is_that_of_normal_numbers():
    # Seen red: with 2.6 for 1.96.
    counts = made_up(60, 50)
    share, error = coverage.share(counts["covered"], counts["converged"])
    assert share == pytest.approx(0.95, abs=0.012)
    assert error == pytest.approx((0.95 * 0.05 / 3000) ** 0.5, rel=0.3)
    assert intervals.covered("made up", counts, intervals.ALLOWED).held
    assert (counts["known"], counts["known_but_flagged"], sum(counts["beyond"])) == (3000, 0, 0)


@pytest.mark.parametrize("shrunk", [0.5, 2.0])
def test_errors_that_are_wrong_are_seen(shrunk):
    counts = made_up(60, 50, shrunk)
    assert not intervals.covered("made up", counts, intervals.ALLOWED).held


def test_a_few_gates_leave_it_open():
    # Seen red: with any number of them judged.
    row = intervals.covered("made up", made_up(3, 20), intervals.ALLOWED)
    assert row.held is None
    assert row.measured.endswith("of 60 (100 % are converged): too few to judge")


def test_blind_and_timid_flags_are_seen():
    wild = made_up(20, 50, 0.3)
    timid = made_up(20, 50, flagged=lambda seed, cell: seed % 2 == 0)
    held = [row.held for row in intervals.rows_flags({"a": {"bidirectional, echoes": wild}, "b": {"forward, echoes": timid}})]
    assert held == [False, True, True, False]
    assert sum(timid["converged"]) == 500


def test_nothing_converged_is_not_held():
    counts = made_up(3, 5, flagged=lambda seed, cell: True)
    row = intervals.covered("made up", counts, intervals.ALLOWED)
    assert (row.measured, row.held) == ("no gate is converged", False)
    assert [row.held for row in accuracy.rows_agreement({"ship": {"z": [], "largest": ""}})] == [False]


def test_estimators_that_disagree_are_seen():
    chance = random.Random(5)
    z = [chance.gauss(0, 1) for _ in range(200)]
    raw = {"a": z, "b": [1.3 * x for x in z], "c": [*z, 5.0]}
    raw = {scene: {"z": of_scene, "largest": "raman of ship, gate 7, seed 2"} for scene, of_scene in raw.items()}
    rows = list(accuracy.rows_agreement(raw))
    assert [row.held for row in rows] == [True, False, False]
    assert "beyond" not in rows[0].measured
    assert rows[2].measured.endswith(
        "; 1 beyond the limit, at the worst (raman of ship, gate 7, seed 2) the forward echo above the bidirectional one"
    )


def test_the_readme_says_in_which_scene_estimators_disagree():
    # Seen red: with the gates of all scenes counted; with no scene named.
    def cell(**z):
        return readme.agreement({scene.replace("_", "-"): {"z": of_scene, "largest": ""} for scene, of_scene in z.items()})[1]

    assert cell(ship=[0.5, -1.0], three_layers=[1.0]) == "up to 1.0 errors in 3 gates"
    assert cell(ship=[0.5, -1.0], three_layers=[-5.0, 1.0]) == "three-layers: 1 of 2 gates off by up to 5.0 (**not held**)"
    assert cell(ship=[0.5, 6.0], rov=[1.0], minimal=[-5.0, 1.0, 1.0]) == "2 scenes: 2 of 5 gates off by up to 6.0 (**not held**)"
    assert cell(ship=[]) == "up to 0.0 errors in 0 gates (**not held**)"


def test_single_scattering_meets_the_equation_and_a_wrong_one_is_seen():
    # Seen red: with n^2 left out of the equation's solid angle; with the attenuation 1 % larger.
    runner = program.Runner(program.find_program(), reduced=True)
    raw = accuracy.measure_lidar_equation(runner)
    assert [row.held for row in accuracy.rows_lidar_equation(raw)] == [True] * 4
    for of_run in raw.values():
        of_run["equation"] = [1.03 * echo for echo in of_run["equation"]]
    assert [row.held for row in accuracy.rows_lidar_equation(raw)] == [False] * 4


def test_the_slowest_scene():
    def one(known, wall_s):
        return {"gates": 10, "known": known, "wall_s": wall_s}

    assert speed.slowest({"limit": "60s", "a": one(10, 3.0), "b": one(10, 9.0), "c": one(10, 5.0)})[0] == "b"
    assert speed.slowest({"limit": "60s", "a": one(10, 3.0), "b": one(8, 60.0), "c": one(3, 60.0)})[0] == "c"


def test_scenes_in_multiples_of_a_yardstick():
    # Seen red: with the mean for the median; with runs that time ended counted as reached.
    def runs(*times):
        ends = {True: {"stopped_by": "target", "known": 8}, False: {"stopped_by": "time", "known": 7}}
        return [{"cpu_s": abs(t), "estimator": "forward", "gates": 9, **ends[t > 0]} for t in times]

    raw = {"yardstick": runs(1, 2, 6), "scenes": {"a": runs(8, 1, 40), "b": runs(-80, 6, 7), "c": runs(-80, 6, -80)}}
    stated = {row.what: row.measured for row in instruments.rows_costs(raw)}
    assert stated["a"] == "4 R (0.5, 4, 20); 8 of 9 gates; forward"
    assert stated["b"] == "3.5 R (3, 3.5, not reached); 7 of 9 gates; forward"
    assert stated["c"] == "not reached; 7 of 9 gates; forward"
    assert stated["R"] == "2.00 s of CPU, the median of 3 runs from 1.00 to 6.00 s"


def test_scenes_are_measured_each_after_the_yardstick():
    # Seen red: with the yardstick measured once; without the cut at 40 m; with gates counted that light does not reach.
    runner = program.Runner(program.find_program(), reduced=True)
    raw = instruments.measure_costs(runner, ["minimal"])
    peaked, minimal = ([c for c in runner.commands if f"scenes/{scene}.toml" in c] for scene in ("benchmark-peaked", "minimal"))
    assert runner.commands == [command for pair in zip(peaked, minimal) for command in pair]
    assert len(peaked) == 3 and all("gates.depth_max_m=40 " in command for command in peaked)
    assert not any("depth_max_m" in command for command in minimal)
    assert [one["stopped_by"] for one in raw["scenes"]["minimal"]] == ["target"] * 3
    assert [row.what for row in instruments.rows_costs(raw)] == ["R", "minimal"]

    [row] = instruments.rows_first_runs(instruments.measure_first_runs(runner, ["minimal"]))
    stated = r"\d+\.\d s, by (target|time); \d+ of 15 gates converged, \d+ at the target; flags: .*; (forward|bidirectional)"
    assert re.fullmatch(stated, row.measured)

    known = {"reasons": [], "converged": True, "relative_error": 0.01}
    dark = {"reasons": ["no_score"], "converged": False, "relative_error": 0}
    assert instruments.gates_of({"echoes": [known, dark]}, 0.02) == {"gates": 1, "known": 1}


def test_commands_of_many_seeds_are_one_line():
    commands = [f"photic run a.toml --seed {seed}" for seed in (1, 2, 3)] + ["photic run b.toml", "photic run a.toml --seed 1"]
    assert program.typed(commands) == ["photic run a.toml --seed 1   # and so on to --seed 3", "photic run b.toml"]


def test_a_run_goes_on_with_what_is_missing(measure, tmp_path):
    # Seen red: with results kept at the end alone; with all of it measured anew; with stamps not compared.
    done = measure("run", "--quick", "--only", "slabs", "-o", "out.json")
    assert done.returncode == 0, done.stderr
    path = tmp_path / "out.json"
    results = json.loads(path.read_text())
    assert list(results["measurements"]) == ["slabs"]
    assert results["measurements"]["slabs"]["commands"][0] == "photic run experiments/slab.toml --photons 240000"
    assert results["stamp"].keys() == stamp.stamp(program.Runner(program.find_program(), True)).keys()

    for measurement in pages.ALL:
        results["measurements"].setdefault(measurement.name, {"raw": "kept"})
    results["measurements"]["files"] = {"failed": "last time"}
    path.write_text(json.dumps(results))
    done = measure("run", "--quick", "-o", "out.json")
    assert done.returncode == 0, done.stderr
    assert " 1 of 1  files " in done.stdout and "1 measured, 0 failed" in done.stdout
    after = json.loads(path.read_text())["measurements"]
    assert after["files"]["raw"]["ship"] > 1e4
    assert after["coverage"] == {"raw": "kept"} and after["slabs"] == results["measurements"]["slabs"]

    before = path.read_text()
    done = measure("run", "-o", "out.json")
    assert done.returncode == 2
    assert "out.json: was not measured in the same way: reduced was True and is False now" in done.stderr
    assert path.read_text() == before


def test_a_failure_is_kept_and_stated_and_others_go_on(measure, tmp_path):
    # Seen red: with an exit code of 0; with the first failure the end of all.
    broken = tmp_path / "photic"
    real = program.find_program()
    broken.write_text(f'#!/bin/sh\ncase "$*" in *half-space*) echo "it broke" >&2; exit 1;; esac\nexec {real} "$@"\n')
    broken.chmod(0o755)
    done = measure("run", "--quick", "--only", "slabs", "--only", "files", PHOTIC_PROGRAM=str(broken))
    assert done.returncode == 1
    records = json.loads((tmp_path / "measured.json").read_text())["measurements"]
    assert records["slabs"]["failed"].endswith("exit code 1: it broke")
    assert "experiments/half-space.toml" in records["slabs"]["failed"]
    assert "raw" in records["files"]
    assert "1 measured, 1 failed" in done.stdout


def test_ctrl_c_keeps_what_is_done(tmp_path):
    # Seen red: with results kept at the end alone.
    command = [sys.executable, ROOT / "benchmarks/measure.py", "run", "--quick", "--only", "slabs", "--only", "coverage-hard"]
    process = subprocess.Popen(command, cwd=tmp_path, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, start_new_session=True)
    path = tmp_path / "measured.json"
    while not path.exists() and process.poll() is None:
        time.sleep(0.05)
    os.killpg(process.pid, signal.SIGINT)
    start = time.monotonic()
    _, errors = process.communicate(timeout=100)
    assert time.monotonic() - start < 5
    assert process.returncode == 130
    assert errors.strip() == "measure.py: interrupted; the same command continues with what is missing"
    assert list(json.loads(path.read_text())["measurements"]) == ["slabs"]


def test_a_program_that_is_not_there(measure):
    done = measure("run", "--quick", "--only", "slabs", PHOTIC_PROGRAM="/nowhere/photic")
    assert (done.returncode, done.stdout) == (2, "")
    assert done.stderr == (
        "measure.py: /nowhere/photic: no such program (build it: cmake --preset release && cmake --build --preset release)\n"
    )
