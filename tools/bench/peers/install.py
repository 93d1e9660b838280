"""Installs the peers from package registries, each into a folder of its own outside the tree."""
import glob
import shutil
import subprocess
import sys
import venv
from dataclasses import dataclass, field
from pathlib import Path

CACHE = Path.home() / ".cache" / "steradian-peers"
PIP = {  # name: what `pip install` gets, call by call
    "threepp": [["threepp", "numpy", "pillow"]],
    "panda3d": [["panda3d", "panda3d-simplepbr", "panda3d-gltf"]],
    "f3d": [["f3d"]],
    "pyvista": [["pyvista"]],
    # It names versions of its dependencies that Python 3.10 and later refuse.
    "pyrender": [["freetype-py", "imageio", "networkx", "numpy", "pillow", "pyglet", "pyopengl", "scipy", "six", "trimesh"],
                 ["--no-deps", "pyrender==0.1.45"]],
    "filly": [["filly", "pillow"]],
    "mitsuba": [["mitsuba==3.9.1", "numpy"]],
}
ANGLE = {"threejs": "gl-egl", "threejs-swiftshader": "swiftshader"}  # the GL under three.js in Chromium, which may choose another
PEERS = (*PIP, *ANGLE)
DEFAULT_PEERS = (*PIP, "threejs")
THREE = "three@0.187.0"
# LLVM of Debian and others. With 14 to 16 Mitsuba 3.9.1 crashes.
LLVM = ("/usr/lib/x86_64-linux-gnu/libLLVM.so.19.1", "/usr/lib/x86_64-linux-gnu/libLLVM.so.[12][0-9].*", "/usr/lib64/libLLVM.so.[12][0-9].*")


class Unavailable(Exception):
    """A peer that cannot be had, with the reason."""


@dataclass
class Installed:
    python: Path
    environment: dict = field(default_factory=dict)
    remark: str = ""


def run_installer(command: list, what: str):
    run = subprocess.run(list(map(str, command)), capture_output=True, text=True)
    if run.returncode:
        raise Unavailable(f"{what}: {(run.stderr.strip() or 'it failed').splitlines()[-1]}")


def venv_with(name: str, packages: list, cache: Path) -> Path:
    """Returns the Python of a venv with these packages, which it makes at the first call. @throws Unavailable"""
    folder = cache / name
    python = folder / "bin" / "python"
    wanted = repr(packages)
    mark = folder / "complete"
    if mark.exists() and mark.read_text() in ("", wanted):
        return python
    print(f"installing {name} into {folder}", file=sys.stderr, flush=True)
    venv.create(folder, with_pip=True, clear=True)
    for words in packages:
        run_installer([python, "-m", "pip", "install", "--quiet", "--disable-pip-version-check", *words], "pip")
    mark.write_text(wanted)
    return python


def llvm() -> str | None:
    """Returns the path of an LLVM that Mitsuba works with."""
    return next((path for pattern in LLVM for path in sorted(glob.glob(pattern))), None)


def mitsuba(cache: Path) -> Installed:
    python, library = venv_with("mitsuba", PIP["mitsuba"], cache), llvm()
    if library:
        return Installed(python, {"DRJIT_LIBLLVM_PATH": library, "STERADIAN_VARIANT": "llvm_ad_rgb"}, "llvm_ad_rgb")
    return Installed(python, {"STERADIAN_VARIANT": "scalar_rgb"}, "scalar_rgb, since there is no LLVM 17 or later: install libllvm19")


def three(name: str, cache: Path) -> Installed:
    folder = cache / "three"
    package = folder / "node_modules" / "three"
    if not any(map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))):
        raise Unavailable("no Chromium: install the package chromium")
    if not (package / "package.json").exists():
        if not shutil.which("npm"):
            raise Unavailable("no npm: install the package npm")
        print(f"installing {THREE} into {folder}", file=sys.stderr, flush=True)
        folder.mkdir(parents=True, exist_ok=True)
        run_installer(["npm", "install", "--prefix", folder, "--no-audit", "--no-fund", "--silent", THREE], "npm")
    return Installed(Path(sys.executable), {"STERADIAN_THREE": str(package), "STERADIAN_ANGLE": ANGLE[name]})


def installed(peer: str, cache: Path = CACHE) -> Installed:
    """@throws Unavailable"""
    if peer == "mitsuba":
        return mitsuba(cache)
    if peer in ANGLE:
        return three(peer, cache)
    return Installed(venv_with(peer, PIP[peer], cache))
