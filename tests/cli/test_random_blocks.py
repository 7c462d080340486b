"""Random numbers: all blocks and streams are on one page, src/estimator/random_blocks.hpp, whose assertions hold them apart."""

import re
import subprocess

from conftest import SOURCE

PAGE = SOURCE / "src/estimator/random_blocks.hpp"
DEFINED = re.compile(r"^\s*(?:inline |static )*constexpr\b[^=;{]*\b(\w*(?:_blocks?|_stream))\b\s*(?:=|\{)", re.M)
BY_NUMBER = re.compile(r"\b(?:uniforms\([^()]*(?:\([^()]*\)[^()]*)*|together\([^()]*), \d+\)")
# Numbers of blocks of points, and of sizes of spheres.
COUNTS = {"quasi_random_blocks", "size_blocks"}


def sources():
    return [path for path in sorted((SOURCE / "src").rglob("*.[hc]pp")) if path != PAGE]


def test_no_block_or_stream_is_defined_elsewhere():
    # Seen red: with a block in forward/passing.hpp, and one asked for by a number.
    assert len(DEFINED.findall(PAGE.read_text())) > 15
    for path in sources():
        text = path.read_text()
        assert set(DEFINED.findall(text)) <= COUNTS, path
        assert not BY_NUMBER.findall(text), path


def test_blocks_that_overlap_do_not_compile(tmp_path):
    # The film's blocks were once the ones of light that passes the surface.
    wrong = PAGE.read_text().replace("film_blocks{std::uint32_t{1} << 25", "film_blocks{std::uint32_t{1} << 23")
    for text, code in ((PAGE.read_text(), 0), (wrong, 1)):
        (tmp_path / "page.cpp").write_text(text.replace("#pragma once", ""))
        done = subprocess.run(["g++", "-std=c++20", "-fsyntax-only", "page.cpp"], cwd=tmp_path, capture_output=True, text=True, check=False)
        assert done.returncode == code
        assert ("an event of a history draws no number twice" in done.stderr) == bool(code)
