"""photic bench: every candidate is measured, and what it recommends is one of them and can be run."""

import json
import math
import re
import signal
import subprocess

import netCDF4
import pytest
from test_interrupt import wait_until_it_listens

CANDIDATES = [
    "as auto chooses",
    "forward, ray",
    "forward, ray, 0.25 directed, points 1",
    "forward, overlap (approximate)",
    "bidirectional, 0.6",
    "bidirectional, 0.9",
    "bidirectional, 0.6, free walks",
    "bidirectional, 0.6, meetings 30",
    "bidirectional, 0.6, walks 4",
    "bidirectional, 0.6, all connected",
    "bidirectional, 0.6, random",
    "forward, ray, scalar",
    "bidirectional, 0.6, scalar",
]


WATER = """\
[[sea.layer]]
iop = [{ wavelength_nm = 532.0, a_per_m = 0.1, b_per_m = 0.1 }]
phase_function = { model = "henyey-greenstein", g = 0.5 }
[gates]
depth_max_m = 6.0
depth_step_m = 3.0
"""


@pytest.fixture
def shallow(scene):
    """Few gates in water without a sharp peak: a reference settles there in a second, on a busy machine too."""
    head, rest = scene.read_text().split('[[channel]]\nname = "raman"')
    scene.write_text(head + WATER + rest[rest.index("[simulation]") :].replace('estimator = "forward"\n', ""))
    return scene


def bench_until_compared(photic, all_compared, *arguments):
    """The bench with the first of a few times that lets this machine compare all gates: it may be slow or busy."""
    for seconds in (2, 24, 64):
        done = photic("bench", "quick.toml", "--time", f"{seconds}s", *arguments)
        assert (done.returncode, done.stderr) == (0, "")
        if all_compared in done.stdout:
            break
    return done


def what_auto_takes(photic, scene, *arguments):
    assert photic("run", scene.name, "-o", "auto.nc", *arguments).returncode == 0
    with netCDF4.Dataset(scene.with_name("auto.nc")) as file:
        return file.estimator


def test_the_table(photic, shallow):
    # Seen red: with a candidate left out; with keys that no scene has in the recommended lines.
    taken = what_auto_takes(photic, shallow)
    done = bench_until_compared(photic, "2 of 2 gates compared", "--threads", "2")
    for name in CANDIDATES:
        assert len(re.findall(rf"^ *{re.escape(name)}  +[0-9]", done.stdout, re.M)) == 2, "by depth and over all gates"
    assert "channel elastic, telescope telescope0" in done.stdout
    assert "A figure of merit from 12 repeats is uncertain by about 41 %." in done.stdout
    name, lines = re.search(r"^recommended: (.*), by these lines .*\n((?:  .*\n)+)", done.stdout, re.M).groups()
    assert name in CANDIDATES
    shallow.write_text(shallow.read_text() + lines)
    assert photic("check", "quick.toml").returncode == 0
    assert f'estimator = "auto" would take\n  estimator = "{taken}"\n' in done.stdout
    assert re.search(r"because of pilot runs of \d+ to \d+ photons; ", done.stdout)


def test_as_json(photic, shallow):
    # Seen red: with a candidate left out; with the candidate of the least merit recommended; with keys that no scene
    # has in the settings of a candidate.
    done = bench_until_compared(photic, '"compared": 2\n', "--seed", "3", "--json")
    out = json.loads(done.stdout)
    assert (out["scene"], out["repeats"]) == ("quick.toml", 12)
    assert out["reference"]["photons"] > 0 and out["reference"]["cpu_s"] > 0
    gates = out["gates"]
    assert gates["all"] == gates["not_converged"] + gates["uncertain"] + gates["compared"] == 2
    assert gates["compared"] > 0
    candidates = out["candidates"]
    assert [c["name"] + ("" if c["exact"] else " (approximate)") for c in candidates] == CANDIDATES
    for candidate in candidates:
        assert candidate["photons"] > 0 and candidate["cpu_s"] > 0
        compared = [g["figure_of_merit_per_s"] for g in candidate["gates"] if g["compared"]]
        assert len(compared) == gates["compared"]
        mean = math.exp(math.fsum(math.log(merit) for merit in compared) / len(compared))
        assert candidate["figure_of_merit_per_s"] == pytest.approx(mean)
        for gate in candidate["gates"]:
            assert gate["channel"] == "elastic"
            merit = 1 / (gate["relative_variance"] * candidate["cpu_s"])
            assert gate["figure_of_merit_per_s"] == pytest.approx(merit)
        lines = [f"--set=simulation.{key}={json.dumps(value)}" for key, value in candidate["settings"].items()]
        assert photic("check", "quick.toml", *lines).returncode == 0
    best = max((c for c in candidates if c["exact"]), key=lambda c: c["figure_of_merit_per_s"])
    assert (out["recommended"], out["recommended_by"]) == (best["settings"], "all gates")
    assert out["auto"]["estimator"] == what_auto_takes(photic, shallow, "--seed", "3")


def test_with_a_target_the_worst_gates_decide(photic, shallow):
    # Seen red: with all gates whatever the aim.
    done = bench_until_compared(photic, '"compared": 2\n', "--set", "simulation.target_relative_error=0.02", "--json")
    out = json.loads(done.stdout)
    for candidate in out["candidates"]:
        worst = min(gate["figure_of_merit_per_s"] for gate in candidate["gates"] if gate["compared"])
        assert candidate["worst_fifth_per_s"] == pytest.approx(worst)
    best = max((c for c in out["candidates"] if c["exact"]), key=lambda c: c["worst_fifth_per_s"])
    assert (out["recommended"], out["recommended_by"]) == (best["settings"], "worst fifth")
    assert "the worst fifth of 2 gates has a relative error of 0.02" in out["auto_reason"]


def test_gates_that_no_light_comes_from(photic, shallow):
    # Seen red: with gates that have not converged in the reference compared.
    far = "depth_min_m = 900.0\ndepth_max_m = 901.0\ndepth_step_m = 1.0"
    shallow.write_text(shallow.read_text().replace("depth_max_m = 6.0\ndepth_step_m = 3.0", far))
    done = photic("bench", "quick.toml", "--time", "1s")
    assert (done.returncode, done.stderr) == (0, "")
    assert "0 of 1 gates compared; left out: 1 not converged in the reference, 0 where" in done.stdout
    assert "recommended: nothing, since no gate can be compared (give more --time)" in done.stdout


def waves(model):
    return ("--set", f"sea.surface={{ {model} }}")


def test_waves_have_no_overlap(photic, shallow):
    # Seen red: with the candidate that takes the mean over the lens, whose scene is refused.
    done = photic("bench", "quick.toml", "--time", "2s", "--json", *waves('model = "cox-munk", wind_speed_m_s = 5'))
    assert (done.returncode, done.stderr) == (0, "")
    candidates = [c["name"] for c in json.loads(done.stdout)["candidates"]]
    assert candidates == [name for name in CANDIDATES if "overlap" not in name and "free walks" not in name]


def test_waves_that_one_estimator_has_alone_are_refused(photic, shallow):
    # Seen red: without the check (an internal error).
    flat = ("--set", "telescope.0.direction=[1.0, 0.0, -0.2]")
    done = photic("bench", "quick.toml", "--time", "2s", *waves('model = "paper", wind_speed_m_s = 5'), *flat)
    assert (done.returncode, done.stdout) == (2, "")
    assert "photic bench compares the estimators, and the bidirectional one cannot treat one-dimensional waves" in done.stderr


def test_a_bad_scene(photic, shallow):
    shallow.write_text(shallow.read_text() + "photosn = 5\n")
    done = photic("bench", "quick.toml")
    assert (done.returncode, done.stdout) == (2, "")
    assert done.stderr == photic("check", "quick.toml").stderr


@pytest.mark.parametrize(
    ("time", "reason"),
    [
        ("60", "--time: '60' is not a time with its unit (write 60s, 10min or 2h)"),
        ("0s", "--time: '0s' is not above 0"),
        ("-5s", "--time: '-5s' is not above 0"),
        ("nans", "--time: 'nans' is not a time with its unit"),
        ("0.1s", "--time: '0.1s' is not from 1s to 24h"),
        ("1e300h", "--time: '1e300h' is not from 1s to 24h"),
    ],
)
def test_a_time_that_cannot_be(photic, shallow, time, reason):
    # Seen red: with any time above 0 taken.
    done = photic("bench", "quick.toml", "--time", time)
    assert (done.returncode, done.stdout) == (2, "")
    assert reason in done.stderr


def test_ctrl_c(program, shallow):
    # Seen red: with exit code 0.
    process = subprocess.Popen(
        [program, "bench", shallow.name, "--time", "60s"],
        cwd=shallow.parent, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.default_int_handler),
    )
    wait_until_it_listens(process)
    process.send_signal(signal.SIGINT)
    out, errors = process.communicate(timeout=20)
    assert (process.returncode, out, errors) == (130, "", "")
