#!/usr/bin/python3
"""Draws the figure of this case from a results folder:

    cases/floating_strip/figure.py results/floating_strip        writes figures/floating_strip.png beside this script
"""

from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402
from matplotlib.colors import LinearSegmentedColormap  # noqa: E402
from measure import Run, broken, options, read_vtp, refuse, run as run_script  # noqa: E402

CASE = Path(__file__).resolve().parent
SHADES = LinearSegmentedColormap.from_list("ice", ["0.62", "C1", "C3", "k"])
SHOWN, RAISED = 45.0, 3.5  # length of strip shown, and offset between frames [m]


def main():
    run = Run(options(__doc__).parse_args().results)
    strip, theory, found = run.strip, run.theory(), broken(run)
    if "crack [N/m]" not in found:
        refuse(f"{run.folder}: no crack is through the strip.")
    pictures = [read_vtp(path) for path in run.pictures]
    loads = np.array([run.load(picture.time) for picture in pictures])
    edge = np.array([-run.mean(picture.point["displacement"][:, 2])[0] for picture in pictures])
    level = run.report["bodies"]["ice"]["boundary_conditions"]["sea"]["level [m]"]

    plt.rcParams.update({"font.size": 12})
    figure, (side, curve) = plt.subplots(2, 1, figsize=(10, 8.2), height_ratios=(1.25, 1), layout="constrained")
    after = next(i for i, picture in enumerate(pictures) if picture.time >= found["crack, time [s]"])
    seen = (run.row == 0) & (run.section * run.spacing < SHOWN)
    for number, i in enumerate((0, after - 1, after, min(after + 2, len(pictures) - 1))):
        up = -RAISED * number
        places = pictures[i].points[seen]
        side.axhspan(up - 2.2, up + level, color="C0", alpha=0.12, lw=0)
        map_ = side.scatter(places[:, 0], places[:, 2] + up, c=pictures[i].point["damage"][seen], s=22, marker="s", lw=0, cmap=SHADES, vmin=0, vmax=0.5)
        side.annotate(f"{pictures[i].time:.1f} s\n{loads[i] / 1e3:.1f} kN/m", (SHOWN + 1, up), va="center", fontsize=11)
    side.axvline(strip.breaking_distance, color="0.3", ls=":", lw=1.5)
    side.annotate("largest moment by theory", (strip.breaking_distance, 1.55), xytext=(5, 0), textcoords="offset points", fontsize=11, color="0.3")
    side.set(title="A strip of ice, pressed down at its edge (heights drawn larger)", xlim=(-1, SHOWN + 9.5), yticks=[], xlabel="from the edge [m]")
    figure.colorbar(map_, ax=side, label="damage", shrink=0.8)

    grid = np.linspace(0, max(found["crack [N/m]"], strip.breaking_load), 9)
    curve.plot(1e-3 * grid, strip.edge_deflection(grid), "k", lw=4, alpha=0.25, label="theory: $2Pλ/k$")
    curve.plot(1e-3 * grid, [theory.solve(load, run.at, flooded=True)[0][0] for load in grid], "C1--", lw=1.8, label="theory with water on the ice")
    whole = loads < found["first bond [N/m]"]
    curve.plot(1e-3 * loads[whole], edge[whole], "C0o", ms=4, label="particles at the edge")
    curve.axvline(1e-3 * found["first bond [N/m]"], color="C3", lw=1.5, label=f"first bond breaks, {found['first bond [N/m]'] / 1e3:.1f} kN/m")
    curve.axvline(1e-3 * strip.breaking_load, color="k", ls=":", lw=1.5, label=f"theory breaks, {strip.breaking_load / 1e3:.1f} kN/m")
    curve.set(xlabel="line load [kN/m]", ylabel="edge, down [m]", xlim=(0, None), ylim=(0, None))
    curve.legend(frameon=False, loc="upper left", fontsize=11)
    curve.grid(alpha=0.3)
    (CASE / "figures").mkdir(exist_ok=True)
    figure.savefig(CASE / "figures/floating_strip.png", dpi=100)


if __name__ == "__main__":
    run_script(main)
