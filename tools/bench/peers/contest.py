"""The same view by each renderer, as a function of the number of frames that measures one process."""
import json
import re
from pathlib import Path

from timing import Cost, Failed, measured

from . import install
from .view import View

HERE = Path(__file__).resolve().parent
SURFACELESS = {"EGL_PLATFORM": "surfaceless"}
PIXELS_A_BYTE = 100  # of a PNG file; more of them only where all are equal


def with_light(scene: Path, view: View, target: Path) -> Path:
    """Writes a copy of a .glb that has the view's light, for us: we render the lights of the file. @return the copy"""
    data = scene.read_bytes()
    length = int.from_bytes(data[12:16], "little")
    gltf = json.loads(data[20:20 + length])
    gltf.setdefault("extensions", {})["KHR_lights_punctual"] = {"lights": [{"type": "point", "intensity": view.intensity}]}
    gltf["extensionsUsed"] = sorted({*gltf.get("extensionsUsed", []), "KHR_lights_punctual"})
    gltf.setdefault("nodes", []).append({"translation": list(view.light), "extensions": {"KHR_lights_punctual": {"light": 0}}})
    for each in gltf["scenes"]:
        each.setdefault("nodes", []).append(len(gltf["nodes"]) - 1)
    text = json.dumps(gltf).encode()
    text += b" " * (-len(text) % 4)
    rest = data[20 + length:]
    target.write_bytes(data[:8] + (20 + len(text) + len(rest)).to_bytes(4, "little") + len(text).to_bytes(4, "little") + data[16:20] + text + rest)
    return target


class Contest:
    """One view of one scene. Pictures and copies of the scene lie in `folder`."""

    def __init__(self, view: View, program: Path, folder: Path, cache: Path = install.CACHE):
        self.view, self.program, self.folder, self.cache = view, program, folder, cache
        folder.mkdir(parents=True, exist_ok=True)
        self.lit = with_light(Path(view.scene), view, folder / "lit.glb") if view.light else Path(view.scene)
        self.camera = ["--camera", "eye={},{},{};target={},{},{};fov={}".format(*view.eye, *view.target, view.fov)]
        self.size = ["--size", f"{view.width}x{view.height}"]

    def ours(self, name: str, *options, scene: Path | None = None):
        """A frame more is a sample more. @param scene the file, if not the one with the view's light"""
        output = self.folder / f"{name}.png"

        def draw(frames: int) -> Cost:
            return measured([self.program, "render", scene or self.lit, "-o", output, *self.size, *self.camera, "--samples", frames, *options], output)
        return draw

    def ours_by_default(self, name: str):
        """The file itself with no option but the size: its own camera and lights or the studio, 16 samples, shadows."""
        output = self.folder / f"{name}.png"
        return lambda: measured([self.program, "render", self.view.scene, "-o", output, *self.size, "--json"], output)

    def exported(self) -> Path:
        """The scene as a folder for Mitsuba. @throws install.Unavailable"""
        target = self.folder / "for_mitsuba"
        try:
            measured([self.program, "export", self.lit, "--to", "mitsuba", target, *self.size, *self.camera, "--rig", "none"])
        except Failed as why:
            raise install.Unavailable(f"the scene cannot be exported: {why}") from None
        return target

    def theirs(self, peer: str):
        """@return the function and a remark @throws install.Unavailable"""
        got = install.installed(peer, self.cache)
        scene = self.exported() if peer == "mitsuba" else Path(self.view.scene)
        script = "render_threejs.py" if peer in install.ANGLE else f"render_{peer}.py"
        output = self.folder / f"{peer}.png"

        def draw(frames: int) -> Cost:
            view = View(**{**vars(self.view), "scene": str(scene), "frames": frames, "output": str(output)})
            cost = measured([got.python, HERE / script, view.argument()], output, {**SURFACELESS, **got.environment}, HERE)
            if output.stat().st_size < view.width * view.height / PIXELS_A_BYTE:
                raise Failed("its picture has one colour")
            return cost
        return draw, got.remark

    def driver_of(self, peer: str) -> str:
        """The GL that a peer says that it had, after its first frame; empty if it says nothing."""
        said = self.folder / f"{peer}.driver"
        found = re.search(r"llvmpipe|softpipe|SwiftShader", said.read_text()) if said.exists() else None
        return f"GL: {found.group() if found else said.read_text()}" if said.exists() else ""
