#!/usr/bin/python3
"""Draws the figures of this case from the folder that variants.sh fills:

    cases/propeller_ice/figures.py results/propeller_ice      two minutes; writes figures/*.png beside this script

fig21      panels of the propeller, and the contact bounds (figure 21 of the paper)
fig22      the sphere at four times, from ahead and from the side (figure 22)
forces     thrust, torque and spindle torques against time, means over a millisecond
fragments  the fragments at the end for four critical stretches
crushed    thrust on crushable ice, on ice that is crushed in contact and on ice that fails in tension only, and their fragments at the end
"""

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402
from matplotlib.colors import LinearSegmentedColormap, to_rgb  # noqa: E402
from measure import BLADES, CASE, WINDOW, history, options, pictures, report_of, run, window_means  # noqa: E402  which makes scripts/results importable
from render import Scene  # noqa: E402

SAND, LINE, BOUNDS = np.array([0.84, 0.74, 0.52]), (0.45, 0.38, 0.24), "#2a6fb0"
DAMAGE = LinearSegmentedColormap.from_list("damage", ["#dbe9f4", "#8fb8d8", "#e8a15a", "#b3312c"])
COLOURS = ["#4477aa", "#ee6677", "#228833", "#ccbb44", "#66ccee", "#aa3377", "#ee8866", "#77aadd", "#44bb99", "#bbcc33"]
AHEAD, SIDE = {"direction": (0.85, -0.25, -0.45), "up": (0, 0, 1)}, {"direction": (0.05, -1, -0.12), "up": (0, 0, 1)}
INSTANTS = 0.0, 0.0075, 0.015, 0.040  # [s]
BALL = 0.027  # [m] a little more than half a spacing


def at(folder, name, time):
    return min(pictures(folder, name), key=lambda picture: abs(picture[0] - time))


def scene(view, width, height, scale, centre, fold=2):
    return Scene(**view, pixels_per_metre=scale * fold, width=width * fold, height=height * fold, centre=centre)


def shells(screw):
    return screw.points.astype(float)[np.array(screw.panels)]


def show(axis, picture, title=None):
    axis.imshow(picture, interpolation="none")
    axis.axis("off")
    if title:
        axis.set_title(title, fontsize=12)


def save(figure, name):
    (CASE / "figures").mkdir(exist_ok=True)
    figure.savefig(CASE / "figures" / f"{name}.png", dpi=100)
    plt.close(figure)


def fig21(folder):
    _, screw = at(folder, "propeller", 0)
    bounds = report_of(folder)["impactors"]["propeller"]["contact_bounds"]
    figure, axes = plt.subplots(1, 2, figsize=(10.4, 5.2))
    view = {"direction": (0.75, -0.5, 0.35), "up": (0, 0, 1)}
    for axis, title in zip(axes, ("11 704 panels, finer along edges and tips", "contact bounds: cylinder with four sectors, fitted")):
        picture = scene(view, 500, 480, 105, (0, 0, 0), fold=3)
        picture.add_panels(screw.points, screw.panels, SAND, LINE, 0.004)
        show(axis, picture.picture(3), title)

    def page(points):
        x, y, _ = picture.axes @ np.atleast_2d(points).T
        return 250 + 105 * x, 240 - 105 * y

    def ring(x, radius, low, high):
        angle = np.linspace(low, high, 90)
        return np.column_stack([np.full(90, x), radius * np.cos(angle), radius * np.sin(angle)])

    axis, half, outer, hub = axes[1], bounds["length [m]"] / 2, bounds["radius [m]"], bounds["hub_radius [m]"]
    for x in (-half, half):
        ends = bounds["start_angle [rad]"] + 2 * np.pi / bounds["blades"] * np.arange(bounds["blades"])
        for start in ends:
            stop = start + bounds["sector_angle [rad]"]
            outline = np.concatenate([ring(x, outer, start, stop), ring(x, hub, stop, stop + 2 * np.pi / bounds["blades"] - bounds["sector_angle [rad]"])])
            axis.plot(*page(outline), color=BOUNDS, lw=1.8 if x > 0 else 0.9)
            axis.plot(*page(np.stack([outline[89], outline[90]])), color=BOUNDS, lw=1.8 if x > 0 else 0.9)
    for start in ends:
        for angle, radius in ((start, outer), (start, hub), (start + bounds["sector_angle [rad]"], outer), (start + bounds["sector_angle [rad]"], hub)):
            axis.plot(*page([[x, radius * np.cos(angle), radius * np.sin(angle)] for x in (-half, half)]), color=BOUNDS, lw=0.9)
    figure.subplots_adjust(left=0.005, right=0.995, top=0.93, bottom=0.005, wspace=0.01)
    save(figure, "fig21")


def fig22(folder):
    figure, axes = plt.subplots(2, 4, figsize=(11, 5.9))
    for column, wanted in zip(axes.T, INSTANTS):
        time, ice = at(folder, "ice", wanted)
        _, screw = at(folder, "propeller", wanted)
        for axis, view in zip(column, (AHEAD, SIDE)):
            picture = scene(view, 260, 270, 80, (0.35, 0, -1.15))
            picture.add_shells(shells(screw), SAND)
            picture.add_balls(ice.points, BALL, DAMAGE(ice.point["damage"])[:, :3])
            show(axis, picture.picture(2), f"{1e3 * time:.1f} ms" if view is AHEAD else None)
    figure.text(0.008, 0.73, "from ahead", rotation=90, va="center", fontsize=11)
    figure.text(0.008, 0.26, "from the side, ahead is right", rotation=90, va="center", fontsize=11)
    figure.subplots_adjust(left=0.025, right=0.915, top=0.95, bottom=0.01, wspace=0.02, hspace=0.02)
    bar = figure.add_axes([0.93, 0.2, 0.012, 0.6])
    figure.colorbar(plt.cm.ScalarMappable(cmap=DAMAGE), cax=bar, label="share of the bonds that are broken")
    save(figure, "fig22")


def forces(folder):
    column = history(folder)

    def mean(what):
        middles, means = window_means(column["time [s]"], column[f"propeller.{what}"], WINDOW)
        return 1e3 * middles, means / 1e6

    figure, axes = plt.subplots(3, 1, figsize=(10, 7), sharex=True, layout="constrained")
    axes[0].plot(*mean("shaft.force_x [N]"), color="#b3312c")
    axes[0].set_ylabel("thrust [MN]\n(+: ahead)")
    axes[1].plot(*mean("shaft.torque [N m]"), color="#b3312c")
    axes[1].set_ylabel("torque [MN m]\n(+: brakes)")
    for blade in BLADES:
        colour, label = ("#b3312c", "blade 4") if blade == 4 else ("#7c8ba1", "blades 1 to 3" if blade == 1 else None)
        axes[2].plot(*mean(f"blade_{blade}.torque [N m]"), color=colour, label=label)
    axes[2].set(xlabel="time [ms]", ylabel="spindle torque\n[MN m]", xlim=(4, 20))
    axes[2].legend(frameon=False)
    for axis in axes:
        axis.grid(alpha=0.25)
    axes[0].set_title("One impact, on the back of blade 4 (means over 1 ms)", fontsize=12)
    save(figure, "forces")


def coloured(ice, screw):
    """Fragments above 1 % in colours, smaller ones grey; the picture, and how many they are."""
    fragment = ice.point["fragment"]
    size = np.bincount(fragment)
    largest = [number for number in np.argsort(-size) if size[number] > 0.01 * len(fragment)]
    colours = np.tile([0.62, 0.62, 0.62], (len(fragment), 1))
    for number, colour in zip(largest, COLOURS * 10):
        colours[fragment == number] = to_rgb(colour)
    picture = scene(AHEAD, 270, 290, 88, (0.3, 0, -0.85))
    picture.add_shells(shells(screw), SAND)
    picture.add_balls(ice.points, BALL, colours)
    return picture.picture(2), f"{len(largest)} fragment{'s' if len(largest) != 1 else ''} above 1 %"


def fragments(results):
    figure, axes = plt.subplots(1, 4, figsize=(11, 3.5))
    for axis, stretch in zip(axes, ("0.032", "0.01", "0.003", "0.001")):
        folder = results / ("deck" if stretch == "0.003" else f"stretch_{stretch}")
        _, ice = at(folder, "ice", 1)
        _, screw = at(folder, "propeller", 1)
        picture, found = coloured(ice, screw)
        show(axis, picture, f"critical stretch {stretch}\n{found}")
    figure.subplots_adjust(left=0.005, right=0.995, top=0.86, bottom=0.005, wspace=0.02)
    save(figure, "fragments")


def crushed(results):
    figure, axes = plt.subplots(1, 4, figsize=(14, 3.6), width_ratios=(1.5, 1, 1, 1))
    runs = (("stretch_3.2e-4", "tension only", "#e8a15a"), ("stretch_3.2e-4_fine", "tension only, 40 across", "#b3312c"),
            ("crushed", "crushable", "#8fb8d8"), ("crushed_fine", "crushable, 40 across", "#12355b"),
            ("crushed_in_contact", "crushed in contact", "#77bb88"), ("crushed_in_contact_fine", "crushed in contact, 40 across", "#1b6b36"))  # fmt: skip
    for name, label, colour in runs:
        column = history(results / name)
        middles, thrust = window_means(column["time [s]"], column["propeller.shaft.force_x [N]"], WINDOW)
        axes[0].plot(1e3 * middles, thrust / 1e6, color=colour, label=label)
    axes[0].set(xlabel="time [ms]", ylabel="thrust, mean over 1 ms [MN]", xlim=(4, 19))
    axes[0].grid(alpha=0.25)
    axes[0].legend(frameon=False, fontsize=9)
    for axis, (name, label) in zip(axes[1:], (("stretch_3.2e-4", "tension only"), ("crushed", "crushable"), ("crushed_in_contact", "crushed in contact"))):
        picture, found = coloured(at(results / name, "ice", 1)[1], at(results / name, "propeller", 1)[1])
        show(axis, picture, f"{label}, at the end\n{found}")
    figure.subplots_adjust(left=0.06, right=0.995, top=0.86, bottom=0.14, wspace=0.03)
    save(figure, "crushed")


def main():
    results = options(__doc__).parse_args().results
    fig21(results / "deck")
    forces(results / "deck")
    fig22(results / "deck")
    fragments(results)
    crushed(results)


if __name__ == "__main__":
    run(main)
