"""The keys in docs/guide.md are those of the schema, with the same defaults."""

import json
import re

import pytest
from conftest import SOURCE

# The headings of the guide, and the sections of a scene whose keys stand under them.
SECTIONS = {
    "`[source]`": ["source"],
    "`[[telescope]]`": ["telescope"],
    "`[[channel]]`": ["channel"],
    "`[[tally]]`": ["tally"],
    "`[optics]`": ["optics"],
    "`[sea]` and `[[sea.layer]]`": ["sea", "sea.layer", "sea.layer.iop", "sea.surface"],
    "`[[sea.column]]`": ["sea.column"],
    "`[bottom]`": ["bottom"],
    "`[oil]`": ["oil"],
    "`[atmosphere]`": ["atmosphere", "atmosphere.layer", "atmosphere.layer.iop", "atmosphere.surface"],
    "`[gates]`": ["gates"],
    "`[simulation]`": ["simulation"],
    "`[simulation.tools]`": ["simulation.tools", "simulation.tools.importance"],
    "`[[environment]]`": ["environment"],
}
# Elsewhere: where the guide describes what has no table of its own.
DEFINITIONS = {"phase_function": "`[sea]` and `[[sea.layer]]`", "profile": "`[sea]` and `[[sea.layer]]`"}
LONGEST_LINE = 100
TOP = ["title", "sensitivity", "environment_grid"]


def split_by_heading(text):
    """The text below each heading of the third level, up to the next of it or of a higher one."""
    out = {}
    for part in re.split(r"^### ", text, flags=re.MULTILINE)[1:]:
        heading, body = part.split("\n", 1)
        out[heading.split(":")[0].removesuffix(" (optional)")] = re.split(r"^## ", body, flags=re.MULTILINE)[0]
    return out


@pytest.fixture(scope="module")
def guide():
    return split_by_heading((SOURCE / "docs/guide.md").read_text())


@pytest.fixture
def schema(photic):
    return json.loads(photic("schema").stdout)


def properties_of(schema, path):
    for key in path.split("."):
        schema = schema["properties"][key]
        schema = schema.get("items", schema)
        tables = [way for way in schema.get("anyOf", []) if "properties" in way]  # of a table, or a word in its place
        schema = tables[0] if tables else schema
    return schema["properties"]


def properties_under(schema, heading, header="key"):
    """Those of the section that the header of a table names, or of all under the heading, less sections."""
    named = re.search(r"\[([a-z.]+)\]", header)
    paths = [named[1]] if named else SECTIONS[heading]
    found = {f"{path}.{key}": value for path in paths for key, value in properties_of(schema, path).items()}
    sections = {path for paths in SECTIONS.values() for path in paths} - {"sea.layer.iop", "sea.surface", "atmosphere.layer.iop"}
    sections -= {"simulation.tools.importance", "atmosphere.surface"}
    return {path.split(".")[-1]: value for path, value in found.items() if path not in sections}


def keys_in(cell):
    return re.findall(r"`([a-z][a-z0-9_]*)(?:`| = )", cell)


def is_mentioned(key, text):
    """In backquotes, alone or with a value, or in an example of TOML."""
    return re.search(rf"(?:`(?:\[+ ?\{{ )?|^|[{{,] ?){key}(?:`| = )", text, flags=re.MULTILINE) is not None


def tables_of_keys(body):
    """The rows of all tables whose first column has keys: (header, keys, cells by header)."""
    for table in re.findall(r"(?:^\|.*\n)+", body, flags=re.MULTILINE):
        head, _, *rows = [[cell.strip() for cell in re.split(r"(?<!\\)\|", line)[1:-1]] for line in table.splitlines()]
        if not head[0].startswith("key"):
            continue
        for row in rows:
            yield head[0], keys_in(row[0]), dict(zip(head, row, strict=True))


def literal(text):
    """The value that a default in the guide stands for; None if it is given in words."""
    text = text.strip().strip("`")
    if re.fullmatch(r'"[^"]*"|true|false|\[[0-9, ]+\]', text) or re.fullmatch(r"-?[0-9.]+(e-?[0-9]+)?", text):
        return json.loads(text)
    return None


def test_the_headings_are_there(guide):
    assert set(SECTIONS) <= set(guide)


def test_no_line_of_the_guide_is_longer_than_a_screen():
    # Seen red: with a line made too long.
    lines = enumerate((SOURCE / "docs/guide.md").read_text().splitlines(), start=1)
    assert [(number, len(line)) for number, line in lines if len(line) > LONGEST_LINE] == []


def test_every_link_within_the_guide_leads_to_a_heading():
    # Seen red: with `#flag` for `#flags`.
    text = re.sub(r"^```.*?^```$", "", (SOURCE / "docs/guide.md").read_text(), flags=re.MULTILINE | re.DOTALL)
    headings = [re.sub(r"[^\w\- ]", "", line).lower() for line in re.findall(r"^#+ (.*)$", text, flags=re.MULTILINE)]
    anchors = {heading.replace(" ", "-") for heading in headings}
    links = re.findall(r"\]\(#([^)]*)\)", text)
    assert links
    assert [link for link in links if link not in anchors] == []


@pytest.mark.parametrize("heading", SECTIONS)
def test_every_key_is_in_the_guide(schema, guide, heading):
    # Seen red: without the row of `max_order`.
    missing = [key for key in properties_under(schema, heading) if not is_mentioned(key, guide[heading])]
    assert missing == []


def test_every_key_of_phase_functions_and_profiles_is_in_the_guide(schema, guide):
    for name, heading in DEFINITIONS.items():
        definition = schema["$defs"][name]
        for form in definition.get("anyOf", [definition]):
            missing = [key for key in form["properties"] if not is_mentioned(key, guide[heading])]
            assert missing == [], name


def test_every_key_at_the_top_is_in_the_guide(schema):
    text = (SOURCE / "docs/guide.md").read_text()
    assert [key for key in TOP if f"`{key}`" not in text and f"`[{key}]`" not in text] == []
    sections = {path.split(".")[0] for paths in SECTIONS.values() for path in paths}
    assert set(schema["properties"]) == sections | set(TOP)


@pytest.mark.parametrize("heading", SECTIONS)
def test_every_key_of_the_guides_tables_exists(schema, guide, heading):
    # Seen red: with `max_orders` in the guide.
    profiles = [key for form in schema["$defs"]["profile"]["anyOf"] for key in form["properties"]]
    rows = list(tables_of_keys(guide[heading]))
    assert rows, heading
    for header, keys, cells in rows:
        known = profiles if "of" in cells else properties_under(schema, heading, header)
        assert keys, heading
        assert [key for key in keys if key not in known] == []


def default_cell(cells):
    (column,) = [head for head in cells if "default" in head] or [None]
    return cells.get(column)


@pytest.mark.parametrize("heading", SECTIONS)
def test_defaults_agree(schema, guide, heading):
    # Seen red: with 101 for the default of `meetings`; with the default of `walks` in words; with true for `slick`.
    counted = 0
    for header, keys, cells in tables_of_keys(guide[heading]):
        properties = properties_under(schema, heading, header)
        cell = default_cell(cells)
        if cell is None:
            continue
        values = cell.split(", ") if len(cell.split(", ")) == len(keys) else [cell] * len(keys)
        for key, value in zip(keys, values, strict=True):
            default = properties.get(key, {}).get("default")
            if isinstance(default, str):
                assert value.strip("`\"") == default, key
            else:
                assert literal(value) == default, key
            counted += default is not None
    assert counted > 0 or heading in {"`[bottom]`", "`[[sea.column]]`", "`[gates]`", "`[[environment]]`"}
