#!/usr/bin/python3
"""The panel as a solid of 27-node hexahedra (dolfinx), for the static deflection and stress alone: a check of the shells that shares nothing with them but the dimensions.

    cases/hull_panel/solid.py [ALONG [PER_BAY]]      elements along the frames and in a bay; prints deflections under 100 kPa and the mass

A quarter is computed. The plating is 0.5 t above and below z = 0, webs reach from its lower face to the flanges, whose middle is HEIGHT below z = 0.
"""

import argparse

import numpy as np
import scipy.sparse.linalg
import ufl
from dolfinx import fem
from dolfinx.mesh import create_mesh, locate_entities_boundary, meshtags
from mpi4py import MPI
from panel import BAYS, BREADTH, DENSITY, FLANGE, HEIGHT, LENGTH, PLATING, POISSON, SPACING, WEB, YOUNG
from shell import to_scipy


def brick(x, y, z):
    """Points and hexahedra, in dolfinx's order of corners, of a grid of these lines."""
    points = np.array([[a, b, c] for c in z for b in y for a in x])
    row, layer = len(x), len(x) * len(y)
    first = np.array([k * layer + j * row + i for k in range(len(z) - 1) for j in range(len(y) - 1) for i in range(len(x) - 1)])
    return points, first[:, None] + np.array([a + b * row + c * layer for c in (0, 1) for b in (0, 1) for a in (0, 1)])


def panel_bricks(along, per_bay):
    x = np.linspace(0, LENGTH / 2, along // 2 + 1)
    half = BAYS * SPACING / 2
    frames = [k * SPACING - half for k in range(1, BAYS) if k * SPACING > half]
    lines = [np.linspace(0, frames[0] - WEB / 2, per_bay // 2 + 1)]
    for left, right in zip(frames, [*frames[1:], None]):
        end = half if right is None else right - WEB / 2
        lines.append(np.linspace(left + WEB / 2, end, per_bay + 1))
    parts = [brick(x, np.concatenate(lines), [-PLATING / 2, PLATING / 2])]
    for y in frames:
        top, bottom = -HEIGHT + FLANGE / 2, -HEIGHT - FLANGE / 2
        parts.append(brick(x, [y - WEB / 2, y + WEB / 2], np.linspace(top, -PLATING / 2, 4)))
        parts.append(brick(x, [y - BREADTH / 2, y - WEB / 2, y + WEB / 2, y + BREADTH / 2], [bottom, top]))
    points, cells = np.zeros((0, 3)), np.zeros((0, 8), int)
    for more, hexahedra in parts:
        cells = np.vstack([cells, hexahedra + len(points)])
        points = np.vstack([points, more])
    _, first, to = np.unique(np.round(points / 1e-7).astype(np.int64), axis=0, return_index=True, return_inverse=True)
    return points[first], to.ravel()[cells]


def solve(along, per_bay, pressure=1e5):
    """Largest deflection of the plating's middle and of a frame [m], mass [kg], degrees of freedom."""
    points, cells = panel_bricks(along, per_bay)
    domain = create_mesh(MPI.COMM_SELF, cells, points, ufl.Mesh(ufl.VectorElement("Lagrange", ufl.hexahedron, 1)))
    space = fem.VectorFunctionSpace(domain, ("Lagrange", 2))
    trial, test = ufl.TrialFunction(space), ufl.TestFunction(space)
    mu, lame = YOUNG / (2 * (1 + POISSON)), YOUNG * POISSON / ((1 + POISSON) * (1 - 2 * POISSON))
    strain, virtual = ufl.sym(ufl.grad(trial)), ufl.sym(ufl.grad(test))
    stiffness = to_scipy((2 * mu * ufl.inner(strain, virtual) + lame * ufl.tr(strain) * ufl.tr(virtual)) * ufl.dx(metadata={"quadrature_degree": 4}))
    wet = locate_entities_boundary(domain, 2, lambda x: np.isclose(x[2], PLATING / 2))
    tags = meshtags(domain, 2, np.sort(wet), np.ones(len(wet), np.int32))
    load = fem.petsc.assemble_vector(fem.form(-pressure * test[2] * ufl.Measure("ds", domain, subdomain_data=tags)(1))).array
    mass = 4 * fem.assemble_scalar(fem.form(fem.Constant(domain, DENSITY) * ufl.dx))
    places = space.tabulate_dof_coordinates()
    clamped = (np.abs(places[:, 0]) > LENGTH / 2 - 1e-9) | (places[:, 1] > BAYS * SPACING / 2 - 1e-9)
    fixed = np.column_stack([clamped | np.isclose(places[:, 0], 0), clamped | np.isclose(places[:, 1], 0), clamped]).ravel()
    u = np.zeros(fixed.size)
    u[~fixed] = scipy.sparse.linalg.spsolve(stiffness[~fixed][:, ~fixed].tocsc(), load[~fixed])
    sag = -u.reshape(-1, 3)[:, 2]
    on_frame = np.isclose(places[:, 1], SPACING / 2) & np.isclose(places[:, 2], 0)
    middle = np.isclose(places[:, 2], 0)
    return sag[middle].max(), sag[on_frame].max(), mass, fixed.size


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("along", metavar="ALONG", type=int, nargs="?", default=20)
    arguments.add_argument("per_bay", metavar="PER_BAY", type=int, nargs="?", default=4)
    given = arguments.parse_args()
    sizes = given.along, given.per_bay
    plating, frame, mass, freedoms = solve(*sizes)
    print(f"solid, {sizes[0]} × {sizes[1]}: {freedoms} degrees of freedom in a quarter, {mass:.2f} kg, deflection {1e3 * plating:.4f} mm, of a frame {1e3 * frame:.4f} mm")


if __name__ == "__main__":
    main()
