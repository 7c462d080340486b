"""The commands of README.md, docs/guide.md and docs/howto, for the tests that run them. CONTRIBUTING.md says how pages mark them."""

import re
import subprocess
from dataclasses import dataclass

BLOCK = re.compile(r"^```(?P<tag>.*)\n(?P<text>(?:.*\n)*?)```$", re.MULTILINE)
NOT_RUN = re.compile(r"(sh|console) \(not run: .+\)")


@dataclass
class Commands:
    line: int  # of the page, where the first one stands
    text: str


def commands_to_run(page):
    """The blocks tagged `sh`, and the lines of those tagged `console` that begin with "$ "."""
    source = page.read_text()
    found = []
    for block in BLOCK.finditer(source):
        tag, text = block["tag"], block["text"]
        line = source.count("\n", 0, block.start("text")) + 1
        if tag == "console":
            text = "".join(re.findall(r"^\$ (.*\n)", text, re.MULTILINE))
        if tag in ("sh", "console"):
            found.append(Commands(line, text))
        elif tag.startswith(("sh", "bash", "console")) and not NOT_RUN.fullmatch(tag):
            raise ValueError(f"{page.name}:{line}: '{tag}' (write ```sh, or ```sh (not run: reason))")
    return found


def run_all(page, folder, environment):
    """Runs the page's commands in one shell, in order, until one fails; its standard error names each with its line."""
    script = "".join(f": {page.name}:{commands.line}\n{commands.text}" for commands in commands_to_run(page))
    return subprocess.run(
        ["bash", "-euxo", "pipefail", "-c", script],
        cwd=folder, env=environment, stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=200, check=False,
    )
