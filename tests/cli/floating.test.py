"""Impactors and sheets that float: what check foretells, and the results of a run."""

import math

from claims import claim, main

# a box of 2 m × 1 m × 0.5 m in water of 1000 kg/m3, and a body far above without contact
DECK = """\
title: A box in water
time: {end: 6 s, step: 2 ms}
bodies:
  block:
    shape: {box: {size: [0.4 m, 0.4 m, 0.4 m]}}
    position: [0, 0, 50 m]
    spacing: 0.1 m
    material: {model: ordinary-state, youngs_modulus: 1 MPa, density: 1000 kg/m3}
impactors:
  raft:
    surface: {box: {size: [2 m, 1 m, 0.5 m], edge_length: 0.5 m}}
    mass: 500 kg
    position: [0, 0, 0]
    free_dofs: [z]
    floating: {level: 0, density: 1000 kg/m3, gravity: 9.81 m/s2, damping: 0}
output: {folder: results, frames: 0, history_interval: 10 ms}
"""


def deck(t, *changes):
    text = DECK
    for old, new in changes:
        t.assertIn(old, text)
        text = text.replace(old, new)
    (t.folder / "raft.yaml").write_text(text)
    return "raft.yaml"


@claim("floating: check reports whether an impactor floats, rises, settles or sinks, and its equilibrium draft")
def _(t):
    def line(*changes):
        out = t.expect_success("check", deck(t, *changes), "--out", "r").out
        return next(line for line in out.splitlines() if line.startswith("  in water"))

    begins = "  in water          "
    t.assertEqual(line(), begins + "floats at rest: displaces 500 kg at a draft of 0.25 m, net force +0 N upward; in this attitude it floats at a draft of 0.25 m")
    t.assertEqual(line(("position: [0, 0, 0]", "position: [0, 0, -0.1 m]")), begins + "rises: displaces 700 kg at a draft of 0.35 m, net force +1962 N upward; in this attitude it floats at a draft of 0.25 m")
    t.assertEqual(line(("position: [0, 0, 0]", "position: [0, 0, 3 m]")), begins + "settles: displaces 0 kg at a draft of -2.75 m, net force -4905 N upward; in this attitude it floats at a draft of 0.25 m")
    t.assertEqual(line(("mass: 500 kg", "mass: 1500 kg"), ("position: [0, 0, 0]", "position: [0, 0, -3 m]")), begins + "sinks: displaces 1000 kg at a draft of 3.25 m, net force -4905 N upward; it is heavier than the water that it can displace")


@claim("floating: history and run.json give water force, displaced mass, draft and work, and the box oscillates with the period of its waterplane")
def _(t):
    # six periods of 1.003 s and a quarter: it ends where the box is fastest, so that all its energy is in the work
    t.expect_success("run", deck(t, ("position: [0, 0, 0]", "position: [0, 0, 0.05 m]"), ("end: 6 s", "end: 6.27 s")), "--out", "r")
    history, report = t.history("r"), t.report("r")["impactors"]["raft"]["floating"]
    times, heights = history["time [s]"], history["raft.position_z [m]"]
    rising = [k for k in range(1, len(heights)) if heights[k - 1] < 0 <= heights[k]]
    crossings = [times[k] - heights[k] / (heights[k] - heights[k - 1]) * (times[k] - times[k - 1]) for k in rising]
    period = (crossings[-1] - crossings[0]) / (len(crossings) - 1)
    t.assertGreater(len(crossings), 3)
    t.assertAlmostEqual(period / (2 * math.pi * math.sqrt(500 / (1000 * 9.81 * 2))), 1, delta=1e-4)  # (ω dt)²/24 and straight lines between rows
    for height, displaced in zip(heights, history["raft.displaced_mass [kg]"]):
        t.assertAlmostEqual(displaced, 1000 * 2 * (0.25 - height), delta=1e-8)
    expected = {"level [m]": 0, "mass [kg]": 500, "added_mass [kg]": 0, "displaced_at_start [kg]": 400, "force_at_start [N]": -981, "draft_at_start [m]": 0.2, "draft_at_rest [m]": 0.25}
    for key, value in expected.items():
        t.assertAlmostEqual(report[key], value, delta=1e-9 * 1000, msg=key)
    t.assertAlmostEqual(report["draft [m]"], 0.25 - heights[-1], delta=1e-12)
    # weight and buoyancy lose what the box gains, but for the half step between places and velocities, ω dt of the energy of 24.5 J at most
    start = 500 * 9.81 * 0.05 + 1000 * 9.81 * 0.2**2  # m g z, and ρ g B L T²/2 to push a box under
    t.assertAlmostEqual(report["work [J]"], start - report["potential [J]"], delta=24.5 * 6.3 * 2e-3)
    t.assertGreater(report["work [J]"], 24)
    t.assertAlmostEqual(report["work [J]"], 250 * history["raft.velocity_z [m/s]"][-1] ** 2, delta=1e-9)


SHEET = """\
title: A sheet on water
time: {end: 1 ms}
bodies:
  sheet:
    shape: {box: {size: [10 m, 8 m, 2 m]}}
    spacing: 0.5 m
    boundary_conditions: {sea: {floating: {entrained_depth: 4.5 m, dry_top: 0.3 m}}}
    material:
      model: bond-based
      density: 910
      youngs_modulus: 1.8 GPa
      ice: {temperature: -5 degC, salinity: 5 g/kg, strain_rate: 1e-3}
      plasticity: {}
output: {folder: results, frames: 0}
"""


@claim("floating: check reports the characteristic length of a sheet and the strength that a strain rate gives, and run.json is a deck of the same run")
def _(t):
    (t.folder / "sheet.yaml").write_text(SHEET)
    out = t.expect_success("check", "sheet.yaml", "--out", "c").out
    # D = 1.8e9 8/(12 15/16) = 1.28e9 N m; (1.28e9/(1025 9.81))^(1/4)
    t.assertIn("  water             characteristic length l = 18.89 m; entrained depth of a bending wave of wavenumber k: 1/k, of a patch of radius R: 0.64 R; given: 4.5 m\n", out)
    # 37 MPa 1e-3^0.22 (1 - sqrt(51.845/270))
    t.assertIn("  yields            at 4.548e+06 Pa in uniaxial compression", out)
    t.expect_success("run", "sheet.yaml", "--out", "first")
    report = (t.folder / "first/run.json").read_text()
    (t.folder / "again.yaml").write_text(report[report.index('"setup":') + len('"setup":') : report.rindex("}")])
    t.expect_success("run", "again.yaml", "--out", "second")
    t.assertEqual(t.report("second")["state_hash"], t.report("first")["state_hash"])
    t.assertEqual(t.history("second")["sheet.sea.flooding_dissipation [J]"][-1], 0)


@claim("floating: an open surface is refused at its key")
def _(t):
    (t.folder / "lid.obj").write_text("v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nf 1 2 3 4\n")
    done = t.run_program("check", deck(t, ("{box: {size: [2 m, 1 m, 0.5 m], edge_length: 0.5 m}}", "{file: lid.obj, orientation: normals}")), "--out", "r")
    t.expect_complaint(done, 2, "raft.yaml:", "raft is open", "its displacement is undefined")


main()
