"""A lidar of the air as that of Harms et al. (1978, 1979): what overlap, obstruction and detectors make of the first order."""

import numpy
import photic
from paper.figure import Check, Figure, of_photons_alone

HEIGHT_M = 6000.0
ABSORPTION, SCATTERING = 1e-5, 9e-5  # 1/m
FIRST_M, LAST_M, STEP_M = 100.0, 5000.0, 100.0
FOCAL_M, LENS_M, LASER_M, DIVERGENCE = 2.0, 0.3, 0.02, 20e-6  # Harms' but for the laser's disc, which is not at hand
ASIDE_M, DETECTOR_M = 0.5, 1e-3
TELESCOPES = {  # name: (aside [m], inclined [mrad], detector [m], obstruction [m])
    "aside, parallel": (ASIDE_M, 0.0, DETECTOR_M, 0.0),
    "aside, 0.3 mrad": (ASIDE_M, 0.3, DETECTOR_M, 0.0),
    "aside, 1 mrad": (ASIDE_M, 1.0, DETECTOR_M, 0.0),
    "obstructed": (0.0, 0.0, DETECTOR_M, 0.1),
    "0.2 mm": (0.0, 0.0, 0.2e-3, 0.0),
    "0.4 mm": (0.0, 0.0, 0.4e-3, 0.0),
    "1 mm": (0.0, 0.0, 1e-3, 0.0),
}
PHOTONS = 200_000
SAMPLES = 1 << 17  # of the overlap integral, in each gate
INTEGRAL = 0.0005  # its relative error
KNOWN = 0.2  # relative error of gates that are compared
DEVIATIONS = 3.3  # of chi squared, about its degrees of freedom: passed by chance in 999 of 1000 cases


def scene_of():
    scene = of_photons_alone(photic.Scene.new("spaceborne"))
    scene.update({
        "source.position_m": [0, 0, HEIGHT_M], "source.diameter_m": LASER_M, "source.half_divergence_mrad": 1e3 * DIVERGENCE,
        "telescope": [{
            "name": name, "position_m": [aside, 0, HEIGHT_M], "direction": [-1e-3 * inclined, 0, -1], "diameter_m": LENS_M,
            "focal_length_m": FOCAL_M, "detector_diameter_m": detector, "obstruction_diameter_m": obstruction,
        } for name, (aside, inclined, detector, obstruction) in TELESCOPES.items()],
        "atmosphere": {"layer": [{
            "bottom_height_m": 0, "top_height_m": HEIGHT_M, "phase_function": "isotropic",
            "iop": [{"wavelength_nm": 532, "a_per_m": ABSORPTION, "b_per_m": SCATTERING}],
        }]},
        "gates": {"range_min_m": FIRST_M, "range_max_m": LAST_M, "range_step_m": STEP_M},
    })
    return scene


def even_points(count, dimensions):
    """Points that fill the unit cube evenly: multiples of powers of the root of x^(d+1) = x + 1 (Roberts 2018 [from memory])."""
    root = 2.0
    for _ in range(60):
        root = (1 + root) ** (1 / (dimensions + 1))
    return (0.5 + numpy.arange(1, count + 1)[:, None] * root ** -numpy.arange(1, dimensions + 1)) % 1


def disc(radius, angle):
    """A point of the unit disc, from two even numbers."""
    return numpy.sqrt(radius) * numpy.cos(2 * numpy.pi * angle), numpy.sqrt(radius) * numpy.sin(2 * numpy.pi * angle)


def first_order(aside, inclined, detector, obstruction):
    """The overlap integral [photons per photon] of each gate: shares of points of the beam and the lens whose light hits the detector."""
    points = even_points(SAMPLES, 5)
    beam, across = (disc(points[:, k], points[:, k + 1]) for k in (1, 3))
    out = []
    for near in numpy.arange(FIRST_M, LAST_M, STEP_M):
        distance = near + STEP_M * points[:, 0]
        x, y = ((LASER_M / 2 + distance * DIVERGENCE) * each for each in beam)  # of a cone whose tip is behind the disc
        image = [FOCAL_M * ((x - aside) / distance + 1e-3 * inclined), FOCAL_M * y / distance]  # of the lens' centre, in the focal plane
        spread = FOCAL_M / distance  # of a point of the lens on the detector
        if detector / 2 < LENS_M / 2 * FOCAL_M / near:  # points of the detector, and where on the lens their light comes through
            lens = [(detector / 2 * a - i) / spread for a, i in zip(across, image)]
            area = numpy.pi * (detector / 2 / spread) ** 2
        else:
            lens = [LENS_M / 2 * a for a in across]
            area = numpy.pi * (LENS_M / 2) ** 2
        places = [i + spread * each for i, each in zip(image, lens)]
        radius = numpy.hypot(*lens)
        seen = (numpy.hypot(*places) <= detector / 2 * (1 + 1e-9)) & (radius <= LENS_M / 2) & (radius >= obstruction / 2)
        light = SCATTERING / (4 * numpy.pi) * numpy.exp(-2 * (ABSORPTION + SCATTERING) * distance) * area / distance**2
        out.append(STEP_M * float((light * seen).mean()))
    return numpy.array(out)


def make(effort):
    result = effort.run(scene_of(), PHOTONS)
    expected = {name: first_order(*of) for name, of in TELESCOPES.items()}
    checks = []
    for name, integral in expected.items():
        one = result.sel(telescope=name, order=1).isel(channel=0)
        found, error = one.echo_by_order.values, one.echo_by_order_standard_error.values
        known = (error > 0) & (error < KNOWN * found)
        z = ((found - integral) / numpy.hypot(numpy.where(error > 0, error, 1), INTEGRAL * integral))[known]
        gates = int(known.sum())
        checks.append(Check(f"{name}: chi^2 per gate of order 1, {gates} gates", float((z**2).mean()), 1.0, DEVIATIONS * (2 / gates) ** 0.5))
    flat = result.sel(telescope="0.2 mm").isel(channel=0, gate=slice(1, 14)).echo
    checks.append(Check("0.2 mm: echo from 0.2 to 1.5 km over its mean, farthest", float(abs(flat / flat.mean() - 1).max()) + 1, 1.0, 0.35))
    near = result.isel(channel=0, gate=0).echo
    checks.append(Check("obstructed over open, from 0.1 to 0.2 km", float(near.sel(telescope="obstructed") / near.sel(telescope="1 mm")), 0.0, 0.05))
    return Figure(
        title="Fig. 2: the overlap of laser and telescope in the air",
        paper=[
            "With the laser aside, an inclination of the telescope loses the far or the near range.",
            "An obstruction takes the near signal away.",
            'A small detector sees a signal that is the same at all distances up to lens radius times focal length over detector radius: "geometrical compression".',
        ],
        finds=[
            "The first order is the overlap integral, which this experiment makes by itself: of points of the beam and the lens it counts "
            "those whose light falls on the detector.",
            "A telescope 0.5 m aside and parallel sees nothing before 1 km; inclined by 1 mrad it sees 0.4 to 0.7 km and nothing behind.",
            "An obstruction of 10 cm leaves 2 % of the first gate's light to a detector of 1 mm.",
            "A detector of 0.2 mm has the same signal within 35 % from 0.2 to 1.5 km (a f / r_d = 3 km).",
        ],
        checks=checks,
        draw=lambda canvas: draw(canvas, result, expected),
    )


def draw(canvas, result, expected):
    names = list(TELESCOPES)
    for panel, group, title in zip(canvas.subplots(1, 3, sharey=True), (names[:3], ["obstructed", "1 mm"], names[4:]), "abc"):
        for index, name in enumerate(group):
            one = result.sel(telescope=name).isel(channel=0)
            panel.errorbar(one.echo, one.gate_depth / 1000, xerr=one.echo_standard_error, fmt=".", ms=4, color=f"C{index}", label=name)
            panel.plot(expected[name], one.gate_depth / 1000, ":", color=f"C{index}")
        panel.set(xscale="log", xlim=(1e-12, 2e-9), xlabel="echo per photon; dotted: integral", title=title)
        panel.legend(fontsize=7)
    canvas.axes[0].set(ylabel="range [km]", ylim=(5, 0))
