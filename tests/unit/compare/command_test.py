#!/usr/bin/env python3
"""`steradian compare` as people and scripts call it: exit status, stdout, files.

    command_test.py STERADIAN GOLDEN_MUTANTS FOLDER
"""
import json
import struct
import subprocess
import sys
import zlib
from pathlib import Path

steradian, golden_mutants, folder = sys.argv[1], sys.argv[2], Path(sys.argv[3])
failures = []


def check(claim, *args, status, out="", err=""):
    ran = subprocess.run([steradian, "compare", *map(str, args)], capture_output=True, text=True, check=False)
    if ran.returncode != status or out not in ran.stdout or err not in ran.stderr:
        failures.append(f"{claim}: status {ran.returncode}, wanted {status}\n{ran.stdout}{ran.stderr}")
    return ran


def files(name):
    return folder / f"{name}.test.exr", folder / f"{name}.reference.exr"


folder.mkdir(parents=True, exist_ok=True)
subprocess.run([golden_mutants, "--write", folder], check=True, stdout=subprocess.DEVNULL)

check("equal images agree", *files("identical"), status=0, out="PASS")
check("a difference is status 1", *files("pi_missing"), status=1, out="a division by π is missing")
check("NaN fails", *files("one_nan"), status=1, out="1 of the test")
check("NaN may be allowed", *files("one_nan"), "--allow-nonfinite", status=0)
check("an option before the files", "--max", "rel=0.02@99%", "--max", "energy=1", *files("identical"), status=0)
check("two noises", "--noise", "0.1", "--noise", files("noise_at_its_floor")[1], *files("noise_at_its_floor"), status=0)
check("a region", *files("clustered_0.9_percent"), "--region", "0,0,60x96", status=0)
check("no such file", files("identical")[0], folder / "none.exr", status=3, err="none.exr: no such file")
check("a region outside", *files("identical"), "--region", "90,0,10x10", status=3, err="not inside 96x96")
check("a wrong limit", *files("identical"), "--max", "rel=x", status=2, err="is not a number")
check("a heat map is a picture", *files("identical"), "--heat-map", folder / "heat.exr", status=2, err=".png")
check("no noise, no z", *files("identical"), "--max", "z=5", status=3, err="noise floor")
check("help has examples", "--help", status=0, out="Examples:")



def png(name, channels, values):
    """An 8-bit PNG of one row."""
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    head = struct.pack(">IIBBBBB", len(values), 1, 8, {1: 0, 3: 2}[channels], 0, 0, 0)
    row = bytes(1) + bytes(value for value in values for _ in range(channels))
    (folder / name).write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(row)) + chunk(b"IEND", b""))
    return folder / name


grey = range(0, 250, 10)
check("grey is RGB with equal channels", png("grey.png", 1, grey), png("rgb.png", 3, grey), status=0, out="PASS")
check("and the other way round", png("rgb.png", 3, grey), png("grey.png", 1, grey), status=0, out="PASS")
check("other grey is not", png("grey.png", 1, grey), png("dark.png", 3, [value // 2 for value in grey]), status=1, out="FAIL")


def exr(name, window, display, channel=b"Y"):
    """An EXR of one float channel, uncompressed, whose data window holds 1, 2, 3 … (OpenEXR File Layout)."""
    (left, top, right, bottom) = window

    def attribute(label, kind, data):
        return label.encode() + b"\0" + kind.encode() + b"\0" + struct.pack("<i", len(data)) + data
    head = struct.pack("<ii", 20000630, 2) + attribute("channels", "chlist", channel + b"\0" + struct.pack("<iiii", 2, 0, 1, 1) + b"\0")
    head += attribute("compression", "compression", b"\0") + attribute("dataWindow", "box2i", struct.pack("<4i", *window))
    head += attribute("displayWindow", "box2i", struct.pack("<4i", *display)) + attribute("lineOrder", "lineOrder", b"\0")
    head += attribute("pixelAspectRatio", "float", struct.pack("<f", 1)) + attribute("screenWindowCenter", "v2f", bytes(8))
    head += attribute("screenWindowWidth", "float", struct.pack("<f", 1)) + b"\0"
    width, height = right - left + 1, bottom - top + 1
    lines = [struct.pack("<ii", top + y, 4 * width) + struct.pack(f"<{width}f", *(1 + y * width + x for x in range(width))) for y in range(height)]
    first = len(head) + 8 * height
    offsets = b"".join(struct.pack("<Q", first + y * len(lines[0])) for y in range(height))
    (folder / name).write_bytes(head + offsets + b"".join(lines))
    return folder / name


whole = exr("whole.exr", (0, 0, 7, 7), (0, 0, 7, 7))
check("windows may begin anywhere", exr("moved.exr", (5, -3, 12, 4), (5, -3, 12, 4)), whole, status=0, out="PASS")
red = exr("red.exr", (0, 0, 7, 7), (0, 0, 7, 7), b"R")
check("a plain file's, too", exr("moved_red.exr", (5, -3, 12, 4), (5, -3, 12, 4), b"R"), red, status=0, out="PASS")
check("a plain file has a limit", red, red, "--limit", "pixels=63", status=3, err="--limit pixels")
cut = folder / "cut.exr"
cut.write_bytes(red.read_bytes()[:-1])
check("a plain file that ends early", cut, red, status=3, err="cut.exr: a broken image (")
part = exr("part.exr", (0, 0, 3, 3), (0, 0, 7, 7))
check("the same pixels in another place", exr("shifted.exr", (4, 4, 7, 7), (0, 0, 7, 7)), part, status=1, out="FAIL")
check("the same pixels in the same place", exr("again.exr", (0, 0, 3, 3), (0, 0, 7, 7)), part, status=0, out="PASS")
check("a huge display window", exr("huge.exr", (0, 0, 3, 3), (0, 0, 99999, 99999)), part, status=3, err="--limit pixels")

def tiff(name, values):
    """A grey TIFF of one row of 8 bits (TIFF 6.0)."""
    entries = [(256, 3, len(values)), (257, 3, 1), (258, 3, 8), (259, 3, 1), (262, 3, 1), (273, 4, 8), (277, 3, 1),
               (278, 3, 1), (279, 4, len(values))]
    directory = struct.pack("<H", len(entries)) + b"".join(struct.pack("<HHII", tag, kind, 1, value) for tag, kind, value in entries)
    (folder / name).write_bytes(b"II*\0" + struct.pack("<I", 8 + len(values)) + bytes(values) + directory + bytes(4))
    return folder / name


codes = [100] * 24
check("8-bit TIFF holds codes", tiff("codes.tif", codes), tiff("off.tif", [101] * 24), "--max", "abs=0.0079", status=0)
check("its default limit is in codes", tiff("codes.tif", codes), tiff("far.tif", [104] * 24), status=1, out="abs ≤ 0.0079")
check("a layer may be left out", *files("key_missing"), "--other-layers", "none", status=1, out="FAIL")
check("layers agree", *files("identical"), status=0, out="other layers: 3 of 3 agree")

heat, both = folder / "heat.png", folder / "both.png"
check("pictures are written", *files("moved_object"), "--heat-map", heat, "--side-by-side", both, status=1)
failures += [f"{picture} is missing" for picture in (heat, both) if not picture.exists()]
check("the same picture as .png", heat, heat, status=0, out="abs ≤ 0.0079")

told = json.loads(check("JSON alone on stdout", *files("key_missing"), "--json", status=1).stdout)
if told["diagnosis"]["name"] != "light_missing" or told["diagnosis"]["layer"] != "key" or told["passed"]:
    failures.append(f"JSON tells {told['diagnosis']}")

print("\n".join(failures) if failures else "all claims hold")
sys.exit(bool(failures))
