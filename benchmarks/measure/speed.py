"""Times: as ratios where possible, since machines differ."""

import math
import os

from measure.accuracy import BOTH, estimator, isas_here
from measure.instruments import TARGET, gates_of
from measure.kinds import Measurement, Row, number
from measure.program import Failed

SHIP, PEAKED = "scenes/ship.toml", "scenes/benchmark-peaked.toml"


def min_of(runner, rounds, key, runs):
    """The least seconds of each of several runs, which take turns, so that all meet the same load."""
    least = dict.fromkeys(runs, math.inf)
    for _ in range(runner.choose(rounds, 1)):
        for name, arguments in runs.items():
            least[name] = min(least[name], runner.timed(*arguments)[key])
    return least


# --- how long until an echo is known ---

TO_40_M = ("--set", "gates.depth_max_m=40")
AXIS = "[0.25881904510252074, 0.0, -0.9659258262890683]"
TILTED = ("--set", f"source.direction={AXIS}", "--set", f"telescope.0.direction={AXIS}")
TARGETS = {
    "ship lidar, three channels": (SHIP, *TO_40_M),
    "peaked water": (PEAKED, *TO_40_M),
    "Henyey-Greenstein water": ("scenes/benchmark-hg.toml", *TO_40_M),
    "ship-tilted": ("scenes/ship-tilted.toml",),
    "rov": ("scenes/rov.toml",),
    "three layers, two telescopes": ("scenes/three-layers.toml", *TO_40_M),
    "peaked water, tilted by 15 degrees": (PEAKED, *TO_40_M, *TILTED),
}


def measure_target(runner):
    limit = runner.choose("40s", "1s")
    out = {"limit": limit}
    for name, scene in TARGETS.items():
        result = runner.timed("run", *scene, "--target", "2%", "--photons", "1e9", "--max-time", limit)
        kept = {key: result[key] for key in ("wall_s", "cpu_s", "stopped_by", "estimator", "photons")}
        out[name] = kept | gates_of(result, TARGET)
    return out


def stated_time(one, limit):
    if one["stopped_by"] == "target":
        return f"{one['wall_s']:.1f} s ({one['cpu_s']:.1f} s of CPU)"
    return f"{one['known']} of {one['gates']} gates after {limit.removesuffix('s')} s"


def slowest(raw):
    """The scene with the fewest known gates when its time was over; if all were known, the one that took longest."""
    scenes = {name: one for name, one in raw.items() if name != "limit"}
    return min(scenes.items(), key=lambda item: (item[1]["known"] / max(1, item[1]["gates"]), -item[1]["wall_s"]))


def rows_target(raw):
    for name, one in raw.items():
        if name != "limit":
            yield Row(f"{name} ({one['estimator']})", stated_time(one, raw["limit"]))


# --- the estimators by depth ---

BANDS = ((0, 8), (16, 25), (33, 41))  # [m]


def measure_estimators(runner):
    out = {}
    for scene in ("benchmark-peaked", "benchmark-hg"):
        found = runner.timed("bench", f"scenes/{scene}.toml", "--time", runner.choose("30s", "2s"))
        merits = {}
        for candidate in found["candidates"]:
            if candidate["name"] in ("forward, ray", "bidirectional, 0.6"):
                compared = [gate for gate in candidate["gates"] if gate["compared"]]
                merits[candidate["name"]] = [[gate["depth_m"], gate["figure_of_merit_per_s"]] for gate in compared]
        out[scene] = merits
    return out


def in_band(gates, band):
    inside = [merit for depth, merit in gates if band[0] <= depth < band[1]]
    return math.exp(math.fsum(map(math.log, inside)) / len(inside)) if inside else math.nan


def rows_estimators(raw):
    for scene, merits in raw.items():
        for band in BANDS:
            both, forward = (in_band(merits[name], band) for name in ("bidirectional, 0.6", "forward, ray"))
            known = not math.isnan(both)
            measured = f"{number(both)} and {number(forward)} per second: ratio {number(both / forward)}" if known else "no gate known"
            yield Row(f"{scene}, {band[0]} to {band[1]} m", measured)


# --- what walks the photons ---

LANES_PHOTONS = {"forward": 2e6, "bidirectional": 1e5}


def measure_engines(runner):
    here, absent = isas_here(runner)
    out = {"absent": absent, "best": {}}
    for name in BOTH:
        run = ("run", PEAKED, *estimator(name), "--threads", 1, "--photons")
        few = runner.photons(LANES_PHOTONS[name] / 8, name)
        engines = {"scalar": (*run, few, "--engine", "scalar")}
        engines |= {isa: (*run, runner.photons(LANES_PHOTONS[name], name), "--isa", isa) for isa in here}
        for _ in range(runner.choose(3, 1)):
            for engine, arguments in engines.items():
                result = runner.timed(*arguments)
                rates = [result[key] / result["wall_time_s"] for key in ("photons", "collisions")]
                best = out["best"].setdefault(f"{name}, {engine}", rates)
                out["best"][f"{name}, {engine}"] = max(best, rates)
    return out


def over_scalar(raw, name):
    """The best lanes' photons per second over the scalar engine's, by estimator; and which lanes."""
    rates = {key.split(", ")[1]: rate[0] for key, rate in raw["best"].items() if key.startswith(name)}
    scalar = rates.pop("scalar")
    if not rates:
        raise Failed("no lanes were measured")
    best = max(rates, key=rates.get)
    return rates[best] / scalar, best


def rows_engines(raw):
    for key, (photons, collisions) in raw["best"].items():
        scalar = raw["best"][key.split(", ")[0] + ", scalar"][0]
        measured = f"{number(photons)} photons/s, {number(collisions)} collisions/s"
        yield Row(key, measured + ("" if key.endswith("scalar") else f": {photons / scalar:.1f} times the scalar engine's photons/s"))
    for isa, reason in raw["absent"].items():
        yield Row(isa, f"not measured: {reason}")


def measure_threads(runner):
    if (os.cpu_count() or 1) < 2:
        raise Failed("this machine has one core")
    out = {}
    for name, photons in (("forward", 5e6), ("bidirectional", 2e5)):
        run = ("run", PEAKED, *estimator(name), "--photons", runner.photons(photons, name), "--threads")
        out[name] = min_of(runner, 3, "wall_time_s", {"1": (*run, 1), "2": (*run, 2)})
    return out


def rows_threads(raw):
    for name, least in raw.items():
        yield Row(name, f"{least['1'] / least['2']:.2f} times as fast")


# --- what more water costs ---


def costs(runner, rounds, photons, variants):
    """CPU seconds by estimator and variant, of the same photons on one thread."""
    out = {}
    for name in BOTH:
        more = (*estimator(name), "--threads", 1, "--photons", runner.photons(photons[name], name))
        out[name] = min_of(runner, rounds, "cpu_s", {key: ("run", *words, *more) for key, words in variants.items()})
    return out


def measure_layers(runner):
    variants = {"one": (PEAKED,), "fifty": ("experiments/fifty-layers.toml",)}
    return costs(runner, 4, {"forward": 2e6, "bidirectional": 1.2e5}, variants)


def rows_layers(raw):
    for name, least in raw.items():
        yield Row(name, f"{least['fifty'] / least['one']:.2f} times the time of one layer")


CHLOROPHYLL = "sea.layer.0.chlorophyll_mg_m3"


def measure_environments(runner):
    def grid(count):
        values = ", ".join(f"{0.1 + 0.01 * k:.2f}" for k in range(1, count + 1))
        return (SHIP, "--set", f"environment_grid.{CHLOROPHYLL}=[{values}]")

    variants = {"0": (SHIP,)} | {str(count): grid(count) for count in (1, 4, 16)}
    return costs(runner, 2, {"forward": 1e6, "bidirectional": 6e4}, variants)


def rows_environments(raw):
    for name, least in raw.items():
        for count in ("1", "4", "16"):
            measured = f"{least[count] / least['0']:.2f} times the time of none"
            measured += f", {least[count] / least['1']:.2f} times that of one" if count != "1" else ""
            yield Row(f"{name}, {count}", measured)


def measure_derivatives(runner):
    keys = ("chlorophyll_mg_m3", "cdom_a440_per_m", "chlorophyll_yield", "cdom_slope_per_nm")
    water = (SHIP, "--set", "sea.layer.0.cdom_a440_per_m=0.02")

    def by(count):
        paths = ", ".join(f'"sea.layer.0.{key}"' for key in keys[:count])
        return (*water, "--set", f"sensitivity=[{paths}]")

    variants = {"0": water, "1": by(1), "4": by(4)}
    return costs(runner, 2, {"forward": 1e6, "bidirectional": 6e4}, variants)


def rows_derivatives(raw):
    for name, least in raw.items():
        for count in ("1", "4"):
            yield Row(f"{name}, by {count}", f"{least[count] / least['0']:.2f} times the time of none")


# --- what a short run costs ---


def measure_start(runner):
    few = ("--photons", 1000)
    runs = {
        "ship, bidirectional": ("run", SHIP, *few, *estimator("bidirectional")),
        "ship, auto": ("run", SHIP, *few),
        "three layers, auto": ("run", "scenes/three-layers.toml", *few),
    }
    return min_of(runner, 5, "wall_s", runs)


def rows_start(raw):
    for name, wall_s in raw.items():
        yield Row(name, f"{wall_s:.2f} s")


def measure_files(runner):
    run = ("run", SHIP, *estimator("bidirectional"), "--photons", runner.photons(6e4, "bidirectional"))
    variants = {"ship": run, "ship, without echoes by depth": (*run, "--set", "gates.depth_cells=0")}
    return {name: runner.timed(*words)["file_bytes"] for name, words in variants.items()}


def rows_files(raw):
    for name, size in raw.items():
        yield Row(name, f"{size / 1000:.0f} kB")


SAME_PHOTONS = "CPU time of whole runs of the same photons on one thread, the shortest of several in turn."
MEASUREMENTS = [
    Measurement(
        "time-to-target", "Time to 2 %", "How long until every gate to 40 m is known to 2 % (ship-tilted and rov: to the last "
        "of their own gates).",
        "The whole command on all cores, with the estimator that `auto` chose. For a run that its limit of time ended: how many gates "
        "were known by then, of those that light reaches.",
        measure_target, rows_target,
    ),
    Measurement(
        "estimators", "Estimators by depth", "Figures of merit, 1 / (relative variance x CPU seconds), of the bidirectional and "
        "the forward estimator.",
        "Geometric means over the gates of a band that `photic bench` compares. A gate's figure is uncertain by 41 %, and "
        "the forward one in deep gates is probably lower: 12 repeats miss rare large scores.",
        measure_estimators, rows_estimators,
    ),
    Measurement(
        "engines", "Engines", "Photons and collisions per second on one core, by the instruction set of the lanes.",
        "Peaked water, the best of several runs in turn.", measure_engines, rows_engines,
    ),
    Measurement("threads", "Threads", "Two threads, relative to one.", "Wall time, the shortest of several runs in turn.",
                measure_threads, rows_threads),
    Measurement("layers", "Layers", "Fifty layers of similar water, relative to one.", SAME_PHOTONS, measure_layers, rows_layers),
    Measurement(
        "environments", "Environments", "The cost of other waters that are computed from the same photons.",
        SAME_PHOTONS,
        measure_environments, rows_environments,
    ),
    Measurement("derivatives", "Derivatives", "The cost of derivatives with respect to one and four parameters.", SAME_PHOTONS,
                measure_derivatives, rows_derivatives),
    Measurement(
        "start", "Start", "A whole run of 1000 photons: with `auto`, pilot runs choose the estimator first.",
        "Wall time on all cores, the shortest of several.", measure_start, rows_start,
    ),
    Measurement("files", "Files", "The size of a result, with all that is needed to continue it.", "netCDF, three channels "
                "of 25 gates.", measure_files, rows_files),
]
