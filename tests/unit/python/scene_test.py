"""Scenes that Python edits: saved copies render the same picture; frames, turntables, cameras; tables.

usage: scene_test.py TEST_NAME     (a function below; PYTHONPATH names the folder of the package)
"""
import json
import math
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np
import pandas
import steradian

CORNELL = steradian.sample("cornell")
EMITTERS = steradian.sample("emitters")
MOTION = steradian.sample("motion")
OPTIONS = {"size": (40, 30), "samples": 4, "gl_debug": True}


def refused(error, call, *words):
    """The call raises `error`, whose message is one line with these words."""
    try:
        call()
    except error as raised:
        assert "\n" not in str(raised) and all(word in str(raised) for word in words), raised
        return
    raise AssertionError(f"no {error.__name__}")


def reloaded(scene, name, noise=1e-3, **options):
    """@return the saved copy, read again. It renders what the scene renders, but for a mean relative difference of `noise`"""
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder, name)
        scene.save(file)
        copy = steradian.load(file, strict=True)
        pictures = [one.render(**OPTIONS, **options).image for one in (scene, copy)]
        difference = np.abs(pictures[0] - pictures[1]).mean() / pictures[0].mean()
        assert difference < noise, difference
        return copy


def test_a_saved_copy_has_the_edits_of_lights():
    scene = steradian.load(EMITTERS)
    lights = {light.name: light for light in scene.lights}
    lights["disk"].flux = 150
    lights["disk"].position = (0.3, 1.2, 0.1)
    lights["sphere"].resize("radius", 0.12)
    lights["sphere"].name = "moon"
    lights["tube"].value = (10, 20, 30)
    lights["downlight"].flux = 40
    lights["downlight"].direction = (0, -0.6, 0.8)
    scene.lights.remove(lights["polygon"])
    assert [light.is_edited for light in scene.lights].count(True) == 4
    copy = reloaded(scene, "copy.gltf", rig="none")
    saved = {light.name: light for light in copy.lights}
    assert set(saved) == {"disk", "moon", "tube", "picture", "downlight"}, set(saved)
    assert math.isclose(saved["disk"].flux, 150, rel_tol=1e-4) and np.allclose(saved["disk"].position, (0.3, 1.2, 0.1), atol=1e-5)
    assert math.isclose(saved["moon"].sizes["radius"], 0.12, rel_tol=1e-5) and math.isclose(saved["downlight"].flux, 40, rel_tol=1e-4)
    assert np.allclose(saved["tube"].value, (10, 20, 30), rtol=1e-4)


def test_a_saved_copy_has_new_lights_of_all_kinds():
    scene = steradian.load(CORNELL)
    place, down = (0.1, 0.35, 0.15), (0.2, -1, 0.1)
    scene.lights += [
        steradian.point_light(place, flux=20, color=(1, 0.5, 0.2), name="candle"),
        steradian.point_light(place, intensity=2, radius=0.02, name="bulb"),
        steradian.spot_light(place, down, inner_angle=10, outer_angle=30, intensity=5),
        steradian.directional_light(down, irradiance=3, angular_diameter=0.53),
        steradian.rectangle_light(place, down, 0.1, 0.05, flux=10),
        steradian.disk_light(place, down, 0.05, intensity=3),
        steradian.sphere_light(place, 0.03, radiance=700),
    ]
    tube = next(light for light in steradian.load(EMITTERS).lights if light.name == "tube")
    tube.position = place
    assert reloaded(scene, "copy.glb").lights
    scene.lights.append(tube)  # of another file; its frame has another roll in the copy, and so other samples
    copy = reloaded(scene, "copy.glb", noise=0.02)
    assert [light.name for light in copy.lights] == [light.name for light in scene.lights]
    for ours, saved in zip(scene.lights, copy.lights):
        assert saved.kind == ours.kind and np.allclose(saved.value, ours.value, rtol=1e-4), (ours, saved)
        for value in ("position", "direction"):
            a, b = getattr(ours, value), getattr(saved, value)
            assert (a is None) == (b is None) and (a is None or np.allclose(a, b, atol=1e-5)), (ours, value)
        assert np.allclose(list(ours.sizes.values()), list(saved.sizes.values()), rtol=1e-4), ours
    refused(ValueError, lambda: (scene.lights.extend(steradian.load(EMITTERS).lights), scene.render(**OPTIONS)), "lights", "another scene")


def test_a_saved_copy_has_the_edits_of_materials_and_a_camera():
    scene = steradian.load(CORNELL)
    names = [material.name for material in scene.materials]
    wall = scene.materials[names.index("red")] if "red" in names else scene.materials[1]
    wall.base_color = (0.1, 0.2, 0.7)
    wall.roughness = 0.4
    lamp = next(material for material in scene.materials if max(material.emission) > 0)
    lamp.emission = (300, 200, 100)
    copy = reloaded(scene, "copy.gltf")
    assert np.allclose(copy.materials[wall.index].base_color, (0.1, 0.2, 0.7)) and math.isclose(copy.materials[wall.index].roughness, 0.4, rel_tol=1e-6)
    assert np.allclose(copy.materials[lamp.index].emission, (300, 200, 100), rtol=1e-4)
    assert not scene.materials[0].is_edited and wall.is_edited
    side = scene.camera().turned(20)
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder, "side.glb")
        scene.save(file, camera=side)
        copy = steradian.load(file)
        assert copy.cameras[0].name == "view" and len(copy.cameras) == len(scene.cameras) + 1
        pictures = [one.render(**OPTIONS, camera=camera).image for one, camera in ((scene, side), (copy, None))]
        assert np.abs(pictures[0] - pictures[1]).mean() < 1e-3 * pictures[0].mean()


def test_a_saved_copy_needs_no_other_file():
    with tempfile.TemporaryDirectory() as folder:
        here, there = Path(folder, "here"), Path(folder, "there")
        here.mkdir()
        there.mkdir()
        shutil.copy(EMITTERS, here)
        shutil.copy(EMITTERS.with_name("downlight.ies"), here)
        original = here / EMITTERS.name
        scene = steradian.load(original)
        scene.save(here / "beside.gltf")
        assert '"downlight.ies"' in (here / "beside.gltf").read_text()
        scene.save(there / "alone.gltf")
        steradian.load(there / "alone.gltf").save(there / "alone.glb")
        steradian.load(there / "alone.glb").save(there / "again.gltf")
        pictures = [steradian.load(file, strict=True).render(**OPTIONS).image
                    for file in (original, here / "beside.gltf", there / "alone.gltf", there / "alone.glb", there / "again.gltf")]
        assert all(np.array_equal(pictures[0], other) for other in pictures[1:])
        refused(steradian.Error, lambda: scene.save(original), "file of the scene", "another name")
        refused(steradian.Error, lambda: scene.save(there / "scene.obj"), ".obj", "*.glb")
        refused(steradian.Error, lambda: scene.save(there / "none" / "scene.glb"), "none")
        twin = steradian.load(original)
        twin.lights.append(next(light for light in twin.lights if light.name == "downlight").copy())
        refused(steradian.Error, lambda: twin.save(there / "twin.glb"), "downlight", "profile")
        assert not (there / "twin.glb").exists()


def test_files_with_an_environment_stay_in_their_folder():
    with tempfile.TemporaryDirectory() as folder:
        gltf = json.loads(CORNELL.read_text())
        gltf["scenes"][0].setdefault("extras", {})["steradian"] = {"environment": {"file": "sky.hdr"}}
        file = Path(folder, "sky.gltf")
        file.write_text(json.dumps(gltf))
        steradian.load(CORNELL).render(size=(8, 4), samples=1).save(Path(folder, "sky.hdr"))
        scene = steradian.load(file)
        scene.save(Path(folder, "beside.gltf"))
        Path(folder, "away").mkdir()
        refused(steradian.Error, lambda: scene.save(Path(folder, "away", "sky.gltf")), "sky.hdr", "in the folder of the file")


def test_edited_lights_go_with_animations():
    scene = steradian.load(MOTION)
    lamp, = scene.lights

    def layer(seconds):
        return scene.render(**OPTIONS, at=seconds, layers=True).layers["lamp"]

    plain = layer(1.0)
    lamp.value = (10, 20, 30)  # at every time
    begin, end = layer(0.0), layer(2.0)
    assert np.abs(begin - end).mean() > 0.1 * begin.mean()  # it moves
    lamp.value = (20, 40, 60)
    assert np.allclose(layer(2.0), 2 * end, rtol=1e-4, atol=1e-6)
    lamp.position = [place + 0.2 for place in lamp.position]
    assert np.abs(layer(0.0) - 2 * begin).mean() > 0.01 * begin.mean() and np.abs(layer(2.0) - 2 * end).mean() > 0.01 * end.mean()
    scene.reset()
    assert np.array_equal(layer(1.0), plain)


def test_frames_are_those_of_the_command():
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([steradian.program(), "render", MOTION, "-o", Path(folder, "c.##.png"), "-o", Path(folder, "c.##.exr"), "--frames", "2:4", "--fps", "12",
                        "--size", "40x30", "--samples", "4"], check=True, capture_output=True)
        numbers = []
        for number, picture in steradian.load(MOTION).frames(range(2, 5), fps=12, size=(40, 30), samples=4):
            numbers.append(number)
            picture.save(Path(folder, f"p.{number:02}.png"))
            assert np.array_equal(steradian.read_image(Path(folder, f"c.{number:02}.exr"))[0][..., :4], picture.image), number
            codes = [steradian.read_image(Path(folder, f"{who}.{number:02}.png"))[0] for who in "cp"]
            assert np.array_equal(*codes), number
        assert numbers == [2, 3, 4]
    scene = steradian.load(MOTION)
    every = [number for number, _ in scene.frames(fps=2, size=(8, 6), samples=1)]
    assert every == list(range(int(scene.animations[0].duration * 2) + 1)), every
    refused(ValueError, lambda: next(scene.frames(fps=0)), "fps")
    refused(steradian.Error, lambda: next(scene.frames(animation="none")), "none", "all")


def test_a_turntable_goes_once_around():
    scene = steradian.load(CORNELL)
    pictures = list(scene.turntable(4, size=(16, 16), samples=2))
    assert [number for number, _ in pictures] == [0, 1, 2, 3]
    assert np.array_equal(pictures[0][1].image, scene.render(size=(16, 16), samples=2).image)
    assert not np.array_equal(pictures[1][1].image, pictures[2][1].image)
    with tempfile.TemporaryDirectory() as folder:
        for rig in ("none", "studio"):  # which stands still
            subprocess.run([steradian.program(), "render", CORNELL, "-o", Path(folder, "c.#.exr"), "--turntable", "3", "--size", "16x16", "--samples", "2",
                            "--rig", rig], check=True, capture_output=True)
            for number, picture in scene.turntable(3, size=(16, 16), samples=2, rig=rig):
                assert np.array_equal(steradian.read_image(Path(folder, f"c.{number}.exr"))[0][..., :4], picture.image), (rig, number)
    low, high = scene.bounds
    middle = [(a + b) / 2 for a, b in zip(low, high)]
    apart = next(p for n, p in scene.turntable(4, around=middle, size=(16, 16), samples=2) if n == 1)
    assert np.isclose(apart.image, pictures[1][1].image, rtol=1e-3, atol=1e-3).mean() > 0.9
    tipped = {axis: next(p for n, p in scene.turntable(4, around=around, axis=axis, size=(16, 16), samples=2) if n == 1).image
              for axis, around in (("x", None), ("camera", middle))}
    apart = next(p for n, p in scene.turntable(4, around=middle, axis="x", size=(16, 16), samples=2) if n == 1)
    assert np.isclose(apart.image, tipped["x"], rtol=1e-3, atol=1e-3).mean() > 0.9
    assert not np.isclose(apart.image, pictures[1][1].image, rtol=1e-3, atol=1e-3).mean() > 0.9
    assert np.isclose(tipped["camera"], pictures[1][1].image, rtol=1e-3, atol=1e-3).mean() > 0.9  # it stands upright
    camera = scene.camera("auto")
    around = camera.turned(360, (0, 0, 0))
    assert np.allclose(around.eye, camera.eye) and np.allclose(around.target, camera.target)
    refused(steradian.Error, lambda: scene.camera("none"), "none", "choose one of")
    refused(ValueError, lambda: next(scene.turntable(0)), "count")
    refused(ValueError, lambda: next(scene.turntable(3, around=(0, 0))), "around")
    refused(ValueError, lambda: next(scene.turntable(3, size=16)), "size", "(width, height)")
    refused(ValueError, lambda: next(scene.turntable(3, axis="up")), "axis", "camera")


def test_a_probe_is_a_table():
    table = steradian.load(CORNELL).probe(10, 20, size=(32, 32), samples=2).table()
    assert isinstance(table, pandas.DataFrame)
    assert list(table["name"]) == ["lamp"] and {"E.r", "wi.x", "V", "L_r.g"} <= set(table.columns)


if __name__ == "__main__":
    globals()["test_" + sys.argv[1]]()
