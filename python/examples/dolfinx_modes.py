#!/usr/bin/env python3
"""Vibration modes of a plate, clamped at one end, by dolfinx: writes the file of an elastic impactor.

    PYTHONPATH=build/release/python /usr/bin/python3 python/examples/dolfinx_modes.py plate_modes.vtu

The deck then has `surface: {file: plate_modes.vtu}` and `elastic: {modes: plate_modes.vtu}`. Replace box, material and clamp() by yours: any mesh of
hexahedra or tetrahedra will do. Elements are of second order; the file has the corners of the outer faces, with displacements and stresses there.

Imports dolfinx, ufl, mpi4py, scipy and numpy (Debian: python3-dolfinx, python3-ufl, python3-mpi4py, python3-scipy, python3-numpy).
"""

import logging
import sys

import dolfinx.fem.petsc  # noqa: F401
import numpy as np
import scipy.sparse
import scipy.sparse.linalg
import scipy.spatial
import ufl
from dolfinx import fem
from dolfinx.mesh import CellType, compute_midpoints, create_box, exterior_facet_indices, locate_entities_boundary
from mpi4py import MPI
from perimpact import modes

for name in ("FFC", "UFL"):
    logging.getLogger(name).setLevel(logging.ERROR)  # they report what they compile

LENGTH, BREADTH, THICKNESS = 1.0, 0.3, 0.02  # [m]
CELLS = 20, 6, 2
YOUNG, POISSON, DENSITY = 206e9, 0.3, 7850.0  # [Pa], [-], [kg/m³]
COUNT = 6  # modes


def clamp(x):
    return np.isclose(x[0], 0)


def strain(u):
    return ufl.sym(ufl.grad(u))


def stress(u):
    return YOUNG / (1 + POISSON) * (strain(u) + POISSON / (1 - 2 * POISSON) * ufl.tr(strain(u)) * ufl.Identity(3))


def to_scipy(form, conditions, diagonal):
    matrix = fem.petsc.assemble_matrix(fem.form(form), bcs=conditions, diagonal=diagonal)
    matrix.assemble()
    matrix.convert("aij")
    offsets, columns, values = matrix.getValuesCSR()
    return scipy.sparse.csr_matrix((values, columns, offsets), shape=matrix.getSize())


def eigenmodes(space, conditions):
    """Frequencies [Hz] and, in the columns, mode shapes of unit modal mass."""
    u, v = ufl.TrialFunction(space), ufl.TestFunction(space)
    stiffness = to_scipy(ufl.inner(stress(u), strain(v)) * ufl.dx, conditions, 1.0)
    mass = to_scipy(DENSITY * ufl.inner(u, v) * ufl.dx, conditions, 0.0)  # clamped degrees of freedom have no mass, and no mode
    eigenvalues, vectors = scipy.sparse.linalg.eigsh(stiffness, k=COUNT, M=mass, sigma=0)
    return np.sqrt(eigenvalues) / (2 * np.pi), vectors / np.sqrt(np.einsum("ik,ik->k", vectors, mass @ vectors))


def outer_faces(mesh):
    """Positions of the vertices [m], and the vertex numbers of each outer face, in order around it."""
    for of, to in ((2, 3), (2, 0), (0, 3)):
        mesh.topology.create_connectivity(of, to)
    vertices = compute_midpoints(mesh, 0, np.arange(mesh.topology.index_map(0).size_local, dtype=np.int32))
    faces = np.array([mesh.topology.connectivity(2, 0).links(face) for face in exterior_facet_indices(mesh.topology)])
    return vertices, faces[:, [0, 1, 3, 2]] if faces.shape[1] == 4 else faces  # of quads dolfinx lists rows


def at_vertices(values, places, vertices):
    """The mean of the values at the places that coincide with each vertex."""
    _, vertex = scipy.spatial.cKDTree(vertices).query(places, distance_upper_bound=1e-9 * np.ptp(vertices))
    here = vertex < len(vertices)
    sums = np.zeros((len(vertices), values.shape[1]))
    np.add.at(sums, vertex[here], values[here])
    return sums / np.bincount(vertex[here], minlength=len(vertices))[:, None]


def plate():
    """Vertices of the surface [m], its faces, and the modes: frequencies [Hz], shapes [1/√kg] and stresses [Pa/(m √kg)] at the vertices."""
    mesh = create_box(MPI.COMM_SELF, [np.zeros(3), np.array([LENGTH, BREADTH, THICKNESS])], list(CELLS), CellType.hexahedron)
    space = fem.VectorFunctionSpace(mesh, ("CG", 2))
    held = fem.locate_dofs_topological(space, 2, locate_entities_boundary(mesh, 2, clamp))
    frequencies, vectors = eigenmodes(space, [fem.dirichletbc(np.zeros(3), held, space)])

    tensors = fem.TensorFunctionSpace(mesh, ("DG", 1))
    u, of_cells = fem.Function(space), fem.Function(tensors)
    expression = fem.Expression(stress(u), tensors.element.interpolation_points())
    vertices, faces = outer_faces(mesh)
    shapes, stresses = [], []
    for vector in vectors.T:
        u.x.array[:] = vector
        of_cells.interpolate(expression)
        shapes.append(at_vertices(vector.reshape(-1, 3), space.tabulate_dof_coordinates(), vertices))
        components = at_vertices(of_cells.x.array.reshape(-1, 9), tensors.tabulate_dof_coordinates(), vertices)
        stresses.append(components[:, [0, 4, 8, 1, 5, 6]])  # xx, yy, zz, xy, yz, zx
    used, own = np.unique(faces, return_inverse=True)
    faces = own.reshape(faces.shape)
    return vertices[used], faces, frequencies, np.array(shapes)[:, used], np.array(stresses)[:, used]


def main():
    vertices, faces, frequencies, shapes, stresses = plate()
    modes.write(sys.argv[1], vertices, faces.tolist(), frequencies, shapes, stresses)
    inertia = YOUNG * BREADTH * THICKNESS**3 / 12
    beam = 1.8751**2 / (2 * np.pi) * np.sqrt(inertia / (DENSITY * BREADTH * THICKNESS * LENGTH**4))
    print(f"frequencies: {' '.join(f'{f:.2f}' for f in frequencies)} Hz; the first of a slender beam is {beam:.2f} Hz")


if __name__ == "__main__":
    main()
