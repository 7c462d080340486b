"""docs/architecture.md and CONTRIBUTING.md name what is there: files, folders, identifiers, tests, floors."""

import re
import subprocess
import sys

import pytest
from conftest import SOURCE

PAGES = ["docs/architecture.md", "CONTRIBUTING.md"]
FOLDERS = ["src", "apps", "tests", "python", "tools", "benchmarks", "experiments", "cmake", "docs"]
FILES = ["CMakePresets.json", "test"]  # of the root, which are read for identifiers
ENDINGS = {".hpp", ".cpp", ".in", ".py", ".txt", ".cmake", ".json", ".bib", ""}
LONGEST_LINE = 120
PLACEHOLDERS = r"NAME|FILE|OLD|NEW|…|\*"


def prose_of(page):
    """Without blocks of code."""
    return re.sub(r"^```.*?^```$", "", (SOURCE / page).read_text(encoding="utf-8"), flags=re.MULTILINE | re.DOTALL)


def quoted_in(page):
    return [text for text in re.findall(r"(?<!`)`([^`\n]+)`(?!`)", prose_of(page)) if not re.search(PLACEHOLDERS, text)]


def is_path(text):
    return re.fullmatch(r"[\w./-]+", text) is not None and ("/" in text or re.search(r"\w\.(hpp|cpp|py|md|txt|toml|json)$", text))


def is_there(path, page):
    """From the root, from src/ as includes are, or beside the page; a file of a folder that the same line names, alone."""
    return any((root / path).exists() for root in (SOURCE, SOURCE / "src", (SOURCE / page).parent))


def paths_of(page):
    """Paths in backquotes. A name alone is a file of one of the folders that its item names."""
    for item in re.split(r"\n(?=\d+\. |- |#)|\n\n", prose_of(page)):
        quoted = [text for text in re.findall(r"(?<!`)`([^`\n]+)`(?!`)", item) if not re.search(PLACEHOLDERS, text)]
        paths = [text for text in quoted if is_path(text)]
        folders = {path.rpartition("/")[0] for path in paths if "/" in path} | {path for path in paths if "." not in path}
        for path in paths:
            yield path, [path] if "/" in path else [path, *(f"{folder}/{path}" for folder in folders)]


@pytest.fixture(scope="module")
def words():
    """Every word of the tree but of the pages themselves and of this file."""
    files = [path for folder in FOLDERS for path in (SOURCE / folder).rglob("*") if path.is_file() and path.suffix in ENDINGS]
    files += [SOURCE / name for name in FILES]
    mine = {SOURCE / page for page in PAGES} | {SOURCE / "tests/cli/test_pages.py"}
    found = set()
    for path in files:
        if path not in mine:
            found.update(re.findall(r"\w+", path.read_text(encoding="utf-8", errors="ignore")))
    return found


@pytest.mark.parametrize("page", PAGES)
def test_every_path_is_there(page):
    # Seen red: with estimator/events.hpp; with robust_test.cpp alone.
    paths = list(paths_of(page))
    assert len(paths) > 20
    assert [path for path, places in paths if not any(is_there(place, page) for place in places)] == []


@pytest.mark.parametrize("page", PAGES)
def test_every_link_leads_somewhere(page):
    # Seen red: with theories.md.
    links = re.findall(r"\]\(([^)#\s]+)\)", prose_of(page))
    assert links
    assert [link for link in links if "://" not in link and not ((SOURCE / page).parent / link).exists()] == []


@pytest.mark.parametrize("page", PAGES)
def test_every_identifier_is_there(page, words):
    # Seen red: with `make_worlds`; with `Fly.GoesAsFar`.
    named = [text for text in quoted_in(page) if re.fullmatch(r"[A-Za-z_][\w.:]*(\(.*\))?", text) and not is_path(text)]
    assert len(named) > 20
    parts = {text: re.findall(r"[A-Za-z_]\w*", text.split("(")[0]) for text in named}
    assert [text for text, needed in parts.items() if not set(needed) <= words] == []


def test_the_floors_are_drawn_in_their_order():
    # Seen red: with a floor that is none.
    code = "import check_include_order as c; print(*c.FLOORS)"
    output = subprocess.run([sys.executable, "-B", "-c", code], cwd=SOURCE / "tools", capture_output=True, text=True, check=True)
    drawing = re.search(r"^```\n(.*?)^```$", (SOURCE / PAGES[0]).read_text(encoding="utf-8"), re.MULTILINE | re.DOTALL)[1]
    drawn = re.findall(r"^  (\w+) ", drawing, re.MULTILINE)
    assert drawn[::-1] == output.stdout.split()


@pytest.mark.parametrize("page", PAGES)
def test_no_line_is_too_long(page):
    # Seen red: with a line made too long.
    lines = enumerate((SOURCE / page).read_text(encoding="utf-8").splitlines(), start=1)
    assert [(number, len(line)) for number, line in lines if len(line) > LONGEST_LINE] == []
