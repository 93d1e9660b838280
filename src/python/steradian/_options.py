"""Arguments of Python as texts of the table of options, which the command line has as well."""
from __future__ import annotations

import difflib
import numbers
import os
from typing import Any, Mapping

from . import _native

TABLE = {row["key"]: row for row in _native.options()}
# Sequences, and files: these belong to the command line.
_LEFT_OUT = {"frames", "fps", "turntable", "turn_axis", "scene", "variant", "strict"}
RENDER = {key for key, row in TABLE.items() if row["of_render"]} - _LEFT_OUT
PROBE = {key for key, row in TABLE.items() if row["of_probe"]} - _LEFT_OUT
_LISTS = {"aov": ",", "environment": ",", "background": ","}


def _number(value: Any) -> str:
    return repr(value.item() if hasattr(value, "item") else value)


def _size(value: Any) -> str:
    if isinstance(value, str):
        return value
    try:
        width, height = value
    except (TypeError, ValueError):
        raise ValueError(f"size: {value!r} is not (width, height)") from None
    return f"{width}x{height}"


def _share(value: Any) -> str:
    """0.005 and "0.5%" are half a percent."""
    return value if isinstance(value, str) else f"{float(value) * 100:.12g}%"


def _layers(value: Any) -> str:
    return "lights" if value is True else str(value)


_SPECIAL = {"size": _size, "error": _share, "layers": _layers}


def texts(given: Mapping[str, Any], allowed: set[str], function: str) -> dict[str, list[str]]:
    """Returns the options that are given, each as its texts. Raises TypeError for an option that the function does not take."""
    result = {}
    for key, value in given.items():
        if key not in allowed:
            near = difflib.get_close_matches(key, allowed, 1)
            raise TypeError(f"{function}() got an unexpected option '{key}'"
                            + (f": did you mean '{near[0]}'?" if near else f": it takes {', '.join(sorted(allowed))}"))
        if value is None or value is False:
            continue
        result[key] = _texts_of(key, value)
    return result


def _texts_of(key: str, value: Any) -> list[str]:
    if TABLE[key]["is_flag"]:
        return [""]
    if key in _SPECIAL:
        return [_SPECIAL[key](value)]
    if isinstance(value, (str, os.PathLike)):
        return [os.fspath(value)]
    if isinstance(value, numbers.Number) or hasattr(value, "item") and getattr(value, "size", 0) == 1:
        return [_number(value)]
    if key in _LISTS:
        return [_LISTS[key].join(v if isinstance(v, str) else _number(v) for v in value)]
    if key == "shaders":
        return [os.fspath(folder) for folder in value]
    return [str(value)]
