"""Rows of a model's frames and of the whole command, beside threepp and Panda3D."""
from peers import install
from peers.contest import Contest
from peers.view import View
from timing import in_turns, spread

from .row import Line, Setting, Skipped, ratio_of


def contest_of(setting: Setting, name: str) -> Contest:
    size = (640, 360) if setting.is_quick else (1280, 720)
    return Contest(View(str(setting.helmet()), "", *size), setting.program, setting.folder(name), setting.cache)


def size_text(contest: Contest) -> str:
    return f"{contest.view.width}×{contest.view.height}"


def peer_of(contest: Contest, name: str):
    """@return the function, or none and why it is missing"""
    try:
        return contest.theirs(name)[0], ""
    except install.Unavailable as why:
        return None, str(why)


def frame_ms(pairs: list, frames: int) -> list:
    return [1e3 * (many.seconds - one.seconds) / frames for one, many in pairs]


def frames_beside_threepp(setting: Setting, name: str, ways: list) -> list[Line]:
    """@param ways (what, aim of the ratio, options of ours, is the scene the file without the view's light)"""
    contest = contest_of(setting, name)
    frames = 24 if setting.is_quick else 32

    def both(draw):
        return lambda: (draw(1), draw(1 + frames))
    tasks = {what: both(contest.ours(f"ours_{i}", *options, scene=setting.helmet() if is_file else None))
             for i, (what, _, options, is_file) in enumerate(ways)}
    draw, missing = peer_of(contest, "threepp")
    if draw:
        tasks["threepp"] = both(draw)
    results, failures = in_turns(tasks, setting.runs, setting.progress.say)
    missing = missing or failures.get("threepp", "")
    times = {what: frame_ms(pairs, frames) for what, pairs in results.items()}
    setting.figures[name] = {"frame_ms": times, "frames": frames, "failures": failures}
    lines = []
    for what, aim, _, _ in ways:
        if what in failures:
            raise Skipped(f"{what}: {failures[what]}")
        ratio = ratio_of(times[what], times["threepp"]) if "threepp" in times else None
        lines.append(Line(f"DamagedHelmet {size_text(contest)}, a frame: {what}", f"{spread(times[what]).text(0)} ms",
                          f"threepp, point without shadows: {spread(times['threepp']).text(0)} ms" if ratio else f"threepp is missing: {missing}",
                          f"≤ {aim} × threepp", ratio.median <= aim if ratio else None, ratio))
    return lines


def frame_point(setting: Setting) -> list[Line]:
    return frames_beside_threepp(setting, "frame_point", [
        ("one point, no shadows", 0.8, ["--rig", "none", "--visibility", "none"], False),
        ("one point, shadows", 1.5, ["--rig", "none"], False)])


def frame_studio(setting: Setting) -> list[Line]:
    return frames_beside_threepp(setting, "frame_studio", [
        ("the studio (an environment) and the helmet's glow, shadows", 4.0, ["--rig", "studio"], True),
        ("three softboxes, shadows", 4.0, ["--rig", "softboxes"], True)])


def command_lines(setting: Setting, name: str, what: str, ours, peers: list, aim_s: tuple, aim_mib: float) -> list[Line]:
    """@param aim_s (text, function of ours [s] and of theirs by peer that says whether it is met)"""
    contest = contest_of(setting, name)
    tasks, missing = {"ours": ours(contest)}, {}
    for peer in peers:
        draw, why = peer_of(contest, peer)
        if draw:
            tasks[peer] = lambda draw=draw: draw(1)
        else:
            missing[peer] = why
    results, failures = in_turns(tasks, setting.runs, setting.progress.say)
    if "ours" in failures:
        raise Skipped(failures["ours"])
    missing.update(failures)
    times = {who: [cost.seconds for cost in costs] for who, costs in results.items()}
    memory = {who: max(cost.memory_mib for cost in costs) for who, costs in results.items()}
    setting.figures[name] = {"seconds": times, "memory_mib": memory, "failures": missing}
    what = f"DamagedHelmet {size_text(contest)}, {what}"
    first = next((peer for peer in peers if peer in times), None)
    beside = [f"{peer} {spread(times[peer]).text()} s" for peer in peers if peer in times] + [f"{peer} is missing: {why}" for peer, why in missing.items()]
    text, is_met = aim_s
    return [Line(what, f"{spread(times['ours']).text()} s", ", ".join(beside), text, is_met(times), ratio_of(times["ours"], times[first]) if first else None,
                 f"the ratio is to {first}" if first else ""),
            Line(f"{what}, memory", f"{memory['ours']:.0f} MiB", ", ".join(f"{peer} {memory[peer]:.0f} MiB" for peer in peers if peer in memory) or "–",
                 f"≤ {aim_mib} MiB", memory["ours"] <= aim_mib)]


def file_to_png(setting: Setting) -> list[Line]:
    def is_met(times):
        return ratio_of(times["ours"], times["panda3d"]).median <= 0.6 if "panda3d" in times else None

    def ours(contest):
        draw = contest.ours("ours", "--rig", "none", "--visibility", "none")
        return lambda: draw(1)
    return command_lines(setting, "file_to_png", "file to PNG, 1 sample, one point, no shadows", ours, ["panda3d", "threepp"],
                         ("≤ 0.6 × Panda3D", is_met), 300)


def defaults(setting: Setting) -> list[Line]:
    return command_lines(setting, "defaults", "the command with its defaults (16 samples, shadows, the studio)",
                         lambda contest: contest.ours_by_default("ours"), ["threepp"],
                         ("≤ 1.5 s", lambda times: spread(times["ours"]).median <= 1.5), 400)
