#!/usr/bin/env python3
"""`steradian export` as a person meets it.

usage: export_test.py STERADIAN SCENES_FOLDER TEST_NAME     (TEST_NAME is a method of Export below)
"""
import base64
import json
import struct
import sys
import zlib
from pathlib import Path
from xml.etree import ElementTree

import cli_test

SCENE = None


def data_uri(content, kind="application/octet-stream"):
    return f"data:{kind};base64," + base64.b64encode(content).decode()


def white_pixel():
    def chunk(name, content):
        return struct.pack(">I", len(content)) + name + content + struct.pack(">I", zlib.crc32(name + content))

    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", 1, 1, 8, 2, 0, 0, 0))
            + chunk(b"IDAT", zlib.compress(b"\0\xff\xff\xff")) + chunk(b"IEND", b""))


def glowing_detail():
    """A triangle that glows by a texture, as the details of a model do: no lamp."""
    places = struct.pack("<9f", 0, 0, 0, 1, 0, 0, 0, 1, 0) + struct.pack("<6f", 0, 0, 1, 0, 0, 1)
    return {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
            "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "material": 0}]}],
            "materials": [{"emissiveFactor": [1, 1, 1], "emissiveTexture": {"index": 0}}],
            "textures": [{"source": 0}], "images": [{"uri": data_uri(white_pixel(), "image/png")}],
            "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]},
                          {"bufferView": 1, "componentType": 5126, "count": 3, "type": "VEC2"}],
            "bufferViews": [{"buffer": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 24}],
            "buffers": [{"byteLength": 60, "uri": data_uri(places)}]}


class Export(cli_test.CommandLine):
    def export(self, scene, *arguments):
        result = cli_test.run("export", scene, "--to", "mitsuba", self.folder / "out", *arguments)
        self.assertEqual((result.returncode, result.stdout), (0, ""), result.stderr)
        return ElementTree.parse(self.folder / "out" / "scene.xml").getroot()

    def test_export_writes_a_scene_for_mitsuba(self):
        root = self.export(SCENE, "--size", "32x16")
        scripts = [self.folder / "out" / "render.py", *sorted((self.folder / "out" / "steradian_mitsuba").glob("*.py"))]
        self.assertIn("__init__.py", [script.name for script in scripts])
        for script in scripts:
            compile(script.read_text(), script.name, "exec")
        self.assertEqual([tag.get("value") for tag in root.iter("integer")][:2], ["32", "16"])
        for mesh in root.iterfind("shape/string[@name='filename']"):
            self.assertTrue((self.folder / "out" / mesh.get("value")).is_file())
        self.assertGreater(len(list(root.iterfind("shape/emitter"))), 0)

    def test_export_lights_what_only_glows_as_render_does(self):
        scene = self.folder / "detail.gltf"
        scene.write_text(json.dumps(glowing_detail()))
        studio = self.export(scene).findall("emitter[@type='envmap']/string")
        self.assertEqual(len(studio), 1)
        self.assertTrue((self.folder / "out" / studio[0].get("value")).is_file())
        root = self.export(scene, "--rig", "softboxes")
        self.assertEqual(len(root.findall("shape[@type='rectangle']/emitter")), 3)
        self.assertEqual(len(root.findall("shape[@type='ply']/emitter")), 1)
        self.assertEqual(len(self.export(scene, "--rig", "none").findall("shape/emitter")), 1)

    def test_export_refuses_a_folder_that_it_did_not_write(self):
        (self.folder / "notes.txt").write_text("mine")
        self.assert_refused(cli_test.run("export", SCENE, "--to", "mitsuba", self.folder), "notes.txt")
        self.assertEqual((self.folder / "notes.txt").read_text(), "mine")


if __name__ == "__main__":
    SCENE = str(Path(sys.argv[2], "cornell.gltf"))
    sys.exit(cli_test.main(Export))
