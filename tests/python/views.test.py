"""Views of particles and impactors in Python."""

import copy

import package
from claims import claim, main

import numpy as np
import perimpact


def every_step():
    """The small plate with a history row per step, at a time of contact."""
    setup = copy.deepcopy(package.SETUP)
    setup["output"]["history_interval"] = 1e-9  # less than a step
    simulation = perimpact.Simulation(setup)
    simulation.run(until=12e-6)
    return simulation


@claim("positions view the simulation's memory: they show every step, are read-only, and outlive the simulation variable")
def views(test):
    simulation = perimpact.Simulation(package.SETUP)
    plate = simulation.bodies["plate"]
    positions, before = plate.positions, plate.positions.copy()
    test.assertFalse(positions.flags.owndata)
    test.assertEqual(positions.__array_interface__["data"][0], plate.positions.__array_interface__["data"][0])
    with test.assertRaises(ValueError):
        positions[0, 0] = 1
    simulation.run(until=12e-6)
    test.assertFalse(np.array_equal(positions, before))
    now = positions.copy()
    del simulation, plate
    test.assertTrue(np.array_equal(positions, now))


@claim("slots, occupied and lattice_shape locate the particles in the arrays")
def slots(test):
    plate = perimpact.Simulation(package.SETUP).bodies["plate"]
    test.assertEqual(len(plate), 20 * 12 * 4)
    test.assertEqual(plate.lattice_shape, [4, 12, 24])  # 20 cells in x, rounded up to packs of eight
    test.assertEqual(plate.positions.shape, (4 * 12 * 24, 3))
    test.assertEqual(plate.slots.tolist(), np.flatnonzero(plate.occupied).tolist())
    grid = plate.references.reshape(*plate.lattice_shape, 3)[:, :, :20]
    x, y, z = (-0.5 * (n - 1) * 5e-3 + 5e-3 * np.arange(n) for n in (20, 12, 4))
    wanted = np.stack(np.broadcast_arrays(x[None, None, :], y[None, :, None], z[:, None, None]), axis=-1)
    np.testing.assert_allclose(grid, wanted, rtol=0, atol=1e-16)  # positions of centimetres, one or two roundings
    test.assertEqual(plate.spacing, 0.005)
    np.testing.assert_allclose(plate.volumes.sum() * plate.density, plate.mass, rtol=1e-13)  # sums of 960 equal numbers in another order
    np.testing.assert_allclose(plate.mass, 0.1 * 0.06 * 0.02 * 8000, rtol=1e-13)


@claim("displacements, momentum and damage follow from positions, velocities and broken bonds")
def derived(test):
    setup = copy.deepcopy(package.SETUP)
    setup["bodies"]["plate"]["material"]["critical_stretch"] = 1e-4  # less than the stretch of this impact
    simulation = perimpact.Simulation(setup)
    simulation.run(until=15e-6)
    plate = simulation.bodies["plate"]
    slots = plate.slots
    np.testing.assert_array_equal(plate.displacements[slots], plate.positions[slots] - plate.references[slots])
    test.assertTrue((plate.displacements[~plate.occupied] == 0).all())
    momentum = (plate.density * plate.volumes[slots, None] * plate.velocities[slots]).sum(axis=0)
    np.testing.assert_allclose(plate.momentum, momentum, rtol=0, atol=1e-12 * np.abs(plate.velocities[slots]).max())  # 960 terms in another order
    test.assertGreater(plate.broken_bonds, 0)
    test.assertGreater(plate.damages.max(), 0)
    test.assertTrue(((plate.damages >= 0) & (plate.damages <= 1)).all())
    # no damage without broken bonds: each of the 122 bonds of a family is at least a thousandth
    test.assertEqual(simulation.history["plate.broken_bonds [-]"].max() > 0, True)


@claim("force and moment of an impactor are the impulses of its contacts over the step, and equal the history row of each step")
def force(test):
    simulation = every_step()
    cylinder = simulation.impactors["cylinder"]
    struck = 0
    while not simulation.is_finished:
        simulation.step()
        contacts = cylinder.contacts
        row = {column: values[-1] for column, values in simulation.history.items()}
        scale = max(np.abs(contacts["impulse"]).sum() / simulation.dt, 1)  # [N]
        rounding = 1e-12 * scale  # sums of tens of terms in another order
        np.testing.assert_allclose(cylinder.force, contacts["impulse"].sum(axis=0) / simulation.dt, rtol=0, atol=rounding)
        np.testing.assert_allclose(cylinder.force, [row[f"cylinder.force_{c} [N]"] for c in "xyz"], rtol=0, atol=rounding)
        arms = contacts["position"] - cylinder.position
        np.testing.assert_allclose(cylinder.moment, np.cross(arms, contacts["impulse"]).sum(axis=0) / simulation.dt, rtol=0, atol=rounding)
        test.assertEqual(len(contacts), row["cylinder.contacts [-]"])
        struck += len(contacts)
    test.assertGreater(struck, 50)


@claim("contacts list particles on the surface, with the outward normal")
def contacts(test):
    simulation = every_step()
    cylinder, plate = simulation.impactors["cylinder"], simulation.bodies["plate"]
    contacts = cylinder.contacts
    test.assertGreater(len(contacts), 0)
    test.assertTrue((contacts["body"] == 0).all())
    np.testing.assert_array_equal(plate.positions[contacts["slot"]], contacts["position"])
    # the axis is z through the centre of mass: half a spacing, the contact radius, from the panels, which are chords of the circle of 40 mm
    off = (contacts["position"] - cylinder.position)[:, :2]
    sagitta = 0.02 * (1 - np.cos(0.5 * 0.004 / 0.02))  # panels are at most 4 mm long
    distance = np.linalg.norm(off, axis=1)
    test.assertTrue(((distance > 0.0225 - sagitta - 1e-9) & (distance < 0.0225 + 1e-9)).all(), distance)
    along = (contacts["normal"][:, :2] * off).sum(axis=1) / distance
    test.assertTrue((along > np.cos(0.15)).all(), along)  # half the angle of a panel, 0.1, plus the deviation of chords
    test.assertTrue(((contacts["time_fraction"] >= 0) & (contacts["time_fraction"] <= 1)).all())


@claim("the surface of an impactor, transformed by its pose, is at the position of the impactor")
def surface(test):
    setup = copy.deepcopy(package.SETUP)
    setup["impactors"]["cylinder"].update(angular_velocity=[0, 0, 5000], velocity=[0, 0, 0], position=[0, 0.06, 0])
    simulation = perimpact.Simulation(setup)
    cylinder = simulation.impactors["cylinder"]
    test.assertEqual(cylinder.origin.tolist(), [0, 0.06, 0])
    simulation.run()
    angle = 5000 * simulation.time
    wanted = [[np.cos(angle), -np.sin(angle), 0], [np.sin(angle), np.cos(angle), 0], [0, 0, 1]]
    np.testing.assert_allclose(cylinder.rotation, wanted, rtol=0, atol=1e-12)  # a hundred rotations by quaternions
    world = cylinder.vertices @ cylinder.rotation.T + cylinder.origin
    test.assertAlmostEqual(np.linalg.norm((world - cylinder.position)[:, :2], axis=1).max(), 0.02, places=12)
    corners = world[cylinder.triangles]
    volume = np.einsum("ti,ti->t", corners[:, 0] - cylinder.position, np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])).sum() / 6
    test.assertAlmostEqual(volume / (np.pi * 0.02**2 * 0.04), 1, delta=0.01)  # chords of 4 mm on a circle of 40 mm miss (0.2)²/6 = 0.7 %
    test.assertEqual(cylinder.mass, 1)


@claim("faces are the panels of a surface over current_vertices, numbered as in contacts, where the surface is welded and where it is not")
def faces(test):
    def area(vertices, triangles):
        corners = vertices[triangles]
        return 0.5 * np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1).sum()

    box = perimpact.Mesh.box([0.04, 0.04, 0.04])
    triangles = np.concatenate([box.faces[:, [0, 1, 2]], box.faces[box.faces[:, 3] >= 0][:, [0, 2, 3]]])
    apart = perimpact.Mesh(box.vertices[triangles].reshape(-1, 3), np.arange(3 * len(triangles)).reshape(-1, 3))  # as in an STL file
    setup = copy.deepcopy(package.SETUP)
    setup["impactors"]["cylinder"]["surface"] = {"file": apart}
    simulation = perimpact.Simulation(setup)
    simulation.run(until=15e-6)
    block = simulation.impactors["cylinder"]
    test.assertEqual((block.vertices.shape, block.current_vertices.shape, block.faces.shape), ((8, 3), (36, 3), (12, 4)))
    test.assertEqual(block.faces.tolist(), apart.faces.tolist())
    for vertices, numbers in (block.current_vertices, block.faces[:, :3]), (block.vertices, block.triangles):
        np.testing.assert_allclose(area(vertices, numbers), 6 * 0.04**2, rtol=1e-12)  # 12 triangles
    contacts = block.contacts
    test.assertGreater(len(contacts), 0)
    corners = block.current_vertices[block.faces[contacts["panel"], :3]]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    np.testing.assert_allclose(normals / np.linalg.norm(normals, axis=1)[:, None], contacts["normal"], rtol=0, atol=1e-12)


@claim("when a moving window moves, slots keep their numbers and their particles change")
def moving_window(test):
    setup = copy.deepcopy(package.SETUP)
    setup["bodies"]["plate"].update(shape={"box": {"size": [0.08, 0.06, 0.02]}}, moving_window={"follow": "cylinder", "axis": "x", "start_after": 0})
    setup["impactors"]["cylinder"].update(position=[0, 0.0505, 0], velocity=[6000, -100, 0], free_dofs=[])
    del setup["output"]["probes"], setup["output"]["lines"]
    simulation = perimpact.Simulation(setup)
    plate = simulation.bodies["plate"]
    slots, references = plate.slots, plate.references
    simulation.run()
    travel = simulation.history["plate.window_travel [m]"][-1]
    test.assertGreater(travel, 0.01)
    test.assertEqual(plate.slots.tolist(), slots.tolist())
    np.testing.assert_allclose((plate.references - references)[slots], np.broadcast_to([travel, 0, 0], (len(plate), 3)), rtol=0, atol=1e-15)  # of 0.1 m


main()
