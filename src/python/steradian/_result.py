"""Pictures that were rendered."""
from __future__ import annotations

import base64
import json
import os
import tempfile
from html import escape
from pathlib import Path
from typing import Any, Sequence

import numpy as np
from numpy.typing import NDArray

from . import _native
from ._program import told_in_python


def embedded_png(png: bytes, width: int, text: str, count: int = 1) -> str:
    """Returns `count` pictures side by side, `width` wide each, as HTML. Small ones have pixels that one can see."""
    shown = max(1, 288 // width) * width * count
    return (f'<img src="data:image/png;base64,{base64.b64encode(png).decode()}" alt="{escape(text)}" '
            f'style="width:{shown}px;max-width:100%;image-rendering:pixelated">')


class Result:
    """A picture: `image`, `layers` and `aov` are arrays that cannot be written to; copy them to change them."""

    def __init__(self, native: _native.RenderedPicture, aov: Sequence[str] = ()) -> None:
        self._native = native
        self._image = native.image
        #: The numbers of `steradian render --json`: samples, error, seconds by phase, driver.
        self.statistics: dict[str, Any] = json.loads(native.summary)
        #: float32, height × width × 4: R, G, B [`unit`] and coverage.
        self.image: NDArray[np.float32] = np.asarray(self._image.channels(0, 4))
        groups: dict[str, list[int]] = {}
        for number, name in enumerate(self._image.channel_names[4:], 4):
            groups.setdefault(name.rpartition(".")[0], []).append(number)
        arrays = {name: np.asarray(self._image.channels(numbers[0], 0 if len(numbers) == 1 else len(numbers)))
                  for name, numbers in groups.items()}
        #: float32, height × width × 3 for each light and for "emission"; their sum is the picture.
        self.layers: dict[str, NDArray[np.float32]] = {name: array for name, array in arrays.items() if name not in aov}
        #: float32, height × width or height × width × 3, by the names that were asked for.
        self.aov: dict[str, NDArray[np.float32]] = {name: array for name, array in arrays.items() if name in aov}

    @property
    def size(self) -> tuple[int, int]:
        """(width, height) in pixels."""
        return self._image.width, self._image.height

    @property
    def unit(self) -> str:
        """The unit of `image`: cd/m^2, or that of the view."""
        return str(self.statistics["unit"])

    @property
    def samples(self) -> int:
        """The samples of the pixels that have most of them."""
        return int(self.statistics["samples"])

    @property
    def error(self) -> float | None:
        """The estimated relative error against the converged picture, √relMSE; None where it was not estimated."""
        return self.statistics.get("error")

    @property
    def exposure(self) -> float:
        """The EV100 that `save` and `display` take: that of `render`, or the automatic one."""
        return self._native.exposure

    @property
    def attributes(self) -> dict[str, str]:
        """How the picture was made, as the attributes of an .exr say it."""
        return self._image.attributes

    def save(self, *files: str | os.PathLike[str], exposure: float | None = None, tone_curve: str | None = None,
             exr_type: str | None = None) -> None:
        """Writes the picture to all files or to none: .exr and .hdr as radiance, .png and .jpg for screens.

        exposure: EV100; None: automatic, or that of `render`. exr_type: "float" or "half".
        """
        with told_in_python():
            self._native.save([os.fspath(file) for file in files], exposure, tone_curve or "", exr_type or "")

    def display(self, exposure: float | None = None, tone_curve: str | None = None) -> NDArray[np.uint8]:
        """Returns uint8, height × width × 3: sRGB codes for a screen, as a .png has them."""
        with told_in_python():
            shown = np.asarray(self._native.displayed(exposure, tone_curve or "").channels(0, 3))
        codes: NDArray[np.uint8] = (np.clip(shown, 0, 1) * 255 + 0.5).astype(np.uint8)
        return codes

    def luminance(self) -> NDArray[np.float32]:
        """Returns float32, height × width: 0.2126 R + 0.7152 G + 0.0722 B."""
        return self.image[..., :3] @ np.array([0.2126, 0.7152, 0.0722], np.float32)

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> NDArray[Any]:
        return np.array(self.image, dtype=dtype, copy=copy if copy is not None else True)

    def _repr_png_(self) -> bytes:
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder, "picture.png")
            self._native.displayed(None, "").write(str(file), "8bit")
            return file.read_bytes()

    def _repr_html_(self) -> str:
        error = f", estimated error {100 * self.error:.2g} %" if self.error is not None else ""
        caption = (f"{Path(self.statistics['scene']).name}, {self.size[0]}×{self.size[1]}, {self.samples} samples{error}, "
                   f"{self.statistics['seconds']['total']:.1f} s")
        return (f'<figure>{embedded_png(self._repr_png_(), self.size[0], caption)}'
                f"<figcaption>{escape(caption)}</figcaption></figure>")

    def __repr__(self) -> str:
        return f"<Result {self.size[0]}x{self.size[1]}, {self.samples} samples, {self.unit}>"
