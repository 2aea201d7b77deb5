#!/usr/bin/env python3
"""Draws the figures of this case from the results of variants.sh:

    cases/submarine_surfacing/figures.py results/submarine_surfacing

writes figures/surfacing.png, forces.png, fragments.png and equilibrium.png beside this script.
"""

import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402
from matplotlib.colors import LinearSegmentedColormap, Normalize  # noqa: E402
from measure import GRAVITY, history, ice_on, options, report_of, run  # noqa: E402

CASE = Path(__file__).resolve().parent
sys.path.insert(0, str(CASE.parents[1] / "scripts/results"))
from render import Scene  # noqa: E402
from vtp_reader import picture_at  # noqa: E402

INSTANTS = 0.6, 2.4, 4.4, 14.0  # [s] of the free rise: the sail has cracked the ice, penetrates it, the hull lifts it, at rest
END = 1e9  # [s] later than any frame
FLOE = 2e-3  # share of the ice above which a fragment has its own colour
COLOURS = LinearSegmentedColormap.from_list("damage", ["#eaf3fa", "#a9cbe3", "#e8a15a", "#b3312c"])
FLOES = [colour for k, colour in enumerate(plt.get_cmap("tab20").colors) if k not in (14, 15)]  # without greys
RED, BLUE, GREY = "#b3312c", "#2f6f9f", "0.45"

plt.rcParams.update({"font.size": 12, "axes.spines.top": False, "axes.spines.right": False})


def by_damage(ice):
    return COLOURS(ice.point["damage"])[:, :3]


def by_fragment(ice):
    """The heaviest fragments in distinct colours, smaller ones pale, single particles grey."""
    fragment = ice.point["fragment"].astype(int).ravel()
    size = np.bincount(fragment)
    colours = np.tile([0.80, 0.83, 0.86], (len(fragment), 1))
    colours[size[fragment] == 1] = 0.52
    for number in np.flatnonzero(size > FLOE * len(fragment)):
        colours[fragment == number] = (0.92, 0.96, 0.98) if number == 0 else FLOES[number % len(FLOES)][:3]
    return colours


def scene_at(folder, time, spacing, colours=by_damage, fold=2):
    at, ice = picture_at(folder, "ice", time)
    boat = picture_at(folder, "submarine", time)[1]
    scene = Scene(direction=(0.75, -0.95, 0.75), up=(0, 0, 1), pixels_per_metre=9.6 * fold, width=640 * fold, height=330 * fold, centre=(1, 0, -1))
    scene.add_panels(boat.points, boat.panels, colour=(0.36, 0.40, 0.44), edge_colour=(0.30, 0.33, 0.37), edge_width=0.03)
    scene.add_balls(ice.points, 0.62 * spacing, colours(ice))
    return at, scene.picture(fold)


def draw_surfacing(folder, spacing):
    figure, axes = plt.subplots(2, 2, figsize=(11.5, 6.9), layout="constrained")
    for axis, time in zip(axes.flat, INSTANTS):
        at, image = scene_at(folder, time, spacing)
        axis.imshow(image, interpolation="none")
        axis.text(0.0, 0.9, f"{at:.1f} s", transform=axis.transAxes, fontsize=14)
        axis.axis("off")
    scale = matplotlib.cm.ScalarMappable(Normalize(0, 1), COLOURS)
    figure.colorbar(scale, ax=axes, location="bottom", shrink=0.3, aspect=25, pad=0.01, label="damage of particles")
    figure.savefig(CASE / "figures/surfacing.png", dpi=95)
    plt.close(figure)


def draw_fragments(runs, spacing):
    figure, axes = plt.subplots(1, len(runs), figsize=(11.5, 3.4), layout="constrained")
    for axis, (folder, title) in zip(axes, runs):
        axis.imshow(scene_at(folder, END, spacing, by_fragment)[1], interpolation="none")
        axis.set_title(f"{title}: {report_of(folder)['bodies']['ice']['fragments']['above_1_percent']} above 1 %")
        axis.axis("off")
    figure.savefig(CASE / "figures/fragments.png", dpi=95)
    plt.close(figure)


def draw_forces(given, crushed, mass):
    """Against the rise of the submarine, which is its speed times time."""
    time, height = given["time [s]"], given["submarine.position_z [m]"]
    rise = height - height[0]

    def curve(columns, part):
        times, force = ice_on(columns, part)
        return np.interp(times, time, rise), force / 1e6

    figure, axis = plt.subplots(figsize=(10.5, 4.6), layout="constrained")
    for part, colour in ((".sail", BLUE), (".hull", RED)):
        axis.plot(*curve(given, part), color=colour, lw=1, alpha=0.6, label=f"{part[1:]}, ice that is not crushed")
        axis.plot(*curve(crushed, part), color=colour, lw=2, label=f"ice on the {part[1:]}, downward")
    lift = GRAVITY * (given["submarine.displaced_mass [kg]"] - mass)
    axis.plot(rise, lift / 1e6, color=GREY, lw=1.5, ls="--", label="buoyancy − weight, upward")
    axis.axhline(0, color="0.8", lw=0.8)
    axis.set(xlabel="rise [m]", ylabel="force [MN]", title="Force that breaks the ice, and force of the water")
    axis.legend(frameon=False, loc="center left", bbox_to_anchor=(0.12, 0.58))
    figure.savefig(CASE / "figures/forces.png", dpi=95)
    plt.close(figure)


def draw_equilibrium(free, mass):
    figure, axis = plt.subplots(figsize=(10.5, 4.6), layout="constrained")
    time = free["time [s]"]
    axis.plot(time, free["submarine.displaced_mass [kg]"] / 1e3, color=BLUE, lw=2.2, label="displaced water")
    times, force = ice_on(free)
    axis.plot(times, (mass + force / GRAVITY) / 1e3, color=RED, lw=1.6, label="mass + force of the ice / g")
    axis.axhline(mass / 1e3, color=GREY, lw=1, ls="--", label="mass")
    axis.set(xlabel="time [s]", ylabel="mass [t]", title="Free in heave, the submarine ends by displacing its own mass and that of the ice on it")
    axis.legend(frameon=False)
    figure.savefig(CASE / "figures/equilibrium.png", dpi=95)
    plt.close(figure)


def main():
    given, crushed, free = (options(__doc__).parse_args().results / name for name in ("given", "crushed", "free"))
    (CASE / "figures").mkdir(exist_ok=True)
    report = report_of(free)
    mass = report["impactors"]["submarine"]["mass [kg]"]
    draw_forces(history(given), history(crushed), mass)
    draw_fragments([(given, "not crushed"), (crushed, "crushed")], report_of(given)["setup"]["bodies"]["ice"]["spacing"])
    draw_equilibrium(history(free), mass)
    draw_surfacing(free, report["setup"]["bodies"]["ice"]["spacing"])


if __name__ == "__main__":
    run(main)
