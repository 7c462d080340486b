"""Scenes: what is simulated, checked as a whole at each change."""

from __future__ import annotations

import os
from collections.abc import Mapping
from typing import Any, Union

import xarray

from photic.core import SCENES, context, core
from photic.errors import Error, Problem, SceneError
from photic.names import file_name
from photic.simulation import File, Number, Run, Watcher, changes_of, refuse_unknown, start, text_of, warn, watcher_of

FLAGS = [
    "photons", "target", "max_time", "seed", "threads", "engine", "isa", "output", "continue_from", "force", "checkpoint"
]  # fmt: skip


class Scene:
    """A scene: source, telescopes, channels, sea and gates, as in a scene file.

        scene = photic.Scene.new("airborne")         # a starter; photic.Scene.kinds() lists them
        scene = photic.Scene.load("my.toml")         # a file
        scene = photic.Scene(text)                   # TOML
        scene = photic.Scene({"source": {...}, ...}) # the same as dicts and lists

        scene["sea.layer.0.chlorophyll_mg_m3"] = 0.5 # as --set does; names serve as numbers do
        del scene["sea.layer.0.cdom_440_per_m"]      # what the scene has by default takes its place
        scene.update({"gates.depth_max_m": 30, "gates.depth_step_m": 0.5})
        echo = scene.run(target=0.01)

    Keys, units and ranges are those of scene files (the guide, "The scene file"). A scene is checked as a
    whole when it is made and at each change, and a change that is refused leaves it as it was.
    Values are numbers, texts, true or false, lists and dicts of these, arrays of numpy or xarray. Files
    that a scene names are sought from the folder of its file; without one, from the current folder.
    Several threads may use a scene.

    Raises photic.SceneError with all that is wrong in `problems`, photic.Error for files that cannot be
    read. Source: docs/guide.md, which lists every key, and photic.Scene.schema().
    """

    def __init__(self, scene: Union[str, Mapping[str, Any]]) -> None:
        self._document = _document_of(scene)
        self._file: str | None = None

    @classmethod
    def load(cls, path: File) -> Scene:
        """The scene of a file. Raises photic.SceneError, and photic.Error if it cannot be read."""
        return cls._loaded(path, {})

    @classmethod
    def _loaded(cls, path: File, changes: Mapping[str, Any]) -> Scene:
        """The same with changes that are made before it is checked."""
        name = file_name("scene", path)
        return cls._of(core().Document.load(context(), name, _checked(changes)), os.fsdecode(name))

    @classmethod
    def _of(cls, document: Any, file: str | None) -> Scene:
        scene = cls.__new__(cls)
        scene._document = document
        scene._file = file
        return scene

    @classmethod
    def new(cls, kind: str) -> Scene:
        """A starter scene, as `photic new` writes it. Raises photic.Error for a kind that there is none of."""
        if not isinstance(kind, str):
            raise Error(f"kind: {kind!r} is no text")
        text = core().starter_text(text_of("kind", kind))
        return cls._of(core().Document.of_text(context(), text, f"{kind}.toml", os.fspath(SCENES), {}), None)

    @staticmethod
    def kinds() -> dict[str, str]:
        """The kinds of starter scenes, each with a sentence on it."""
        return dict(core().starter_kinds())

    @staticmethod
    def schema() -> str:
        """The JSON Schema of scenes: every key with its meaning, unit and range."""
        return str(core().schema())

    def __getitem__(self, path: str) -> Any:
        """The value at a path as it was given, or else as the scene has it by default. Raises KeyError."""
        return self._document.find(_path(path))

    def __contains__(self, path: object) -> bool:
        try:
            return isinstance(path, str) and self[path] is not None
        except (KeyError, SceneError):
            return False

    def __setitem__(self, path: str, value: Any) -> None:
        self.update({path: value})

    def __delitem__(self, path: str) -> None:
        self._document.take_away(_path(path))

    def update(self, values: Mapping[str, Any]) -> None:
        """Puts values at paths: all of them, checked once, or none. Raises photic.SceneError."""
        self._document.change(_checked(values))

    def toml(self) -> str:
        """The scene as it was given, as TOML: its very text as long as it has not been changed."""
        return str(self._document.toml())

    def save(self, path: File) -> None:
        """Writes the scene as TOML, whole or not at all, in the place of what is there. Raises
        photic.SceneError if it would be none there, since files that it names are elsewhere;
        photic.Error if it cannot be written."""
        text = self.toml()
        name = file_name("path", path)
        core().Document.of_text(context(), text, name, os.path.dirname(name), {})
        core().write_file(name, text)

    def copy(self) -> Scene:
        """Another scene of the same values."""
        return self._of(self._document.changed({}), self._file)

    __copy__ = copy

    def __deepcopy__(self, _: object) -> Scene:
        return self.copy()

    def __reduce__(self) -> tuple[object, ...]:
        """The scene as text, whose files are sought where they are."""
        document = self._document
        file = None if self._file is None else os.path.abspath(self._file)
        return _of_text, (self.toml(), document.name, os.path.abspath(document.folder), file)

    @property
    def remarks(self) -> list[str]:
        """What is not wrong, but worth knowing, a line each; warnings of its runs, too."""
        return list(self._document.remarks)

    def __repr__(self) -> str:
        return f"<photic.Scene {self._document.name}>"

    def _ipython_key_completions_(self) -> list[str]:
        found: list[str] = []
        for path in core().scene_paths():
            found += self._filled(path.split("."), "")
        return found

    def _filled(self, keys: list[str], before: str) -> list[str]:
        """The paths of a pattern, with the names or numbers that the scene has in the place of '*'."""
        if "*" not in keys:
            return [before + ".".join(keys)]
        at = keys.index("*")
        above = before + ".".join(keys[:at])
        elements = self[above] if above in self else []
        names = [each.get("name", number) for number, each in enumerate(elements) if isinstance(each, dict)]
        return [path for name in names for path in self._filled(keys[at + 1 :], f"{above}.{name}.")]

    def start(
        self,
        *,
        photons: Number | None = None,
        target: Number | None = None,
        max_time: Number | None = None,
        seed: Number | None = None,
        threads: int | None = None,
        engine: str | None = None,
        isa: str | None = None,
        output: File | None = None,
        continue_from: File | None = None,
        force: bool = False,
        checkpoint: Number | None = None,
        **unknown: Any,
    ) -> Run:
        """Begins a run, and returns it at once as a photic.Run. Keywords and errors are those of run()."""
        refuse_unknown(unknown, FLAGS)
        flags = {name: value for name, value in locals().items() if name in FLAGS and value is not None and value is not False}
        document = self._document.changed(changes_of(photons, target, max_time, seed))
        for remark in document.remarks:
            warn(remark)
        return start(
            document, self._file, threads=threads, engine=engine, isa=isa, output=output,
            continue_from=continue_from, force=force, checkpoint=checkpoint, command=_command(self._file, flags),
        )  # fmt: skip

    def run(
        self,
        *,
        photons: Number | None = None,
        target: Number | None = None,
        max_time: Number | None = None,
        seed: Number | None = None,
        threads: int | None = None,
        engine: str | None = None,
        isa: str | None = None,
        output: File | None = None,
        continue_from: File | None = None,
        force: bool = False,
        checkpoint: Number | None = None,
        progress: Watcher = False,
        **unknown: Any,
    ) -> xarray.Dataset:
        """Simulates the scene, and returns its result as photic.open gives results: units, dimensions and
        shapes are listed there. The keywords are the flags of `photic run`:

        photons   stop after so many: 1e7 or "1e7"
        target    stop when every gate is converged below this relative error: 0.01 or "1%"
        max_time  stop after this time: 60 [s] or "60s", "10min", "2h"
        seed      of the random numbers; the four above are values of the scene, which stays as it is
        threads   how many to use (default: all cores); the result does not depend on it
        engine    "lanes" (the default) or "scalar"; isa: "avx512", "avx2" or "baseline", of lanes
        output    a file for the result (.nc, .csv, .txt), or a folder; by default it is in memory alone
        continue_from  a result or checkpoint of the same scene to go on from; photons are the total then
        force     replaces whatever is at `output`; otherwise the run is refused where that took longer or
                  is of another scene, or leaves it with this result beside it, and warns
        checkpoint  how often the result so far is written beside `output`: 30 [s] or "30s"
        progress  True draws a line on standard error, again and again. A function is called about ten
                  times a second, in this thread, with a photic.Progress; if it returns False, the run
                  ends with what there is, and what it raises ends the run and is raised

        Remarks and warnings are Python warnings. Raises photic.SceneError for values that the scene
        does not take, photic.Error for all else. Ctrl-C raises photic.Interrupted, a KeyboardInterrupt,
        with the result so far in `partial`, and in `output`.
        """
        refuse_unknown(unknown, [*FLAGS, "progress"])
        watcher = watcher_of(progress)
        work = self.start(
            photons=photons, target=target, max_time=max_time, seed=seed, threads=threads, engine=engine, isa=isa,
            output=output, continue_from=continue_from, force=force, checkpoint=checkpoint,
        )  # fmt: skip
        return work.watched(watcher)


def run(
    scene: Union[Scene, File],
    set: Mapping[str, Any] | None = None,
    photons: Number | None = None,
    threads: int | None = None,
    output: File | None = None,
    **flags: Any,
) -> xarray.Dataset:
    """Simulates a scene, or a scene file, and returns its result as photic.open gives results.

    set      values that replace the scene's, e.g. {"sea.layer.0.chlorophyll_mg_m3": 0.5}; a number
             in the path counts from 0; the name of a layer, telescope or channel also works

    The other keywords, units, errors and warnings are those of photic.Scene.run. A scene that is handed
    over stays as it is.
    """
    values = set or {}
    if not isinstance(scene, Scene):
        changed = Scene._loaded(scene, values)
    else:
        changed = Scene._of(scene._document.changed(_checked(values)), scene._file)
    return changed.run(photons=photons, threads=threads, output=output, **flags)


def _of_text(text: str, name: str, folder: str, file: str | None) -> Scene:
    document = core().Document.of_text(context(), text, os.fsencode(name), os.fsencode(folder), {})
    return Scene._of(document, file)


def _document_of(scene: Any) -> Any:
    if isinstance(scene, Mapping):
        return core().Document.of_values(context(), scene, {})
    if not isinstance(scene, str):
        raise Error(f"a scene is TOML text or a dict, not {type(scene).__name__} (Scene.load reads a file)")
    if "\n" not in scene and scene.endswith(".toml"):
        raise Error(f"{scene}: the name of a file, and no TOML (Scene.load reads a file)")
    try:
        scene.encode()
    except UnicodeEncodeError as error:
        raise Error(f"the scene is no text that UTF-8 has: {error.reason} at character {error.start}") from None
    return core().Document.of_text(context(), scene, "scene", "", {})


def _checked(values: Any) -> dict[str, Any]:
    """Values by paths that are text."""
    if not isinstance(values, Mapping):
        raise Error(f"values by their paths are a dict, not {type(values).__name__}")
    return {_path(path): value for path, value in values.items()}


def _path(path: Any) -> str:
    reason = None
    if not isinstance(path, str):
        reason = "is no path"
    elif "\0" in path:
        reason = "has a null byte"
    elif not path.isascii() and any("\ud800" <= c <= "\udfff" for c in path):
        reason = "has a character that UTF-8 does not have"
    if reason is None:
        return str(path)
    advice = 'write text, as "sea.layer.0.chlorophyll_mg_m3"'
    problem = Problem(file=repr(path), line=0, column=0, path="", reason=reason, suggestion=advice)
    raise SceneError(f"{path!r}: {reason} ({advice})", [problem])


def _command(file: str | None, flags: dict[str, Any]) -> str:
    """The call for the history of the result."""
    words = [] if file is None else [repr(file)]
    shown = {name: os.fspath(value) if isinstance(value, os.PathLike) else value for name, value in flags.items()}
    return f"photic.run({', '.join(words + [f'{name}={value!r}' for name, value in shown.items()])})"
