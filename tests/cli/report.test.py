"""What `perimpact report` shows: its data, read back by other means, are those of the results folder."""

import math
import os
import resource
import shutil

from claims import MOVES, claim, main, table
from reports import ReportFile, read_pictures

# two bodies, one of which breaks to fragments, and an impactor that turns freely
TWO = (
    ("free_dofs: [y]", "free_dofs: [x, y, z, rx, ry, rz]\n    angular_velocity: [2000, 0, 9000]"),
    ("density: 8000 kg/m3}", "density: 8000 kg/m3, critical_stretch: 0.0001}\n  stone:\n    shape: {box: {size: [20 mm, 20 mm, 20 mm]}}\n    position: [1, 0, 0]\n"
                             "    spacing: 5 mm\n    material: {model: ordinary-state, youngs_modulus: 10 GPa, poissons_ratio: 0.25, density: 1000 kg/m3}"),
)
FLOAT = 2**-23  # a float is at most half of this part of itself off; with another operation on floats, as much again


def half_step(array, extra=0.0):
    return array["step"] / 2 * (1 + 1e-9) + extra


def expect_frames(t, report, folder, name, kept=None):
    """Every frame in the report equals its file within half a quantisation step of each quantity."""
    body, places, pictures = report.body(name)
    half = {array["name"]: half_step(array) for array in body["arrays"]}
    t.assertEqual(len(pictures), len(body["pictures"]))
    t.assertEqual(len(pictures), len(body["offsets"]))
    for number, picture, offset in zip(body["pictures"], pictures, body["offsets"]):
        file = folder / f"frames/{name}_{t.file_numbers[report.times[number]]:05}.vtp"
        arrays = read_pictures(file)
        particles = range(len(arrays["points"])) if kept is None else kept
        t.assertEqual(len(particles), body["shown"])
        for shown, particle in enumerate(particles):
            u, v = arrays["displacement"][particle], arrays["velocity"][particle]
            for axis in range(3):
                t.assertLessEqual(abs(picture[f"displacement_{'xyz'[axis]}"][shown] - u[axis]), half[f"displacement_{'xyz'[axis]}"])
                x = places[axis][shown] + offset[axis] + picture[f"displacement_{'xyz'[axis]}"][shown]
                # files contain positions as floats; the undeformed position is a difference, and the offset is one of two of these
                rounding = FLOAT * (2 * abs(arrays["points"][particle][axis]) + 4 * abs(offset[axis]))
                bound = half_step(body["undeformed"][axis], half[f"displacement_{'xyz'[axis]}"] + rounding)
                t.assertLessEqual(abs(x - arrays["points"][particle][axis]), bound)
            t.assertLessEqual(abs(picture["speed"][shown] - math.hypot(*v)), half["speed"])
            t.assertLessEqual(abs(picture["damage"][shown] - arrays["damage"][particle][0]), half["damage"])
            t.assertEqual("fragment" in picture, "fragment" in arrays)
            if "fragment" in picture:
                t.assertEqual(round(picture["fragment"][shown]), arrays["fragment"][particle][0])


def report_of(t, folder, *arguments):
    t.expect_success("report", folder, *arguments)
    report = ReportFile(t.folder / folder / "report.html")
    lists = (t.folder / folder / "frames").glob("*.pvd")
    t.file_numbers = {time: number for each in lists for number, time in enumerate(times_of(each))}
    return report


def times_of(series):
    return [float(line.split('timestep="')[1].split('"')[0]) for line in series.read_text().splitlines() if "timestep" in line]


@claim("report: every frame equals that of the file within half a quantisation step, for each particle and quantity")
def _(t):
    t.expect_success("run", t.deck(*TWO), "--out", "r", "--no-report")
    report = report_of(t, "r")
    t.assertEqual(report.notes, [])
    t.assertEqual(report.times, times_of(t.folder / "r/frames/plate.pvd"))
    t.assertGreater(max(round(p) for p in report.body("plate")[2][-1]["fragment"]), 0, "nothing broke off: this run does not show what it should")
    for name in ("plate", "stone"):
        expect_frames(t, report, t.folder / "r", name)
        body, _, _ = report.body(name)
        t.assertEqual((body["particles"], body["spacing [m]"]), (body["shown"], 0.005))
        for array in [*body["undeformed"], *body["arrays"]]:
            if array["unit"]:  # 16 bits of the range
                t.assertLessEqual(array["bytes"], 2)


@claim("report: a body with a moving window is where its files have it, in every frame, and its displacements are those of its particles")
def _(t):
    t.expect_success("run", t.deck(*MOVES), "--out", "r", "--no-report")
    report = report_of(t, "r")
    expect_frames(t, report, t.folder / "r", "plate")
    offsets = report.body("plate")[0]["offsets"]
    travels = table(t.folder / "r/history.csv")
    wanted = dict(zip(travels["time [s]"], travels["plate.window_travel [m]"]))
    for time, offset in zip(report.times, offsets):
        row = min(row for row in wanted if row >= time * (1 - 1e-9))  # windows move after rows: until the next row nothing changes
        t.assertLess(abs(offset[0] - wanted[row]), 1e-6 * 0.2, "floats of coordinates up to 0.2 m")
        t.assertEqual(offset[1:], [0, 0])
    t.assertEqual(offsets[0], [0, 0, 0])
    t.assertEqual({round(offset[0] / 0.04) for offset in offsets}, {0, 1, 2}, "eight cells of 5 mm a move")


@claim("report: impactors are at the positions of their files, to single precision, with the loads on their panels")
def _(t):
    t.expect_success("run", t.deck(*TWO), "--out", "r", "--no-report")
    report = report_of(t, "r")
    impactor, vertices, panels, pictures = report.impactor("cylinder")
    t.assertEqual({array["name"]: array["unit"] for array in impactor["arrays"]}, {"contact_pressure": "Pa", "peak_pressure": "Pa", "contact_impulse": "N s"})
    largest_turn = 0
    for number, (m, picture) in enumerate(zip(impactor["motions"], pictures, strict=True)):
        arrays = read_pictures(t.folder / f"r/frames/cylinder_{number:05}.vtp")
        t.assertEqual(panels, arrays["panels"])
        largest_turn = max(largest_turn, abs(m[1]))
        for X, x in zip(vertices, arrays["points"], strict=True):
            for axis in range(3):
                moved = sum(m[4 * axis + k] * X[k] for k in range(3)) + m[4 * axis + 3]
                t.assertAlmostEqual(moved, x[axis], delta=FLOAT * 0.1)  # vertices are floats, and nothing is farther than 0.1 m
        for array in impactor["arrays"]:
            for got, row in zip(picture[array["name"]], arrays[array["name"]], strict=True):
                t.assertLessEqual(abs(got - math.hypot(*row)), half_step(array))
    t.assertGreater(largest_turn, 0.05)
    t.assertGreater(max(pictures[-1]["peak_pressure"]), 0)


@claim("report: curves are those of history.csv to single precision; deck, checks and warnings are run.json, word for word")
def _(t):
    t.expect_success("run", t.deck(("Small plate", "A </script> & \\\"plate\\\"")), "--out", "r", "--no-report")
    report = report_of(t, "r")
    history, curves = t.history("r"), report.curves()
    units = [column["unit"] for column in report.description["history"]["columns"]]
    t.assertEqual([f"{name} [{unit}]" for name, unit in zip(curves, units)], list(history))
    for column, unit in zip(curves, units):
        for got, wanted in zip(curves[column], history[f"{column} [{unit}]"], strict=True):
            t.assertLessEqual(abs(got - wanted), FLOAT / 2 * abs(wanted) + 1e-45)  # the smallest float is 1.4e-45
    t.assertEqual(report.run, t.report("r"))
    t.assertEqual(report.text.count("A </script>"), 0)


@claim("report: run.json has the largest energy balance error of history.csv, and that over the works of contact and of boundary conditions")
def _(t):
    held = ("density: 8000 kg/m3}", "density: 8000 kg/m3}\n    boundary_conditions: {side: {fixed: {particle_set: side}}, pull: {body_force: {force_density: [0, 1 GN/m3, 0]}}}\n"
            "    particle_sets: {side: {shape: {box: {size: [100 mm, 5 mm, 20 mm]}}, position: [0, -27.5 mm, 0]}}")  # fmt: skip
    t.expect_success("run", t.deck(held), "--out", "r", "--no-report")
    largest = {name: max(map(abs, values)) for name, values in t.history("r").items()}
    error, works = largest["total.energy_balance_error [J]"], [largest[f"{name} [J]"] for name in ("cylinder.contact_work", "plate.side.work", "plate.pull.work")]
    t.assertGreater(min(works[0], works[2]), 0)
    t.assertEqual(t.report("r")["energy_balance"], {"largest_error [J]": error, "exchanged [J]": sum(works), "relative": error / sum(works)})


@claim("report: run writes it at its end and prints the path, --no-report suppresses it, and a new run removes an old one")
def _(t):
    out = t.expect_success("run", t.deck(), "--out", "r", "--force").out
    t.assertRegex(out, r"\n  r/report\.html  report for the browser \(0\.\d MB\)\n$")
    written = (t.folder / "r/report.html").read_bytes()
    t.expect_success("report", "r")
    t.assertEqual((t.folder / "r/report.html").read_bytes(), written)  # the same folder gives the same file
    t.assertNotIn("report.html", t.expect_success("run", t.deck(), "--out", "r", "--force", "--no-report").out)
    t.assertEqual([name for name in t.files("r") if name in ("report.html", "open_in_paraview.py")], [])


@claim("report: open_in_paraview.py names the bodies with their spacing, and the impactors, without the path of the folder")
def _(t):
    t.expect_success("run", t.deck(*TWO), "--out", "r", "--no-report")
    report_of(t, "r")
    script = (t.folder / "r/open_in_paraview.py").read_text()
    compile(script, "open_in_paraview.py", "exec")
    lists = {}
    exec(script.split("\nfrom paraview import simple\n")[1].split("\n# ")[0], lists)
    t.assertEqual(lists["BODIES"], [("plate", ".pvd", 0.005, "damage"), ("stone", ".pvd", 0.005, "velocity")])
    t.assertEqual(lists["IMPACTORS"], [("cylinder", ".pvd")])
    t.assertNotIn(str(t.folder), script)
    shutil.rmtree(t.folder / "r/frames")
    t.expect_success("run", t.deck(*TWO, ("frames: 4", "frames: 0")), "--out", "r", "--force")
    t.assertNotIn("open_in_paraview.py", t.files("r"))  # that of the earlier run


@claim("report: without disk space for it the run still finishes, with a warning")
def _(t):
    room = 500_000  # for all other files of this run, but not for the page
    out = t.expect_success("run", t.deck(), "--out", "r", limits={resource.RLIMIT_FSIZE: room}).out
    t.assertRegex(out, r"\nwarning: the report of this run could not be written: r/report\.html cannot be written: .*\n$")
    t.assertEqual(t.report("r")["outcome"], "finished")
    t.assertEqual([name for name in t.files("r") if "report" in name], [])


@claim("report: it requests no external resources")
def _(t):
    t.expect_success("run", t.deck(), "--out", "r")
    text = (t.folder / "r/report.html").read_text()
    for word in ('src="', "@import", "url(", "XMLHttpRequest("):
        t.assertNotIn(word, text.replace("u.src=", ""), word)
    t.assertNotRegex(text, r"<link[^>]*href")


@claim("report: a larger run is thinned, first frames evenly, then particles, and stays below the size")
def _(t):
    # 60 frames of 6 400 particles, of which 2 296 lie on the surface: 40 x 20 x 8 cells of 2.5 mm
    deck = t.deck(("spacing: 5 mm", "spacing: 2.5 mm"), ("frames: 4", "frames: 60"), ("size: [100 mm, 60 mm, 20 mm]", "size: [100 mm, 50 mm, 20 mm]"),
                  ("position: [0, 50 mm, 0]", "position: [0, 45 mm, 0]"), ("from: [0, -30 mm, 0], to: [0, 30 mm, 0]", "from: [0, -25 mm, 0], to: [0, 25 mm, 0]"), ("{end: 20 us}", "{end: 12 us, step: 0.2 us}"), ("density: 8000 kg/m3}", "density: 8000 kg/m3, critical_stretch: 0.003}"))
    t.expect_success("run", deck, "--out", "r", "--no-report")
    whole = report_of(t, "r", "--size", "100")
    t.assertEqual((whole.notes, len(whole.times)), ([], 61))
    size = sum(len(text) for name, text in whole.scripts.items() if name not in ("description", "run", "history"))

    fewer = report_of(t, "r", "--size", f"{0.85e-6 * size:.3f}")  # frames alone
    t.assertTrue(40 <= len(fewer.times) < 61, len(fewer.times))
    t.assertEqual((fewer.times[0], fewer.times[-1]), (whole.times[0], whole.times[-1]))
    gaps = [round((b - a) / 0.2e-6) for a, b in zip(fewer.times, fewer.times[1:])]
    t.assertLessEqual(max(gaps) - min(gaps), 1)
    t.assertIn(f"{len(fewer.times)} of 61 frames are shown", " ".join(fewer.notes))
    body, _, _ = fewer.body("plate")
    t.assertEqual(body["shown"], 6400)
    expect_frames(t, fewer, t.folder / "r", "plate")

    thin = report_of(t, "r", "--size", f"{0.65e-6 * size:.3f}")  # particles too
    t.assertEqual(len(thin.times), 40)
    t.assertLessEqual(sum(len(text) for name, text in thin.scripts.items() if name not in ("description", "run", "history")), 0.65 * size + 1)
    body, places, pictures = thin.body("plate")
    t.assertTrue(2296 < body["shown"] < 6400, body["shown"])
    t.assertIn(f"{body['shown']} of 6400 particles are shown", " ".join(thin.notes))
    # which ones: found by their places; all of the surface and all that are damaged are among them
    arrays = read_pictures(t.folder / "r/frames/plate_00060.vtp")
    cell = lambda place: tuple(round((x + edge) / 0.0025 - 0.5) for x, edge in zip(place, (0.05, 0.025, 0.01)))
    numbers = {cell([x - u for x, u in zip(*row)]): k for k, row in enumerate(zip(arrays["points"], arrays["displacement"]))}
    kept = [numbers[cell(place)] for place in zip(*places)]
    t.assertEqual(kept, sorted(set(kept)))
    wanted = {k for (i, j, l), k in numbers.items() if i in (0, 39) or j in (0, 19) or l in (0, 7)} | {k for k, (damage,) in enumerate(arrays["damage"]) if damage > 0}
    t.assertGreater(len(wanted), 2296)
    t.assertEqual(wanted - set(kept), set())
    expect_frames(t, thin, t.folder / "r", "plate", kept)


@claim("report: rows of long histories are merged, so that impulses are preserved, with a note")
def _(t):
    t.expect_success("run", t.deck(), "--out", "r", "--no-report")
    path = t.folder / "r/history.csv"
    head = "time [s],cylinder.force_y [N],cylinder.contacts [-]\n"
    path.write_text(head + "".join(f"{k},{k % 7},{k}\n" for k in range(50_001)))
    t.write_kinds("r", loads=["cylinder.force_y"])
    report = report_of(t, "r")
    curves = report.curves()
    t.assertEqual(curves["time"], [0.0] + [float(min(3 * k, 50_000)) for k in range(1, 16_668)])
    means = [((3 * k - 2) % 7 + (3 * k - 1) % 7 + (3 * k) % 7) / 3 for k in range(1, 16_667)]
    for got, wanted in zip(curves["cylinder.force_y"][1:], means):
        t.assertAlmostEqual(got, wanted, delta=1e-6)  # floats of up to 6
    t.assertEqual(curves["cylinder.contacts"], curves["time"])
    t.assertIn("history.csv has 50001 rows", " ".join(report.notes))


@claim("report: missing or damaged files are reported in a sentence, and the rest is shown")
def _(t):
    t.expect_success("run", t.deck(*TWO), "--out", "r", "--no-report")

    def after(*changes):
        shutil.rmtree(t.folder / "d", ignore_errors=True)
        shutil.copytree(t.folder / "r", t.folder / "d")
        for change in changes:
            change(t.folder / "d")
        out = t.expect_success("report", "d").out
        report = ReportFile(t.folder / "d/report.html")
        t.assertEqual([line[6:].replace("d/", "") for line in out.splitlines()[1:]], report.notes)  # the page may be read elsewhere
        return report

    def without(name):
        return lambda folder: (folder / name).unlink()

    def cut(name, share=0.5):
        return lambda folder: os.truncate(folder / name, int(share * (folder / name).stat().st_size))

    report = after(without("run.json"))  # as of a run that was killed
    t.assertIsNone(report.run)
    t.assertRegex(report.notes[0], r"^run\.json does not exist: the run is in progress or was killed\.")
    t.assertEqual(len(report.body("plate")[2]), 5)

    report = after(cut("run.json"))
    t.assertIsNone(report.run)
    t.assertRegex(report.notes[0], r"^run\.json:.*Deck, checks and timers are missing from this report\.$")

    report = after(without("history.csv"))
    t.assertNotIn("history", report.description)
    t.assertRegex(report.notes[0], r"^history\.csv does not exist")
    report = after(without("history.json"))
    t.assertIn("history", report.description)
    t.assertRegex(report.notes[0], r"^history\.json does not exist.*Where rows are merged in this report, the last value is shown\.$")
    report = after(cut("history.csv", 0.99))
    t.assertNotIn("history", report.description)
    t.assertRegex(report.notes[0], r"^history\.csv:\d+: this row ")

    report = after(without("frames/plate_00002.vtp"), cut("frames/plate_00003.vtp"))
    body, _, pictures = report.body("plate")
    t.assertEqual((body["pictures"], len(pictures)), ([0, 1, 4], 3))
    t.assertEqual(len(report.times), 5)  # the others have theirs
    t.assertRegex(report.notes[0], r"^frames/plate_00002\.vtp: there is no such file")
    t.assertRegex(report.notes[1], r"^frames/plate_00003\.vtp:\d+: ")

    report = after(cut("frames/plate_00000.vtp", 0.02), cut("frames/cylinder_00001.vtp", 0.9))
    t.assertEqual(report.body("plate")[0]["pictures"], [1, 2, 3, 4])
    t.assertEqual(len(report.notes), 2)

    report = after(without("frames/plate.pvd"))
    t.assertEqual([body["name"] for body in report.description["bodies"]], ["stone"])
    report = after(lambda folder: (folder / "frames/stone.pvd").write_text("nothing"))
    t.assertRegex(report.notes[0], r"^frames/stone\.pvd lists no frames")
    report = after(lambda folder: shutil.copy(folder / "frames/stone_00001.vtp", folder / "frames/plate_00002.vtp"))
    t.assertRegex(report.notes[0], r"^frames/plate_00002\.vtp has 64 particles, but the earlier frames have 960; use the files of one run\.$")
    report = after(lambda folder: shutil.rmtree(folder / "frames"))
    t.assertEqual((report.description["bodies"], report.times), ([], []))
    t.assertRegex(report.notes[0], r"^frames contains no frame series")


@claim("report: a folder without results, and a size out of range, are refused with 2 and a sentence")
def _(t):
    (t.folder / "empty").mkdir()
    for folder in ("empty", "nowhere"):
        t.expect_complaint(t.run_program("report", folder), 2, f"{folder} contains no results of a run", "perimpact run")
    t.expect_complaint(t.run_program("report", "empty", "--size", "0"), 2, "--size: Value 0 not in range", "--help lists the options")
    t.assertEqual(t.files("empty"), [])


@claim("report: an interrupted run can be reported")
def _(t):
    deck = t.deck(("{end: 20 us}", "{end: 20 ms, step: 0.2 us}"), ("frames: 4", "frames: 4000"), ("history_interval: 2 us", "history_interval: 20 us"))
    process = t.start("run", deck, "--out", "r")
    while not (t.folder / "r/frames/plate_00003.vtp").exists():
        t.assertIsNone(process.poll())
    process.terminate()
    process.communicate(timeout=60)
    report = report_of(t, "r")
    t.assertEqual(report.run["outcome"], "interrupted")
    t.assertGreaterEqual(len(report.times), 4)


main()
