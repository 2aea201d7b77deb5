"""examples/grains: grains in a tray that is shaken, in Fortran."""

import re
import sys
from pathlib import Path
from unittest import SkipTest

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "cli"))
from claims import claim, main  # noqa: E402


def output(scene, amplitude):
    if not Path(scene.program).exists():
        raise SkipTest("there is no Fortran compiler")
    return scene.expect_success(amplitude).out


def number(text, pattern):
    return float(re.search(pattern, text)[1])


@claim("grains in a shaken tray never leave it, and their momentum and the impulse on the tray balance gravity to rounding")
def shaken(scene):
    out = output(scene, 0.02)
    scene.assertIn(" 0 grains ever outside", out)
    scene.assertGreater(number(out, r"(\d+) contacts"), 10000)
    scene.assertLess(number(out, r"gravity:\s+(\S+) of the latter"), 1e-12)  # rounding of sums over 4000 steps
    # two periods of 0.2 s, in which grains change their momentum by a few percent of the impulse of gravity
    scene.assertLess(abs(number(out, r"/ weight:\s+(\S+);") - 1), 0.1)
    scene.assertGreater(number(out, r"largest:\s+(\S+)"), 5)  # they are thrown up and fall


@claim("grains in a tray at rest come to rest, and press on it with their weight")
def at_rest(scene):
    out = output(scene, 0)
    scene.assertIn(" 0 grains ever outside", out)
    scene.assertLess(number(out, r"at the end:\s+(\S+) J"), 1e-4)  # they fell with 30 J
    scene.assertLess(abs(number(out, r"/ weight:\s+(\S+);") - 1), 1e-3)


@claim("a Fortran program gets the sentence of what fccda refuses")
def refused(scene):
    if not Path(scene.program).exists():
        raise SkipTest("there is no Fortran compiler")
    scene.expect_complaint(scene.run_program("NaN"), 2, "rigid body: ")


main()
