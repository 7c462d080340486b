"""Programs on a terminal of a given width."""

import fcntl
import os
import pty
import re
import struct
import subprocess
import termios

COLOUR = re.compile(r"\x1b\[[0-9;]*m")


def on_a_terminal(command, columns=80, environment=(), **options):
    """The exit code of a command, and what a terminal gets of its output and errors together."""
    ours, theirs = pty.openpty()
    fcntl.ioctl(theirs, termios.TIOCSWINSZ, struct.pack("HHHH", 24, columns, 0, 0))
    kept = {name: value for name, value in os.environ.items() if name != "NO_COLOR"}
    env = kept | {"TERM": "xterm"} | dict(environment)
    process = subprocess.Popen(
        [str(word) for word in command], stdin=subprocess.DEVNULL, stdout=theirs, stderr=theirs, env=env, **options
    )
    os.close(theirs)
    output = b""
    try:
        while chunk := os.read(ours, 4096):
            output += chunk
    except OSError:  # EIO: the program is gone
        pass
    os.close(ours)
    return process.wait(timeout=60), output.decode().replace("\r\n", "\n")


def without_colour(text):
    return COLOUR.sub("", text)


def lines_shown(text):
    """The lines as they were shown at any time: what is drawn over counts too."""
    return [part.replace("\x1b[K", "") for line in without_colour(text).split("\n") for part in line.split("\r")]
