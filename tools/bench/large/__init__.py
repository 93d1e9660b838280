"""Large scenes that are made once, into a cache folder: their names, and the view in which each is seen whole."""
import hashlib
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
# As members of peers.view.View. A scene whose light is None has lights of its own.
VIEWS = {
    "atrium": {"eye": (-9.3, 3.3, 1.2), "target": (3.0, 3.4, -0.4), "fov": 62.0, "light": (-2.0, 6.5, 1.0), "intensity": 300.0},
    "million": {"eye": (0.0, 7.5, 13.0), "target": (0.0, 0.0, 0.5), "fov": 45.0, "light": (7.0, 8.0, 3.0), "intensity": 400.0},
    "thousand": {"eye": (1.2, 2.3, 11.5), "target": (0.0, 0.8, 0.0), "fov": 51.57, "light": None, "intensity": 0.0},
    "textures8k": {"eye": (0.0, 0.4, 3.2), "target": (0.0, 0.0, 0.0), "fov": 45.0, "light": (2.0, 2.5, 3.0), "intensity": 100.0},
}
WHAT = {
    "atrium": "a hall of two storeys: 260,000 triangles, 100 draws, 25 materials with 50 textures",
    "million": "a height field of 1,000,000 triangles",
    "thousand": "a hall under 1,000 point lights of its own",
    "textures8k": "a globe with a base colour and a normal map of 8192² each",
}
PACKAGES = [["numpy", "pillow"]]  # what build.py needs, as a peer's list


def made(words: list, cache: Path, python: Path) -> Path:
    """
    Returns the .glb that build.py makes of these words, e.g. ["atrium"] or ["heights", "500"]; makes it if the cache lacks it.
    @param python one that has PACKAGES @throws RuntimeError with the last line of what went wrong
    """
    sources = b"".join((HERE.parent / name).read_bytes() for name in ("large/build.py", "large/glb.py", "large/atrium.py", "hall.py"))
    file = cache / "scenes" / f"{'-'.join(map(str, words))}-{hashlib.sha256(sources).hexdigest()[:12]}.glb"
    if file.exists():
        return file
    file.parent.mkdir(parents=True, exist_ok=True)
    print(f"making {' '.join(map(str, words))}: {file}", file=sys.stderr, flush=True)
    part = file.with_suffix(".part")
    run = subprocess.run([python, HERE / "build.py", *map(str, words), part], capture_output=True, text=True)
    if run.returncode:
        part.unlink(missing_ok=True)
        raise RuntimeError(f"{' '.join(map(str, words))}: {(run.stderr.strip() or 'build.py failed').splitlines()[-1]}")
    part.replace(file)
    return file
