#!/usr/bin/env python3
"""The gain or cost of each of the paper's tools: docs/decisions/0016-the-papers-tools.md.

    experiments/tools_merit.py build/release/apps/photic/photic [--seeds 24] [--cpu 1.0]

For each scene: a long bidirectional run as reference, then the forward estimator with each tool, the same photons with so
many seeds. Figure of merit: 1 / (mean squared relative deviation from the reference x CPU time), by depth, as a ratio to the
plain estimator's (geometric mean over the gates whose reference is known to 1 % or to a third of what the runs miss).
Never a run's own error: rare large scores make that look small."""

import argparse
import json
import math
import pathlib
import resource
import statistics
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
DEEPER = "[{depth_m=5,value=2},{depth_m=10,value=4},{depth_m=20,value=8},{depth_m=30,value=16}]"
SHALLOWER = "[{depth_m=1,value=2},{depth_m=2.5,value=4},{depth_m=4,value=8}]"
FOLDER = tempfile.TemporaryDirectory()  # pylint: disable=consider-using-with
END = ["weight_threshold=0.1", "at_threshold=end"]


def variants(importance):
    """Name: (whether directed sampling is on, tools)."""
    tools = {
        "plain": ["weight_threshold=1e-8"],
        "forced collisions, all": ["weight_threshold=1e-8", "forced_collisions=1000000"],
        "forced collisions, first 2": ["weight_threshold=1e-8", "forced_collisions=2"],
        "local forced collisions": ["weight_threshold=1e-8", "local_forced_collisions=all"],
        "importance by depth": ["weight_threshold=1e-8", f"importance={importance}"],
        "roulette below 0.1": ["weight_threshold=0.1"],
        "analog absorption": ["weight_threshold=1.0", "at_threshold=analog-absorption"],
        "end below 0.1": END,
    }
    out = {name: (True, keys) for name, keys in tools.items()}
    for name in ("plain", "local forced collisions", "importance by depth"):
        out[f"undirected: {name}"] = (False, tools[name])
    return out


SCENES = {
    "ship": (ROOT / "scenes/ship.toml", DEEPER, [0, 10, 20, 35]),
    "peaked": (ROOT / "scenes/benchmark-peaked.toml", DEEPER, [0, 8, 16, 30]),
    "shallow": (ROOT / "experiments/shallow.toml", SHALLOWER, [0, 2, 4, 6]),
}


def run(photic, scene, photons, seed, keys):
    """Echoes by (channel, gate) and the CPU seconds they took."""
    command = [photic, "run", str(scene), "--threads", "1", "--photons", str(int(photons)), "--seed", str(seed), "--json",
               "-o", f"{FOLDER.name}/merit.csv"]
    # Photons alone end the run, whatever else the scene says.
    for key in ["target_relative_error=1e-9", "max_time_s=1e9", *keys]:
        command += ["--set", f"simulation.{key}"]
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if done.returncode != 0:
        sys.exit(done.stderr)
    cpu_s = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    result = json.loads(done.stdout)
    return {(row["channel"], row["gate"]): row for row in result["echoes"]}, result, cpu_s


class Candidate:
    """One variant's squared relative deviations from the reference, by cell, and its CPU times."""

    def __init__(self, settings, photic, scene):
        self.settings = settings
        self.start_s = min(run(photic, scene, 2000, 1, settings)[2] for _ in range(3))
        self.squares = {}
        self.cpu_s = []
        self.cut = 0.0

    def add(self, echoes, reference, cpu_s, cut):
        self.cpu_s.append(cpu_s - self.start_s)
        self.cut = cut
        for cell, row in reference.items():
            if row["echo"] > 0:
                square = (echoes[cell]["echo"] / row["echo"] - 1) ** 2
                self.squares.setdefault(cell, []).append(square)

    def badness(self, cell):
        """Mean squared deviation times CPU time; the median, for other programs run as well."""
        return statistics.mean(self.squares[cell]) * statistics.median(self.cpu_s)


def known(row, plain_square):
    error = row["standard_error"] / row["echo"] if row["echo"] > 0 else math.inf
    return row["converged"] and (error < 0.01 or error**2 < plain_square / 9)


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("photic")
    arguments.add_argument("--seeds", type=int, default=24)
    arguments.add_argument("--cpu", type=float, default=1.0, help="seconds of a plain run")
    arguments.add_argument("--reference", type=float, default=60.0, help="CPU seconds of a reference")
    arguments.add_argument("--scene", choices=SCENES, action="append")
    asked = arguments.parse_args()
    for name in asked.scene or SCENES:
        scene, importance, edges = SCENES[name]
        trial = 200_000
        forward = ["estimator=forward", "scored_points=1"]
        speed = trial / run(asked.photic, scene, trial, 1, forward)[2]
        photons = round(asked.cpu * speed, -4)
        both_ways = ["estimator=bidirectional"]
        reference_speed = 100_000 / run(asked.photic, scene, 100_000, 1, both_ways)[2]
        reference, _, _ = run(asked.photic, scene, asked.reference * reference_speed, 7, both_ways)
        print(f"\n{name}: {photons:.3g} photons a run, {asked.seeds} seeds", flush=True)
        candidates = {label: Candidate(forward + [f"tools.{key}" for key in keys] + ([] if directed else ["directed_fraction=0"]),
                                       asked.photic, scene) for label, (directed, keys) in variants(importance).items()}
        for seed in range(1000, 1000 + asked.seeds):  # in turns, so that all meet the same load
            for one in candidates.values():
                echoes, result, cpu_s = run(asked.photic, scene, photons, seed, one.settings)
                one.add(echoes, reference, cpu_s, result["ledger"]["cut_by_weight"])
        plain = candidates["plain"]
        for label, one in candidates.items():
            line = f"| {label} | {statistics.median(one.cpu_s) / statistics.median(plain.cpu_s):.2f} |"
            for low, high in zip(edges, edges[1:]):
                for channel in sorted({cell[0] for cell in reference}):
                    ratios = [plain.badness(cell) / one.badness(cell) for cell, row in reference.items()
                              if cell[0] == channel and low <= row["depth_m"] < high
                              and known(row, statistics.mean(plain.squares.get(cell, [0])))]
                    if ratios:
                        line += f" {channel} {low}-{high} m: {statistics.geometric_mean(ratios):.2g} ({len(ratios)}) |"
            print(line + (f" cut {one.cut:.2g}" if one.cut else ""), flush=True)


if __name__ == "__main__":
    main()
