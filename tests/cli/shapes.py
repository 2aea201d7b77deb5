"""Small surfaces for tests of the command line, as vertices and faces by part, and the files that they become."""

import math
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "scripts/results"))

DEFECTS = ["boundary edge", "non-manifold edge", "non-orientable", "no volume", "self-intersection", "inside out"]


class Shape:
    """`parts`: faces by the name of their part, each face a list of corners (x, y, z)."""

    def __init__(self, parts):
        self.parts = parts

    def faces(self):
        return [face for faces in self.parts.values() for face in faces]

    def moved(self, where):
        return Shape({name: [[where(corner) for corner in face] for face in faces] for name, faces in self.parts.items()})

    def turned_over(self):
        return Shape({name: [face[::-1] for face in faces] for name, faces in self.parts.items()})

    def with_image(self, axis):
        """And its mirror image in the plane where that coordinate is 0, oriented such that normals are mirrored too."""
        image = self.moved(lambda p: tuple(-x if k == axis else x for k, x in enumerate(p))).turned_over()
        return Shape({name: faces + image.parts[name] for name, faces in self.parts.items()})

    def obj(self):
        """Faces with coincident corners share the vertex."""
        number, lines = {}, []
        for name, faces in self.parts.items():
            if name:
                lines.append(f"g {name}")
            for face in faces:
                for corner in face:
                    if corner not in number:
                        number[corner] = len(number) + 1
                        lines.append("v %.17g %.17g %.17g" % corner)
                lines.append("f " + " ".join(str(number[corner]) for corner in face))
        return "\n".join(lines) + "\n"

    def stl(self):
        """As text; faces are cut into fans."""
        lines = []
        for name, faces in self.parts.items():
            lines.append(f"solid {name}")
            for face in faces:
                for k in range(1, len(face) - 1):
                    corners = ["vertex %.17g %.17g %.17g" % corner for corner in (face[0], face[k], face[k + 1])]
                    lines += ["facet normal 0 0 0", "outer loop", *corners, "endloop", "endfacet"]
            lines.append(f"endsolid {name}")
        return "\n".join(lines) + "\n"


def grid_box(size, cells):
    """Around the origin, oriented outward, each side a grid of quads."""
    faces = []
    for axis in range(3):
        u, v = (axis + 1) % 3, (axis + 2) % 3
        for side in (0, 1):
            for i in range(cells[u]):
                for j in range(cells[v]):
                    face = []
                    for a, b in ((0, 0), (1, 0), (1, 1), (0, 1)):
                        corner = [0.0, 0.0, 0.0]
                        corner[axis] = size[axis] * (side - 0.5)
                        corner[u], corner[v] = size[u] * ((i + a) / cells[u] - 0.5), size[v] * ((j + b) / cells[v] - 0.5)
                        face.append(tuple(corner))
                    faces.append(face if side else face[::-1])
    return Shape({"": faces})


def prism(section, height):
    """Over a polygon in x and y that runs counterclockwise; its ends are fans about the mean of the corners."""
    n = len(section)
    middle = tuple(sum(p[k] for p in section) / n for k in (0, 1))
    at = lambda k, z: (*section[k % n], z)
    sides = [[at(k, 0.0), at(k + 1, 0.0), at(k + 1, height), at(k, height)] for k in range(n)]
    ends = [[at(k + 1, 0.0), at(k, 0.0), (*middle, 0.0)] for k in range(n)] + [[at(k, height), at(k + 1, height), (*middle, height)] for k in range(n)]
    return Shape({"": sides + ends})


def half_hull(length=12000.0, beam=2400.0, draft=1500.0, along=24, down=8):
    """The side y > 0 of Wigley's hull, y = B/2 (1 - (2 x/L)²) (1 - (z/T)²), and its deck; open where y = 0."""
    x = [length * (i / along - 0.5) for i in range(along + 1)]
    z = [-draft * (1 - j / down) for j in range(down + 1)]
    y = lambda x, z: beam / 2 * (1 - (2 * x / length) ** 2) * (1 - (z / draft) ** 2)
    shell = [[(x[i + a], y(x[i + a], z[j + b]), z[j + b]) for a, b in ((1, 0), (0, 0), (0, 1), (1, 1))] for i in range(along) for j in range(down)]
    deck = [[(x[i + a], b * y(x[i + a], 0.0), 0.0) for a, b in ((0, 0), (1, 0), (1, 1), (0, 1))] for i in range(along)]
    return Shape({"shell": shell, "deck": deck})


def moebius(panels=12):
    """A band with half a twist."""
    at = lambda k, s: ((1 + 0.3 * s * math.cos(math.pi * k / panels)) * math.cos(2 * math.pi * k / panels),
                       (1 + 0.3 * s * math.cos(math.pi * k / panels)) * math.sin(2 * math.pi * k / panels), 0.3 * s * math.sin(math.pi * k / panels))
    edge = [(at(k, -1), at(k, 1)) for k in range(panels)]
    edge.append(edge[0][::-1])
    return Shape({"": [[edge[k][0], edge[k + 1][0], edge[k + 1][1], edge[k][1]] for k in range(panels)]})


def two_rooms():
    """A box of 1 x 1 x 2 with a wall across its middle, which hangs on the sides: face 10."""
    square = lambda z: [(0.0, 0.0, z), (1.0, 0.0, z), (1.0, 1.0, z), (0.0, 1.0, z)]
    sides = [[square(z)[k], square(z)[(k + 1) % 4], square(z + 1)[(k + 1) % 4], square(z + 1)[k]] for z in (0.0, 1.0) for k in range(4)]
    return Shape({"": [square(0.0)[::-1], square(2.0)] + sides + [square(1.0)]})


def folded_prism():
    """One side, face 3 from (0, 2) to (0.5, -0.5), exits through face 0 from (0, 0) to (3, 0), so that what lies below is inside out."""
    return prism([(0.0, 0.0), (3.0, 0.0), (3.0, 2.0), (0.0, 2.0), (0.5, -0.5), (1.0, -0.5)], 1.0)


def defects(path):
    """The panels of a file of defects, by kind."""
    from vtp_reader import read_vtp

    picture = read_vtp(path)
    found = {}
    for kind, panel in zip(picture.cell["defect"].tolist(), picture.cell["panel"].tolist()):
        found.setdefault(DEFECTS[kind], []).append(panel)
    return found
