#!/usr/bin/python3
"""Draws the figures of README.md: figures.py [RESULTS] [--of DECK] [--check FOLDER]

RESULTS: folder of a finished run (default: results/ship_ice). --of: its deck: deck (default); paper, window, or window_rigid (75.2 s of window with rigid contact); paper and window_rigid at the paper's four instants.
--check: folder with the surfaces and contact bounds written by `perimpact check`; then only the bow and its contact bounds are drawn.
"""

from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402
from measure import begin_of_full_breadth, history, mean, options, read_vtp, report_of, run, series, travel_in_ice, window_means  # noqa: E402  which makes scripts/results importable
from ship_in_ice import corners_of, draw_damage, draw_scenes  # noqa: E402

HERE = Path(__file__).resolve().parent
PAPER_TIMES = 18.8, 37.6, 56.4, 75.2  # [s] of figure 19
WINDOW_TIMES = 42.3, 65.8, 89.3, 112.8  # [s] with the full breadth in the ice


def mean_from(folder):
    """[s] and its name: where the full breadth of the ship is in the ice, else where the entry of the stem ends."""
    begin = begin_of_full_breadth(folder)
    return (4, "mean from 4 s on") if begin is None else (begin, "mean at full breadth")


def draw_forces(folder, file):
    rows = history(folder)
    time = rows["time [s]"]
    begin, name_of_mean = mean_from(folder)
    figure, axes = plt.subplots(2, 1, figsize=(10, 6.4), sharex=True)
    for axis, name, words in zip(axes, "xz", ("F_x, resistance", "F_z, upwards")):
        force = rows[f"ship.force_{name} [N]"] / 1e6
        axis.fill_between(time, force, color="#a9c9e0", step="pre", label=f"rows of history.csv, {time[2] - time[1]:.3g} s")
        axis.plot(*window_means(time, force, 1.0), color="#b3312c", linewidth=1.6, label="mean over 1 s")
        axis.axhline(mean(time[time > begin], force[time > begin]), color="#20506e", linestyle="--", linewidth=1, label=name_of_mean)
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
    arguments = options(__doc__, nargs="?", default=Path("results/ship_ice"))
    arguments.add_argument("--of", choices=("deck", "paper", "window", "window_rigid"), default="deck")
    arguments.add_argument("--check", type=Path)
    given = arguments.parse_args()
    figures = HERE / "figures"
    figures.mkdir(exist_ok=True)
    if given.check:
        draw_bow(given.check, figures / "bow.png")
        return
    end = series(given.results, "sheet")[-1][0]
    times = {"deck": [share * end for share in (0.1, 0.4, 0.7, 1)], "window": WINDOW_TIMES}.get(given.of, PAPER_TIMES)
    prefix = "" if given.of == "deck" else f"{given.of}_"
    draw_scenes(given.results, times, figures / f"{prefix}scenes.png")
    draw_damage(given.results, times, figures / f"{prefix}damage.png")
    draw_forces(given.results, figures / f"{prefix}forces.png")


if __name__ == "__main__":
    run(main)
