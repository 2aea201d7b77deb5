#!/usr/bin/python3
"""Draws the picture of this case from the folder of its results:

    cases/ice_specimens/figures.py results/ice_specimens      writes figures/specimens.png and figures/edges_and_impacts.png beside this script
"""

import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402
from measure import (  # noqa: E402
    DROP_RADIUS, EDGES, TENSION, ball, bending, cap, centre_pressure, compression, drop, edge, indentation, iso_global, local_design, nested, options, punch, run, splitting, strength, tension)  # fmt: skip

CASE = Path(__file__).resolve().parent
sys.path.insert(0, str(CASE.parents[1] / "scripts/results"))
from vtp_reader import pictures  # noqa: E402

HILL = (1 + np.pi / 2) * 2 / np.sqrt(3)


def line(axes, curve, title, x, y, reference=None, label=None):
    axes.plot(*np.array(curve).T)
    if reference is not None:
        axes.axhline(reference, color="black", linestyle=":", label=label)
        axes.legend(loc="lower right", frameon=False)
    axes.set_title(title, fontsize=10)
    axes.set_xlabel(x)
    axes.set_ylabel(y)


def section(axes, folder, figure):
    """The layer of particles nearest to y = 0 at the end, coloured by plastic strain; what has lost more than a third of its bonds is ringed."""
    *_, (_, body) = pictures(folder, "ice")
    first = body.points - body.point["displacement"]
    layer = np.isclose(first[:, 1], first[np.abs(first[:, 1]).argmin(), 1], atol=1e-3)
    points, strain, damage = body.points[layer], body.point["plastic_strain"][layer], body.point["damage"][layer]
    dots = axes.scatter(points[:, 0], points[:, 2], c=strain, s=26, cmap="viridis", vmax=0.3)
    axes.scatter(points[damage > 0.33, 0], points[damage > 0.33, 2], facecolors="none", edgecolors="crimson", s=30, linewidths=0.8)
    axes.set_xlim(-1.2, 1.2)
    axes.set_ylim(-1.3, 0.15)
    axes.set_aspect("equal")
    axes.set_title("plastic strain; red: a third of the bonds broken", fontsize=10)
    figure.colorbar(dots, ax=axes, shrink=0.8)


def half_of_disc(axes, folder):
    """Damage of the disc's middle layer at the end, displacements ten times as large."""
    *_, (_, body) = pictures(folder, "ice")
    first = body.points - body.point["displacement"]
    layer = np.isclose(first[:, 1], first[np.abs(first[:, 1]).argmin(), 1], atol=1e-4)
    points = first[layer] + 10 * body.point["displacement"][layer]
    axes.scatter(points[:, 0], points[:, 2], c=body.point["damage"][layer], s=14, cmap="magma_r", vmin=0, vmax=0.6)
    axes.set_aspect("equal")
    axes.set_title("the disc at the end: damage, displacements × 10", fontsize=10)


def edge_from_above(axes, folder):
    """Plastic strain of the upper layer of a sheet beside the indenter, at the end."""
    *_, (_, body) = pictures(folder, "ice")
    first = body.points - body.point["displacement"]
    layer = np.isclose(first[:, 2], first[:, 2].max(), atol=1e-4)
    points = body.points[layer]
    axes.scatter(points[:, 0], points[:, 1], c=body.point["plastic_strain"][layer], s=9, cmap="viridis", vmax=0.05)
    broken = body.point["damage"][layer] > 0.33
    axes.scatter(points[broken, 0], points[broken, 1], facecolors="none", edgecolors="crimson", s=14, linewidths=0.6)
    axes.set_xlim(-0.01, 0.25)
    axes.set_ylim(-0.2, 0.2)
    axes.set_aspect("equal")
    axes.set_title(f"{folder.name}: plastic strain, 0 to 5 %", fontsize=10)


def specimens(folder):
    figure, ((a, b, c), (d, e, f)) = plt.subplots(2, 3, figsize=(13, 7.5))
    line(a, [(100 * s, p / 1e6) for s, p in compression(folder / "compression")], "compression of a prism", "strain [%]", "stress [MPa]", strength(folder / "compression") / 1e6,
         "compressive_strength")
    line(b, [(t, p / 1e6) for t, p, broken in bending(folder / "bending")], "four-point bending", "time [s]", "stress at the surface [MPa]", 0.5, "flexural_strength")
    line(c, [(100 * w, p) for w, p in punch(folder / "punch")], "punch of 16 particles, plane strain", "depth [% of the width]", "pressure/σ_c", HILL, "Hill")
    curve = np.array(indentation(folder / "indentation"))
    d.plot(curve[:, 0], curve[:, 1] / 1e6, label="this deck")
    d.plot(curve[:, 0], local_design(curve[:, 0]) / 1e6, "k:", label="7.4 A^-0.7")
    d.set_ylim(0, 20)
    d.legend(frameon=False)
    d.set_title("indentation by a sphere", fontsize=10)
    d.set_xlabel("area of the cap [m²]")
    d.set_ylabel("mean pressure [MPa]")
    panels = np.array(nested(folder / "indentation", "sphere"))
    e.loglog(panels[:, 0], panels[:, 1] / 1e6, "o-")
    e.set_title("the same: nested areas of panels, largest force", fontsize=10)
    e.set_xlabel("area [m²]")
    e.set_ylabel("mean pressure [MPa]")
    section(f, folder / "indentation", figure)
    return figure


def edges_and_impacts(folder):
    figure, ((a, b, c, d), (e, f, g, h)) = plt.subplots(2, 4, figsize=(17, 7.8))
    line(a, [(1e3 * s, p / 1e6) for s, p, _ in splitting(folder / "brazilian")], "splitting of a disc, tension of the prism (dashed)", "shortening [mm]", "stress [MPa]",
         0.8 * TENSION / 0.918 / 1e6, "0.8 E s_c/0.918")
    a.plot(*np.array([(190 * s, p / 1e6) for s, p, _ in tension(folder / "tension")]).T, "--", color="C1")
    half_of_disc(b, folder / "brazilian")
    for name, (thickness, _, width) in EDGES.items():
        curve = np.array(edge(folder / name))
        c.plot(1e3 * curve[:, 0], curve[:, 2] / strength(folder / name), label=name)
        panels = np.array(nested(folder / name, "indenter"))
        d.loglog(panels[:, 0], panels[:, 1] / 1e6, ".-", label=name)
        depth = curve[-1, 0]
        d.plot(width(depth) * thickness, iso_global(thickness, width(depth)) / 1e6, "k^", markersize=5, label="ISO, global" if name == "edge_narrow" else None)
    area = np.geomspace(5e-5, 0.02)
    d.plot(area, local_design(area) / 1e6, "k:", label="7.4 A^-0.7")
    d.set_ylim(1, 400)
    for axes, title, x, y in (c, "edge of a floating sheet", "depth [mm]", "pressure/σ_c"), (d, "nested areas of panels, largest force", "area [m²]", "mean pressure [MPa]"):
        axes.legend(frameon=False, fontsize=8)
        axes.set_title(title, fontsize=10)
        axes.set_xlabel(x)
        axes.set_ylabel(y)
    c.set_ylim(0, 6)
    edge_from_above(e, folder / "edge_narrow")
    edge_from_above(f, folder / "edge_wide")
    line(g, [(1e3 * t, p / 1e6) for t, p in ball(folder / "ball")], "ball of ice on a plate", "time [ms]", "force [MN]", 2.43, "v √(2πR p_c m)")
    curve = np.array([(1e3 * depth, force / cap(DROP_RADIUS, depth) / 1e6) for _, depth, force in drop(folder / "drop") if depth > 1e-3])
    line(h, curve, "dropped sphere", "depth [mm]", "pressure [MPa]")
    times = np.arange(0.2e-3, 3.2e-3, 0.2e-3)
    depths = np.interp(times + 0.1e-3, *np.array(drop(folder / "drop"))[:, :2].T)
    h.plot(1e3 * depths, [centre_pressure(folder / "drop", time, time + 0.2e-3) / 1e6 for time in times])
    h.set_ylim(0, None)
    h.axhspan(25, 41, color="0.85")
    h.legend(["mean over the cap", "over 15 cm² at the lowest point", "the same, measured"], frameon=False, fontsize=8)
    return figure


def main():
    folder = options(__doc__).parse_args().results
    for draw in specimens, edges_and_impacts:
        figure = draw(folder)
        figure.tight_layout()
        (CASE / "figures").mkdir(exist_ok=True)
        figure.savefig(CASE / f"figures/{draw.__name__}.png", dpi=80)


if __name__ == "__main__":
    run(main)
