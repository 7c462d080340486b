"""README: short, and what it shows is what a run prints."""

import re
from pathlib import Path

README = (Path(__file__).resolve().parents[2] / "README.md").read_text(encoding="utf-8")


def test_is_short():
    assert len(README.split()) < 700
    cells = [cell.strip() for line in README.splitlines() if line.startswith("|") for cell in line.split("|")]
    assert max(map(len, cells)) <= 60, max(cells, key=len)


def test_the_scene_prints_the_table_beside_it(photic, tmp_path):
    # Seen red: with another depth of the last gate; with a digit of an echo changed.
    toml, table = re.findall(r"^```(?:toml)?\n(.*?)^```$", README[README.index("```toml") :], re.DOTALL | re.MULTILINE)[:2]
    assert len(toml.splitlines()) == 12
    (tmp_path / "my.toml").write_text(toml)
    done = photic("run", "my.toml")
    assert done.returncode == 0, done.stderr
    assert table in done.stdout
