"""Kalthoff and Winkler's plate: which bonds the notches cut, and at which angle cracks run from them."""

import sys
import unittest
from itertools import product
from math import floor
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
CASE = ROOT / "cases/kalthoff_winkler"
sys.path[:0] = [str(ROOT / "tests/cli"), str(CASE)]
from claims import claim, main  # noqa: E402

# 101 x 50 x 4 particles 2 mm apart: the planes of the notches stay half-way between two layers
COARSE = ["--set", "bodies.plate.spacing=2 mm", "--set", "bodies.plate.shape.box.size=[202 mm, 100 mm, 8 mm]", "--set", "time.step=0.18 us"]


def module():
    try:
        import measure
    except ImportError as reason:  # numpy is missing
        raise unittest.SkipTest(str(reason)) from reason
    return measure


def bonds_through_notch(rows, layers, first_cut_row, ratio=3.015):
    """Of a lattice, in spacings: bonds of |offset| < ratio + 1/2 that cross, between two columns, a plane from half-way before row
    `first_cut_row` to the last row (rows count along the notch, layers through the thickness). On the edge counts as crossing."""
    reach = floor(ratio + 0.5)
    count = 0
    for i, j, k in product(range(1, reach + 1), range(-reach, reach + 1), range(-reach, reach + 1)):
        if i * i + j * j + k * k >= (ratio + 0.5) ** 2:
            continue
        for before in range(i):  # of the columns that lie before the plane, how far the bond's end is from the last: before + 1/2 spacings to the plane
            share = (before + 0.5) / i
            crossing = sum(0 <= y + j < rows and y + share * j > first_cut_row - 0.5 - 1e-9 for y in range(rows))
            count += crossing * max(0, layers - abs(k))
    return count


@claim("kalthoff_winkler: each notch cuts exactly the bonds that cross its plane")
def notches(scene):
    for changes, rows, layers in (([], 100, 9), (COARSE, 50, 4)):
        scene.expect_success("run", CASE / "deck.yaml", "--out", "out", "--force", *changes, "--set", "time.end=0.18 us", "--set", "output.frames=0")
        cracks = scene.report("out")["bodies"]["plate"]["cracks"]
        wanted = bonds_through_notch(rows, layers, first_cut_row=rows // 2)
        scene.assertEqual({name: crack["bonds"] for name, crack in cracks.items()}, {"left": wanted, "right": wanted})


@claim("kalthoff_winkler: with particles 2 mm apart cracks run from both notches, alike, at an angle between 60 and 75 degrees")
def coarse(scene):
    measure = module()
    scene.expect_success("run", CASE / "deck.yaml", "--out", "out", "--force", *COARSE)
    found = measure.measure(scene.folder / "out")
    print(found)
    # the experiment's 70 degrees, Silling's 68 (README.md), and what material and spacing make of it
    scene.assertGreater(found["angle [deg]"], 60)
    scene.assertLess(found["angle [deg]"], 75)
    # plate, blow and lattice are their own mirror images, so nothing but rounding can differ; one particle in the fit makes 0.3 degrees
    scene.assertAlmostEqual(found["angle right minus left [deg]"], 0, delta=0.5)
    # as expected.csv has it of the deck; a critical stretch of 0.0057 makes it 18 m/s, a coarser lattice 0.4 m/s less
    scene.assertAlmostEqual(found["projectile at 65 us [m/s]"], -16, delta=1)
    # a front is slower than Rayleigh waves: 0.919 sqrt(G/rho) at a Poisson's ratio of 1/4
    scene.assertLess(found["speed [m/s]"], 0.919 * (191e9 / 2.5 / 8000) ** 0.5)
    # all momentum of the plate comes from the projectile: to rounding of 500 steps
    for momentum in scene.history("out")["total.momentum_y [kg m/s]"]:
        scene.assertAlmostEqual(momentum, -1.57 * 32, delta=1e-9 * 1.57 * 32)


main()
