"""The pages and the tables in the README, made of results: nothing in them is typed by hand."""

from measure import accuracy, instruments, intervals, marked, speed
from measure.kinds import Row
from measure.program import ROOT
from measure.readme import commit, speed_table, trust_table

PAGES = {
    "docs/accuracy.md": (
        "Accuracy",
        "What Photic claims about its echoes and error bars, what is allowed, and what was measured.",
        accuracy.MEASUREMENTS + intervals.MEASUREMENTS,
    ),
    "docs/benchmarks.md": (
        "Benchmarks",
        "How long things take. Compare ratios, not seconds: processors differ by a factor of two and more.",
        speed.MEASUREMENTS + instruments.MEASUREMENTS,
    ),
}
RESULTS = "benchmarks/measured.json"
STARTERS_PAGE = "docs/accuracy.md"
STARTERS = (
    "The scenes of `photic new`, run as they are: what ended each run, how many of the gates that light reaches met the scene's own target, "
    "and which did not. This section alone is written by [starters.py](../experiments/starters.py)."
)
ALL = accuracy.MEASUREMENTS + intervals.MEASUREMENTS + speed.MEASUREMENTS + instruments.MEASUREMENTS


def documents(results):
    """Text by the path of each page."""
    texts = {path: page(results, *of_page) for path, of_page in PAGES.items()}
    texts[STARTERS_PAGE] += starters()
    return texts


def readme(results, text):
    """The README with its tables written anew between their markers."""
    for name, table in (("trust", trust_table(results)), ("speed", speed_table(results))):
        text = marked.written("README.md", text, name, table)
    return text


def starters():
    """The section of the starters, with the table that experiments/starters.py wrote last."""
    table = marked.read(STARTERS_PAGE, (ROOT / STARTERS_PAGE).read_text(), "starters")
    return "\n".join([
        "", "## Starters", "", STARTERS, "", f"<!-- measured: starters -->\n{table}{marked.END}", "",
    ])


def page(results, title, intro, measurements):
    stamp = results["stamp"]
    reduced = " (reduced run)" if stamp["reduced"] else ""
    lines = [f"# {title}{reduced}", ""]
    if stamp["reduced"]:
        lines += ["**Reduced run**: few photons and seeds, to try out the measurements. Do not quote these numbers; "
                  "bounds may be missed by chance.", ""]
    lines += [
        "<!-- Written by benchmarks/measure.py write; changes go there. -->", "",
        intro + " Everything here is written by [measure.py](../benchmarks/measure.py) from runs that it makes:", "",
        "```", f"benchmarks/measure.py run -o {RESULTS}", f"benchmarks/measure.py write {RESULTS}", "```", "",
        *stamped(stamp),
    ]
    for measurement in measurements:
        lines += ["", *section(measurement, results["measurements"].get(measurement.name))]
    return "\n".join(lines) + "\n"


def stamped(stamp):
    version = stamp["version"] + (", built before the sources were last written" if stamp["program_older_than_sources"] else "")
    rows = {
        "processor": f"{stamp['processor']}, {stamp['cores']} cores",
        "instruction sets": ", ".join(stamp["instruction_sets"]),
        "compiler": stamp["compiler"], "program": version, "commit": commit(stamp), "date": stamp["date"],
    }
    return table(["measured on", ""], rows.items())


def section(measurement, record):
    lines = [f"## {measurement.title}", "", measurement.claim, ""]
    if record is None:
        return [*lines, "**Not measured.**"]
    if "failed" in record:
        return [*lines, f"**Not measured**: {cell(record['failed'])}"]
    rows = list(measurement.rows(record["raw"]))
    if any(row.allowed for row in rows):
        lines += table(["what", "allowed", "measured"], [(row.what, row.allowed, row.stated()) for row in rows])
    else:
        lines += table(["what", "measured"], [(row.what, row.stated()) for row in rows])
    lines += ["", measurement.how, "", f"`benchmarks/measure.py run --only {measurement.name}` runs:", ""]
    return [*lines, "```", *record["commands"], "```"]


def table(head, rows):
    lines = [head, ["---"] * len(head), *rows]
    return ["| " + " | ".join(cell(text) for text in line) + " |" for line in lines]


def cell(text):
    return text.replace("|", "\\|").replace("\n", " ")


def judged(measurement, raw) -> list[Row]:
    return [row for row in measurement.rows(raw) if row.held is not None]
