#!/usr/bin/python3
"""Draws force, damage and scenes of a run into figures/: figures.py [RESULTS]

RESULTS: folder of a run of deck.yaml (default: results/uikku_ice_302).
"""

from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
from decks import HERE, ship_in, tests  # noqa: E402  which makes ../ship_ice importable
from measure import history, mean, options, run, series, window_means  # noqa: E402  which makes scripts/results importable
from ship_in_ice import draw_damage, draw_scenes  # noqa: E402


def draw_force(folder, test, file):
    """F_x by time: rows, mean over 2 s, mean of the sample, and the measured mean."""
    rows = history(folder)
    time, force = rows["time [s]"], rows["ship.force_x [N]"] / 1e3
    figure, axis = plt.subplots(figsize=(10, 3.8))
    axis.fill_between(time, force, color="#a9c9e0", step="pre", label=f"rows of history.csv, {time[2] - time[1]:.3g} s")
    middles, smooth = window_means(time, force, 2.0)
    axis.plot(middles, smooth, color="#b3312c", linewidth=1.2, label="mean over 2 s")
    begin = ship_in(test).sample_begins
    if time[-1] > begin:
        axis.hlines(mean(time[time > begin], force[time > begin]), begin, time[-1], color="#20506e", linewidth=1.6, label="mean of the sample")
    axis.axhline(test["resistance"], color="#3a3a3a", linestyle="--", linewidth=1, label="measured mean")
    axis.axvspan(0, ship_in(test).approach_time, color="#000000", alpha=0.06, linewidth=0)
    axis.set_ylabel("F_x, resistance [kN]"), axis.set_xlabel("time [s]; grey: 1.5 m/s, until the bow is in the ice")
    axis.set_xlim(0, time[-1]), axis.set_ylim(0, 1.1 * max(*smooth, test["resistance"]))
    axis.legend(fontsize=9, loc="upper left")
    figure.tight_layout()
    figure.savefig(file, dpi=95)


def main():
    folder = options(__doc__, nargs="?", default=Path("results/uikku_ice_302")).parse_args().results
    figures = HERE / "figures"
    figures.mkdir(exist_ok=True)
    end = series(folder, "sheet")[-1][0]
    draw_force(folder, tests()[302], figures / "force.png")
    draw_scenes(folder, [0.5 * end, end], figures / "scenes.png")
    draw_damage(folder, [0.5 * end, end], figures / "damage.png")


if __name__ == "__main__":
    run(main)
