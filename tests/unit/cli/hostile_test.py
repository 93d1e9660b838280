#!/usr/bin/env python3
"""Files and surroundings that mean harm, or are merely odd: one line and status 3, at once and in bounded memory.

usage: hostile_test.py STERADIAN SCENES_FOLDER TEST_NAME     (TEST_NAME is a method of Hostile below)
"""
import base64
import json
import os
import resource
import struct
import subprocess
import sys
import time
import zlib
from pathlib import Path

import cli_test
from cli_test import run

TRIANGLE = struct.pack("<9f", -1, -1, 0, 1, -1, 0, 0, 1, 0)
MEMORY = 512 << 10  # [KiB] resident, of what a small file may take


def is_sanitized():
    return b"__asan_init" in Path(cli_test.STERADIAN).read_bytes()


def png(width, height, channels=3):
    """A PNG of zeros, small however many texels it has."""
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    row = bytes(1 + width * channels)
    packer = zlib.compressobj(9)
    data = b"".join(packer.compress(row) for _ in range(height)) + packer.flush()
    head = struct.pack(">IIBBBBB", width, height, 8, {1: 0, 3: 2}[channels], 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", data) + chunk(b"IEND", b"")


def data_uri(data):
    return "data:application/octet-stream;base64," + base64.b64encode(data).decode()


def scene(**changes):
    """A triangle, a camera and a lamp."""
    return {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1, 2]}],
            "nodes": [{"mesh": 0}, {"camera": 0, "translation": [0, 0, 3]},
                      {"translation": [0, 0, 2], "extensions": {"KHR_lights_punctual": {"light": 0}}}],
            "cameras": [{"type": "perspective", "perspective": {"yfov": 0.8, "znear": 0.01, "zfar": 100}}],
            "extensionsUsed": ["KHR_lights_punctual"],
            "extensions": {"KHR_lights_punctual": {"lights": [{"type": "point", "intensity": 10}]}},
            "materials": [{}], "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "material": 0}]}],
            "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [-1, -1, 0], "max": [1, 1, 0]}],
            "bufferViews": [{"buffer": 0, "byteLength": 36}], "buffers": [{"byteLength": 36, "uri": data_uri(TRIANGLE)}], **changes}


class Hostile(cli_test.CommandLine):
    def write(self, content, name="scene.gltf"):
        file = self.folder / name
        if isinstance(content, bytes):
            file.write_bytes(content)
        else:
            file.write_text(content if isinstance(content, str) else json.dumps(content))
        return file

    def shell(self, command, *words):
        """Runs a line of sh, in which $0 is the program and $1, $2 … are the words."""
        return subprocess.run(["sh", "-c", command, cli_test.STERADIAN, *map(str, words)], capture_output=True, text=True, timeout=100)

    def assert_small(self, *arguments):
        """It is refused, and takes little memory for that."""
        before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss
        result = run(*arguments)
        self.assert_refused(result, "--limit ")
        used = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss
        if not is_sanitized():
            self.assertLess(used, max(before, MEMORY))

    def test_numbers_that_overflow_name_their_place(self):
        line = '  {"name": "a 1e999", "command": ["true", "{out}"], "time_limit": 1e999}]}'
        suite = self.write('{"tests": [\n' + line, "suite.json")
        self.assert_refused(run("golden", "list", suite), f"suite.json:2:{line.rindex('1e999') + 1}: ")
        gltf = self.write(json.dumps(scene()).replace('"yfov": 0.8', '"yfov": 1e999'))
        self.assert_refused(run("info", gltf), "scene.gltf:1:")

    def test_a_path_that_is_too_long_names_its_place(self):
        suite = self.write(json.dumps({"goldens": "x" * 300, "tests": [{"name": "a", "command": ["true", "{out}"]}]}), "suite.json")
        self.assert_refused(run("golden", "run", suite, "-o", self.folder / "out"), "suite.json:1:13")

    def test_a_lost_warning_costs_no_picture(self):
        gltf = self.write(scene(extensionsUsed=["KHR_lights_punctual", "EXT_nothing"]))
        out = self.folder / "a.exr"
        render = f'"$0" render "$1" -o "$2" --size 16x16 --samples 1'
        for stream in ("2>/dev/full", "2>&-", "<&- >&- 2>&-"):
            self.assertEqual(self.shell(f"{render} {stream}", gltf, out).returncode, 0, stream)
            self.assertTrue(out.exists(), stream)
            out.unlink()
        reader, writer = os.pipe()
        os.close(reader)  # whoever listened is gone
        lost = subprocess.run([cli_test.STERADIAN, "render", gltf, "-o", out, "--size", "16x16", "--samples", "1"], stderr=writer, timeout=100)
        os.close(writer)
        self.assertEqual(lost.returncode, 0)
        self.assertTrue(out.exists())

    def test_lost_output_is_no_success(self):
        gltf = self.write(scene())
        commands = ["info", 'info "$1"', 'info "$1" --json', "expand forward.frag", "brdf lambert", "--help", "--version", "render --help",
                    'probe "$1" --pixel 8,8 --size 16x16 --samples 1', 'render "$1" -o "$2" --size 16x16 --samples 1 --json']
        for command in commands:
            for stream in (">/dev/full", ">&-"):
                result = self.shell(f'"$0" {command} {stream}', gltf, self.folder / "a.png")
                self.assertEqual(result.returncode, 3, (command, stream, result.stderr))
                self.assertIn("stdout: cannot be written", result.stderr)

    def test_limits_of_the_system_are_one_line(self):
        if is_sanitized():
            self.skipTest("AddressSanitizer does not run under a limit on memory")
        gltf = self.write(scene())
        for kilobytes in (300000, 400000, 600000):
            result = self.shell(f'ulimit -v {kilobytes}; "$0" render "$1" -o "$2" --size 16x16 --samples 1', gltf, self.folder / "a.exr")
            self.assertIn(result.returncode, (0, 3), (kilobytes, result.stderr))
            if result.returncode:
                self.assertEqual(len(result.stderr.strip().splitlines()), 1, (kilobytes, result.stderr))
            (self.folder / "a.exr").unlink(missing_ok=True)

    def test_only_regular_files_are_read(self):
        fifo, link = self.folder / "fifo.exr", self.folder / "zero.png"
        os.mkfifo(fifo)
        link.symlink_to("/dev/zero")
        good = self.folder / "good.exr"
        self.assertEqual(run("render", self.write(scene()), "-o", good, "--size", "8x8", "--samples", "1").returncode, 0)
        suite = self.write({"tests": []}, "empty.json")
        for odd in (fifo, link):
            for command in (["info", odd], ["render", odd, "-o", self.folder / "b.hdr"], ["compare", odd, good], ["compare", good, odd],
                            ["compare", good, good, "--mask", odd], ["golden", "run", odd], ["brdf", self.linked(odd, "a.glsl")],
                            ["brdf", self.linked(odd, "a.binary")], ["golden", "approve", suite, "-o", self.folder / "none"]):
                result = run(*command)
                self.assertEqual(result.returncode, 3, (command, result.stderr))
                self.assertEqual(len(result.stderr.strip().splitlines()), 1, result.stderr)
        overlay = self.folder / "overlay"
        (overlay / "brdf").mkdir(parents=True)
        os.mkfifo(overlay / "brdf/f_r.glsl")
        result = run("render", self.folder / "scene.gltf", "-o", self.folder / "b.hdr", "--shaders", overlay)
        self.assertEqual(result.returncode, 3, result.stderr)
        self.assertIn("f_r.glsl: this is not a regular file", result.stderr)

    def linked(self, target, name):
        link = self.folder / name
        link.unlink(missing_ok=True)
        link.symlink_to(target)
        return link

    def test_a_candidate_that_is_no_file_ends_at_once(self):
        for command in ("mkfifo", "ln -s /dev/zero", "mkdir"):
            suite = self.write({"tests": [{"name": "a", "command": ["sh", "-c", f'{command} "$0"', "{out}"], "time_limit": 20}]}, "suite.json")
            begin = time.monotonic()
            result = run("golden", "run", suite, "-o", self.folder / "out")
            self.assertEqual(result.returncode, 3, (command, result.stdout, result.stderr))
            self.assertIn("0 of 1 passed, 1 broken", result.stdout)
            self.assertLess(time.monotonic() - begin, 10)

    def test_small_files_ask_for_little(self):
        image = {"uri": "data:image/png;base64," + base64.b64encode(png(8192, 8192, 1)).decode()}
        bomb = scene(images=[image] * 10, textures=[{"source": i} for i in range(10)],
                     materials=[{"pbrMetallicRoughness": {"baseColorTexture": {"index": i}}} for i in range(10)])
        bomb["meshes"][0]["primitives"] = [{"attributes": {"POSITION": 0}, "material": i} for i in range(10)]
        self.assert_small("info", self.write(bomb, "texels.gltf"))

        def instanced(nodes, name=""):
            more = [{"mesh": 0, "name": name, "extensions": {"EXT_mesh_gpu_instancing": {"attributes": {"TRANSLATION": 1}}}}] * nodes
            file = scene(extensionsUsed=["KHR_lights_punctual", "EXT_mesh_gpu_instancing"])
            file["nodes"] += more
            file["scenes"][0]["nodes"] = list(range(len(file["nodes"])))
            file["accessors"].append({"componentType": 5126, "count": 65536, "type": "VEC3"})
            return file
        self.assert_small("info", self.write(instanced(300), "instances.gltf"))
        self.assert_small("info", self.write(instanced(1, "n" * 40000), "names.gltf"))
        materials = json.dumps(scene(materials=["@"])).replace('"@"', ",".join(["{}"] * 100000))
        self.assert_small("info", self.write(materials, "materials.gltf"))
        self.assert_small("info", self.write(json.dumps(scene(extras=["@"])).replace('"@"', ",".join(["[]"] * 5000000)), "values.gltf"))
        picture = self.write(png(16384, 16384), "picture.PNG")
        self.assert_small("compare", picture, picture)

    def test_limits_are_settable(self):
        gltf = self.write(scene())
        self.assert_refused(run("info", gltf, "--limit", "vertices=2"), "asks for 3 vertices", "--limit vertices=3")
        self.assert_refused(run("--limit", "json-values=10", "info", gltf), "--limit json-values=")
        environment = {**os.environ, "STERADIAN_LIMITS": "texels=5,vertices=2"}
        self.assert_refused(run("info", gltf, env=environment), "asks for 3 vertices")
        self.assertEqual(run("info", gltf, "--limit", "vertices=3", env=environment).returncode, 0)
        for wrong in ("vertexes=2", "vertices", "vertices=-1", "vertices=1e9", "vertices=99999999999999999999"):
            self.assertEqual(run("info", gltf, "--limit", wrong).returncode, 2, wrong)

    def test_links_do_not_lead_out_of_the_folder(self):
        inside, outside = self.folder / "inside", self.folder / "outside"
        inside.mkdir(), outside.mkdir()
        (outside / "data.bin").write_bytes(TRIANGLE)
        (inside / "data.bin").write_bytes(TRIANGLE)
        (inside / "within.bin").symlink_to("data.bin")
        (inside / "away.bin").symlink_to("../outside/data.bin")
        (inside / "folder").symlink_to(outside)
        (inside / "loop.bin").symlink_to("loop.bin")
        for name, status in (("within.bin", 0), ("away.bin", 3), ("folder/data.bin", 3), ("loop.bin", 3)):
            file = self.write(scene(buffers=[{"byteLength": 36, "uri": name}]), "inside/scene.gltf")
            result = run("info", file)
            self.assertEqual(result.returncode, status, (name, result.stderr))
        whole = self.folder / "whole"
        whole.symlink_to(inside)  # the way to the file is the user's
        self.write(scene(buffers=[{"byteLength": 36, "uri": "within.bin"}]), "inside/scene.gltf")
        self.assertEqual(run("info", whole / "scene.gltf").returncode, 0)

    def test_control_characters_are_shown(self):
        for name, seen in (("a\nb\nc", "a\\nb\\nc"), ("\x1b]0;pwned\x07\x1b[31mred", "\\x1b]0;pwned\\x07"), ("\x9b31m", "\\u009b31m"),
                           ("\u202eabc", "\\u202eabc"), ("\x7f", "\\x7f")):
            file = scene()
            file["meshes"][0]["primitives"][0]["attributes"][name] = 99
            self.assert_refused(run("info", self.write(file)), seen)
            file = scene()
            file["cameras"][0]["name"] = file["meshes"][0]["name"] = name
            file["nodes"][1]["name"] = name
            for options in ([], ["--json"]):
                out = run("info", self.write(file), *options).stdout
                for c in out.replace("\n", ""):
                    self.assertTrue(c.isprintable(), (name, c))
        result = run("info", self.folder / "no\nsuch\x1b.gltf")
        self.assertEqual(result.stderr.count("\n"), 1)
        self.assertNotIn("\x1b", result.stderr)

    def test_options_that_overflow_are_usage_errors(self):
        gltf = self.write(scene())
        for option in (["--samples", "99999999999"], ["--samples", "0"], ["--size", "0x0"], ["--size", "99999999999x1"], ["--exposure", "1e999"],
                       ["--exposure", "nan"], ["--seed", "99999999999999"], ["--seed", "-1"], ["--background", "nan"], ["--time", "1e999"],
                       ["--error", "nan%"], ["--at", "-1"], ["--at", "1e999"], ["--at", "nan"], ["--fps", "nan", "--frames", "0:1"],
                       ["--environment-strength", "nan"], ["--environment-rotation", "nan"],
                       ["--frames", "0:99999999999"], ["--scene", "99999999999"], ["--map-size", "1e9"]):
            result = run("render", gltf, "-o", self.folder / "a.####.png", *option)
            self.assertEqual(result.returncode, 2, (option, result.stderr))
        for option in (["--ior", "nan"], ["--rotation", "nan"], ["--rotation", "1e999"], ["--film-thickness", "inf"], ["--roughness", "nan"]):
            self.assertEqual(run("brdf", "gltf", *option).returncode, 2, option)


if __name__ == "__main__":
    sys.exit(cli_test.main(Hostile))
