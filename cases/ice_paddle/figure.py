#!/usr/bin/env python3
"""Draws the figure of this case from a results folder:

    ./run.sh ice_paddle --out results/ice_paddle
    cases/ice_paddle/figure.py results/ice_paddle      writes figures/ice_paddle.png beside this script
"""

import re
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
from matplotlib.colors import LinearSegmentedColormap  # noqa: E402

CASE = Path(__file__).resolve().parent
sys.path.insert(0, str(CASE.parents[1] / "scripts/results"))
from csv_reader import history  # noqa: E402
from render import Scene  # noqa: E402
from results_folder import options, run  # noqa: E402
from vtp_reader import picture_at  # noqa: E402

INSTANTS = 0.026, 0.029, 0.036  # [s] just before the impact of the blade, during cutting, and after
COLOURS = LinearSegmentedColormap.from_list("damage", ["#dbe9f4", "#8fb8d8", "#e8a15a", "#b3312c"])


def picture(ice, paddle, feeder, fold=3):
    scene = Scene(direction=(-0.45, -0.35, 1.1), up=(0, 1, 0), pixels_per_metre=560 * fold, width=380 * fold, height=400 * fold, centre=(0.24, 0.0, 0))
    scene.add_panels(paddle.points, paddle.panels, colour=(0.74, 0.77, 0.81), edge_colour=(0.60, 0.63, 0.68), edge_width=1.5e-3)
    scene.add_panels(feeder.points, feeder.panels, colour=(0.62, 0.66, 0.60), edge_colour=(0.50, 0.54, 0.48), edge_width=1.5e-3)
    scene.add_balls(ice.points, 0.006, COLOURS(ice.point["damage"])[:, :3])
    return scene.picture(fold)


def main():
    folder = options(__doc__).parse_args().results
    column = history(folder)
    milliseconds = 1e3 * column["time [s]"]

    figure = plt.figure(figsize=(11, 6.4), layout="constrained")
    above, below = figure.subfigures(2, 1, height_ratios=(1.75, 1))
    for axis, time in zip(above.subplots(1, 3), INSTANTS):
        at, ice = picture_at(folder, "ice", time)
        axis.imshow(picture(ice, picture_at(folder, "paddle", time)[1], picture_at(folder, "feeder", time)[1]), interpolation="none")
        axis.text(0.97, 0.93, f"{1e3 * at:.0f} ms", transform=axis.transAxes, fontsize=12, ha="right")
        axis.axis("off")
    left, right = below.subplots(1, 2)
    left.plot(milliseconds, column["paddle.wheel.torque [N m]"], color="#b3312c")
    left.set(xlabel="time [ms]", ylabel="torque on the shaft [N m]")
    for gauge, colour in (("paddle.blade_1", "#b3312c"), ("paddle.blade_4", "#7c8ba1")):
        right.plot(milliseconds, column[f"{gauge}.force_y [N]"] / 1e3, color=colour, label=re.sub(r".*\.", "", gauge))
    right.plot(milliseconds, column["feeder.force_y [N]"] / 1e3, color="#5a7a4a", label="feeder")
    right.set(xlabel="time [ms]", ylabel="vertical force [kN]")
    right.legend(frameon=False)
    for axis in (left, right):
        axis.grid(alpha=0.25)
    (CASE / "figures").mkdir(exist_ok=True)
    figure.savefig(CASE / "figures" / "ice_paddle.png", dpi=100)


if __name__ == "__main__":
    run(main)
