"""Flat shell elements by dolfinx: four nodes, six degrees of freedom each, small displacements, linear elasticity, lumped masses.

Reissner-Mindlin kinematics: a point at the distance z from the middle surface moves by u + z θ × n, with the displacement u, the rotation θ and
the facet's normal n. Elements are rectangles, so that reduced quadrature is exactly the assumed strain that prevents locking:

- transverse shear γ_α is integrated with one point along α and two across it, which on a rectangle is the MITC4 element
  (K.-J. Bathe, E. N. Dvorkin: Int. J. Numer. Methods Eng. 21 (1985) 367);
- membrane shear with one point, since a four-node element in bending within its plane (a web) would otherwise be too stiff; the other membrane strains
  with 2×2 points, which leaves no zero-energy mode;
- the rotation about the normal follows that of the displacements through a penalty of DRILLING times the membrane shear stiffness.

Masses are lumped at the nodes: a quarter of each element, with the rotary inertia m t²/12 about every axis.
"""

import logging
import sys

import numpy as np
import scipy.sparse

try:
    import ufl
    import dolfinx.fem.petsc
    from dolfinx import fem
    from dolfinx.mesh import create_mesh
    from mpi4py import MPI
except ImportError as missing:
    sys.exit(f"error: {missing}: the shell elements need dolfinx. On Debian: sudo apt-get install python3-dolfinx, and run this with /usr/bin/python3")

logging.getLogger("UFL").setLevel(logging.ERROR)  # it warns about points of quadrature in the metadata
logging.getLogger("FFC").setLevel(logging.ERROR)

DRILLING = 0.01  # the static deflection of the panel changes by less than 0.1 % from 0.001 to 0.1
SHEAR_CORRECTION = 5 / 6
GAUSS = 0.5 + 0.5 / np.sqrt(3) * np.array([-1, 1])
CORNERS = [0, 1, 3, 2]  # dolfinx numbers the corners of a quadrilateral row by row; the others here go around it


def gauss(along_1, along_2):
    """Measure with 1 or 2 Gauss points along each direction of the reference square."""
    one = {1: np.array([0.5]), 2: GAUSS}
    points = np.array([[a, b] for a in one[along_1] for b in one[along_2]])
    weights = np.full(len(points), 1 / len(points))
    return ufl.dx(metadata={"quadrature_rule": "custom", "quadrature_degree": along_1 + 10 * along_2, "quadrature_points": points, "quadrature_weights": weights})


def to_scipy(form):
    """The assembled matrix of a bilinear form, in dolfinx's numbering."""
    matrix = fem.petsc.assemble_matrix(fem.form(form))
    matrix.assemble()
    rows, columns, values = matrix.getValuesCSR()
    return scipy.sparse.csr_matrix((values, columns, rows), shape=matrix.getSize())


class Shell:
    """A mesh of flat rectangles: matrices over the degrees of freedom (u_x, u_y, u_z, θ_x, θ_y, θ_z) of each node in turn.

    vertices   (n, 3) [m];  quads (m, 4), around each element, its first side along the first local axis;  thickness (m,) [m]
    stiffness  (6n, 6n) sparse [N/m, N, N m]
    masses     (n,) [kg];  inertias (n,) [kg m²]
    stresses   (6m, 6n) sparse [Pa/m, Pa]: σ11, σ22, σ12 at the centre of each element, on the side of its normal, then on the other one
    """

    def __init__(self, vertices, quads, thickness, young, poisson, density):
        self.vertices, self.quads, self.thickness = np.asarray(vertices, float), np.asarray(quads), np.asarray(thickness, float)
        self.young, self.poisson = young, poisson
        element = ufl.VectorElement("Lagrange", ufl.Cell("quadrilateral", geometric_dimension=3), 1)
        domain = create_mesh(MPI.COMM_SELF, self.quads[:, CORNERS].astype(np.int64), self.vertices, ufl.Mesh(element))
        self._cells = np.asarray(domain.topology.original_cell_index)
        self._domain = domain
        self._space = fem.FunctionSpace(domain, ufl.VectorElement("Lagrange", domain.ufl_cell(), 1, dim=6))
        self._thickness = fem.Function(fem.FunctionSpace(domain, ("DG", 0)))
        self._thickness.x.array[:] = self.thickness[self._cells]
        self._order = self._find_order()
        sides = self.vertices[self.quads]
        self.areas = np.linalg.norm(np.cross(sides[:, 1] - sides[:, 0], sides[:, 3] - sides[:, 0]), axis=1)
        self.stiffness = self._assemble(self._energy_form())
        self.stresses = self._assemble_stresses()
        element_masses = density * self.thickness * self.areas
        self.masses, self.inertias = (np.zeros(len(self.vertices)) for _ in range(2))
        for corner in self.quads.T:
            np.add.at(self.masses, corner, element_masses / 4)
            np.add.at(self.inertias, corner, element_masses * self.thickness**2 / 48)

    def _find_order(self):
        """The degrees of freedom of dolfinx that correspond to those of the nodes as given."""
        geometry, dofs = self._domain.geometry, self._space.dofmap
        given = np.empty(len(self.vertices), int)  # node of dolfinx's function space for each node as given
        for cell in range(len(self.quads)):
            given[np.asarray(geometry.input_global_indices)[geometry.dofmap.links(cell)]] = dofs.cell_dofs(cell)
        return (6 * given[:, None] + np.arange(6)).ravel()

    def _strains(self, f):
        """Membrane strain, curvature (11, 22, 12 each, engineering shear), transverse shear, drilling strain of the field f."""
        u, rotation = ufl.as_vector([f[0], f[1], f[2]]), ufl.as_vector([f[3], f[4], f[5]])
        jacobian = ufl.Jacobian(self._domain)
        sides = [ufl.as_vector([jacobian[i, side] for i in range(3)]) for side in (0, 1)]
        e = [side / ufl.sqrt(ufl.dot(side, side)) for side in sides]
        n = ufl.cross(*e)

        def slope(vector, direction, along):
            return ufl.dot(direction, ufl.dot(ufl.grad(vector), along))

        def symmetric(vector):
            return slope(vector, e[0], e[0]), slope(vector, e[1], e[1]), slope(vector, e[0], e[1]) + slope(vector, e[1], e[0])

        membrane = symmetric(u)
        # (θ × n)·e1 = θ·e2 and (θ × n)·e2 = -θ·e1; the axes are constant on a rectangle
        tilt = ufl.dot(rotation, e[1]), -ufl.dot(rotation, e[0])
        curvature = (slope(rotation, e[1], e[0]), -slope(rotation, e[0], e[1]), slope(rotation, e[1], e[1]) - slope(rotation, e[0], e[0]))
        shear = [slope(u, n, e[k]) + tilt[k] for k in (0, 1)]
        drilling = ufl.dot(rotation, n) - (slope(u, e[1], e[0]) - slope(u, e[0], e[1])) / 2
        return membrane, curvature, shear, drilling

    def _energy_form(self):
        trial, test = ufl.TrialFunction(self._space), ufl.TestFunction(self._space)
        (m, k, s, d), (dm, dk, ds, dd) = self._strains(trial), self._strains(test)
        t, nu = self._thickness, self.poisson
        plane, shear = self.young / (1 - nu**2), self.young / (2 * (1 + nu))

        def normal(a, b):
            return plane * (a[0] * b[0] + a[1] * b[1] + nu * (a[0] * b[1] + a[1] * b[0]))

        full = t * normal(m, dm) + t**3 / 12 * (normal(k, dk) + shear * k[2] * dk[2]) + DRILLING * shear * t * d * dd
        across = [SHEAR_CORRECTION * shear * t * s[k] * ds[k] for k in (0, 1)]
        return full * gauss(2, 2) + t * shear * m[2] * dm[2] * gauss(1, 1) + across[0] * gauss(1, 2) + across[1] * gauss(2, 1)

    def _assemble(self, form):
        matrix = to_scipy(form)[self._order][:, self._order]
        return ((matrix + matrix.T) / 2).tocsr()  # exactly symmetric, so that the work of forces is

    def _assemble_stresses(self):
        places = fem.FunctionSpace(self._domain, ufl.VectorElement("DG", self._domain.ufl_cell(), 0, dim=6))
        trial, test = ufl.TrialFunction(self._space), ufl.TestFunction(places)
        membrane, curvature, *_ = self._strains(trial)
        nu, plane = self.poisson, self.young / (1 - self.poisson**2)
        terms = []
        for side, sign in ((0, 1), (1, -1)):
            a, b, c = (membrane[i] + sign * self._thickness / 2 * curvature[i] for i in range(3))
            stress = plane * (a + nu * b), plane * (b + nu * a), plane * (1 - nu) / 2 * c
            terms += [stress[i] * test[3 * side + i] for i in range(3)]
        integrals = to_scipy(sum(terms) * gauss(1, 1))
        rows = np.empty((len(self.quads), 6), int)
        for cell in range(len(self.quads)):
            rows[self._cells[cell]] = 6 * places.dofmap.cell_dofs(cell)[0] + np.arange(6)
        means = scipy.sparse.diags(np.repeat(1 / self.areas, 6)) @ integrals[rows.ravel()][:, self._order]
        return scipy.sparse.csr_matrix(means)

    def von_mises(self, displacements):
        """(m,) [Pa] the larger of both sides at the centre of each element; displacements (6n,)."""
        return von_mises(self.stresses @ displacements)


def von_mises(stresses):
    """(m,) [Pa] the larger of both sides of each element, from Shell.stresses @ displacements."""
    a, b, c = np.moveaxis(stresses.reshape(-1, 2, 3), -1, 0)
    return np.sqrt(a**2 - a * b + b**2 + 3 * c**2).max(axis=1)
