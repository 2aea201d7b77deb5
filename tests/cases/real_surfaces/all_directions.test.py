"""Every surface with panels, whatever it was made for, strikes from several directions."""

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


def files(t, closed):
    """(path, corners, spacing: an eightieth of the size) of all closed surfaces, or of all open ones."""
    for path in surfaces.all_files():
        plain = surface_file.read(path)
        if plain is None or plain.panels == 0:
            continue
        closure = re.search(r"^  closure +(closed|open)", t.expect_success("mesh", path).out, re.MULTILINE)
        if (closure[1] == "closed") == closed:
            points = plain.corners.reshape(-1, 3)
            yield path, plain.corners, float((points.max(axis=0) - points.min(axis=0)).max() / 80)


@claim("real surfaces: every closed surface of OpenFOAM's examples displaces every particle in its path, in all six directions")
def _(t):
    for path, corners, spacing in files(t, closed=True):
        for direction in ("+x", "-x", "+y", "-y", "+z", "-z"):
            outcome = impact.run(t, path, corners, direction, spacing, None)
            t.assertEqual((outcome.touched, outcome.entered, outcome.crossed), (True, 0, 0), (path, direction))


@claim("real surfaces: every open surface of OpenFOAM's examples runs with either side outside, and keeps momentum")
def _(t):
    for path, corners, spacing in files(t, closed=False):
        for direction, outside in (("+x", "normals"), ("-y", "reversed"), ("+z", "normals")):
            impact.run(t, path, corners, direction, spacing, outside)


main()
