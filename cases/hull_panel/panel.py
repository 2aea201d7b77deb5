"""The stiffened panel of this case as finite elements (shell.py), explicit in time, and its vibration modes.

The plating is the plane z = 0, wet on the side of +z; the frames run along x and lie below. All four edges of the plating and the ends of the frames
are clamped. Dimensions: README.md, "The panel".
"""

import numpy as np
import scipy.sparse
import scipy.sparse.linalg
from shell import Shell, von_mises

LENGTH, SPACING, BAYS = 2.0, 0.4, 5  # [m] span of the frames, their spacing
PLATING, WEB, FLANGE = 0.020, 0.014, 0.016  # [m] thickness
HEIGHT, BREADTH = 0.300, 0.100  # [m] of the frames, between the middle surfaces; of their flange
YOUNG, POISSON, DENSITY, YIELD = 206e9, 0.3, 7850.0, 355e6  # [Pa] [-] [kg/m³] [Pa]
SAFETY = 0.9  # of the stable step


def grid(first, second, corner, counts, offset):
    """Nodes of a rectangle with the sides `first` and `second` from `corner`, and its quadrilaterals numbered from `offset`."""
    along, across = (np.linspace(0, 1, n + 1) for n in counts)
    points = np.array(corner) + np.array([a * np.array(first) + b * np.array(second) for b in across for a in along])
    row = counts[0] + 1
    lower = (np.arange(counts[1])[:, None] * row + np.arange(counts[0])).ravel() + offset
    return points, np.column_stack([lower, lower + 1, lower + row + 1, lower + row])


def merged(points, quads):
    """The same mesh with nodes at one place merged; the first of them keeps its place in the order."""
    keys = np.round(points / 1e-6).astype(np.int64)
    _, first, to = np.unique(keys, axis=0, return_index=True, return_inverse=True)
    order = np.argsort(first)
    rank = np.empty_like(order)
    rank[order] = np.arange(len(order))
    return points[first[order]], rank[to.ravel()][quads]


def panel_mesh(per_bay=8):
    """Vertices, quads, thickness and part (0 plating, 1 webs, 2 flanges) of each quad. The nodes of the plating come first. per_bay: elements between two frames."""
    along = round(LENGTH / (SPACING / per_bay))
    up = max(2, round(HEIGHT / (SPACING / per_bay)))
    width = BAYS * SPACING
    parts = [((LENGTH, 0, 0), (0, width, 0), (0, 0, 0), (along, BAYS * per_bay), PLATING, 0)]
    for frame in range(1, BAYS):
        y = frame * SPACING
        parts.append(((LENGTH, 0, 0), (0, 0, -HEIGHT), (0, y, 0), (along, up), WEB, 1))
        parts.append(((LENGTH, 0, 0), (0, BREADTH, 0), (0, y - BREADTH / 2, -HEIGHT), (along, 2), FLANGE, 2))
    points, quads, thickness, names = np.zeros((0, 3)), np.zeros((0, 4), int), [], []
    for first, second, corner, counts, t, part in parts:
        more, cells = grid(first, second, corner, counts, len(points))
        points, quads = np.vstack([points, more]), np.vstack([quads, cells])
        thickness += [t] * len(cells)
        names += [part] * len(cells)
    points, quads = merged(points, quads)
    points -= [LENGTH / 2, width / 2, 0]
    return points, quads, np.array(thickness), np.array(names)


class Model:
    """The panel's matrices, with the clamped degrees of freedom, and its wetted surface: vertices 0 … wet - 1 and `faces`."""

    def __init__(self, per_bay=8, mesh=None, clamped=None):
        self.mesh = mesh or panel_mesh(per_bay)
        points, quads, thickness, self.part = self.mesh
        self.shell = Shell(points, quads, thickness, YOUNG, POISSON, DENSITY)
        self.points, self.faces = points, quads[self.part == 0]
        self.wet = self.faces.max() + 1
        if clamped is None:
            span, width = np.abs(points[:, 0]), np.abs(points[:, 1])
            clamped = (span > LENGTH / 2 - 1e-9) | (width > BAYS * SPACING / 2 - 1e-9)
        self.clamped = clamped
        self.free = np.repeat(~clamped, 6)
        shell = self.shell
        self.mass = np.column_stack([*[shell.masses] * 3, *[shell.inertias] * 3]).ravel()
        self.stiffness = shell.stiffness
        self.inner = self.stiffness[self.free][:, self.free].tocsr()

    def stable_step(self):
        """[s] 2/ω of the stiffest mode of the mesh."""
        scale = scipy.sparse.diags(1 / np.sqrt(self.mass[self.free]))
        largest = scipy.sparse.linalg.eigsh(scale @ self.inner @ scale, k=1, which="LM", tol=1e-3, return_eigenvectors=False)[0]
        return 2 / np.sqrt(1.002 * largest)

    def solve(self, forces):
        """(n, 6) static displacements under forces (n, 6)."""
        u = np.zeros(self.free.size)
        u[self.free] = scipy.sparse.linalg.spsolve(self.inner.tocsc(), np.asarray(forces).ravel()[self.free])
        return u.reshape(-1, 6)

    def pressure(self, value):
        """(n, 6) forces of a pressure [Pa] on the plating, towards -z: a number, or a function of the x and y of a place. Four Gauss points in each element."""
        corners = self.points[self.faces]
        forces = np.zeros((len(self.points), 6))
        areas = self.shell.areas[self.part == 0]
        for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
            a, b = a / np.sqrt(3), b / np.sqrt(3)
            shape = np.array([(1 - a) * (1 - b), (1 + a) * (1 - b), (1 + a) * (1 + b), (1 - a) * (1 + b)]) / 4
            place = np.einsum("c,ecd->ed", shape, corners)
            p = value(place[:, 0], place[:, 1]) if callable(value) else np.full(len(place), value)
            for c in range(4):
                np.add.at(forces[:, 2], self.faces[:, c], -p * shape[c] * areas / 4)
        return forces

    def modes(self, count):
        """Angular frequencies [rad/s] and shapes (6n, count) [1/√kg] of the lowest modes, of unit modal mass."""
        mass = scipy.sparse.diags(self.mass[self.free])
        values, vectors = scipy.sparse.linalg.eigsh(self.inner.tocsc(), k=count, M=mass.tocsc(), sigma=0)
        shapes = np.zeros((self.free.size, count))
        shapes[self.free] = vectors / np.sqrt(np.einsum("ik,i,ik->k", vectors, self.mass[self.free], vectors))
        return np.sqrt(values), shapes

    def wet_stresses(self, displacements):
        """(wet, 6) or (wet, 6, k) [Pa] xx, yy, zz, xy, yz, zx at the wetted vertices, on their wet side: the mean of the elements around each."""
        centre = (self.shell.stresses @ displacements).reshape(len(self.part), 6, -1)[self.part == 0]
        total, count = np.zeros((self.wet, 3, centre.shape[2])), np.zeros(self.wet)
        for corner in self.faces.T:
            np.add.at(total, corner, centre[:, :3])
            np.add.at(count, corner, 1)
        mean = total / count[:, None, None]
        zero = np.zeros_like(mean[:, 0])
        return np.stack([mean[:, 0], mean[:, 1], zero, mean[:, 2], zero, zero], axis=1).reshape(self.wet, 6, *displacements.shape[1:])

    def largest_stress(self, displacements):
        """[Pa] von Mises, at the centres of elements: plating, webs, flanges."""
        stress = von_mises(self.shell.stresses @ displacements)
        return [stress[self.part == part].max() if (self.part == part).any() else 0.0 for part in range(3)]


class ExplicitPanel:
    """The model in time, by central differences: velocities are those in the middle of a step. A structure of perimpact.Simulation.

    load      function of time [s]: (n, 6) forces at that time, besides contact
    damping   [1/s] α of forces -α M v
    """

    def __init__(self, model, load=None, damping=0.0):
        self.model, self.load, self.damping = model, load, damping
        self.u = np.zeros(model.free.size)
        self.v = np.zeros_like(self.u)
        self.forces = np.zeros_like(self.u)  # K u at the beginning of the step
        self.inverse = np.where(model.free, 1 / model.mass, 0)
        self.masses = np.where(model.clamped, np.inf, model.shell.masses)[: model.wet]
        self.support_impulse = np.zeros(3)  # [N s] of the clamped nodes on the panel
        self.contact_impulse = np.zeros(3)  # [N s] of the contact on the panel
        self.load_impulse = np.zeros(3)  # [N s] of the load
        self.work = self.damped = 0.0  # [J] of the load; dissipated by damping
        self.dt = None

    def advance(self, time, dt):
        """(wet, 3) [m] positions of the wetted vertices at time + dt."""
        self.dt = dt
        self.forces = self.model.stiffness @ self.u
        total = -self.forces
        if self.load is not None:
            given = np.asarray(self.load(time)).ravel()
            total = total + given
        slowed = 1 - self.damping * dt / 2, 1 + self.damping * dt / 2
        before = self.v
        self.v = (slowed[0] * before + dt * self.inverse * total) / slowed[1]
        mean = (before + self.v) / 2
        self.u = self.u + dt * self.v
        if self.load is not None:
            self.work += dt * given @ mean
            self.load_impulse += dt * given.reshape(-1, 6)[:, :3].sum(axis=0)
        self.damped += dt * self.damping * (self.model.mass * mean) @ mean
        self.support_impulse -= dt * total.reshape(-1, 6)[self.model.clamped, :3].sum(axis=0)
        self.support_impulse -= dt * self.damping * (self.model.mass * mean).reshape(-1, 6)[~self.model.clamped, :3].sum(axis=0)
        return self.positions()

    def apply(self, impulses):
        """Contact impulses (wet, 3) [N s] of this step."""
        change = np.zeros((len(self.model.points), 6))
        change[: self.model.wet, :3] = impulses
        change = self.inverse * change.ravel()
        self.v = self.v + change
        self.u = self.u + self.dt * change
        self.contact_impulse += impulses.sum(axis=0)
        self.support_impulse -= impulses[self.model.clamped[: self.model.wet]].sum(axis=0)

    def positions(self):
        return self.model.points[: self.model.wet] + self.displacements()[: self.model.wet]

    def displacements(self):
        return self.u.reshape(-1, 6)[:, :3]

    @property
    def momentum(self):
        """(3,) [N s]"""
        return (self.model.mass * self.v).reshape(-1, 6)[:, :3].sum(axis=0)

    @property
    def kinetic_energy(self):
        """[J] in the middle of the last step."""
        return 0.5 * (self.model.mass * self.v) @ self.v

    @property
    def elastic_energy(self):
        """[J] ½ u(t0)·K u(t1): with the kinetic energy in between, central differences conserve the sum exactly."""
        return 0.5 * self.forces @ self.u

    @property
    def energy(self):
        """[J] what perimpact.Simulation includes in its energy balance: less the work of the load, and with what damping has dissipated."""
        return self.kinetic_energy + self.elastic_energy - self.work + self.damped
