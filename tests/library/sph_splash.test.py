"""examples/sph_splash: smoothed particles."""

import re
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "cli"))
from claims import claim, main  # noqa: E402


def points_of(path):
    lines = path.read_text().splitlines()
    start = next(i for i, line in enumerate(lines) if line.startswith("POINTS"))
    count = int(lines[start].split()[1])
    return [tuple(map(float, line.split())) for line in lines[start + 1 : start + 1 + count]]


def planes_of(path):
    """(outward normal, distance) of each polygon of a closed mesh."""
    vertices, planes = points_of(path), []
    for line in path.read_text().split("POLYGONS")[1].splitlines()[1:]:
        a, b, c = (vertices[int(word)] for word in line.split()[1:4])
        u, v = ([q - p for p, q in zip(a, other)] for other in (b, c))
        n = (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
        length = sum(x * x for x in n) ** 0.5
        planes.append(([x / length for x in n], sum(x * y for x, y in zip(n, a)) / length))
    return planes


@claim("no water particle is ever inside the hull, and the momentum of water and hull balances gravity to rounding")
def splash(scene):
    out = scene.expect_success(0.04, 8).out
    contacts = int(re.search(r"(\d+) contacts", out)[1])
    scene.assertGreater(contacts, 10000)
    scene.assertIn("particles ever inside the hull: 0\n", out)
    # rounding of 1200 particles over 800 steps: 1e-16 times the root of a million, and the sums of pairs, which cancel
    scene.assertLess(float(re.search(r"gravity: (\S+) of the momentum", out)[1]), 1e-12)
    scene.assertGreater(-float(re.search(r"impulse on the hull: (\S+) N s", out)[1]), 50)  # the block is largely stopped

    planes = planes_of(scene.folder / "splash_hull.vtk")
    frames = sorted(scene.folder.glob("splash_00*.vtk"))
    scene.assertEqual(len(frames), 9)
    for frame in frames:
        for x in points_of(frame):
            beyond = max(sum(n * each for n, each in zip(normal, x)) - distance for normal, distance in planes)
            scene.assertGreater(beyond, -1e-8, f"{frame.name}: {x} is inside")  # coordinates are written to nine digits
    last = points_of(frames[-1])
    scene.assertGreater(min(sum(y > 0.25 for _, y, _ in last), sum(y < -0.25 for _, y, _ in last)), 100)  # it was divided by the keel


@claim("the splash is bitwise identical on one thread and on three")
def threads(scene):
    frames = []
    for count in ("1", "3"):
        scene.environment["OMP_NUM_THREADS"] = count
        scene.expect_success(0.05, 4)
        frames.append([path.read_text() for path in sorted(scene.folder.glob("splash_*.vtk"))])
    scene.assertTrue(frames[0] == frames[1])  # assertEqual would diff megabytes


main()
