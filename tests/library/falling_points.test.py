"""examples/falling_points on meshes whose interior is known in closed form."""

import math
import sys
from pathlib import Path
from unittest import SkipTest

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "cli"))
from claims import claim, main  # noqa: E402

BALL = 0.02  # contact radius of the example


def points(scene):
    rows = [line.split(",") for line in (scene.folder / "falling_points.csv").read_text().splitlines()]
    return [tuple(map(float, row[:3])) for row in rows], [row[3] == "1" for row in rows]


def write_obj(path, vertices, faces):
    lines = ["v %.17g %.17g %.17g" % tuple(v) for v in vertices] + ["f " + " ".join(str(i + 1) for i in f) for f in faces]
    path.write_text("\n".join(lines) + "\n")


def distance_to_rhombus(x, y, a, b):
    """Distance from the filled rhombus |x|/a + |y|/b <= 1, in its plane."""
    x, y = abs(x), abs(y)
    if x / a + y / b <= 1:
        return 0
    along = min(1, max(0, ((x - a) * -a + y * b) / (a * a + b * b)))  # on the edge from (a, 0) to (0, b)
    return math.hypot(x - (a - along * a), y - along * b)


@claim("balls above an octahedron land if they are above it or within their radius of it, and none ends inside")
def octahedron(scene):
    a, b, c = 1.5, 1.3, 0.8
    vertices = [(a, 0, 0), (-a, 0, 0), (0, b, 0), (0, -b, 0), (0, 0, c), (0, 0, -c)]
    faces = [(0, 2, 4), (2, 1, 4), (1, 3, 4), (3, 0, 4), (2, 0, 5), (1, 2, 5), (3, 1, 5), (0, 3, 5)]
    write_obj(scene.folder / "octahedron.obj", vertices, faces)
    out = scene.expect_success("octahedron.obj").out
    places, landed = points(scene)
    expected = []
    for i in range(41 * 41):  # the sheet of the example
        distance = distance_to_rhombus(0.6 * 2 * a * (i % 41 - 20) / 20, 0.6 * 2 * b * (i // 41 - 20) / 20, a, b)
        scene.assertGreater(abs(distance - BALL), 1e-6, "a ball that just touches decides nothing")
        expected.append(distance < BALL)
    scene.assertEqual([i for i in range(41 * 41) if landed[i] != expected[i]], [])
    scene.assertEqual(out, f"{sum(expected)} of 1681 points landed, 0 are inside\n")
    # rounding of coordinates of 20 m, those of the points that fell past
    scene.assertGreater(min(abs(x) / a + abs(y) / b + abs(z) / c for x, y, z in places), 1 - 1e-12)


@claim("by the winding number no point is inside a torus on which many have come to rest")
def torus(scene):
    try:
        import numpy as np
    except ImportError as missing:
        raise SkipTest(str(missing))
    around, across = 32, 16
    u, v = np.meshgrid(2 * np.pi * np.arange(around) / around, 2 * np.pi * np.arange(across) / across, indexing="ij")
    r = 1 + 0.35 * np.cos(v)
    vertices = np.stack([r * np.cos(u), r * np.sin(u), 0.35 * np.sin(v)], axis=-1).reshape(-1, 3)
    at = lambda i, j: (i % around) * across + j % across  # noqa: E731
    quads = [(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)) for i in range(around) for j in range(across)]
    triangles = [t for q in quads for t in ((q[0], q[1], q[2]), (q[0], q[2], q[3]))]
    write_obj(scene.folder / "torus.obj", vertices, triangles)
    scene.expect_success("torus.obj")
    places = np.array(points(scene)[0])
    resting = places[:, 2] > -1
    scene.assertGreater(resting.sum(), 100)
    # van Oosterom, Strackee, IEEE Transactions on Biomedical Engineering 30 (1983) 125
    corners = vertices[np.array(triangles)][None] - places[resting][:, None, None]
    a, b, c = (corners[:, :, k] for k in range(3))
    la, lb, lc = (np.linalg.norm(corners[:, :, k], axis=-1) for k in range(3))
    dot = lambda p, q: (p * q).sum(-1)  # noqa: E731
    angle = 2 * np.arctan2(dot(a, np.cross(b, c)), la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb)
    winding = angle.sum(-1) / (4 * np.pi)
    scene.assertLess(np.abs(winding).max(), 1e-6)  # 0 outside, 1 inside; rounding of a sum of a thousand angles


@claim("an unreadable mesh is reported in a sentence")
def unreadable(scene):
    scene.expect_complaint(scene.run_program("hull.stl"), 2, "hull.stl: there is no such file")


main()
