"""Draws the lobes of a Phong highlight, as a plot or in 3D.  usage: plot.py polar|surface OUT.png"""
import sys

import matplotlib

matplotlib.use("Agg")  # no display
import matplotlib.pyplot as plt
import numpy as np

kind, out = sys.argv[1], sys.argv[2]
angles = np.linspace(-np.pi / 2, np.pi / 2, 181)
if kind == "polar":
    axes = plt.figure(figsize=(3.2, 2.4), dpi=100).add_subplot(projection="polar")
    for exponent in (1, 10, 100):
        axes.plot(angles, np.cos(angles) ** exponent, label=f"n = {exponent}")
    axes.set_thetalim(-np.pi / 2, np.pi / 2)
    axes.legend(loc="lower right", fontsize=7)
else:
    axes = plt.figure(figsize=(3.2, 2.4), dpi=100).add_subplot(projection="3d")
    x, y = np.meshgrid(np.linspace(-1, 1, 41), np.linspace(-1, 1, 41))
    axes.plot_surface(x, y, np.exp(-4 * (x**2 + y**2)), cmap="viridis")
plt.savefig(out, metadata={"Software": None})
