"""run(), its callback, and how the results of a run end."""

import copy

import package
from claims import claim, main

import numpy as np
import perimpact


def plate(forces=None, **output):
    setup = copy.deepcopy(package.SETUP)
    setup["output"].update(output)
    return perimpact.Simulation(setup, forces={"plate": forces} if forces else None)


@claim("a callback ends run() with whatever is false, except None, and the run may continue")
def callbacks(test):
    simulation = plate()
    plate_ = simulation.bodies["plate"]
    for number, value in enumerate([False, np.False_, 0, plate_.damages.max() > 0.5, np.array([False])], start=1):
        simulation.run(callback=lambda s: value)
        test.assertEqual(simulation.step_number, number, repr(value))
    for value in True, np.True_, None, "yes":
        simulation = plate()
        simulation.run(until=3 * simulation.dt, callback=lambda s: value)
        test.assertEqual(simulation.step_number, 3, repr(value))
    with test.assertRaises(ValueError):  # of NumPy: it has no truth value
        simulation.run(callback=lambda s: np.array([True, False]))
    simulation.run()
    test.assertTrue(simulation.is_finished)


@claim("run(until=nan) is refused, and until=inf is the end of the set-up")
def until(test):
    simulation = plate()
    with test.assertRaises(perimpact.InputError) as error:
        simulation.run(until=float("nan"))
    test.assertEqual(str(error.exception), "until is nan, but it must be a time [s].")
    test.assertEqual(simulation.step_number, 0)
    simulation.run(until=float("inf"))
    test.assertTrue(simulation.is_finished)


@claim("an exception in a user force ends the results as those of a failed run, with report and the checkpoint of a step before, from which it resumes")
def failed_force(test):
    def force(time, body):
        if may_fail and time > 10e-6:
            raise KeyError("no such spring")
        return [0, 0, 0]

    may_fail = True
    simulation = plate({"spring": force}, checkpoint_interval=1e-9)
    simulation.write_results(test.folder / "results")
    with test.assertRaisesRegex(KeyError, "no such spring"):
        simulation.run()
    report = test.report("results")
    last = simulation.step_number
    test.assertGreater(last, 10)
    test.assertEqual(report["outcome"], "failed")
    test.assertEqual(report["failure"], f"the user force plate.spring raised KeyError: 'no such spring'. The last checkpoint is at step {last}.")
    for file in "report.html", "checkpoint.h5", "pressure_area/cylinder_at_peak.csv":
        test.assertTrue((test.folder / "results" / file).exists(), file)
    test.assertFalse((test.folder / "results" / "run.lock").exists())
    simulation.close_results()  # they are closed
    with test.assertRaisesRegex(perimpact.RunError, "aborted by an error"):
        simulation.run()
    may_fail = False
    resumed = plate({"spring": force}, checkpoint_interval=1e-9)
    resumed.write_results(test.folder / "results", resume=True)
    test.assertEqual(resumed.step_number, last)
    resumed.run()
    whole = plate({"spring": force})
    whole.run()
    test.assertEqual(resumed.state_hash, whole.state_hash)
    test.assertEqual(test.report("results")["outcome"], "finished")


@claim("whatever ends a step, the results have an outcome and a report: an invalid force, a force out of the plane, a run that is unstable")
def failed_otherwise(test):
    def ended(name, force, **plate_changes):
        setup = copy.deepcopy(package.SETUP)
        del setup["impactors"], setup["contact"], setup["output"]["probes"], setup["output"]["lines"]
        setup["bodies"]["plate"].update(plate_changes)
        simulation = perimpact.Simulation(setup, forces={"plate": {"own": lambda time, body: force if time > 5e-6 else [0, 0, 0]}})
        simulation.write_results(test.folder / name)
        with test.assertRaises((perimpact.InputError, perimpact.RunError)) as error:
            simulation.run()
        report = test.report(name)
        test.assertEqual(report["outcome"], "failed", name)
        test.assertTrue((test.folder / name / "report.html").exists(), name)
        test.assertFalse((test.folder / name / "run.lock").exists(), name)
        test.assertTrue(report["failure"].startswith(str(error.exception)), (report["failure"], error.exception))
        return str(error.exception)

    test.assertTrue(ended("nothing", None).startswith("the user force plate.own returned nothing, but must return"))
    test.assertIn("not finite on 960 particles", ended("unstable", [np.nan, 0, 0]))
    test.assertIn("the body is 2-D", ended("plane", [0, 0, 1.0], plane="stress"))


@claim("an exception in a structure ends the results as those of a failed run")
def failed_structure(test):
    corners = np.array([[-0.05, 0.05, -0.05], [0.05, 0.05, -0.05], [0.05, 0.05, 0.05], [-0.05, 0.05, 0.05]])

    class Wall:
        masses = np.full(4, np.inf)
        steps = 0

        def advance(self, time, dt):
            self.steps += 1
            if self.steps == 5:
                raise ArithmeticError("it did not converge.")
            return corners

        def apply(self, impulses):
            pass

    setup = copy.deepcopy(package.SETUP)
    setup["impactors"] = {"wall": {"surface": {"file": perimpact.Mesh(corners, [[0, 1, 2, 3]]), "orientation": "normals"}, "mass": 1}}
    simulation = perimpact.Simulation(setup, structures={"wall": Wall()})
    simulation.write_results(test.folder / "results")
    with test.assertRaisesRegex(ArithmeticError, "it did not converge"):
        simulation.run()
    report = test.report("results")
    test.assertEqual(report["outcome"], "failed")
    test.assertTrue(report["failure"].startswith("advance of the structure of impactor wall raised ArithmeticError: it did not converge."), report["failure"])


@claim("close_results in the middle of a step is refused, and the results remain complete")
def closed_within(test):
    refused = []

    def force(time, body):
        if time > 3e-6 and not refused:
            try:
                simulation.close_results()
            except perimpact.RunError as error:
                refused.append(str(error))
        return [0, 0, 0]

    simulation = plate({"own": force})
    simulation.write_results(test.folder / "results")
    simulation.run()
    test.assertEqual(refused, ["the simulation is in the middle of a step; close the results between steps, such as in the callback of run."])
    test.assertEqual(test.report("results")["outcome"], "finished")
    test.assertEqual(len(test.history("results")["time [s]"]), len(simulation.history["time [s]"]))


@claim("a callback may close the results, and the run continues without")
def closed_between(test):
    simulation = plate()
    simulation.write_results(test.folder / "results")
    simulation.run(callback=lambda s: s.close_results(), every=10)
    test.assertTrue(simulation.is_finished)
    report = test.report("results")
    test.assertEqual((report["outcome"], report["steps"]), ("interrupted", 10))


main()
