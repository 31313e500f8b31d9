"""Scenes as texts: files, and mappings built in Python."""

import json
import os

from . import _core


def _plain(value):
    """What JSON has no word for: fibers, numbers and arrays of numpy, paths."""
    if hasattr(value, "scene_keys"):
        return value.scene_keys()
    if hasattr(value, "tolist"):
        return value.tolist()
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    raise TypeError(f"a scene cannot hold a {type(value).__name__}")


def _without_none(value):
    if isinstance(value, dict):
        return {key: _without_none(one) for key, one in value.items() if one is not None}
    if isinstance(value, (list, tuple)):
        return [_without_none(one) for one in value]
    return _without_none(value.scene_keys()) if hasattr(value, "scene_keys") else value


def text_of(scene, name=None):
    """Text and name of a scene: a path, or a mapping with the keys of data/scenes/README.md.

    JSON is YAML. Python writes numbers with all their digits: they are read back to the same bits.
    """
    if isinstance(scene, (str, os.PathLike)):
        path = os.fspath(scene)
        try:
            return _core.read_scene(path), path
        except ValueError as error:
            if os.path.exists(path):
                raise
            raise FileNotFoundError(str(error)) from None
    return json.dumps(_without_none(scene), indent=1, ensure_ascii=False, default=_plain), name or "scene.yaml"


def settings_of(settings):
    """Settings as `--set KEY=VALUE` has them: values are written as YAML."""
    def word(value):
        return value if isinstance(value, str) else json.dumps(_without_none(value), default=_plain)
    return [(key, word(value)) for key, value in (settings or {}).items()]
