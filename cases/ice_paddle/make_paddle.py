#!/usr/bin/env python3
"""Writes paddle.obj: a wheel of four flat blades sunk in a hub, about the z axis, each part in a separate group.

    cases/ice_paddle/make_paddle.py > cases/ice_paddle/paddle.obj

The parts overlap as parts from CAD often do: blade panels inside the hub do not count as surface.
"""

import argparse
import math

HUB_RADIUS, HUB_LENGTH = 0.1, 0.2
BLADE_ROOT, BLADE_TIP, BLADE_WIDTH, BLADE_THICKNESS = 0.06, 0.4, 0.16, 0.024
PANEL = 0.02


class Mesh:
    def __init__(self):
        self.number = {}
        self.lines = []

    def vertex(self, *place):
        key = tuple(round(c, 9) + 0.0 for c in place)
        if key not in self.number:
            self.number[key] = len(self.number) + 1
            self.lines.append("v {:.9g} {:.9g} {:.9g}".format(*key))
        return self.number[key]

    def panel(self, *corners):
        self.lines.append("f " + " ".join(str(self.vertex(*corner)) for corner in corners))


def add_hub(mesh):
    around, along, rings = 32, round(HUB_LENGTH / PANEL), 4
    angles = [2 * math.pi * k / around for k in range(around + 1)]

    def at(angle, radius, z):
        return radius * math.cos(angle), radius * math.sin(angle), z

    heights = [-HUB_LENGTH / 2 + HUB_LENGTH * k / along for k in range(along + 1)]
    for a, b in zip(angles, angles[1:]):
        for low, high in zip(heights, heights[1:]):
            mesh.panel(at(a, HUB_RADIUS, low), at(b, HUB_RADIUS, low), at(b, HUB_RADIUS, high), at(a, HUB_RADIUS, high))
        for z, turn in ((heights[-1], False), (heights[0], True)):
            for ring in range(rings):
                r, s = HUB_RADIUS * ring / rings, HUB_RADIUS * (ring + 1) / rings
                corners = [at(a, r, z), at(a, s, z), at(b, s, z)] + ([at(b, r, z)] if ring > 0 else [])
                mesh.panel(*(reversed(corners) if turn else corners))


def add_blade(mesh, angle):
    low = (BLADE_ROOT, -BLADE_THICKNESS / 2, -BLADE_WIDTH / 2)
    high = (BLADE_TIP, BLADE_THICKNESS / 2, BLADE_WIDTH / 2)
    count = [max(1, round((h - l) / PANEL)) for l, h in zip(low, high)]

    def grid(axis, k):
        return low[axis] + (high[axis] - low[axis]) * k / count[axis]

    def turned(point):
        x, y, z = point
        return x * math.cos(angle) - y * math.sin(angle), x * math.sin(angle) + y * math.cos(angle), z

    for axis in range(3):
        first, second = (axis + 1) % 3, (axis + 2) % 3
        for side in (0, 1):
            for i in range(count[first]):
                for j in range(count[second]):
                    corners = []
                    for di, dj in ((0, 0), (1, 0), (1, 1), (0, 1)) if side else ((0, 0), (0, 1), (1, 1), (1, 0)):
                        point = [0.0] * 3
                        point[axis] = grid(axis, side * count[axis])
                        point[first], point[second] = grid(first, i + di), grid(second, j + dj)
                        corners.append(turned(point))
                    mesh.panel(*corners)


argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter).parse_args()
mesh = Mesh()
mesh.lines.append("g hub")
add_hub(mesh)
for k in range(4):
    mesh.lines.append(f"g blade_{k + 1}")
    add_blade(mesh, math.pi / 4 + k * math.pi / 2)
print("# A wheel of four blades in a hub, made by make_paddle.py [m]")
print("\n".join(mesh.lines))
