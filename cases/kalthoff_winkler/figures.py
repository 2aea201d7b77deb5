#!/usr/bin/python3
"""Draws the figures of this case from results folders:

    cases/kalthoff_winkler/figures.py results/kalthoff_winkler                             writes figures/kalthoff_winkler.png
    cases/kalthoff_winkler/figures.py --variants "0.0057=FOLDER" "0.015=FOLDER" …          writes figures/critical_stretch.png

beside this script. The figures show the layer of particles in the middle of the thickness in the reference configuration.
"""

import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402
from measure import FAR, LEFT, RIGHT, TIP, angle, crack, frames, length, options, refuse, run  # noqa: E402

CASE = Path(__file__).resolve().parent
sys.path.insert(0, str(CASE.parents[1] / "scripts/results"))
from damage_map import draw  # noqa: E402

INSTANTS = 27e-6, 36e-6, 54e-6, 90e-6  # [s]


def layer(points, damage):
    """One layer if there are two in the middle."""
    _, one = np.unique(np.round(points, 7), axis=0, return_index=True)
    return points[one], damage[one]


def from_tip(axis, degrees, side, reach, **style):
    """A line at that angle from the notch line, from the tip outwards [mm]."""
    turn = np.radians(degrees)
    axis.plot([side * 1e3 * TIP, side * (1e3 * TIP + reach * np.sin(turn))], [0, -reach * np.cos(turn)], **style)


def label(figure, axes, map_, title):
    for axis in axes[-1]:
        axis.set_xlabel("x [mm]")
    for axis in axes[:, 0]:
        axis.set_ylabel("y [mm]")
    for axis in axes.flat:
        axis.set(xlim=(-100, 100), ylim=(-50, 50))
    figure.colorbar(map_, ax=axes, label="growth of damage", shrink=0.85)
    figure.suptitle(title, fontsize=12.5)


def notches(axis):
    for side in (LEFT, RIGHT):
        axis.plot([side * 1e3 * TIP] * 2, [0, 50], color="#1d2733", lw=1.6)


def course(folder, path):
    """The cracks at four instants, and the angle in the frame in which it is measured."""
    pictures = list(frames(folder))
    measured = next((plate for _, *plate in pictures if length(crack(*plate, RIGHT)) > FAR), None) or refuse(f"{folder}: no crack is {1e3 * FAR:g} mm long.")
    figure, axes = plt.subplots(2, 2, figsize=(10, 5.4), sharex=True, sharey=True, layout="constrained")
    for axis, wanted in zip(axes.flat, INSTANTS):
        time, points, damage = min(pictures, key=lambda picture: abs(picture[0] - wanted))
        map_ = draw(axis, *layer(points, damage))
        notches(axis)
        axis.set_title(f"{1e6 * time:.0f} µs", loc="left", fontsize=11)
    found = np.mean([angle(crack(*measured, side)) for side in (LEFT, RIGHT)])
    last = axes.flat[-1]
    for side in (LEFT, RIGHT):
        from_tip(last, 70, side, 60, color="#2f6f4f", lw=1.3, ls=(0, (5, 3)))
    last.set_title(f"{1e6 * time:.0f} µs; {found:.1f}° when 50 mm long, dashed: 70°", loc="left", fontsize=11)
    label(figure, axes, map_, f"Cracks run at {found:.0f}° from both notches of a plate that is struck between them at 32 m/s")
    figure.savefig(path, dpi=100)


def variants(folders, path):
    """The cracks for several critical stretches, each at a length of 50 mm, when the angle is measured."""
    figure, axes = plt.subplots(len(folders) // 2, 2, figsize=(10, 2.7 * (len(folders) // 2)), sharex=True, sharey=True, layout="constrained")
    for axis, (name, folder) in zip(axes.flat, folders):
        for time, points, damage in frames(Path(folder)):
            if length(crack(points, damage, RIGHT)) > FAR:
                break
        else:
            refuse(f"{folder}: no crack is {1e3 * FAR:g} mm long.")
        map_ = draw(axis, *layer(points, damage))
        notches(axis)
        axis.set_title(f"critical stretch {name}: {np.mean([angle(crack(points, damage, side)) for side in (LEFT, RIGHT)]):.1f}°, at {1e6 * time:.0f} µs",
                       loc="left", fontsize=11)  # fmt: skip
    label(figure, axes, map_, "The tougher the steel, the later the cracks run and the larger is their angle")
    figure.savefig(path, dpi=100)


def main():
    parser = options(__doc__, nargs="?")
    parser.add_argument("--variants", nargs="+", type=lambda word: tuple(word.split("=", 1)), metavar="STRETCH=RESULTS")
    given = parser.parse_args()
    if (given.results is None) == (given.variants is None) or not all(len(variant) == 2 for variant in given.variants or ()):
        parser.error("give RESULTS, or --variants STRETCH=RESULTS …")
    (CASE / "figures").mkdir(exist_ok=True)
    if given.variants:
        variants(given.variants, CASE / "figures/critical_stretch.png")
    else:
        course(given.results, CASE / "figures/kalthoff_winkler.png")


if __name__ == "__main__":
    run(main)
