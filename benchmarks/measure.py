#!/usr/bin/python3
"""Measures what Photic claims, and writes the pages that report it.

    benchmarks/measure.py run -o benchmarks/measured.json     # all of it: some 40 minutes on two idle cores
    benchmarks/measure.py run --only coverage --only slabs    # some of it, into measured.json here
    benchmarks/measure.py write benchmarks/measured.json      # docs/accuracy.md, docs/benchmarks.md, README's tables

Results are kept after each measurement: after an interruption the same command continues with what is missing.
The program is that of PHOTIC_PROGRAM, or build/release/apps/photic/photic.
"""

import argparse
import json
import os
import sys
import time
from pathlib import Path

sys.dont_write_bytecode = True

from measure import pages  # noqa: E402
from measure.program import ROOT, Failed, Runner, check_program, find_program, typed  # noqa: E402
from measure.stamp import differences, stamp  # noqa: E402


def main(arguments=None):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(dest="command", required=True)
    run = commands.add_parser("run", help="measure")
    names = [measurement.name for measurement in pages.ALL]
    run.add_argument("--only", action="append", choices=names, metavar="NAME", help=f"this one, again if it is there: {', '.join(names)}")
    run.add_argument("--quick", action="store_true", help="few photons and seeds, to try it out; marked as a reduced run")
    run.add_argument("-o", "--output", type=Path, default=Path("measured.json"), help="default: measured.json")
    write = commands.add_parser("write", help="write the pages")
    write.add_argument("results", type=Path)
    asked = parser.parse_args(arguments)
    try:
        return measure(asked) if asked.command == "run" else write_pages(asked.results)
    except Failed as failure:
        print(f"measure.py: {failure}", file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        print("\nmeasure.py: interrupted; the same command continues with what is missing", file=sys.stderr)
        return 130


def read(path):
    try:
        return json.loads(path.read_text())
    except (OSError, ValueError) as error:
        raise Failed(f"{path}: {error}") from error


def in_lines(results):
    """JSON with a line for the stamp and one for each measurement."""
    lines = [f"{json.dumps(name)}: {json.dumps(record)}" for name, record in results["measurements"].items()]
    rest = {key: value for key, value in results.items() if key != "measurements"}
    return json.dumps(rest)[:-1] + ', "measurements": {\n' + ",\n".join(lines) + "\n}}\n"


def keep(results, path):
    """Whole or not at all."""
    partial = path.with_name(path.name + ".partial")
    partial.write_text(in_lines(results))
    os.replace(partial, path)


def measure(asked):
    program = find_program()
    check_program(program)
    now = stamp(Runner(program, asked.quick))
    results = {"stamp": now, "measurements": {}}
    if asked.output.exists():
        results = read(asked.output)
        other = differences(results["stamp"], now)
        if other:
            raise Failed(f"{asked.output}: was not measured in the same way: {'; '.join(other)} (remove it, or give another -o)")
    done = results["measurements"]
    due = [m for m in pages.ALL if (m.name in asked.only if asked.only else "raw" not in done.get(m.name, {}))]
    known = {}
    start = time.monotonic()
    for place, measurement in enumerate(due, 1):
        print(f"{place:2} of {len(due)}  {measurement.name:16}", end="", flush=True)
        record, said = one(measurement, Runner(program, asked.quick, known))
        done[measurement.name] = record
        keep(results, asked.output)
        print(f"{record['seconds']:7.1f} s  {said}", flush=True)
    failed = [m.name for m in due if "failed" in done[m.name]]
    print(f"{len(due) - len(failed)} measured, {len(failed)} failed, {time.monotonic() - start:.0f} s: {asked.output}")
    return 1 if failed else 0


def one(measurement, runner):
    """The record of a measurement, and a word on it. Whatever goes wrong is recorded, and others go on."""
    start = time.monotonic()
    try:
        raw = json.loads(json.dumps(measurement.measure(runner)))
        rows = pages.judged(measurement, raw)
        record = {"raw": raw, "commands": typed(runner.commands)}
        missed = [f"{row.what}: {row.measured}, allowed {row.allowed}" for row in rows if not row.held]
        said = "; ".join(["NOT HELD", *missed]) if missed else f"{len(rows)} held" if rows else "done"
    except Exception as error:  # noqa: BLE001
        reason = str(error) if isinstance(error, Failed) else f"{type(error).__name__}: {error}"
        record, said = {"failed": reason}, f"FAILED: {reason}"
    return record | {"seconds": round(time.monotonic() - start, 1)}, said


def write_pages(path):
    results = read(path)
    readme = ROOT / "README.md"
    texts = pages.documents(results) | {"README.md": pages.readme(results, readme.read_text())}
    for name, text in texts.items():
        (ROOT / name).write_text(text)
        print(name)
    return 0


if __name__ == "__main__":
    sys.exit(main())
