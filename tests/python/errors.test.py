"""Errors in Python."""

import copy
import os
import signal
import subprocess
import sys
import threading
import time

import package
from claims import claim, main

import perimpact


@claim("a mistake in a deck is a ValueError with the message of the command line")
def in_a_deck(test):
    deck = test.folder / test.deck(("poissons_ratio: 0.25", "poissons_ratio: 0.6"))
    done = test.run_program("check", deck)
    with test.assertRaises(ValueError) as error:
        perimpact.Simulation.from_deck(deck)
    test.assertIsInstance(error.exception, perimpact.InputError)
    test.assertEqual(f"error: {error.exception}\n", done.err)
    test.assertEqual(done.code, 2)


@claim("errors found only when the simulation is built give line and column too")
def in_building(test):
    deck = test.folder / test.deck(("position: [0, 50 mm, 0]", "position: [0, 40 mm, 0]"))
    done = test.run_program("run", deck)
    with test.assertRaises(perimpact.InputError) as error:
        perimpact.Simulation.from_deck(deck)
    test.assertEqual(f"error: {error.exception}\n", done.err)


@claim("set makes the changes of --set, and its messages are the same but for the key in place of the option")
def changes(test):
    deck = test.folder / test.deck()
    simulation = perimpact.Simulation.from_deck(deck, set={"time.end": "10 us", "bodies.plate.velocity": [0, 1, 0], "output.frames": 0})
    test.assertEqual(simulation.setup["time"]["end"], 10e-6)
    test.assertEqual(simulation.setup["bodies"]["plate"]["velocity"], [0, 1, 0])

    def refused(changes):
        with test.assertRaises(perimpact.InputError) as error:
            perimpact.Simulation.from_deck(deck, set=changes)
        return str(error.exception)

    mistakes = {"time.ned": "1", "bodies.plate.spacing": -1.0, "title.more": "x", "time.end": "[1", "impactors.cylinder.position": [0, 0.04, 0]}
    for key, value in mistakes.items():
        done = test.run_program("run", deck, "--set", f"{key}={value}")
        test.assertIn(f"--set {key}", done.err)
        test.assertEqual(f"error: {refused({key: value})}\n", done.err.replace(f"--set {key}", f'set["{key}"]'))
    test.assertEqual(refused({"time..end": 1}), 'set["time..end"]: a key consists of names with dots between them, such as "time.end".')
    test.assertEqual(refused({3: 1}), 'set: 3 is a key, but keys are names of keys of the deck, such as "time.end".')
    test.assertEqual(refused(["a"]), 'set is of type list, but it must be a dict such as {"time.end": "10 us"}.')


@claim("a mistake in a dict is reported with its key instead of line and column")
def in_a_dict(test):
    def refused(change):
        setup = copy.deepcopy(package.SETUP)
        change(setup)
        with test.assertRaises(perimpact.InputError) as error:
            perimpact.Simulation(setup)
        return str(error.exception)

    material = "bodies.plate.material"
    test.assertEqual(
        refused(lambda s: s["bodies"]["plate"]["material"].update(poissons_ratio=0.6)).split(",")[0], f"{material}.poissons_ratio: poissons_ratio is 0.6"
    )
    test.assertEqual(
        refused(lambda s: s["bodies"]["plate"].update(spacign=1)),
        "bodies.plate.spacign: spacign is not a key of bodies.plate; did you mean spacing?",
    )
    test.assertTrue(refused(lambda s: s.pop("time")).startswith("the set-up: "))
    test.assertTrue(refused(lambda s: s["impactors"]["cylinder"].update(position=[0, 0])).startswith("impactors.cylinder.position: position has 2 numbers"))
    test.assertEqual(
        refused(lambda s: s["impactors"]["cylinder"].update(position=[0, 0, {1}])),
        "impactors.cylinder.position[2]: this is a set, but a set-up consists of dicts, lists, numbers, strings and meshes.",
    )
    test.assertEqual(refused(lambda s: s.update({3: 4})), "the set-up: 3 is a key, but keys must be strings.")
    test.assertIn("nan", refused(lambda s: s["time"].update(end=float("nan"))))
    endless = []
    endless.append(endless)
    with test.assertRaises(RecursionError):
        perimpact.Simulation({"time": endless})


@claim("invalid meshes are refused with a sentence")
def meshes(test):
    def refused(*arguments):
        with test.assertRaises(perimpact.InputError) as error:
            perimpact.Mesh(*arguments)
        return str(error.exception)

    corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]
    test.assertEqual(refused(corners, [[0, 1, 3]]), "mesh: face 0 has vertex 3, but there are 3, counted from 0.")
    test.assertEqual(refused(corners, [[0, 1, -1]]), "mesh: face 0 has vertex -1, but there are 3, counted from 0.")
    test.assertEqual(refused([[0, 0], [1, 0]], [[0, 1, 2]]), "mesh: vertices has the shape (2, 2), but must have one row x, y, z per point: (points, 3).")
    test.assertIn("(2,)", refused(corners, [0, 1]))
    test.assertEqual(refused([[0, 0, 0], [1, 0, float("inf")], [0, 1, 0]], [[0, 1, 2]]), "mesh: vertex 1 has a coordinate that is not a finite number.")
    test.assertEqual(refused(corners, [[0, 1, 2]], ["a", "b"]), "mesh: parts has 2 entries for 1 faces; give one part per face.")


@claim("an unstable run is a RuntimeError, and the results report it")
def unstable(test):
    setup = copy.deepcopy(package.SETUP)
    simulation = perimpact.Simulation(setup, forces={"plate": {"wrong": lambda time, body: [1e300 if time > 3e-6 else 0, 0, 0]}})
    simulation.write_results(str(test.folder / "results"))
    with test.assertRaises(RuntimeError) as error:
        simulation.run()
    test.assertIsInstance(error.exception, perimpact.RunError)
    report = test.report("results")
    test.assertEqual((report["outcome"], report["failure"]), ("failed", str(error.exception)))


@claim("write_results too late or twice is refused, and so is a step beyond the end")
def too_late(test):
    simulation = perimpact.Simulation(package.SETUP)
    simulation.write_results(str(test.folder / "results"))
    with test.assertRaisesRegex(perimpact.InputError, "already"):
        simulation.write_results(str(test.folder / "others"))
    simulation.run()
    with test.assertRaisesRegex(perimpact.RunError, "the run is over at 2e-05 s"):
        simulation.step()
    simulation.run()  # no steps remain
    late = perimpact.Simulation(package.SETUP)
    late.step()
    with test.assertRaisesRegex(perimpact.InputError, "step 1 is done, but results begin at t = 0"):
        late.write_results(str(test.folder / "others"))


@claim("what a message advises can be done in Python: it names no option of the command line")
def advice(test):
    folder = test.folder / "results"

    def refused(folder, setup=package.SETUP, **options):
        with test.assertRaises(perimpact.InputError) as error:
            perimpact.Simulation(setup).write_results(folder, **options)
        test.assertNotIn("--", str(error.exception))
        return str(error.exception)

    test.assertEqual(refused(folder, resume=True), f"there is no checkpoint {folder}/checkpoint.h5, so there is nothing to resume; leave out resume=True.")
    simulation = perimpact.Simulation(package.SETUP)
    simulation.write_results(folder)
    simulation.run(until=10e-6)
    simulation.close_results()
    other = copy.deepcopy(package.SETUP)
    other["bodies"]["plate"]["material"]["density"] = 7000
    test.assertTrue(refused(folder, other, resume=True).endswith("resume with the same deck, or start a new run without resume=True."))
    other = copy.deepcopy(package.SETUP)
    other["time"]["step"] = 0.5 * simulation.dt
    test.assertTrue(refused(folder, other, resume=True).endswith(f"resume with time.step = {simulation.dt!r} in the set-up."))
    test.assertIn(f'write_results("{folder}", resume=True) or replace it with overwrite=True', refused(folder))
    (test.folder / "file").write_text("no folder")
    test.assertTrue(refused(test.folder / "file").endswith("Choose another one."), refused(test.folder / "file"))
    test.assertIn("expand it with os.path.expandvars", refused("$SCRATCH/results"))


@claim("paths may be text or pathlib.Path wherever a file or folder is named")
def paths(test):
    deck = test.folder / test.deck()
    test.assertEqual(perimpact.read_deck(deck), perimpact.read_deck(str(deck)))
    stl = test.folder / "triangle.obj"
    stl.write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
    test.assertEqual(perimpact.Mesh.read(stl).faces.tolist(), [[0, 1, 2, -1]])
    test.assertEqual(perimpact.Mesh.read(str(stl)).faces.tolist(), [[0, 1, 2, -1]])
    for folder in test.folder / "one", str(test.folder / "two"):
        simulation = perimpact.Simulation.from_deck(deck)
        simulation.write_results(folder)
        simulation.run()
    test.assertEqual(test.report("one")["state_hash"], test.report("two")["state_hash"])


@claim("Ctrl-C ends a run after a complete step, other Python threads continue meanwhile, and the run can be resumed")
def interrupted(test):
    setup = copy.deepcopy(package.SETUP)
    signal.signal(signal.SIGINT, signal.default_int_handler)  # it is ignored where the tests run in the background
    setup["time"] = {"end": 4e-3, "step": 2e-7}  # 20000 steps, some seconds
    setup["impactors"]["cylinder"]["velocity"] = [0, 0, 0]

    def busy(time, body):  # most of the step time is here, where Python would raise the KeyboardInterrupt
        for _ in range(3000):
            pass
        return [0, 0, 0]

    for forces in (None, {"plate": {"busy": busy}}):
        simulation = perimpact.Simulation(setup, forces=forces)
        folder = test.folder / ("with_user_force" if forces else "alone")
        simulation.write_results(str(folder))
        ticks = []

        def watch():
            while len(ticks) < 3:
                time.sleep(0.02)
                if simulation.step_number > 0:
                    ticks.append(simulation.step_number)
            os.kill(os.getpid(), signal.SIGINT)

        thread = threading.Thread(target=watch)
        thread.start()
        with test.assertRaises(KeyboardInterrupt):
            simulation.run()
        thread.join()
        test.assertFalse(simulation.is_finished)
        stopped_at = simulation.step_number
        test.assertGreater(stopped_at, 0)
        test.assertTrue((folder / "checkpoint.h5").exists())
        simulation.step()
        test.assertEqual(simulation.step_number, stopped_at + 1)
        test.assertEqual(signal.getsignal(signal.SIGINT), signal.default_int_handler)


@claim("SIGTERM and SIGHUP end a program during run() by the same signal, with a checkpoint from which the run resumes; SIGINT raises KeyboardInterrupt")
def ended_by_signal(test):
    setup = copy.deepcopy(package.SETUP)
    setup["time"] = {"end": 4e-3, "step": 2e-7}  # 20000 steps, some seconds
    for which, code in (signal.SIGTERM, -signal.SIGTERM), (signal.SIGHUP, -signal.SIGHUP), (signal.SIGINT, 3):
        folder = test.folder / which.name
        program = f"""
import os, signal, sys, threading, time
sys.path[:0] = {sys.path[:1]!r}
import perimpact
for each in signal.SIGINT, signal.SIGTERM, signal.SIGHUP:
    signal.signal(each, signal.default_int_handler if each == signal.SIGINT else signal.SIG_DFL)  # ignored where the tests run in the background
simulation = perimpact.Simulation({setup!r})
simulation.write_results({str(folder)!r})
def send():
    while simulation.step_number < 5:
        time.sleep(0.01)
    os.kill(os.getpid(), {int(which)})
threading.Thread(target=send).start()
try:
    simulation.run()
except KeyboardInterrupt:
    sys.exit(3)
"""
        done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, timeout=60)
        test.assertEqual((done.returncode, done.stdout, done.stderr), (code, "", ""), which)
        test.assertTrue((folder / "checkpoint.h5").exists(), which)
        test.assertFalse((folder / "run.lock").exists() and which == signal.SIGINT)
        resumed = perimpact.Simulation(setup)
        resumed.write_results(str(folder), resume=True)
        test.assertGreater(resumed.step_number, 4)
        test.assertLess(resumed.step_number, 20000)
        resumed.close_results()


@claim("SIGTERM while the callback of run() works ends the program by the same signal after it, with a checkpoint from which the run resumes")
def ended_in_callback(test):
    setup = copy.deepcopy(package.SETUP)
    setup["time"] = {"end": 4e-3, "step": 2e-7}
    folder = test.folder / "r"
    program = f"""
import os, signal, sys
sys.path[:0] = {sys.path[:1]!r}
import perimpact
signal.signal(signal.SIGTERM, signal.SIG_DFL)
simulation = perimpact.Simulation({setup!r})
simulation.write_results({str(folder)!r})
def callback(simulation):
    os.kill(os.getpid(), signal.SIGTERM)
    print("after the signal", flush=True)
simulation.run(callback=callback, every=7)
"""
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, timeout=60)
    test.assertEqual((done.returncode, done.stdout, done.stderr), (-signal.SIGTERM, "after the signal\n", ""))
    resumed = perimpact.Simulation(setup)
    resumed.write_results(str(folder), resume=True)
    test.assertEqual(resumed.step_number, 7)
    resumed.close_results()


@claim("SIGINT while a simulation is built raises KeyboardInterrupt once it is built, and nothing is written")
def interrupted_set_up(test):
    setup = copy.deepcopy(package.SETUP)
    setup["bodies"]["plate"]["spacing"] = 0.001  # tenths of a second
    signal.signal(signal.SIGINT, signal.default_int_handler)
    threading.Timer(0.1, lambda: os.kill(os.getpid(), signal.SIGINT)).start()
    with test.assertRaises(KeyboardInterrupt):
        perimpact.Simulation(setup)
        time.sleep(0.2)  # where the machine has built it before the signal
    test.assertEqual(test.files("."), [])


@claim("a user force cannot start another step from within a step")
def from_within(test):
    held = []

    def meddles(time, body):
        if held:
            held[0].step()
        return [0, 0, 0]

    simulation = perimpact.Simulation(package.SETUP, forces={"plate": {"own": meddles}})
    held.append(simulation)
    with test.assertRaisesRegex(perimpact.RunError, "in the middle of a step"):
        simulation.step()


main()
