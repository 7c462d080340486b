"""experiments/starters.py: no starter ends with a gate that more photons do not bring to its target, and its table."""

import re
import subprocess
import sys

import pytest
from conftest import SOURCE

sys.path.insert(0, str(SOURCE / "experiments"))
import starters  # noqa: E402
from measure.program import Failed  # noqa: E402
from starters import Channel, Gate, Run  # noqa: E402


@pytest.mark.parametrize("kind", starters.echo_scenes())
def test_more_photons_mend_every_gate_of_a_starter(kind):
    # Short runs; the script runs starters whole. Seen red (oil-spill): with beam_missed raised whatever walks carry.
    one = starters.run(kind, ["--photons", "3.2e4", "--max-time", "60s", "--threads", "1"])
    assert (one.kind, one.stuck) == (kind, [])
    assert one.photons == 3.2e4 or one.stopped_by == "target"
    assert one.gates > 10 and one.left < one.gates


def gate(number, error, *flags, target=0.02):
    return Gate(number, number + 0.5, error, list(flags), error <= target)


def made_up(*channels, stopped_by="time", target=0.02):
    return Run("ship", list(channels), target, stopped_by, "bidirectional", 1.25e6, 60.04)


def test_a_gate_is_stuck_whose_flag_stays():
    # Seen red: without the look at the error; with few_batches among what stays.
    assert made_up(Channel("elastic", 9, [gate(1, 0.03, "beam_missed")])).stuck == []
    assert made_up(Channel("elastic", 9, [gate(1, 0.01, "heavy_tail"), gate(2, 0.01, "few_batches")])).stuck == []
    known = gate(3, 0.01, "heavy_tail", "beam_missed")
    assert made_up(Channel("raman", 9, [known])).stuck == [("raman", known)]


def test_the_rows_of_the_table():
    # Seen red: with ranges that go on over gaps; with errors of all channels in each sentence.
    assert starters.row(made_up(Channel("elastic", 25, []), stopped_by="target", target=None)) == [
        "ship", "bidirectional", "target, 60 s, 1.2e6 photons", "10 % (none in the scene)", "25 of 25", "none",
    ]
    left = [gate(20, 0.03), gate(21, 0.031), gate(23, 0.06), gate(24, 0.12, "large_error")]
    one = made_up(Channel("elastic", 25, []), Channel("raman", 25, left), Channel("oil", 5, [gate(24, 1.84, "large_error")]))
    assert starters.row(one)[4:] == [
        "50 of 55; raman 21 of 25, oil 4 of 5",
        "raman, 20.5 to 21.5, 23.5 m: above the target: the time ended the run first (errors 3 to 6 %); "
        "raman, 24.5 m; oil, 24.5 m: few photons come back from there (errors 12 to 184 %)",
    ]
    filters = [Channel(f"filter {n}", 3, [gate(n, 0.01, "heavy_tail")]) for n in range(8)]
    assert starters.row(made_up(Channel("oil", 3, []), *filters))[4:] == [
        "19 of 27; all of them in 1 of 9 channels",
        "8 channels, 8 gates from 0.5 to 7.5 m: `heavy_tail`: rare large scores may be missing (errors 1 %)",
    ]


def test_the_table_goes_between_its_markers(tmp_path):
    # Seen red: with what follows the table lost.
    page = tmp_path / "accuracy.md"
    page.write_text("before\n<!-- measured: starters -->\nold\n<!-- end -->\nbehind\n")
    starters.write([made_up(Channel("elastic", 25, []))], "experiments/starters.py --write", page)
    lines = page.read_text().splitlines()
    assert lines[:3] == ["before", "<!-- measured: starters -->", "| " + " | ".join(starters.HEAD) + " |"]
    assert lines[4].startswith("| ship | bidirectional | time, 60 s, 1.2e6 photons | 2 % | 25 of 25 | none |")
    assert re.fullmatch(r"`experiments/starters.py --write` wrote this table. On .*, commit [0-9a-f]{12}\b.*", lines[6])
    assert lines[7:] == ["<!-- end -->", "behind"]
    page.write_text("no markers\n")
    with pytest.raises(Failed, match="accuracy.md: 0 places between"):
        starters.write([], "", page)


def test_a_table_of_some_starters_is_refused():
    done = subprocess.run([sys.executable, starters.__file__, "--write", "ship"], capture_output=True, text=True, check=False)
    assert done.returncode == 2
    assert "--write takes no KIND: the table has all of them" in done.stderr
