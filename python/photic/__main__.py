"""python3 -m photic plot out.nc [more.nc …] -o out.png"""

import argparse
import os
import sys

from photic.errors import Error
from photic.result import is_optics, is_spectra
from photic.result import open as open_result


def main(arguments=None):
    parser = argparse.ArgumentParser(
        prog="python3 -m photic", description="Shows results of Photic."
    )
    commands = parser.add_subparsers(dest="command", required=True)
    plot = commands.add_parser(
        "plot",
        help="draw echoes against depth, or optics",
        description="Draws the echoes of one result by channel, process and order, or those of "
        "several results over each other, channel by channel, and each by order beside them. Of a "
        "file of `photic optics` it draws coefficients, phase functions and emitted light, or "
        "spectra.",
    )
    add = plot.add_argument
    add("results", nargs="+", metavar="RESULT.nc", help="what `photic run` or `photic optics` wrote")
    add("-o", "--output", required=True, metavar="OUT.png", help="picture: .png, .pdf or .svg")
    add("--title", help="default: the scene's title")
    add("--telescope", metavar="NAME", help="default: the first")
    options = parser.parse_args(arguments)
    try:
        draw(options)
    except Error as error:
        print(error, file=sys.stderr)
        return error.exit_code
    return 0


def draw(options):
    if not options.output.endswith((".png", ".pdf", ".svg")):
        raise Error(f"{options.output}: pictures are .png, .pdf or .svg")
    results = [open_result(path) for path in options.results]
    try:
        from photic import optics_plot, plot  # here, so that reading results needs no matplotlib
    except ImportError as error:
        raise Error(f"plots need matplotlib: {error}", exit_code=1) from error
    if any(is_optics(result) or is_spectra(result) for result in results):
        _expect_one(options)
        draws = optics_plot.figure if is_optics(results[0]) else optics_plot.spectra
        picture = draws(results[0], title=options.title)
    else:
        names = _names(options.results)
        picture = plot.figure(results, names, telescope=options.telescope, title=options.title)
    try:
        picture.savefig(options.output)
    except OSError as error:
        message = f"{options.output}: cannot write the picture: {error.strerror or error}"
        raise Error(message, exit_code=1) from error


def _expect_one(options):
    if len(options.results) > 1:
        raise Error("optics are drawn alone: give one file of `photic optics`, and nothing else")
    if options.telescope is not None:
        raise Error(f"{options.results[0]}: holds optics, and no telescopes (leave out --telescope)")


def _names(paths):
    """File names without their endings; whole paths where these would not differ."""
    names = [os.path.splitext(os.path.basename(path))[0] for path in paths]
    return names if len(set(names)) == len(names) else paths


if __name__ == "__main__":
    sys.exit(main())
