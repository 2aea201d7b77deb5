#!/usr/bin/python3
"""Draws the picture of this case from the folder of its results:

    cases/ice_specimens/figures.py results/ice_specimens      writes figures/specimens.png beside this script
"""

import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402
from measure import STRENGTH, bending, compression, indentation, punch  # noqa: E402

CASE = Path(__file__).resolve().parent
sys.path.insert(0, str(CASE.parents[1] / "scripts/pictures"))
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


def main(folder):
    folder = Path(folder)
    figure, ((a, b, c), (d, e, f)) = plt.subplots(2, 3, figsize=(13, 7.5))
    line(a, [(100 * s, p / 1e6) for s, p in compression(folder / "compression")], "compression of a prism", "strain [%]", "stress [MPa]", STRENGTH / 1e6,
         "compressive_strength")
    line(b, [(t, p / 1e6) for t, p, broken in bending(folder / "bending")], "four-point bending", "time [s]", "stress at the surface [MPa]", 0.5, "flexural_strength")
    line(c, [(100 * w, p) for w, p in punch(folder / "punch")], "punch of 16 particles, plane strain", "depth [% of the width]", "pressure/σ_c", HILL, "Hill")
    curve = np.array(indentation(folder / "indentation"))
    d.plot(curve[:, 0], curve[:, 1] / 1e6, label="this deck")
    d.plot(curve[:, 0], 7.4 * curve[:, 0] ** -0.7, "k:", label="7.4 A^-0.7")
    d.set_ylim(0, 20)
    d.legend(frameon=False)
    d.set_title("indentation by a sphere", fontsize=10)
    d.set_xlabel("area of the cap [m²]")
    d.set_ylabel("mean pressure [MPa]")
    panels = np.genfromtxt(folder / "indentation/pressure_area/sphere_at_peak.csv", delimiter=",", skip_header=1)
    e.loglog(panels[:, 0], panels[:, 1] / 1e6, "o-")
    e.set_title("the same: nested areas of panels, largest force", fontsize=10)
    e.set_xlabel("area [m²]")
    e.set_ylabel("mean pressure [MPa]")
    section(f, folder / "indentation", figure)
    figure.tight_layout()
    (CASE / "figures").mkdir(exist_ok=True)
    figure.savefig(CASE / "figures/specimens.png", dpi=80)


if __name__ == "__main__":
    main(sys.argv[1])
