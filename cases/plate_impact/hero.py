"""The picture of this case: the struck plate, its particles coloured by how far they moved, at four instants."""

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.colors import LinearSegmentedColormap, Normalize
from render import Scene

INSTANTS = 50e-6, 100e-6, 150e-6, 200e-6  # [s]
COLOURS = LinearSegmentedColormap.from_list("struck", ["#e9eef2", "#b7d3e0", "#6fb0c4", "#2f87a5", "#1d5d86", "#2b2f6b", "#581845", "#b3294e", "#f26b4e"])


def draw_hero(runs, path):
    """The struck plate at four instants, coloured by displacement."""
    run = min(runs, key=lambda run: abs((run.panel or 1e9) - 1))  # panels of about 1 mm show best
    frames = [(run.frame("plate", time), run.frame("cylinder", time)) for time in INSTANTS]
    farthest = max(np.linalg.norm(plate.point["displacement"], axis=1).max() for plate, _ in frames)
    scale = Normalize(0, 1e3 * farthest)
    figure, axes = plt.subplots(2, 2, figsize=(10, 7.4))
    for axis, time, (plate, cylinder) in zip(axes.flat, INSTANTS, frames):
        axis.imshow(picture(plate, cylinder, scale))
        axis.text(0.04, 0.93, f"{1e6 * time:.0f} µs", transform=axis.transAxes, fontsize=14, weight="bold")
        axis.axis("off")
    bar = figure.colorbar(plt.cm.ScalarMappable(scale, COLOURS), ax=axes, orientation="horizontal", shrink=0.42, aspect=45, pad=0.01)
    bar.set_label("displacement [mm]", fontsize=11)
    bar.outline.set_visible(False)
    figure.savefig(path, dpi=160)


def picture(plate, cylinder, scale, fold=2):
    """One instant, seen from above the struck edge."""
    scene = Scene(direction=(-0.42, -0.95, 1.15), up=(0, 0.55, 1), pixels_per_metre=3600 * fold, width=800 * fold, height=560 * fold, centre=(0, 0.016, 0))
    moved = 1e3 * np.linalg.norm(plate.point["displacement"], axis=1)
    spacing = np.cbrt(np.prod(np.ptp(plate.points, axis=0)) / len(plate.points))
    scene.add_panels(cylinder.points, cylinder.panels, colour=(0.80, 0.82, 0.85), edge_colour=(0.52, 0.55, 0.60), edge_width=0)
    scene.add_balls(plate.points, 0.56 * spacing, COLOURS(scale(moved))[:, :3])
    return scene.picture(fold)
