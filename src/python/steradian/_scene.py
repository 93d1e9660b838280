"""Scenes: files that are rendered and probed, with lights, materials and cameras to edit."""
from __future__ import annotations

import os
import sys
import time
from dataclasses import dataclass, replace
from operator import index
from typing import Any, Callable, Iterable, Iterator, Sequence

import numpy as np

from . import _native, _options
from ._probe import Probe, probe_of
from ._program import Error, told_in_python, warn
from ._result import Result

Progress = Callable[[str, float, str], None]
Vector = tuple[float, float, float]
_AXES = {"x": (1, 0, 0), "y": (0, 1, 0), "z": (0, 0, 1), "camera": None}  # that a camera turns around


@dataclass(frozen=True)
class Camera:
    """A camera in the file's world. Lengths are in metres, `fov` is the full vertical angle in degrees.

    >>> camera = steradian.Camera(eye=(0, 1, 4), target=(0, 1, 0), fov=40)
    >>> camera.text()
    'eye=0.0,1.0,4.0;target=0.0,1.0,0.0;fov=40.0'
    >>> camera.with_(fov=20).fov
    20
    """
    eye: Sequence[float]
    target: Sequence[float]
    up: Sequence[float] = (0.0, 1.0, 0.0)
    fov: float = 45.0
    ymag: float | None = None  # half the height of an orthographic picture [m]
    near: float | None = None  # [m]; None: by the scene's bounds
    far: float | None = None
    name: str = ""
    number: int | None = None  # of a camera of a file, as the file has it

    def with_(self, **changes: Any) -> Camera:
        """Returns this camera with other values."""
        return replace(self, **{"number": None, **changes})

    def turned(self, degrees: float, around: Sequence[float] | None = None, axis: str = "y") -> Camera:
        """Returns this camera turned by an angle around an axis through a point, its target if that is None.

        axis: "x", "y" (up) or "z" of the scene, or "camera", what is up in its picture. A positive angle goes counter-clockwise for someone
        whom the axis points to.

        >>> steradian.Camera(eye=(0, 1, 4), target=(0, 1, 0)).turned(90).eye
        (4.0, 1.0, 0.0)
        """
        around = self.target if around is None else around
        back = np.subtract(self.eye, self.target)
        k = np.asarray(_AXES[axis] if axis != "camera" else np.cross(back, np.cross(self.up, back)), float)
        k /= np.linalg.norm(k)
        angle = np.radians(degrees)

        def turn(v: Sequence[float], by: Sequence[float]) -> Vector:
            offset = np.subtract(v, by)  # Rodrigues' formula
            moved = np.cos(angle) * offset + np.sin(angle) * np.cross(k, offset) + (1 - np.cos(angle)) * np.dot(k, offset) * k
            x, y, z = (round(float(a), 12) for a in np.add(by, moved))
            return x, y, z

        return self.with_(eye=turn(self.eye, around), target=turn(self.target, around), up=turn(self.up, (0, 0, 0)))

    def text(self) -> str:
        """Returns the camera as `steradian render --camera` takes it."""
        if self.number is not None:
            return str(self.number)

        def triple(values: Sequence[float]) -> str:
            return ",".join(repr(float(value)) for value in values)

        parts = [f"eye={triple(self.eye)}", f"target={triple(self.target)}"]
        if tuple(self.up) != (0, 1, 0):
            parts.append(f"up={triple(self.up)}")
        parts.append(f"ymag={float(self.ymag)!r}" if self.ymag is not None else f"fov={float(self.fov)!r}")
        parts += [f"{key}={float(value)!r}" for key, value in (("near", self.near), ("far", self.far)) if value is not None]
        return ";".join(parts)


@dataclass(frozen=True)
class Animation:
    """An animation of a file; `duration` is in seconds."""
    name: str
    duration: float


class Scene:
    """A glTF file that is open. `load` makes it.

    `lights` and `materials` are lists of what the file has; their changes hold from the next picture on. Emissive surfaces
    are materials. `cameras` and `animations` are those of the file.
    """

    def __init__(self, native: _native.SceneFile) -> None:
        self._native = native
        contents = native.contents()
        self.animations = [Animation(*row) for row in contents["animations"]]
        self.cameras = [Camera(**row) for row in contents["cameras"]]
        self.variants: list[str] = contents["variants"]
        self.triangles: int = contents["triangles"]
        self.unit: str = contents["unit"]
        #: The corners of the box around all surfaces at rest [m].
        self.bounds: tuple[Vector, Vector] = contents["bounds"]
        self._warned = 0
        self._tell_warnings()
        self.lights: list[_native.Light]
        self.materials: list[_native.Material]
        self.reset()

    @property
    def file(self) -> str:
        """The path that was loaded."""
        return self._native.file

    @property
    def warnings(self) -> list[str]:
        """What the file asks for and does not get, one line each."""
        return self._native.warnings()

    def reset(self) -> None:
        """Drops all edits of lights and materials."""
        if not hasattr(self, "_file_lights"):
            self._file_lights = self._native.lights()
            self._file_materials = self._native.materials()
        self.lights = [light.copy() for light in self._file_lights]
        self._unedited = list(self.lights)
        self.materials = [material.copy() for material in self._file_materials]

    def render(self, size: tuple[int, int] | str | None = None, samples: int | None = None, error: float | str | None = None,
               camera: Camera | str | int | None = None, estimator: str | None = None, layers: bool | str = False,
               aov: Sequence[str] | str | None = None, progress: Progress | bool | None = None, **options: Any) -> Result:
        """Renders a picture as `steradian render` does, and returns it.

        size: (width, height) in pixels; None: 720 rows. samples: of each pixel, 16 by default. error: stops once the estimated
        relative error is so small, such as 0.005. camera: one of `cameras`, a `Camera`, a name, a number, or "auto". estimator:
        "sampled" or "analytic". layers: whether to render a layer for each light. aov: names of further channels, such as
        ["depth", "normal"]. progress: is called with what is rendered, the share that is done (0 to 1) and its state; False:
        nothing is shown; None: a bar on stderr, on a terminal. All other options are those of the command, with _ for -.

        Raises ValueError for options that make no sense, Error for a driver or a shader that is at fault, KeyboardInterrupt at
        Ctrl-C. Other threads of Python run meanwhile; pictures are rendered one after the other.

        >>> scene = steradian.load(steradian.sample("cornell"))
        >>> picture = scene.render(size=(16, 16), samples=2, layers=True, aov=["depth"])
        >>> list(picture.layers), picture.aov["depth"].shape
        (['emission', 'lamp'], (16, 16))
        """
        options |= {"size": size, "samples": samples, "error": error, "camera": camera, "estimator": estimator, "layers": layers,
                    "aov": aov}
        return self._render(options, progress, {})

    def _render(self, options: dict[str, Any], progress: Progress | bool | None, moment: dict[str, list[str]]) -> Result:
        texts = self._texts(options, _options.RENDER, "render") | moment
        with told_in_python(), _Bar(progress) as told:
            native = self._native.render(texts, self._edited_lights(), self._edited_materials(), told)
        self._tell_warnings()
        return Result(native, texts["aov"][0].split(",") if "aov" in texts else ())

    def frames(self, numbers: Iterable[int] | None = None, *, fps: float = 24.0, animation: str | int | None = None,
               **options: Any) -> Iterator[tuple[int, Result]]:
        """Yields frames of an animation, each with its number: frame n is at n / fps seconds, as in `steradian render --frames`.

        numbers: such as range(48); None: all of them. The other options are those of `render`. An automatic exposure is that of
        the first frame, and the camera "auto" frames the scene at rest, so that the frames do not flicker.

            for number, picture in scene.frames(range(48), size=(640, 360)):
                picture.save(f"walk.{number:04}.png")
        """
        if not fps > 0:
            raise ValueError(f"fps: {fps} is not above 0")
        if numbers is None:
            numbers = range(int(self._duration(animation) * fps + 1e-6) + 1)
        if options.get("camera") == "auto" or options.get("camera") is None and not self.cameras:
            options["camera"] = self.camera("auto")
        yield from self._sequence(((number, {"at": number / fps, "animation": animation}, {}) for number in numbers), options)

    def turntable(self, count: int = 36, camera: Camera | str | int | None = None, around: Sequence[float] | None = None, axis: str = "y",
                  **options: Any) -> Iterator[tuple[int, Result]]:
        """Yields `count` pictures from a camera that goes once around the scene, each with its number, as in
        `steradian render --turntable`.

        camera: as `render` takes it; picture 0 is from there. around: the point that it goes around; None: the middle of
        the scene. axis: that it goes around: "y" is up in the scene; "x", "z"; "camera": what is up in the first picture. The other options are those of `render`; an automatic exposure is that of the first picture. The studio
        or softboxes that light a dark scene stand still, unless `around` is given: then they are placed for each camera.

            for number, picture in scene.turntable(36, size=(640, 360)):
                picture.save(f"turn.{number:03}.png")
        """
        if index(count) < 1:
            raise ValueError(f"count: {count} is not 1 or more")
        if around is not None and len(around) != 3:
            raise ValueError(f"around: {around} is not x, y, z")
        if axis not in _AXES:
            raise ValueError(f"axis: {axis!r} is not one of {', '.join(_AXES)}")
        if around is None:
            moments = ((number, {"camera": camera}, {"turntable": [str(count)], "turn_axis": [axis], "frames": [f"{number}:{number}"]})
                       for number in range(count))
        else:
            begin = camera if isinstance(camera, Camera) else self.camera(camera)
            moments = ((number, {"camera": begin.turned(360 * number / count, around, axis) if number else begin}, {})
                       for number in range(count))
        yield from self._sequence(moments, options)

    def _sequence(self, moments: Iterable[tuple[int, dict[str, Any], dict[str, list[str]]]],
                  options: dict[str, Any]) -> Iterator[tuple[int, Result]]:
        exposure, progress = options.pop("exposure", None), options.pop("progress", None)
        for number, moment, texts in moments:
            picture = self._render({**options, **moment, "exposure": exposure}, progress, texts)
            if exposure in (None, "auto"):
                exposure = picture.exposure
            yield number, picture

    def _duration(self, animation: str | int | None) -> float:
        if animation == "all":
            return max((one.duration for one in self.animations), default=0.0)
        for number, one in enumerate(self.animations):
            if animation in (None, number, str(number), one.name):
                return one.duration
        names = ", ".join(one.name for one in self.animations)
        raise Error(f"{self.file}: no animation {animation!r}: " + (f"choose one of {names}" if names else "the file has none"))

    def camera(self, camera: str | int | None = None) -> Camera:
        """Returns a camera as `render` would choose it: by name, by number, "auto" for one that frames the scene, or the first.

        >>> steradian.load(steradian.sample("cornell")).camera("auto").with_(fov=20).fov
        20
        """
        with told_in_python():
            return Camera(**self._native.camera("" if camera is None else str(camera), self._edited_lights(), self._edited_materials()))

    def save(self, file: str | os.PathLike[str], camera: Camera | str | int | None = None) -> None:
        """Writes a copy of the scene's file with all edits of lights and materials: a .gltf or a .glb.

        What was not edited stays as it is in the file. A copy in another folder has within it the buffers, textures and
        profiles that the file refers to. camera: becomes the copy's first camera. Options of `render`, such as an
        environment, are not part of a scene. Raises Error for what glTF cannot state.

        >>> import tempfile, pathlib
        >>> scene = steradian.load(steradian.sample("cornell"))
        >>> scene.lights.append(steradian.point_light((0.1, 0.35, 0.15), flux=20, name="candle"))
        >>> with tempfile.TemporaryDirectory() as folder:
        ...     file = pathlib.Path(folder, "candle.glb")
        ...     scene.save(file)
        ...     steradian.load(file).lights
        [<Light 'candle': point, 1.59155 cd>]
        """
        with told_in_python():
            text = camera.text() if isinstance(camera, Camera) else "" if camera is None else str(camera)
            self._native.save(os.fspath(file), text, self._edited_lights(), self._edited_materials())

    def probe(self, x: int, y: int, size: tuple[int, int] | str | None = None, samples: int | None = None,
              camera: Camera | str | int | None = None, estimator: str | None = None, **options: Any) -> Probe:
        """Returns the equation at the pixel in column x and row y, counted from the upper left corner, term by term.

        The options are those of `render`; with the same ones L_o is that pixel of the picture.

        >>> scene = steradian.load(steradian.sample("cornell"))
        >>> probe = scene.probe(16, 30, size=(32, 32), samples=4)
        >>> [light.name for light in probe.lights]
        ['lamp']
        """
        options |= {"size": size, "samples": samples, "camera": camera, "estimator": estimator}
        texts = self._texts(options, _options.PROBE, "probe")
        with told_in_python():
            terms = self._native.probe(x, y, texts, self._edited_lights(), self._edited_materials())
        return probe_of((x, y), terms)

    def _texts(self, options: dict[str, Any], allowed: set[str], function: str) -> dict[str, list[str]]:
        if isinstance(options.get("camera"), Camera):
            options["camera"] = options["camera"].text()
        return _options.texts(options, allowed, function)

    def _edited_lights(self) -> list[_native.Light] | None:
        same = len(self.lights) == len(self._unedited) and all(a is b for a, b in zip(self.lights, self._unedited))
        return None if same and not any(light.is_edited for light in self.lights) else self.lights

    def _edited_materials(self) -> list[_native.Material]:
        return [material for material in self.materials if material.is_edited]

    def _tell_warnings(self) -> None:
        lines = self.warnings
        for line in lines[self._warned:]:
            warn(line)
        self._warned = len(lines)

    def __repr__(self) -> str:
        return (f"<Scene {self.file}: {self.triangles} triangles, {len(self.lights)} lights, {len(self.materials)} materials, "
                f"{len(self.cameras)} cameras, {len(self.animations)} animations>")


class _Bar:
    """A progress bar on stderr that shows itself after a second; only on a terminal."""

    def __init__(self, progress: Progress | bool | None) -> None:
        self.progress: Progress | None = progress if callable(progress) else None
        if progress is None and sys.stderr is not None and sys.stderr.isatty():
            self.progress = self._show
        self.begin = time.monotonic()
        self.is_shown = False

    def _show(self, what: str, share: float, state: str) -> None:
        if time.monotonic() - self.begin < 1.0:
            return
        self.is_shown = True
        filled = min(max(int(30 * share), 0), 30)
        sys.stderr.write(f"\r{what} [{'#' * filled}{'.' * (30 - filled)}] {state}\x1b[K")
        sys.stderr.flush()

    def __enter__(self) -> Progress | None:
        return self.progress

    def __exit__(self, *_: object) -> None:
        if self.is_shown:
            sys.stderr.write("\r\x1b[K")
            sys.stderr.flush()


def load(path: str | os.PathLike[str], *, scene: int | None = None, variant: str | None = None, strict: bool = False) -> Scene:
    """Reads a .gltf or .glb file and all that it refers to.

    scene: the number of a scene of the file. variant: a name of KHR_materials_variants. strict: raises Error where a part of
    the file is broken or not supported, which else is a warning (`Remark`).

    >>> steradian.load(steradian.sample("cornell"))
    <Scene ...cornell.gltf: 38 triangles, 0 lights, 4 materials, 1 cameras, 0 animations>
    """
    texts = _options.texts({"scene": scene, "variant": variant, "strict": strict}, {"scene", "variant", "strict"}, "load")
    with told_in_python():
        return Scene(_native.load(os.fspath(path), texts))
