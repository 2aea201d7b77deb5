#!/usr/bin/python3
"""Draws the figures of this case:

    PYTHONPATH=build/release/python cases/hull_panel/figures.py RESULTS      the folder of impacts.py; with moving.npz of verify.py; writes figures/*.png beside this script

impacts      force, deflection and stress against time, of the rigid panel, the modal one and the finite elements
panel        the panel and the ice at the largest deflection
moving_load  deflection of the panel under a moving load, by finite elements and by modes
bars         the pulse in both bars
"""

import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import matplotlib.ticker  # noqa: E402
import numpy as np  # noqa: E402
from mpl_toolkits.mplot3d.art3d import Poly3DCollection  # noqa: E402

CASE = Path(__file__).resolve().parent
sys.path.insert(0, str(CASE.parents[1] / "scripts/results"))
from interval_means import window_means  # noqa: E402
from results_folder import file_in, options, run  # noqa: E402

PANELS = (("rigid", "rigid", "#b3312c", "-"), ("modal", "240 modes", "#e8b04a", "-"), ("finite", "finite elements", "#12355b", "--"))
WINDOW = 2e-4  # [s]


def save(figure, name):
    (CASE / "figures").mkdir(exist_ok=True)
    figure.savefig(CASE / "figures" / f"{name}.png", dpi=100)
    plt.close(figure)


def smooth(found):
    """Middles of windows [s] and the mean force in them [N]."""
    return window_means(found["time"], found["force"], WINDOW)


def draw_impacts(results):
    figure, axes = plt.subplots(2, 3, figsize=(12, 6.4), layout="constrained")
    for row, (name, title, end) in zip(axes, (("sphere", "sphere, 1 m/s", 14), ("floe", "floe, 3 m/s", 16))):
        for panel, label, colour, style in PANELS:
            found = np.load(file_in(results, f"{name}_{panel}.npz", "impacts.py"))
            times, force = smooth(found)
            row[0].plot(1e3 * times, force / 1e3, color=colour, ls=style, lw=3 if panel == "modal" else 1.3, label=label)
            row[1].plot(1e3 * found["times"], 1e3 * found["deflection"], color=colour, ls=style, lw=3 if panel == "modal" else 1.3)
            stress = np.max([found[part] for part in ("plating", "webs", "flanges")], axis=0)
            row[2].plot(1e3 * found["times"], stress / 1e6, color=colour, ls=style, lw=3 if panel == "modal" else 1.3)
        for axis, quantity in zip(row, ("force, mean over 0.2 ms [kN]", "largest deflection [mm]", "largest von Mises stress [MPa]")):
            axis.set(ylabel=quantity, xlim=(0, end), ylim=(0, None), title=title)
            axis.grid(alpha=0.25)
    for axis in axes[1]:
        axis.set_xlabel("time [ms]")
    axes[0][0].legend(frameon=False)
    save(figure, "impacts")


def draw_panel(results):
    from panel import Model

    model = Model()
    figure = plt.figure(figsize=(12, 5.4), layout="constrained")
    for place, name in enumerate(("sphere", "floe")):
        found = np.load(file_in(results, f"{name}_finite.npz", "impacts.py"))
        axis = figure.add_subplot(1, 2, 1 + place, projection="3d", computed_zorder=False)
        u = found["picture_u"]
        stress = model.shell.von_mises(u) / 1e6
        corners = (model.points + 100 * u.reshape(-1, 6)[:, :3])[model.shell.quads]
        drawn = Poly3DCollection(corners, array=stress, cmap="viridis", edgecolors="none", zorder=1)
        drawn.set_clim(0, stress.max())
        axis.add_collection3d(drawn)
        ice = found["picture_ice"]
        shown = ice[:, 1] > 0.2 if name == "sphere" else np.ones(len(ice), bool)
        whole = found["picture_damage"] < 0.5
        for kind, colour in ((whole, "#9fd0ea"), (~whole, "#e0822f")):
            axis.scatter(*ice[shown & kind].T, s=5, c=colour, linewidths=0, zorder=2, depthshade=True)
        axis.set(xlim=(-1, 1), ylim=(-1, 1), zlim=(-0.6, 1.0), xlabel="x [m]", ylabel="y [m]", title=f"{name}: {1e3 * found['picture_deflection']:.2f} mm, drawn 100 times")
        axis.set_box_aspect((2, 2, 1.6))
        axis.view_init(elev=18, azim=-62)
        for line in (axis.xaxis, axis.yaxis, axis.zaxis):
            line.set_major_locator(matplotlib.ticker.MultipleLocator(0.5))
        figure.colorbar(drawn, ax=axis, shrink=0.6, label="von Mises stress [MPa]")
    save(figure, "panel")


def draw_moving_load(results):
    found = np.load(file_in(results, "moving.npz", "verify.py"))
    times, points = 1e3 * found["times"], found["points"]
    figure, axis = plt.subplots(figsize=(9, 3.8), layout="constrained")
    for place, colour, label in (((0.0, 0.0), "#12355b", "middle of the middle bay"), ((0.0, 0.2), "#b3312c", "on a frame")):
        node = np.argmin(np.linalg.norm(points[:, :2] - place, axis=1))
        axis.plot(times, -1e3 * found["finite"][:, node], color=colour, label=f"{label}: finite elements")
        axis.plot(times, -1e3 * found["modal"][:, node], color="#e8b04a", ls="--", lw=1.2, label=f"{label}: 240 modes")
    axis.set(xlabel="time [ms]", ylabel="deflection [mm]", title="100 kN on 0.6 m × 0.4 m, crossing the frames at 25 m/s", xlim=(0, times[-1]))
    axis.grid(alpha=0.25)
    axis.legend(frameon=False, fontsize=9)
    save(figure, "moving_load")


def draw_bars():
    from bar import DENSITY, SPEED, run

    figure, axes = plt.subplots(1, 2, figsize=(10, 3.6), sharey=True, layout="constrained")
    for axis, ratio in zip(axes, (1.0, 0.5)):
        found = run(ratio)
        axis.plot(1e3 * found["times"], DENSITY * SPEED * found["finite"] / 1e3, color="#12355b", label="finite elements")
        axis.plot(1e3 * found["times"], DENSITY * SPEED * found["particles"] / 1e3, color="#e0822f", label="peridynamics")
        axis.set(xlabel="time [ms]", title=f"Z₂/Z₁ = {ratio:g}")
        axis.grid(alpha=0.25)
    axes[0].set_ylabel("Z₁ × velocity at the gauge [kPa]")
    axes[0].legend(frameon=False)
    save(figure, "bars")


def main():
    results = options(__doc__).parse_args().results
    draw_impacts(results)
    draw_panel(results)
    draw_moving_load(results)
    draw_bars()


if __name__ == "__main__":
    run(main)
