#!/usr/bin/env python3
"""Writes submarine.obj: a body of revolution with a sail, one closed surface in two parts, hull and sail.

    cases/submarine_surfacing/make_submarine.py > cases/submarine_surfacing/submarine.obj

x points ahead, z up, the axis is at z = 0 and amidships at x = 0. At each station the hull is an arc from the keel up to the sail,
or to the crown; the sail has vertical sides and a rounded top. It tapers to edges ahead and astern.
"""

import argparse
import math

LENGTH, DIAMETER = 60.0, 8.0
NOSE, TAIL = 8.0, 20.0  # of the length: half an ellipsoid, and a paraboloid
SAIL_ASTERN, SAIL_AHEAD = 2.0, 12.0  # x of its edges
SAIL_HEIGHT, SAIL_BREADTH = 3.0, 2.0  # above the crown of the hull
SAIL_TOP = 0.6  # height of its rounded part
PANEL = 0.8


def hull_radius(x):
    ahead, astern = LENGTH / 2 - NOSE, -LENGTH / 2 + TAIL
    if x > ahead:
        return DIAMETER / 2 * math.sqrt(max(0, 1 - ((x - ahead) / NOSE) ** 2))
    if x < astern:
        return DIAMETER / 2 * (1 - ((astern - x) / TAIL) ** 2)
    return DIAMETER / 2


def sail_half_breadth(x):
    """An ellipse of two halves, fullest at 60 % of the sail's length."""
    fullest = SAIL_ASTERN + 0.6 * (SAIL_AHEAD - SAIL_ASTERN)
    reach = SAIL_AHEAD - fullest if x > fullest else fullest - SAIL_ASTERN
    return SAIL_BREADTH / 2 * math.sqrt(max(0, round(1 - ((x - fullest) / reach) ** 2, 9)))


def spread(start, end, longest):
    count = max(1, math.ceil(abs(end - start) / longest - 1e-9))
    return [start + (end - start) * k / count for k in range(count + 1)]


def stations():
    """Dense where nose and sail edges are curved."""
    ahead, astern = LENGTH / 2 - NOSE, -LENGTH / 2 + TAIL
    tail = spread(astern - TAIL, astern, PANEL)
    nose = [ahead + NOSE * math.sin(angle) for angle in spread(0, math.pi / 2, PANEL / NOSE)]
    middle, reach = (SAIL_AHEAD + SAIL_ASTERN) / 2, (SAIL_AHEAD - SAIL_ASTERN) / 2
    sail = [middle + reach * math.sin(angle) for angle in spread(-math.pi / 2, math.pi / 2, PANEL / reach)]
    between = spread(astern, SAIL_ASTERN, PANEL)[1:-1], spread(SAIL_AHEAD, ahead, PANEL)[1:-1]
    return tail + between[0] + sail + between[1] + nose


def section(x, around, up, over):
    """Points (y, z) on the port side: of the hull from keel to sail, and of the sail from hull to top."""
    radius, half = hull_radius(x), min(sail_half_breadth(x), hull_radius(x))
    root = math.asin(half / radius) if radius > 0 else 0
    arc = [(radius * math.sin(math.pi - (math.pi - root) * k / around), radius * math.cos(math.pi - (math.pi - root) * k / around)) for k in range(around + 1)]
    foot, shoulder = arc[-1][1], DIAMETER / 2 + SAIL_HEIGHT - SAIL_TOP
    side = [(half, foot + (shoulder - foot) * k / up) for k in range(up + 1)]
    angles = [math.pi / 2 * k / over for k in range(1, over + 1)]
    return arc, side + [(half * math.cos(angle), shoulder + SAIL_TOP * math.sin(angle)) for angle in angles]


class Mesh:
    def __init__(self):
        self.number, self.lines = {}, []

    def vertex(self, *place):
        key = tuple(round(c, 6) + 0.0 for c in place)
        if key not in self.number:
            self.number[key] = len(self.number) + 1
            self.lines.append("v {:.7g} {:.7g} {:.7g}".format(*key))
        return self.number[key]

    def panel(self, *corners):
        if all(abs(y) < 1e-9 for _, y, _ in corners):
            return  # at the edges of the sail both sides coincide
        corners = [self.vertex(*corner) for corner in corners]
        corners = [c for k, c in enumerate(corners) if c != corners[k - 1]]  # at nose, tail and edges two corners coincide
        if len(corners) > 2:
            self.lines.append("f " + " ".join(map(str, corners)))

    def strip(self, x, x_next, line, line_next):
        """Both sides between two stations, normals outward."""
        for (a, b), (c, d) in zip(zip(line, line[1:]), zip(line_next, line_next[1:])):
            port = [(x, *a), (x, *b), (x_next, *d), (x_next, *c)]
            self.panel(*port)
            self.panel(*[(px, -py, pz) for px, py, pz in reversed(port)])


def main():
    argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter).parse_args()
    around = math.ceil(math.pi * DIAMETER / 2 / PANEL)
    up = math.ceil((SAIL_HEIGHT - SAIL_TOP) / PANEL)
    xs = stations()
    sections = [section(x, around, up, over=3) for x in xs]
    mesh = Mesh()
    for part, line in (("hull", 0), ("sail", 1)):
        mesh.lines.append(f"g {part}")
        for k in range(len(xs) - 1):
            if part == "hull" or SAIL_ASTERN - 1e-9 < 0.5 * (xs[k] + xs[k + 1]) < SAIL_AHEAD:
                mesh.strip(xs[k], xs[k + 1], sections[k][line], sections[k + 1][line])
    print("# A submarine of 60 m, made by make_submarine.py [m]")
    print("\n".join(mesh.lines))


main()
