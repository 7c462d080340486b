"""README: short, and what it shows is what a run prints."""

import re
from pathlib import Path

README = (Path(__file__).resolve().parents[2] / "README.md").read_text(encoding="utf-8")


def test_is_short():
    assert len(README.split()) < 700
    cells = [cell.strip() for line in README.splitlines() if line.startswith("|") for cell in line.split("|")]
    assert max(map(len, cells)) <= 60, max(cells, key=len)


def unit_of(number):
    """The size of a number's last digit."""
    digits, _, power = number.partition("e")
    return 10.0 ** (int(power or 0) - len(digits.partition(".")[2]))


def test_the_scene_prints_the_table_beside_it(photic, tmp_path):
    """But for one unit of a last digit: instruction sets round otherwise."""
    # Seen red: with another depth of the last gate; with a digit of an echo, and of an error, changed by two.
    toml, table = re.findall(r"^```(?:toml)?\n(.*?)^```$", README[README.index("```toml") :], re.DOTALL | re.MULTILINE)[:2]
    assert len(toml.splitlines()) == 12
    (tmp_path / "my.toml").write_text(toml)
    done = photic("run", "my.toml")
    assert done.returncode == 0, done.stderr
    number = re.compile(r"[0-9.]+(?:e[-+][0-9]+)?")
    begin = done.stdout.index(table.splitlines()[0])
    printed = "\n".join(done.stdout[begin:].splitlines()[: len(table.splitlines())]) + "\n"
    assert number.sub("N", printed) == number.sub("N", table)
    for here, there in zip(number.findall(table), number.findall(printed), strict=True):
        assert abs(float(here) - float(there)) < 1.5 * unit_of(here), (here, there)
