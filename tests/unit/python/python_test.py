"""The Python module: the same numbers as the command line, edits, errors, threads, comparisons, BRDFs.

usage: python_test.py TEST_NAME     (a function below; PYTHONPATH names the folder of the package)
"""
import doctest
import importlib.util
import math
import os
import re
import signal
import subprocess
import sys
import tempfile
import threading
import time
import warnings
from pathlib import Path

import numpy as np
import steradian

CORNELL = steradian.sample("cornell")
SOURCE = Path(__file__).resolve().parents[3]


def refused(error, call, *words):
    """The call raises `error`, whose message is one line with these words."""
    try:
        call()
    except error as raised:
        message = str(raised)
        assert "\n" not in message and all(word in message for word in words), message
        assert type(raised) is error, type(raised)
        return
    raise AssertionError(f"no {error.__name__}")


def command(*words):
    return subprocess.run([steradian.program(), *map(str, words)], check=True, capture_output=True, text=True).stdout


def rendered_by_command(folder, *words):
    file = Path(folder, "command.exr")
    command("render", CORNELL, "-o", file, "--gl-debug", *words)
    return steradian.read_image(file)


def test_pictures_have_the_bits_of_the_command():
    with tempfile.TemporaryDirectory() as folder:
        pixels, channels = rendered_by_command(folder, "--size", "48x32", "--samples", 5, "--seed", 7, "--layers", "lights", "--aov",
                                               "depth,normal,error")
        scene = steradian.load(CORNELL)
        picture = scene.render(size=(48, 32), samples=5, seed=7, layers=True, aov=["depth", "normal", "error"], gl_debug=True)
        assert picture.image.shape == (32, 48, 4) and picture.image.dtype == np.float32
        assert np.array_equal(pixels[..., :4], picture.image)
        assert not picture.image.flags.writeable
        for name, array in {**picture.layers, **picture.aov}.items():
            chosen = [number for number, channel in enumerate(channels) if channel.rpartition(".")[0] == name]
            assert chosen and np.array_equal(pixels[..., chosen].reshape(array.shape), array), name
        assert set(picture.aov) == {"depth", "normal", "error"} and set(picture.layers) == {"emission", "lamp"}
        assert np.abs(sum(picture.layers.values()) - picture.image[..., :3]).max() < 1e-5 * picture.image.max()
        again = Path(folder, "python.exr")
        picture.save(again)
        written, names = steradian.read_image(again)
        assert names == channels and np.array_equal(written, pixels)


def test_a_second_picture_does_not_depend_on_the_first():
    scene = steradian.load(steradian.sample("zoo"))
    options = {"size": (40, 30), "samples": 3}
    first = scene.render(**options)
    scene.render(estimator="analytic", size=(20, 20), samples=1, hide_emitters=True)
    scene.lights[0].value = (0, 0, 0)
    assert not np.array_equal(scene.render(**options).image, first.image)
    scene.reset()
    assert np.array_equal(scene.render(**options).image, first.image)
    assert np.array_equal(steradian.load(steradian.sample("zoo")).render(**options).image, first.image)


def test_errors_below_a_target_stop_a_picture():
    told = []
    picture = steradian.load(CORNELL).render(size=(24, 24), error=0.05, progress=lambda *state: told.append(state))
    assert picture.error <= 0.05 and picture.statistics["stopped_by"] == "error"
    assert told and told[-1][0] == "rendering" and 0 <= told[-1][1] <= 1


def test_a_lambert_plane_under_a_new_light_has_its_closed_form():
    """White Lambert below a point light: L = I cosθ / (π r²)."""
    scene = steradian.load(Path(__file__).parents[2] / "golden" / "scenes" / "point.gltf")
    scene.lights[:] = [steradian.point_light((0, 2, 0), intensity=3.0)]
    assert math.isclose(scene.lights[0].flux, 12 * math.pi, rel_tol=1e-6)
    scene.materials[0].base_color = (1, 1, 1)
    down = steradian.Camera(eye=(0, 1, 0), target=(0, 0, 0), up=(0, 0, -1), fov=2)
    picture = scene.render(size=(9, 9), samples=1, camera=down, rig="none")
    assert np.allclose(picture.image[4, 4, :3], 3.0 / (math.pi * 4), rtol=1e-4), picture.image[4, 4]
    probe = scene.probe(4, 4, size=(9, 9), samples=1, camera=down, rig="none")
    assert np.array_equal(np.float32(probe.L_o), picture.image[4, 4, :3])
    light, = probe.lights
    assert np.allclose(light.f_r, 1 / math.pi, rtol=1e-4) and np.allclose(light.E, 0.75, rtol=1e-4)
    assert probe.records()[0]["name"] == "point"


def test_lights_are_edited_in_their_units():
    light = steradian.rectangle_light((1, 2, 3), (0, -1, 0), 2, 0.5, flux=100, color=(2, 1, 1))
    assert np.allclose(light.direction, (0, -1, 0)) and np.allclose(light.position, (1, 2, 3)) and light.unit == "cd/m^2"
    assert math.isclose(light.radiance, 100 / math.pi, rel_tol=1e-5) and math.isclose(light.intensity, 100 / math.pi, rel_tol=1e-5)
    assert math.isclose(light.value[0], 2 * light.value[1], rel_tol=1e-5)
    light.resize("width", 4)
    light.direction = (0, 1, 0)
    light.position = (0, 0, 0)
    assert light.sizes == {"width": 4, "height": 0.5} and math.isclose(light.flux, 200, rel_tol=1e-5)
    assert np.allclose(light.direction, (0, 1, 0), atol=1e-6) and np.allclose(light.position, 0, atol=1e-6)
    sun = steradian.directional_light((0, -1, 0), irradiance=1000)
    assert sun.flux is None and sun.position is None and sun.irradiance == 1000
    refused(ValueError, lambda: setattr(sun, "flux", 3), "flux", "irradiance")
    refused(ValueError, lambda: setattr(sun, "irradiance", -3), "irradiance", "-3")
    refused(ValueError, lambda: steradian.point_light((0, 0, 0)), "flux, intensity, radiance")


def test_failures_are_exceptions_of_one_line():
    scene = steradian.load(CORNELL)
    refused(steradian.Error, lambda: steradian.load("no_such.glb"), "no_such.glb")
    refused(steradian.Error, lambda: scene.render(camera="none such"), "no camera 'none such'", "choose one of")
    refused(TypeError, lambda: scene.render(sample=3), "did you mean 'samples'?")
    refused(ValueError, lambda: scene.render(samples=0), "samples: '0' is not a whole number")
    refused(ValueError, lambda: scene.render(denoise=True), "denoise", "estimator analytic")
    refused(ValueError, lambda: scene.probe(40, 0, size=(40, 40)), "pixel", "40x40")
    refused(ValueError, lambda: steradian.brdf("none"), "lambert")
    refused(ValueError, lambda: steradian.brdf("ggx", gloss=1), "gloss")
    refused(ValueError, lambda: steradian.brdf("lambert").f_r((0, 0, 2), (0, 0, 1)), "unit vector")
    refused(steradian.Error, lambda: steradian.compare("none.exr", np.zeros((4, 4, 3))), "none.exr")
    refused(ValueError, lambda: steradian.compare(np.zeros((4, 4, 2)), np.zeros((4, 4, 3))), "(4, 4, 2)")
    assert scene.render(size=(8, 8), samples=1).image.max() > 0  # a failure does no harm to what comes next
    with warnings.catch_warnings(record=True) as heard:
        warnings.simplefilter("always")
        steradian.load(CORNELL).render(size=(8, 8), samples=1, camera="eye=0,1,90;target=0,1,99")
    assert [str(w.message) for w in heard if issubclass(w.category, steradian.Remark)], heard
    assert all("--" not in str(w.message) and w.filename == __file__ for w in heard), [str(w) for w in heard]


def test_a_missing_library_is_an_error_that_says_what_to_do():
    program = ("import sys\n"
               "class Loader:\n"
               "    def find_spec(self, name, *_):\n"
               "        if name == 'steradian._native': raise ImportError('libfmt.so.9: cannot open shared object file: No such file or directory')\n"
               "sys.meta_path.insert(0, Loader())\n"
               "import steradian\n")
    run = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True)
    last = run.stderr.splitlines()[-1]
    assert last.startswith("ImportError: libfmt.so.9: no such library") and "apt-file search libfmt.so.9" in last, run.stderr


def test_other_threads_run_while_a_picture_is_rendered():
    ticks = []
    ended = threading.Event()

    def tick():
        while not ended.wait(0.005):
            ticks.append(time.monotonic())

    other = threading.Thread(target=tick)
    other.start()
    begin = time.monotonic()
    steradian.load(CORNELL).render(size=(128, 128), samples=16)
    end = time.monotonic()
    ended.set()
    other.join()
    within = [tick for tick in ticks if begin <= tick <= end]
    assert len(within) >= 5, (len(within), end - begin)


def test_threads_render_one_after_the_other():
    scenes = [steradian.load(CORNELL) for _ in range(3)]
    alone = scenes[0].render(size=(16, 16), samples=2).image
    pictures = [None] * 3

    def render(number):
        pictures[number] = scenes[number].render(size=(16, 16), samples=2).image

    threads = [threading.Thread(target=render, args=(number,)) for number in range(3)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert all(np.array_equal(picture, alone) for picture in pictures)


def test_ctrl_c_ends_a_picture():
    scene = steradian.load(CORNELL)

    def interrupt(*_):
        os.kill(os.getpid(), signal.SIGINT)

    try:
        scene.render(size=(64, 64), samples=1 << 20, progress=interrupt)
    except KeyboardInterrupt:
        pass
    else:
        raise AssertionError("no KeyboardInterrupt")
    assert scene.render(size=(8, 8), samples=1).samples == 1

    def fail(*_):
        raise LookupError("mine")

    refused(LookupError, lambda: scene.render(size=(64, 64), samples=1 << 20, progress=fail), "mine")


def test_brdfs_have_their_values_and_laws():
    lambert = steradian.brdf("lambert", base_color=(0.9, 0.5, 0.1))
    wi = np.array([[0, 0, 1], [0.6, 0, 0.8], [0, -0.8, 0.6]])
    values = lambert.f_r(wi[:, None], wi[None])
    assert values.shape == (3, 3, 3) and np.allclose(values, np.array([0.9, 0.5, 0.1]) / math.pi, rtol=1e-5)
    assert np.allclose(lambert.albedo(wi), (0.9, 0.5, 0.1), rtol=1e-3)
    ggx = steradian.brdf("ggx", roughness=0.4)
    # D G2 F / (4 cosθ_i cosθ_o) at normal incidence: α = 0.16, D = 1 / (π α²), G2 = F = 1
    assert np.allclose(ggx.f_r((0, 0, 1), (0, 0, 1)), 1 / (4 * math.pi * 0.16**2), rtol=1e-4)
    assert np.allclose(ggx(wi[1], wi[2]), ggx(wi[2], wi[1]), rtol=1e-5)
    directions, densities = ggx.sample((0, 0, 1), np.random.default_rng(1).random((64, 2)))
    assert np.allclose(np.linalg.norm(directions, axis=-1), 1, atol=1e-4) and (densities > 0).all()
    assert {law.law for law in ggx.laws() if law.holds} >= {"reciprocity", "energy", "normalisation"}


def test_comparisons_judge_and_explain():
    picture = steradian.load(CORNELL).render(size=(64, 64), samples=4)
    assert steradian.compare(picture, picture) and steradian.compare(picture, picture).metrics["rmse"] == 0
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder, "picture.exr")
        picture.save(file)
        assert steradian.compare(picture.image, file).passed
        wrong = steradian.compare(picture.image * np.float32([math.pi, math.pi, math.pi, 1]), file)
        assert not wrong and wrong.diagnosis.name == "pi_missing", str(wrong)
        assert wrong.heat_map.shape == (64, 64, 3) and wrong.error.shape == (64, 64) and wrong.error.max() > 1
    assert steradian.compare(picture, picture.image * np.float32(1.01), "rel=0.02").passed
    shown = picture.display()
    assert shown.dtype == np.uint8 and shown.shape == (64, 64, 3)
    assert not steradian.compare(np.roll(shown, 1, axis=1), shown)


def test_pictures_show_themselves_in_notebooks():
    picture = steradian.load(CORNELL).render(size=(20, 10), samples=1)
    png = picture._repr_png_()
    assert png[:8] == b"\x89PNG\r\n\x1a\n" and picture._repr_html_().startswith("<figure><img src=\"data:image/png;base64,")
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder, "picture.png")
        picture.save(file)
        written, _ = steradian.read_image(file)
    assert np.array_equal((written[..., :3] * 255).round().astype(np.uint8), picture.display())
    comparison = steradian.compare(picture, picture)
    assert "PASS" in comparison._repr_html_()


def test_examples_in_docstrings_hold():
    failed = 0
    for name in ("", "._scene", "._compare", "._brdf", "._lights", "._program"):
        module = sys.modules["steradian" + name]
        found = doctest.testmod(module, extraglobs={"steradian": steradian, "np": np}, optionflags=doctest.ELLIPSIS)
        failed += found.failed
    assert failed == 0


def test_types_are_strict():
    """The package itself has no errors, and callers' mistakes are found through its types."""
    if importlib.util.find_spec("mypy") is None:
        print("SKIPPED: the Python package mypy is not installed")
        sys.exit(77)
    with tempfile.TemporaryDirectory() as folder:
        caller = Path(folder, "caller.py")
        caller.write_text("import steradian\nscene = steradian.load('a.glb')\nflux: float | None = scene.lights[0].flux\n"
                          "scene.render(size=64, samples=2)\nname: int = scene.render().unit\n")
        run = subprocess.run([sys.executable, "-m", "mypy", f"--cache-dir={folder}/cache", "src/python/steradian", caller], cwd=SOURCE,
                             capture_output=True, text=True)
        errors = [line for line in run.stdout.splitlines() if ": error: " in line]
        assert [re.sub(r".*/(\w+\.py:\d+):.*", r"\1", line) for line in errors] == ["caller.py:4", "caller.py:5"], run.stdout + run.stderr


def test_stubs_are_those_of_the_module():
    """After a change: python -m nanobind.stubgen -m steradian._native -O src/python/steradian"""
    from nanobind.stubgen import StubGen

    made = StubGen(steradian._native)
    made.put(steradian._native)
    committed = Path(steradian.__file__).with_name("_native.pyi").read_text(encoding="utf-8")
    assert made.get().strip() == committed.strip(), "src/python/steradian/_native.pyi is of another module"


if __name__ == "__main__":
    globals()["test_" + sys.argv[1]]()
