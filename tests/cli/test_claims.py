"""Errors are not wider than the truth where scores have a bound: experiments/claims_by_seeds.py, of one scene and few seeds."""

import sys

from conftest import SOURCE

sys.path.insert(0, str(SOURCE / "experiments"))
import claims_by_seeds  # noqa: E402

SEEDS = 12  # scatter is known to 21 %


# The first gate that the beam enters, whose scores have a bound. These seeds gave 10.7; four other sets of twelve gave 6 to 20, and give
# 0.94 to 1.79 now. Seen red: without the chance of no larger score.
def test_the_first_gate_of_a_vehicle_claims_what_it_scatters(program, tmp_path):
    echo, error, _ = claims_by_seeds.runs_of(program, "rov-near", SEEDS, tmp_path)
    down = claims_by_seeds.over_scatter(echo, error.mean(axis=0))[0]
    assert 0.5 < down[0] < 2
    assert (down < 2.5).all()
