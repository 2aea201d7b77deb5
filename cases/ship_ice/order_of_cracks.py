#!/usr/bin/python3
"""Draws figures/order_of_cracks.png and cut_sheets.png from results of variants.sh, each with its forces: order_of_cracks.py RESULTS [--only NAME]

Damage of the bottom and of the top layer in the reference configuration, and the vertical force, since first contact with the ice.
"""

import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE / "../../scripts/results"))
from csv_reader import history  # noqa: E402
from results_folder import options, refuse, run  # noqa: E402
from ship_in_ice import COLOURS, spacing_of  # noqa: E402
from vtp_reader import picture_at  # noqa: E402

FIGURES = {  # file → columns: folder, title, time [s] since contact
    "order_of_cracks": (("deck", "deck.yaml", 0.6), ("deck", "deck.yaml", 1.6), ("cut", "cut along the track", 1.4), ("rigid", "rigid contact", 2.1)),
    "cut_sheets": (("cut", "cut, three layers", 1.4), ("cut_below_top", "cut below the top layer", 1.4), ("cut_layers_4", "cut, four layers", 1.4), ("cut_layers_8", "cut, eight layers", 1.4)),
}  # fmt: skip
ENDS = 4.5, 1.5  # [s] of the forces


def first_contact(rows):
    contacts = np.flatnonzero(rows["ship.bow.force_z [N]"])
    return rows["time [s]"][contacts[0]] if len(contacts) else refuse(f"{rows.owner}: the bow is never in contact with the ice.")


def draw(results, file, columns, ends):
    figure, axes = plt.subplots(2, len(columns), figsize=(3.1 * len(columns), 4.0), sharex=True, sharey=True)
    curves = {}
    for (upper, lower), (name, title, since) in zip(axes.T, columns):
        rows = history(results / name)
        start = first_contact(rows)
        curves[title] = rows["time [s]"] - start, rows["ship.bow.force_z [N]"] / 1e6
        largest = np.argmax(curves[title][1])
        print(f"{name}: F_z at most {curves[title][1][largest]:.2f} MN, {curves[title][0][largest]:.2f} s after contact")
        at, sheet = picture_at(results / name, "sheet", start + since)
        reference = sheet.points - sheet.point["displacement"]
        spacing = spacing_of(sheet)
        for axis, height in ((upper, reference[:, 2].max()), (lower, reference[:, 2].min())):
            layer = np.abs(reference[:, 2] - height) < 0.5 * spacing
            image = axis.scatter(reference[layer, 1], reference[layer, 0], c=sheet.point["damage"][layer], s=9 * spacing, marker="s", cmap=COLOURS, vmin=0, vmax=0.9,
                                 linewidths=0)
            axis.set_aspect("equal"), axis.set_xlim(-22, 22), axis.set_ylim(-28, 0.5)
        upper.set_title(f"{title}\n{at - start:.2g} s after contact", fontsize=9)
    axes[0, 0].set_ylabel("top layer, x [m]"), axes[1, 0].set_ylabel("bottom layer, x [m]")
    for axis in axes[1]:
        axis.set_xlabel("y [m]")
    figure.colorbar(image, ax=axes, label="damage", shrink=0.7)
    figure.savefig(HERE / f"figures/{file}.png", dpi=85, bbox_inches="tight")

    figure, axis = plt.subplots(figsize=(8, 3.2))
    for title, (time, force) in curves.items():
        axis.plot(time, force, label=title)
    axis.set_xlim(0, ends), axis.set_xlabel("time since contact [s]"), axis.set_ylabel("F_z on the bow [MN]")
    axis.legend(fontsize=8)
    figure.tight_layout()
    figure.savefig(HERE / f"figures/{file}_forces.png", dpi=85)


def main():
    parser = options(__doc__)
    parser.add_argument("--only", choices=FIGURES, help="this figure alone")
    given = parser.parse_args()
    for (file, columns), ends in zip(FIGURES.items(), ENDS):
        if given.only in (None, file):
            draw(given.results, file, columns, ends)


if __name__ == "__main__":
    run(main)
