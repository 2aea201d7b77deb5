"""examples/sph_membrane: smoothed particles on a deforming surface."""

import re
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "cli"))
from claims import claim, main  # noqa: E402


def numbers(text, pattern):
    return [float(word) for word in re.search(pattern, text).groups()]


@claim("water that falls on a membrane stays above it, bends it, loses energy, and its momentum is that of membrane, border and gravity to rounding")
def membrane(scene):
    out = scene.expect_success(0.05).out
    sag, expected = numbers(out, r"own weight: (\S+) mm, by .* (\S+) mm")
    scene.assertAlmostEqual(expected, 1e3 * 20 * 9.81 * 0.5**2 / (4 * 4000), delta=1e-3)
    scene.assertLess(abs(sag - expected), 0.002 * expected)  # twelve rings of linear triangles: 0.05 % was measured
    scene.assertGreater(numbers(out, r"(\d+) contacts")[0], 10000)
    scene.assertIn("particles below the membrane: 0;", out)
    scene.assertLess(numbers(out, r"middle at (\S+) m")[0], -0.05)
    before, largest, after = numbers(out, r"before (\S+) J, largest (\S+) J, after (\S+) J")
    scene.assertEqual(largest, before)
    scene.assertLess(after, 0.8 * before)
    # rounding of 400 particles and nodes over 600 steps: 1e-16 times the root of the number of terms
    scene.assertLess(numbers(out, r"gravity: (\S+) of that of the water")[0], 1e-12)


@claim("the membrane and the water on it move bitwise identically on one thread and on three")
def threads(scene):
    outputs = []
    for count in ("1", "3"):
        scene.environment["OMP_NUM_THREADS"] = count
        outputs.append(scene.expect_success(0.06).out)
    scene.assertEqual(*outputs)


main()
