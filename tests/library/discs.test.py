"""examples/discs: two dimensions, radii, several bodies, points shared out."""

import re
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "cli"))
from claims import claim, main  # noqa: E402


@claim("discs of different sizes stay in their plane and outside of two bodies, and four parts of them turn the wheel as one whole does")
def discs(scene):
    out = scene.expect_success().out
    contacts, turned, inside, off = re.search(r"(\d+) contacts .* turned by (\S+) rad; (\d+) of 400 discs inside, none further than (\S+) m", out).groups()
    shared, apart = re.search(r"turned by (\S+) rad, discs at most (\S+) m from", out).groups()
    scene.assertGreater(int(contacts), 10000)
    scene.assertLess(float(turned), -0.1)  # discs fall on the right side
    scene.assertEqual(int(inside), 0)
    scene.assertEqual(float(off), 0)
    scene.assertEqual(shared, turned)
    scene.assertLess(float(apart), 1e-6)  # sums of the same impulses in another order, over 1000 steps


main()
