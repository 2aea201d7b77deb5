#!/usr/bin/python3
"""What the ship met: measure.py RESULTS ...

A line for each results folder. The loads are of contact on the part `bow`, from 3 s after the first contact to the end: mean resistance
F_x, its largest mean over 1 s, F_z/F_x; before these, the largest row of all. Then travel in the ice, broken bonds, pieces of 1 % of the
sheet's mass and more beside the one that remains, work of the ship, and the closing error of the energy over it.
"""

import csv
import json
import sys
from pathlib import Path

import numpy as np

SETTLED = 3.0  # [s] after the first contact, in which the sheet answers the blow


def history(folder):
    with open(Path(folder) / "history.csv", newline="") as lines:
        names, *rows = csv.reader(lines)
    return dict(zip(names, np.array(rows, float).T))


def window_means(time, force, width):
    """Means over windows of that width [s] that begin at each row."""
    rows = max(1, round(width / np.median(np.diff(time))))
    sums = np.concatenate([[0], np.cumsum(force)])
    return (sums[rows:] - sums[:-rows]) / rows


def measure(folder):
    rows = history(folder)
    report = json.loads((Path(folder) / "run.json").read_text())
    time, along, up = rows["time [s]"], rows["ship.bow.force_x [N]"], rows["ship.bow.force_z [N]"]
    first = time[np.flatnonzero(along)[0]]
    late = time > first + SETTLED
    speed = abs(rows["ship.velocity_x [m/s]"][0])
    work = -rows["ship.contact_work [J]"][-1]
    with open(Path(folder) / "pieces/sheet.csv", newline="") as lines:
        pieces = list(csv.DictReader(lines))[-1]
    return {
        "travel": speed * (time[-1] - first),
        "first peak": along.max(),
        "mean": along[late].mean(),
        "largest 1 s": window_means(time[late], along[late], 1.0).max(),
        "ratio": up.sum() / along.sum(),
        "broken": rows["sheet.broken_bonds [-]"][-1] / report["bodies"]["sheet"]["bonds"],
        "large pieces": int(pieces["above_1_percent [-]"]) - 1,
        "work": work,
        "closing": np.abs(rows["total.closing_error [J]"]).max() / work,
    }


def show(folder):
    m = measure(folder)
    print(
        f"{Path(folder).name:24s} {m['travel']:5.1f} m  peak {m['first peak'] / 1e6:5.2f} MN  mean {m['mean'] / 1e3:5.0f} kN  1 s {m['largest 1 s'] / 1e3:5.0f} kN"
        f"  F_z/F_x {m['ratio']:.4f}  broken {100 * m['broken']:4.1f} %  pieces {m['large pieces']:d}  work {m['work'] / 1e6:.2f} MJ  closing {m['closing']:.0e}"
    )


if __name__ == "__main__":
    for name in sys.argv[1:]:
        show(name)
