"""Echoes against closed forms, against each other, and against the reference engine."""

import json
import math
import subprocess
from statistics import NormalDist

from measure import coverage, lidar_equation
from measure.kinds import Measurement, Row, number, percent, within
from measure.program import ROOT, Failed

BOTH = ("forward", "bidirectional")
SCENES = ("ship", "ship-tilted", "rov", "three-layers")


def estimator(name):
    return "--set", f"simulation.estimator={name}"


# --- single scattering against the lidar equation ---

AXIS = "[0.5, 0.0, -0.8660254037844386]"
TILTED = [word for path in ("source.direction", "telescope.0.direction") for word in ("--set", f"{path}={AXIS}")]
TILTED += ["--set", "telescope.0.detector_diameter_m=0.12"]
POSES = {"vertical": [], "tilted by 30 degrees": TILTED}
FIRST_ORDER = "experiments/first-order.toml"
LARGEST = {"forward": 0.005, "bidirectional": 0.02}


def measure_lidar_equation(runner):
    out = {}
    for pose, settings in POSES.items():
        show = [runner.program, "show", str(ROOT / FIRST_ORDER), "--json", *settings]
        shown = subprocess.run(show, capture_output=True, text=True, check=False)
        if shown.returncode != 0:
            raise Failed(f"photic show {FIRST_ORDER}: {shown.stderr.strip()}")
        equation = None
        for name, photons in (("forward", 1e7), ("bidirectional", 3e6)):
            count = runner.photons(photons, name)
            echoes = runner.result("run", FIRST_ORDER, "--photons", count, *estimator(name), *settings)["echoes"]
            if equation is None:
                edges = [row["time_start_ns"] for row in echoes] + [echoes[-1]["time_end_ns"]]
                equation = [float(x) for x in lidar_equation.echo_of(json.loads(shown.stdout), edges)]
            of_gates = ("echo", "standard_error")
            out[f"{pose}, {name}"] = {key: [row[key] for row in echoes] for key in of_gates} | {"equation": equation}
    return out


def rows_lidar_equation(raw):
    for name, gates in raw.items():
        off = [abs(echo / equation - 1) for echo, equation in zip(gates["echo"], gates["equation"])]
        error = max(error / echo for error, echo in zip(gates["standard_error"], gates["echo"]))
        allowed = LARGEST[name.split(", ")[1]]
        measured = f"{percent(max(off), 2)} in {len(off)} gates; errors up to {percent(error, 2)}"
        yield Row(name, measured, f"{percent(allowed)} in every gate", max(off) < allowed)


# --- the two estimators against each other ---

PHOTONS = {"ship": (4e6, 2e5), "ship-tilted": (4e6, 4e5), "rov": (3e7, 4e5), "three-layers": (2e6, 1e5)}
RMS = (0.75, 1.25)


def measure_agreement(runner):
    out = {}
    for scene in SCENES:
        runs = {}
        for name, photons in zip(BOTH, PHOTONS[scene]):
            count = runner.photons(photons, name)
            many = [("run", f"scenes/{scene}.toml", "--photons", count, *estimator(name), "--seed", s) for s in runner.seeds(4)]
            runs[name] = [coverage.cells(result, "echoes") for result in runner.results(many)]
        z = {}
        for seed, a, b in zip(runner.seeds(4), runs["forward"], runs["bidirectional"]):
            for cell in a:
                (x, x_error, x_converged), (y, y_error, y_converged) = a[cell], b[cell]
                if x_converged and y_converged:
                    telescope, channel, gate = cell
                    name = f"{channel} of {telescope}, gate {gate}, seed {seed}"
                    z[name] = round((x - y) / math.hypot(x_error, y_error), 4)
        out[scene] = {"z": list(z.values()), "largest": max(z, key=lambda name: abs(z[name]), default="")}
    return out


def family_wise_z(count, level=0.01):
    """The bound that `count` standard normals all stay below, but for a chance of `level`."""
    return NormalDist().inv_cdf(1 - (1 - (1 - level) ** (1 / count)) / 2)


def rows_agreement(raw):
    for scene, of_scene in raw.items():
        z = of_scene["z"]
        if not z:
            yield Row(scene, "no gate is converged in both", "at least one gate", False)
            continue
        limit, largest = family_wise_z(len(z)), max(z, key=abs)
        rms = math.sqrt(math.fsum(x * x for x in z) / len(z))
        beyond = sum(abs(x) >= limit for x in z)
        measured = f"z up to {abs(largest):.2f}, rms {rms:.2f}, {len(z)} gates"
        if beyond:
            side = "above" if largest > 0 else "below"
            measured += f"; {beyond} beyond the limit, at the worst ({of_scene['largest']}) the forward echo {side} the bidirectional one"
        yield Row(scene, measured, f"z below {limit:.2f}, rms {RMS[0]} to {RMS[1]}", not beyond and within(rms, *RMS))


# --- multiple scattering against published results ---

SLABS = {
    "slab": ("van de Hulst's slab", {"escaped": ("reflectance", 0.09739), "sea_bed": ("transmittance", 0.66096)}),
    "half-space": ("Giovanelli's half space", {"escaped": ("reflectance", 0.2600)}),
}


def measure_slabs(runner):
    out = {}
    for scene in SLABS:
        result = runner.result("run", f"experiments/{scene}.toml", "--photons", runner.photons(4e6))
        out[scene] = {"photons": result["photons"], **result["ledger"]}
    return out


def rows_slabs(raw):
    for scene, (name, published) in SLABS.items():
        for key, (what, value) in published.items():
            share, photons = raw[scene][key], raw[scene]["photons"]
            # A photon's share lies between 0 and 1, so that the binomial error bounds its own; tables have four digits.
            allowed = 3 * math.sqrt(value * (1 - value) / photons) + 5e-5
            yield Row(f"{name}: {what}", f"{share:.4f}", f"{value:.4f} +- {allowed:.4f}", abs(share - value) < allowed)


# --- lanes in float against the scalar engine in double ---

ISAS = ("baseline", "avx2", "avx512")


def isas_here(runner):
    """The instruction sets of this program and processor; the reasons why the others are absent."""
    here, absent = [], {}
    for isa in ISAS:
        try:
            runner.result("run", "scenes/benchmark-hg.toml", "--photons", 1000, *estimator("forward"), "--isa", isa)
            here.append(isa)
        except Failed as failure:
            absent[isa] = str(failure).split(": ", 2)[-1]
    return here, absent


def measure_lanes(runner):
    here, absent = isas_here(runner)
    out = {"absent": absent, "z": {}}
    for scene in ("benchmark-peaked", "ship"):
        for name, photons in (("forward", 2.4e5), ("bidirectional", 6e4)):
            run = ("run", f"scenes/{scene}.toml", "--photons", runner.photons(photons, name), *estimator(name))
            scalar, *lanes = runner.results([(*run, "--engine", "scalar")] + [(*run, "--isa", isa) for isa in here])
            for isa, result in zip(here, lanes):
                pairs = [(a, b) for a, b in zip(result["echoes"], scalar["echoes"]) if b["converged"]]
                z = [(a["echo"] - b["echo"]) / b["standard_error"] for a, b in pairs]
                out["z"].setdefault(isa, {})[f"{scene}, {name}"] = [round(x, 5) for x in z]
    return out


def rows_lanes(raw):
    for isa, scenes in raw["z"].items():
        z = [abs(x) for of_scene in scenes.values() for x in of_scene]
        if not z:
            yield Row(isa, "no gate is converged", "at least one gate", False)
            continue
        rms = math.sqrt(math.fsum(x * x for x in z) / len(z))
        measured = f"up to {number(max(z))}, rms {number(rms)} standard errors, {len(z)} gates"
        yield Row(isa, measured, "up to 0.15, rms 0.03 standard errors", max(z) < 0.15 and rms < 0.03)
    for isa, reason in raw["absent"].items():
        yield Row(isa, f"not measured: {reason}")


# --- the photons' weight ---

LARGEST_LOSS = {"forward": 0.02, "bidirectional": 0.01}  # of a run: photic warns from 2 % on


def measure_ledger(runner):
    out = {}
    for scene in ("ship", "benchmark-peaked", *SCENES[1:]):
        for name, photons in (("forward", 2e6), ("bidirectional", 1e5)):
            result = runner.result("run", f"scenes/{scene}.toml", "--photons", runner.photons(photons, name), *estimator(name))
            lost = result["lost_too_many_events"] + result["lost_not_finite"]
            out[f"{scene}, {name}"] = {"sum": math.fsum(result["ledger"].values()), "lost": lost}
    return out


def rows_ledger(raw):
    for name in BOTH:
        of_it = {scene: kept for scene, kept in raw.items() if scene.endswith(name)}
        worst, kept = max(of_it.items(), key=lambda item: abs(item[1]["sum"] - 1))
        off, lost = abs(kept["sum"] - 1), sum(kept["lost"] for kept in of_it.values())
        measured = f"off by {percent(off, 2)} ({worst.split(',')[0]}), {lost} photons lost"
        allowed = LARGEST_LOSS[name]
        yield Row(f"{name}, {len(of_it)} scenes", measured, f"off by at most {percent(allowed, 0)}, none lost", off < allowed and lost == 0)


MEASUREMENTS = [
    Measurement(
        "lidar-equation", "Single scattering", "Echoes of light scattered once are those of the lidar equation.",
        "The equation (docs/theory.md, eq. 30) is integrated over the laser's cone and each gate by "
        "`python/photic/single_scattering.py`, which shares no code with the program. The number is the largest relative "
        "difference of any gate. The tilted telescope sees the whole beam: the equation takes the blur of an image for round.",
        measure_lidar_equation, rows_lidar_equation,
    ),
    Measurement(
        "agreement", "Two estimators", "The forward and the bidirectional estimator, which share emission, flight and "
        "scattering but not how an echo is estimated, agree.",
        "z is the difference of two echoes divided by the error of that difference, in gates converged in both, of several pairs "
        "of runs. The largest may exceed the limit by chance in one of a hundred measurements; the gates of a run share "
        "histories, so the root mean square scatters about 1. The ship's Raman light from 32 to 36 m reaches the forward estimator in "
        "rare and large scores, whose absence makes an echo low and its error small: of the 24 gates of twelve runs (4e6 photons, seeds 1 "
        "to 12) 19 are flagged; of the other five three are low by more than four of their errors, and all are 11 % low on average. "
        "`auto` takes the bidirectional estimator there.",
        measure_agreement, rows_agreement,
    ),
    Measurement(
        "slabs", "Multiple scattering", "Reflectance and transmittance of slabs are those published for other methods.",
        "Shares of all light that leave the water upwards and that reach its bottom: van de Hulst 1980, table 35; Giovanelli 1955.",
        measure_slabs, rows_slabs,
    ),
    Measurement(
        "lanes", "Lanes in float", "Echoes from lanes, in float, are those of the scalar engine in double.",
        "Differences of echoes of the same photons, divided by their standard error, in gates converged in the scalar run, for two "
        "scenes and both estimators.",
        measure_lanes, rows_lanes,
    ),
    Measurement(
        "ledger", "Weight", "All weight that was emitted is booked: absorbed, escaped, or cut off.",
        "The worst of several scenes. The sum is 1 only in the mean. In turbid water the forward estimator's is not, and a "
        "warning says so (docs/theory.md, eq. 24).",
        measure_ledger, rows_ledger,
    ),
]
