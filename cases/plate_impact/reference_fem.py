#!/usr/bin/env python3
"""Computes the reference of this case independently: linear finite elements, two-dimensional plane stress.

Four-node elements of 1 mm with 2×2 Gauss points, lumped mass, central differences. A node inside the cylinder is moved to
its surface, and the cylinder loses the momentum that the node gains. Writes reference_fem.csv (histories) and reference_fem_line_x.csv,
reference_fem_line_y.csv (displacements along the central lines at the end) into the given folder.

    /usr/bin/python3 reference_fem.py .      # ten seconds
"""

import argparse
from pathlib import Path

import numpy as np

LENGTH, WIDTH, THICKNESS = 0.2, 0.1, 0.009  # [m] plate in x, y, z
YOUNG, POISSON, DENSITY = 191e9, 0.25, 8000.0  # [Pa] [-] [kg/m³]
RADIUS, MASS, SPEED = 0.025, 1.57, -32.0  # [m] [kg] [m/s] cylinder, along y
END, STEP, EVERY = 200e-6, 1e-7, 10  # [s] [s]; steps between rows of the history
SIZE = 0.001  # [m] of an element


def element_stiffness():
    """Of a square element in plane stress; it does not depend on the size. Rows and columns: u_x, u_y of the corners in turn."""
    elasticity = YOUNG / (1 - POISSON**2) * np.array([[1, POISSON, 0], [POISSON, 1, 0], [0, 0, (1 - POISSON) / 2]])
    corners = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]])
    stiffness = np.zeros((8, 8))
    for gauss in corners / np.sqrt(3):
        slopes = corners * (1 + corners[:, ::-1] * gauss[::-1]) / 4 * (2 / SIZE)  # slopes of the four shape functions along x and y
        strain = np.zeros((3, 8))
        strain[0, 0::2] = strain[2, 1::2] = slopes[:, 0]
        strain[1, 1::2] = strain[2, 0::2] = slopes[:, 1]
        stiffness += strain.T @ elasticity @ strain * THICKNESS * SIZE**2 / 4
    return stiffness


class Plate:
    def __init__(self):
        self.X = np.stack(np.meshgrid(np.arange(-LENGTH / 2, LENGTH / 2 + SIZE / 2, SIZE), np.arange(-WIDTH / 2, WIDTH / 2 + SIZE / 2, SIZE), indexing="ij"), axis=-1)
        share = np.ones(self.X.shape[:2])  # elements around each node, in quarters
        for edge in (np.s_[0], np.s_[-1], np.s_[:, 0], np.s_[:, -1]):
            share[edge] /= 2
        self.mass = (DENSITY * THICKNESS * SIZE**2 * share)[..., None]
        self.u = np.zeros_like(self.X)
        self.v = np.zeros_like(self.X)
        self.stiffness = element_stiffness()

    def forces(self):
        corners = [np.s_[:-1, :-1], np.s_[1:, :-1], np.s_[1:, 1:], np.s_[:-1, 1:]]
        element_forces = np.concatenate([self.u[corner] for corner in corners], axis=-1) @ self.stiffness
        total = np.zeros_like(self.u)
        for c, corner in enumerate(corners):
            total[corner] -= element_forces[..., 2 * c : 2 * c + 2]
        return total


def run():
    """Histories as rows (time, cylinder position, velocity, mean force since the previous row, centre displacement), and the plate at the end."""
    plate, centre = Plate(), np.array([0.0, WIDTH / 2 + RADIUS])
    velocity = SPEED
    middle = tuple(n // 2 for n in plate.X.shape[:2])
    rows, impulse = [(0.0, centre[1], velocity, 0.0, 0.0)], 0.0
    for step in range(1, round(END / STEP) + 1):
        plate.v += STEP * plate.forces() / plate.mass
        plate.u += STEP * plate.v
        centre[1] += STEP * velocity
        from_axis = plate.X + plate.u - centre
        distance = np.linalg.norm(from_axis, axis=-1, keepdims=True)
        inside = distance[..., 0] < RADIUS
        if inside.any():
            push = (from_axis * (RADIUS / distance - 1))[inside]
            plate.u[inside] += push
            plate.v[inside] += push / STEP
            gained = np.sum(plate.mass[inside] * push / STEP, axis=0)[1]
            velocity -= gained / MASS
            impulse -= gained
        if step % EVERY == 0:
            rows.append((step * STEP, centre[1], velocity, impulse / (EVERY * STEP), plate.u[middle][1]))
            impulse = 0.0
    return np.array(rows), plate, middle


def write(path, columns, rows):
    np.savetxt(path, rows, fmt="%.7g", delimiter=",", header=",".join(columns), comments="")


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("folder", type=Path)
    folder = arguments.parse_args().folder
    rows, plate, (i, j) = run()
    write(folder / "reference_fem.csv", ["time [s]", "cylinder.position_y [m]", "cylinder.velocity_y [m/s]", "cylinder.force_y [N]", "centre.displacement_y [m]"], rows)
    columns = ["position_x [m]", "position_y [m]", "displacement_x [m]", "displacement_y [m]"]
    for name, along in (("line_x", np.s_[:, j]), ("line_y", np.s_[i, :])):
        write(folder / f"reference_fem_{name}.csv", columns, np.hstack([plate.X[along], plate.u[along]]))
    time, position, velocity, force, centre = rows.T
    momentum = MASS * velocity[-1] + (plate.mass * plate.v)[..., 1].sum()
    print(f"centre {1e3 * centre[-1]:.3f} mm, cylinder {1e3 * (position[-1] - position[0]):.3f} mm and {velocity[-1]:.3f} m/s")
    print(f"peak force {force.max() / 1e6:.3f} MN, contact until {1e6 * time[np.flatnonzero(force)[-1]]:.0f} us, momentum {momentum:.9f} kg m/s")


if __name__ == "__main__":
    main()
