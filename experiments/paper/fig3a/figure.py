"""The elastic echo for detectors at and behind the focal plane of Table 1's telescope."""

import photic
from paper.figure import Check, Figure, table_1

SHIFTS_M = [0.0, 0.1, 0.2, 0.4, 0.8]
FIRST_METRE = {0.1: 1.56, 0.2: 2.13, 0.4: 2.61, 0.8: 0.87}  # over the echo in the focal plane
AT_25_M = {0.1: 1.06, 0.2: 1.03, 0.4: 0.66, 0.8: 0.20}
PHOTONS = 1_000_000


def scene_of():
    """Five telescopes in one run, the same but for the place of the detector."""
    scene = table_1({"gates.depth_max_m": 26, "gates.depth_step_m": 1})
    telescope = {key: scene[f"telescope.0.{key}"] for key in ("position_m", "direction", "diameter_m", "focal_length_m", "detector_diameter_m")}
    scene["telescope"] = [{**telescope, "name": f"shift {shift:g} m", "detector_shift_m": shift} for shift in SHIFTS_M]
    scene["channel"] = [{"name": "elastic", "process": "elastic"}]
    return scene


def over_the_first(echo):
    return echo / echo.isel(telescope=0, drop=True)


def make(effort):
    scene = scene_of()
    result = effort.run(scene, PHOTONS)
    closed = photic.lidar_equation(scene)
    first = result.sel(order=1)
    checks = []
    for index, shift in enumerate(SHIFTS_M):
        ratio = photic.error_of(result, lambda e, index=index: e.echo.isel(channel=0, telescope=index) / e.echo.isel(channel=0, telescope=0))
        for gate, expected in ((0, FIRST_METRE), (24, AT_25_M)):
            if shift in expected:
                what = f"detector {shift:g} m behind: echo over that in the focal plane, {'first metre' if gate == 0 else '25 m'}"
                checks.append(Check(what, float(ratio.value[gate]), expected[shift], 0.02, float(ratio.value_standard_error[gate])))
        one = first.isel(channel=0, telescope=index)
        expected = closed.echo.isel(channel=0, telescope=index)
        found, error = one.echo_by_order / expected, one.echo_by_order_standard_error / expected
        worst = max(range(result.sizes["gate"]), key=lambda gate: abs(float(found[gate]) - 1) / (0.01 + 3 * float(error[gate])))
        what = f"detector {shift:g} m behind: order 1 over the closed form, worst gate ({float(one.gate_depth[worst]):.1f} m)"
        checks.append(Check(what, float(found[worst]), 1.0, 0.01, float(error[worst])))
    return Figure(
        title="Fig. 3a: a detector behind the focal plane",
        paper=[
            '"The efficiency … from the regions nearest to the device increases" as the detector is shifted.',
            '"An excessive distance could make the efficiency worse".',
        ],
        finds=[
            "In the first metre the echo is up to 2.6 times that in the focal plane (0.4 m), and less than that with a shift of 0.8 m.",
            "What is gained near the ship is lost at 25 m, where shifts of 0.4 m and 0.8 m leave two thirds and a fifth.",
            "The first order is the closed form to 1 % and its errors, in all gates of all telescopes.",
        ],
        checks=checks,
        draw=lambda canvas: draw(canvas, result, closed),
    )


def draw(canvas, result, closed):
    left, right = canvas.subplots(1, 2, sharey=True)
    for index, shift in enumerate(SHIFTS_M):
        one = result.isel(channel=0, telescope=index)
        colour = f"C{index}"
        left.plot(one.echo, one.gate_depth, colour, label=f"{shift:g} m")
        left.plot(closed.echo.isel(channel=0, telescope=index), one.gate_depth, ":", color=colour)
        right.plot(over_the_first(result.echo).isel(channel=0, telescope=index), one.gate_depth, colour)
    left.set(xscale="log", xlabel="echo per photon; dotted: order 1 in closed form", ylabel="depth [m]", ylim=(26, 0))
    right.set(xlabel="echo over that of a detector in the focal plane")
    left.legend(title="behind the focal plane", fontsize=8)
