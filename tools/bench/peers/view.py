"""The picture that every renderer of this bench draws, as one JSON argument of its script.

A script draws `frames` frames of the same view, reads each back as 8-bit RGB, and writes the last one as PNG. The bench
times the whole process: a frame costs what more frames add.
"""
import json
import sys
from dataclasses import asdict, dataclass


@dataclass
class View:
    scene: str             # .glb, or for Mitsuba an exported folder
    output: str            # .png
    width: int = 1280
    height: int = 720
    frames: int = 1
    eye: tuple = (0.0, 0.4, 3.2)       # [m]
    target: tuple = (0.0, 0.0, 0.0)    # [m]
    fov: float = 45.0                  # from bottom to top [degrees]
    light: tuple | None = (2.0, 2.5, 3.0)    # a point light [m], or none: the scene has its own
    intensity: float = 100.0           # of it [cd]
    near: float = 0.01                 # of the camera [m]
    far: float = 100.0

    def argument(self) -> str:
        return json.dumps(asdict(self))


def view() -> View:
    """Returns the view of this process's argument."""
    return View(**json.loads(sys.argv[1]))
