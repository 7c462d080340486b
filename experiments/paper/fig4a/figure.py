"""Chlorophyll fluorescence over Raman light against chlorophyll: how straight that line is."""

import numpy
import photic
import xarray
from paper.figure import Check, Figure, power, table_1

CHLOROPHYLL = [0.1, 0.2, 0.5, 1.0, 2.0]  # mg/m3
PATH = "sea.layer.0.chlorophyll_mg_m3"
OPTICS = {  # by name: changes of the scene, and the power that is to be found
    "paper's absorption, 532 nm": ({"optics.set": "paper"}, 0.64),
    "paper's absorption, 480 nm": ({"optics.set": "paper", "source.wavelength_nm": 480}, 0.78),
    "modern, 532 nm": ({"optics.set": "modern"}, 0.90),
    "in proportion, 532 nm": (None, 1.05),
}
PER_CHLOROPHYLL = {"paper's absorption, 532 nm": (2.12, 0.72)}  # at the ends
R_SQUARED = {"paper's absorption, 532 nm": 0.985, "modern, 532 nm": 0.999}
PHOTONS = 100_000


def in_proportion():
    """Changes of a scene whose phytoplankton absorbs and scatters in proportion to chlorophyll: as the paper's at 1 mg/m3."""
    wavelengths = list(range(400, 741, 10))
    table = photic.optics.of(table_1({"optics.set": "paper", PATH: 1.0}), wavelengths).isel(depth=0)
    names = {"a_m2_per_mg": "a_phytoplankton_and_detritus_per_m", "b_m2_per_mg": "b_phytoplankton_and_detritus_per_m"}
    columns = {key: [float(value) for value in table[name].values] for key, name in names.items()}
    return {"optics.set": "paper", "optics.phytoplankton": "table", "optics.phytoplankton_file": {"wavelength_nm": wavelengths, **columns}}


def scene_of(changes, case_2=None):
    changes = in_proportion() if changes is None else changes
    scene = table_1({"gates.depth_max_m": 50, "gates.depth_step_m": 2, "simulation.estimator": "bidirectional",
                     PATH: CHLOROPHYLL[0], **changes, **(case_2 or {})})
    scene["environment_grid"] = {PATH: CHLOROPHYLL[1:]}
    return scene


def ratios(result):
    """With the scene itself as the first of the waters."""
    scene = photic.ratio(result).isel(telescope=0).expand_dims(environment=["scene"])
    others = photic.ratio(result, environment=list(map(str, result.environment.values))).isel(telescope=0)
    others = others.transpose("environment", ...)
    both = [one.drop_vars([name for name in one.coords if name != "environment"]) for one in (scene, others)]
    return xarray.concat(both, dim="environment")


def power_of(one):
    return power(CHLOROPHYLL, one.ratio_of_sums.values, one.ratio_of_sums_replicates.transpose("batch_group", ...).values)


def make(effort):
    found = {name: ratios(effort.run(scene_of(changes), PHOTONS)) for name, (changes, _) in OPTICS.items()}
    case_2 = {"sea.layer.0.minerals_g_m3": 2.0, "sea.layer.0.cdom_a440_per_m": 0.5}
    found["modern, 532 nm, case-2 water"] = ratios(effort.run(scene_of(OPTICS["modern, 532 nm"][0], case_2), PHOTONS))
    checks, lines = [], {name: photic.linear_fit(CHLOROPHYLL, one, "ratio_of_sums") for name, one in found.items()}
    for name, (_, expected) in OPTICS.items():
        values = found[name].ratio_of_sums.values
        if expected is not None:
            exponent, error = power_of(found[name])
            checks.append(Check(f"{name}: ratio goes as chlorophyll to the power", exponent, expected, 0.02, error))
        for end, (chlorophyll, per) in enumerate(zip((CHLOROPHYLL[0], CHLOROPHYLL[-1]), PER_CHLOROPHYLL.get(name, ()))):
            error = float(found[name].ratio_of_sums_standard_error[-end]) / chlorophyll
            checks.append(Check(f"{name}: ratio over chlorophyll at {chlorophyll:g} mg/m3", values[-end] / chlorophyll, per, 0.02 * per, error))
        if name in R_SQUARED:
            line = numpy.corrcoef(CHLOROPHYLL, values)[0, 1] ** 2
            checks.append(Check(f"{name}: r^2 of a straight line without weights", line, R_SQUARED[name], 0.003))
    return Figure(
        title="Fig. 4a: chlorophyll over Raman light",
        paper=['"Linear dependence of the phytoplankton fluorescence signal normalised by Raman from chlorophyll".'],
        finds=[
            "Not so with the paper's own absorption, which goes as chlorophyll to the power 0.602: the ratio goes as the power 0.64 at 532 nm, "
            "0.78 at 480 nm, and the ratio over chlorophyll falls to a third from 0.1 to 2 mg/m3. r^2 of a straight line is 0.985 all the same: "
            "it shows nothing.",
            "With the modern data the power is 0.90.",
            "With absorption in proportion to chlorophyll the ratio over chlorophyll rises by a sixth: that must be what the paper had.",
            "In case-2 water (2 g/m3 of minerals, CDOM of 0.5 1/m at 440 nm) the modern ratio bends less, since what else absorbs rules: its power is "
            f"{power_of(found['modern, 532 nm, case-2 water'])[0]:.2f}.",
        ],
        checks=checks,
        draw=lambda canvas: draw(canvas, found, lines),
    )


def draw(canvas, found, lines):
    left, right = canvas.subplots(1, 2)
    for index, (name, one) in enumerate(found.items()):
        value, error, colour = one.ratio_of_sums.values, one.ratio_of_sums_standard_error.values, f"C{index}"
        left.errorbar(CHLOROPHYLL, value / CHLOROPHYLL, error / CHLOROPHYLL, fmt="o-", color=colour, ms=4, capsize=2, label=name)
        right.plot(CHLOROPHYLL, lines[name].residual / value, "o-", color=colour, ms=4)
    left.set(xscale="log", yscale="log", xlabel="chlorophyll [mg/m3]", ylabel="chlorophyll over Raman light, over chlorophyll")
    left.legend(fontsize=7)
    right.set(xscale="log", xlabel="chlorophyll [mg/m3]", ylabel="residual of the straight line, over the ratio")
    right.axhline(0, color="0.6", lw=1)
