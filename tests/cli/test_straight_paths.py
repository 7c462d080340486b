"""Straight pieces of paths: their optical depths and times are worked out on one page, src/geometry/segment.hpp."""

import re

from conftest import SOURCE

ELSEWHERE = re.compile(r"\bslant_\w*|\b\w*optical_depth\(|\bair_delay\w*\(|gather<T>\(\w*\.?sea_?\.group_index")


def test_optical_depths_and_times_are_on_one_page():
    # Seen red: with the time of an edge in connect_vertices.hpp worked out from group_index, and an optical depth in cross.hpp.
    assert ELSEWHERE.search((SOURCE / "src/geometry/segment.hpp").read_text())
    for folder in ("transport", "estimator"):
        for path in sorted((SOURCE / "src" / folder).rglob("*.hpp")):
            if path.name != "flight.hpp":  # which moves photons
                assert not ELSEWHERE.findall(path.read_text()), path
