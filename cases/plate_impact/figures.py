#!/usr/bin/python3
"""Draws the figures of section 5 of Zhang et al. from results folders, with the finite-element reference.

    /usr/bin/python3 figures.py RESULTS [RESULTS ...] [--out figures] [--only fig16 ...]

Folders named panel_<size>mm are labelled with their panel size, `analytic` as the original method (results.py).
Missing data are reported, and the figures that need them are skipped. Needs numpy and matplotlib.
"""

import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from hero import draw_hero
from matplotlib.collections import PolyCollection
from results import Results, middle_layer, read_columns  # which makes scripts/results importable
from results_folder import Missing, options

HERE = Path(__file__).parent
END = 200e-6  # [s]
INK, QUIET = "#1d2733", "#8a97a5"
STYLE = {
    "font.size": 9, "font.family": "DejaVu Sans", "text.color": INK, "axes.labelcolor": INK, "axes.edgecolor": INK, "axes.linewidth": 0.7,
    "xtick.color": INK, "ytick.color": INK, "axes.spines.top": False, "axes.spines.right": False, "axes.titlesize": 9, "axes.titlelocation": "left",
    "legend.frameon": False, "savefig.dpi": 150, "savefig.bbox": "tight", "figure.constrained_layout.use": True,
}  # fmt: skip


# ---- the set-up ----

def faces_towards_reader(picture, axes):
    """The panels whose outward normal comes out of the page, as polygons in mm; axes: which coordinates go right and up."""
    right, up = axes
    polygons = []
    for panel in picture.panels:
        corners = 1e3 * picture.points[panel][:, [right, up]]
        x, y = (corners - corners[0]).T
        if np.sum(x * np.roll(y, -1) - y * np.roll(x, -1)) > 1e-9:
            polygons.append(corners)
    return polygons


def draw_particles(axis, plate, axes, **style):
    seen = np.unique(np.round(1e3 * plate.points[:, axes], 3), axis=0)
    axis.scatter(*seen.T, linewidths=0, rasterized=True, **style)


def draw_box(axis, region, axes):
    low, high = 1e3 * region.points.min(axis=0)[axes], 1e3 * region.points.max(axis=0)[axes]
    axis.add_patch(plt.Rectangle(low, *(high - low), fill=False, ls=(0, (4, 3)), lw=1.1, ec="#c8102e", zorder=3))


def fig13(runs, path):
    """Model set-up: plate, cylinder and contact bounds, from the front and from the side."""
    run = next(run for run in runs if run.panel is None or run.panel >= 0.5)
    plate, cylinder, region = (run.checked(name) for name in ("plate", "cylinder_surface", "cylinder_contact_bounds"))
    figure, (front, side) = plt.subplots(1, 2, figsize=(9, 5.2), width_ratios=[220, 60], sharey=True)
    for axis, axes in ((front, [0, 1]), (side, [2, 1])):
        draw_particles(axis, plate, axes, s=1.5, color="#4b7ba6")
        low, high = 1e3 * cylinder.points.min(axis=0), 1e3 * cylinder.points.max(axis=0)
        faces = faces_towards_reader(cylinder, axes) if axes == [0, 1] else [np.array([(low[2], low[1]), (high[2], low[1]), (high[2], high[1]), (low[2], high[1])])]
        axis.add_collection(PolyCollection(faces, facecolor="#d5dbe1", edgecolor="#d5dbe1", lw=0.2, zorder=2))
        draw_box(axis, region, axes)
        axis.set_aspect("equal")
    front.annotate("", (0, 55), (0, 75), arrowprops={"arrowstyle": "-|>", "color": INK, "lw": 1.4}, zorder=4)
    front.text(3, 64, "32 m/s\n1.57 kg", va="center", zorder=4)
    front.text(-98, 56, "plate 200 × 100 × 9 mm, free", va="bottom")
    front.text(28, 99, "contact bounds 50 × 50 × 10 mm", color="#c8102e", va="top")
    front.text(28, 75, "rigid cylinder Ø 50 × 25 mm", va="center")
    front.set(xlabel="x [mm]", ylabel="y [mm]", xlim=(-106, 106), ylim=(-56, 106), title="from the front")
    side.set(xlabel="z [mm]", xlim=(-20, 20), title="from the side")
    figure.savefig(path)


def fig14(runs, path):
    """The panel meshes over the particles, without the finest as in the paper; below, the contact zone."""
    runs = sorted((run for run in runs if (run.panel or 0) >= 0.5), key=lambda run: -run.panel)
    figure, axes = plt.subplots(2, len(runs), figsize=(2.2 * len(runs), 4.9), squeeze=False)
    for run, (whole, near) in zip(runs, axes.T):
        plate, cylinder = run.checked("plate"), run.checked("cylinder_surface")
        faces = faces_towards_reader(cylinder, [0, 1])
        for axis, dot in ((whole, 1.2), (near, 34)):
            draw_particles(axis, plate, [0, 1], s=dot, color="#4b7ba6")
            shown = faces if axis is whole else [face for face in faces if np.abs(face[:, 0]).max() < 9 and face[:, 1].min() < 58]
            axis.add_collection(PolyCollection(shown, facecolor="#e6e9ed", edgecolor=INK, lw=min(0.35, 0.2 * run.panel + (axis is near) * 0.1), rasterized=True))
            axis.set(aspect="equal", xticks=[], yticks=[])
            axis.spines[:].set_visible(True)
        whole.set(xlim=(-29, 29), ylim=(32, 102), title=f"{run.label}\n" + f"{len(cylinder.panels):,} panels".replace(",", " "))
        near.set(xlim=(-6, 6), ylim=(44, 56))
        whole.add_patch(plt.Rectangle((-6, 44), 12, 12, fill=False, ec="#c8102e", lw=0.8, zorder=3))
    figure.savefig(path, dpi=120)


# ---- the plate ----

def fig15(runs, path):
    """Displacement fields of the plate's middle layer at the end, one row per run."""
    layers = [middle_layer(run.frame("plate", END)) for run in runs]
    figure, axes = plt.subplots(len(runs), 2, figsize=(8.2, 2.2 * len(runs) + 0.5), sharex=True, sharey=True, squeeze=False)
    for component, (column, name, colours) in enumerate(zip(axes.T, ("u_x", "u_y"), ("RdBu_r", "viridis"))):
        values = [1e3 * u[..., component] for _, u in layers]
        low, high = min(v.min() for v in values), max(v.max() for v in values)
        if component == 0:
            low, high = -max(-low, high), max(-low, high)  # white at zero displacement
        for axis, run, (x, _), value in zip(column, runs, layers, values):
            image = axis.pcolormesh(1e3 * x[..., 0], 1e3 * x[..., 1], value, shading="gouraud", cmap=colours, vmin=low, vmax=high, rasterized=True)
            axis.set_aspect("equal")
            axis.set_title(f"{run.label}:  ${name}$ from {value.min():.3f} to {value.max():.3f} mm".replace("-", "−"))
        figure.colorbar(image, ax=column, orientation="horizontal", label=f"${name}$ at 200 µs [mm]", shrink=0.7, aspect=40, pad=0.01)
    for axis in axes[:, 0]:
        axis.set_ylabel("y [mm]")
    for axis in axes[-1]:
        axis.set_xlabel("x [mm]")
    figure.savefig(path, dpi=100)


# ---- curves ----

def curve_styles(runs):
    """Curves that coincide stay visible: the first are wide and pale, the last thin and dark."""
    colours = plt.get_cmap("viridis_r")(np.linspace(0.08, 0.95, len(runs)))
    widths = np.linspace(4.5, 0.9, len(runs))
    return [{"color": INK if run.is_original else colour, "lw": 1.0 if run.is_original else width, "ls": (0, (3, 2)) if run.is_original else "-", "label": run.label}
            for run, colour, width in zip(runs, colours, widths)]  # fmt: skip


def draw_reference(axis, x, y, every):
    axis.plot(x[::every], y[::every], "o", ms=4.2, mfc="white", mec="#c8102e", mew=1.0, label="finite elements", zorder=5)


def draw_share(axis, percent):
    """A scale bar as a share of the values, for an axis that shows only a narrow range of them."""
    bottom = axis.get_ylim()[0] + 0.05 * np.ptp(axis.get_ylim())
    height = np.abs(np.mean(axis.get_ylim())) * percent / 100
    ends = {"arrowstyle": "|-|,widthA=0.3,widthB=0.3", "color": QUIET, "shrinkA": 0, "shrinkB": 0}
    axis.annotate("", (0.86, bottom), (0.86, bottom + height), xycoords=("axes fraction", "data"), arrowprops=ends)
    axis.text(0.88, bottom + height / 2, f"{percent} %", transform=axis.get_yaxis_transform(), va="center", color=QUIET)


def curve(path, runs, xlabel, ylabel, of_run, reference, every, share=None):
    figure, axis = plt.subplots(figsize=(5.2, 3.5))
    for run, style in zip(runs, curve_styles(runs)):
        axis.plot(*of_run(run), **style)
    draw_reference(axis, *reference, every)
    axis.set(xlabel=xlabel, ylabel=ylabel)
    axis.grid(color="#e4e8ec", lw=0.6)
    axis.set_axisbelow(True)
    if share:
        draw_share(axis, share)
    axis.legend(fontsize=8)
    figure.savefig(path)


def history_curve(name, ylabel, of_column, column):
    def draw(runs, path):
        def points(table):
            return 1e6 * table["time [s]"], of_column(table[column])

        reference = points(read_columns(HERE / "reference_fem.csv"))
        curve(path, runs, "time [µs]", ylabel, lambda run: points(run.history), reference, 10)

    draw.__doc__ = name
    return draw


def line_curve(name, line, coordinate, every, share=None):
    def draw(runs, path):
        def points(table):
            return 1e3 * table[f"position_{coordinate} [m]"], 1e3 * table["displacement_y [m]"]

        reference = points(read_columns(HERE / f"reference_fem_line_{coordinate}.csv"))
        curve(path, runs, f"{coordinate} [mm]", "$u_y$ at 200 µs [mm]", lambda run: points(run.line(line, END)), reference, every, share)

    draw.__doc__ = name
    return draw


FIGURES = {
    "fig13": fig13,
    "fig14": fig14,
    "fig15": fig15,
    "fig16a": history_curve("Displacement of the plate's centre against time.", "$u_y$ of the centre [mm]", lambda u: 1e3 * u, "centre.displacement_y [m]"),
    "fig16b": line_curve("Displacement along the central line in x.", "along_x", "x", every=10),
    "fig16c": line_curve("Displacement along the central line in y.", "along_y", "y", every=5, share=0.25),
    "fig17a": history_curve("Position of the cylinder.", "y of the cylinder [mm]", lambda y: 1e3 * y, "cylinder.position_y [m]"),
    "fig17b": history_curve("Displacement of the cylinder.", "$u_y$ of the cylinder [mm]", lambda y: 1e3 * (y - y[0]), "cylinder.position_y [m]"),
    "fig17c": history_curve("Velocity of the cylinder.", "$v_y$ of the cylinder [m/s]", lambda v: v, "cylinder.velocity_y [m/s]"),
    "hero": draw_hero,
}


def main():
    arguments = options(__doc__, nargs="+")
    arguments.add_argument("--out", type=Path, default=HERE / "figures")
    arguments.add_argument("--only", nargs="+", default=[], metavar="FIGURE", help=f"of {', '.join(FIGURES)}")
    given = arguments.parse_args()
    given.out.mkdir(parents=True, exist_ok=True)
    runs = sorted((Results(folder) for folder in given.results), key=lambda run: (run.is_original, -(run.panel or 0)))
    plt.rcParams.update(STYLE)
    left_out = 0
    for name, draw in FIGURES.items():
        if given.only and not any(name.startswith(wanted) for wanted in given.only):
            continue
        try:
            draw(runs, given.out / f"{name}.png")
            print(f"{given.out / name}.png: {draw.__doc__.splitlines()[0]}")
        except (Missing, StopIteration, IndexError) as lacking:
            left_out += 1
            print(f"{name} left out: {lacking or 'no run for it'}", file=sys.stderr)
        plt.close("all")
    return 1 if left_out else 0


if __name__ == "__main__":
    sys.exit(main())
