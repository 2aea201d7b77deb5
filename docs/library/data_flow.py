#!/usr/bin/env python3
"""Draws the data flow of a step with a structure that deforms: data_flow.py writes data_flow.png beside this script."""

from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
from pictures import INK, PALE  # noqa: E402

COLUMNS = {"points": (0.0, "particle code\n(PD, SPH, DEM)", "#dbe9f4"), "contact": (4.2, "fccda", "#fbe5d0"), "structure": (8.4, "structure\n(FEM, modes)", "#dcefdc")}
WIDTH, HEIGHT = 3.1, 0.82


def box(axes, column, row, text):
    x, _, colour = COLUMNS[column]
    axes.add_patch(plt.Rectangle((x, -row - HEIGHT / 2), WIDTH, HEIGHT, facecolor=colour, edgecolor=PALE, linewidth=0.8))
    axes.text(x + WIDTH / 2, -row, text, ha="center", va="center", fontsize=8, color=INK)


def arrow(axes, start, end, bend=0.0):
    axes.annotate("", end, start, arrowprops={"arrowstyle": "-|>", "color": INK, "linewidth": 0.9, "connectionstyle": f"arc3,rad={bend}", "shrinkA": 0, "shrinkB": 0})


def main():
    figure, axes = plt.subplots(figsize=(8.6, 5.4), layout="constrained")
    for x, title, _ in COLUMNS.values():
        axes.text(x + WIDTH / 2, 0.95, title, ha="center", va="center", fontsize=9, fontweight="bold", color=INK)
    box(axes, "points", 0, "forces at t0,\nv and x(t1) without contact")
    box(axes, "structure", 0, "forces at t0,\nvertices at t1 without contact")
    box(axes, "contact", 1.2, "move: surface and trees\nat both ends of the step")
    box(axes, "contact", 2.4, "detect: contact along\nthe whole relative path")
    box(axes, "contact", 3.6, "respond: relocation, friction,\nimpulses on both sides")
    box(axes, "points", 4.8, "x(t1), v with contact")
    box(axes, "structure", 4.8, "velocities, vertices at t1\nwith contact")

    def left(column):
        return COLUMNS[column][0]

    def right(column):
        return COLUMNS[column][0] + WIDTH

    middle = left("contact") + WIDTH / 2
    arrow(axes, (left("structure"), -0.1), (right("contact"), -1.1))
    arrow(axes, (right("points"), -0.1), (left("contact"), -2.3))
    arrow(axes, (middle, -1.2 - HEIGHT / 2), (middle, -2.4 + HEIGHT / 2))
    arrow(axes, (middle, -2.4 - HEIGHT / 2), (middle, -3.6 + HEIGHT / 2))
    arrow(axes, (left("contact"), -3.7), (right("points"), -4.7))
    arrow(axes, (right("contact"), -3.7), (left("structure"), -4.7))
    arrow(axes, (right("contact"), -3.5), (right("contact"), -1.3), bend=0.9)
    for place, text in (((middle + 0.1, -1.8), "paths of triangles"), ((middle + 0.1, -3.0), "contacts"), ((left("structure") - 0.25, -0.75), "vertices at t1"),
                        ((right("points") + 0.35, -0.6), "x(t0), x(t1)"), ((right("points") + 0.65, -4.45), "x(t1), v"), ((right("contact") + 0.75, -4.1), "impulses on vertices"),
                        ((right("contact") + 1.25, -2.4), "implicit coupling:\nuntil impulse and\nmotion agree")):  # fmt: skip
        axes.text(*place, text, fontsize=7.5, color=INK, va="center", ha="left")
    for column in ("points", "structure"):
        x = COLUMNS[column][0] + (-0.35 if column == "points" else WIDTH + 0.35)
        side = left(column) if column == "points" else right(column)
        axes.plot([side, x, x], [-4.8, -4.8, 0], color=PALE, linewidth=0.9)
        arrow(axes, (x, 0), (side, 0))
        axes.text(x, -2.4, "next step", rotation=90, fontsize=7.5, color=PALE, ha="right" if column == "points" else "left", va="center")
    axes.set(xlim=(-0.8, right("structure") + 0.8), ylim=(-5.4, 1.5))
    axes.axis("off")
    figure.savefig(Path(__file__).with_suffix(".png"), dpi=130)


if __name__ == "__main__":
    main()
