"""Copies of meshes and poses, and simulations that refer to themselves."""

import copy
import gc
import pickle
import weakref

import package
from claims import claim, main

import numpy as np
import perimpact
from perimpact import fccda


@claim("meshes are copied and pickled with every bit, and so is a set-up that contains one")
def meshes(test):
    corners = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0.5, 0.5, 1 / 3]])
    mesh = perimpact.Mesh(corners, [[0, 3, 2, 1], [0, 1, 4, -1], [1, 2, 4, -1], [2, 3, 4, -1], [3, 0, 4, -1]], ["floor", "roof", "roof", "roof", "roof"])
    for other in copy.copy(mesh), copy.deepcopy(mesh), pickle.loads(pickle.dumps(mesh)):
        test.assertIsInstance(other, perimpact.Mesh)
        test.assertEqual(other.vertices.tobytes(), mesh.vertices.tobytes())
        test.assertEqual(other.faces.tolist(), mesh.faces.tolist())
        test.assertEqual(other.parts, mesh.parts)
    plain = perimpact.Mesh.sphere(0.02)
    test.assertEqual(pickle.loads(pickle.dumps(plain)).parts, [])

    setup = copy.deepcopy(package.SETUP)
    setup["impactors"]["cylinder"].update(surface={"file": plain}, position=[0, 0.05, 0])
    runs = [perimpact.Simulation(each) for each in (setup, copy.deepcopy(setup), pickle.loads(pickle.dumps(setup)))]
    for run in runs:
        run.run(until=5e-6)
    test.assertEqual(len({run.state_hash for run in runs}), 1)


@claim("poses are copied and pickled with every bit")
def poses(test):
    pose = fccda.Pose(position=[1 / 3, 2, 3], attitude=np.array([1, 2, 3, 4]) / np.sqrt(30))
    for other in copy.copy(pose), copy.deepcopy(pose), pickle.loads(pickle.dumps(pose)):
        test.assertEqual((other.position.tolist(), other.attitude), (pose.position.tolist(), pose.attitude))
        test.assertEqual(other.rotation.tobytes(), pose.rotation.tobytes())
    test.assertEqual(fccda.Pose.__module__, "perimpact.fccda")


class Sentinel:
    """Whether it is alive shows whether a function that refers to it is."""


@claim("a simulation whose user force or structure refers to it, or to its bodies, is collected once nothing else does")
def collected(test):
    def with_force(refer):
        sentinel, held = Sentinel(), {}

        def force(time, body):
            assert sentinel and held is not None
            return [0, 0, 0]

        held["own"] = refer(perimpact.Simulation(package.SETUP, forces={"plate": {"force": force}}))
        return weakref.ref(sentinel)

    def run(simulation):
        simulation.run(until=2e-6)
        return simulation

    for name, refer in {
        "simulation": lambda simulation: simulation,
        "one that has run": run,
        "body": lambda simulation: (simulation, simulation.bodies["plate"]),
        "impactor alone": lambda simulation: simulation.impactors["cylinder"],
        "method": lambda simulation: simulation.step,
    }.items():
        alive = with_force(refer)
        gc.collect()
        test.assertIsNone(alive(), name)

    corners = np.array([[-0.05, 0.05, -0.05], [0.05, 0.05, -0.05], [0.05, 0.05, 0.05], [-0.05, 0.05, 0.05]])

    class Wall:
        masses = np.full(4, np.inf)

        def advance(self, time, dt):
            return corners

        def apply(self, impulses):
            pass

    wall = Wall()
    setup = copy.deepcopy(package.SETUP)
    setup["impactors"] = {"wall": {"surface": {"file": perimpact.Mesh(corners, [[0, 1, 2, 3]]), "orientation": "normals"}, "mass": 1}}
    wall.simulation = perimpact.Simulation(setup, structures={"wall": wall})
    wall.simulation.run(until=2e-6)
    alive = weakref.ref(wall)
    del wall
    gc.collect()
    test.assertIsNone(alive())


@claim("the garbage collector leaves a simulation alone as long as a body, an array or a variable refers to it")
def kept(test):
    def made(part):
        held = {}

        def force(time, body):
            gc.collect()  # within a step too
            return [1e6 * (held["calls"] > 0), 0, 0]

        held["calls"] = 1
        held["simulation"] = simulation = perimpact.Simulation(package.SETUP, forces={"plate": {"force": force}})
        simulation.run(until=2e-6)
        return part(simulation)

    body = made(lambda simulation: simulation.bodies["plate"])
    positions = made(lambda simulation: simulation.bodies["plate"].positions)
    simulation = made(lambda simulation: simulation)
    gc.collect()
    test.assertGreater(body.momentum[0], 0)
    test.assertTrue(np.array_equal(positions, body.positions))
    simulation.run(until=5e-6)
    test.assertGreater(simulation.bodies["plate"].momentum[0], body.momentum[0])


main()
