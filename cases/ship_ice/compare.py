#!/usr/bin/python3
"""Compares runs of variants.sh: compare.py RESULTS

RESULTS: folder that variants.sh filled. Prints a table, and draws figures/variants.png: F_x on the bow against the travel since first contact.
"""

from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402
from measure import history, loads_of, measure, options, report_of, run, travel_in_ice, window_means  # noqa: E402

HERE = Path(__file__).resolve().parent

PANELS = {
    "contact": {"deck": "deck.yaml, crushed at 2.3 MPa", "crushing_1.15": "1.15 MPa", "crushing_4.6": "4.6 MPa", "rigid": "rigid"},
    "time step and layers": {"deck": "deck.yaml", "step_half": "half of the step", "layers_4": "four layers"},
    "rigid contact: time step, panels, resolution": {
        "rigid": "rigid", "rigid_step_half": "half of the step", "rigid_panels_uniform_3": "panels of 3 m", "rigid_layers_4": "four layers",
        "rigid_horizon_2.5": "horizon of 2.5 spacings", "rigid_horizon_3": "horizon of 3 spacings",
    },
    "rigid contact: ice, friction and speed": {
        "rigid": "rigid", "rigid_flexural_360": "flexural strength 360 kPa", "rigid_flexural_1440": "1440 kPa", "rigid_compressive_4.6": "compressive strength 4.6 MPa",
        "rigid_friction_0.1": "friction of the hull 0.1", "rigid_speed_6": "6 knots",
    },
}  # fmt: skip
TABLE_ALONE = "stem_radius_1", "dry_top_3"  # without a curve in the figure
MEAN_OVER = 1.5  # [m] of travel, a second at 3 knots


def table(folders):
    print("| run | particles | largest F_x before 4.6 m [MN] | mean of F_x [kN] | largest mean over a second [kN] | load peaks | bonds broken | energy balance error over the work |")
    print("|---|---|---|---|---|---|---|---|")
    for folder in folders:
        found, particles = measure(folder), report_of(folder)["bodies"]["sheet"]["particles"]
        number = f"{particles:,}".replace(",", "\u202f")
        print(f"| `{folder.name}` | {number} | {found['first peak'] / 1e6:.2f} | {found['mean of all'] / 1e3:.0f} | {found['largest 1 s'] / 1e3:.0f} | {loads_of(found)}"
              f" | {100 * found['broken']:.1f} % | {found['closing']:.0e} |")


def draw(results, file):
    figure, axes = plt.subplots(len(PANELS), 1, figsize=(10, 2.3 * len(PANELS)), sharex=True)
    for axis, (title, runs) in zip(axes, PANELS.items()):
        first = next(iter(runs.values()))
        for name, label in runs.items():
            rows = history(results / name)
            time, way = rows["time [s]"], travel_in_ice(rows)
            middles, means = window_means(time, rows["ship.bow.force_x [N]"] / 1e6, MEAN_OVER * np.ptp(time) / np.ptp(way))
            axis.plot(np.interp(middles, time, way), means, label=label, color="#20506e" if label == first else None, linewidth=1.8 if label == first else 1.2)
        axis.set_ylabel("F_x [MN]"), axis.set_xlim(0, None), axis.set_ylim(0, None)
        axis.set_title(title, fontsize=10), axis.legend(fontsize=8)
    axes[-1].set_xlabel("travel since first contact [m]")
    figure.tight_layout()
    figure.savefig(file, dpi=85)


def main():
    results = options(__doc__).parse_args().results
    table([results / name for name in dict.fromkeys([*(name for runs in PANELS.values() for name in runs), *TABLE_ALONE])])
    draw(results, HERE / "figures" / "variants.png")


if __name__ == "__main__":
    run(main)
