#!/usr/bin/env python3
"""Holds the house to its floors: a folder of src/ includes only itself and the folders below it, and each
third-party library stays in its own folder (docs/architecture.md). Estimators, the folders of src/estimator/, do not know each
other, and what stands beside their folders knows none of them. The floors are a library: they leave the process alone, which
belongs to the application, and keep no variables that the runs of a process would share.

usage: check_include_order.py [ROOT]; prints every violation as file:line: reason; exit code 1 if there is any.
"""

import re
import sys
from pathlib import Path

FLOORS = ["core", "optics", "scene", "medium", "surface", "geometry", "instrument", "transport", "tally", "lanes", "estimator", "schedule", "run", "io", "session"]
HOMES = {  # the head of a third-party include -> the folders that may use it
    "Random123/": ["core"],
    "toml++/": ["scene"],
    "netcdf": ["io"],
    "CLI/": ["apps"],
    "nlohmann/": ["scene", "io", "apps"],
}
OF_THE_PROCESS = {  # what only applications do -> why
    re.compile(r"\bf?printf\(|\bf?puts\(|\bputchar\(|\bperror\(|\bfmt::print\(|\bstd::(cout|cerr|clog)\b"): "prints",
    re.compile(r"\bstd::(exit|_Exit|quick_exit|abort|terminate)\(|(?<![\w:.])_?exit\("): "ends the process",
    re.compile(r"\bgetenv\("): "reads the environment",
    re.compile(r"\bset(locale|env)\(|\blocale::global\("): "changes the process",
    re.compile(r"\bthread_local\b|^\s+static (?!const\b|constexpr\b)[^()]*[;={]"): "has a variable that all runs would share",
}
MAY_SHARE = {"src/io/netcdf_lock.cpp"}  # netCDF is one for the process, and so is its lock
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')


def reason_against(folder: str, mark: str, header: str) -> str | None:
    """The reason why a file of `folder` (a floor, or apps) may not include the header; None if it may."""
    if mark == "<":
        for head, homes in HOMES.items():
            if header.startswith(head) and folder not in homes:
                return f"<{header}> belongs to {' and '.join(homes)} alone"
        return None
    first = header.split("/")[0]
    if folder == "apps":
        return None if first in FLOORS or first == "photic" else f'"{header}" is in no floor of src/'
    if first not in FLOORS or "/" not in header:
        return f'"{header}" must be named from src/, as "{folder}/..."'
    if FLOORS.index(first) > FLOORS.index(folder):
        return f"{folder} must not include {first}, which stands above it"
    return None


def reason_against_line(line: str) -> str | None:
    """The reason why no line of src/ may do this; None if it may."""
    code = line.split("//")[0]
    return next((f"{why}: that is for applications" for what, why in OF_THE_PROCESS.items() if what.search(code)), None)


def beside_estimators(folder: list[str]) -> list[str]:
    """A folder of tallies counts as the one that it is in: all estimators stand on them."""
    return folder[:1] if folder[:2] == ["estimator", "tallies"] else folder


def reason_against_estimator(folder: str, header: str) -> str | None:
    """The same of estimators: `folder`, of a file under src/, and the header's are estimator or estimator/NAME."""
    own, other = beside_estimators(folder.split("/")), beside_estimators(header.split("/")[:-1])
    if own[0] != "estimator" or other[:1] != ["estimator"] or len(other) < 2 or own == other:
        return None
    if other[1] == "variations" and len(own) > 1:  # environments and derivatives: below the estimators
        return None
    whose = own[1] if len(own) > 1 else "what all estimators stand on"
    return f"{whose} must not include {'/'.join(other)}"


def violations(root: Path) -> tuple[list[str], int]:
    found, files = [], 0
    for top in ("src", "apps"):
        for path in sorted((root / top).rglob("*")):
            if path.suffix not in {".hpp", ".cpp", ".inl"}:
                continue
            files += 1
            relative = path.relative_to(root)
            folder = relative.parts[1] if top == "src" else top
            if top == "src" and folder not in FLOORS:
                found.append(f"{relative}:1: src/{folder} is no floor of the house")
                continue
            for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), start=1):
                match = INCLUDE.match(line)
                reason = match and (reason_against(folder, *match.groups())
                                    or reason_against_estimator(relative.parent.as_posix()[len("src/"):], match[2]))
                if top == "src" and str(relative) not in MAY_SHARE:
                    reason = reason or reason_against_line(line)
                if reason:
                    found.append(f"{relative}:{number}: {reason}")
    return found, files


def main() -> int:
    root = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).resolve().parent.parent
    found, files = violations(root)
    if files == 0:
        found.append(f"{root}: no C++ files under src/ and apps/")
    print("\n".join(found) if found else f"{files} files keep the order of the floors")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
