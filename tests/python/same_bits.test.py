"""Python and the command line give bitwise identical results and the same files."""

import copy

import package
from claims import claim, main

import numpy as np
import perimpact


def finished(simulation):
    simulation.run()
    return simulation.state_hash


@claim("a deck run from Python writes the same files as the command line, and reaches the same state")
def same_files(test):
    deck = test.folder / test.deck()
    test.expect_success("run", deck, "--out", "shell", "--threads", 1)
    simulation = perimpact.Simulation.from_deck(deck)
    simulation.write_results(str(test.folder / "asked"))
    simulation.run()
    test.assertTrue(simulation.is_finished)
    test.assertEqual(simulation.state_hash, test.report("shell")["state_hash"])
    test.assertEqual(test.files("asked"), test.files("shell"))
    for name in test.files("shell"):
        if name in ("run.json", "checkpoint.h5", "report.html"):  # contain wall-clock times; run.json is compared by its hash
            continue
        test.assertEqual((test.folder / "asked" / name).read_bytes(), (test.folder / "shell" / name).read_bytes(), name)
    test.assertEqual(test.report("asked")["outcome"], test.report("shell")["outcome"])


@claim("a dict with the keys of a deck gives a simulation bitwise identical to the deck's, with numbers or with units")
def same_dict(test):
    deck = test.folder / test.deck()
    wanted = finished(perimpact.Simulation.from_deck(deck))
    test.assertEqual(finished(perimpact.Simulation(package.SETUP)), wanted)
    arrays = copy.deepcopy(package.SETUP)
    arrays["bodies"]["plate"]["shape"]["box"]["size"] = np.array([0.1, 0.06, 0.02])
    arrays["bodies"]["plate"]["spacing"] = "5 mm"
    arrays["impactors"]["cylinder"]["mass"] = np.float64(1)
    arrays["impactors"]["cylinder"]["position"] = (0, 0.05, np.int32(0))
    test.assertEqual(finished(perimpact.Simulation(arrays)), wanted)
    test.assertEqual(finished(perimpact.Simulation(perimpact.read_deck(deck))), wanted)
    test.assertEqual(finished(perimpact.Simulation(perimpact.Simulation(package.SETUP).setup)), wanted)


@claim("a mesh from arrays gives bitwise the results of the same mesh from a file, and is refused as a file is")
def same_mesh(test):
    mesh = perimpact.Mesh.cylinder(diameter=0.04, height=0.04, edge_length=0.004)
    vertices, faces = mesh.vertices, mesh.faces[:, :3]
    lines = [f"v {x!r} {y!r} {z!r}" for x, y, z in vertices.tolist()] + [f"f {a} {b} {c}" for a, b, c in (faces + 1).tolist()]
    (test.folder / "cylinder.obj").write_text("\n".join(lines) + "\n")
    from_file, from_memory = copy.deepcopy(package.SETUP), copy.deepcopy(package.SETUP)
    from_file["impactors"]["cylinder"]["surface"] = {"file": "cylinder.obj", "rotate": ["0 deg", "0 deg", "10 deg"]}
    from_memory["impactors"]["cylinder"]["surface"] = {"file": perimpact.Mesh(vertices, faces), "rotate": ["0 deg", "0 deg", "10 deg"]}
    wanted = finished(perimpact.Simulation(from_file, folder=test.folder))
    test.assertEqual(finished(perimpact.Simulation(from_memory)), wanted)
    test.assertEqual(finished(perimpact.Simulation(perimpact.Simulation(from_memory).setup)), wanted)

    deck = test.folder / test.deck()
    surface = {"file": perimpact.Mesh(vertices, faces), "rotate": ["0 deg", "0 deg", "10 deg"]}
    test.assertEqual(finished(perimpact.Simulation.from_deck(deck, set={"impactors.cylinder.surface": surface})), wanted)

    from_memory["impactors"]["cylinder"]["surface"] = {"file": perimpact.Mesh(vertices, faces[:-1])}
    with test.assertRaises(perimpact.InputError) as refused:
        perimpact.Simulation(from_memory)
    test.assertTrue(str(refused.exception).startswith("impactors.cylinder.surface: cylinder: "), refused.exception)
    test.assertIn("open", str(refused.exception))


@claim("a mesh from arrays may define the shape of a body")
def body_of_mesh(test):
    setup = copy.deepcopy(package.SETUP)
    plate = setup["bodies"]["plate"]
    plate["shape"] = {"file": perimpact.Mesh.box(size=[0.1, 0.06, 0.02], edge_length=0.05)}
    body = perimpact.Simulation(setup).bodies["plate"]
    test.assertEqual(len(body), 20 * 12 * 4)


@claim("single steps, partial runs, callbacks and any number of threads give bitwise identical results")
def same_steps(test):
    deck = test.folder / test.deck()
    wanted = finished(perimpact.Simulation.from_deck(deck))

    one_by_one = perimpact.Simulation.from_deck(deck)
    while not one_by_one.is_finished:
        one_by_one.step()
    test.assertEqual(one_by_one.state_hash, wanted)

    fragments = perimpact.Simulation.from_deck(deck)
    times = []
    fragments.run(until=5e-6)
    test.assertTrue(5e-6 <= fragments.time < 5e-6 + fragments.dt, fragments.time)
    fragments.run(callback=lambda simulation: times.append(simulation.step_number), every=7)
    test.assertEqual(np.unique(np.diff(times)).tolist(), [7])
    test.assertEqual(fragments.state_hash, wanted)

    stopped = perimpact.Simulation.from_deck(deck)
    stopped.run(callback=lambda simulation: simulation.step_number < 3)
    test.assertEqual(stopped.step_number, 3)

    perimpact.use_threads(2)
    test.assertEqual(finished(perimpact.Simulation.from_deck(deck)), wanted)
    perimpact.use_threads(1)


@claim("a run interrupted in Python is resumed by Python or by the command line, bitwise identical to an uninterrupted one")
def resumed(test):
    deck = test.folder / test.deck()
    test.expect_success("run", deck, "--out", "whole", "--threads", 1)
    for name in ("by_python", "by_command"):
        first = perimpact.Simulation.from_deck(deck)
        first.write_results(str(test.folder / name))
        first.run(until=11e-6)
        first.close_results()
        test.assertEqual(test.report(name)["outcome"], "interrupted")
    second = perimpact.Simulation.from_deck(deck)
    second.write_results(str(test.folder / "by_python"), resume=True)
    test.assertGreaterEqual(second.time, 11e-6)
    second.run()
    test.expect_success("run", deck, "--out", "by_command", "--resume", "--threads", 1)
    for name in ("by_python", "by_command"):
        test.assertEqual(test.report(name)["state_hash"], test.report("whole")["state_hash"])
        test.assertEqual((test.folder / name / "history.csv").read_bytes(), (test.folder / "whole" / "history.csv").read_bytes())
        test.assertEqual(test.files(name), test.files("whole"))


@claim("a run with a user force and a mesh from arrays is resumed bitwise, and refused with another mesh or without the force")
def resumed_with_own(test):
    def made(edge_length=0.004, force=True):
        setup = copy.deepcopy(package.SETUP)
        setup["impactors"]["cylinder"]["surface"] = {"file": perimpact.Mesh.cylinder(diameter=0.04, height=0.04, edge_length=edge_length)}
        forces = {"plate": {"drag": lambda time, body: -1e7 * body.velocities}} if force else None
        return perimpact.Simulation(setup, forces=forces)

    whole = made()
    whole.write_results(str(test.folder / "whole"))
    whole.run()
    test.assertLess(whole.history["plate.drag.work [J]"][-1], 0)
    left = made()
    left.write_results(str(test.folder / "left"))
    left.run(until=12e-6)
    left.close_results()
    for other in (made(edge_length=0.005), made(force=False)):
        with test.assertRaises(perimpact.InputError):
            other.write_results(str(test.folder / "left"), resume=True)
    resumed = made()
    resumed.write_results(str(test.folder / "left"), resume=True)
    resumed.run()
    test.assertEqual(resumed.state_hash, whole.state_hash)
    test.assertEqual((test.folder / "left" / "history.csv").read_bytes(), (test.folder / "whole" / "history.csv").read_bytes())


@claim("a relaxation is bitwise identical to the command line's, although it is paused to check for signals")
def relaxed(test):
    deck = test.folder / "relax.yaml"
    deck.write_text(RELAX)
    test.expect_success("run", deck, "--out", "shell", "--threads", 1)
    test.assertEqual(finished(perimpact.Simulation.from_deck(deck)), test.report("shell")["state_hash"])


@claim("the history equals history.csv, and the set-up read back contains every value")
def same_history(test):
    deck = test.folder / test.deck()
    test.expect_success("run", deck, "--threads", 1)
    simulation = perimpact.Simulation.from_deck(deck)
    simulation.run()
    table = test.history("results")
    test.assertEqual(list(simulation.history), list(table))
    for column, values in table.items():
        test.assertEqual(simulation.history[column].tolist(), values, column)  # CSV is exact
    test.assertEqual(simulation.setup["bodies"]["plate"]["spacing"], 0.005)
    test.assertEqual(simulation.setup["impactors"]["cylinder"]["velocity"], [0, -32, 0])


RELAX = """\
title: A bar is pulled
time: {end: 1 s, relax: {increments: 2}}
bodies:
  bar:
    shape: {box: {size: [100 mm, 30 mm, 30 mm]}}
    spacing: 5 mm
    material: {model: ordinary-state, youngs_modulus: 191 GPa, poissons_ratio: 0.25, density: 8000 kg/m3}
    particle_sets:
      left: {shape: {box: {size: [15 mm, 40 mm, 40 mm]}}, position: [-50 mm, 0, 0]}
      right: {shape: {box: {size: [15 mm, 40 mm, 40 mm]}}, position: [50 mm, 0, 0]}
    boundary_conditions:
      held: {fixed: {particle_set: left}}
      pulled: {prescribed: {particle_set: right, x: {times: [0, 1 s], displacements: [0, 0.01 mm]}}}
output: {frames: 0}
"""

main()
