#!/usr/bin/python3
"""Draws the figures of the tutorials from the results of their runs: figures.py RESULTS

RESULTS holds 1_plate, 2_your_part and 3_ice_and_hull, as the pages' commands leave them. Needs numpy and matplotlib.
"""

import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[2] / "scripts/results"))
from csv_reader import history  # noqa: E402
from vtp_reader import read_vtp  # noqa: E402

LINE = "#d1495b"


def draw_curve(axes, results, name, per, unit, label):
    """Rows are means since the previous row, so they are drawn as steps."""
    columns = history(results)
    time = columns["time [s]"]
    axes.stairs(columns[name][1:] / unit, time / per[0], color=LINE, baseline=None, lw=1.4)
    axes.set(xlabel=f"time [{per[1]}]", ylabel=label, xlim=(0, time[-1] / per[0]))
    axes.spines[["top", "right"]].set_visible(False)


def draw_particles(axes, points, values, size, colours, largest, labels):
    dots = axes.scatter(*points.T, c=values, s=size, cmap=colours, vmin=0, vmax=largest, linewidths=0, marker="s")
    axes.set(aspect="equal", xlabel=labels[0], ylabel=labels[1])
    return dots


def plate(results):
    figure, (left, right) = plt.subplots(1, 2, figsize=(11, 3.6), width_ratios=(1.15, 1), layout="constrained")
    frame = read_vtp(results / "frames/plate_00006.vtp")
    speed = np.linalg.norm(frame.point["velocity"], axis=1)
    near = np.argsort(frame.points[:, 2], kind="stable")  # the nearest layer is drawn last
    dots = draw_particles(left, 1e3 * frame.points[near, :2], speed[near], 13, "viridis", 40, ("x [mm]", "y [mm]"))
    figure.colorbar(dots, ax=left, label="speed [m/s]", shrink=0.75)
    left.set_title(f"{1e6 * frame.time:.0f} µs", loc="left", fontsize=10)
    draw_curve(right, results, "cylinder.force_y [N]", (1e-6, "µs"), 1e3, "force on the cylinder [kN]")
    figure.savefig(HERE / "1_plate.png", dpi=90)


def part(results):
    figure, (left, right) = plt.subplots(1, 2, figsize=(11, 3.2), width_ratios=(1.3, 1), layout="constrained")
    frame = read_vtp(results / "frames/tile_00020.vtp")
    first = read_vtp(results / "frames/tile_00000.vtp").points
    middle = np.abs(first[:, 0]) < 1e-3  # the two layers at x = 0
    dots = draw_particles(left, 1e3 * frame.points[middle][:, 1:], frame.point["damage"][middle], 16, "magma_r", 1, ("y [mm]", "z [mm]"))
    figure.colorbar(dots, ax=left, label="damage", shrink=0.8)
    pin = read_vtp(results / "frames/pin_00020.vtp").points
    silhouette = pin[np.abs(pin[:, 0]) < 0.6e-3]
    left.scatter(1e3 * silhouette[:, 1], 1e3 * silhouette[:, 2], s=3, color="#6b7780")
    left.set(xlim=(-25, 25), ylim=(-16, 12), title=f"section x = 0 at {1e6 * frame.time:.0f} µs")
    draw_curve(right, results, "pin.force_z [N]", (1e-6, "µs"), 1e3, "force on the pin [kN]")
    figure.savefig(HERE / "2_your_part.png", dpi=90)


def ice(results):
    figure, axes = plt.subplots(1, 4, figsize=(13, 3.3), width_ratios=(1, 1, 1, 1.25), layout="constrained")
    first = read_vtp(results / "frames/sheet_00000.vtp").points
    top = first[:, 2] > first[:, 2].max() - 0.1
    for one, number in zip(axes, (5, 10, 20)):
        frame = read_vtp(results / f"frames/sheet_{number:05d}.vtp")
        dots = draw_particles(one, frame.points[top, :2], frame.point["damage"][top], 6, "magma_r", 1, ("x [m]", "y [m]" if number == 5 else ""))
        ship = read_vtp(results / f"frames/ship_{number:05d}.vtp").points
        line = ship[np.abs(ship[:, 2]) < 0.12]  # near the waterline
        one.scatter(line[:, 0], line[:, 1], s=3, color="#2f7f9c")
        one.set(xlim=(-18.5, 3), ylim=(-9.5, 9.5), title=f"{frame.time:.2f} s")
    figure.colorbar(dots, ax=axes[2], label="damage of the upper layer", shrink=0.8)
    draw_curve(axes[3], results, "ship.force_x [N]", (1, "s"), 1e6, "resistance [MN]")
    figure.savefig(HERE / "3_ice_and_hull.png", dpi=90)


def main():
    results = Path(sys.argv[1])
    plate(results / "1_plate")
    part(results / "2_your_part")
    ice(results / "3_ice_and_hull")


main()
