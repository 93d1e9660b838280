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
        return subprocess.run(["sh", "-c", command, cli_test.STERADIAN, *map(str, words)], capture_output=True, text=True, timeout=250)

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
        lost = subprocess.run([cli_test.STERADIAN, "render", gltf, "-o", out, "--size", "16x16", "--samples", "1"], stderr=writer, timeout=250)
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

    def test_a_system_without_threads_is_one_line(self):
        if is_sanitized():
            self.skipTest("sanitizers start threads of their own")
        somebody = {"user": 65534} if os.geteuid() == 0 else {}  # the limit does not hold for root
        try:
            run("--version", **somebody)
        except OSError:
            self.skipTest("the program is where others may not run it")
        picture = self.write(png(4, 4), "good.PNG")
        self.folder.chmod(0o755)
        somebody["preexec_fn"] = lambda: resource.setrlimit(resource.RLIMIT_NPROC, (1, 1))
        for command in (["brdf", "lambert"], ["compare", picture, picture]):
            self.assert_refused(run(*command, **somebody), "the system refuses what is needed")
        plain = self.folder / "plain.exr"
        self.assertEqual(run("render", self.write(scene()), "-o", plain, "--size", "8x8", "--samples", "1").returncode, 0)
        limited = run("compare", plain, plain, **somebody)
        self.assertEqual(limited.returncode, 0, limited.stderr)  # OpenEXR is content with the thread that there is

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

    def overlay(self, text, name="brdf/f_r.glsl", folder="overlay"):
        file = self.folder / folder / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_bytes(text if isinstance(text, bytes) else text.encode())
        return file

    def rendered_with(self, folder="overlay", *arguments):
        return run("render", self.write(scene()), "-o", self.folder / "a.exr", "--size", "8x8", "--samples", "1",
                   "--shaders", self.folder / folder, *arguments)

    def test_shaders_that_kill_the_compiler_are_one_line(self):
        # AddressSanitizer would turn a crash of the driver into an exit status.
        os.environ["ASAN_OPTIONS"] = os.environ.get("ASAN_OPTIONS", "") + ":handle_segv=0"
        good = "vec3 f_r(Surface x, vec3 wi, vec3 wo) { return vec3(0.1); }\n"
        bombs = {"crashes": "float d(float x) { return x" + "-x" * 100000 + "; }\n",
                 "takes more than 2 GiB of memory": "#define A0 1.0\n" + "".join(f"#define A{i + 1} (A{i}+A{i})\n" for i in range(40))
                                                    + "float bomb() { return A40; }\n"}
        for words, bomb in bombs.items():
            file = self.overlay(good + bomb)
            self.assert_refused(self.rendered_with(), f"{file}: ", words)
        file.write_text(good + "float q() { return nothere; }\n")  # a mistake keeps its place
        self.assert_refused(self.rendered_with(), f"{file}:2:", "nothere")
        file.write_text(good)
        self.assertEqual(self.rendered_with().returncode, 0)

    def test_a_shader_of_brdf_that_kills_the_compiler_is_one_line(self):
        file = self.overlay("vec3 f_r(Surface x, vec3 wi, vec3 wo) { return vec3(0.1" + "-0.1*x.alpha" * 50000 + "); }\n")
        self.assert_refused(run("brdf", file), f"{file}: ", "the driver's compiler")

    def test_errors_of_odd_overlays_name_their_place(self):
        for text, place in ((b"float a;\n#line 7 7\nfloat q() { return nothere; }\n", ":2: #line"), (b"float a;\r\n\0float b;\n", ":2: a NUL byte"),
                            (b"float a;\r#if 0\rfloat b;\n", ":2: this #if never ends"), (b"float a;\rgarbage garbage\n", ":2:")):
            file = self.overlay(text)
            self.assert_refused(self.rendered_with(), f"{file}{place}")

    def test_untrusted_shaders_are_refused_or_end(self):
        text = ('#include "surface/surface.glsl"\nvec3 f_r(Surface x, vec3 wi, vec3 wo) {{\n    float a = 0.1;\n'
                "    {}\n    return vec3(a);\n}}\n")
        for body, words in (("while (true) a += 0.1;", ":4: this loop was stopped"), ("discard;", ":4: discard is not allowed here"),
                            ("for (int i = 0; i < 1000000; ++i) a *= 0.5;", ":4: this loop was stopped"),
                            ('#include "../../secret.glsl"', ":4: includes")):
            file = self.overlay(text.format(body))
            self.assert_refused(self.rendered_with("overlay", "--untrusted"), f"{file}{words}")
        self.overlay(text.format("for (int i = 0; i < 3; ++i) a += 0.1;"))
        self.assertEqual(self.rendered_with("overlay", "--untrusted").returncode, 0)
        plain = (self.folder / "a.exr").read_bytes()
        self.assertEqual(self.rendered_with().returncode, 0)
        self.assertEqual(run("compare", self.folder / "a.exr", self.write(plain, "untrusted.exr")).returncode, 0)
        for picture in self.folder.glob("*.exr"):
            picture.unlink()
        self.linked(self.overlay("", folder="elsewhere"), self.overlay("", folder="linked"))
        self.assert_refused(self.rendered_with("linked", "--untrusted"), "f_r.glsl: a link")

    def test_a_loop_that_only_shadow_rays_meet_is_stopped(self):
        text = (Path(__file__).resolve().parents[3] / "shaders/visibility/record.glsl").read_text()
        lines = text.replace("    ++recorded_count;\n", "    ++recorded_count;\n    for (float a = 0.0; a < 1.0;) a *= 0.5;\n").splitlines()
        file = self.overlay("\n".join(lines), "visibility/record.glsl")
        number = next(i for i, line in enumerate(lines, 1) if "for (" in line)
        self.assert_refused(self.rendered_with("overlay", "--untrusted", "--visibility", "ray"), f"{file}:{number}: this loop was stopped")
        self.assertEqual(self.rendered_with("overlay", "--untrusted", "--visibility", "none").returncode, 0)

    def test_an_overlay_that_replaces_nothing_is_named(self):
        self.overlay("", "brdf/fr.glsl", "misspelt")
        self.overlay("", "f_r.glsl", "flat")
        (self.folder / "empty").mkdir()
        for folder, words in (("misspelt", "rename brdf/fr.glsl if brdf/f_r.glsl is meant"), ("flat", "rename f_r.glsl if brdf/f_r.glsl is meant"),
                              ("empty", "the folder holds no files")):
            result = self.rendered_with(folder)
            self.assertEqual(result.returncode, 0, result.stderr)
            self.assertEqual(len(result.stderr.strip().splitlines()), 1, result.stderr)
            self.assertIn(words, result.stderr)
        self.overlay("float mine() { return 0.5; }\n", "mine.glsl", "helpers")
        self.overlay('#include "surface/surface.glsl"\n#include "mine.glsl"\nvec3 f_r(Surface x, vec3 wi, vec3 wo) { return vec3(mine()); }\n',
                     folder="real")
        self.assertEqual(self.rendered_with("helpers", "--shaders", self.folder / "real").stderr, "")
        (self.folder / "a.exr").unlink()
        self.linked("nowhere", self.overlay("", folder="dangling"))
        self.assert_refused(self.rendered_with("dangling"), "brdf/f_r.glsl: this symbolic link leads to no file")

    def test_a_term_needs_no_includes_for_its_signature(self):
        terms = {"brdf/f_r.glsl": "vec3 f_r(Surface x, vec3 wi, vec3 wo) { return vec3(0.1); }\n",
                 "integrator/emitted.glsl": "vec3 emitted(Surface x) { return vec3(0.0); }\n",
                 "visibility/visibility.glsl": "vec3 visibility(Surface x, vec3 wi, float distance, int light, int ray) { return vec3(1.0); }\n"}
        for name, text in terms.items():
            self.overlay(text, name, name.split("/")[0])
            for view in ([], ["--view", "irradiance"]):
                result = self.rendered_with(name.split("/")[0], *view)
                self.assertEqual((result.returncode, result.stderr), (0, ""), name)

    def test_outputs_are_checked_before_rendering(self):
        gltf, there = self.write(scene()), self.folder / "there"
        there.mkdir()
        (there / "folder.png").mkdir()
        os.mkfifo(there / "fifo.png")
        self.linked("loop.png", "there/loop.png")
        for name, words in (("none/x.exr", "there is no folder"), ("folder.png", "this is a folder"), ("fifo.png", "not a regular file"),
                            ("a.tiff", "unknown image format"), ("loop.png", "circle"), ("x" * 300 + ".png", "too long")):
            begin = time.monotonic()
            result = run("render", gltf, "-o", there / "a.exr", "-o", there / name, "--samples", "1000000")
            self.assert_refused(result, words)
            self.assertLess(time.monotonic() - begin, 90, name)
            self.assertEqual(sorted(p.name for p in there.iterdir()), ["fifo.png", "folder.png", "loop.png"])
            if name != "a.tiff":
                self.assert_refused(run("brdf", "lambert", "-o", there / name), words)
        good = self.folder / "good.hdr"
        self.assertEqual(run("render", gltf, "-o", good, "--size", "8x8", "--samples", "1").returncode, 0)
        self.assert_refused(run("compare", good, good, "--heat-map", self.folder / "none/x.png"), "there is no folder")

    def test_modes_and_links_of_outputs_stay(self):
        gltf, target, link = self.write(scene()), self.folder / "target.hdr", self.folder / "link.hdr"
        render = ["render", gltf, "--size", "8x8", "--samples", "1", "-o"]
        target.write_text("before")
        for mode in (0o600, 0o640, 0o444):
            target.chmod(mode)
            result = run(*render, target)
            if result.returncode:  # only root may write what is read-only
                self.assertEqual(mode, 0o444)
                self.assert_refused(result, "target.hdr: the file cannot be replaced")
            self.assertEqual(target.stat().st_mode & 0o777, mode)
        target.chmod(0o644)
        for before in ("target.hdr", "new.hdr"):  # the second leads nowhere yet
            self.linked(before, link.name)
            self.assertEqual(run(*render, link).returncode, 0)
            self.assertEqual(os.readlink(link), before)
            self.assertTrue((self.folder / before).read_bytes().startswith(b"#?"))

    def test_libraries_print_no_line_of_their_own(self):
        good = png(4, 4)
        half = zlib.compress(bytes(20))
        ihdr = good[:33]
        pictures = {"crc.png": good[:45] + b"zzzz" + good[49:], "short.png": good[:50], "rows.png":
                    ihdr + struct.pack(">I", len(half)) + b"IDAT" + half + struct.pack(">I", zlib.crc32(b"IDAT" + half)) + good[-12:],
                    "bad.jpg": b"\xff\xd8\xff\xe0\0\x10JFIF\0\1\1\0\0\1\0\1\0\0\xff\xda" + b"z" * 40}
        self.write(good, "good.PNG")
        for name, data in pictures.items():
            file = self.write(data, name).rename(self.folder / name.upper())
            result = run("compare", file, self.folder / "good.PNG")
            self.assert_refused(result, file.name)
        gltf = self.write(scene(images=[{"uri": "ROWS.PNG"}], textures=[{"source": 0}],
                                materials=[{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}]))
        self.assertEqual(run("info", gltf).stderr, "")  # a warning on stdout

    def linked(self, target, name):
        link = self.folder / name
        link.unlink(missing_ok=True)
        link.symlink_to(target)
        return link

    def test_a_candidate_that_is_no_file_ends_at_once(self):
        for command in ("mkfifo", "ln -s /dev/zero", "mkdir"):
            suite = self.write({"tests": [{"name": "a", "command": ["sh", "-c", f'{command} "$0"', "{out}"], "time_limit": 300}]}, "suite.json")
            begin = time.monotonic()
            result = run("golden", "run", suite, "-o", self.folder / "out")
            self.assertEqual(result.returncode, 3, (command, result.stdout, result.stderr))
            self.assertIn("0 of 1 passed, 1 unreadable", result.stdout)
            self.assertLess(time.monotonic() - begin, 90)

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

    def test_what_is_unpacked_counts(self):
        corners = 3 << 18
        shared = scene(buffers=[{"byteLength": 36, "uri": data_uri(TRIANGLE)}, {"byteLength": corners, "uri": data_uri(bytes([0, 1, 2]) * (corners // 3))}])
        shared["bufferViews"].append({"buffer": 1, "byteLength": corners})
        shared["accessors"].append({"bufferView": 1, "componentType": 5121, "count": corners, "type": "SCALAR"})
        primitive = {"attributes": {"POSITION": 0}, "indices": 1, "material": 0}
        shared["meshes"] = [{"primitives": [{**primitive, "targets": [{"POSITION": 0}] * 500}]}]  # of three vertices, for 786432 corners
        self.assert_small("info", self.write(shared, "targets.gltf"), "--limit", "values=20000000")
        shared["meshes"] = [{"primitives": [primitive] * 1000}]
        self.assert_small("info", self.write(shared, "corners.gltf"), "--limit", "vertices=1000000")
        blocks = 1 << 14  # of 256 elements, all 0: 16 bytes each
        packed = b"\xa0" + bytes(16 * blocks + 32)
        view = {"buffer": 0, "byteLength": 1024 * blocks, "byteStride": 4, "extensions": {"EXT_meshopt_compression": {
            "buffer": 0, "byteLength": len(packed), "byteStride": 4, "count": 256 * blocks, "mode": "ATTRIBUTES"}}}
        meshopt = scene(buffers=[{"byteLength": len(packed), "uri": data_uri(packed)}], bufferViews=[view] * 1000,
                        extensionsUsed=["KHR_lights_punctual", "EXT_meshopt_compression"], extensionsRequired=["EXT_meshopt_compression"])
        file = self.write(meshopt, "meshopt.gltf")
        if "is not supported" in run("info", file, "--limit", "values=40000000").stderr:
            self.skipTest("built without meshoptimizer")
        self.assert_small("info", file, "--limit", "values=40000000")

    def test_a_large_scene_is_within_the_limits(self):
        side, copies = 142, 100  # 40,328 triangles a mesh, four million in all
        grid = b"".join(struct.pack("<3f", x / side, y / side, 0) for y in range(side + 1) for x in range(side + 1))
        quads = [y * (side + 1) + x for y in range(side) for x in range(side)]
        indices = b"".join(struct.pack("<6I", q, q + 1, q + side + 2, q, q + side + 2, q + side + 1) for q in quads)
        file = scene(buffers=[{"byteLength": len(grid), "uri": data_uri(grid)}, {"byteLength": len(indices), "uri": data_uri(indices)}])
        file["bufferViews"] = [{"buffer": 0, "byteLength": len(grid)}, {"buffer": 1, "byteLength": len(indices)}]
        file["accessors"] = [{"bufferView": 0, "componentType": 5126, "count": (side + 1) ** 2, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]},
                             {"bufferView": 1, "componentType": 5125, "count": 6 * side * side, "type": "SCALAR"}]
        file["meshes"][0]["primitives"][0]["indices"] = 1
        file["nodes"] += [{"mesh": 0, "translation": [i, 0, 0]} for i in range(1, copies)]
        file["scenes"][0]["nodes"] = list(range(len(file["nodes"])))
        result = run("info", self.write(file))
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertIn(f"{2 * side * side * copies}", result.stdout.replace(",", ""))

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
