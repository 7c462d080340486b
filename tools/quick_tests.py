#!/usr/bin/env python3
"""The tests that a change asks for: of the folders that it is in, and of the floors above that include them.

usage: quick_tests.py [FOLDER...]; folders as src/tally, tests/unit/tally or tally; without any, those changed since HEAD.
Prints two lines: the targets to build, and a regular expression of the labels of the tests.
"""

import subprocess
import sys
from pathlib import Path

from check_include_order import FLOORS, INCLUDE

ROOT = Path(__file__).resolve().parent.parent
KINDS = ["statistical", "analytic", "validation", "cli", "python"]  # in tests/, besides unit
PROGRAMS = {"cli": ["photic", "photic_python"], "python": ["photic", "photic_python", "make_sample_result"]}


def changed_files() -> list[str]:
    def lines(*command: str) -> list[str]:
        return subprocess.run(["git", *command], cwd=ROOT, capture_output=True, text=True, check=True).stdout.splitlines()

    return lines("diff", "--name-only", "HEAD") + lines("ls-files", "--others", "--exclude-standard")


def label_of(path: str) -> str | None:
    """The label of the tests of a file or folder; None if it has none."""
    parts = Path(path).parts
    if parts[:1] == ("apps",) or parts[:1] == ("scenes",):
        return "cli"
    if parts[:1] == ("python",):
        return "python"
    if parts[:1] == ("tests",):
        parts = parts[1:]
        if parts[:1] == ("unit",):
            parts = parts[1:]
    elif parts[:1] == ("src",):
        parts = parts[1:]
    name = parts[0] if parts else ""
    if name in KINDS:
        return name
    return f"unit/{name}" if name in FLOORS else None


def floors_above(floor: str) -> list[str]:
    """The floor, and those that include it, directly or by way of others."""
    includes = {name: set() for name in FLOORS}
    for path in (ROOT / "src").rglob("*.[hc]pp"):
        for line in path.read_text().splitlines():
            found = INCLUDE.match(line)
            if found and found[1] == '"':
                includes[path.relative_to(ROOT / "src").parts[0]].add(found[2].split("/")[0])
    reached = {floor}
    for name in FLOORS:  # lowest first: what a floor includes has been seen
        if includes[name] & reached:
            reached.add(name)
    return [name for name in FLOORS if name in reached]


def main() -> int:
    labels = []
    for path in sys.argv[1:] or changed_files():
        label = label_of(path)
        if label is None and sys.argv[1:]:
            print(f"{path}: no folder with tests of its own (one of {', '.join([*FLOORS, *KINDS])})", file=sys.stderr)
            return 2
        if label and label.startswith("unit/") and not path.startswith("tests/"):
            labels += [f"unit/{floor}" for floor in floors_above(label.removeprefix("unit/"))]
        elif label:
            labels.append(label)
    labels = [label for label in dict.fromkeys(labels) if (ROOT / "tests" / label).is_dir()]
    targets = [f"tests/{label}/all" for label in labels] + [program for kind in PROGRAMS if kind in labels for program in PROGRAMS[kind]]
    print(" ".join(dict.fromkeys(targets)))
    print(f"^({'|'.join(labels)})$")
    return 0


if __name__ == "__main__":
    sys.exit(main())
