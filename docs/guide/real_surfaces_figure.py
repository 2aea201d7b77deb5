#!/usr/bin/python3
"""Draws the pictures of real_surfaces.md: a Wigley hull that goes into a sheet, and where a motorcycle has rims.

    docs/guide/real_surfaces_figure.py build/release/perimpact        two minutes; needs openfoam-examples, numpy and matplotlib
"""

import subprocess
import sys
import tempfile
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1] / "scripts/results"))
from render import Scene  # noqa: E402
from vtp_reader import read_vtp  # noqa: E402

SURFACES = Path("/usr/share/doc/openfoam-examples/examples/resources/geometry")
SHEET, HULL, RIM = np.array([0.62, 0.78, 0.90]), np.array([0.72, 0.36, 0.30]), np.array([0.85, 0.10, 0.12])
CRACKED = np.array([0.10, 0.22, 0.42])

DECK = f"""\
title: A Wigley hull goes into a sheet
time: {{end: 60 ms}}
bodies:
  sheet:
    shape: {{box: {{size: [0.5, 0.5, 0.04]}}}}
    spacing: 0.01
    position: [0.765, 0.0013, 0]
    material: {{model: ordinary-state, youngs_modulus: 10 MPa, poissons_ratio: 0.25, density: 900 kg/m3, critical_stretch: 0.02}}
impactors:
  hull:
    surface: {{file: {SURFACES}/wigley.stl.gz, orientation: reversed}}
    mass: 20 kg
    velocity: [4 m/s, 0, 0]
output: {{folder: results, frames: 3}}
"""


def triangles(picture):
    return np.array([picture.points[[panel[0], panel[k], panel[k + 1]]] for panel in picture.panels for k in range(1, len(panel) - 1)])


def wigley(program, folder, fold=3):
    (folder / "deck.yaml").write_text(DECK)
    subprocess.run([program, "run", "deck.yaml"], cwd=folder, check=True, stdout=subprocess.DEVNULL)
    figure, axes = plt.subplots(1, 3, figsize=(12, 3.4))
    for axis, frame in zip(axes, (0, 1, 3)):
        sheet, hull = (read_vtp(folder / f"results/frames/{name}_{frame:05}.vtp") for name in ("sheet", "hull"))
        scene = Scene(direction=(0.55, -0.75, 0.85), up=(0, 0, 1), pixels_per_metre=400 * fold, width=470 * fold, height=400 * fold, centre=(0.44, 0, 0))
        damage = np.clip(sheet.point["damage"] / 0.5, 0, 1)[:, None]
        scene.add_balls(sheet.points, 0.005, (1 - damage) * SHEET + damage * CRACKED)
        scene.add_shells(triangles(hull), HULL)
        axis.imshow(scene.picture(fold))
        axis.set_title(f"{1e3 * sheet.time:.0f} ms", fontsize=10)
        axis.set_axis_off()
    figure.subplots_adjust(left=0.005, right=0.995, bottom=0.01, top=0.92, wspace=0.02)
    figure.savefig(HERE / "figures/wigley.png", dpi=110)


def motorcycle(program, folder, fold=3):
    subprocess.run([program, "mesh", SURFACES / "motorBike.obj.gz", "--out", "fit.stl"], cwd=folder, check=True, stdout=subprocess.DEVNULL)
    rims = triangles(read_vtp(folder / "motorBike_defects.vtp"))
    facets = np.array([row.split()[1:] for row in (folder / "fit.stl").read_text().splitlines() if row.split()[:1] == ["vertex"]], float)
    figure, axes = plt.subplots(1, 2, figsize=(12, 4.2))
    for axis, direction in zip(axes, ((-0.7, -1.0, 0.45), (0.4, -0.5, 1.0))):
        scene = Scene(direction=direction, up=(0, 0, 1), pixels_per_metre=260 * fold, width=620 * fold, height=450 * fold, centre=(0.72, 0, 0.6))
        scene.add_shells(facets.reshape(-1, 3, 3), np.array([0.74, 0.77, 0.81]))
        lift = 0.01 * np.asarray(direction) / np.linalg.norm(direction)  # so that what has a rim is not hidden by what it lies on
        scene.add_shells(rims + lift, RIM)
        axis.imshow(scene.picture(fold))
        axis.set_axis_off()
    figure.subplots_adjust(left=0.005, right=0.995, bottom=0.01, top=0.99, wspace=0.02)
    figure.savefig(HERE / "figures/motorcycle_rims.png", dpi=110)


def main():
    program = Path(sys.argv[1]).resolve()
    (HERE / "figures").mkdir(exist_ok=True)
    for draw in (wigley, motorcycle):
        with tempfile.TemporaryDirectory() as folder:
            draw(program, Path(folder))


main()
