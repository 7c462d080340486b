"""The features of scenes, their values, and the small scene that has one value of each."""

import math

from pair_array.scenes import changed, value_at

FEATURES = {  # the first value of each is what scenes have that are about other features
    "surface": ["flat", "cox-munk", "gaussian", "one-dimensional", "paper"],
    "on the surface": ["clean", "film", "shining film", "whitecaps", "slick"],
    "bed": ["none", "constant", "by angle", "by wavelength"],
    "air": ["none", "molecules", "haze", "refraction"],
    "instruments": ["coaxial", "tilted", "biaxial", "laser below", "telescope below", "both below"],
    "lens": ["in focus", "shifted away", "shifted towards", "obstruction", "overlap"],
    "view": ["narrow", "wide", "nested", "apart"],
    "water": ["one layer", "three layers", "profile", "turbid", "peaked"],
    "light": ["elastic", "raman", "chlorophyll", "filter", "lifetime"],
    "run": ["lanes", "scalar", "environments", "environments of other surfaces", "derivatives", "tools", "forced collisions", "continued"],
    "gates": ["depth", "range", "time", "in the air"],
}
FOAM_ON_OIL = ("film", "whitecaps")  # two values of one feature, and so in no pair
NEEDS = {  # what a value needs of other features before it makes any scene
    ("on the surface", "whitecaps"): {"surface": "cox-munk"},
    ("on the surface", "slick"): {"surface": "cox-munk"},
    ("instruments", "both below"): {"gates": "time"},
}

HEIGHT, BELOW, BED, DEEPEST = 4.0, 0.5, 3.5, 5.0  # of instruments above and below the sea, depth of the bed, end of the last gate [m]
BEHIND_BED = 0.25  # from a bed to the end of the last gate: what comes later is dark, and flagged
BOTH_BELOW = 0.2  # of a laser and a lens in the water [m]: light of the bed that is scattered right above the lens comes with the bed's image
FROM_LENS = 1.0  # from a lens in the water to its first gate: scores nearby have no bound
TILT = math.radians(30)
LASER_NM, RED_NM, END_NM = 532.0, 640.0, 760.0
INDEX, GROUP_INDEX, METRE_PER_NS = 1.34, 1.36, 0.299792458


def _direction(zenith):
    return [round(math.sin(zenith), 6), 0.0, round(-math.cos(zenith), 6)]


def _iop(a, b):
    """Water by wavelength: red light is absorbed more strongly; a share of what green light loses excites others."""
    at = [(LASER_NM, a, b), (RED_NM, a + 0.2, 0.9 * b), (END_NM, a + 1.0, 0.8 * b)]
    shares = {"a_phytoplankton_per_m": round(0.3 * a, 6), "a_cdom_per_m": round(0.2 * a, 6)}
    return [{"wavelength_nm": nm, "a_per_m": round(x, 6), "b_per_m": round(y, 6)} | shares for nm, x, y in at]


def _henyey_greenstein(g):
    return {"model": "henyey-greenstein", "g": g}


def _constituents(chlorophyll, share):
    return {"chlorophyll_mg_m3": chlorophyll, "minerals_g_m3": 0.1 * share, "cdom_a440_per_m": 0.1 * share}


CLEARER = 0.1  # water around a telescope, over that below others: forward scores near a lens have no bound, and the more turbid, the more are flagged


def _water(value, bed, share):
    """Layers; `share`: of what is in the water."""
    def layer(a, b, phase_function):
        return {"iop": _iop(a * share, b * share), "phase_function": phase_function}

    profile = {"depth_m": [0.0, 1.0, 2.5, BED], "value": [x * share for x in (0.1, 0.8, 0.4, 0.2)]}
    layers = {
        "one layer": [layer(0.1, 0.25, _henyey_greenstein(0.8))],
        "three layers": [layer(0.1, 0.2, _henyey_greenstein(0.6)) | {"bottom_depth_m": 1.4}, layer(0.15, 0.25, _henyey_greenstein(0.3)) | {"bottom_depth_m": 2.6},
                         layer(0.08, 0.2, _henyey_greenstein(0.6))],
        "profile": [_constituents(profile, share) | {"bottom_depth_m": BED}] + ([] if bed else [_constituents(0.2 * share, share)]),
        "turbid": [layer(0.02, 0.38, _henyey_greenstein(0.8))],
        "peaked": [layer(0.1, 0.25, "petzold")],
    }[value]
    if bed:
        layers[-1]["bottom_depth_m"] = BED
    return layers


SURFACES = {
    "flat": {"model": "flat"},
    "cox-munk": {"model": "cox-munk", "wind_speed_m_s": 5.0, "wind_direction_deg": 30.0, "whitecaps": False},
    "gaussian": {"model": "gaussian", "upwind_slope_variance": 0.02, "crosswind_slope_variance": 0.01, "wind_direction_deg": 30.0},
    "one-dimensional": {"model": "gaussian", "upwind_slope_variance": 0.02, "crosswind_slope_variance": 0.0, "wind_direction_deg": 30.0},
    "paper": {"model": "paper", "wind_speed_m_s": 3.0, "wind_direction_deg": 30.0, "whitecaps": False},
}
WEAKER_WAVES = {"cox-munk": ("wind_speed_m_s", 4.0), "gaussian": ("upwind_slope_variance", 0.016),
                "one-dimensional": ("upwind_slope_variance", 0.016), "paper": ("wind_speed_m_s", 2.5)}
ALBEDOS = {"constant": 0.2, "by angle": {"zenith_deg": [0.0, 60.0, 90.0], "albedo": [0.15, 0.2, 0.3]},
           "by wavelength": {"wavelength_nm": [LASER_NM - 1, RED_NM, END_NM], "albedo": [0.1, 0.2, 0.3]}}
OTHER_ALBEDO = 0.1


def _oil(shining, lifetime):
    spectrum = {"wavelength_nm": [LASER_NM - 1, 620.0, 650.0, 680.0, END_NM], "n": [1.49, 1.48, 1.48, 1.47, 1.47],
                "a_per_m": [1.5e5, 6e4, 5e4, 4e4, 3e4], "emission_per_nm": [0.0, 0.0, 1.0, 0.0, 0.0]}
    return {"file": spectrum, "thickness_um": 1.0, "yield": 0.05 if shining else 0.0, "lifetime_ns": 5.0 if lifetime else 0.0}


def _air_iop(a, b):
    return [{"wavelength_nm": LASER_NM, "a_per_m": a, "b_per_m": b}, {"wavelength_nm": END_NM, "a_per_m": a, "b_per_m": 0.6 * b}]


ATMOSPHERES = {  # so thick that a few metres of air count
    "molecules": {"layer": [{"bottom_height_m": 0.0, "top_height_m": 100.0, "iop": _air_iop(0.0, 0.02)}]},
    "haze": {"profile": "us-standard", "aerosol": "maritime", "visibility_km": 0.3},
    "refraction": {"refraction": True, "layer": [
        {"bottom_height_m": 0.0, "top_height_m": 2.0, "iop": _air_iop(0.01, 0.02), "phase_function": _henyey_greenstein(0.7),
         "refractive_index": 1.0009},
        {"bottom_height_m": 2.0, "top_height_m": 100.0, "iop": _air_iop(0.0, 0.01), "phase_function": _henyey_greenstein(0.5),
         "refractive_index": 1.0003}]},
}
CLEARER_AIR = {"molecules": {"atmosphere.layer.0.iop.0.b_per_m": 0.012}, "haze": {"atmosphere.visibility_km": 0.4},
               "refraction": {"atmosphere.layer.0.iop.0.b_per_m": 0.012}}


def _poses(value):
    """Place and direction of the laser and of the telescope; the first is that of the laser."""
    down, above, below = _direction(0.0), [0.0, 0.0, HEIGHT], [0.0, 0.0, -BELOW]
    aside, aside_below = [0.4, 0.0, HEIGHT], [0.3, 0.0, -BELOW]
    both, beside, up = [0.0, 0.0, -BOTH_BELOW], [0.2, 0.0, -BOTH_BELOW], _direction(math.pi)  # what is seen upwards is the beam's image in the surface
    return {
        "coaxial": ((above, down), (above, down)),
        "tilted": ((above, _direction(TILT)), (above, _direction(TILT))),
        "biaxial": ((above, down), (aside, _direction(-math.atan(aside[0] / (HEIGHT + 1.0))))),
        "laser below": ((below, down), (above, down)),
        "telescope below": ((above, down), (aside_below, down)),
        "both below": ((both, down), (beside, up)),
    }[value]


LENS = {"diameter_m": 0.3, "focal_length_m": 0.6}
LENSES = {"in focus": {"focus_m": 5.5}, "shifted away": {"detector_shift_m": 0.15}, "shifted towards": {"detector_shift_m": -0.08},
          "obstruction": {"focus_m": 5.5, "obstruction_diameter_m": 0.15}, "overlap": {"focus_m": 5.5, "diameter_m": 0.1}}  # small: its first order is too bright by (radius / distance)^2
SMALL_LENS = 0.03  # with overlap reception in the water [m]: the mean over a lens lacks light that is scattered within some diameters of it
VIEWS_MRAD = {"narrow": [40.0], "wide": [300.0], "nested": [40.0, 120.0], "apart": [60.0, 60.0]}
WATER_VIEWS_MRAD = {"narrow": [150.0], "wide": [300.0], "nested": [150.0, 300.0], "apart": [200.0, 200.0]}  # of lenses in the water


def _telescopes(values):
    position, direction = _poses(values["instruments"])[1]
    lens = LENS | LENSES[values["lens"]]
    if values["lens"] == "overlap" and position[2] < 0:
        lens["diameter_m"] = SMALL_LENS
    out = []
    for n, view in enumerate((VIEWS_MRAD if position[2] > 0 else WATER_VIEWS_MRAD)[values["view"]]):
        x, y, z = position
        apart = values["view"] == "apart" and n > 0
        out.append({"position_m": [x, y + 0.15, z] if apart else position, "direction": direction, **lens, "half_field_of_view_mrad": view})
    return out


def _channels(values):
    channels = [{"name": "elastic", "process": "elastic"}]
    if values["light"] == "filter":
        channels.append({"name": "filter", "centre_nm": 650.0, "fwhm_nm": 30.0, "filter": "gaussian"})
    elif values["light"] != "elastic":
        process = "raman" if values["light"] == "raman" else "chlorophyll"
        channels.append({"name": process, "process": process})
    if values["on the surface"] == "shining film":
        channels.append({"name": "oil", "process": "oil"})
    return channels


def _way(pose, depth):
    """Metres of air and of water along an axis to a depth; an axis that looks up ends at that depth's image in the surface."""
    (_, _, z), axis = pose
    if axis[2] > 0:
        return 0.0, depth - z
    sine = math.hypot(axis[0], axis[1]) / math.hypot(*axis)
    sine_in_water = sine / INDEX if z > 0 else sine
    return max(0.0, z) / math.sqrt(1 - sine**2), (depth - max(0.0, -z)) / math.sqrt(1 - sine_in_water**2)


def _range(lens, depth):
    """Along a lens's axis; behind the surface an axis that looks up is in the air, where light is faster."""
    (_, _, z), axis = lens
    return GROUP_INDEX * (depth + z) - z if axis[2] > 0 else sum(_way(lens, depth))


def _time_ns(poses, depth):
    ways = [_way(pose, depth) for pose in poses]
    return sum(air + GROUP_INDEX * water for air, water in ways) / METRE_PER_NS


def _gates(values):
    """Five gates, from where the light of the sea begins to the bed, or as deep as light is followed."""
    if values["gates"] == "in the air":
        return {"depth_min_m": -1.5, "depth_max_m": 4.5, "depth_step_m": 1.2}
    poses = _poses(values["instruments"])
    laser, lens = (position[2] for position, _ in poses)
    depths = max(0.0, -laser, FROM_LENS - lens if lens < 0 else 0.0), DEEPEST if values["bed"] == "none" else BED + BEHIND_BED
    keys, at = {
        "depth": (("depth_min_m", "depth_max_m", "depth_step_m"), depths),
        "range": (("range_min_m", "range_max_m", "range_step_m"), [_range(poses[1], depth) for depth in depths]),
        "time": (("start_ns", "stop_ns", "step_ns"), [_time_ns(poses, depth) for depth in depths]),
    }[values["gates"]]
    begin, step = round(at[0], 3), round((at[1] - at[0]) / 5, 3)
    return dict(zip(keys, (begin, round(begin + 5 * step, 3), step)))


def _is_oily(values):
    return "film" in values["on the surface"]


def _surface(values):
    surface = dict(SURFACES[values["surface"]])
    if "whitecaps" in values["on the surface"]:
        surface.pop("whitecaps", None)
        surface["whitecap_fraction"] = 0.05
    if values["on the surface"] == "slick":
        surface["slick"] = True
    return surface


def _water_change(scene):
    path = "sea.layer.0.minerals_g_m3" if "minerals_g_m3" in scene["sea"]["layer"][0] else "sea.layer.0.iop.0.a_per_m"
    return {path: round(1.3 * value_at(scene, path), 6)}


def _surface_change(values):
    change = {}
    if values["surface"] in WEAKER_WAVES:
        key, value = WEAKER_WAVES[values["surface"]]
        change[f"sea.surface.{key}"] = value
    if _is_oily(values):
        change["oil.thickness_um"] = 0.7
    if values["on the surface"] == "whitecaps":
        change["sea.surface.whitecap_fraction"] = 0.035
    return change


def _environments(scene, values):
    """Those of other water, then those of another bed and clearer air."""
    sets = [_water_change(scene)]
    if values["bed"] != "none" or values["air"] != "none":
        bed = {} if values["bed"] == "none" else {"bottom.albedo": OTHER_ALBEDO}
        sets.append(bed | CLEARER_AIR.get(values["air"], {}))
    return sets


def _parameters(scene, values):
    """Numbers of water and bed that have derivatives."""
    bed = ["bottom.albedo"] if values["bed"] == "constant" else []
    return [*_water_change(scene), *bed]


BATCH = 500
FREE = {"free_telescope_meetings": 0.1, "free_laser_meetings": 0.3}
TOOLS = {"tools": {"local_forced_collisions": "all", "importance": [{"depth_m": 2.0, "value": 2.0}], "at_threshold": "analog-absorption"},
         "forced collisions": {"forced_collisions": 2}}


def _simulation(values):
    free = FREE if values["view"] == "wide" else dict.fromkeys(FREE, 0.0)
    out = {"photons": 1e5, "batch_photons": BATCH, **free}
    if values["lens"] == "overlap":
        out["reception"] = "overlap"
    if values["run"] in TOOLS:
        out["tools"] = TOOLS[values["run"]]
    return out


def title_of(values):
    """What is not as in the plainest scene, in words."""
    named = [f"{feature}: {value}" for feature, value in values.items() if value != FEATURES[feature][0]]
    return "; ".join(named) or "the plainest"


def _share(values):
    """Of what is in the water: less where a wide view has light of the air that is scattered close to the lens, too."""
    if _poses(values["instruments"])[1][0][2] > 0:
        return 1.0
    return CLEARER * (0.3 if values["view"] == "wide" and values["air"] != "none" else 1.0)


def scene_of(values):
    """The scene that has one value of each feature."""
    bed = values["bed"] != "none"
    (position, direction), _ = _poses(values["instruments"])
    scene = {
        "title": title_of(values),
        "source": {"wavelength_nm": LASER_NM, "position_m": position, "direction": direction, "diameter_m": 0.04, "half_divergence_mrad": 20.0},
        "telescope": _telescopes(values),
        "channel": _channels(values),
        "optics": {},
        "sea": {"surface": _surface(values), "layer": _water(values["water"], bed, _share(values))},
    }
    if values["light"] == "lifetime":
        scene["optics"] = {"chlorophyll_lifetime_ns": 5.0}
    if bed:
        scene["bottom"] = {"albedo": ALBEDOS[values["bed"]]}
    if _is_oily(values):
        scene["oil"] = _oil(values["on the surface"] == "shining film", values["light"] == "lifetime")
    if values["air"] != "none":
        scene["atmosphere"] = ATMOSPHERES[values["air"]]
    scene |= {"gates": _gates(values), "simulation": _simulation(values)}
    if values["run"] == "environments":
        scene["environment"] = [{"set": change} for change in _environments(scene, values)]
    if values["run"] == "environments of other surfaces":
        scene["environment"] = [{"set": _surface_change(values)}]
    if values["run"] == "derivatives":
        scene["sensitivity"] = _parameters(scene, values)
    return scene


def own_scene(scene, environment):
    """The scene of an environment alone."""
    alone = {key: value for key, value in scene.items() if key != "environment"}
    return changed(alone, environment["set"])
