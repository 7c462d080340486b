"""The program, machine and date of a measurement."""

import datetime
import os
import platform
import re
import shutil
import subprocess
from pathlib import Path

from measure.accuracy import isas_here
from measure.program import ROOT

WRITTEN = ("README.md", "docs/accuracy.md", "docs/benchmarks.md", "benchmarks/measured.json")  # by measure.py itself


def stamp(runner):
    here, _ = isas_here(runner)
    version = runner.version().splitlines()
    return {
        "reduced": runner.reduced,
        "date": datetime.date.today().isoformat(),
        "processor": processor(),
        "cores": os.cpu_count(),
        "instruction_sets": here,
        "version": version[0],
        "compiler": compiler(version, runner.program),
        "commit": git("rev-parse", "--short=12", "HEAD") or "none",
        "changed_since_commit": changed(),
        "program_older_than_sources": older_than_sources(runner.program),
    }


def differences(old, new):
    """The reason why two stamps' numbers cannot stand in one table."""
    return [f"{key} was {old.get(key)!r} and is {new[key]!r} now" for key in new if key != "date" and old.get(key) != new[key]]


def processor():
    try:
        lines = [line.partition(":") for line in Path("/proc/cpuinfo").read_text().splitlines()]
    except OSError:
        return platform.processor() or platform.machine()
    said = {key.strip(): value.strip() for key, _, value in reversed(lines)}
    if "model name" not in said:
        return platform.machine()
    return f"{said['model name']} (family {said.get('cpu family', '?')}, model {said.get('model', '?')})"


def compiler(version, program):
    """By the output of `photic --version`, or by the build folder that the program lies in."""
    for line in version[1:]:
        name, _, value = line.partition(":")
        if "compiler" in name.lower():
            return value.strip()
    for folder in Path(shutil.which(program)).resolve().parents:
        cache = folder / "CMakeCache.txt"
        if cache.exists():
            text = cache.read_text()
            path = re.search(r"^CMAKE_CXX_COMPILER:\w+=(.*)$", text, re.M).group(1)
            done = subprocess.run([path, "--version"], capture_output=True, text=True, check=False)
            build = re.search(r"^CMAKE_BUILD_TYPE:\w+=(.*)$", text, re.M)
            return f"{done.stdout.splitlines()[0] if done.stdout else path}, {build.group(1) if build else 'no build type'}"
    return "compiler not known"


def git(*words):
    done = subprocess.run(["git", "-C", ROOT, *words], capture_output=True, text=True, check=False)
    return done.stdout.rstrip("\n") if done.returncode == 0 else ""


def changed():
    """Returns whether files that git knows differ from the commit, other than those that are written here."""
    names = [line[3:] for line in git("status", "--porcelain", "--untracked-files=no").splitlines()]
    return any(name not in WRITTEN for name in names)


def older_than_sources(program):
    built = Path(shutil.which(program)).stat().st_mtime
    return any(path.stat().st_mtime > built for path in (ROOT / "src").rglob("*.?pp"))
