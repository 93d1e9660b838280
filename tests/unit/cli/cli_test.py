#!/usr/bin/env python3
"""The command line as a person or a script meets it: exit status, what goes to stdout and stderr, what is written.

usage: cli_test.py STERADIAN SCENES_FOLDER TEST_NAME     (TEST_NAME is a method of CommandLine below)
"""
import base64
import json
import struct
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path
from xml.etree import ElementTree

STERADIAN = SCENE = None


def run(*arguments, **options):
    return subprocess.run([STERADIAN, *map(str, arguments)], capture_output=True, text=True, timeout=250, **options)


class CommandLine(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def render(self, output, *arguments):
        return run("render", SCENE, "-o", self.folder / output, "--size", "48x48", "--samples", "2", "--gl-debug", *arguments)

    def assert_refused(self, result, *words, status=3):
        """One line on stderr that contains the words, nothing on stdout, nothing written."""
        self.assertEqual(result.returncode, status, result.stderr)
        self.assertEqual(result.stdout, "")
        self.assertEqual(len(result.stderr.strip().splitlines()), 1, result.stderr)
        for word in words:
            self.assertIn(word, result.stderr)
        self.assertEqual([p.name for p in self.folder.iterdir() if p.suffix in (".png", ".exr", ".tmp")], [])

    def test_help_shows_examples(self):
        for command in ([], ["render"], ["info"], ["expand"], ["export"], ["brdf"]):
            result = run(*command, "--help")
            self.assertEqual(result.returncode, 0)
            self.assertIn("Examples:", result.stdout)

    def test_strict_makes_a_warning_an_error(self):
        scene = json.loads(Path(SCENE).read_text())
        scene["extensionsUsed"] = [*scene.get("extensionsUsed", []), "EXT_nothing"]
        broken = self.folder / "broken.gltf"
        broken.write_text(json.dumps(scene))
        what = "it uses what is not supported yet, \"EXT_nothing\""
        render = ["render", broken, "-o", self.folder / "a.png", "--size", "32x32", "--samples", "1"]
        self.assert_refused(run(*render, "--strict"), what)
        self.assert_refused(run("info", broken, "--strict"), what)
        self.assert_refused(run("export", broken, "--to", "mitsuba", self.folder / "m", "--strict"), what)
        self.assert_refused(run("probe", broken, "--pixel", "3,4", "--size", "32x32", "--strict"), what)
        result = run(*render)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(result.stderr.count(what), 1, result.stderr)
        self.assertIn(what, run("info", broken).stdout)
        suite = self.folder / "suite.json"
        for strict, outcome in ((True, "broken"), (False, "missing")):
            suite.write_text(json.dumps({"tests": [{"name": "a", "scene": "broken.gltf", "size": "8x8", "samples": 1,
                                                    "tolerance": "rel=0.1", **({} if strict else {"strict": False})}]}))
            self.assertNotEqual(run("golden", "run", suite, "--output", self.folder / "out").returncode, 0)
            results = json.loads((self.folder / "out" / "results.json").read_text())
            self.assertIn(f'"{outcome}"', json.dumps(results))

    def test_usage_errors_exit_with_2(self):
        for arguments in ([], ["frobnicate"], ["render"], ["render", SCENE], ["render", SCENE, "-o", "a.png", "--size", "12"],
                          ["render", SCENE, "-o", "a.png", "--samples", "0"],
                          ["render", SCENE, "-o", "a.png", "--error", "0.5"], ["render", SCENE, "-o", "a.png", "--time", "0"],
                          ["render", SCENE, "-o", "a.png", "--time", "3h"],
                          ["render", SCENE, "-o", "a.png", "--tone-curve", "filmic"],
                          ["render", SCENE, "-o", "a.png", "--estimator", "guessed"],
                          ["render", SCENE, "-o", "a.png", "--analytic-points", "-1"]):
            result = run(*arguments)
            self.assertEqual(result.returncode, 2, arguments)
            self.assertEqual(result.stdout, "")
            self.assertNotEqual(result.stderr, "")

    def test_a_missing_scene_is_one_line(self):
        self.assert_refused(run("render", self.folder / "no.gltf", "-o", self.folder / "a.png"), "no.gltf")

    def test_broken_json_names_line_and_column(self):
        scene = self.folder / "broken.gltf"
        scene.write_text('{\n  "asset": { "version": "2.0" },\n  "nodes": [ { ] }\n}\n')
        self.assert_refused(run("render", scene, "-o", self.folder / "a.png"), "broken.gltf:3:")

    def test_an_unknown_format_is_refused_before_any_work(self):
        self.assert_refused(self.render("a.tiff"), ".tiff", ".exr")

    def test_a_missing_folder_is_one_line(self):
        result = run("render", SCENE, "-o", self.folder / "no" / "a.png", "--size", "16x16", "--samples", "1")
        self.assert_refused(result, "a.png")

    def test_an_unknown_camera_lists_those_there_are(self):
        self.assert_refused(self.render("a.png", "--camera", "nobody"), "nobody", "auto")

    def test_a_broken_shader_names_its_line(self):
        (self.folder / "visibility").mkdir()
        (self.folder / "visibility" / "visibility.glsl").write_text(
            "float visibility(vec3 x, vec3 wi, float distance) {\n    return darkness;\n}\n")
        self.assert_refused(self.render("a.png", "--shaders", self.folder), "visibility.glsl:2", "darkness")

    def test_visibility_may_be_a_float_or_a_colour(self):
        (self.folder / "visibility").mkdir()
        for kind in "float", "vec3":
            (self.folder / "visibility" / "visibility.glsl").write_text(
                '#include "surface/surface.glsl"\n'
                f"{kind} visibility(Surface x, vec3 wi, float distance, int light, int ray) {{ return {kind}(0.5); }}\n")
            for estimator in "sampled", "analytic":
                result = self.render("a.exr", "--shaders", self.folder, "--estimator", estimator)
                self.assertEqual(result.returncode, 0, result.stderr)

    def test_the_analytic_estimator_is_named(self):
        result = self.render("a.exr", "--estimator", "analytic", "--analytic-points", "4", "--json")
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertEqual(json.loads(result.stdout)["estimator"], "analytic")

    def test_the_analytic_estimator_asks_for_the_lobes_of_another_brdf(self):
        (self.folder / "brdf").mkdir()
        (self.folder / "brdf" / "f_r.glsl").write_text(
            '#include "surface/surface.glsl"\nvec3 f_r(Surface x, vec3 wi, vec3 wo) { return vec3(0.1); }\n')
        result = self.render("a.png", "--estimator", "analytic", "--shaders", self.folder)
        self.assert_refused(result, "f_r.glsl", "lobes", "sampled")

    def test_a_missing_include_names_who_asks(self):
        (self.folder / "visibility").mkdir()
        (self.folder / "visibility" / "visibility.glsl").write_text('#include "no/such.glsl"\n')
        self.assert_refused(self.render("a.png", "--shaders", self.folder), "visibility.glsl:1", "no/such.glsl")

    def test_too_large_a_picture_is_one_line(self):
        result = run("render", SCENE, "-o", self.folder / "a.png", "--size", "65536x16", "--samples", "1")
        self.assert_refused(result, "65536")

    def test_two_runs_write_the_same_bytes(self):
        for name in ("a.exr", "b.exr"):
            self.assertEqual(self.render(name).returncode, 0)
            time.sleep(1.1)  # a time of day in the file would show
        self.assertEqual((self.folder / "a.exr").read_bytes(), (self.folder / "b.exr").read_bytes())

    def test_an_exr_says_what_it_holds(self):
        result = self.render("a.exr", "--seed", "7")
        self.assertEqual((result.returncode, result.stdout), (0, ""), result.stderr)
        header = (self.folder / "a.exr").read_bytes()[:4096]
        for words in (b"steradian:unit", b"cd/m^2", b"steradian:estimator", b"sampled", b"steradian:samples",
                      b"steradian:seed", b"steradian:GL_RENDERER", b"steradian:GL_VERSION", b"steradian:version",
                      b"steradian:camera", b"steradian:visibility"):
            self.assertIn(words, header)

    def test_every_format_is_written(self):
        magic = {"a.exr": b"\x76\x2f\x31\x01", "a.hdr": b"#?", "a.png": b"\x89PNG", "a.jpg": b"\xff\xd8"}
        for name, begin in magic.items():
            self.assertEqual(self.render(name).returncode, 0)
            self.assertTrue((self.folder / name).read_bytes().startswith(begin), name)

    def test_options_may_stand_before_the_scene(self):
        result = run("render", "-o", self.folder / "a.png", "--size", "16x16", "--samples", "1", "--shaders", self.folder, SCENE)
        self.assertEqual(result.returncode, 0, result.stderr)

    def test_one_rendering_makes_several_files(self):
        self.assertEqual(self.render("a.exr", "-o", self.folder / "a.png").returncode, 0)
        self.render("b.png")
        self.assertTrue((self.folder / "a.exr").exists())
        self.assertEqual((self.folder / "a.png").read_bytes(), (self.folder / "b.png").read_bytes())

    def test_json_is_all_of_stdout(self):
        result = self.render("a.png", "--json")
        summary = json.loads(result.stdout)
        self.assertEqual((summary["width"], summary["height"], summary["samples"]), (48, 48, 2))
        self.assertEqual(summary["unit"], "cd/m^2")
        self.assertGreater(summary["triangles"], 0)
        for phase in ("start", "upload", "compile", "draw", "read", "write", "total"):
            self.assertGreaterEqual(summary["seconds"][phase], 0.0)

    def test_shadows_are_a_choice(self):
        summaries = {}
        for visibility in ("ray", "ray-cpu", "ray-glsl", "none"):
            result = self.render(visibility + ".exr", "--visibility", visibility, "--json")
            summaries[visibility] = json.loads(result.stdout)["shadows"]
        self.assertIsNone(summaries["none"])
        self.assertGreater(summaries["ray-cpu"]["rays"], 0)
        self.assertEqual(summaries["ray-cpu"]["bvh_nodes"], 0)
        self.assertGreater(summaries["ray-glsl"]["bvh_nodes"], 0)
        self.assertEqual(summaries["ray-glsl"]["bvh_triangles"], summaries["ray"]["bvh_triangles"])
        self.assertNotEqual((self.folder / "ray.exr").read_bytes(), (self.folder / "none.exr").read_bytes())
        self.assertEqual(run("render", SCENE, "-o", "a.png", "--visibility", "soft").returncode, 2)

    def test_exposure_is_a_matter_of_the_picture_alone(self):
        self.render("dark.png", "--exposure", "20")
        self.render("bright.png", "--exposure", "2")
        self.assertNotEqual((self.folder / "dark.png").read_bytes(), (self.folder / "bright.png").read_bytes())
        self.render("a.exr", "--exposure", "20")
        self.render("b.exr", "--exposure", "2")
        self.assertEqual((self.folder / "a.exr").read_bytes(), (self.folder / "b.exr").read_bytes())

    def test_an_environment_lights_the_scene_and_is_its_background(self):
        def pixels(name, *arguments):
            self.render(name, *arguments)
            return (self.folder / name).read_bytes()

        alone = pixels("alone.exr", "--rig", "none")
        seen = pixels("seen.exr", "--environment", "0.5")
        hidden = pixels("hidden.exr", "--environment", "0.5", "--hide-environment")
        self.assertEqual(len({alone, seen, hidden}), 3)
        self.assertEqual(hidden, pixels("too.exr", "--environment", "0.5", "--hide-environment", "--environment-rotation", "90"))
        self.assertNotEqual(seen, pixels("strong.exr", "--environment", "0.5", "--environment-strength", "2"))
        for refused, status in (("-1", 2), ("nosuch.hdr", 3), (str(self.folder / "x.png"), 3)):
            result = run("render", SCENE, "-o", self.folder / "no.exr", "--environment", refused)
            self.assertEqual(result.returncode, status, result.stderr)
            self.assertEqual(result.stdout, "")
            self.assertFalse((self.folder / "no.exr").exists())

    def test_a_black_picture_has_a_reason(self):
        triangle = {"asset": {"version": "2.0"}, "scenes": [{"nodes": [0, 1]}], "scene": 0,
                    "nodes": [{"mesh": 0}, {"name": "away", "camera": 0, "translation": [0, 0, -5]}],
                    "cameras": [{"type": "perspective", "perspective": {"yfov": 0.5, "znear": 0.1}}],
                    "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
                    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
                                   "min": [0, 0, 0], "max": [1, 1, 0]}],
                    "bufferViews": [{"buffer": 0, "byteLength": 36}],
                    "buffers": [{"byteLength": 36, "uri": "data:application/octet-stream;base64,"
                                 "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]}
        scene = self.folder / "triangle.gltf"
        scene.write_text(json.dumps(triangle))
        away = run("render", scene, "-o", self.folder / "a.png", "--size", "32x32", "--samples", "1")
        self.assertIn("camera 'away' sees no surface", away.stderr)
        dark = run("render", scene, "-o", self.folder / "a.png", "--size", "32x32", "--samples", "1", "--camera", "auto",
                   "--rig", "none")
        self.assertIn("no light reaches", dark.stderr)
        lit = run("render", scene, "-o", self.folder / "a.png", "--size", "32x32", "--samples", "1", "--camera", "auto")
        self.assertEqual(len(lit.stderr.strip().splitlines()), 1, lit.stderr)  # only that the rig is in use

    def lit_plate(self, lux):
        """A white Lambert plate that a directional light meets head on: it reads lux / pi."""
        data = base64.b64encode(struct.pack("<12f6H", -1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0, 0, 1, 2, 0, 2, 3)).decode()
        file = self.folder / "plate.gltf"
        file.write_text(json.dumps({
            "asset": {"version": "2.0"}, "scenes": [{"nodes": [0, 1, 2]}],
            "nodes": [{"mesh": 0}, {"camera": 0, "translation": [0, 0, 2]},
                      {"extensions": {"KHR_lights_punctual": {"light": 0}}}],
            "cameras": [{"type": "orthographic", "orthographic": {"xmag": 0.5, "ymag": 0.5, "znear": 0.1, "zfar": 9}}],
            "extensionsUsed": ["KHR_lights_punctual"],
            "extensions": {"KHR_lights_punctual": {"lights": [{"type": "directional", "intensity": lux}]}},
            "materials": [{"extras": {"steradian": {"brdf": "lambert"}}}],
            "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "material": 0}]}],
            "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", "min": [-1, -1, 0],
                           "max": [1, 1, 0]},
                          {"bufferView": 1, "componentType": 5123, "count": 6, "type": "SCALAR"}],
            "bufferViews": [{"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 12}],
            "buffers": [{"byteLength": 60, "uri": "data:application/octet-stream;base64," + data}]}))
        return file

    def test_half_ends_at_65504_and_says_so(self):
        for lux, stored, lines in ((1e6, 65504, 1), (1e5, 1e5 / 3.14159265, 0), (1e-12, 0, 0)):
            out, full = self.folder / "half.exr", self.folder / "float.exr"
            result = run("render", self.lit_plate(lux), "-o", out, "--size", "4x4", "--samples", "1", "--exr-type", "half")
            self.assertEqual(result.returncode, 0, result.stderr)
            self.assertEqual(result.stderr.count("65504"), lines, result.stderr)
            run("render", self.lit_plate(stored * 3.14159265), "-o", full, "--size", "4x4", "--samples", "1")
            if stored > 0:
                same = run("compare", out, full)
                self.assertEqual(same.returncode, 0, same.stdout + same.stderr)

    def test_info_lists_backends_and_scenes(self):
        backends = json.loads(run("info", "--json").stdout)
        self.assertEqual([b["name"] for b in backends], ["egl", "osmesa", "window"])
        self.assertTrue(any(b["works"] for b in backends))
        scene = json.loads(run("info", SCENE, "--json").stdout)
        self.assertGreater(scene["triangles"], 0)
        self.assertEqual(scene["lights"][0]["kind"], "rectangle")

    def lamp_alone(self, stated, **asset):
        """A scene of nothing but a lamp of extras.steradian, in a file."""
        scene = self.folder / "lit.gltf"
        scene.write_text(json.dumps({"asset": {"version": "2.0", **asset}, "scenes": [{"nodes": [0]}], "scene": 0,
                                     "nodes": [{"name": "lamp", "extras": {"steradian": stated}}]}))
        return scene

    def test_info_converts_units(self):
        sphere = {"shape": "sphere", "radius": 0.5, "quantity": {"value": 100, "unit": "lm"}}
        lamp = json.loads(run("info", self.lamp_alone(sphere), "--json").stdout)["lights"][0]
        self.assertAlmostEqual(lamp["Phi [lm]"], 100, 3)
        self.assertAlmostEqual(lamp["L [cd/m^2]"][1], 100 / 3.14159265 / 3.14159265, 3)  # Φ / (π A), A = π
        self.assertIn('sphere "lamp": L [cd/m^2]', run("info", self.lamp_alone(sphere)).stdout)
        sphere["quantity"] = {"value": 10, "unit": "W"}
        radiometric = {"extras": {"steradian": {"units": "radiometric"}}}
        scene = json.loads(run("info", self.lamp_alone(sphere, **radiometric), "--json").stdout)
        self.assertEqual(scene["unit"], "W/(m^2 sr)")
        self.assertAlmostEqual(scene["lights"][0]["Phi [W]"], 10, 4)

    def test_the_unit_of_a_radiometric_scene_is_written(self):
        sphere = {"shape": "sphere", "radius": 0.5, "quantity": {"value": 10, "unit": "W"}}
        scene = self.lamp_alone(sphere, extras={"steradian": {"units": "radiometric"}})
        result = run("render", scene, "-o", self.folder / "a.exr", "--size", "16x16", "--samples", "1", "--json")
        self.assertEqual(json.loads(result.stdout)["unit"], "W/(m^2 sr)", result.stderr)
        self.assertIn(b"W/(m^2 sr)", (self.folder / "a.exr").read_bytes()[:4096])

    def test_hidden_emitters_are_not_seen(self):
        self.render("seen.exr")
        self.assertEqual(self.render("unseen.exr", "--hide-emitters").returncode, 0)
        self.assertNotEqual((self.folder / "seen.exr").read_bytes(), (self.folder / "unseen.exr").read_bytes())

    def test_a_bad_light_is_one_line(self):
        sphere = {"shape": "sphere", "radius": 0, "quantity": {"value": 10, "unit": "lm"}}
        self.assert_refused(run("info", self.lamp_alone(sphere)), "lit.gltf", '"lamp"', "has the radius 0")

    def test_probe_prints_the_equation_at_a_pixel(self):
        arguments = ("probe", SCENE, "--size", "48x48", "--samples", "2", "--gl-debug")
        table = run(*arguments, "--pixel", "30,24")
        self.assertEqual((table.returncode, table.stderr), (0, ""))
        self.assertIn("rectangle", table.stdout)
        terms = json.loads(run(*arguments, "--pixel", "30,24", "--json").stdout)
        for channel in range(3):
            total = terms["L_e [cd/m^2]"][channel] + sum(light["L_r [cd/m^2]"][channel] for light in terms["lights"])
            self.assertAlmostEqual(total / terms["L_o [cd/m^2]"][channel], 1.0, places=5)
        self.assertEqual(run(*arguments, "--pixel", "48,0").returncode, 2)
        self.assertEqual(run(*arguments, "--pixel", "a,0").returncode, 2)

    def test_brdf_checks_the_laws_of_a_brdf(self):
        result = run("brdf", "ggx", "--roughness", "0.4", "--json", "-o", self.folder / "lobe.svg", "-o", self.folder / "ball.png",
                     "--samples", "1")
        self.assertEqual(result.returncode, 0, result.stderr)
        laws = {law["law"]: law for law in json.loads(result.stdout)["laws"]}
        self.assertEqual(set(laws), {"reciprocity", "negativity", "energy", "normalisation", "sampling"})
        self.assertTrue(all(law["holds"] for law in laws.values()), laws)
        ElementTree.fromstring((self.folder / "lobe.svg").read_text())
        self.assertGreater((self.folder / "ball.png").stat().st_size, 1000)

    def test_brdf_finds_what_a_persons_own_brdf_breaks(self):
        mine = self.folder / "mine.glsl"
        mine.write_text("#include \"surface/surface.glsl\"\n"
                        "vec3 f_r(Surface x, vec3 wi, vec3 wo) { return vec3(0.5 * dot(x.n, wi)); }\n")
        result = run("brdf", mine, "--json")
        self.assertEqual(result.returncode, 1, result.stderr)
        holds = {law["law"]: law["holds"] for law in json.loads(result.stdout)["laws"]}
        self.assertEqual(holds, {"reciprocity": False, "negativity": True, "energy": False})
        mine.write_text("#include \"surface/surface.glsl\"\n\nvec3 f_r(Surface x, vec3 wi, vec3 wo) { return nonsense; }\n")
        self.assert_refused(run("brdf", mine), "mine.glsl:3")
        mine.write_text("float x;")
        self.assert_refused(run("brdf", mine), "mine.glsl", "f_r")
        self.assert_refused(run("brdf", self.folder / "no.binary"), "no.binary")
        self.assertEqual(run("brdf", "plastic").returncode, 2)

    def test_completion_offers_commands_options_and_values(self):
        script = run("completion", "bash").stdout
        (self.folder / "completion").write_text(script)

        def completed(*words):
            line = " ".join(f"'{word}'" for word in words)
            command = (f"source completion; COMP_WORDS=(steradian {line}); COMP_CWORD={len(words)}; "
                       "_steradian; printf '%s\\n' \"${COMPREPLY[@]}\"")
            result = subprocess.run(["bash", "-c", command], capture_output=True, text=True, cwd=self.folder, timeout=100)
            self.assertEqual(result.stderr, "")
            return result.stdout.split()

        self.assertEqual(completed("rend"), ["render"])
        self.assertEqual(completed("golden", "app"), ["approve"])
        self.assertEqual(completed("render", "scene.glb", "--tone-c"), ["--tone-curve"])
        self.assertEqual(completed("render", "--estimator", "a"), ["analytic"])
        self.assertEqual(completed("render", "--view", "lu"), ["luminance"])
        self.assertEqual(completed("render", ""), [])  # bash completes file names
        self.assertNotIn("compile-trial", completed(""))

    def test_expand_prints_a_whole_shader(self):
        result = run("expand", "forward.frag")
        self.assertTrue(result.stdout.startswith("#version 410 core\n"))
        self.assertNotIn("#include", result.stdout)
        self.assert_refused(run("expand", "no.frag"), "no.frag")


def main(tests=CommandLine):
    """Runs the one test of `tests` that the command line names. Exit status 77: it is skipped."""
    global STERADIAN, SCENE
    STERADIAN, SCENE = sys.argv[1], Path(sys.argv[2], "cornell.gltf")
    suite = unittest.TestSuite([tests("test_" + sys.argv[3])])
    result = unittest.TextTestRunner(verbosity=0).run(suite)
    for _, reason in result.skipped:
        print(f"SKIPPED: {reason}")
    return 77 if result.skipped else 0 if result.wasSuccessful() else 1


if __name__ == "__main__":
    sys.exit(main())
