"""perimpact.Results reads what a run has written."""

import copy
import shutil
import unittest

import package
from claims import claim, main

import numpy as np
import perimpact


def block():
    """A cube of quadrilaterals, but for one side of triangles."""
    corners = 0.02 * np.array([[x, y, z] for z in (-1, 1) for y in (-1, 1) for x in (-1, 1)])
    quads = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2]]
    return perimpact.Mesh(corners, [*quads, [1, 3, 7, -1], [1, 7, 5, -1]])


def run(folder, surface=None, **output):
    """A plate that breaks, and a cylinder or another surface that hits it; its results are in the folder."""
    setup = copy.deepcopy(package.SETUP)
    if surface:
        setup["impactors"]["cylinder"]["surface"] = {"file": surface}
    setup["bodies"]["plate"]["material"]["critical_stretch"] = 1e-4  # less than the stretch of this impact
    setup["output"].update(output)
    simulation = perimpact.Simulation(setup)
    simulation.write_results(folder)
    simulation.run()
    return simulation


def expect_same(test, found, wanted):
    test.assertEqual(found.dtype, wanted.dtype)
    test.assertEqual(found.tobytes(), wanted.tobytes())


@claim("history, columns, run.json and the tables of a results folder are those of its simulation")
def tables(test):
    simulation = run(test.folder / "results")
    results = perimpact.Results(test.folder / "results")
    test.assertEqual(list(results.history), list(simulation.history))
    for column, values in simulation.history.items():
        expect_same(test, results.history[column], values)
    test.assertEqual(results.columns, simulation.history_columns)
    test.assertEqual((results.run["outcome"], results.run["state_hash"]), ("finished", simulation.state_hash))
    ((time, line),) = results.lines["along_y"].items()
    test.assertAlmostEqual(time / simulation.time, 1, delta=1e-9)  # the name of the file has ten digits
    test.assertEqual(line["position_y [m]"].min(), -0.0275)  # the middle of the first of twelve segments
    test.assertGreater(np.abs(line["displacement_y [m]"]).max(), 0)
    fragments = results.table("fragments/plate.csv")
    test.assertEqual(len(fragments["time [s]"]), 5)


@claim("frames of bodies and impactors have the positions, damage and panels of the simulation")
def frames(test):
    simulation = run(test.folder / "results", block())
    results = perimpact.Results(str(test.folder / "results"))
    test.assertEqual(sorted(results.frames), ["cylinder", "plate"])
    plate, cylinder = simulation.bodies["plate"], simulation.impactors["cylinder"]
    series = results.frames["plate"]
    test.assertEqual(len(series), 5)
    test.assertEqual([frame.time for frame in series], series.times.tolist())
    test.assertEqual((series.times[0], series.times[-1]), (0, simulation.time))
    test.assertEqual([frame.time for frame in series[1:3]], series.times[1:3].tolist())
    test.assertEqual(series.at(0.3 * simulation.time).time, series.times[1])
    with test.assertRaises(IndexError):
        series[5]
    last = series[-1]
    expect_same(test, last.points, plate.positions[plate.slots].astype(last.points.dtype))
    expect_same(test, last.point["damage"], plate.damages[plate.slots].astype("f4"))
    expect_same(test, last.point["displacement"], plate.displacements[plate.slots].astype("f4"))
    test.assertEqual((last.faces.shape, last.panel), ((0, 4), {}))
    last = results.frames["cylinder"][-1]
    expect_same(test, last.points, cylinder.current_vertices.astype(last.points.dtype))
    test.assertEqual(last.faces.tolist(), cylinder.faces.tolist())
    test.assertEqual(last.faces[:, 3].min(initial=0), -1)
    test.assertEqual((last.faces[:, 3] >= 0).sum(), 5)
    test.assertGreater(last.panel["contact_pressure"].max(), 0)
    test.assertEqual(last.panel["contact_impulse"].shape, (len(last.faces), 3))


@claim("frames are the same from .vtkhdf and .vtp files, also where their particles differ between frames")
def formats(test):
    try:
        import h5py  # noqa: F401
    except ImportError:
        raise unittest.SkipTest("h5py is not installed")
    for name, thinned in ("whole", {}), ("thinned", {"frame_particles": {"damage_above": 0.01}, "frame_fields": ["damage"]}):
        folders = [test.folder / f"{name}_{format_}" for format_ in ("vtp", "vtkhdf")]
        for folder, format_ in zip(folders, ("vtp", "vtkhdf")):
            run(folder, block(), frame_format=format_, **thinned)
        for body in "plate", "cylinder":
            a, b = (perimpact.Results(folder).frames[body] for folder in folders)
            expect_same(test, a.times, b.times)
            sizes = set()
            for one, other in zip(a, b, strict=True):
                test.assertEqual(one.time, other.time)
                expect_same(test, one.points, other.points)
                test.assertEqual(one.faces.tolist(), other.faces.tolist())
                for these, those in (one.point, other.point), (one.panel, other.panel):
                    test.assertEqual(set(these), set(those))
                    for key in these:
                        expect_same(test, these[key], those[key])
                sizes.add(len(one.points))
            if thinned and body == "plate":
                test.assertGreater(len(sizes), 1)


@claim("results of a run in progress can be read: whole rows, and the frames so far")
def in_progress(test):
    simulation = perimpact.Simulation(package.SETUP)
    simulation.write_results(test.folder / "results")
    results = perimpact.Results(test.folder / "results")
    test.assertEqual(len(results.history["time [s]"]), 1)
    simulation.run(until=12e-6)
    rows, text = len(results.history["time [s]"]), (test.folder / "results/history.csv").read_text()
    test.assertEqual(rows, len(simulation.history["time [s]"]))
    (test.folder / "results/history.csv").write_text(text + text.splitlines()[-1][:25])  # in the middle of a row
    test.assertEqual(len(results.history["time [s]"]), rows)
    test.assertEqual(len(results.frames["plate"]), 3)
    test.assertEqual(results.lines, {})
    with test.assertRaisesRegex(perimpact.InputError, "run.json is written when a run ends; this run is in progress, or was killed."):
        results.run


@claim("what is not in the results, or is damaged, is refused with a sentence")
def refused(test):
    def complaint(read):
        with test.assertRaises(perimpact.InputError) as error:
            read()
        return str(error.exception)

    folder = test.folder / "results"
    advice = "; give the folder that output.folder, --out or write_results named."
    test.assertEqual(complaint(lambda: perimpact.Results(folder)), f"{folder} does not exist{advice}")
    folder.mkdir()
    test.assertEqual(complaint(lambda: perimpact.Results(folder)), f"{folder} has no history.csv, so it is not the results folder of a run{advice}")
    run(folder)
    results = perimpact.Results(folder)
    test.assertEqual(complaint(lambda: results.frames["plat"]), "there is no body or impactor 'plat' in the results; known here: cylinder, plate.")
    test.assertEqual(complaint(lambda: results.lines["x"]), "there is no line 'x' in the results; known here: along_y.")
    test.assertTrue(complaint(lambda: results.history["force"]).startswith("there is no column 'force' in the results; known here: time [s], "))
    test.assertTrue(complaint(lambda: results.table("x.csv")).startswith("there is no table x.csv in the results; known here: fragments/plate.csv, "))
    file = folder / "frames/plate_00002.vtp"
    content = file.read_bytes()
    for damaged in content[: len(content) // 2], content[:200], b"":
        file.write_bytes(damaged)
        test.assertTrue(complaint(lambda: results.frames["plate"][2]).startswith(f"{file} is damaged, or not a frame of perimpact: "))
    file.unlink()
    test.assertEqual(complaint(lambda: results.frames["plate"][2]), f"{file} cannot be read: No such file or directory.")
    (folder / "history.csv").write_text("time [s],force [N]\n1,2\n3\n")
    test.assertEqual(complaint(lambda: results.history), f"{folder}/history.csv is damaged: a row does not have a number for each column.")
    shutil.rmtree(folder)


main()
