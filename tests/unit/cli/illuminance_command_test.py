#!/usr/bin/env python3
"""`steradian illuminance` as a lighting designer meets it.

usage: illuminance_command_test.py STERADIAN SCENES_FOLDER TEST_NAME     (TEST_NAME is a method of Illuminance below)
"""
import base64
import csv
import json
import math
import struct
import sys
from xml.etree import ElementTree

import cli_test

# A lamp of 314 cd, 2 m above the middle of a floor of 4 × 2 m that faces up, and one of 100 cd at its corner.
ROOM = {
    "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1, 2]}],
    "extensionsUsed": ["KHR_lights_punctual"],
    "extensions": {"KHR_lights_punctual": {"lights": [{"type": "point", "name": "middle", "intensity": 314},
                                                      {"type": "point", "name": "=corner", "intensity": 100}]}},
    "nodes": [{"mesh": 0, "translation": [10, 0, 0]},
              {"translation": [10, 2, 0], "extensions": {"KHR_lights_punctual": {"light": 0}}},
              {"translation": [8, 2, 1], "extensions": {"KHR_lights_punctual": {"light": 1}}}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", "min": [-2, 0, -1], "max": [2, 0, 1]},
                  {"bufferView": 1, "componentType": 5121, "count": 6, "type": "SCALAR"}],
    "bufferViews": [{"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 6}],
    "buffers": [{"byteLength": 54, "uri": None}],
}


def lux(x, z, height):
    """E at (x, z) of the two lamps `height` metres above: I cosθ / d²."""
    total = 0
    for intensity, lamp_x, lamp_z in ((314, 10, 0), (100, 8, 1)):
        distance = math.sqrt((x - lamp_x) ** 2 + (z - lamp_z) ** 2 + height ** 2)
        total += intensity * height / distance ** 3
    return total


class Illuminance(cli_test.CommandLine):
    def setUp(self):
        super().setUp()
        corners = struct.pack("<12f", -2, 0, 1, 2, 0, 1, 2, 0, -1, -2, 0, -1) + bytes([0, 1, 2, 0, 2, 3])
        ROOM["buffers"][0]["uri"] = "data:application/octet-stream;base64," + base64.b64encode(corners).decode()
        self.room = self.folder / "room.gltf"
        self.room.write_text(json.dumps(ROOM))

    def measure(self, *arguments):
        return cli_test.run("illuminance", self.room, "--gl-debug", *arguments)

    def test_a_plan_and_its_numbers(self):
        plan, cells = self.folder / "plan.svg", self.folder / "cells.csv"
        result = self.measure("--height", "0", "--grid", "40x20", "--by-light", "--json", "-o", plan, "-o", cells)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        summary = json.loads(result.stdout)
        rows = list(csv.reader(cells.read_text().splitlines()))
        self.assertEqual(rows[0], ["x [m]", "y [m]", "z [m]", "E [lx]", "middle [lx]", "'=corner [lx]"])
        self.assertEqual(len(rows), 1 + 40 * 20)
        values = []
        for row in rows[1:]:
            x, y, z, E, middle, corner = map(float, row)
            self.assertEqual(y, 0)
            self.assertAlmostEqual(E / lux(x, z, 2), 1, delta=2e-3)
            self.assertAlmostEqual((middle + corner) / E, 1, delta=1e-4)
            values.append(E)
        self.assertAlmostEqual(summary["mean"], sum(values) / len(values), delta=0.01)
        self.assertAlmostEqual(summary["min_over_mean"], min(values) / summary["mean"], delta=1e-4)
        self.assertAlmostEqual(summary["max"], max(values), delta=0.01)
        self.assertEqual([light["light"] for light in summary["lights"]], ["middle", "=corner"])
        svg = ElementTree.parse(plan).getroot()
        self.assertEqual(len(svg.findall(".//{*}circle")), 2)  # a mark at each lamp
        self.assertGreater(len(svg.findall(".//{*}polyline")), 3)

    def test_a_stated_plane_and_a_border(self):
        stated = json.loads(self.measure("--plane", "9,1,1;2,0,0;0,0,-2", "--grid", "10x10", "--json").stdout)
        self.assertEqual(stated["normal"], [0, 1, 0])
        self.assertAlmostEqual(stated["max"], lux(10.1, 0.1, 1), delta=3)
        below = json.loads(self.measure("--plane", "9,1,-1;2,0,0;0,0,2", "--json").stdout)
        self.assertEqual((below["normal"], below["max"]), ([0, -1, 0], 0))
        above = self.measure("--height", "3", "--grid", "4x4")
        self.assertIn("no light reaches 16 of 16 cells: the plane faces away from the lights, lies above them", above.stderr)
        inner = json.loads(self.measure("--border", "0.5", "--spacing", "0.25", "--json").stdout)
        self.assertEqual((inner["columns"], inner["rows"]), (12, 4))
        self.assertEqual(inner["corner [m]"][0], 8.5)

    def test_impossible_planes_are_refused(self):
        for arguments, word in ((["--plane", "0,0,0;1,0,0"], "a corner and two edges"), (["--plane", "0,0,0;1,0,0;1,1,0"], "perpendicular"),
                                (["--plane", "0,0,0;0,0,0;0,0,1"], "perpendicular"), (["--spacing", "0"], "above 0"),
                                (["--grid", "5000x1"], "COLUMNSxROWS"), (["--spacing", "1e-9"], "choose"),
                                (["--border", "-1"], "0 or more"), (["--isolines", "a"], "E,E"), (["-o", "plan.png"], ".svg")):
            result = self.measure(*arguments)
            self.assertEqual((result.returncode, result.stdout), (2, ""), arguments)
            self.assertIn(word, result.stderr)
        result = self.measure("--border", "1")
        self.assertEqual(result.returncode, 3)
        self.assertIn("no area within its border", result.stderr)
        self.assert_refused(self.measure("-o", self.folder / "none" / "plan.svg"), "none")

    def test_a_scene_without_light_is_refused(self):
        dark = json.loads(self.room.read_text())
        dark["scenes"][0]["nodes"] = [0]
        self.room.write_text(json.dumps(dark))
        result = self.measure()
        self.assertEqual((result.returncode, result.stdout), (3, ""))
        self.assertIn("nothing in the scene emits light: add lights to the file, or light from outside with --environment",
                      result.stderr)
        sky = json.loads(self.measure("--environment", "100", "--height", "0.1", "--json").stdout)
        self.assertAlmostEqual(sky["mean"], 100 * math.pi, delta=0.2)  # E = π L


if __name__ == "__main__":
    sys.exit(cli_test.main(Illuminance))
