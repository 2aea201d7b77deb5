"""Python threads beside a run, and the number of threads of a simulation."""

import copy
import threading

import package
from claims import claim, main

import perimpact


def plate(**forces):
    """The small plate, which breaks, and a cylinder that hits it."""
    setup = copy.deepcopy(package.SETUP)
    setup["time"]["end"] = 60e-6
    setup["bodies"]["plate"]["material"]["critical_stretch"] = 1e-4  # less than the stretch of this impact
    return perimpact.Simulation(setup, forces={"plate": forces} if forces else None)


def readings(simulation):
    """What depends on the state, each as bytes or text that differs between steps."""
    body, impactor = simulation.bodies["plate"], simulation.impactors["cylinder"]
    return {
        "contacts": lambda: impactor.contacts.tobytes(),
        "current_vertices": lambda: impactor.current_vertices.tobytes(),
        "force": lambda: impactor.force.tobytes(),
        "damages": lambda: body.damages.tobytes(),
        "displacements": lambda: body.displacements.tobytes(),
        "momentum": lambda: body.momentum.tobytes(),
        "broken_bonds": lambda: body.broken_bonds,
        "state_hash": lambda: simulation.state_hash,
        "warnings": lambda: tuple(simulation.warnings),
    }


@claim("what another Python thread reads during a run is the state between two steps, and the run remains bitwise the same")
def between_steps(test):
    alone = plate()
    read, allowed = readings(alone), {}
    for _ in range(alone.steps + 1):
        for name, value in read.items():
            allowed.setdefault(name, set()).add(value())
        if not alone.is_finished:
            alone.step()
    test.assertGreater(len(allowed["contacts"]), 20)
    test.assertGreater(len(allowed["damages"]), 5)

    def none(time, body):
        body.displacements  # in the thread of the step
        return [0, 0, 0]

    for forces in {}, {"none": none}:
        shared = plate(**forces)
        thread = threading.Thread(target=shared.run)
        found, columns = {}, set()
        thread.start()
        while thread.is_alive():
            for name, value in readings(shared).items():
                found.setdefault(name, set()).add(value())
            columns |= {len({len(values) for values in shared.history.values()})}
            shared.timers, shared.time, shared.is_finished, repr(shared)
        thread.join()
        test.assertEqual(columns, {1})
        if not forces:
            test.assertEqual(shared.state_hash, alone.state_hash)
        for name, values in found.items():
            if not forces or name != "state_hash":  # a user force is a part of the state
                test.assertEqual(len(values - allowed[name]), 0, f"{name}: {len(values - allowed[name])} of {len(values)} are of no step")


@claim("a thread that reads a simulation while a user force waits for this thread gets a RunError instead of waiting for ever")
def waits_for_the_reader(test):
    told = []

    def read():
        try:
            simulation.impactors["cylinder"].contacts
        except perimpact.RunError as error:
            told.append(str(error))

    def waits(time, body):
        if time > 1e-6 and not told:
            reader = threading.Thread(target=read)
            reader.start()
            reader.join()
            simulation.impactors["cylinder"].contacts  # in the thread of the step it does not wait
        return [0, 0, 0]

    simulation = plate(waits=waits)
    simulation.run(until=3e-6)
    test.assertEqual(
        told,
        [
            "a step is in progress, and a user force or structure that it has called did not return within 5 s; read the state between steps, or within the function "
            "in the thread that calls it."
        ],
    )
    simulation.run()
    test.assertTrue(simulation.is_finished)


@claim("a second thread cannot perform steps during a run")
def one_thread_steps(test):
    begun, refused = threading.Event(), []

    def slow(time, body):
        begun.set()
        if time > 1e-6 and not refused:
            other.join()
        return [0, 0, 0]

    def steps():
        begun.wait()
        try:
            simulation.step()
        except perimpact.RunError as error:
            refused.append(str(error))

    simulation = plate(slow=slow)  # calls it too
    begun.clear()
    other = threading.Thread(target=steps)
    other.start()
    simulation.run(until=5e-6)
    test.assertEqual(refused, ["the simulation is in the middle of a step; a user force or another thread cannot start another one."])


@claim("use_threads holds for every Python thread, and takes 1 to 1024")
def number_of_threads(test):
    perimpact.use_threads(3)
    counts = []
    folder = test.folder / "results"

    def run():
        counts.append(perimpact.thread_count())
        simulation = plate()
        simulation.write_results(str(folder))
        simulation.run()

    thread = threading.Thread(target=run)
    thread.start()
    thread.join()
    test.assertEqual(counts, [3])
    test.assertEqual(test.report("results")["threads"], 3)
    for count in 0, -1, 1025, 10**9:
        with test.assertRaises(perimpact.InputError) as error:
            perimpact.use_threads(count)
        test.assertEqual(str(error.exception), f"use_threads was given {count}, but the number of threads must be between 1 and 1024.")
    test.assertEqual(perimpact.thread_count(), 3)


main()
