"""Results approach exact solutions as the spacing falls (docs/theory/convergence.md). Python: Debian's, with numpy."""

import json
import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
sys.path[:0] = [str(ROOT / "tests/cli"), str(Path(__file__).resolve().parent)]
from claims import claim, main  # noqa: E402

try:
    import numpy as np
    from problems import SPEED, STRESS, YOUNG, Body, HoleInSquare, PROBLEMS, Result, lattice_moduli, love_bar
except ImportError:
    np = None


def errors(scene, problem, *bodies):
    """The problem's errors for each body."""
    if np is None:
        raise unittest.SkipTest("numpy is not installed")

    def run(name, deck):
        folder = scene.folder / name.replace(" ", "_")
        folder.mkdir()
        (folder / "deck.yaml").write_text(json.dumps(deck))
        scene.expect_success("run", folder / "deck.yaml", "--out", folder / "out", "--threads", "1")
        return Result(folder / "out")

    return [PROBLEMS[problem](body, run)[1] for body in bodies]


def expect_fall(scene, found, quantity, by, last):
    """From each body to the next the error falls at least by the factor; that of the last is below `last`."""
    sizes = [abs(one[quantity]) for one in found]
    for before, after in zip(sizes, sizes[1:]):
        scene.assertLess(after, before / by, f"{quantity}: {sizes}")
    scene.assertLess(sizes[-1], last, f"{quantity}: {sizes}")


@claim("convergence: the exact solutions are exact where others are known")
def oracles(scene):
    if np is None:
        raise unittest.SkipTest("numpy is not installed")
    # Kirsch: three times the stress at the edge of a small hole, 1 + a²/2r² + 3a⁴/2r⁴ beside it. With W = 1000 a the difference is of the
    # order (a/W)² times some ten.
    small = HoleInSquare(1, 1000, 0.3, terms=12)
    beside = small.strain_xx(np.zeros(1), np.ones(1))[0] * YOUNG / STRESS
    scene.assertAlmostEqual(beside, 3, delta=2e-5)
    # the edge moves by 3 σ a/E along the pull and −σ a/E across
    scene.assertAlmostEqual(small.displacement(np.ones(1), np.zeros(1))[0, 0] * YOUNG / STRESS, 3, delta=2e-5)
    scene.assertAlmostEqual(small.displacement(np.zeros(1), np.ones(1))[0, 1] * YOUNG / STRESS, -1, delta=2e-5)
    # tractions that are left over on the edges of the plate that is used, of the far stress: at the corners, where angles change
    scene.assertLess(HoleInSquare(1, 5, 0.3).left_over, 1e-4)
    # Love's bar without inertia across is d'Alembert's. A pulse of 0.4 m in bits of 20 µm, in waves down to 1 mm
    time = 0.7 / SPEED
    fine = np.linspace(0, 1 / SPEED, 100_001)
    pressure = STRESS * np.where(fine < 0.4 / SPEED, np.sin(np.pi * fine * SPEED / 0.4) ** 2, 0)
    impulse = np.concatenate([[0], np.cumsum(0.5 * (pressure[1:] + pressure[:-1]) * np.diff(fine))])
    x = np.linspace(0, 1, 200)
    exact = SPEED / YOUNG * np.interp(time - x / SPEED, fine, impulse, left=0)
    scene.assertLess(np.abs(love_bar(x, time, fine, pressure, 0) - exact).max(), 1e-4 * exact.max())


@claim("convergence: a bar pulled at both ends")
def bar(scene):
    # The layer that lacks neighbours is as thick as the horizon, so its share falls by 2 when the spacing is halved; what the correction
    # leaves of it must do so at least. 1 %: the page's rule for eight layers.
    found = errors(scene, "bar", Body(4), Body(8))
    expect_fall(scene, found, "strain", by=2, last=0.01)
    expect_fall(scene, found, "extension", by=2, last=0.02)  # with the ends, which add a share of a spacing's strain
    # Without a correction it is that layer alone: half the error for half the spacing, but for terms of second order, here 4 %.
    before, after = errors(scene, "bar", *(Body(n, plane="stress", correction="none") for n in (8, 16)))
    scene.assertAlmostEqual(before["strain"] / after["strain"], 2, delta=0.2)
    # Correspondence is exact in uniform strain; 1e-4 is far above what the ends, a quarter of the bar away, and the relaxation add.
    (exact,) = errors(scene, "bar", Body(8, model="correspondence"))
    scene.assertAlmostEqual(exact["strain"], 0, delta=1e-4)
    scene.assertAlmostEqual(exact["contraction"], 0, delta=1e-4)


@claim("convergence: at a fixed horizon ratio Poisson's ratio goes to that of the lattice, not to the one asked for")
def contraction(scene):
    # 1 %: what the surfaces add, whose cut layers are a quarter of the height with 24 layers; asked for is −6 % of ν
    (found,) = errors(scene, "bar", Body(24, plane="stress"))
    expected = lattice_moduli(3.015, 0.3, "stress")["ν"] - 1
    scene.assertLess(expected, -0.05)
    scene.assertAlmostEqual(found["contraction"], expected, delta=0.01)


@claim("convergence: a pulse that runs through a bar")
def pulse(scene):
    # of second order, as the bar's stiffness is: 4 for half the spacing, and 3 are asked for, because 4 layers are few
    found = errors(scene, "pulse", Body(4), Body(8))
    expect_fall(scene, found, "field", by=3, last=0.01)
    expect_fall(scene, found, "speed", by=3, last=0.005)


@claim("convergence: a cantilever with a load at its end")
def cantilever(scene):
    # the stiffness is of second order: 4 for half the spacing, and 3 are asked for
    found = errors(scene, "cantilever", *(Body(n, plane="stress") for n in (4, 8, 16)))
    expect_fall(scene, found, "stiffness", by=3, last=0.02)  # lattice.md: plates have 0.98 of their stiffness from twelve layers on
    expect_fall(scene, found, "tip", by=2.5, last=0.04)  # with the clamp, which gives way by a share of the spacing: of first order


@claim("convergence: a plate with a hole")
def hole(scene):
    # The staircase of the edge leaves its radius uncertain by a share of the spacing: of first order, but uneven, so a factor of 1.7 is asked for
    # where 2 is meant. With m = 4, where the lattice's shear modulus is within 1.5 % (at 3.015 it is 6 % off and the error stays at 1.5 %).
    found = errors(scene, "hole", *(Body(n, plane="stress", horizon=4) for n in (4, 8)))
    expect_fall(scene, found, "field", by=1.7, last=0.02)


main()
