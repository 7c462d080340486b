#!/usr/bin/python3
"""Fits the prices of a simulation's operations, by which `auto` compares estimators and settings.

    benchmarks/prices.py count -o benchmarks/prices.csv    # half an hour on two cores; needs valgrind
    benchmarks/prices.py fit benchmarks/prices.csv         # writes src/run/prices.hpp

`count` runs every starter by several estimators and settings under callgrind, with so many photons and twice as many: the
difference in instructions is that of so many photons, without the tables that a run begins with. The results list the operations.
`fit` finds the prices, none of them below 0, whose mean and largest relative errors over all runs are least together.

The program is that of PHOTIC_PROGRAM, or build/release/apps/photic/photic; it runs with AVX2.
"""

import argparse
import csv
import re
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import netCDF4
import numpy as np
from scipy.optimize import linprog

sys.dont_write_bytecode = True

from measure.program import ROOT, echo_scenes, find_program  # noqa: E402

HEADER = ROOT / "src/run/prices.hpp"
OPERATIONS = ["photons", "collisions", "scores", "local_estimates", "facets", "vertex_pairs", "ray_pairs", "meetings",
              "free_meetings", "meetings_by_waves"]
COLUMNS = ["scene", "way", "layered", "film", "environments", *OPERATIONS, "instructions"]
OF_ESTIMATOR = {  # the prices that each of them has
    "forward": ["photons", "collisions", "scores", "layered_scores", "facets", "film_facets", "ratios"],
    "bidirectional": ["photons", "collisions", "scores", "layered_scores", "local_estimates", "facets", "film_facets", "vertex_pairs",
                      "ray_pairs", "meetings", "free_meetings", "meetings_by_waves", "ratios"],
}
GROUP = 8  # environments are added up by so many: tally::EnvironmentScores
NO_FREE_WALKS = ["free_telescope_meetings=0", "free_laser_meetings=0"]
FREE_WALKS = ["free_telescope_meetings=0.3", "free_laser_meetings=1.0"]
WAYS = {  # estimator, photons, settings
    "forward": ("forward", 30000, []),
    "bidirectional": ("bidirectional", 2000, NO_FREE_WALKS),
    "bidirectional, few meetings": ("bidirectional", 2000, ["meetings=30", *NO_FREE_WALKS]),
    "bidirectional, four walks": ("bidirectional", 2000, ["walks=4", *NO_FREE_WALKS]),
    "bidirectional, free walks": ("bidirectional", 2000, FREE_WALKS),
}
WITH_ENVIRONMENTS = {  # the scene, environments: chlorophyll of so many values
    "ship": 16, "three-layers": 4,
}
GRID = "environment_grid.sea.layer.0.chlorophyll_mg_m3"


def run(program, scene, way, environments, photons, folder):
    """Runs a scene; its result, and its instructions."""
    estimator, _, settings = WAYS[way]
    out = folder / f"{scene}-{way}-{environments}-{photons}.nc"
    command = ["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null", program, "run", ROOT / f"scenes/{scene}.toml",
               "-o", out, "--quiet", "--table", "none", "--threads", "1", "--isa", "avx2", "--photons", str(photons),
               "--max-time", "90h", "--checkpoint", "90h"]
    for setting in [f"estimator={estimator}", "batch_photons=2000", *settings]:
        command += ["--set", f"simulation.{setting}"]
    if environments:
        values = [round(0.11 + 0.01 * k, 2) for k in range(environments)]
        command += ["--set", f"{GRID}={values}"]
    done = subprocess.run(command, capture_output=True, text=True)
    counted = re.search(r"Collected : (\d+)", done.stderr)
    if done.returncode != 0 or not counted:
        raise SystemExit(f"prices.py: {scene}, {way}: {done.stderr[-500:]}")
    return out, int(counted[1])


def row_of(result, instructions, environments):
    """The properties of the scene that a result is of, and its counts."""
    with netCDF4.Dataset(result) as file:
        scene = file.scene
        group = file.groups["continuation"]
        counts = {name: int(getattr(group, name)) for name in OPERATIONS}
    layered = scene.count("[[sea.layer]]") > 1 or "[atmosphere]" in scene
    properties = {"layered": int(layered), "film": int("[oil]" in scene), "environments": -(-environments // GROUP) * GROUP}
    return properties, {**counts, "instructions": instructions}


def count(program, only, output):
    scenes = only or echo_scenes()
    jobs = [(scene, way, 0) for scene in scenes for way in WAYS]
    jobs += [(scene, way, WITH_ENVIRONMENTS[scene]) for scene in scenes if scene in WITH_ENVIRONMENTS
             for way in ("forward", "bidirectional", "bidirectional, free walks")]
    with tempfile.TemporaryDirectory() as folder, ThreadPoolExecutor(2) as pool, output.open("w", newline="") as file:
        writer = csv.DictWriter(file, COLUMNS, lineterminator="\n")
        writer.writeheader()
        runs = {job: [pool.submit(run, program, *job, n * WAYS[job[1]][1], Path(folder)) for n in (1, 2)] for job in jobs}
        for (scene, way, environments), both in runs.items():
            (properties, once), (_, twice) = (row_of(*one.result(), environments) for one in both)
            more = {name: twice[name] - once[name] for name in once}
            writer.writerow({"scene": scene, "way": way, **properties, **more})
            print(f"{scene}, {way}, {environments} environments", flush=True)


def read(table):
    with table.open(newline="") as file:
        return list(csv.DictReader(file))


def priced(row, name):
    """How often a price is to be paid."""
    number = {key: float(value) for key, value in row.items() if key not in ("scene", "way")}
    return {"layered_scores": number["scores"] * number["layered"], "film_facets": number["facets"] * number["film"],
            "ratios": number["scores"] * number["environments"], **number}[name]


def prices(rows, names):
    """The prices [instructions], and predicted over counted instructions of each row."""
    counts = np.array([[priced(row, name) for name in names] for row in rows])
    instructions = np.array([float(row["instructions"]) for row in rows])
    relative = counts / instructions[:, None]
    # Predicted over counted, 1 + d, lies within 1 - 0.8 t and 1 + t; t and the mean of |d| are made small together.
    runs, kinds = relative.shape
    zero, one, each = np.zeros((runs, runs)), np.ones((runs, 1)), np.eye(runs)
    none = np.zeros((runs, 1))
    bounds = np.block([[relative, zero, -one], [-relative, zero, -0.8 * one], [relative, -each, none], [-relative, -each, none]])
    sides = np.tile([1.0] * runs + [-1.0] * runs, 2)
    price = linprog([*np.zeros(kinds), *np.full(runs, 1 / runs), 1], A_ub=bounds, b_ub=sides, method="highs").x[:kinds]
    return price, relative @ price


def line_of(estimator, names, price):
    by_name = dict(zip(names, price))
    figures = ", ".join(f".{name} = {by_name[name]:.0f}" for name in names)
    return f"constexpr Prices {estimator}_prices{{{figures}}};\n"


def fit(table):
    rows = read(table)
    text = HEADER.read_text()
    for estimator, names in OF_ESTIMATOR.items():
        own = [row for row in rows if WAYS[row["way"]][0] == estimator]
        price, ratio = prices(own, names)
        for row, r in sorted(zip(own, ratio), key=lambda pair: pair[1]):
            print(f"{r:.2f} {row['scene']}, {row['way']}, {row['environments']} environments")
        print(line_of(estimator, names, price))
        text = re.sub(rf"constexpr Prices {estimator}_prices\{{[^}}]*\}};\n", line_of(estimator, names, price), text)
    HEADER.write_text(text)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(dest="command", required=True)
    counting = commands.add_parser("count", help="count operations and instructions")
    counting.add_argument("scene", nargs="*", help="starters; all by default")
    counting.add_argument("-o", "--output", type=Path, default=Path("prices.csv"))
    fitting = commands.add_parser("fit", help="fit the prices, and write them into the source")
    fitting.add_argument("table", type=Path)
    asked = parser.parse_args()
    if asked.command == "count":
        count(find_program(), asked.scene, asked.output)
    else:
        fit(asked.table)


if __name__ == "__main__":
    main()
