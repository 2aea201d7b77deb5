"""examples/fem_two_bars: finite elements against finite elements, by a deforming surface."""

import re
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "cli"))
from claims import claim, main  # noqa: E402


def number(text, pattern):
    return float(re.search(pattern, text)[1])


@claim("a bar of finite elements gives an equal bar its velocity as the wave equation predicts, in stress, time and impulse, and better when refined")
def exchange(scene):
    errors = []
    for cells in (30, 70):
        out = scene.expect_success(cells).out
        scene.assertLess(abs(number(out, r"contact stress.*\((\S+) %\)")), 1)
        scene.assertLess(number(out, r"momentum balance (\S+) of"), 1e-12)  # rounding of sums over thousands of nodes
        # symplectic Euler, first order in the step: one percent for 30 cells, in proportion to their size
        scene.assertLess(number(out, r", (\S+) % at the most"), 100 + 1.0 * 30 / cells)
        first, second = map(float, re.search(r"velocities after (\S+) m/s and (\S+) m/s", out).groups())
        scene.assertAlmostEqual(first + second, -0.1, delta=1.1e-5)  # equal masses; written to five digits
        errors.append([abs(number(out, rf"{word}.*\((\S+) %\)")) for word in ("contact lasts", "impulse  ")] + [100 * abs(first / 0.1)])
    coarse, fine = errors
    # the front is smeared over some cells: of 70 cells, two percent of the duration
    scene.assertLess(max(fine), 2.5)
    for a, b in zip(coarse, fine):
        scene.assertLess(b, 0.75 * a)


main()
