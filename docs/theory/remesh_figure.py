#!/usr/bin/python3
"""Draws a hull as its mesher left it, coarsened, and refined at the bow:

    docs/theory/remesh_figure.py build/release/perimpact      writes figures/remesh.png beside this script
"""

import json
import subprocess
import sys
import tempfile
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1] / "scripts/results"))
from render import Scene  # noqa: E402
from vtp_reader import read_vtp  # noqa: E402

LENGTH, BREADTH, DEPTH = 24.0, 5.0, 3.0  # [m]
CELLS = 96, 24  # of each side, along the ship and around its section

DECK = """\
title: Panels of a hull
time: {{end: 1 us, step: 1 us}}
bodies: {{floe: {{shape: {{box: {{size: [4, 4, 4]}}}}, spacing: 1, position: [20, 0, 0],
  material: {{model: ordinary-state, youngs_modulus: 1 GPa, density: 900}}}}}}
impactors: {{ship: {{surface: {{file: hull.obj}}, mass: 100 t{keys}}}}}
"""
COARSEN = ", coarsen: {max_deviation: 10 mm, max_edge_length: 4 m}"
REFINE = ", refine: {bow: {edge_length: 0.4 m, box: {size: [6, 6, 6], centre: [10, 0, -1]}}}"


def write_hull(path):
    """A parallel middle body with a flat bottom and a bow, closed by a deck: a lattice of quads as even as meshers make them."""
    along, around = CELLS
    x = np.linspace(-LENGTH / 2, LENGTH / 2, along + 1)
    fullness = np.where(x > 2, np.sqrt(np.clip(1 - ((x - 2) / (LENGTH / 2 - 2)) ** 2, 0, 1)), 1.0)
    keel = np.where(x > 6, -DEPTH + DEPTH * ((x - 6) / (LENGTH / 2 - 6)) ** 2 * 0.8, -DEPTH)
    rings = []
    for j in range(around + 1):  # from the deck's edge at port down, under the keel, and up again
        t = -1 + 2 * j / around
        across, down = np.sin(np.pi / 2 * np.clip(1.35 * t, -1, 1)), np.clip((1 - abs(t)) / 0.45, 0, 1)
        rings.append(np.stack([x, BREADTH / 2 * fullness * across, keel * np.sin(np.pi / 2 * down)], axis=1))
    points = np.stack(rings, axis=1)  # (along, around, 3)
    deck = np.linspace(points[:, 0], points[:, -1], around // 2 + 1, axis=1)
    faces = []

    def sheet(lattice, turned):
        for i in range(lattice.shape[0] - 1):
            for j in range(lattice.shape[1] - 1):
                corners = [lattice[i, j], lattice[i + 1, j], lattice[i + 1, j + 1], lattice[i, j + 1]]
                apart = [c for k, c in enumerate(corners) if np.linalg.norm(c - corners[k - 1]) > 1e-9]  # quads shrink at the stem
                if len(apart) > 2:
                    faces.append(apart[::-1] if turned else apart)

    sheet(points, True)
    sheet(deck, False)
    stern = points[0]
    faces += [[stern.mean(axis=0), stern[j + 1], stern[j]] for j in range(around)]
    faces += [[stern.mean(axis=0), deck[0, j], deck[0, j + 1]] for j in range(around // 2)]
    with open(path, "w") as file:
        count = 0
        for corners in faces:
            for corner in corners:
                file.write("v {:.9g} {:.9g} {:.9g}\n".format(*corner))
            file.write("f " + " ".join(str(count + k + 1) for k in range(len(corners))) + "\n")
            count += len(corners)


def panels(program, folder, keys):
    """What the program makes of the hull with these keys: the picture of the panels, and how many triangles they are."""
    deck = folder / "deck.yaml"
    deck.write_text(DECK.format(keys=keys))
    subprocess.run([program, "run", deck, "--out", folder / "run", "--force"], check=True, stdout=subprocess.DEVNULL)
    subprocess.run([program, "check", deck, "--out", folder / "check"], check=True, stdout=subprocess.DEVNULL)
    report = json.loads((folder / "run/run.json").read_text())["impactors"]["ship"]
    return read_vtp(folder / "check/check/ship_surface.vtp"), report["surface"]["triangles"]


def picture(ship, fold=3):
    scene = Scene(direction=(0.9, 1.0, -0.25), up=(0, 0, 1), pixels_per_metre=24 * fold, width=470 * fold, height=270 * fold, centre=(0, 0, -1.5))
    scene.add_panels(ship.points, ship.panels, colour=(0.74, 0.77, 0.81), edge_colour=(0.35, 0.40, 0.48), edge_width=0.02)
    return scene.picture(fold)


def main():
    program = Path(sys.argv[1]).resolve()
    figure, axes = plt.subplots(1, 3, figsize=(13.5, 2.9))
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        write_hull(folder / "hull.obj")
        for axis, keys, words in zip(axes, ("", COARSEN, COARSEN + REFINE), ("as given", "coarsened within 10 mm", "refined at the bow")):
            ship, triangles = panels(program, folder, keys)
            axis.imshow(picture(ship), interpolation="antialiased")
            axis.set_title(f"{words}: {triangles} triangles", fontsize=10)
            axis.set_axis_off()
    figure.subplots_adjust(left=0.005, right=0.995, bottom=0.01, top=0.9, wspace=0.02)
    figure.savefig(HERE / "figures/remesh.png", dpi=110)


main()
