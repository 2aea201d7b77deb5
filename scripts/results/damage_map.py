"""Damage of one layer of a lattice as an image, for the figures of cases."""

import numpy as np
from matplotlib.colors import LinearSegmentedColormap

COLOURS = LinearSegmentedColormap.from_list("damage", ["#eef2f5", "#b9cfe0", "#e8a15a", "#b3312c", "#5e0f14"])
MOST = 0.6  # of the colour bar; where a crack has branched particles lose more


def image(points, values):
    """(rows of values by y, [left, right, bottom, top] in mm) of particles that fill a rectangle in x and y; empty cells are NaN."""
    x, y = (np.round(points[:, axis], 7) for axis in (0, 1))
    spacing = np.diff(np.unique(x)).min()
    column, row = (np.round((v - v.min()) / spacing).astype(int) for v in (x, y))
    cells = np.full((row.max() + 1, column.max() + 1), np.nan)
    cells[row, column] = values
    low, high = points.min(axis=0)[:2] - spacing / 2, points.max(axis=0)[:2] + spacing / 2
    return cells, 1e3 * np.array([low[0], high[0], low[1], high[1]])


def draw(axis, points, damage):
    """Draws it, and gives what a colour bar is made from."""
    cells, extent = image(points, damage)
    return axis.imshow(cells, extent=extent, origin="lower", cmap=COLOURS, vmin=0, vmax=MOST, interpolation="none")
