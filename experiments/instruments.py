#!/usr/bin/python3
"""The cost of the scenes of scenes/ in multiples of R, the CPU time of peaked water to 40 m.

    experiments/instruments.py                        # all of them
    experiments/instruments.py rov spaceborne         # some
    experiments/instruments.py --whole                # each as it is, on two threads: time, gates, flags
    experiments/instruments.py -o instruments.json    # the raw numbers as well

The program is that of PHOTIC_PROGRAM, or build/release/apps/photic/photic. `benchmarks/measure.py run --only instruments --only
first-runs` measures the same for docs/benchmarks.md.
"""

import argparse
import json
import sys
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "benchmarks"))

from measure import instruments  # noqa: E402
from measure.program import Failed, Runner, check_program, find_program  # noqa: E402
from measure.stamp import stamp  # noqa: E402


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scene", nargs="*", metavar="SCENE", help=f"default: all ({', '.join(instruments.scenes())})")
    parser.add_argument("--whole", action="store_true", help="as a user runs it: two threads, its own target and limit")
    parser.add_argument("-o", "--output", type=Path, help="a JSON file for the raw numbers")
    asked = parser.parse_args()
    for scene in asked.scene:
        if scene not in instruments.scenes():
            parser.error(f"there is no scenes/{scene}.toml (choose from: {', '.join(instruments.scenes())})")
    costs, first_runs = instruments.MEASUREMENTS
    measurement = first_runs if asked.whole else costs
    try:
        check_program(find_program())
        runner = Runner(find_program())
        raw = measurement.measure(runner, asked.scene)
    except Failed as failure:
        print(f"instruments.py: {failure}", file=sys.stderr)
        return 2
    for row in measurement.rows(raw):
        print(f"{row.what:18} {row.measured}")
    if asked.output:
        results = {"stamp": stamp(Runner(find_program())), "commands": runner.commands, measurement.name: raw}
        asked.output.write_text(json.dumps(results) + "\n")
    return 0


if __name__ == "__main__":
    sys.exit(main())
