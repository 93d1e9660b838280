#!/usr/bin/env python3
"""The report of a check in a real browser: tasks, checks, problems and pictures, from a file and under its own
Content-Security-Policy, by mouse and by keyboard, in dark and light and on a phone.

usage: report_test.py STERADIAN SOURCE_FOLDER SCRATCH_FOLDER
Needs Chromium and the Python package playwright; exit status 77 (skipped) without them. Leaves screenshots.
"""
import os
import shutil
import subprocess
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "golden"))
from report_test import CHROMIUM, check_width, open_page, sync_playwright  # skips where there is no browser


def make_report(program: str, source: Path, scratch: Path) -> Path:
    """A folder with a right task, a mistake that has a name, a picture that is π times too bright, and code that is no code."""
    folder, report = scratch / "my-a3", scratch / "report.html"
    subprocess.run([program, "assignment", "new", "a3", folder, "--student", "12345"], check=True)
    for file in ("phong.glsl", "microfacets.glsl"):
        text = (source / "assets/assignments/a3-brdf/shaders" / file).read_text()
        text = text.replace("a2 / (pi * d * d)", "a2 / (d * d)").replace("(1.0 - F0) * c", "(1.0 - <b>F0) * c")
        (folder / file).write_text(text.replace("return D(dot(n, h)", "return pi * D(dot(n, h)"))
    run = subprocess.run([program, "assignment", "check", folder, "--report", report], capture_output=True, text=True)
    assert run.returncode == 1, run.stderr
    return report


def check_content(page):
    statuses = page.locator("nav .badge").all_text_contents()
    assert statuses == ["passed", "failed", "passed", "broken", "failed", "not implemented", "not implemented"], statuses
    assert "of 17 points" in page.locator("header .badge").text_content()
    task = page.locator("section[id='A3.2']")
    assert "pi_missing" in task.text_content() and "1/sr" in task.text_content()
    broken = page.locator("section[id='A3.4']")
    assert "microfacets.glsl:32" in broken.text_content() and "<b>F0" in broken.locator("pre").text_content()
    assert page.locator("b, img").count() == 0, "a student's code became markup"


def check_pictures(page):
    """Yours over the reference is π at the pixel under the pointer."""
    task = page.locator("section[id='A3.5']")
    assert task.locator("figcaption").all_text_contents() == ["yours", "reference", "difference"]
    canvas = task.locator("canvas").first
    canvas.scroll_into_view_if_needed()
    box = canvas.bounding_box()
    canvas.hover(position={"x": box["width"] / 2, "y": box["height"] * 0.6})
    *ratios, alpha = [float(text) for text in task.locator(".readout tr").nth(4).locator("td").all_text_contents()]
    assert len(ratios) == 3 and alpha == 1.0, (ratios, alpha)
    assert all(abs(ratio / 3.14159 - 1) < 2e-3 for ratio in ratios), ratios
    page.keyboard.press("5")
    assert task.locator(".frame.swipe .handle").count() == 1
    page.keyboard.press("2")
    width = canvas.bounding_box()["width"]
    page.keyboard.press("-")
    page.keyboard.press("+")
    assert canvas.bounding_box()["width"] != width or width > 64


def check_keyboard(page):
    page.evaluate("scrollTo(0, 0)")
    page.keyboard.press("j")
    before = page.evaluate("scrollY")
    page.keyboard.press("j")
    assert page.evaluate("scrollY") > before, "j does not go to the next task"
    page.keyboard.press("k")
    assert page.evaluate("scrollY") == before, "k does not go back"


def main():
    program, source, scratch = sys.argv[1], Path(sys.argv[2]), Path(sys.argv[3])
    shutil.rmtree(scratch, ignore_errors=True)
    scratch.mkdir(parents=True)
    report = make_report(program, source, scratch)
    with sync_playwright() as playwright:
        arguments = ["--no-sandbox"] if os.geteuid() == 0 else []
        browser = playwright.chromium.launch(executable_path=CHROMIUM, args=arguments)
        for name, options in {
            "light": {"viewport": {"width": 1280, "height": 600}, "color_scheme": "light"},
            "dark": {"viewport": {"width": 1280, "height": 600}, "color_scheme": "dark"},
            "phone": {"viewport": {"width": 390, "height": 844}, "has_touch": True},
        }.items():
            page, errors = open_page(browser, report, **options)
            check_width(page)
            page.screenshot(path=scratch / f"{name}.png", full_page=True)
            check_content(page)
            check_pictures(page)
            check_keyboard(page)
            assert not errors, errors
        page = browser.new_page(java_script_enabled=False)
        page.goto(report.as_uri())
        assert "pi_missing" not in page.title() and page.locator("table tr").count() > 8, "without scripts there is no table"
        browser.close()
    print(f"screenshots in {scratch}")


if __name__ == "__main__":
    main()
