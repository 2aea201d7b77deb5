"""Pictures of a ship in a sheet of ice, from the frames of a run with the body `sheet` and the impactor `ship`."""

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.colors import LinearSegmentedColormap
from render import Scene
from vtp_reader import picture_at

COLOURS = LinearSegmentedColormap.from_list("damage", ["#e6eff6", "#a9c9e0", "#e8a15a", "#b3312c", "#5e0f14"])
HULL, WATER = (0.66, 0.33, 0.30), "#20506e"


def spacing_of(sheet):
    heights = np.unique(np.round(sheet.points[:, 2] - sheet.point["displacement"][:, 2], 4))
    return np.diff(heights).min()


def corners_of(ship):
    return np.asarray(ship.points, float)[np.array([panel[:3] for panel in ship.panels])]


def near(corners, sheet):
    """Triangles of the hull near the sheet and a little behind it."""
    return corners[corners[:, :, 0].min(axis=1) < sheet.points[:, 0].max() + 25]


def is_long(sheet):
    return np.ptp(sheet.points[:, 0]) > 2 * np.ptp(sheet.points[:, 1])


def scene_of(sheet, fold):
    """View from ahead and above, with space for the sheet and the bow above it; more from the side for a long sheet."""
    reference = sheet.points - sheet.point["displacement"]
    low, high = reference.min(axis=0), reference.max(axis=0) + [8, 0, 5]
    direction, width = ((-0.35, -0.8, 0.6), 1100) if is_long(sheet) else ((-0.75, -0.62, 0.62), 620)
    axes = Scene(direction, (0, 0, 1), 1, 1, 1, (0, 0, 0)).axes
    corners = np.array(np.meshgrid(*zip(low, high))).reshape(3, -1).T @ axes[:2].T
    size = np.ptp(corners, axis=0)
    pixels = width / size[0]
    centre = (corners.min(axis=0) + size / 2) @ axes[:2]
    return Scene(direction, (0, 0, 1), pixels * fold, width * fold, int(pixels * size[1]) * fold, centre)


def scene_picture(sheet, ship, spacing, fold=2):
    """Ice and hull."""
    scene = scene_of(sheet, fold)
    scene.add_shells(near(corners_of(ship), sheet), HULL)
    scene.add_balls(sheet.points, 0.56 * spacing, COLOURS(np.clip(sheet.point["damage"] / 0.9, 0, 1))[:, :3])
    return scene.picture(fold)


def draw_scenes(folder, times, file):
    shots = []
    for time in times:
        at, sheet = picture_at(folder, "sheet", time)
        _, ship = picture_at(folder, "ship", time)
        shots.append((at, scene_picture(sheet, ship, spacing_of(sheet))))
    columns = 1 if is_long(sheet) else 2
    rows = len(shots) // columns
    tall, wide = shots[0][1].shape[:2]
    figure, axes = plt.subplots(rows, columns, figsize=(11, rows * (11 / columns * tall / wide + 0.3)))
    for axis, (at, picture) in zip(axes.flat, shots):
        axis.imshow(picture, interpolation="none")
        axis.set_facecolor(WATER)
        axis.set_xticks([]), axis.set_yticks([])
        axis.set_title(f"{at:.1f} s", fontsize=13)
    figure.tight_layout()
    figure.savefig(file, dpi=95)


def draw_damage(folder, times, file):
    """Damage of the top layer in the reference configuration; frames of a wide sheet side by side."""
    shots = [picture_at(folder, "sheet", time) for time in times]
    long, wide = (np.ptp(shots[0][1].points[:, axis]) for axis in (0, 1))
    is_wide = wide > long
    rows, columns = (1, len(shots)) if is_wide else (len(shots), 1)
    size = (11, 0.9 + 10 / columns * wide / long) if is_wide else (9, 0.6 + rows * (0.45 + 7 * wide / long))
    begins = [(sheet.points[:, 0] - sheet.point["displacement"][:, 0]).min() for _, sheet in shots]
    figure, axes = plt.subplots(rows, columns, figsize=size, sharex=bool(np.ptp(begins) < 1e-3), sharey=True)  # windows that move have axes of their own
    for axis, (at, sheet) in zip(axes, shots):
        reference = sheet.points - sheet.point["displacement"]
        spacing = spacing_of(sheet)
        top = reference[:, 2] > reference[:, 2].max() - 0.5 * spacing
        column, row = (np.round(reference[top, k] / spacing - 0.5).astype(int) for k in (0, 1))
        cells = np.full((np.ptp(row) + 1, np.ptp(column) + 1), np.nan)
        cells[row - row.min(), column - column.min()] = sheet.point["damage"][top]
        low, high = reference[top].min(axis=0) - 0.5 * spacing, reference[top].max(axis=0) + 0.5 * spacing
        image = axis.imshow(cells, extent=(low[0], high[0], low[1], high[1]), origin="lower", cmap=COLOURS, vmin=0, vmax=0.9, interpolation="none")
        axis.set_title(f"{at:.1f} s", fontsize=11, loc="left")
        if not is_wide or axis is axes[0]:
            axis.set_ylabel("y [m]")
    axes[-1].set_xlabel("x [m]" if is_wide else "x [m]; the ship comes from the right")
    figure.colorbar(image, ax=axes, label="damage", shrink=0.6)
    figure.savefig(file, dpi=95, bbox_inches="tight")
