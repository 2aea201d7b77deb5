#!/usr/bin/python3
"""Draws the figure of this case from a results folder:

    cases/crack_branching/figures.py results/crack_branching      writes figures/crack_branching.png beside this script
"""

import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
from measure import frames, measure, options, refuse, run  # noqa: E402

CASE = Path(__file__).resolve().parent
sys.path.insert(0, str(CASE.parents[1] / "scripts/results"))
from damage_map import draw  # noqa: E402

INSTANTS = 15e-6, 25e-6, 35e-6, 50e-6  # [s] before branching, twice during propagation, and after the crack has left the plate


def main():
    folder = options(__doc__).parse_args().results
    pictures = list(frames(folder))
    found = measure(pictures)
    if found["branches at [m]"] is None:
        refuse(f"{folder}: the crack does not branch.")
    figure, axes = plt.subplots(2, 2, figsize=(10, 4.7), sharex=True, sharey=True, layout="constrained")
    for axis, wanted in zip(axes.flat, INSTANTS):
        time, points, damage = min(pictures, key=lambda picture: abs(picture[0] - wanted))
        map_ = draw(axis, points, damage)
        axis.set_title(f"{1e6 * time:.0f} µs", loc="left", fontsize=11)
    split = 1e3 * found["branches at [m]"]
    last = axes.flat[-1]
    label = f"branches {split:.1f} mm\npast the notch, at {1e6 * found['branches [s]']:.1f} µs"
    last.annotate(label, (split, 0), (-22, 11), fontsize=9.5, ha="center", va="center", arrowprops={"arrowstyle": "-", "lw": 0.7})
    for axis in axes[1]:
        axis.set_xlabel("x [mm]")
    for axis in axes[:, 0]:
        axis.set_ylabel("y [mm]")
    figure.colorbar(map_, ax=axes, label="damage: share of the bonds that are broken", shrink=0.85)
    figure.suptitle("Crack branching in glass under a suddenly applied tension of 12 MPa", fontsize=12.5)
    (CASE / "figures").mkdir(exist_ok=True)
    figure.savefig(CASE / "figures/crack_branching.png", dpi=100)


if __name__ == "__main__":
    run(main)
