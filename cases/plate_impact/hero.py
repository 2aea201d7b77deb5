"""The title figure of this case: the plate after impact, particles coloured by speed, as waves cross it."""

import sys
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.colors import LinearSegmentedColormap, Normalize

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "scripts/results"))
from render import Scene  # noqa: E402

INSTANTS = 10e-6, 20e-6, 30e-6, 60e-6  # [s]: the wave spreads, reaches the far edge, is reflected, and the plate begins to fly off
FASTEST = 32.0  # [m/s] of the colour bar: the initial speed of the cylinder
COLOURS = LinearSegmentedColormap.from_list("struck", ["#262f47", "#3f3570", "#83307c", "#c93f68", "#f37651", "#fdbb6c", "#fff3c9"])


def draw_hero(runs, path):
    """The plate at four instants after impact, coloured by particle speed."""
    run = max(runs, key=lambda run: run.panel or 0)  # large panels are visible
    scale = Normalize(0, FASTEST)
    figure, axes = plt.subplots(2, 2, figsize=(11, 7.6))
    for axis, time in zip(axes.flat, INSTANTS):
        axis.imshow(picture(run.frame("plate", time), run.frame("cylinder", time), scale), interpolation="none")
        axis.text(0.03, 0.88, f"{1e6 * time:.0f} µs", transform=axis.transAxes, fontsize=13)
        axis.axis("off")
    bar = figure.colorbar(plt.cm.ScalarMappable(scale, COLOURS), ax=axes, orientation="horizontal", shrink=0.4, aspect=50, pad=0.015)
    bar.set_label("speed of the particles [m/s]", fontsize=10)
    bar.outline.set_visible(False)
    figure.savefig(path, dpi=132)  # a pixel of the images is one of the file, which avoids moiré


def picture(plate, cylinder, scale, fold=4):
    """One instant, seen from above the free edge."""
    scene = Scene(direction=(-0.16, -0.8, 1.15), up=(0, 0, 1), pixels_per_metre=3050 * fold, width=706 * fold, height=470 * fold, centre=(0.001, 0.017, 0))
    speed = np.linalg.norm(plate.point["velocity"], axis=1)
    spacing = np.cbrt(np.prod(np.ptp(plate.points, axis=0)) / len(plate.points))
    scene.add_panels(cylinder.points, cylinder.panels, colour=(0.83, 0.85, 0.88), edge_colour=(0.60, 0.63, 0.68), edge_width=1.2e-4)
    scene.add_balls(plate.points, 0.58 * spacing, COLOURS(scale(speed))[:, :3])
    return scene.picture(fold)
