#!/usr/bin/python3
"""Draws the figures of README.md: figures.py [RESULTS] [--of DECK] [--check FOLDER]

RESULTS: folder of a finished run (default: results/ship_ice). --of: its deck, deck (default), paper, at the paper's four instants, wide or six_layers.
--check: folder with the surfaces and contact bounds written by `perimpact check`; then only the bow and its contact bounds are drawn.
"""

import argparse
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402
from matplotlib.colors import LinearSegmentedColormap  # noqa: E402
from measure import history, window_means  # noqa: E402

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE / "../../scripts/pictures"))
from render import Scene  # noqa: E402
from vtp_reader import picture_at, read_vtp, series  # noqa: E402

COLOURS = LinearSegmentedColormap.from_list("damage", ["#e6eff6", "#a9c9e0", "#e8a15a", "#b3312c", "#5e0f14"])
HULL, WATER = (0.66, 0.33, 0.30), "#20506e"
PAPER_TIMES = 18.8, 37.6, 56.4, 75.2  # [s] of figure 19


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
    figure, axes = plt.subplots(rows, columns, figsize=size, sharex=True, sharey=True)
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


def draw_forces(folder, file):
    rows = history(folder)
    time = rows["time [s]"]
    figure, axes = plt.subplots(2, 1, figsize=(10, 6.4), sharex=True)
    for axis, name, words in zip(axes, "xz", ("F_x, resistance", "F_z, upwards")):
        force = rows[f"ship.force_{name} [N]"] / 1e6
        axis.fill_between(time, force, color="#a9c9e0", step="pre", label=f"rows of history.csv, {time[2] - time[1]:.3g} s")
        smooth = window_means(time, force, 1.0)
        axis.plot(time[: len(smooth)] + 0.5, smooth, color="#b3312c", linewidth=1.6, label="mean over 1 s")
        axis.axhline(force[time > 4].mean(), color="#20506e", linestyle="--", linewidth=1, label="mean from 4 s on")
        axis.set_ylabel(f"{words} [MN]")
        axis.set_ylim(0, 1.6 * np.percentile(force, 99))
    axes[0].legend(fontsize=9)
    axes[1].set_xlabel("time [s]")
    figure.tight_layout()
    figure.savefig(file, dpi=95)


def draw_bow(folder, file):
    """The bow's panels, and the boxes of its contact bounds, from the side and from above."""
    corners = corners_of(read_vtp(folder / "ship_surface.vtp"))
    region = read_vtp(folder / "ship_contact_bounds.vtp")
    figure, axes = plt.subplots(2, 1, figsize=(11, 3.9), gridspec_kw={"height_ratios": (0.65, 1)})
    for axis, up, word in zip(axes, (2, 1), ("z [m]", "y [m]")):
        seen = corners[:, :, 2].max(axis=1) <= 0.5 if up == 1 else corners[:, :, 1].mean(axis=1) <= 0  # from above the submerged part, from the side port
        outline = np.concatenate([corners[seen], corners[seen][:, :1]], axis=1)
        axis.plot(*np.concatenate([np.swapaxes(outline[:, :, [0, up]], 1, 2), np.full((seen.sum(), 2, 1), np.nan)], axis=2).transpose(1, 0, 2).reshape(2, -1),
                  color="#5a6b78", linewidth=0.35)
        for panel in region.panels:
            side = np.asarray(region.points, float)[np.append(panel, panel[0])]
            axis.plot(side[:, 0], side[:, up], color="#b3312c", linewidth=0.8)
        axis.set_aspect("equal"), axis.set_ylabel(word)
    axes[-1].set_xlabel("x [m]")
    figure.tight_layout()
    figure.savefig(file, dpi=95)


def main():
    arguments = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    arguments.add_argument("results", type=Path, nargs="?", default=Path("results/ship_ice"))
    arguments.add_argument("--of", choices=("deck", "paper", "wide", "six_layers"), default="deck")
    arguments.add_argument("--check", type=Path)
    given = arguments.parse_args()
    figures = HERE / "figures"
    figures.mkdir(exist_ok=True)
    if given.check:
        draw_bow(given.check, figures / "bow.png")
        return
    end = series(given.results, "sheet")[-1][0]
    times = PAPER_TIMES if given.of == "paper" else [share * end for share in (0.1, 0.4, 0.7, 1)]
    prefix = "" if given.of == "deck" else f"{given.of}_"
    draw_scenes(given.results, times, figures / f"{prefix}scenes.png")
    draw_damage(given.results, times, figures / f"{prefix}damage.png")
    draw_forces(given.results, figures / f"{prefix}forces.png")


if __name__ == "__main__":
    main()
