#!/usr/bin/env python3
"""The report in a real browser: escapes, works under its own Content-Security-Policy and from a file, shows what a
run found, by mouse and by keyboard, in dark and light and on a phone.

usage: report_test.py STERADIAN SOURCE_FOLDER SCRATCH_FOLDER
Needs Chromium and the Python package playwright; exit status 77 (skipped) without them. Leaves screenshots.
"""
import csv
import json
import os
import shutil
import struct
import subprocess
import sys
from pathlib import Path

SKIPPED = 77
EVIL = "<img src=x onerror=alert(1)> & \"quotes\" '"


def skip(reason):
    print(f"SKIPPED: {reason}")
    sys.exit(SKIPPED)


try:
    from playwright.sync_api import sync_playwright
except ImportError:
    skip("the Python package playwright is not installed")
CHROMIUM = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")
if not CHROMIUM:
    skip("no Chromium here (Debian: apt-get install chromium)")


def golden(program, *words, status=0):
    result = subprocess.run([program, "golden", *map(str, words)], capture_output=True, text=True)
    assert result.returncode == status, f"{words}: {result.returncode}\n{result.stdout}{result.stderr}"


def make_run(program, source, scratch):
    """A run with one test of each outcome; the one that differs has a name and a tag that are markup."""
    scenes = source / "tests/golden/scenes"
    small = {"size": "24x16", "samples": 1, "exr_type": "half"}
    suite = {"name": f"report {EVIL}", "goldens": "goldens", "defaults": small, "tests": [
        {"name": "passes", "scene": str(scenes / "point.gltf")},
        {"name": EVIL.replace("/", ""), "scene": str(scenes / "two_lights.gltf"), "tags": ["</script><script>alert(2)</script>"]},
        {"name": "new", "scene": str(scenes / "sun.gltf")},
        {"name": "broken", "command": ["sh", "-c", "echo '</script><b>boom</b>' >&2; exit 5", "{out}"]}]}
    file = scratch / "suite.json"
    file.write_text(json.dumps(suite))
    out = scratch / "out"
    golden(program, "run", file, "-o", out, status=1)
    golden(program, "approve", file, "passes", "<img*", "-o", out, "--force")
    mutant = scratch / "pi_missing"
    (mutant / "brdf").mkdir(parents=True)
    (mutant / "brdf/lambert.glsl").write_text("vec3 f_lambert(vec3 albedo) { return albedo; }\n")
    suite["tests"][1]["shaders"] = [str(mutant)]
    file.write_text(json.dumps(suite))
    golden(program, "run", file, "-o", out, status=1)
    return out / "report.html"


def write_exr(file, width, height, grey, nan_at=None):
    """An uncompressed OpenEXR file of one grey; the pixel nan_at is not a number."""
    channels = b"".join(name + b"\0" + struct.pack("<iBxxxii", 2, 0, 1, 1) for name in (b"B", b"G", b"R")) + b"\0"
    window = struct.pack("<4i", 0, 0, width - 1, height - 1)
    attributes = [(b"channels", b"chlist", channels), (b"compression", b"compression", b"\0"), (b"dataWindow", b"box2i", window),
                  (b"displayWindow", b"box2i", window), (b"lineOrder", b"lineOrder", b"\0"), (b"pixelAspectRatio", b"float", struct.pack("<f", 1)),
                  (b"screenWindowCenter", b"v2f", struct.pack("<2f", 0, 0)), (b"screenWindowWidth", b"float", struct.pack("<f", 1))]
    head = struct.pack("<ii", 20000630, 2) + b"".join(n + b"\0" + t + b"\0" + struct.pack("<i", len(v)) + v for n, t, v in attributes) + b"\0"
    size = 8 + 12 * width
    offsets = struct.pack(f"<{height}Q", *(len(head) + 8 * height + size * y for y in range(height)))
    lines = []
    for y in range(height):
        row = [grey] * width
        if nan_at and nan_at[1] == y:
            row[nan_at[0]] = float("nan")
        lines.append(struct.pack("<ii", y, size - 8) + 3 * struct.pack(f"<{width}f", *row))
    file.write_bytes(head + offsets + b"".join(lines))


def make_nan_run(program, scratch):
    """A run with one pixel of 640x360 that is not a number, and a picture whose golden has another size."""
    scratch.mkdir()
    names = ("one_nan", "resized")
    suite = {"tests": [{"name": name, "command": ["cp", f"{name}.exr", "{out}"]} for name in names]}
    (scratch / "suite.json").write_text(json.dumps(suite))
    for name in names:
        write_exr(scratch / f"{name}.exr", 640, 360, 0.5)
    golden(program, "run", scratch / "suite.json", "-o", scratch / "out", status=1)
    golden(program, "approve", scratch / "suite.json", "-o", scratch / "out")
    write_exr(scratch / "one_nan.exr", 640, 360, 0.5, nan_at=(401, 233))
    write_exr(scratch / "resized.exr", 320, 200, 0.5)
    golden(program, "run", scratch / "suite.json", "-o", scratch / "out", status=1)
    return scratch / "out/report.html"


def open_page(browser, report, **options):
    """The page, and the list that its errors go to."""
    page = browser.new_page(**options)
    errors = []
    page.on("console", lambda message: errors.append(message.text) if message.type in ("error", "warning") else None)
    page.on("pageerror", lambda error: errors.append(str(error)))
    page.on("dialog", lambda dialog: errors.append(f"a script was smuggled in: {dialog.message}"))
    page.on("request", lambda request: None if request.url.startswith(("file:", "data:")) else errors.append(request.url))
    page.goto(report.as_uri())
    page.wait_for_selector("article h2")
    return page, errors


def wait_for_test(page, name):
    page.locator("article h2", has_text=name).wait_for()  # wait_for_function would need eval, which the CSP forbids


def choose(page, name):
    page.locator("nav button", has_text=name).first.click()
    wait_for_test(page, name)


def check_content(page):
    outcomes = page.locator("nav .badge").all_text_contents()
    assert outcomes == ["differs", "broken", "no golden", "passed"], outcomes
    assert EVIL in page.locator("article h2").text_content()
    assert page.locator("img, b, nav script").count() == 0, "a name became markup"
    assert "pi_missing" in page.locator(".diagnosis").text_content()
    assert page.locator("article canvas").count() == 3
    commands = page.locator(".command").all_text_contents()
    assert any("golden approve" in c for c in commands) and any("steradian render" in c for c in commands), commands
    choose(page, "broken")
    assert "boom" in page.locator("pre").text_content() and page.locator("article canvas").count() == 0
    choose(page, "new")
    assert page.locator("article canvas").count() == 1 and "no golden" in page.locator("article h2").text_content()


def check_pixels(page, program, report):
    """The value under the cursor is the candidate's, linear."""
    choose(page, "new")  # the sun on white Lambert: E/π everywhere
    page.locator("article canvas").hover(position={"x": 20, "y": 20})
    cells = page.locator(".readout td").all_text_contents()
    for found, true in zip(map(float, cells), (0.95493, 0.859437, 0.763944)):
        assert abs(found / true - 1) < 1e-3, cells
    choose(page, "onerror")
    page.locator("article canvas").first.hover(position={"x": 30, "y": 30})
    *ratios, alpha = [float(text) for text in page.locator(".readout tr").nth(4).locator("td").all_text_contents()]
    assert len(ratios) == 3 and all(abs(ratio / 3.14159 - 1) < 2e-3 for ratio in ratios), ratios
    assert alpha == 1, alpha


def check_keyboard(page):
    choose(page, "onerror")
    page.keyboard.press("5")
    assert page.locator(".frame.swipe .handle").count() == 1
    page.keyboard.press("6")
    caption = page.locator("figcaption")
    page.keyboard.press("Space")
    before = caption.text_content()
    page.keyboard.press("Space")
    assert caption.text_content() != before, "flicker does not change by hand"
    page.keyboard.press("2")
    width = "parseFloat(document.querySelector('article canvas').style.width)"
    page.keyboard.press("0")
    for _ in range(8):
        page.keyboard.press("+")
    assert page.evaluate(width) == 24 * 64
    for _ in range(5):
        page.keyboard.press("-")
    assert page.evaluate(width) == 24 * 2, page.evaluate(width)
    pixel = "Array.from(document.querySelector('article canvas').getContext('2d').getImageData(5, 5, 1, 1).data)"
    before = page.evaluate(pixel)
    page.keyboard.press("[")
    assert page.evaluate(pixel)[0] < before[0], "a lower exposure is not darker"
    page.keyboard.press("ArrowRight")
    page.keyboard.press("ArrowRight")
    assert "(14, 8)" in page.locator(".readout").text_content() or page.locator(".readout table").count() == 1
    page.keyboard.press("j")
    wait_for_test(page, "broken")
    page.keyboard.press("k")
    wait_for_test(page, "onerror")
    page.keyboard.press("f")
    assert page.locator("nav button:visible").count() == 3


def check_review(page, program, report, scratch):
    """What is approved and rejected in the page is what approve reads."""
    choose(page, "onerror")
    page.keyboard.press("x")
    choose(page, "new")
    page.locator("button[data-decides=approved]").click()
    with page.expect_download() as download:
        page.locator(".review button").click()
    file = scratch / "review.json"
    download.value.save_as(file)
    review = json.loads(file.read_text())
    assert [test["name"] for test in review["approved"]] == ["new"], review
    assert [test["name"] for test in review["rejected"]] == [EVIL.replace("/", "")], review
    command = page.locator(".review code").text_content()
    assert "--failed-as-reviewed review.json" in command, command
    golden(program, "approve", scratch / "suite.json", "-o", report.parent, "--failed-as-reviewed", file, "--dry-run", "--force")


def check_table(page, scratch):
    """The table has all tests, and no cell that a spreadsheet computes or that breaks a row."""
    with page.expect_download() as download:
        page.locator("header button", has_text="save tests.csv").click()
    file = scratch / "tests.csv"
    download.value.save_as(file)
    with file.open(encoding="utf-8", newline="") as stream:
        rows = list(csv.DictReader(stream))
    assert [row["outcome"] for row in rows] == ["differs", "broken", "missing", "passed"], rows
    assert rows[0]["test"] == EVIL.replace("/", "") and rows[0]["diagnosis"] == "pi_missing", rows[0]
    assert rows[0]["decision"] == "rejected" and float(rows[0]["largest_error_over_limit"]) > 1, rows[0]


def check_quick_choices(page):
    """The viewer is that of the test that was chosen last, also where pictures of others were still unpacked."""
    is_shown = "(async () => { await Promise.all([1, 2, 3, 0].map((index) => choose(index))); return page.viewer.node.isConnected; })()"
    assert page.evaluate(is_shown), "the keys reach the viewer of another test"
    assert EVIL in page.locator("article h2").text_content()


def check_places(page):
    """The single pixel that is not finite is found, and enlarged."""
    page.wait_for_selector("article .box")
    assert "1 failing place" in page.locator(".bar").text_content()
    page.keyboard.press("n")
    text = page.locator(".bar").text_content()
    assert "1 not finite" in text and "(401, 233)" in text, text
    readout = page.locator(".readout").text_content()
    assert "(401, 233)" in readout and "Not finite in one of them." in readout, readout
    marker, stage = (page.locator(f"article {what}").first.bounding_box() for what in (".box", ".stage"))
    assert stage["x"] <= marker["x"] <= stage["x"] + stage["width"], (marker, stage)
    assert stage["y"] <= marker["y"] <= stage["y"] + stage["height"], (marker, stage)
    before = page.locator("article canvas").first.bounding_box()["width"]
    page.locator(".stage").first.hover()
    page.mouse.wheel(0, 300)
    page.wait_for_timeout(50)
    assert page.locator("article canvas").first.bounding_box()["width"] < before, "the wheel does not zoom"


def check_sizes(page):
    """A golden of another size is shown beside the test."""
    choose(page, "resized")
    assert page.locator("article canvas").count() == 2
    page.keyboard.press("3")
    assert page.evaluate("document.querySelector('article canvas').width") == 640


def check_search(page):
    page.keyboard.press("/")
    page.keyboard.type("boom")
    assert page.locator("nav button:visible").count() == 1
    page.keyboard.press("Escape")
    assert page.locator("nav button:visible").count() == 4
    page.locator("header .counts button", has_text="passed").click()
    assert page.locator("nav button:visible").count() == 1
    page.locator("header .counts button", has_text="passed").click()


def check_width(page):
    overflow = page.evaluate("document.documentElement.scrollWidth - document.documentElement.clientWidth")
    assert overflow <= 0, f"the page is {overflow} pixels too wide"


def main():
    program, source, scratch = sys.argv[1], Path(sys.argv[2]), Path(sys.argv[3])
    shutil.rmtree(scratch, ignore_errors=True)
    scratch.mkdir(parents=True)
    report = make_run(program, source, scratch)
    nan_report = make_nan_run(program, scratch / "nan")
    with sync_playwright() as playwright:
        arguments = ["--no-sandbox"] if os.geteuid() == 0 else []
        browser = playwright.chromium.launch(executable_path=CHROMIUM, args=arguments)
        for name, options in {
            "light": {"viewport": {"width": 1280, "height": 860}, "color_scheme": "light"},
            "dark": {"viewport": {"width": 1280, "height": 860}, "color_scheme": "dark"},
            "phone": {"viewport": {"width": 390, "height": 844}, "color_scheme": "dark", "has_touch": True},
        }.items():
            page, errors = open_page(browser, report, **options)
            check_width(page)
            page.screenshot(path=scratch / f"{name}.png", full_page=name == "phone")
            check_content(page)
            check_search(page)
            check_pixels(page, program, report)
            check_review(page, program, report, scratch)
            check_table(page, scratch)
            check_quick_choices(page)
            check_keyboard(page)
            assert not errors, errors
        for size in ((1280, 860), (390, 844)):
            page, errors = open_page(browser, nan_report, viewport={"width": size[0], "height": size[1]})
            check_width(page)
            check_places(page)
            check_sizes(page)
            assert not errors, errors
        page = browser.new_page(java_script_enabled=False)
        page.goto(report.as_uri())
        assert page.locator("table tr").count() == 5, "without scripts there is no table"
        browser.close()
    print(f"screenshots in {scratch}")


if __name__ == "__main__":
    main()
