"""Rows of the time to a given error and of samples a second, beside Mitsuba's integrator `direct`."""
import hashlib
import json
from pathlib import Path

from curves import error, softbox
from peers import install
from timing import Failed, in_turns, measured, spread

from .row import Line, Setting, Skipped, ratio_of

ROOT = Path(__file__).resolve().parents[3]
TARGET = 1e-3            # relMSE
TARGET_OF_HELMET = 4e-3  # of 99.9 % of the pixels: to 1e-3 Mitsuba would take minutes
ERRORS = [20, 14, 10, 7, 5, 3.5, 2.5, 1.8, 1.2]  # of --error [percent]
MOST = {"ours": 2048, "Mitsuba": 16384}          # samples a pixel of the search
MOST_S = {False: 30.0, True: 10.0}               # a search ends at a render that takes longer, by --quick
LONG = {"ours": 2048, "Mitsuba": 4096}           # samples a pixel of the long picture


class NotReached(Failed):
    """A search that ended above the target. `count` is the largest that misses it by more than the long picture's noise, or none."""

    def __init__(self, side: str, point: dict, clear: dict | None):
        super().__init__(f"{side} has relMSE {point['rel_mse']:.1e} at {point['count']} after {point['seconds']:.1f} s")
        self.count = clear and clear["count"]
        self.seconds = []  # of that count, in the turns


class Side:
    """One renderer on one scene: renders, and knows its own long picture."""

    def __init__(self, setting: Setting, name: str, command, environment: dict, key: bytes, judge):
        """
        @param command returns the command of (samples, seed, picture) @param key of what the long picture depends on
        @param judge the error of (picture, reference)
        """
        self.setting, self.name, self.command, self.environment, self.key, self.judge = setting, name, command, environment, key, judge
        self.picture = setting.scratch / f"{name.replace(' ', '_')}.exr"
        self.reference, self.noise, self.errors = None, None, {}

    def render(self, samples, seed=0, picture=None) -> float:
        picture = picture or self.picture
        return measured(self.command(samples, seed, picture), picture, self.environment).seconds

    def make_reference(self, samples: int):
        """Renders the long picture, or finds it in the cache."""
        name = hashlib.sha256(self.key + str(samples).encode()).hexdigest()[:16]
        self.reference = self.setting.cache / "references" / f"{name}.exr"
        noise = self.reference.with_suffix(".json")
        if self.setting.is_fresh or not (self.reference.exists() and noise.exists()):
            self.reference.parent.mkdir(parents=True, exist_ok=True)
            self.setting.progress.say(f"{self.name}: long picture of {samples} samples a pixel")
            value = error.long_picture(self.judge, lambda picture, seed: self.render(samples // 2, seed, picture), self.reference)
            noise.write_text(json.dumps({"rel_mse": value}))
        self.noise = json.loads(noise.read_text())["rel_mse"]

    def point(self, count) -> dict:
        """One point of the curve. The error of a count is the same each time."""
        seconds = self.render(count)
        if count not in self.errors:
            self.errors[count] = self.judge(self.picture, self.reference)
        self.setting.progress.say(f"{self.name}: {count}: {seconds:.2f} s, relMSE {self.errors[count]:.2e}")
        return {"count": count, "seconds": seconds, "rel_mse": self.errors[count]}

    def bracket(self, counts: list, target: float) -> list:
        """The first count that reaches the target, and the one before it. @throws NotReached if none does in time"""
        before, clear = [], None
        for count in counts:
            point = self.point(count)
            clear = point if point["rel_mse"] > target + self.noise else clear
            if point["rel_mse"] <= target:
                return [*before, count]
            if point["seconds"] > MOST_S[self.setting.is_quick]:
                break
            before = [count]
        raise NotReached(self.name, point, clear)

    def seconds_to(self, bracket: list, target: float) -> float:
        seconds = error.seconds_for([self.point(count) for count in bracket], target)
        if seconds is None:
            raise Failed(f"{self.name}: the times of {bracket} do not bracket the target")
        return seconds


def doubling(first: int, last: int) -> list:
    counts = [first]
    while counts[-1] < last:
        counts.append(2 * counts[-1])
    return counts


def size_of(setting: Setting) -> str:
    return "240x135" if setting.is_quick else "480x270"


def judge_of(setting: Setting, python: Path, is_trimmed: bool):
    """relMSE of (picture, reference), or that of 99.9 % of the pixels."""
    if is_trimmed:
        return lambda *pictures: float(measured([python, Path(__file__).with_name("trimmed.py"), *pictures]).output)
    return lambda *pictures: error.rel_mse(setting.program, *pictures)


def sides_of(setting: Setting, scene: Path, options: list, is_trimmed: bool = False) -> dict:
    """@param options of render and export, e.g. the camera @throws Skipped if Mitsuba cannot be had, or not with LLVM"""
    size = size_of(setting)
    key = b"\0".join([scene.read_bytes(), size.encode(), repr((options, is_trimmed)).encode()])

    def ours(samples, seed, picture):
        return [setting.program, "render", scene, "-o", picture, "--size", size, *options, "--samples", samples, "--seed", seed]

    def by_error(percent, seed, picture):
        return [setting.program, "render", scene, "-o", picture, "--size", size, *options, "--error", f"{percent}%", "--seed", seed]
    try:
        mitsuba = install.installed("mitsuba", setting.cache)
    except install.Unavailable as why:
        raise Skipped(f"Mitsuba is missing: {why}") from None
    if mitsuba.environment["STERADIAN_VARIANT"] != "llvm_ad_rgb":  # the aims are for that variant; another takes many times as long
        raise Skipped(f"Mitsuba would be {mitsuba.remark}")
    judge = judge_of(setting, mitsuba.python, is_trimmed)
    folder = setting.folder(f"mitsuba_{scene.stem}")
    measured([setting.program, "export", scene, "--to", "mitsuba", folder, "--size", size, *options])

    def theirs(samples, seed, picture):
        return [mitsuba.python, folder / "render.py", "-o", picture, "--spp", samples, "--seed", seed, "--variant",
                mitsuba.environment["STERADIAN_VARIANT"]]
    return {"--samples": Side(setting, "ours --samples", ours, {}, b"ours" + key, judge),
            "--error": Side(setting, "ours --error", by_error, {}, b"ours" + key, judge),
            "Mitsuba": Side(setting, "Mitsuba", theirs, mitsuba.environment, b"mitsuba" + install.PIP["mitsuba"][0][0].encode() + key, judge)}


def searched(sides: dict, counts: dict, target: float):
    """@return brackets of those that reach the target; why others do not"""
    brackets, missing = {}, {}
    for way, side in sides.items():
        try:
            brackets[way] = side.bracket(counts[way], target)
        except NotReached as why:
            missing[way] = why
    return brackets, missing


def error_line(what: str, ours: list, theirs: list | Failed, aim: float, remark: str) -> Line:
    """@param theirs why Mitsuba has no time, if it has none; a search that ended early bounds the ratio from above"""
    text, aim_text = f"{spread(ours).text()} s", f"≤ {aim} × Mitsuba"
    if isinstance(theirs, list):
        ratio = ratio_of(ours, theirs)
        return Line(what, text, f"Mitsuba {spread(theirs).text()} s", aim_text, ratio.median <= aim, ratio, remark)
    if isinstance(theirs, NotReached) and theirs.seconds:
        bound = ratio_of(ours, theirs.seconds)
        return Line(what, text, f"{theirs}; {theirs.count} samples, {spread(theirs.seconds).text()} s, are too few", aim_text,
                    True if bound.median <= aim else None, None, f"the ratio is below {bound.text()}; {remark}")
    return Line(what, text, str(theirs), aim_text, None, None, remark)


def error_row(setting: Setting, name: str, title: str, scene: Path, options: list, aim: float, target: float = TARGET, is_trimmed: bool = False) -> list[Line]:
    sides = sides_of(setting, scene, options, is_trimmed)
    shorter = 8 if setting.is_quick else 1
    target *= 4 if setting.is_quick else 1
    sides["--samples"].make_reference(LONG["ours"] // shorter)
    sides["Mitsuba"].make_reference(LONG["Mitsuba"] // shorter)
    sides["--error"].reference, sides["--error"].noise = sides["--samples"].reference, sides["--samples"].noise
    brackets, missing = searched(sides, {"--samples": doubling(4, MOST["ours"]), "--error": ERRORS, "Mitsuba": doubling(8, MOST["Mitsuba"])}, target)
    tasks = {way: lambda way=way: sides[way].seconds_to(brackets[way], target) for way in brackets}
    bound = missing.get("Mitsuba")
    if bound and bound.count:
        tasks["bound"] = lambda: sides["Mitsuba"].render(bound.count)
    results, failures = in_turns(tasks, setting.runs, warm=False)
    if bound:
        bound.seconds = results.pop("bound", [])
    missing.update({way: Failed(why) for way, why in failures.items()})
    setting.figures[name] = {"seconds": results, "brackets": brackets, "rel_mse": {way: side.errors for way, side in sides.items()},
                             "noise": {way: side.noise for way, side in sides.items()}, "failures": {way: str(why) for way, why in missing.items()}}
    remark = f"noise of the long pictures {sides['--samples'].noise:.0e} and {sides['Mitsuba'].noise:.0e}"
    lines = []
    for way in ("--samples", "--error"):
        what = f"{title}, {size_of(setting).replace('x', '×')}, relMSE {target:g}{' of 99.9 % of the pixels' * is_trimmed} by {way}"
        if way in results:
            lines.append(error_line(what, results[way], results.get("Mitsuba") or missing["Mitsuba"], aim, remark))
        else:
            lines.append(Line(what, f"not reached: {missing[way]}", "–", f"≤ {aim} × Mitsuba", None, None, remark))
    return lines


def error_cornell(setting: Setting) -> list[Line]:
    return error_row(setting, "error_cornell", "Cornell box", ROOT / "assets" / "scenes" / "cornell.gltf", [], 0.25)


def error_veach(setting: Setting) -> list[Line]:
    return error_row(setting, "error_veach", "Veach's plates", ROOT / "assets" / "scenes" / "veach.gltf", [], 0.35)


def error_helmet(setting: Setting) -> list[Line]:
    # Trimmed: near-mirrors light a few pixels so rarely that one of them can be 99 % of the plain relMSE of 64 samples.
    scene = softbox.lit(setting.helmet(), setting.scratch / "helmet_softbox.glb")
    return error_row(setting, "error_helmet", "DamagedHelmet, one softbox", scene, ["--rig", "none"], 0.35, TARGET_OF_HELMET, is_trimmed=True)


def samples_per_second(setting: Setting) -> list[Line]:
    sides = sides_of(setting, ROOT / "assets" / "scenes" / "cornell.gltf", [])
    sides.pop("--error")
    width, height = map(int, size_of(setting).split("x"))
    counts = {"--samples": (8, 136), "Mitsuba": (64, 576)} if setting.is_quick else {"--samples": (16, 272), "Mitsuba": (64, 1088)}

    def rate(way):
        few, many = counts[way]
        begin, end = (sides[way].render(count) for count in (few, many))
        if end <= begin:
            raise Failed(f"{many} samples took no longer than {few}: the machine is too busy")
        return 1e-6 * (many - few) * width * height / (end - begin)
    results, failures = in_turns({way: lambda way=way: rate(way) for way in sides}, setting.runs, setting.progress.say)
    setting.figures["samples_per_second"] = {"million_per_second": results, "counts": counts, "failures": failures}
    if failures:
        raise Skipped("; ".join(f"{way}: {why}" for way, why in failures.items()))
    ratio = ratio_of(results["--samples"], results["Mitsuba"])
    return [Line(f"Cornell box, {width}×{height}, samples a second, without the start", f"{spread(results['--samples']).text(1)} M",
                 f"Mitsuba {spread(results['Mitsuba']).text(1)} M", "≥ 1 × Mitsuba", ratio.median >= 1.0, ratio)]
