#!/usr/bin/python3
"""Solves problems 1 and 2 of Mobley et al. 1993 (Appl. Opt. 32, 7484) with many photons, beside what the paper has.

    experiments/mobley_1993.py build/release/apps/photic/photic --photons 2e7

Deep water of index 1.34 under the sun at 60 degrees, an irradiance of 1 across the beam, a black sky. E_d, scalar E_u and the radiance
straight up are printed at optical depths 1, 5 and 10, with their standard errors, the means of the paper's models and their
coefficients of variation (as transcribed in github.com/mgimond/aomc, comparison/mobley_problems). Two of these, half a unit of the
last digit and three standard errors are allowed; numbers farther off are marked, and the script fails. `./test` does the same with
fewer photons (tests/validation/mobley_test.cpp).
"""

import argparse
import subprocess
import sys
import tempfile

import netCDF4

MOLECULES = '{ model = "rayleigh", depolarisation = 0.08992 }'  # 0.06225 (1 + 0.835 cos^2)
PETZOLD = '"petzold"'
QUANTITIES = ("irradiance_down", "scalar_irradiance_up", "radiance")
# Problem, a, b, phase function; then by quantity and depth the mean as printed and the coefficient of variation.
PROBLEMS = (
    ("1, albedo 0.2", 1, 0.25, MOLECULES,
     (("0.141", .001), ("1.07e-3", .005), ("2.93e-6", .102)),
     (("0.0134", .003), ("1.00e-4", .039), ("3.00e-7", .308)),
     (("1.72e-3", .044), ("1.37e-5", .288), ("3.39e-8", .197))),
    ("1, albedo 0.9", 1, 9, MOLECULES,
     (("0.366", .002), ("0.0433", .003), ("3.16e-3", .015)),
     (("0.372", .005), ("0.0435", .007), ("3.20e-3", .038)),
     (("0.0485", .015), ("5.59e-3", .052), ("4.37e-4", .091))),
    ("2, albedo 0.2", 1, 0.25, PETZOLD,
     (("0.162", 0), ("2.27e-3", .002), ("1.30e-5", .047)),
     (("9.66e-4", .023), ("1.37e-5", .063), ("7.28e-8", .187)),
     (("5.47e-5", .06), ("6.24e-7", .355), ("4.02e-9", .248))),
    ("2, albedo 0.9", 1, 9, PETZOLD,
     (("0.413", .001), ("0.187", .005), ("0.0685", .01)),
     (("0.0931", .021), ("0.0463", .017), ("0.0165", .014)),
     (("6.99e-3", .063), ("3.29e-3", .055), ("1.21e-3", .109))),
)
SCENE = """
[source]
kind = "beam"
wavelength_nm = 532
zenith_deg = 60
[[tally]]
kind = "irradiance"
depth_m = {depths}
[[tally]]
kind = "radiance"
depth_m = {depths}
direction_deg = [[0, 0]]
[sea]
refractive_index = 1.34
[[sea.layer]]
iop = [{{ wavelength_nm = 532, a_per_m = {a}, b_per_m = {b} }}]
phase_function = {phase}
[simulation]
estimator = "forward"
photons = {photons:.0f}
seed = {seed}
"""


def half_digit(printed):
    """Half a unit of the last digit of a number."""
    mantissa, _, exponent = printed.partition("e")
    return 0.5 * 10.0 ** (int(exponent or 0) - len(mantissa.partition(".")[2]))


def solve(program, a, b, phase, asked):
    """By quantity the values and standard errors at the three depths."""
    depths = [tau / (a + b) for tau in (1, 5, 10)]
    with tempfile.TemporaryDirectory() as folder:
        scene = f"{folder}/scene.toml"
        with open(scene, "w") as file:
            file.write(SCENE.format(depths=depths, a=a, b=b, phase=phase, photons=asked.photons, seed=asked.seed))
        done = subprocess.run([program, "run", scene, "-o", f"{folder}/out.nc"], capture_output=True, text=True)
        if done.returncode != 0:
            sys.exit(done.stderr)
        with netCDF4.Dataset(f"{folder}/out.nc") as file:
            return [(file[name][:].ravel(), file[f"{name}_standard_error"][:].ravel()) for name in QUANTITIES]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--photons", type=float, default=2e7)
    parser.add_argument("--seed", type=int, default=1)
    asked = parser.parse_args()
    far_off = 0
    for problem, a, b, phase, *published in PROBLEMS:
        for name, (values, errors), numbers in zip(QUANTITIES, solve(asked.program, a, b, phase, asked), published):
            for tau, value, error, (printed, cv) in zip((1, 5, 10), values, errors, numbers):
                mean = float(printed)
                far = abs(value - mean) > 2 * cv * mean + half_digit(printed) + 3 * error
                far_off += far
                print(f"problem {problem}, optical depth {tau:2}: {name:20} {value:.4g} +- {error:.1g}, paper {printed} "
                      f"(cv {cv}){'  FAR OFF' if far else ''}")
    sys.exit(f"{far_off} of 36 numbers are far off" if far_off else 0)


if __name__ == "__main__":
    main()
