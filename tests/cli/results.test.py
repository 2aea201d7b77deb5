"""Results of a run."""

import re
import xml.etree.ElementTree as xml

from claims import DECK, claim, main, table

AXES = "xyz"


def columns_of_the_deck():
    """As docs/guide and the architecture say them: name.quantity_axis [unit]."""

    def vector(owner, quantity, unit):
        return [f"{owner}.{quantity}_{axis} [{unit}]" for axis in AXES]

    return [
        "time [s]",
        *vector("cylinder", "position", "m"),
        *vector("cylinder", "velocity", "m/s"),
        *vector("cylinder", "angular_velocity", "rad/s"),
        "cylinder.kinetic_energy [J]",
        *vector("cylinder", "force", "N"),
        *vector("cylinder", "moment", "N m"),
        "cylinder.contacts [-]",
        "cylinder.contact_work [J]",
        "plate.kinetic_energy [J]",
        "plate.elastic_energy [J]",
        "plate.broken_bonds [-]",
        "plate.fracture_energy [J]",
        *vector("total", "momentum", "kg m/s"),
        "total.energy [J]",
        "total.contact_dissipation [J]",
        "total.energy_balance_error [J]",
        *vector("centre", "displacement", "m"),
    ]


def head_of_vtp(path):
    """The XML of a .vtp without the raw bytes that it carries at its end."""
    content = path.read_bytes()
    mark = content.index(b"<AppendedData")
    return xml.fromstring(content[:mark] + b"</VTKFile>")


@claim("results: a run writes run.json, history, lines, frames, pressure-area curves and a report, nothing else, and exits with 0")
def _(t):
    t.expect_success("run", t.deck(), "--out", "r")
    wanted = ["checkpoint.h5", "files.txt", "history.csv", "history.json", "lines/along_y_t2e-05.csv", "open_in_paraview.py", "pressure_area/cylinder.csv", "pressure_area/cylinder_at_peak.csv", "report.html", "run.json"]
    for name in ("plate", "cylinder"):
        wanted += [f"frames/{name}.pvd"] + [f"frames/{name}_{frame:05}.vtp" for frame in range(5)]
    t.assertEqual(t.files("r"), sorted(wanted))


@claim("results: history has the documented columns, from 0 to the end, one row per interval")
def _(t):
    t.expect_success("run", t.deck(("20 us}", "20 us, step: 0.5 us}")), "--out", "r")
    history = t.history("r")
    t.assertEqual(list(history), columns_of_the_deck())
    for got, wanted in zip(history["time [s]"], range(0, 21, 2), strict=True):
        t.assertAlmostEqual(got, wanted * 1e-6, delta=1e-18)  # rounding of 40 steps of 0.5e-6 s


@claim("results: forces are the impulse of each interval over its length, and momentum is conserved")
def _(t):
    t.expect_success("run", t.deck(), "--out", "r")
    history = t.history("r")
    time, velocity, force = (history[name] for name in ("time [s]", "cylinder.velocity_y [m/s]", "cylinder.force_y [N]"))
    t.assertGreater(max(force), 1e5, "the cylinder must have struck")
    mass = 1.0
    for k in range(1, len(time)):
        gained = mass * (velocity[k] - velocity[k - 1])
        t.assertAlmostEqual(force[k] * (time[k] - time[k - 1]), gained, delta=1e-12 * 32)  # rounding of velocities of 32 m/s
    for momentum in history["total.momentum_y [kg m/s]"]:
        t.assertAlmostEqual(momentum, -32, delta=1e-12 * 32)  # contact keeps it to rounding


@claim("results: the kinetic energy of an impactor is that of its translation and rotation")
def _(t):
    # beyond reach of the plate, so that the velocities are those of the deck
    far = ("position: [0, 50 mm, 0]", "position: [0, 150 mm, 0]\n    angular_velocity: [0, 0, 100]")
    t.expect_success("run", t.deck(far, ("free_dofs: [y]", "free_dofs: [y, rz]\n    inertia: [1e-3, 1e-3, 2e-3]")), "--out", "r", "--no-report")
    mass = t.report("r")["impactors"]["cylinder"]["mass [kg]"]
    for energy in t.history("r")["cylinder.kinetic_energy [J]"]:
        t.assertAlmostEqual(energy, mass * 32**2 / 2 + 2e-3 * 100**2 / 2, delta=1e-9 * energy)  # rounding


@claim("results: gauges have columns behind those of their impactor, the torque where they have an axis, and add up to its force")
def _(t):
    gauges = "gauges: {rim: {surface_parts: [side]}, caps: {surface_parts: [bottom, top]}, hub: {point: [0, 1 mm, 0], axis: [0, 0, 1]}}"
    t.expect_success("run", t.deck(("free_dofs: [y]", f"free_dofs: [y]\n    {gauges}")), "--out", "r")
    history = t.history("r")
    names = list(history)
    first = names.index("cylinder.contact_work [J]") + 1
    wanted = [f"cylinder.{gauge}.{quantity}_{axis} [{unit}]" for gauge in ("rim", "caps", "hub") for quantity, unit in (("force", "N"), ("moment", "N m")) for axis in AXES]
    t.assertEqual(names[first : first + 19], wanted + ["cylinder.hub.torque [N m]"])
    t.assertEqual(names[first + 19], "plate.kinetic_energy [J]")
    for axis in AXES:
        for rim, caps, whole in zip(*(history[f"cylinder.{who}force_{axis} [N]"] for who in ("rim.", "caps.", "")), strict=True):
            t.assertAlmostEqual(rim + caps, whole, delta=1e-9 * 1e5)  # sums of some hundred impulses in another order
    for torque, moment in zip(history["cylinder.hub.torque [N m]"], history["cylinder.hub.moment_z [N m]"], strict=True):
        t.assertAlmostEqual(torque, moment, delta=1e-9)  # the axis is z and does not turn
    t.assertGreater(max(map(abs, history["cylinder.rim.force_y [N]"])), 1e5)


@claim("results: an impactor follows its file of displacements, and run.json contains the table, so that it runs again without the file")
def _(t):
    (t.folder / "stroke.csv").write_text("time [us], displacement [mm]\n0, 0\n10, -2\n15, -1\n")
    deck = t.deck(("velocity: [0, -32 m/s, 0]", "motion: {y: {file: stroke.csv}}"), ("free_dofs: [y]", "free_dofs: []"))
    t.expect_success("run", deck, "--out", "r")
    history = t.history("r")
    for time, y in zip(history["time [s]"], history["cylinder.position_y [m]"], strict=True):
        wanted = -200 * time if time <= 10e-6 else min(-2e-3 + 200 * (time - 10e-6), -1e-3)
        t.assertAlmostEqual(y, 0.05 + wanted, delta=1e-15)  # some dozens of roundings of 0.05
    report = t.report("r")
    t.assertEqual(report["setup"]["impactors"]["cylinder"]["motion"]["y"]["displacements"], [0, -0.002, -0.001])
    (t.folder / "stroke.csv").unlink()
    text = (t.folder / "r/run.json").read_text()
    (t.folder / "again.yaml").write_text(text[text.index('"setup":') + len('"setup":') : text.rindex("}")])
    t.expect_success("run", "again.yaml", "--out", "again")
    t.assertEqual(t.report("again")["state_hash"], report["state_hash"])


@claim("results: a line has one row per spacing, and its displacements agree with the probe")
def _(t):
    t.expect_success("run", t.deck(), "--out", "r")
    line = table(t.folder / "r/lines/along_y_t2e-05.csv")
    t.assertEqual(list(line), [f"{quantity}_{axis} [m]" for quantity in ("position", "displacement") for axis in AXES])
    t.assertEqual([round(y, 9) for y in line["position_y [m]"]], [round(-0.0275 + 0.005 * k, 9) for k in range(12)])
    # The probe is the mean of the eight particles about the centre; the two samples beside it are the means of four each.
    middle = 0.5 * (line["displacement_y [m]"][5] + line["displacement_y [m]"][6])
    t.assertAlmostEqual(t.history("r")["centre.displacement_y [m]"][-1], middle, delta=1e-12 * abs(middle))  # rounding of sums of eight


@claim("results: each series lists its frames with their times, and each frame is well-formed and complete")
def _(t):
    t.expect_success("run", t.deck(("20 us}", "20 us, step: 0.5 us}")), "--out", "r")
    for name, points in ("plate", 960), ("cylinder", None):
        entries = xml.parse(t.folder / f"r/frames/{name}.pvd").findall("./Collection/DataSet")
        t.assertEqual([entry.get("file") for entry in entries], [f"{name}_{frame:05}.vtp" for frame in range(5)])
        for entry, wanted in zip(entries, range(0, 21, 5), strict=True):
            t.assertAlmostEqual(float(entry.get("timestep")), wanted * 1e-6, delta=1e-18)  # rounding of 40 steps of 0.5e-6 s
            head = head_of_vtp(t.folder / "r/frames" / entry.get("file"))
            t.assertEqual(head.get("type"), "PolyData")
            t.assertEqual(float(head.find(".//FieldData/DataArray[@Name='TimeValue']").text), float(entry.get("timestep")))
            if points:
                t.assertEqual(head.find(".//Piece").get("NumberOfPoints"), str(points))
                t.assertEqual([array.get("Name") for array in head.findall(".//PointData/DataArray")], ["displacement", "velocity", "damage"])


@claim("results: more frames than steps are one per step, and an uneven number of them is distributed over the run")
def _(t):
    deck = t.deck(("20 us}", "4 us, step: 0.5 us}"))
    for wanted, steps in (1000, list(range(9))), (8, list(range(9))), (3, [0, 3, 5, 8]), (1, [0, 8]):
        t.expect_success("run", deck, "--out", "r", "--force", "--set", f"output.frames={wanted}")
        times = [float(entry.get("timestep")) for entry in xml.parse(t.folder / "r/frames/plate.pvd").findall("./Collection/DataSet")]
        t.assertEqual([round(time / 0.5e-6) for time in times], steps)


@claim("results: run.json describes set-up and outcome of the run with consistent numbers")
def _(t):
    t.expect_success("run", t.deck(), "--out", "r", "--threads", "2")
    report = t.report("r")
    t.assertEqual((report["outcome"], report["title"], report["threads"]), ("finished", "Small plate", 2))
    t.assertNotIn("failure", report)
    t.assertRegex(report["state_hash"], "^[0-9a-f]{16}$")
    t.assertAlmostEqual(report["steps"] * report["stability"]["step [s]"], 20e-6, delta=1e-15)  # sums nothing, so only rounding
    t.assertEqual(report["time [s]"], t.history("r")["time [s]"][-1])
    t.assertEqual(report["bodies"]["plate"]["particles"], 20 * 12 * 4)
    t.assertEqual(report["bodies"]["plate"]["bonds"], report["bodies"]["plate"]["intact_bonds"])
    t.assertAlmostEqual(report["bodies"]["plate"]["mass [kg]"], 0.1 * 0.06 * 0.02 * 8000, delta=1e-12)
    t.assertEqual(report["impactors"]["cylinder"]["surface"]["closure"], "closed")
    t.assertEqual(list(report["timers [s]"]), ["predict", "contact", "forces", "boundary_conditions", "monitors"])
    t.assertLessEqual(sum(report["timers [s]"].values()), report["wall_time [s]"])


@claim("results: the Setup in run.json, with its defaults filled in, is a deck that yields the same state")
def _(t):
    t.expect_success("run", t.deck(("191 GPa", "19.1e10 Pa")), "--out", "first")
    first = t.report("first")
    material = first["setup"]["bodies"]["plate"]["material"]
    t.assertEqual((material["youngs_modulus"], material["poissons_ratio"]), (191e9, 0.25))
    t.assertEqual(first["setup"]["bodies"]["plate"]["horizon_ratio"], 3.015)
    report = (t.folder / "first/run.json").read_text()
    setup = report[report.index('"setup":') + len('"setup":') : report.rindex("}")]
    (t.folder / "again.yaml").write_text(setup)
    t.expect_success("run", "again.yaml", "--out", "second")
    t.assertEqual(t.report("second")["state_hash"], first["state_hash"])
    t.assertEqual(t.report("second")["setup"], first["setup"])


@claim("results: --set changes values of the deck, and --out the folder")
def _(t):
    deck = t.deck()
    t.expect_success("run", deck, "--set", "time.end=5 us", "--set", "output.frames=0", "--set", "output.folder=elsewhere",
                     "--set", "impactors.cylinder.velocity=[0, -10, 0]", "--set", "bodies.plate.material.critical_stretch=0.01")
    t.assertEqual(t.files("elsewhere"), ["checkpoint.h5", "files.txt", "fragments/plate_end.csv", "history.csv", "history.json", "lines/along_y_t5e-06.csv", "report.html", "run.json"])
    setup = t.report("elsewhere")["setup"]
    t.assertEqual((setup["time"]["end"], setup["impactors"]["cylinder"]["velocity"]), (5e-6, [0, -10, 0]))
    t.assertEqual(setup["bodies"]["plate"]["material"]["critical_stretch"], 0.01)
    t.assertEqual(t.history("elsewhere")["cylinder.velocity_y [m/s]"][0], -10)
    t.expect_success("run", deck, "--set", "output.frames=0", "--out", "deep/er")
    t.assertTrue((t.folder / "deep/er/run.json").exists())
    t.assertFalse((t.folder / "results").exists())


@claim("results: a second run into the same folder removes the results of the first, and nothing else")
def _(t):
    deck = t.deck(("to: [0, 30 mm, 0]", "to: [0, 30 mm, 0], times: [10 us, 20 us]"))
    t.expect_success("check", deck, "--out", "r")
    t.expect_success("run", deck, "--out", "r", "--set", "output.frames=9")
    foreign = ["notes.txt", "frames/hero.png", "lines/reference.csv", "frames/view.pvsm", "frames/plate_00003.vtp.bak"]
    for name in foreign:
        (t.folder / "r" / name).write_text("kept")
    (t.folder / "r/frames/plate_00009.vtp.part").write_text("of a run that was killed")
    checked = t.files("r/check")
    t.expect_success("run", t.deck(), "--out", "r", "--force", "--set", "output.frames=1")
    t.expect_success("run", t.deck(), "--out", "fresh", "--set", "output.frames=1")
    t.assertEqual(t.files("r"), sorted(t.files("fresh") + foreign + [f"check/{name}" for name in checked]))
    t.assertEqual(t.files("r/check"), ["cylinder_surface.vtp", "plate.vtp"])
    for name in [name for name in t.files("fresh") if not name.endswith(("run.json", "report.html"))]:
        t.assertEqual((t.folder / "r" / name).read_bytes(), (t.folder / "fresh" / name).read_bytes(), name)


@claim("results: a refused deck leaves the results of an earlier run unchanged")
def _(t):
    t.expect_success("run", t.deck(), "--out", "r", "--force")
    before = {name: (t.folder / "r" / name).read_bytes() for name in t.files("r")}
    for change in [("spacing: 5 mm", "spacing: 5 kg"), ("20 us}", "20 us, step: 5 us}"), ("0, 50 mm, 0", "0, 40 mm, 0"), ("to: [0, 30 mm, 0]", "to: [0, 1, 0]"),
                   ("at: [0, 0, 0]", "at: [1, 0, 0]")]:
        done = t.run_program("run", t.deck(change), "--out", "r", "--force")
        t.assertEqual(done.code, 2, done)
        t.assertEqual({name: (t.folder / "r" / name).read_bytes() for name in t.files("r")}, before, change)


@claim("results: a body without contact stays at rest, which is not an error")
def _(t):
    impactors = DECK[DECK.index("impactors:\n") : DECK.index("contact:")]
    for settings in [], ["--set", "bodies.plate.position=[1 km, 0, 0]", "--set", "output.lines={}", "--set", "output.probes={}"]:
        t.expect_success("run", t.deck((impactors, "")), "--out", "r", "--force", *settings)
        t.assertLess(max(t.history("r")["total.energy [J]"]), 1e-12)  # a nanogram dropped from a nanometre; rounding at 1 km gives 1e-15


@claim("results: an unstable run exits with 3 and the step, and run.json records the message")
def _(t):
    # just below the limit of small strains, and with an impact so fast that strains are not small
    done = t.run_program("run", t.deck(("end: 20 us", "end: 1 ms, step: 1.5 us"), ("-32 m/s", "-3200 m/s")), "--out", "r")
    t.expect_complaint(done, 3, "At step ", "reduce it")
    report = t.report("r")
    t.assertEqual((report["outcome"], f"error: {report['failure']}"), ("failed", done.err.strip()))
    t.assertEqual(len(report["warnings"]), 1)
    printed = int(re.search(r"At step (\d+)", done.err)[1])
    t.assertEqual(report["steps"], printed)
    t.assertLess(t.history("r")["time [s]"][-1], printed * 1.5e-6)


main()
