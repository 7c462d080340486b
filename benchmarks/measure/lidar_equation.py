"""The echo of single scattering in closed form (docs/theory.md, eq. 30): the lidar equation of one bottomless layer under a
flat sea, integrated over the laser's cone and over every gate.

It shares no code with the program. Rays refract by Snell's law, found by bisection; the solid angle of the lens is that of
the cone of rays about the refracted one, differentiated by hand.
"""

import numpy as np

LIGHT_M_PER_NS = 0.299792458
RINGS, AZIMUTHS, POINTS = 24, 12, 12  # of the laser's cone; along a ray within a gate


def echo(scene, edges_ns):
    """Photons per photon emitted in each gate. `scene`: as `photic show --json` prints it; its sea has indices of its own."""
    rays = Rays(scene)
    telescope, layer = scene["telescope"][0], scene["sea"]["layer"][0]
    a, b = layer["iop"][0]["a_per_m"], layer["iop"][0]["b_per_m"]
    edges = np.array([rays.distance_of(LIGHT_M_PER_NS * edge) for edge in edges_ns])
    nodes, weights = np.polynomial.legendre.leggauss(POINTS)
    gates = []
    for low, high in zip(edges, edges[1:]):
        half = (high - low) / 2
        s = low + half * (nodes[:, None] + 1)
        way = rays.way_home(s)
        phase = henyey_greenstein(way["cosine"], layer["phase_function"]["g"])
        seen = way["transmittance"] * lens(telescope, way)
        density = b * phase * seen * np.exp(-(a + b) * (s + way["in_water"]))
        gates.append(np.mean(rays.weight * half * (weights[:, None] * density).sum(axis=0)))
    return np.array(gates)


def henyey_greenstein(cosine, g):
    return (1 - g * g) / (1 + g * g - 2 * g * cosine) ** 1.5 / (4 * np.pi)


def fresnel(n1, n2, cosine1, cosine2):
    s = (n1 * cosine1 - n2 * cosine2) / (n1 * cosine1 + n2 * cosine2)
    p = (n2 * cosine1 - n1 * cosine2) / (n2 * cosine1 + n1 * cosine2)
    return (s * s + p * p) / 2


def frame(axis):
    """Two directions across an axis and each other."""
    axis = np.array(axis) / np.linalg.norm(axis)
    across = np.cross(axis, [0.0, 1.0, 0.0])
    across /= np.linalg.norm(across)
    return axis, across, np.cross(axis, across)


class Rays:
    """The laser's cone in the water: RINGS x AZIMUTHS rays of equal shares of the light."""

    def __init__(self, scene):
        source, self.telescope = scene["source"], scene["telescope"][0]
        self.n, self.group = scene["sea"]["refractive_index"], scene["sea"]["group_index"]
        axis, u, v = frame(source["direction"])
        widest = 1 - np.cos(1e-3 * source["half_divergence_mrad"])
        ring, azimuth = np.meshgrid((np.arange(RINGS) + 0.5) / RINGS, 2 * np.pi * (np.arange(AZIMUTHS) + 0.5) / AZIMUTHS)
        cosine = (1 - widest * ring.ravel())[:, None]
        sine, azimuth = np.sqrt(1 - cosine**2), azimuth.ravel()[:, None]
        k = cosine * axis + sine * (np.cos(azimuth) * u + np.sin(azimuth) * v)
        behind = source["diameter_m"] / 2 / np.tan(1e-3 * source["half_divergence_mrad"])  # of the cone's tip
        disc = np.array(source["position_m"]) + behind * (k / cosine - axis)
        self.path = disc[:, 2] / -k[:, 2]
        self.start = disc + self.path[:, None] * k
        self.direction = np.column_stack([k[:, :2] / self.n, -np.sqrt(1 - (k[:, :2] ** 2).sum(axis=1) / self.n**2)])
        self.weight = 1 - fresnel(1.0, self.n, -k[:, 2], -self.direction[:, 2])

    def distance_of(self, path):
        """The distance along each ray at which light turns back that has come so far when it reaches the lens."""
        low, high = np.zeros(len(self.path)), np.full(len(self.path), path)
        for _ in range(60):
            middle = (low + high) / 2
            way = self.way_home(middle[None, :])
            short = self.path + self.group * (middle + way["in_water"][0]) + way["in_air"][0] < path
            low, high = np.where(short, middle, low), np.where(short, high, middle)
        return (low + high) / 2

    def way_home(self, s):
        """From the points at the distances s [points, rays] along the rays to the centre of the lens."""
        point = self.start + s[..., None] * self.direction
        centre = np.array(self.telescope["position_m"])
        depth, height = -point[..., 2], centre[2]
        aside = centre[:2] - point[..., :2]
        r = np.hypot(aside[..., 0], aside[..., 1])
        low, high = np.zeros_like(r), np.minimum(r / np.maximum(np.hypot(r, depth), 1e-12), 1 / self.n)
        for _ in range(60):  # the sine of the angle in the water
            sine = (low + high) / 2
            beyond = depth * sine / np.sqrt(1 - sine**2) + height * self.n * sine / np.sqrt(1 - (self.n * sine) ** 2) > r
            low, high = np.where(beyond, low, sine), np.where(beyond, sine, high)
        sine = (low + high) / 2
        water, air = np.sqrt(1 - sine**2), np.sqrt(1 - (self.n * sine) ** 2)  # cosines
        in_water, in_air = depth / water, height / air
        # r = sine (depth / water + n height / air); of a cone of rays, dOmega = sine dtheta dphi in the water lands on
        # dA = r dr cos(theta_air) dphi across the ray.
        slope = depth / water**2 + height / air**2 * self.n * water / air  # dr / dtheta
        angle_per_area = 1 / ((in_water + self.n * in_air) * slope * air)
        outward = aside / np.maximum(r, 1e-12)[..., None]
        leaving = np.concatenate([outward * sine[..., None], water[..., None]], axis=-1)
        arriving = np.concatenate([outward * (self.n * sine)[..., None], air[..., None]], axis=-1)
        return {
            "in_water": in_water, "in_air": in_air, "arriving": arriving, "angle_per_area": angle_per_area,
            "cosine": (leaving * self.direction).sum(axis=-1), "apparent": in_air + in_water / self.n,
            "transmittance": 1 - fresnel(self.n, 1.0, water, air),
        }


def lens(telescope, way):
    """The solid angle of the lens [sr] times the share of the blurred image that the detector sees (eq. 31, 32)."""
    axis = np.array(telescope["direction"]) / np.linalg.norm(telescope["direction"])
    cosine = -(way["arriving"] * axis).sum(axis=-1)
    f, radius = telescope["focal_length_m"], telescope["diameter_m"] / 2
    blur = radius * np.abs(1 - f * (1 / f - 1 / (way["apparent"] * cosine)))
    aside = f * np.sqrt(np.maximum(0, 1 - cosine**2)) / cosine
    share = common_area(telescope["detector_diameter_m"] / 2, blur, aside) / (np.pi * blur**2)
    return way["angle_per_area"] * np.pi * radius**2 * cosine * share


def common_area(r1, r2, distance):
    """The common area of two circles."""
    r1, r2, d = np.broadcast_arrays(r1, r2, np.maximum(distance, 1e-12))
    first = np.arccos(np.clip((d * d + r1 * r1 - r2 * r2) / (2 * d * r1), -1, 1))
    second = np.arccos(np.clip((d * d + r2 * r2 - r1 * r1) / (2 * d * r2), -1, 1))
    kite = np.sqrt(np.maximum(0, (r1 + r2 - d) * (d + r1 - r2) * (d - r1 + r2) * (d + r1 + r2))) / 2
    lens_area = r1 * r1 * first + r2 * r2 * second - kite
    return np.where(d >= r1 + r2, 0, np.where(d <= np.abs(r1 - r2), np.pi * np.minimum(r1, r2) ** 2, lens_area))
