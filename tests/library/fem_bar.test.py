"""examples/fem_bar: finite elements."""

import re
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "cli"))
from claims import claim, main  # noqa: E402


def number(text, pattern):
    return float(re.search(pattern, text)[1])


@claim("a bar of finite elements rebounds from a wall as the wave equation predicts, in stress, time and impulse, and converges with refinement")
def wall(scene):
    errors = []
    for cells in (30, 50):
        text = scene.expect_success(cells).out.split("wedge,")[0]
        # mean over the middle of the contact; the waves behind the front do not average out completely
        scene.assertLess(abs(number(text, r"contact stress.*\((\S+) %\)")), 0.5)
        errors.append([abs(number(text, rf"{word}.*\((\S+) %\)")) for word in ("contact lasts", "impulse  ")])
        scene.assertLess(number(text, r"momentum balance (\S+)"), 1e-12)  # rounding of the sums over nodes
        scene.assertLess(abs(number(text, r"energy balance\s+(\S+) %")), 0.3)  # symplectic Euler, first order in the step
        # the end nodes stop: they carry half a cell and its share of the energy
        scene.assertLess(abs(number(text, r"nodes stop (\S+) %") - 100 * 0.5 / cells), 0.3)
    coarse, fine = errors
    # half a cell of nodes stops plastically and the front is smeared over some cells: of 50 cells, two percent
    scene.assertLess(max(fine), 2)
    for a, b in zip(coarse, fine):
        scene.assertLess(b, 0.75 * a)


@claim("a bar that hits a free wedge transfers its momentum loss to it, and no node is inside")
def wedge(scene):
    text = scene.expect_success(50).out.split("wedge,")[1]
    scene.assertIn("nodes inside     0\n", text)
    scene.assertLess(number(text, r"momentum balance (\S+)"), 1e-12)
    scene.assertLess(abs(number(text, r"energy balance\s+(\S+) %")), 0.3)
    # The body moves with the impulses of the previous step: a first-order error, here 0.6 % of energy.
    scene.assertLess(abs(number(text, r"left (\S+) %") - 100), 1.5)
    wedge, bar = (number(text, pattern) for pattern in (r"wedge leaves at\s+(\S+) m/s", r"on average at\s+(\S+) m/s"))
    scene.assertLess(wedge, bar)  # they separate
    scene.assertLess(abs(wedge - -3.51), 0.03)  # finer bars of 70 and 90 cells give -3.514 and -3.52
    scene.assertAlmostEqual(wedge + bar, -4, delta=1.1e-4)  # equal masses; written to four digits


main()
