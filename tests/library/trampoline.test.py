"""examples/trampoline: grains on a deforming surface, in C."""

import math
import re
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "cli"))
from claims import claim, main  # noqa: E402

CELLS, TENSION, KNOT_MASS, GRAIN_MASS, RADIUS, GRAVITY = 20, 500, 0.01, 0.3, 0.05, 9.81  # of the example


def number(text, pattern):
    return float(re.search(pattern, text)[1])


def compliance():
    """Displacement of the middle of the square net, in units of the force over the tension of its springs: of the same force on every knot inside, and of
    one force there. The modes of the discrete Laplacian are products of sines."""
    inner, modes = range(1, CELLS), []
    total = {p: sum(math.sin(math.pi * p * i / CELLS) for i in inner) for p in inner}
    for p in inner:
        for q in inner:
            stiffness = 4 * math.sin(math.pi * p / 2 / CELLS) ** 2 + 4 * math.sin(math.pi * q / 2 / CELLS) ** 2
            at_middle = math.sin(p * math.pi / 2) * math.sin(q * math.pi / 2)
            modes.append((4 / CELLS**2 * at_middle / stiffness, total[p] * total[q], at_middle))
    return sum(a * on_all for a, on_all, _ in modes), sum(a * on_one for a, _, on_one in modes)


@claim("a grain comes to rest on a net where the tension of the springs balances its weight and that of the net")
def sag(scene):
    out = scene.expect_success(1).out
    on_all, on_one = compliance()
    expected = -(on_all * KNOT_MASS + on_one * GRAIN_MASS) * GRAVITY / TENSION
    # Friction makes the force of the grain vertical, through its centre above the knot: 0.04 % off. Without friction the net was 0.3 % less deep, and with
    # friction up to the limit of Coulomb, which rocks the grain, 1.0 % deeper.
    found = number(out, r"net at its middle: (\S+) m")
    scene.assertLess(abs(found - expected), 0.002 * abs(expected))
    above = number(out, r"first grain (\S+) m above")
    scene.assertGreater(above, RADIUS)  # between the panels that fall towards the knot
    scene.assertLess(above, 1.002 * RADIUS)  # 1/cos of their slope
    scene.assertLess(abs(number(out, r"/ weight: (\S+)") - 1), 1e-4)
    balanced(scene, out, growth=0.025)


def balanced(scene, out, growth):
    """`growth`: symplectic Euler conserves a quantity that differs from the energy in proportion to the step; of the energy that was lost."""
    scene.assertLess(number(out, r"gravity: (\S+) of the latter"), 1e-12)  # rounding
    lost, grown = re.search(r"energy: lost (\S+) J, largest growth from any earlier time (\S+) J", out).groups()
    scene.assertGreater(float(lost), 0)
    scene.assertLess(float(grown), growth * float(lost))


@claim("a heap of grains rests on a net, none falls through, and the border carries its weight")
def heap(scene):
    out = scene.expect_success(32).out
    scene.assertGreater(number(out, r"lowest grain at (\S+) m"), -0.2)
    scene.assertGreater(number(out, r"(\d+) contacts"), 100000)
    scene.assertLess(abs(number(out, r"/ weight: (\S+)") - 1), 0.01)  # the heap still moves a little
    balanced(scene, out, growth=0.025)


@claim("a number of grains for which the example has no memory is refused in a sentence")
def refused(scene):
    scene.expect_complaint(scene.run_program(90), 2, "trampoline: give a number of grains from 1 to 64")


main()
