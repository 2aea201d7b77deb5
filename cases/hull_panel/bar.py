#!/usr/bin/python3
"""A compressive pulse runs along a bar of finite elements into a peridynamic bar in contact with it, and is reflected as the impedances require:

    PYTHONPATH=build/release/python cases/hull_panel/bar.py [1 [0.5 [2]]]      impedance of the peridynamic bar over that of the finite elements

With Z = ρ c, a pulse of stress σ that comes from the finite elements (Z₁) causes a reflected one R σ and a transmitted one T σ,
R = (Z₂ - Z₁)/(Z₂ + Z₁), T = 2 Z₂/(Z₁ + Z₂) (K. F. Graff: Wave Motion in Elastic Solids, 1975, section 2.3). Both bars have the same speed of sound; the impedance is
changed through Young's modulus and density. Poisson's ratio is 0, so that the wave is that of one dimension.

The finite elements are 8-node hexahedra of dolfinx, with 2×2×2 Gauss points and lumped masses, central differences; the end of the bar in contact with the other one is the
surface of an impactor, moved by this program in each step. The pulse enters as a pressure ½ P (1 - cos(2πt/τ)) on the other end.

Coefficients are ratios of impulses, the integrals of the pulse over time: those do not depend on dispersion, which lowers peaks.
"""

import argparse

import dolfinx.fem.petsc  # noqa: F401
import numpy as np
import perimpact
import scipy.sparse
import ufl
from dolfinx import fem
from dolfinx.mesh import create_mesh
from mpi4py import MPI
from shell import to_scipy

YOUNG, DENSITY = 1.8e9, 900.0  # [Pa] [kg/m³] of the finite elements
LENGTH, WIDTH, SIZE = 1.2, 0.08, 0.01  # [m] of each bar; of an element, and the spacing of the particles
PRESSURE, DURATION = 1e5, 0.5e-3  # [Pa] [s] of the pulse
GAUGE = 0.5 * LENGTH  # [m] from the interface, in both bars
DRIFT = 0.02  # [m/s] of both bars together: the check for an unstable step compares energies with that of the bodies at t = 0, which must not be zero
SPEED = np.sqrt(YOUNG / DENSITY)  # [m/s]
STEP = 0.4 * SIZE / SPEED
END = (LENGTH + GAUGE) / SPEED + 1.4 * DURATION


class FiniteBar:
    """A bar along z, from -LENGTH to 0; a structure of perimpact.Simulation, whose surface is the end z = 0."""

    def __init__(self):
        across, along = round(WIDTH / SIZE), round(LENGTH / SIZE)
        x, z = np.linspace(-WIDTH / 2, WIDTH / 2, across + 1), np.linspace(-LENGTH, 0, along + 1)
        self.points = np.array([[a, b, c] for c in z for b in x for a in x])
        row, layer = across + 1, (across + 1) ** 2
        first = np.array([k * layer + j * row + i for k in range(along) for j in range(across) for i in range(across)])
        corners = np.array([a + b * row + c * layer for c in (0, 1) for b in (0, 1) for a in (0, 1)])
        self.end = np.arange(len(self.points) - layer, len(self.points))
        self.faces = np.array([[j * row + i, j * row + i + 1, (j + 1) * row + i + 1, (j + 1) * row + i] for j in range(across) for i in range(across)])
        self._assemble(first[:, None] + corners)
        self.u, self.v = np.zeros(self.mass.size), np.zeros(self.mass.size)
        self.v[2::3] = DRIFT
        self.masses = self.mass[2::3][self.end]
        self.reach = self.points[:, 2] < -LENGTH + 1e-9  # the loaded end
        self.gauge = np.argmin(np.abs(z + GAUGE)) * layer + np.arange(layer)
        self.forces, self.load_impulse, self.work, self.dt = np.zeros(self.mass.size), 0.0, 0.0, 0.0

    def _assemble(self, cells):
        domain = create_mesh(MPI.COMM_SELF, cells, self.points, ufl.Mesh(ufl.VectorElement("Lagrange", ufl.hexahedron, 1)))
        space = fem.VectorFunctionSpace(domain, ("Lagrange", 1))
        trial, test = ufl.TrialFunction(space), ufl.TestFunction(space)
        stiffness = to_scipy(YOUNG * ufl.inner(ufl.sym(ufl.grad(trial)), ufl.sym(ufl.grad(test))) * ufl.dx(metadata={"quadrature_degree": 2}))
        node = np.empty(len(self.points), int)
        for cell in range(len(cells)):
            node[np.asarray(domain.geometry.input_global_indices)[domain.geometry.dofmap.links(cell)]] = space.dofmap.cell_dofs(cell)
        order = (3 * node[:, None] + np.arange(3)).ravel()
        self.stiffness = scipy.sparse.csr_matrix(stiffness[order][:, order])
        self.mass = np.zeros(3 * len(self.points))
        for corner in cells.T:
            for axis in range(3):
                np.add.at(self.mass, 3 * corner + axis, DENSITY * SIZE**3 / 8)

    def pressure(self, time):
        return PRESSURE / 2 * (1 - np.cos(2 * np.pi * time / DURATION)) if 0 < time < DURATION else 0.0

    def advance(self, time, dt):
        self.dt = dt
        self.forces = self.stiffness @ self.u
        load = np.zeros_like(self.u)
        load[2::3][self.reach] = self.pressure(time) * self.mass[2::3][self.reach] / (DENSITY * SIZE / 2)  # half an element of length belongs to each node
        before = self.v
        self.v = before + dt * (load - self.forces) / self.mass
        self.u = self.u + dt * self.v
        self.load_impulse += dt * load.sum()
        self.work += dt * load @ (before + self.v) / 2
        return self.positions()

    def apply(self, impulses):
        change = np.zeros_like(self.u).reshape(-1, 3)
        change[self.end] = impulses / self.masses[:, None]
        self.v = self.v + change.ravel()
        self.u = self.u + self.dt * change.ravel()

    def positions(self):
        return self.points[self.end] + self.u.reshape(-1, 3)[self.end]

    @property
    def kinetic_energy(self):
        """[J] in the middle of the last step."""
        return 0.5 * (self.mass * self.v) @ self.v

    @property
    def elastic_energy(self):
        """[J] as that of panel.ExplicitPanel."""
        return 0.5 * self.forces @ self.u

    @property
    def unbalanced(self):
        """[J] kinetic and elastic energy less the work of the pressure: what the bar has passed on, negative. It is not named `energy`, which would make perimpact.Simulation
        include it in its balance: its check of an unstable step would then compare with an initial energy of 0."""
        return self.kinetic_energy + self.elastic_energy - self.work

    @property
    def momentum(self):
        """(3,) [N s]"""
        return (self.mass * self.v).reshape(-1, 3).sum(axis=0)


def setup_of(ratio, bar):
    """The peridynamic bar of an impedance `ratio` times that of the finite elements, in front of the bar's end."""
    gap = 1e-9
    body = {"shape": {"box": {"size": [WIDTH, WIDTH, LENGTH]}}, "position": [0, 0, LENGTH / 2 + gap], "velocity": [0, 0, DRIFT], "spacing": SIZE,
            "material": {"model": "ordinary-state", "youngs_modulus": ratio * YOUNG, "poissons_ratio": 0.0, "density": ratio * DENSITY}}  # fmt: skip
    surface = {"file": perimpact.Mesh(bar.points[bar.end], bar.faces), "orientation": "normals"}
    return {"time": {"end": END, "step": STEP}, "bodies": {"bar": body}, "impactors": {"end": {"surface": surface, "mass": 1.0}}, "output": {"frames": 0, "history_interval": 10 * STEP}}


def run(ratio):
    """Times [s], velocity [m/s] along z at the gauges of both bars; largest residuals of momentum and energy over the impulse and the work of the pulse."""
    bar = FiniteBar()
    simulation = perimpact.Simulation(setup_of(ratio, bar), structures={"end": bar})
    body = simulation.bodies["bar"]
    places = body.positions[body.slots]
    middle = body.slots[np.abs(places[:, 2] - GAUGE) < 0.6 * SIZE]
    particle = ratio * DENSITY * SIZE**3
    times, finite, particles, energy, momentum = [], [], [], [], 0.0

    def momentum_now():
        return bar.momentum[2] + particle * body.velocities[body.slots, 2].sum()

    start, passed_on = momentum_now(), bar.unbalanced

    def record(simulation):
        nonlocal momentum
        times.append(simulation.time)
        finite.append((bar.mass.reshape(-1, 3)[bar.gauge, 2] @ bar.v.reshape(-1, 3)[bar.gauge, 2]) / bar.mass.reshape(-1, 3)[bar.gauge, 2].sum() - DRIFT)
        particles.append(body.velocities[middle, 2].mean() - DRIFT)
        energy.append(bar.unbalanced)
        momentum = max(momentum, abs(momentum_now() - start - bar.load_impulse))

    simulation.run(callback=record)
    history = simulation.history
    of_bar = np.interp(history["time [s]"], [0.0, *(np.array(times) - STEP / 2)], [passed_on, *energy])  # known in the middle of each step
    total = history["total.energy [J]"] + history["total.contact_dissipation [J]"] + of_bar
    return {"times": np.array(times), "finite": np.array(finite), "particles": np.array(particles), "momentum": momentum / bar.load_impulse,
            "energy": np.abs(total - total[0]).max() / bar.work, "dissipation": history["total.contact_dissipation [J]"][-1] / bar.work}  # fmt: skip


def coefficients(found):
    """Reflected and transmitted impulse over the incident one, as stresses: σ = -Z v forwards, Z v backwards; the transmitted one is still without the factor Z₂/Z₁. Last
    the largest reflected stress over the largest incident one, at any time."""
    times, finite = found["times"], found["finite"]
    arrives = (LENGTH - GAUGE) / SPEED
    parted = arrives + DURATION + GAUGE / SPEED - DURATION / 2  # halfway between the incident pulse and the reflected one
    incident = np.trapz(np.where(times < parted, finite, 0), times)
    reflected = np.trapz(np.where(times >= parted, finite, 0), times)
    peak = np.abs(finite[times >= parted]).max() / finite[times < parted].max()
    return -reflected / incident, np.trapz(found["particles"], times) / incident, peak


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("ratios", metavar="RATIO", type=float, nargs="*", default=[1.0, 0.5])
    given = arguments.parse_args()
    perimpact.use_threads(1)
    for ratio in given.ratios:
        found = run(ratio)
        reflection, transmission, peak = coefficients(found)
        transmission *= ratio
        print(f"Z2/Z1 = {ratio:g}: reflection {reflection:.4f}, theory {(ratio - 1) / (ratio + 1):.4f}; transmission {transmission:.4f}, theory {2 * ratio / (1 + ratio):.4f}; largest reflected stress {peak:.4f}; "
              f"residual of momentum {found['momentum']:.1e} of the impulse, of energy {found['energy']:.1e} of the work, contact dissipates {found['dissipation']:.1e} of it")  # fmt: skip


if __name__ == "__main__":
    main()
