"""The commands of README.md and docs/guide.md, for the tests that run them. CONTRIBUTING.md says how pages mark them."""

import re
import subprocess
from dataclasses import dataclass

BLOCK = re.compile(r"^```(?P<tag>.*)\n(?P<text>(?:.*\n)*?)```$", re.MULTILINE)
NOT_RUN = re.compile(r"sh \(not run: .+\)")
COMMAND = re.compile(r"^(?:\$ |\./|sudo |cmake |photic |python3? )", re.MULTILINE)


@dataclass
class Commands:
    line: int  # of the page, where the first one stands
    text: str


def commands_to_run(page):
    """The blocks tagged `sh`. Commands in a block whose tag says nothing about them are an error: nobody would see them rot."""
    source = page.read_text()
    found, unmarked = [], []
    for block in BLOCK.finditer(source):
        line = source.count("\n", 0, block.start("text")) + 1
        if block["tag"] == "sh":
            found.append(Commands(line, block["text"]))
        elif not NOT_RUN.fullmatch(block["tag"]) and (block["tag"].startswith("sh") or COMMAND.search(block["text"])):
            unmarked.append(f"{page.name}:{line}: commands in a block tagged '{block['tag']}'")
    if unmarked:
        raise ValueError("\n".join([*unmarked, "Write ```sh, and they are run, or ```sh (not run: reason)"]))
    return found


def run_all(page, folder, environment):
    """Runs the page's commands in one shell, in order, until one fails; its standard error names each with its line."""
    script = "".join(f": {page.name}:{commands.line}\n{commands.text}" for commands in commands_to_run(page))
    return subprocess.run(
        ["bash", "-euxo", "pipefail", "-c", script],
        cwd=folder, env=environment, stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=200, check=False,
    )
