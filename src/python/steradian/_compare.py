"""Comparison of pictures: arrays, results and files."""
from __future__ import annotations

import json
import os
import tempfile
from dataclasses import dataclass
from html import escape
from pathlib import Path
from typing import Any, Sequence, Union

import numpy as np
from numpy.typing import NDArray

from . import _native
from ._program import told_in_python
from ._result import Result, embedded_png

Picture = Union[str, "os.PathLike[str]", NDArray[Any], Result]


@dataclass(frozen=True)
class Verdict:
    """One limit, and whether it is kept."""
    passed: bool
    line: str


@dataclass(frozen=True)
class Diagnosis:
    """The mistake that explains a difference; `residual` is the share of the difference that it leaves, 0 to 0.2."""
    name: str
    statement: str
    residual: float
    layer: str = ""


class Comparison:
    """Whether two pictures agree, by how much not, and why not. It is true if they agree."""

    def __init__(self, native: _native.Compared) -> None:
        self._native = native
        told = json.loads(native.json)
        self.passed: bool = told["passed"]
        self.verdicts = [Verdict(**row) for row in told["verdicts"]]
        #: Numbers by name: rmse, rel_mse, flip, ssim, …
        self.metrics: dict[str, Any] = {name: _numbers(value) for name, value in told["metrics"].items()}
        diagnosis = told.get("diagnosis")
        #: The mistake that explains the difference; None where they agree or no mistake with a name does.
        self.diagnosis = Diagnosis(**diagnosis) if diagnosis else None

    @property
    def error(self) -> NDArray[np.float32] | None:
        """float32, height × width: each pixel's error over its limit. NaN: not finite; -1: not compared. None: other sizes."""
        return _pixels(self._native.error, 0)

    @property
    def heat_map(self) -> NDArray[np.float32] | None:
        """float32, height × width × 3 in 0 to 1: the error as colours."""
        return _pixels(self._native.heat_map, 3)

    @property
    def side_by_side(self) -> NDArray[np.float32] | None:
        """float32, height × width × 3 in 0 to 1: test, reference and heat map."""
        return _pixels(self._native.side_by_side, 3)

    def __bool__(self) -> bool:
        return self.passed

    def __str__(self) -> str:
        lines = ["PASS" if self.passed else "FAIL"]
        lines += [f"  {'ok' if verdict.passed else 'FAIL':<5} {verdict.line}" for verdict in self.verdicts]
        if self.diagnosis:
            lines.append(f"  cause {self.diagnosis.statement} ({self.diagnosis.name})")
        return "\n".join(lines)

    def _repr_html_(self) -> str:
        text = f"<pre>{escape(str(self))}</pre>"
        if not self._native.side_by_side.width:
            return text
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder, "picture.png")
            self._native.side_by_side.write(str(file), "8bit")
            picture = file.read_bytes()
        return text + embedded_png(picture, self._native.side_by_side.width // 3, "test, reference, heat map", 3)


def _pixels(image: _native.Image, channels: int) -> NDArray[np.float32] | None:
    return np.asarray(image.channels(0, channels)) if image.width else None


def _numbers(value: Any) -> Any:
    """JSON has no nan and inf: they are texts there."""
    if isinstance(value, list):
        return [_numbers(part) for part in value]
    return float(value) if isinstance(value, str) else value


def native_image(picture: Picture) -> _native.Image:
    """Returns a picture in the form that the native part takes."""
    if isinstance(picture, Result):
        return picture._image
    if isinstance(picture, (str, os.PathLike)):
        return _native.read_image(os.fspath(picture))
    array = np.asarray(picture)
    bits = {np.dtype(np.uint8): 8, np.dtype(np.uint16): 16}.get(array.dtype, 0)
    pixels = array.astype(np.float32) / (2**bits - 1) if bits else array.astype(np.float32)
    if pixels.ndim == 2:
        pixels = pixels[..., None]
    if pixels.ndim != 3 or pixels.shape[2] not in (1, 3, 4) or 0 in pixels.shape:
        raise ValueError(f"a picture has the shape height × width × 1, 3 or 4, not {array.shape}")
    channels = {1: ["Y"], 3: ["R", "G", "B"], 4: ["R", "G", "B", "A"]}[pixels.shape[2]]
    return _native.Image(np.ascontiguousarray(pixels), channels, bits)


def read_image(file: str | os.PathLike[str]) -> tuple[NDArray[np.float32], list[str]]:
    """Reads any image file. Returns float32, height × width × channels, as stored, and the names of the channels."""
    with told_in_python():
        image = _native.read_image(os.fspath(file))
    return np.asarray(image.channels(0, len(image.channel_names))), image.channel_names


def compare(test: Picture, reference: Picture, limits: Sequence[str] | str = (), *, region: Sequence[int] | None = None,
            mask: Picture | None = None, noise: Sequence[Picture | float] = (), layer: str = "", encoding: str | None = None,
            allow_nonfinite: bool = False) -> Comparison:
    """Compares two pictures as `steradian compare` does.

    A picture is a `Result`, a file, or an array of height × width × 1, 3 or 4: floats are light, uint8 and uint16 sRGB codes.
    limits: such as ["rel=0.02@99.5%", "flip=0.03"]; none: the default ones. region: x, y, width, height in pixels, from the
    upper left corner. mask: compares only where its first channel exceeds 0.5. noise: standard errors of the test, the reference
    or both, as pictures or numbers. encoding: "linear" or "srgb".

    >>> picture = np.full((8, 8, 3), 2.0, np.float32)
    >>> comparison = steradian.compare(picture * np.pi, picture)
    >>> comparison.passed, comparison.diagnosis.name
    (False, 'pi_missing')
    """
    if encoding not in (None, "linear", "srgb"):
        raise ValueError(f"encoding: '{encoding}' is not one of linear, srgb")
    with told_in_python():
        native = _native.Limits()
        native.tolerances = [limits] if isinstance(limits, str) else list(limits)
        native.allows_nonfinite = allow_nonfinite
        if region is not None:
            if len(region) != 4:
                raise ValueError(f"region: {region} is not x, y, width, height")
            x, y, width, height = region
            native.region = x, y, width, height
        if mask is not None:
            native.mask = native_image(mask)
        native.noise = [native_image(np.full((1, 1, 1), n, np.float32) if isinstance(n, (int, float)) else n) for n in noise]
        native.layer = layer
        native.encoding = encoding or ""
        return Comparison(_native.compare(native_image(test), native_image(reference), native))
