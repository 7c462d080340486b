#!/usr/bin/python3
"""Tests whether `auto` chooses well: CPU time until all gates meet the target, with `auto` and with each exact setting that bench tries.

    experiments/choice.py build/release/apps/photic/photic scenes/*.toml --seeds 1 2 3 --cap 60

One thread each; seconds are the whole process's, pilots and tables included. A run that has taken the cap of CPU seconds is
interrupted: its time is given as above the cap, with the gates that had met the target by then. A line for each scene: the
median over the seeds with `auto`, with the best setting, and their ratio; then what was measured. By hand, on an idle machine:
12 settings x scenes x seeds x up to the cap.
"""

import argparse
import json
import os
import signal
import statistics
import subprocess
import tempfile
import time
import tomllib
from pathlib import Path

import netCDF4
import numpy as np

TICKS = os.sysconf("SC_CLK_TCK")


def cpu_so_far(pid):
    fields = Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / TICKS


def run(command, cap):
    """CPU seconds of a command; interrupted (which lets it write what it has) once it has taken the cap."""
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    sent = False
    while not os.waitid(os.P_PID, process.pid, os.WEXITED | os.WNOHANG | os.WNOWAIT):
        if not sent and cpu_so_far(process.pid) > cap:
            process.send_signal(signal.SIGINT)
            sent = True
        time.sleep(0.02)
    used = os.wait4(process.pid, 0)[2]
    return used.ru_utime + used.ru_stime


def settings_of_bench(program, scene):
    """Exact settings by name, each once: those that differ in the engine alone are one."""
    done = subprocess.run([program, "bench", scene, "--time", "1s", "--threads", "1", "--json"], check=True, capture_output=True, text=True)
    out = {}
    for candidate in json.loads(done.stdout)["candidates"]:
        if candidate["exact"] and candidate["settings"] not in out.values():
            out[candidate["name"]] = candidate["settings"]
    return out


def to_target(program, scene, settings, seed, target, cap):
    """CPU seconds, whether all gates met the target, how many of those that light reaches did, what estimator took how long."""
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder) / "out.nc"
        command = [program, "run", scene, "-o", out, "--threads", "1", "--seed", seed, "--photons", "1e12", "--target", target]
        command += ["--max-time", "24h", "--table", "none"]
        for key, value in settings.items():
            command += ["--set", f"simulation.{key}={json.dumps(value)}"]
        seconds = run([str(word) for word in command], cap)
        if not out.exists():
            return {"cpu_s": seconds, "met": False, "known": 0, "gates": 0, "reason": ""}
        with netCDF4.Dataset(out) as file:
            echo, error = (np.ma.filled(file[name][:], np.nan) for name in ("echo", "echo_standard_error"))
            known = np.sum((np.ma.filled(file["convergence_flags"][:], 1) == 0) & (error <= target * echo))
            return {"cpu_s": seconds, "met": file.stopped_by == "target", "known": int(known), "gates": int(np.sum(echo > 0)),
                    "reason": tomllib.loads(file.scene)["simulation"].get("estimator_reason", "")}


def in_words(runs):
    median = statistics.median(r["cpu_s"] for r in runs)
    if all(r["met"] for r in runs):
        return f"{median:.2f} s"
    return f">{median:.1f} s ({', '.join(str(r['known']) + '/' + str(r['gates']) for r in runs)})"


def rank(runs):
    """Better is less: how many seeds missed the target, gates not known, seconds."""
    return sum(not r["met"] for r in runs), -sum(r["known"] for r in runs if not r["met"]), statistics.median(r["cpu_s"] for r in runs)


def measure(program, scene, options):
    measured = {}
    settings = {"auto": {"estimator": "auto"}} | settings_of_bench(program, scene)
    for name, setting in settings.items():
        measured[name] = [to_target(program, scene, setting, seed, options.target, options.cap) for seed in options.seeds]
    best = min((name for name in measured if name != "auto"), key=lambda name: rank(measured[name]))
    seconds = {name: statistics.median(r["cpu_s"] for r in measured[name]) for name in ("auto", best)}
    both_met = all(r["met"] for name in ("auto", best) for r in measured[name])
    ratio = f"{seconds['auto'] / seconds[best]:.2f}" if both_met else "not known: a target was missed"
    print(f"{scene}: auto {in_words(measured['auto'])}, best {in_words(measured[best])} ({best}), ratio {ratio}", flush=True)
    for name, runs in sorted(measured.items(), key=lambda item: rank(item[1])):
        print(f"    {name}: {in_words(runs)}", flush=True)
    print(f"    {measured['auto'][0]['reason']}", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("scenes", nargs="+")
    parser.add_argument("--seeds", nargs="+", type=int, default=[1, 2, 3])
    parser.add_argument("--target", type=float, default=0.02)
    parser.add_argument("--cap", type=float, default=60, help="CPU seconds a run may take")
    options = parser.parse_args()
    for scene in options.scenes:
        measure(options.program, scene, options)


if __name__ == "__main__":
    main()
