"""examples/own_arrays: the Points interface."""

import re
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "cli"))
from claims import claim, main  # noqa: E402


@claim("a solver accessed in place finds the contacts of the plain call, queries few points, and conserves momentum to rounding")
def in_place(scene):
    out = scene.expect_success().out
    contacts, agreed = map(int, re.match(r"(\d+) contacts, the plain call found the same in (\d+) of 100 steps", out).groups())
    tested = float(re.search(r"(\S+) of 20000 grains a step", out)[1])
    error = float(re.search(r"gained: (\S+) of what", out)[1])
    scene.assertGreater(contacts, 10000)
    scene.assertEqual(agreed, 100)
    scene.assertLess(tested, 2000)
    scene.assertLess(error, 1e-11)  # rounding of 20 000 grains in a sum that cancels to a hundredth


main()
