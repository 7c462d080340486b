"""The files that commands write."""

import contextlib
import os
import tempfile

from photic.errors import Error


def ending_of(path, endings, what, example, kind="file"):
    """The ending of a file's name, ".nc", in small letters. Raises photic.Error for a folder, and for one that is none
    of the endings; what: the sentence that lists them."""
    if os.path.isdir(path) or path.endswith("/"):
        raise Error(f"{path}: is a folder: name a {kind} in it, as in {os.path.join(path, example)}")
    ending = os.path.splitext(path)[1].lower()
    if ending not in endings:
        raise Error(f"{path}: {what}")
    return ending


@contextlib.contextmanager
def written_whole(path):
    """The name of a file beside this one, which takes its place at the end of `with`, unless there was an exception.
    Raises photic.Error where it cannot be written."""
    folder, name = os.path.split(path)
    try:
        handle, beside = tempfile.mkstemp(prefix=f".{name}.", suffix=os.path.splitext(name)[1], dir=folder or ".")
        os.close(handle)
    except OSError as error:
        raise _not_written(path, error) from error
    try:
        yield beside
        os.chmod(beside, 0o666 & ~_mask())
        os.replace(beside, path)
    except OSError as error:
        raise _not_written(path, error) from error
    finally:
        with contextlib.suppress(FileNotFoundError):
            os.unlink(beside)


def _not_written(path, error):
    return Error(f"{path}: cannot write it: {error.strerror or error}", exit_code=1)


def _mask():
    mask = os.umask(0)
    os.umask(mask)
    return mask
