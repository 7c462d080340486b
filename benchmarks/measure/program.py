"""The program, run as a user would type it, in a folder of its own."""

import json
import os
import re
import shlex
import shutil
import subprocess
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


def echo_scenes():
    """The scenes that `photic new` writes and that have echoes."""
    return sorted(path.stem for path in (ROOT / "scenes").glob("*.toml") if "[[telescope]]" in path.read_text())


LEAST = {"forward": 240_000, "bidirectional": 60_000}  # thirty batches: with fewer no gate counts as converged


class Failed(Exception):
    """A run that did not end as it should, or a number that cannot be formed."""


def find_program():
    program = os.environ.get("PHOTIC_PROGRAM") or str(ROOT / "build/release/apps/photic/photic")
    return os.path.abspath(program) if os.sep in program else program


class Runner:
    """Runs commands and remembers them. `reduced` asks for as little work as shows whether a measurement works at all;
    `known` are results of earlier runs by their arguments, which measurements may share."""

    def __init__(self, program, reduced=False, known=None):
        self.program = program
        self.reduced = reduced
        self.commands = []
        self.known = {} if known is None else known

    # How much work: a full run's number, or what a reduced one makes of it.
    def photons(self, count, estimator="forward"):
        count = max(LEAST[estimator], count / 25) if self.reduced else count
        return f"{count:g}".replace("e+0", "e")

    def seeds(self, count):
        return range(1, 1 + (3 if self.reduced else count))

    def choose(self, full, reduced):
        return reduced if self.reduced else full

    def timed(self, *arguments):
        """Runs `photic ARGUMENTS --json`: what it prints, with wall_s, cpu_s (user and system) and file_bytes of the result."""
        self.commands.append(shlex.join(["photic", *map(str, arguments)]))
        return self._run([*map(str, arguments), "--json"])

    def result(self, *arguments):
        """The same where time does not matter: remembered."""
        return self.results([arguments])[0]

    def results(self, many):
        """Many such runs, as many at a time as there are cores, each on one thread: no result depends on it."""
        many = [tuple(map(str, arguments)) for arguments in many]
        self.commands += [shlex.join(["photic", *words]) for words in many]
        new = [words for words in dict.fromkeys(many) if words not in self.known]
        options = ("--json",) if len(new) == 1 else ("--threads", "1", "--json")
        with ThreadPoolExecutor(os.cpu_count()) as pool:
            for words, result in zip(new, pool.map(lambda words: self._run((*words, *options)), new)):
                self.known[words] = result
        return [self.known[words] for words in many]

    def _run(self, words):
        with tempfile.TemporaryDirectory() as folder:
            for shared in ("scenes", "experiments"):
                os.symlink(ROOT / shared, Path(folder) / shared)
            with open(Path(folder) / "out", "w+") as out, open(Path(folder) / "errors", "w+") as errors:
                start = time.monotonic()
                process = subprocess.Popen(
                    [self.program, *words], cwd=folder, stdin=subprocess.DEVNULL, stdout=out, stderr=errors
                )
                try:
                    _, status, usage = os.wait4(process.pid, 0)
                except BaseException:
                    process.kill()
                    process.wait()
                    raise
                wall_s = time.monotonic() - start
                process.returncode = os.waitstatus_to_exitcode(status)
                out.seek(0)
                errors.seek(0)
                if process.returncode != 0:
                    message = " ".join(errors.read().split()) or "no message"
                    raise Failed(f"{shlex.join(['photic', *words])}: exit code {process.returncode}: {message}")
                result = json.load(out)
            file_bytes = sum(path.stat().st_size for path in Path(folder).glob("*.nc"))
        return result | {"wall_s": wall_s, "cpu_s": usage.ru_utime + usage.ru_stime, "file_bytes": file_bytes}

    def version(self):
        done = subprocess.run([self.program, "--version"], capture_output=True, text=True, check=False)
        if done.returncode != 0:
            raise Failed(f"{self.program} --version: exit code {done.returncode}")
        return done.stdout.strip()


def check_program(program):
    if shutil.which(program) is None:
        raise Failed(f"{program}: no such program (build it: cmake --preset release && cmake --build --preset release)")


def typed(commands):
    """Commands for a reader: those that differ in their seed alone are one line, with all its seeds; each once."""
    seeds = {}
    for command in commands:
        found = re.search(r" --seed (\d+)", command)
        frame = command if found is None else command.replace(found.group(), " --seed {}")
        of_it = seeds.setdefault(frame, [])
        if found is not None and int(found.group(1)) not in of_it:
            of_it.append(int(found.group(1)))
    return [frame.replace("{}", str(of_it[0])) + more(of_it) if of_it else frame for frame, of_it in seeds.items()]


def more(seeds):
    return f"   # and so on to --seed {seeds[-1]}" if len(seeds) > 1 else ""
