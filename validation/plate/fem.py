#!/usr/bin/python3
"""The plate of section 5 of Zhang et al. by explicit three-dimensional finite elements, with dolfinx (Debian: python3-dolfinx).

    OMP_NUM_THREADS=1 validation/plate/fem.py OUT [--size 2] [--gap 0.5] [--late]      sizes in mm; writes OUT/fem_<size>mm[_gap][_late].csv, and lines

A solution independent of perimpact in every part: eight-node elements with 2×2×2 Gauss points, finite strain, lumped mass, central
differences. The material is neo-Hookean (J. Bonet, R. D. Wood: Nonlinear Continuum Mechanics for Finite Element Analysis, 2nd ed. 2008, ch. 6): under the
cylinder it is compressed by some per cent, where the simpler St Venant-Kirchhoff law softens. A quarter is computed: x ≥ 0 and z ≥ 0. The
cylinder is exact, without friction, free along y. Contact is by Lagrange multipliers of the end of the step (N. J. Carpenter, R. L. Taylor, M. G.
Katona: Int. J. Numer. Methods Eng. 32 (1991) 103): impulses λ ≥ 0 on the nodes, normal to the cylinder, such that none of them and the cylinder,
which they push back within the same step, overlap:

    Δt λ_i/m_i + Δt n_iy S/M = p_i,     S = Σ λ_j n_jy = Σ m_j n_jy p_j/Δt / (1 + Σ m_j n_jy²/M)         p: overlap [m], n: normal

With `--late` nodes are moved to the cylinder at the position given by its velocity of the previous step, and their impulse acts on it from the next step on, as in
the paper (eqs. 8 to 10). This isolates the effect of the delay.

One row per microsecond: time, the cylinder, the mean force since the previous row, the plate's centre; then energies of the whole: of the cylinder, kinetic
and strain energy of the plate, contact dissipation, and `energy balance error`, their sum less the initial energy of the cylinder.
"""

import argparse
import sys
import time
from pathlib import Path

import numpy as np

try:
    import ufl
    from dolfinx import fem, mesh
    from mpi4py import MPI
except ImportError as missing:
    sys.exit(f"error: {missing}: the finite elements need dolfinx. On Debian: sudo apt-get install python3-dolfinx, and run this with /usr/bin/python3")

LENGTH, WIDTH, THICKNESS = 0.2, 0.1, 0.009  # [m] plate in x, y, z
YOUNG, POISSON, DENSITY = 191e9, 0.25, 8000.0  # [Pa] [-] [kg/m³]
RADIUS, MASS, SPEED = 0.025, 1.57, 32.0  # [m] [kg] [m/s] cylinder, towards -y
END, ROW = 200e-6, 1e-6  # [s]
STEP_OVER_SIZE = 1e-4  # [s/m], at most: 0.54 of the time that a dilatational wave, at 5 353 m/s, takes across an element
QUARTER = 4  # a quarter of the model is computed
COLUMNS = ["time [s]", "cylinder.position_y [m]", "cylinder.velocity_y [m/s]", "cylinder.force_y [N]", "centre.displacement_y [m]", "cylinder energy [J]",
           "plate.kinetic_energy [J]", "plate.elastic_energy [J]", "contact dissipation [J]", "energy balance error [J]"]  # fmt: skip


class Plate:
    """A quarter of the plate: positions X, displacements u, velocities v, masses m of the nodes, forces from the strain."""

    def __init__(self, size):
        cells = [round(LENGTH / 2 / size), 2 * round(WIDTH / 2 / size), int(np.ceil(THICKNESS / 2 / size))]  # a node in the middle
        corners = [[0, -WIDTH / 2, 0], [LENGTH / 2, WIDTH / 2, THICKNESS / 2]]
        domain = mesh.create_box(MPI.COMM_SELF, corners, cells, mesh.CellType.hexahedron)
        space = fem.VectorFunctionSpace(domain, ("Lagrange", 1))
        self.X = space.tabulate_dof_coordinates()
        self.displacement, test = fem.Function(space), ufl.TestFunction(space)
        self.u = self.displacement.x.array.reshape(-1, 3)
        self.v = np.zeros_like(self.u)
        dx = ufl.dx(metadata={"quadrature_degree": 2})
        gradient = ufl.Identity(3) + ufl.grad(self.displacement)
        stretch, volume = gradient.T * gradient, ufl.det(gradient)
        mu, lame = YOUNG / (2 * (1 + POISSON)), YOUNG * POISSON / ((1 + POISSON) * (1 - 2 * POISSON))
        stress = mu * (ufl.Identity(3) - ufl.inv(stretch)) + lame * ufl.ln(volume) * ufl.inv(stretch)
        energy = mu / 2 * (ufl.tr(stretch) - 3 - 2 * ufl.ln(volume)) + lame / 2 * ufl.ln(volume) ** 2
        self.inner_forces = fem.form(ufl.inner(gradient * stress, ufl.grad(test)) * dx)
        self.strain_energy = fem.form(energy * dx)
        self.m = self.assembled(fem.form(DENSITY * ufl.inner(ufl.as_vector([1, 1, 1]), test) * dx))
        self.free = np.ones_like(self.u)
        self.free[np.isclose(self.X[:, 0], 0), 0] = 0
        self.free[np.isclose(self.X[:, 2], 0), 2] = 0

    @staticmethod
    def assembled(form):
        return fem.assemble_vector(form).array.reshape(-1, 3).copy()

    def accelerate(self, step):
        self.v -= step * self.free * self.assembled(self.inner_forces) / self.m

    def elastic_energy(self):
        return fem.assemble_scalar(self.strain_energy)

    def along(self, axis):
        """Nodes of the middle layer on an axis of symmetry, in order."""
        across = 1 - axis
        nodes = np.flatnonzero(np.isclose(self.X[:, across], 0) & np.isclose(self.X[:, 2], 0))
        return nodes[np.argsort(self.X[nodes, axis])]


def impact(plate, early, edge, centre, speed, mass, step, late):
    """Resolves overlaps at the end of the step. New velocity of the cylinder, impulse on it along y, loss of energy.

    early: velocities half a step before. Forces change them to half a step after; work is the impulse times the mean of both.
    """
    from_axis = plate.free[edge, :2] * ((plate.X + plate.u)[edge, :2] - [0, centre])  # rounding would grow on the plane of symmetry
    distance = np.linalg.norm(from_axis, axis=1)
    touching = np.flatnonzero(distance < RADIUS)
    while len(touching):
        normal = from_axis[touching] / distance[touching, None]
        overlap, m = RADIUS - distance[touching], plate.m[edge[touching], 0]
        along = normal[:, 1]
        gives_way = 0 if late else 1 / mass
        total = (along * m * overlap).sum() / step / (1 + (m * along**2).sum() * gives_way)
        impulse = m * (overlap / step - along * total * gives_way)
        if (impulse >= 0).all():
            break
        touching = touching[impulse > 0]
    if not len(touching):
        return speed, 0.0, 0.0
    nodes = edge[touching]
    plate.v[nodes, :2] += impulse[:, None] * normal / m[:, None]
    plate.u[nodes, :2] += step * impulse[:, None] * normal / m[:, None]
    work_on_plate = (impulse * (normal * (early[nodes, :2] + plate.v[nodes, :2]) / 2).sum(axis=1)).sum()
    after = speed - total / mass
    return after, -total, total * (speed + after) / 2 - work_on_plate


def run(size, gap, late):
    every = int(np.ceil(ROW / (STEP_OVER_SIZE * size) - 1e-9))  # steps between rows
    plate, step, steps = Plate(size), ROW / every, every * round(END / ROW)
    edge = np.flatnonzero(np.isclose(plate.X[:, 1], WIDTH / 2) & (plate.X[:, 0] < RADIUS))
    middle = plate.along(1)[np.abs(plate.X[plate.along(1), 1]).argmin()]
    mass, centre, speed = MASS / QUARTER, WIDTH / 2 + RADIUS + gap, -SPEED
    begin, first = time.process_time(), MASS * SPEED**2 / 2
    rows, impulse, loss = [[0, centre, speed, 0, 0, first, 0, 0, 0, 0]], 0.0, 0.0
    for n in range(steps + 1):
        early = plate.v.copy()
        plate.accelerate(step)
        if n > 0 and n % every == 0:  # a row of t = n Δt: velocities are from half a step before and half a step after
            kinetic = QUARTER * (plate.m * early * plate.v).sum() / 2
            energies = [MASS * speed**2 / 2, kinetic, QUARTER * plate.elastic_energy(), QUARTER * loss]
            rows.append([n * step, centre, speed, QUARTER * impulse / ROW, plate.u[middle, 1], *energies, sum(energies) - first])
            impulse = 0.0
            if not abs(rows[-1][-1]) < 1e-3 * first:
                sys.exit(f"error: {n * step * 1e6:.0f} us: the energy does not close, {rows[-1][-1]:.3g} J of {first:.5g} J: the step of {step:.3g} s is too long for these "
                         "elements. Lower STEP_OVER_SIZE")  # fmt: skip
        if n == steps:
            break
        plate.u += step * plate.v
        centre += step * speed
        after, pushed, lost = impact(plate, early, edge, centre, speed, mass, step, late)
        centre += 0 if late else step * (after - speed)
        speed, impulse, loss = after, impulse + pushed, loss + lost
    momentum = MASS * speed + QUARTER * (plate.m * early)[:, 1].sum()
    print(f"{size * 1e3:g} mm, gap {gap * 1e3:g} mm{', late' * late}: {len(plate.X)} nodes, {steps} steps, {time.process_time() - begin:.0f} s; "
          f"momentum {momentum / (-MASS * SPEED) - 1:+.1e} of itself", flush=True)  # fmt: skip
    return plate, rows


def write(path, columns, rows):
    np.savetxt(path, rows, fmt="%.7g", delimiter=",", header=",".join(columns), comments="")


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("out", type=Path)
    arguments.add_argument("--size", type=float, default=2, help="of elements [mm]")
    arguments.add_argument("--gap", type=float, default=0, help="between cylinder and plate at first [mm]")
    arguments.add_argument("--late", action="store_true", help="the cylinder feels what pushes it a step late")
    given = arguments.parse_args()
    plate, rows = run(given.size * 1e-3, given.gap * 1e-3, given.late)
    given.out.mkdir(parents=True, exist_ok=True)
    name = f"fem_{given.size:g}mm" + "_gap" * bool(given.gap) + "_late" * given.late
    write(given.out / f"{name}.csv", COLUMNS, rows)
    for axis, letter in enumerate("xy"):
        nodes = plate.along(axis)
        write(given.out / f"{name}_line_{letter}.csv", [f"position_{letter} [m]", "displacement_y [m]"], np.column_stack([plate.X[nodes, axis], plate.u[nodes, 1]]))


if __name__ == "__main__":
    main()
