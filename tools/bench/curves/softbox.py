"""A glTF binary with one softbox and no other lamp."""
import json
import struct
from pathlib import Path


def chunks(data):
    at = 12
    while at < len(data):
        length, kind = struct.unpack_from("<II", data, at)
        yield kind, data[at + 8:at + 8 + length]
        at += 8 + length


def lit(source: Path, target: Path) -> Path:
    """Adds a square of 2 m and 1000 cd/m², above and before the origin, which it faces."""
    (json_kind, text), *others = chunks(source.read_bytes())
    document = json.loads(text)
    document.setdefault("extensionsUsed", []).append("EXT_lights_area")
    lights = document.setdefault("extensions", {}).setdefault("EXT_lights_area", {}).setdefault("lights", [])
    lights.append({"type": "rect", "color": [1, 1, 1], "intensity": 1000, "size": 2.0, "rect": {"aspect": 1}})
    nodes = document["nodes"]
    # Turned by -45° about x, so that its -Z leads from (0, 2.5, 2.5) to the origin.
    nodes.append({"name": "softbox", "translation": [0.0, 2.5, 2.5], "rotation": [-0.3826834, 0.0, 0.0, 0.9238795],
                  "extensions": {"EXT_lights_area": {"light": len(lights) - 1}}})
    document["scenes"][document.get("scene", 0)]["nodes"].append(len(nodes) - 1)
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    body = b"".join(struct.pack("<II", len(data), kind) + data for kind, data in [(json_kind, text), *others])
    target.write_bytes(struct.pack("<4sII", b"glTF", 2, 12 + len(body)) + body)
    return target
