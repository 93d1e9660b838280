"""The error of a picture against a long one of other seeds, and the time that a given error takes."""
import json
import subprocess
from pathlib import Path

from .plot import log_share


def rel_mse(program: Path, picture: Path, reference: Path) -> float:
    """relMSE as `steradian compare` defines it. @throws RuntimeError if the two cannot be compared"""
    result = subprocess.run([str(program), "compare", str(picture), str(reference), "--json"], capture_output=True, text=True)
    if result.returncode not in (0, 1):
        raise RuntimeError((result.stderr.strip() or "steradian compare failed").splitlines()[-1])
    return json.loads(result.stdout)["metrics"]["rel_mse"]


def long_picture(judge, render, target: Path) -> float:
    """
    Writes the mean of two halves as the reference. @param judge the error of (picture, reference)
    @param render renders (picture, seed) of half its samples @return its own noise: a quarter of the error between the halves
    """
    halves = [target.with_name(f"{target.stem}.half{i}.exr") for i in (0, 1)]
    for i, half in enumerate(halves):
        render(half, 1000 + i)
    subprocess.run(["oiiotool", *map(str, halves), "--add", "--mulc", "0.5", "-d", "float", "-o", str(target)], check=True,
                   stdout=subprocess.DEVNULL)
    noise = judge(*halves) / 4.0
    for half in halves:
        half.unlink()
    return noise


def seconds_for(points: list, target: float) -> float | None:
    """By interpolation in logarithms, where a curve of points (seconds, rel_mse) passes `target`; None if it does not get there."""
    points = [point for point in points if point["rel_mse"] > 0.0 and point["seconds"] > 0.0]
    if points and points[0]["rel_mse"] <= target:
        return points[0]["seconds"]
    for a, b in zip(points, points[1:]):
        if a["rel_mse"] >= target > b["rel_mse"]:
            return a["seconds"] * (b["seconds"] / a["seconds"]) ** log_share(a["rel_mse"], b["rel_mse"], target)
    return None
