"""The program beside the module, the bundled scenes, errors and warnings."""
from __future__ import annotations

import atexit
import os
import re
import shutil
import sys
import warnings
from contextlib import contextmanager
from pathlib import Path
from typing import Iterator

from . import _native

_HERE = Path(__file__).parent
_OPTION = re.compile(r"--([a-z]+(?:-[a-z]+)*)")


class Error(RuntimeError):
    """A file, a shader or a driver is at fault. The message is one line: `file[:line:col]: what: what to do`."""


class Remark(UserWarning):
    """A decision that was not asked for, or a part of a file that is left out."""


def program() -> Path:
    """Returns the program `steradian` of this installation.

    It compiles shaders that others wrote, checks assignments and runs suites, each in a process of its own. $STERADIAN names
    another one.
    """
    named = os.environ.get("STERADIAN")
    beside = [_HERE / "_prefix" / "bin" / "steradian",  # in a wheel
              _HERE.parent.parent / "steradian"]  # in a build folder
    for file in ([Path(named)] if named else []) + beside:
        if file.is_file():
            return file.absolute()
    found = shutil.which("steradian")
    if not found:
        raise Error("steradian: the program is not beside the module: install the package again, or name it in $STERADIAN")
    return Path(found).absolute()


def _scenes() -> Path:
    folder = program().parent
    for place in (folder / "scenes", folder.parent / "share" / "steradian" / "scenes"):
        if place.is_dir():
            return place
    raise Error(f"{folder}: the bundled scenes are not there: install the package again")


def samples() -> list[str]:
    """Returns the names of the bundled scenes.

    >>> "cornell" in steradian.samples()
    True
    """
    return sorted(file.stem for file in _scenes().glob("*.gltf"))


def sample(name: str) -> Path:
    """Returns the file of a bundled scene. Raises ValueError for another name."""
    file = _scenes() / f"{name}.gltf"
    if not file.is_file():
        raise ValueError(f"name: '{name}' is none of {', '.join(samples())}")
    return file


def python_words(text: str) -> str:
    """Returns a message with options as arguments: `--exr-type half` is `exr_type half`."""
    return _OPTION.sub(lambda found: found.group(1).replace("-", "_"), text)


@contextmanager
def told_in_python() -> Iterator[None]:
    """Raises errors of the native part with options as arguments."""
    try:
        yield
    except (Error, ValueError) as error:
        raise type(error)(python_words(str(error))) from None


def warn(text: str) -> None:
    """Warns at the line of the caller outside of this package."""
    level, frame = 1, sys._getframe()
    while frame.f_back and Path(frame.f_code.co_filename).parent == _HERE:
        level, frame = level + 1, frame.f_back
    warnings.warn(python_words(text), Remark, stacklevel=level)


def start() -> None:
    _native.start(Error, warn, str(program()))
    atexit.register(_native.end)
