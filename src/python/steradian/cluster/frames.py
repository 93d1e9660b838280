"""Frames of an animation, or of a turntable, on workers."""
from __future__ import annotations

import argparse
import os
import re
import sys
from pathlib import Path
from typing import Any, Callable

from . import work
from .failure import Failure
from .files import bundle_of, named_files
from .grading import write_whole
from .tasks import Cluster


def frame_name(pattern: str, frame: int) -> str:
    """As `render` names it: #### and %04d are the number with as many digits."""
    name = re.sub(r"#+", lambda m: f"{frame:0{len(m[0])}d}", pattern)
    return re.sub(r"%0?(\d*)d", lambda m: f"{frame:0{int(m[1] or 1)}d}", name)


def frames_of(arguments: argparse.Namespace) -> range:
    """The numbers of all frames: those that are named, or a whole turn."""
    turn, named = arguments.turntable, arguments.frames
    if not turn and not named:
        raise Failure("no frames: write --frames FIRST:LAST for those of an animation, or --turntable COUNT")
    first, last = named or (0, turn - 1)
    if turn and last >= turn:
        raise Failure(f"--frames {first}:{last}: is beyond the {turn} pictures of --turntable: the last one is {turn - 1}")
    return range(first, last + 1)


def require_outputs(outputs: list[Path]) -> None:
    for output in outputs:
        if output.suffix.lower() in (".mp4", ".webm"):
            raise Failure(f"{output}: workers make pictures: write frames, as in {output.stem}.####.png, and encode them with ffmpeg, or use steradian render")
        if frame_name(output.name, 0) == output.name:
            raise Failure(f"{output}: all frames would have this name: write #### where the number belongs")
        if not output.parent.is_dir():
            raise Failure(f"{output.parent}: no folder: make it")


class Rendering:
    """The frames of one command."""

    def __init__(self, arguments: argparse.Namespace) -> None:
        self.arguments = arguments
        self.said: set[str] = set()
        self.here = Path.cwd()
        words = [str(arguments.scene), *arguments.options]
        words += ["--turntable", str(arguments.turntable)] if arguments.turntable else []
        files = named_files(arguments.scene)
        for word in arguments.options:
            if not word.startswith("-") and os.path.exists(word):
                files |= {Path(os.path.abspath(word))} if os.path.isdir(word) else named_files(Path(word))
        self.root = Path(os.path.commonpath([self.here, *files]))
        # A relative name leads to the same file in the worker's folder; an absolute one becomes a place there.
        self.words = [("place", os.path.relpath(word, self.root)) if os.path.isabs(word) and os.path.exists(word) else word for word in words]
        self.bundle = bundle_of(self.root, files)

    def is_there(self, frame: int) -> bool:
        return all((output.parent / frame_name(output.name, frame)).is_file() for output in self.arguments.output)

    def needs_exposure(self) -> bool:
        """The first frame's automatic exposure is that of all, as when one process renders them."""
        options = self.arguments.options
        is_fixed = "--exposure" in options and options[options.index("--exposure") + 1:][:1] != ["auto"]
        return not is_fixed and any(output.suffix.lower() in (".png", ".jpg", ".jpeg") for output in self.arguments.output)

    def leave_out_exposure(self) -> None:
        if "--exposure" in self.words:
            at = self.words.index("--exposure")
            del self.words[at:at + 2]

    def keep(self, part: list[int], result: tuple[dict[str, bytes], str, float | None]) -> float | None:
        pictures, remarks, ev100 = result
        for output in self.arguments.output:
            for frame in part:
                name = frame_name(output.name, frame)
                if name not in pictures:
                    raise Failure(f"frame {frame}: the worker made no {name}: it made {', '.join(pictures) or 'nothing'}")
                if not (self.arguments.resume and (output.parent / name).is_file()):  # the first frame may only tell its exposure
                    write_whole(output.parent / name, pictures[name])
        for line in set(remarks.splitlines()) - self.said:
            self.said.add(line)
            print(line, file=sys.stderr, flush=True)
        return ev100

    def run(self, cluster: Cluster, parts: list[list[int]], more: list[str]) -> float | None:
        """@return the exposure of the last part"""
        exposures: list[float | None] = []
        names = [output.name for output in self.arguments.output]
        by_key = {f"frame {part[0]}" if len(part) == 1 else f"frames {part[0]} to {part[-1]}": part for part in parts}

        def task(part: list[int]) -> Callable[[], Any]:
            return lambda: cluster.submit(work.render_frames, self.arguments.program, ("bundle", self.bundle[0]), os.path.relpath(self.here, self.root),
                                          self.words + more, names, part[0], part[-1])

        cluster.run("rendering", ((key, task(part)) for key, part in by_key.items()), sum(map(len, parts)),
                    lambda key, result: exposures.append(self.keep(by_key[key], result)), weight=lambda key: len(by_key[key]))
        return exposures[-1] if exposures else None


def render(arguments: argparse.Namespace) -> int:
    every = frames_of(arguments)
    first = every[0]
    require_outputs(arguments.output)
    if not arguments.scene.is_file():
        raise Failure(f"{arguments.scene}: no file: name a .gltf or .glb file")
    rendering = Rendering(arguments)
    frames = [f for f in every if not (arguments.resume and rendering.is_there(f))]
    if not frames:
        return 0
    cluster = Cluster(arguments.scheduler, arguments.program)
    try:
        cluster.share(rendering.bundle)
        more: list[str] = []
        if rendering.needs_exposure():
            ev100 = rendering.run(cluster, [[first]], [])
            if ev100 is not None:
                rendering.leave_out_exposure()
                more = ["--exposure", repr(ev100)]
            frames = [f for f in frames if f != first]
        size = 1 if arguments.resume else arguments.chunk  # what is there may lie between what is not
        rendering.run(cluster, [frames[i:i + size] for i in range(0, len(frames), size)], more)
    finally:
        cluster.close()
    return 0
