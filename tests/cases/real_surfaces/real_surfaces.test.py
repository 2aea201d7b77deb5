"""Surfaces that engineers have: all are read or refused in one sentence, and what is read strikes as it should."""

import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
sys.path[:0] = [str(ROOT / "tests/cli"), str(ROOT / "scripts/results")]
from claims import claim, main  # noqa: E402

try:
    import impact  # noqa: E402
    import surface_file  # noqa: E402
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(77)
import surfaces  # noqa: E402

def expect_all_struck(t, named):
    for one in named:
        path = surfaces.file_named(one.name)
        corners = surface_file.read(path).corners
        for direction, outside in one.strikes.items():
            result = impact.run(t, path, corners, direction, one.spacing, outside)
            t.assertEqual((result.touched, result.entered, result.crossed), (True, 0, 0), (one.name, direction))


@claim("real surfaces: every file of OpenFOAM's examples with panels is read, to the last panel, and every other one refused in one sentence")
def _(t):
    for path in surfaces.all_files():
        plain = surface_file.read(path)
        done = t.run_program("mesh", path)
        if plain is None or plain.panels == 0:
            t.expect_complaint(done, 2, f"{path}:")
            continue
        t.assertEqual((done.code, done.err), (0, ""), path)
        rows = dict(re.findall(r"^  ([a-z]+) {2,}(.*)$", done.out, re.MULTILINE))
        t.assertEqual(int(rows["panels"].split()[0]), plain.panels, path)
        points = plain.corners.reshape(-1, 3)
        for shown, extent in zip(rows["size"].removesuffix(" m").split(" x "), points.max(axis=0) - points.min(axis=0), strict=True):
            t.assertAlmostEqual(float(shown), extent, delta=5.001e-4 * extent, msg=path)  # four digits are shown


@claim("real surfaces: hull, buildings, fan, bullet, flange and car, all closed, push every particle out of their way")
def _(t):
    expect_all_struck(t, surfaces.CLOSED)


@claim("real surfaces: open hulls, propeller and motorcycle are in contact with their outer side, and no particle penetrates")
def _(t):
    expect_all_struck(t, surfaces.OPEN)


@claim("real surfaces: an open hull whose outside is said the wrong way round lets particles through, and the run tells how many")
def _(t):
    (hull,) = (one for one in surfaces.OPEN if one.name == "wigley.stl")
    path = surfaces.file_named(hull.name)
    result = impact.run(t, path, surface_file.read(path).corners, "+x", hull.spacing, "normals")
    t.assertFalse(result.touched)
    t.assertGreater(result.crossed, 10)
    t.assertEqual(result.entered, result.crossed)


main()
