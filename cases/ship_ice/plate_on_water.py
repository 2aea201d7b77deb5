#!/usr/bin/python3
"""At which vertical force of a stem an elastic plate on water cracks, and where: plate_on_water.py [--thickness 2 --young 1.8e9 --strength 768e3 …]

Kirchhoff's plate on Winkler's foundation ρ_w g, by conforming rectangular elements of third order (F. K. Bogner, R. L. Fox, L. A. Schmit, Proc. 1st Conf. Matrix
Methods in Structural Mechanics, 1965). The stem with the entrance half-angle α has advanced by a into the edge x = 0 and presses on the triangle |y| ≤ (a − x) tan α with
the pressure p, so that its vertical force is p a² tan α. Two sheets: a whole one, and one that a radial crack along y = 0 has split. Printed is the force at which the
largest principal stress along the track reaches the flexural strength: at the bottom (radial crack) and at the top (circumferential crack), with the distance ahead
of the edge.
Independent of peridynamics, and of the program. SI units, angles in degrees. Needs numpy and scipy.
"""

import argparse
from dataclasses import replace
from math import radians, tan
from pathlib import Path

import numpy as np
from resistance import GRAVITY, ShipInIce, help_of_fields
from scipy.sparse import coo_matrix
from scipy.sparse.linalg import splu

POINTS, WEIGHTS = np.polynomial.legendre.leggauss(4)
POINTS, WEIGHTS = 0.5 * (POINTS + 1), 0.5 * WEIGHTS  # on [0, 1]
PARTS = 24  # of the sides of an element, for the integral of the load over a part of it


def hermite(s, length):
    """Values, first and second derivatives of the four cubic functions of an interval at s in [0, 1]: value and slope at its begin, and at its end."""
    s, one = np.asarray(s, float), np.ones_like(np.asarray(s, float))
    values = np.array([1 - 3 * s**2 + 2 * s**3, length * (s - 2 * s**2 + s**3), 3 * s**2 - 2 * s**3, length * (s**3 - s**2)])
    slopes = np.array([6 * s**2 - 6 * s, length * (1 - 4 * s + 3 * s**2), 6 * s - 6 * s**2, length * (3 * s**2 - 2 * s)]) / length
    curvatures = np.array([12 * s - 6 * one, length * (6 * s - 4 * one), 6 * one - 12 * s, length * (6 * s - 2 * one)]) / length**2
    return values, slopes, curvatures


def graded(reach, finest, growth):
    """Coordinates from 0 to some reach, in steps that grow from the finest one."""
    steps = [finest]
    while sum(steps) < reach:
        steps.append(steps[-1] * growth)
    return np.concatenate([[0], np.cumsum(steps)])


class Plate:
    """A quarter-infinite sheet x ≥ 0, y ≥ 0 with a free edge x = 0. At y = 0 it is symmetric, or free where `is_split`."""

    def __init__(self, ice, is_split, finest=0.15, growth=1.06):
        self.ice = ice
        reach = 5 * ice.characteristic_length
        self.x, self.y = graded(reach, finest, growth), graded(reach, finest, growth)
        self.stiffness = ice.young * ice.thickness**3 / (12 * (1 - ice.poisson**2))
        self.columns = len(self.y)
        rows, others, entries = [], [], []
        for i in range(len(self.x) - 1):
            for j in range(len(self.y) - 1):
                numbers, matrix = self.numbers(i, j), self.element(self.x[i + 1] - self.x[i], self.y[j + 1] - self.y[j])
                rows.append(np.repeat(numbers, 16)), others.append(np.tile(numbers, 16)), entries.append(matrix.ravel())
        count = 4 * len(self.x) * len(self.y)
        matrix = coo_matrix((np.concatenate(entries), (np.concatenate(rows), np.concatenate(others))), shape=(count, count)).tocsc()
        at_axis = 4 * np.arange(len(self.x)) * self.columns
        fixed = np.array([], int) if is_split else np.concatenate([at_axis + 2, at_axis + 3])  # w_y and w_xy
        self.kept = np.setdiff1d(np.arange(count), fixed)
        self.solver = splu(matrix[self.kept][:, self.kept].tocsc())

    def numbers(self, i, j):
        """Unknowns of an element: w, w_x, w_y, w_xy of the nodes, in the order of shape()."""
        nodes = [(i + a) * self.columns + j + b for a in (0, 1) for b in (0, 1)]
        return np.array([4 * node + number for node in nodes for number in range(4)])

    @staticmethod
    def shape(of_x, of_y):
        """Products of the functions of x and y, as unknowns of an element (16, points)."""
        return np.array([of_x[2 * a + c] * of_y[2 * b + d] for a in (0, 1) for b in (0, 1) for d in (0, 1) for c in (0, 1)])

    def curvatures(self, s, t, long, wide):
        """w, w_xx, w_yy, w_xy of the 16 functions at points of an element."""
        (x0, x1, x2), (y0, y1, y2) = hermite(s, long), hermite(t, wide)
        return self.shape(x0, y0), self.shape(x2, y0), self.shape(x0, y2), self.shape(x1, y1)

    def element(self, long, wide):
        s, t = (grid.ravel() for grid in np.meshgrid(POINTS, POINTS, indexing="ij"))
        weights = np.outer(WEIGHTS, WEIGHTS).ravel() * long * wide
        w, xx, yy, xy = self.curvatures(s, t, long, wide)
        nu = self.ice.poisson
        bending = self.stiffness * ((xx * weights) @ (xx + nu * yy).T + (yy * weights) @ (yy + nu * xx).T + 2 * (1 - nu) * (xy * weights) @ xy.T)
        return bending + self.ice.water * GRAVITY * (w * weights) @ w.T

    def solve(self, pressure):
        """Deflection of the nodes (unknowns), downward, under pressure(x, y) [Pa] on a convex area that contains the corner; and the force on y ≥ 0 [N]."""
        load, force = np.zeros(4 * len(self.x) * self.columns), 0.0
        centres = (np.arange(PARTS) + 0.5) / PARTS
        s, t = (grid.ravel() for grid in np.meshgrid(centres, centres, indexing="ij"))
        for i in range(len(self.x) - 1):
            for j in range(len(self.y) - 1):
                if not pressure(self.x[i], self.y[j]):
                    break
                long, wide = self.x[i + 1] - self.x[i], self.y[j + 1] - self.y[j]
                acting = pressure(self.x[i] + s * long, self.y[j] + t * wide) * long * wide / PARTS**2
                load[self.numbers(i, j)] += self.shape(hermite(s, long)[0], hermite(t, wide)[0]) @ acting
                force += acting.sum()
        deflection = np.zeros(len(load))
        deflection[self.kept] = self.solver.solve(load[self.kept])
        return deflection, force

    def largest(self, deflection):
        """Largest principal stress along y = 0 and its x [Pa, m], at the bottom and at the top."""
        found = {1: (0.0, 0.0), -1: (0.0, 0.0)}
        s, t = (grid.ravel() for grid in np.meshgrid(POINTS, POINTS, indexing="ij"))
        nu, factor = self.ice.poisson, 6 * self.stiffness / self.ice.thickness**2
        for i in range(len(self.x) - 1):
            long, wide = self.x[i + 1] - self.x[i], self.y[1]
            _, xx, yy, xy = (functions.T @ deflection[self.numbers(i, 0)] for functions in self.curvatures(s, t, long, wide))
            a, b, c = factor * (xx + nu * yy), factor * (yy + nu * xx), factor * (1 - nu) * xy  # of the top, where w is downward
            radius = np.hypot(0.5 * (a - b), c)
            for side, stress in ((1, 0.5 * (a + b) + radius), (-1, -0.5 * (a + b) + radius)):
                best = int(np.argmax(stress))
                if stress[best] > found[side][0]:
                    found[side] = float(stress[best]), float(self.x[i] + s[best] * long)
        return found[-1], found[1]


def breaking(plate, half_angle, pressure, side):
    """Force of the stem [N] at which the stress at the bottom (side 0) or top (1) reaches the strength, and the distance from the edge [m]."""
    low, high = 0.05, 6.0  # [m] of advance
    for _ in range(24):
        a = 0.5 * (low + high)
        deflection, force = plate.solve(lambda x, y: pressure * (y <= (a - x) * tan(radians(half_angle))))
        stress, distance = plate.largest(deflection)[side]
        low, high = (a, high) if stress < plate.ice.strength else (low, a)
    return 2 * force, distance


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    ice = ShipInIce(strength=768e3)
    descriptions = help_of_fields(Path(__file__).with_name("resistance.py"))
    for name in ("thickness", "young", "strength", "waterline"):
        parser.add_argument("--" + name, type=float, default=getattr(ice, name), help=descriptions[name])
    parser.add_argument("--pressure", type=float, default=2.3e6, help="at which the stem crushes the ice [Pa]")
    given = vars(parser.parse_args())
    pressure = given.pop("pressure")
    ice = replace(ice, **given)
    whole, split = Plate(ice, False), Plate(ice, True)
    for title, plate, side in (("radial crack, whole sheet", whole, 0), ("circumferential crack, split sheet", split, 1), ("circumferential crack, whole sheet", whole, 1)):
        force, distance = breaking(plate, ice.waterline, pressure, side)
        print(f"{title:40}{1e-6 * force:6.2f} MN   {distance:5.1f} m from the edge")


if __name__ == "__main__":
    main()
