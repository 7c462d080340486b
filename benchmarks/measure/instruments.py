"""The cost of the scenes that `photic new` writes: as a multiple of the time of one of them, and as a user meets them."""

import math
import statistics
import tomllib
from collections import Counter

from measure.kinds import Measurement, Row, number
from measure.program import ROOT, echo_scenes

YARDSTICK = "benchmark-peaked"  # to 2 % in every gate to 40 m: its CPU time is R
TARGET = 0.02
LIMIT = 40  # in R
DEEPEST_M = 40
SEEDS = 3
CHANGED = {  # instruments that are hard in other ways: a scene, and what is set
    "benchmark-peaked, lens of 4 mm": ("benchmark-peaked", "telescope.0.diameter_m=0.004"),
    "spaceborne, view of 5 mrad, laser of 0.25 mrad": (
        "spaceborne", "telescope.0.half_field_of_view_mrad=2.5", "source.half_divergence_mrad=0.125",
    ),
}


def words(name):
    """The scene, with gates by depth that go further than 40 m cut there."""
    scene, *changes = CHANGED.get(name, (name,))
    return (*to_40_m(f"scenes/{scene}.toml"), *(word for change in changes for word in ("--set", change)))


def to_40_m(file):
    gates = tomllib.loads((ROOT / file).read_text())["gates"]
    return (file, "--set", f"gates.depth_max_m={DEEPEST_M}") if gates.get("depth_max_m", 0) > DEEPEST_M else (file,)


def gates_of(result, target):
    """The number of gates that light reaches, and of those that are converged below the target."""
    lit = [row for row in result["echoes"] if row["reasons"] != ["no_score"]]
    return {"gates": len(lit), "known": sum(row["converged"] and row["relative_error"] <= target for row in lit)}


# --- in multiples of R ---


def measure_costs(runner, chosen=None):
    def run(scene, seed, *more):
        target = f"{runner.choose(TARGET, 0.2):.0%}"
        ends = ("--target", target, "--photons", "1e9", *more, "--threads", 1, "--seed", seed)
        result = runner.timed("run", *words(scene), *ends)
        kept = {key: result[key] for key in ("cpu_s", "stopped_by", "estimator")}
        return kept | gates_of(result, TARGET)

    yardsticks, costs = [], {}
    for seed in runner.seeds(SEEDS):
        for scene in chosen or (*echo_scenes(), *CHANGED):
            yardsticks.append(run(YARDSTICK, seed, "--max-time", "10min"))
            limit = LIMIT * statistics.median(one["cpu_s"] for one in yardsticks)
            costs.setdefault(scene, []).append(run(scene, seed, "--max-time", f"{limit:.0f}s"))
    return {"yardstick": yardsticks, "scenes": costs}


def stated_cost(runs, r):
    """The median of the runs' CPU times in R, and all of them; infinite are those that did not reach the target."""
    costs = sorted(one["cpu_s"] / r if one["stopped_by"] == "target" else math.inf for one in runs)
    if math.isinf(statistics.median(costs)):
        return "not reached"
    each = [number(cost) if cost < math.inf else "not reached" for cost in costs]
    return f"{number(statistics.median(costs))} R ({', '.join(each)})"


def stated_gates(runs):
    """The fewest known gates of several runs, of the most that light reached."""
    return f"{min(one['known'] for one in runs)} of {max(one['gates'] for one in runs)} gates"


def rows_costs(raw):
    times = [one["cpu_s"] for one in raw["yardstick"]]
    r = statistics.median(times)
    yield Row("R", f"{r:.2f} s of CPU, the median of {len(times)} runs from {min(times):.2f} to {max(times):.2f} s")
    for scene, runs in raw["scenes"].items():
        estimators = ", ".join(dict.fromkeys(one["estimator"] for one in runs))
        yield Row(scene, f"{stated_cost(runs, r)}; {stated_gates(runs)}; {estimators}")


# --- as a user meets them ---


def measure_first_runs(runner, chosen=None):
    out = {}
    for scene in chosen or echo_scenes():
        file = f"scenes/{scene}.toml"
        simulation = tomllib.loads((ROOT / file).read_text())["simulation"]
        result = runner.timed("run", file, "--threads", 2, *runner.choose((), ("--max-time", "1s")))
        flags = Counter(reason for row in result["echoes"] for reason in row["reasons"])
        kept = {key: result[key] for key in ("wall_s", "stopped_by", "estimator")}
        kept |= gates_of(result, simulation.get("target_relative_error", math.inf))
        out[scene] = kept | {"converged": gates_of(result, math.inf)["known"], "flags": flags}
    return out


def rows_first_runs(raw):
    for scene, one in raw.items():
        flags = ", ".join(f"{reason} {count}" for reason, count in one["flags"].items()) or "none"
        ended = f"{one['wall_s']:.1f} s, by {one['stopped_by']}; {one['converged']} of {one['gates']} gates converged"
        yield Row(scene, f"{ended}, {one['known']} at the target; flags: {flags}; {one['estimator']}")


MEASUREMENTS = [
    Measurement(
        "instruments", "Instruments", "The cost of knowing every gate to 2 %, for the scenes that `photic new` writes, and for two harder ones.",
        "CPU time of the whole command on one thread, the median of three seeds and each of them, in R: that of peaked water (benchmark-peaked) to "
        f"40 m, measured before each of these runs. Gates by depth end at {DEEPEST_M} m. A run has {LIMIT} R after the pilots: "
        "'not reached' if most seeds ended so. Gates: the smallest number, over the seeds, that were known by then, of those that light "
        "reaches. The estimator is the one that `auto` chose.",
        measure_costs, rows_costs,
    ),
    Measurement(
        "first-runs", "First runs", "The result of such a scene as it is.",
        "Wall time of the whole command on two threads; what ended it; how many gates are converged, and how many of those "
        "are below the scene's own target; how many gates have each flag.",
        measure_first_runs, rows_first_runs,
    ),
]
