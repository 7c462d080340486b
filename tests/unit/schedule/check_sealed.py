"""Looks at objects made for one instruction set (cmake/photic.cmake): no symbol but their entry is seen by the linker,
and nothing in them runs before main.

Seen red: with an object as the compiler makes it.

usage: check_sealed.py NM OBJDUMP ENTRY OBJECT...; exit code 1 if an object breaks the promise.
"""

import subprocess
import sys


def main() -> int:
    nm, objdump, entry, *objects = sys.argv[1:]
    wrong = [] if objects else ["no objects"]
    for path in objects:
        symbols = subprocess.run([nm, "--defined-only", "--extern-only", path], capture_output=True, text=True, check=True)
        names = [line.split()[-1] for line in symbols.stdout.splitlines() if line.strip()]
        wrong += [f"{path}: {name} is seen by the linker" for name in names if entry not in name]
        if not any(entry in name for name in names):
            wrong.append(f"{path}: has no {entry}")
        sections = subprocess.run([objdump, "-h", path], capture_output=True, text=True, check=True).stdout
        if ".init_array" in sections or ".ctors" in sections:
            wrong.append(f"{path}: something runs before main")
    print("\n".join(wrong) if wrong else f"{len(objects)} objects are sealed")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
