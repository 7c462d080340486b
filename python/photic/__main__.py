"""python3 -m photic plot out.nc [more.nc …] -o out.png; python3 -m photic analyse out.nc FUNCTION"""

import argparse
import os
import sys
import warnings

from photic import analyse
from photic.errors import Error
from photic.output import ending_of
from photic.result import is_optics, is_spectra
from photic.result import open as open_result


def main(arguments=None):
    parser = argparse.ArgumentParser(
        prog="photic", description="Shows results of Photic."
    )
    commands = parser.add_subparsers(dest="command", required=True)
    plot = commands.add_parser(
        "plot",
        help="draw echoes against depth and tallies, or optics",
        description="Draws the echoes of one result by channel, process and order, or by depth and "
        "wavelength if it has eight channels or more, or those of several results on the same axes, "
        "channel by channel, and each by order beside them; all telescopes, or those chosen. Tallies "
        "beside echoes follow below, where one result is drawn alone. From a "
        "file of `photic optics` it draws coefficients, phase functions and emitted light, or "
        "spectra.",
    )
    add = plot.add_argument
    several = {"action": "append", "default": [], "metavar": "NAME"}
    add("results", nargs="+", metavar="RESULT.nc", help="what `photic run` or `photic optics` wrote")
    add("-o", "--output", required=True, metavar="OUT.png", help="picture: .png, .pdf or .svg")
    add("--title", help="default: the scene's title")
    add("--telescope", **several, help="draw this telescope only; may be repeated [default: all]")
    add("--channel", **several, help="draw this channel only; may be repeated [default: all]")
    add("--width-mm", type=float, metavar="W", help="width of the picture, as for a journal's column")
    plot.set_defaults(run=draw)
    analyse.add_to(commands)
    options = parser.parse_args(arguments)
    try:
        with warnings.catch_warnings(record=True) as remarks:
            options.run(options)
    except Error as error:
        print(error, file=sys.stderr)
        return error.exit_code
    for remark in _in_lines(remarks):
        print(remark, file=sys.stderr)
    return 0


def _in_lines(remarks):
    """Each warning on a line; letters that the font lacks once for all."""
    texts = [str(remark.message).replace("\n", " ") for remark in remarks]
    lacking = any(text.startswith("Glyph ") for text in texts)
    lines = list(dict.fromkeys(text for text in texts if not text.startswith("Glyph ")))
    return lines + ["letters that the font of plots lacks are drawn as boxes"] * lacking


def draw(options):
    ending = _ending(options.output)
    if options.width_mm is not None and not 60 <= options.width_mm <= 500:
        raise Error(f"--width-mm {options.width_mm:g}: widths are from 60 to 500 mm")
    results = [open_result(path) for path in options.results]
    try:
        from photic import optics_plot, plot  # here, so that reading results needs no matplotlib
    except ImportError as error:
        raise Error(f"plots need matplotlib: {error}", exit_code=1) from error
    if any(is_optics(result) or is_spectra(result) for result in results):
        _expect_one(options)
        draws = optics_plot.figure if is_optics(results[0]) else optics_plot.spectra
        picture = draws(results[0], title=options.title, width_mm=options.width_mm)
    else:
        names = _names(options.results)
        chosen = {"telescopes": options.telescope, "channels": options.channel}
        look = {"title": options.title, "width_mm": options.width_mm}
        picture = plot.figure(results, names, **chosen, **look)
    try:
        picture.savefig(options.output, format=ending)
    except OSError as error:
        message = f"{options.output}: cannot write the picture: {error.strerror or error}"
        raise Error(message, exit_code=1) from error


def _ending(path):
    return ending_of(path, (".png", ".pdf", ".svg"), "pictures are .png, .pdf or .svg", "echoes.png", "picture")[1:]


def _expect_one(options):
    if len(options.results) > 1:
        raise Error("optics are drawn alone: give one file of `photic optics`, and no other")
    for option, given in (("telescope", options.telescope), ("channel", options.channel)):
        if given:
            raise Error(f"{options.results[0]}: holds optics, and no {option}s (leave out --{option})")


def _names(paths):
    """File names without their endings; whole paths where these would not differ."""
    names = [os.path.splitext(os.path.basename(path))[0] for path in paths]
    return names if len(set(names)) == len(names) else paths


if __name__ == "__main__":
    sys.exit(main())
