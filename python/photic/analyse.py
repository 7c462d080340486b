"""The command `photic analyse RESULT.nc FUNCTION`: numbers derived from a result, with their errors."""

import datetime
import os
import shlex
import shutil
import sys
import tomllib

import netCDF4
import xarray

from photic import analysis_table
from photic.analysis import FUNCTIONS, analysed, function_named, scene_text
from photic.core import VERSION
from photic.errors import Error
from photic.locks import netcdf_lock
from photic.output import ending_of, written_whole

CONTENT = "analysis"  # of a netCDF file: the attribute photic_content
MARK = "written by photic analyse"  # in its other files
PICTURES = (".png", ".pdf", ".svg")
WIDTH = 100  # of a table that goes to no terminal
MANY = ("telescope", "channel", "environment")
ALONE = ("of", "over", "reference", "share", "against", "clean", "formula")


def add_to(commands):
    """Adds the command to those of `python3 -m photic`."""
    parser = commands.add_parser(
        "analyse",
        allow_abbrev=False,
        help="derive numbers from a result, with their errors",
        description="Applies a function of the package to a result, or to its scene, and prints a table. "
        f"Functions: {', '.join(FUNCTIONS)}.",
    )
    add = parser.add_argument
    add("file", metavar="RESULT.nc", help="what `photic run` wrote; for overlap and lidar-equation a scene, too")
    add("function", metavar="FUNCTION", help="as photic.k_lidar, by the name k-lidar")
    for name in MANY:
        add(f"--{name}", action="append", default=[], metavar="NAME", help="may be repeated")
    for name in ALONE:
        add(f"--{name}", help="a keyword of the function, of which help(photic) has the meaning")
    add("--depths", nargs=2, metavar=("FIRST", "LAST"), help="of the fit of k-lidar [m]")
    add("-o", "--output", metavar="OUT", help="write them, too: .nc, .csv, or a picture: .png, .pdf or .svg")
    add("--json", action="store_true", help="print as JSON")
    add("--force", action="store_true", help="replace whatever is where the output goes")
    parser.set_defaults(run=run)


def run(options):
    function = function_named(options.function)
    ending = _expect_output(options)
    given = {name: getattr(options, name) for name in (*MANY, *ALONE, "depths")}
    found, subject = analysed(options.file, options.function, given)
    text = scene_text(subject)
    title = tomllib.loads(text).get("title", "")
    about = {"title": f"{function.title}: {title}" if title else function.title, "command": _command(options, given)}
    if ending is not None:
        _write(options, ending, found, subject, text, about)
    show = analysis_table.as_json(found, **about) if options.json else _table(found, about)
    try:
        sys.stdout.write(show)
        sys.stdout.flush()
    except OSError as error:
        sys.stdout = None  # which Python flushes once more, at its end
        raise Error(f"photic: cannot write to standard output: {error.strerror}", exit_code=1) from error


def _table(found, about):
    width = shutil.get_terminal_size().columns if sys.stdout.isatty() else WIDTH
    return analysis_table.table(found, about["title"], width)


def _command(options, given):
    """The command line, as the program has it."""
    words = ["photic", "analyse", options.file, options.function]
    for name, value in given.items():
        for each in value if name in MANY else [value] if value is not None else []:
            words += [f"--{name}", *(each if name == "depths" else [each])]
    return shlex.join(words + (["-o", options.output] if options.output else []))


def _expect_output(options):
    """The ending of the output, None without one. Raises photic.Error for what it may not replace."""
    path = options.output
    if path is None:
        return None
    what = f"outputs are .nc, .csv, .png, .pdf or .svg (write -o {path}.nc)"
    ending = ending_of(path, (".nc", ".csv", *PICTURES), what, f"{options.function}.nc")
    if os.path.exists(path):
        if os.path.exists(options.file) and os.path.samefile(path, options.file):
            raise Error(f"{path}: is what is analysed: choose another name with -o")
        if not options.force and not _is_ours(path, ending):
            raise Error(f"{path}: is there already, no file of photic analyse, and is left as it is (--force replaces it)")
    return ending


def _is_ours(path, ending):
    """Returns whether a file is an earlier output of this command, or an empty one."""
    try:
        if os.path.getsize(path) == 0:
            return True
        if ending == ".nc":
            with netcdf_lock, netCDF4.Dataset(path) as file:
                return getattr(file, "photic_content", "") == CONTENT
        with open(path, "rb") as file:
            return MARK.encode() in file.read()
    except OSError:
        return False


def _write(options, ending, found, subject, text, about):
    path = options.output
    if ending in PICTURES:
        _draw(path, ending, found, subject, tomllib.loads(text).get("title", ""))
        return
    if ending == ".csv":
        image = analysis_table.as_csv(found, about["title"], f"Photic {VERSION}, {MARK}: {about['command']}").encode()
    else:
        image = _netcdf(options, found.dataset, subject, text, about)
    with written_whole(path) as beside, open(beside, "wb") as file:
        file.write(image)


def _netcdf(options, dataset, subject, text, about):
    now = datetime.datetime.now(datetime.timezone.utc).strftime("%Y-%m-%dT%H:%M:%SZ")
    attributes = {
        "Conventions": "CF-1.10",
        "title": about["title"],
        "source": f"Photic {VERSION}, {MARK}",
        "history": f"{now}: {about['command']}",
        "photic_content": CONTENT,
        "function": options.function,
        "command": about["command"],
        "result": options.file,
        "scene": text,
        "optics_sources": getattr(subject, "attrs", {}).get("optics_sources", ""),
    }
    return _netcdf_image(dataset.assign_attrs({key: value for key, value in attributes.items() if value}))


def _netcdf_image(dataset):
    """The bytes of a file. It is made in memory, since HDF5 crashes where a disk is full."""
    with netcdf_lock:
        file = netCDF4.Dataset("in memory", mode="w", memory=1)
        dataset.dump_to_store(xarray.backends.NetCDF4DataStore(file))
        return bytes(file.close())


def _draw(path, ending, found, subject, title):
    try:
        from photic import analysis_plot  # here, so that tables need no matplotlib
    except ImportError as error:
        raise Error(f"plots need matplotlib: {error}", exit_code=1) from error
    picture = analysis_plot.figure(found, title, subject)
    with written_whole(path) as beside:
        picture.savefig(beside, format=ending[1:], metadata={"Software" if ending == ".png" else "Creator": f"Photic {VERSION}, {MARK}"})
