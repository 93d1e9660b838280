"""Rows of what only we have: many lights, a small error under a softbox, the viewer, the first picture."""
import json
import shutil
import sys
from pathlib import Path

from curves import softbox
from curves.error import seconds_for
from timing import Failed, in_turns, measured, spread

from .frames import contest_of, frame_ms, peer_of
from .row import Line, Setting, Skipped

ROOT = Path(__file__).resolve().parents[3]
BENCH = ROOT / "tools" / "bench"


def growth_of_lights(setting: Setting, name: str, kind: str, few: int, many: int, samples: str, options: list) -> list[Line]:
    """Processor times of drawing, by tools/bench/lights: those of many lights against those of few, at equal error."""
    results = setting.folder(name) / "lights.json"
    size, reference = ("80x45", 128) if setting.is_quick else ("240x135", 512)
    setting.progress.say(f"tools/bench/lights: {few} and {many} {kind}s")
    try:
        measured([sys.executable, BENCH / "lights", "--program", setting.program, "--kinds", kind, "--counts", f"{few},{many}", "--lights", "auto",
                  "--size", size, "--samples", samples, "--reference", reference, "--json", results, *options], results)
    except Failed as why:
        raise Skipped(f"tools/bench/lights: {why}") from None
    curves = {result["count"]: result["curves"]["auto"] for result in json.loads(results.read_text())}
    setting.figures[name] = curves
    lines = []
    for target in (2e-2, 1e-2) if setting.is_quick else (1e-2, 2e-3):
        seconds = {count: seconds_for(points, target) for count, points in curves.items()}
        what = f"{few} → {many} {kind}s, {size.replace('x', '×')}, processor time to relMSE {target:g}"
        short = [f"{count}: not within {points[0]['rel_mse']:.0e} to {points[-1]['rel_mse']:.0e}" for count, points in curves.items() if not seconds[count]]
        if short:
            lines.append(Line(what, "; ".join(short), "–", "≤ 3 ×", None))
            continue
        ratio = seconds[many] / seconds[few]
        lines.append(Line(what, f"{seconds[few]:.2f} → {seconds[many]:.2f} s", "–", "≤ 3 ×", ratio <= 3.0, spread([ratio]),
                          "the ratio is of many to few lights"))
    return lines


def points(setting: Setting) -> list[Line]:
    return growth_of_lights(setting, "points", "point", 16, 1000, "4,8,16,32,64,128", [])


def rectangles(setting: Setting) -> list[Line]:
    return growth_of_lights(setting, "rectangles", "rectangle", 4, 256, "4,8,16,32,64", ["--hide-emitters"])


def softbox_error(setting: Setting) -> list[Line]:
    scene = softbox.lit(setting.helmet(), setting.scratch / "helmet_softbox.glb")
    picture, size, percent = setting.scratch / "softbox.exr", *(("240x135", 10) if setting.is_quick else ("480x270", 5))

    def draw():
        return measured([setting.program, "render", scene, "-o", picture, "--size", size, "--rig", "none", "--error", f"{percent}%", "--json"], picture)
    results, failures = in_turns({"ours": draw}, min(setting.runs, 2), setting.progress.say, warm=False)
    if failures:
        raise Skipped(failures["ours"])
    said = json.loads(results["ours"][-1].output)
    seconds = spread(cost.seconds for cost in results["ours"])
    setting.figures["softbox_error"] = {"seconds": vars(seconds), "samples_mean": said["samples_mean"], "samples": said["samples"], "error": said["error"]}
    return [Line(f"DamagedHelmet, one softbox, {size.replace('x', '×')}, --error {percent}%", f"{seconds.text(1)} s", "–", "≤ 10 s",
                 seconds.median <= 10.0, None, f"{said['samples_mean']:.0f} samples a pixel, {said['samples']} at most")]


def viewer_moving(setting: Setting) -> list[Line]:
    absent = [program for program in ("Xvfb", "xdotool") if not shutil.which(program)]
    if absent:
        raise Skipped(f"needs {' and '.join(absent)}: run tools/setup")
    contest = contest_of(setting, "viewer_moving")
    size, frames = f"{contest.view.width}x{contest.view.height}", 24 if setting.is_quick else 32
    draw, missing = peer_of(contest, "threepp")
    tasks = {"ours": lambda: measured([sys.executable, BENCH / "viewer.py", setting.program, setting.helmet(), "--size", size])}
    if draw:
        tasks["threepp"] = lambda: (draw(1), draw(1 + frames))
    results, failures = in_turns(tasks, min(setting.runs, 3), setting.progress.say)
    if "ours" in failures:
        raise Skipped(f"tools/bench/viewer.py: {failures['ours']}")
    said = [json.loads(cost.output) for cost in results["ours"]]
    frame, scale = spread(1e3 * each["moving_frame_median [s]"] for each in said), spread(each["moving_scale_median"] for each in said)
    beside = spread(frame_ms(results["threepp"], frames)) if "threepp" in results else None
    setting.figures["viewer_moving"] = {"runs": said, "threepp_ms": vars(beside) if beside else None}
    return [Line(f"the viewer while it orbits DamagedHelmet, {size.replace('x', '×')}", f"{frame.text(0)} ms at {scale.text()} of the sides",
                 f"threepp at full size {beside.text(0)} ms" if beside else f"threepp is missing: {missing or failures['threepp']}",
                 "33 ms at ≥ 0.6", frame.median <= 33.5 and scale.median >= 0.6)]


def first_picture(setting: Setting) -> list[Line]:
    """The last step of tools/demo: its render command, with the build done."""
    scene, output = ROOT / "assets" / "scenes" / "default.gltf", setting.scratch / "demo.png"

    def draw():
        return measured([setting.program, "render", scene, "-o", output.with_suffix(".exr"), "-o", output, "--size", "640x360", "--time", "8s",
                         "--json"], output)
    results, failures = in_turns({"ours": draw}, 1 if setting.is_quick else min(setting.runs, 3), setting.progress.say, warm=False)
    if failures:
        raise Skipped(failures["ours"])
    seconds, said = spread(cost.seconds for cost in results["ours"]), json.loads(results["ours"][-1].output)
    setting.figures["first_picture"] = {"seconds": vars(seconds), "samples": said["samples"]}
    return [Line("the picture of tools/demo after the build, 640×360, --time 8s", f"{seconds.text(1)} s", "–", "≤ 15 s", seconds.median <= 15.0, None,
                 f"{said['samples']} samples a pixel")]
