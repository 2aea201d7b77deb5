"""Structures that move the surface of an impactor."""

import copy

import package
from claims import claim, main

import numpy as np
import perimpact

SIDE, CELLS = 0.06, 12
perimpact.use_threads(1)  # small loops, beside other tests


def sheet():
    """Vertices of a square sheet in the plane z = 0, and its quads with normals along z."""
    places = np.linspace(-SIDE / 2, SIDE / 2, CELLS + 1)
    vertices = np.array([[x, y, 0.0] for y in places for x in places])
    number = np.arange(len(vertices)).reshape(CELLS + 1, CELLS + 1)
    quads = np.stack([number[:-1, :-1], number[:-1, 1:], number[1:, 1:], number[1:, :-1]], -1).reshape(-1, 4)
    return vertices, quads


class Net:
    """Vertices of a sheet, joined by springs along the edges of the quads; explicit, symplectic Euler."""

    def __init__(self, mass, stiffness):
        self.x, quads = sheet()
        self.v = np.zeros_like(self.x)
        self.masses = np.full(len(self.x), mass)
        self.ends = np.unique(np.sort(np.concatenate([quads[:, [k, (k + 1) % 4]] for k in range(4)]), axis=1), axis=0)
        self.stiffness, self.length, self.dt = stiffness, SIDE / CELLS, 0.0
        self.last = np.zeros_like(self.x)

    def stretched(self):
        along = self.x[self.ends[:, 1]] - self.x[self.ends[:, 0]]
        length = np.linalg.norm(along, axis=1)
        return along / length[:, None], length - self.length

    def forces(self):
        direction, extension = self.stretched()
        pull = self.stiffness * extension[:, None] * direction
        force = np.zeros_like(self.x)
        np.add.at(force, self.ends[:, 0], pull), np.add.at(force, self.ends[:, 1], -pull)
        return force

    def advance(self, time, dt):
        self.dt = dt
        self.v = self.v + dt * self.forces() / self.masses[:, None]
        self.x = self.x + dt * self.v
        return self.x

    def apply(self, impulses):
        self.last = impulses
        change = impulses / self.masses[:, None]
        self.v, self.x = self.v + change, self.x + self.dt * change

    @property
    def energy(self):
        half = self.v + 0.5 * self.dt * self.forces() / self.masses[:, None] + 0.5 * self.last / self.masses[:, None]  # at the end of the step
        return 0.5 * (self.masses * (half**2).sum(1)).sum() + 0.5 * self.stiffness * (self.stretched()[1] ** 2).sum()


def block_on_sheet(speed=20.0, **impactor):
    """A block of ice in free flight, just above the sheet."""
    vertices, quads = sheet()
    setup = copy.deepcopy(package.SETUP)
    setup["time"] = {"end": 1e-3, "step": 0.67e-6}  # half of the automatic step, for the stiff net
    setup["bodies"] = {
        "block": {
            "shape": {"box": {"size": [0.024, 0.024, 0.016]}},
            "position": [0.001, 0.002, 0.0101],
            "velocity": [3.0, 0, -speed],
            "spacing": 0.002,
            "material": {"model": "ordinary-state", "youngs_modulus": 1e9, "poissons_ratio": 0.25, "density": 900},
        }
    }
    setup["impactors"] = {"net": {"surface": {"file": perimpact.Mesh(vertices, quads), "orientation": "normals"}, "mass": 1, **impactor}}
    setup["output"] = {"folder": "results", "frames": 2, "history_interval": 2e-6}
    return setup


@claim("a block and a net of NumPy that it hits exchange momentum exactly, and energy closes over both")
def net(test):
    for friction in (0.0, 0.3):
        setup = block_on_sheet()
        setup["contact"]["impactors"]["friction"] = friction
        structure = Net(mass=2e-5, stiffness=2e4)  # a particle has 7.2e-6 kg, and one or two of them meet each vertex
        simulation = perimpact.Simulation(setup, structures={"net": structure})
        before = simulation.bodies["block"].momentum
        simulation.run()
        block, history = simulation.bodies["block"], simulation.history
        given = (structure.masses[:, None] * structure.v).sum(0)
        test.assertGreater(given[2], -20 * block.mass)
        test.assertLess(given[2], -0.15 * 20 * block.mass)  # a substantial part of the block's momentum
        np.testing.assert_allclose(block.momentum + given, before, rtol=0, atol=1e-12 * np.abs(before).max())
        energy, error, dissipated = (history[f"total.{name} [J]"] for name in ("energy", "energy_balance_error", "contact_dissipation"))
        test.assertLess(np.abs(error).max(), 0.01 * energy[0])  # measured 0.5 %, and 0.2 % at half of the step
        test.assertGreaterEqual(np.diff(dissipated).min(), -1e-3 * energy[0])  # contact does not add energy
        test.assertLess(dissipated[-1], 0.5 * energy[0])
        deepest = simulation.impactors["net"].current_vertices[:, 2].min()
        test.assertLess(deepest, -1e-3)
        np.testing.assert_allclose(simulation.impactors["net"].current_vertices, structure.x, rtol=0, atol=1e-9)


@claim("a structure with infinite masses at rest is a rigid impactor at rest")
def rigid(test):
    class Still:
        masses = np.full((CELLS + 1) ** 2, np.inf)

        def advance(self, time, dt):
            return sheet()[0]

        def apply(self, impulses):
            pass

    still = Still()
    moved, fixed = perimpact.Simulation(block_on_sheet(), structures={"net": still}), perimpact.Simulation(block_on_sheet())
    moved.run(), fixed.run()
    test.assertLess(fixed.history["net.force_z [N]"].min(), -1.0)
    for column in ("net.force_x [N]", "net.force_z [N]"):
        scale = np.abs(fixed.history["net.force_z [N]"]).max()
        np.testing.assert_allclose(moved.history[column], fixed.history[column], rtol=0, atol=1e-6 * scale)  # relocations differ by rounding
    a, b = moved.bodies["block"], fixed.bodies["block"]
    np.testing.assert_allclose(a.positions[a.slots], b.positions[b.slots], rtol=0, atol=1e-9)


@claim("a net at rest that loads push against a block at rest is no unstable step, though the balance starts from zero energy")
def loaded(test):
    class Pushed(Net):
        def forces(self):
            return super().forces() + np.array([0, 0, 0.05])  # [N] on each vertex

    setup = block_on_sheet(speed=0)
    setup["bodies"]["block"] |= {"velocity": [0, 0, 0], "position": [0.001, 0.002, 0.0081]}
    structure = Pushed(mass=2e-5, stiffness=2e4)
    simulation = perimpact.Simulation(setup, structures={"net": structure})
    simulation.run()
    block = simulation.bodies["block"]
    test.assertGreater(block.momentum[2], 1e-3 * block.mass)  # pushed
    test.assertGreater(simulation.history["total.energy [J]"][-1], 0)


@claim("structures that do not fit are refused with a sentence")
def refused(test):
    def complaint(structures, **changes):
        with test.assertRaises(perimpact.InputError) as raised:
            perimpact.Simulation(block_on_sheet(**changes), structures=structures)
        return str(raised.exception)

    net = Net(1.0, 1.0)
    test.assertEqual(complaint(3), 'structures is of type int, but it must be a dict {"impactor": object}.')
    test.assertEqual(complaint({3: net}), "structures: 3 is a key, but keys are names of impactors.")
    test.assertIn("impactor nets, which does not exist", complaint({"nets": net}))
    test.assertIn("has no masses", complaint({"net": object()}))
    net.masses = np.ones(3)
    test.assertIn("3 masses, but the surface has 169 vertices", complaint({"net": net}))
    test.assertIn("excludes velocities", complaint({"net": Net(1.0, 1.0)}, velocity=[0, 0, 1]))
    simulation = perimpact.Simulation(block_on_sheet(), structures={"net": Net(1e-3, 1.0)})
    with test.assertRaisesRegex(perimpact.InputError, "checkpoints do not contain the state of structures"):
        simulation.write_results(str(test.folder / "results"), resume=True)

    class Short(Net):
        def advance(self, time, dt):
            return super().advance(time, dt)[:-1]

    with test.assertRaisesRegex((perimpact.InputError, perimpact.RunError), "168 vertices, but the surface has 169"):
        perimpact.Simulation(block_on_sheet(), structures={"net": Short(1e-3, 1.0)}).run()


main()
