"""Scenes as nested dicts of their keys, as in TOML: written, changed by paths, and read again."""

import copy
import json


def _key(key):
    return json.dumps(key) if "." in key else key


def _inline(value):
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{_key(key)} = {_inline(inner)}" for key, inner in value.items()) + " }"
    if isinstance(value, list):
        return "[" + ", ".join(map(_inline, value)) + "]"
    return json.dumps(value)


def _is_section(value):
    return isinstance(value, list) and bool(value) and isinstance(value[0], dict)


def _keys(table):
    return "".join(f"{_key(key)} = {_inline(value)}\n" for key, value in table.items())


def text_of(scene):
    """The TOML file of a scene: lists of tables at the top and in [sea] and [atmosphere] are sections of their own."""
    lone = {key: value for key, value in scene.items() if not isinstance(value, dict) and not _is_section(value)}
    out = _keys(lone)
    for name, value in scene.items():
        if name in lone:
            continue
        for table in value if isinstance(value, list) else [value]:
            inner = {key: v for key, v in table.items() if _is_section(v) and key == "layer"}
            out += f"\n[[{name}]]\n" if isinstance(value, list) else f"\n[{name}]\n"
            out += _keys({key: v for key, v in table.items() if key not in inner})
            for key, layers in inner.items():
                out += "".join(f"\n[[{name}.{key}]]\n{_keys(layer)}" for layer in layers)
    return out


def _part(node, key):
    return node[int(key)] if isinstance(node, list) else node[key]


def value_at(scene, path):
    for key in path.split("."):
        scene = _part(scene, key)
    return scene


def changed(scene, changes):
    """A copy of a scene in which the values at some paths are others."""
    scene = copy.deepcopy(scene)
    for path, value in changes.items():
        *way, last = path.split(".")
        node = value_at(scene, ".".join(way))
        node[int(last) if isinstance(node, list) else last] = value
    return scene


def without(scene, *keys):
    """A copy of a scene without some of its sections, or keys of sections ("simulation.tools")."""
    scene = copy.deepcopy(scene)
    for path in keys:
        *way, last = path.split(".")
        node = scene
        for key in way:
            node = node.get(key, {})
        node.pop(last, None)
    return scene
