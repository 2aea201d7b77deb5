"""examples/discs: two dimensions, different radii, several bodies, distributed points."""

import re
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "cli"))
from claims import claim, main  # noqa: E402


@claim("discs of different sizes remain in their plane and outside two bodies, and four processes turn the wheel as one does")
def discs(scene):
    out = scene.expect_success().out
    contacts, turned, inside, off = re.search(r"(\d+) contacts .* turned by (\S+) rad; (\d+) of 400 discs inside, at most (\S+) m off", out).groups()
    shared, apart = re.search(r"turned by (\S+) rad, discs at most (\S+) m from", out).groups()
    scene.assertGreater(int(contacts), 10000)
    scene.assertLess(float(turned), -0.1)  # discs fall on the right side
    scene.assertEqual(int(inside), 0)
    scene.assertEqual(float(off), 0)
    scene.assertEqual(shared, turned)
    scene.assertLess(float(apart), 1e-5)  # sums of the same impulses in another order, over 1000 steps: 1.9e-6 was measured


main()
