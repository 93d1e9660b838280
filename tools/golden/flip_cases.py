#!/usr/bin/env python3
"""Makes the stored cases that our FLIP and SSIM are tested against.

    python3 -m venv venv && venv/bin/pip install flip-evaluator==1.7 scikit-image==0.26.0
    venv/bin/python tools/golden/flip_cases.py > tests/unit/compare/data/appearance.json

Development only: the test reads the stored file and needs neither package. Images are small, and their values
have few digits, so that the file can be read by people too. FLIP is BSD-3-Clause, scikit-image too; only their
results are stored.
"""
import json
import sys
from importlib.metadata import version

import flip_evaluator
import numpy as np
from skimage.metrics import structural_similarity

WIDTH, HEIGHT = 24, 18


def scene(rng):
    """A gradient, two coloured blocks, an edge and some texture, 0..1."""
    x, y = np.meshgrid(np.linspace(0, 1, WIDTH), np.linspace(0, 1, HEIGHT))
    image = np.stack([x, y, 0.5 + 0.4 * np.sin(9 * x * y)], axis=-1) * 0.7
    image[3:9, 4:11] = (0.9, 0.2, 0.1)
    image[8:15, 12:20] = (0.1, 0.3, 0.8)
    return np.clip(image + 0.06 * rng.standard_normal(image.shape), 0, 1)


def ldr_pairs(rng):
    reference = np.round(255 * scene(rng)).astype(int)
    noise = np.clip(reference + np.round(30 * rng.standard_normal(reference.shape)), 0, 255).astype(int)
    return {
        "noise": (noise, reference, 67.02),
        "shift": (np.roll(reference, 1, axis=1), reference, 67.02),
        "darker": ((reference * 6) // 10, reference, 67.02),
        "swapped_channels_from_afar": (reference[..., ::-1], reference, 30.0),
        "black_and_white": (np.zeros_like(reference), np.full_like(reference, 255), 67.02),
    }


def hdr_pairs(rng):
    light = lambda image: np.round(np.float32(image), 4)
    reference = light(np.exp(5 * scene(rng)) / 20)
    lamp = reference.copy()
    lamp[2:5, 15:20] = 400.0
    half_black = reference.copy()
    half_black[:, : WIDTH // 2] = 0.0
    return {
        "factor": (light(reference * 1.5), reference, (-2.0, 3.0, 4)),
        "lamp_missing": (reference, lamp, (-9.0, 2.0, 6)),
        "half_black": (light(np.roll(half_black, 1, axis=0)), half_black, (-1.0, 4.5, 3)),
        "offset": (light(reference + 0.05), reference, (0.5, 2.0, 2)),
    }


def numbers(array, digits):
    return [round(float(value), digits) for value in np.asarray(array).ravel()]


def luma(codes):
    return (codes / 255.0) @ np.array([0.2126, 0.7152, 0.0722])


def main():
    rng = np.random.default_rng(20)
    cases = []
    for name, (test, reference, ppd) in ldr_pairs(rng).items():
        t, r = np.float32(test / 255.0), np.float32(reference / 255.0)
        flip_map, mean, _ = flip_evaluator.evaluate(r, t, "LDR", applyMagma=False, parameters={"ppd": ppd})
        ssim = structural_similarity(luma(test), luma(reference), data_range=1.0, gaussian_weights=True, sigma=1.5,
                                     use_sample_covariance=False)
        cases.append({"name": name, "ppd": ppd, "codes": True, "test": test.ravel().tolist(),
                      "reference": reference.ravel().tolist(), "flip": numbers(flip_map, 5), "mean": round(float(mean), 6),
                      "ssim": round(float(ssim), 6)})
    for name, (test, reference, (start, stop, count)) in hdr_pairs(rng).items():
        parameters = {"ppd": 67.02, "startExposure": start, "stopExposure": stop, "numExposures": count,
                      "tonemapper": "aces"}
        flip_map, mean, _ = flip_evaluator.evaluate(reference, test, "HDR", applyMagma=False, parameters=parameters)
        cases.append({"name": name, "ppd": 67.02, "codes": False, "start": start, "stop": stop, "count": count,
                      "test": numbers(test, 4), "reference": numbers(reference, 4), "flip": numbers(flip_map, 5),
                      "mean": round(float(mean), 6)})
    json.dump({"made_by": "tools/golden/flip_cases.py", "flip-evaluator": version("flip-evaluator"),
               "scikit-image": version("scikit-image"), "width": WIDTH, "height": HEIGHT, "cases": cases},
              sys.stdout, separators=(",", ":"))
    print()


if __name__ == "__main__":
    main()
