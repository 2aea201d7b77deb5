"""Boundary conditions and relaxation, from the deck to the results folder."""

import signal
import time

from claims import claim, main

BAR = """\
title: A bar, pulled
time: {end: 1, relax: {increments: 4, tolerance: 1e-5}}
bodies:
  bar:
    shape: {box: {size: [40 mm, 5 mm, 5 mm]}}
    spacing: 1 mm
    material: {model: ordinary-state, youngs_modulus: 200 GPa, density: 7850}
    particle_sets:
      left: {shape: {box: {size: [3 mm, 5 mm, 5 mm]}}, position: [-18.5 mm, 0, 0]}
      right: {shape: {box: {size: [3 mm, 5 mm, 5 mm]}}, position: [18.5 mm, 0, 0]}
    boundary_conditions:
      clamp: {fixed: {particle_set: left}}
      pull: {prescribed: {particle_set: right, x: {file: pull.csv}}}
output: {folder: results, frames: 2, probes: {middle: {body: bar, at: [0, 0, 0]}}}
"""


def bar(t, *changes):
    (t.folder / "pull.csv").write_text("time [s], displacement [mm]\n0, 0\n1, 0.04\n")
    text = BAR
    for old, new in changes:
        t.assertIn(old, text)
        text = text.replace(old, new)
    (t.folder / "bar.yaml").write_text(text)
    return "bar.yaml"


@claim("boundary conditions: relaxation of a bar writes one row per increment with its convergence")
def _(t):
    out = t.expect_success("run", bar(t), "--out", "r").out
    t.assertRegex(out, r"\n\d+ threads?, 4 increments of 0\.25 s; results go to r\n")
    t.assertRegex(out, r"\n100\.0 %  increment 4 of 4  t = 1 s  \d+ iterations  residual \S+  0 s left\n")
    history, report = t.history("r"), t.report("r")
    t.assertEqual(history["time [s]"], [0, 0.25, 0.5, 0.75, 1])
    t.assertTrue(all(residual <= 1e-5 for residual in history["total.residual [-]"]))
    force = history["bar.pull.force_x [N]"]
    # 34 of 40 mm are free and about as long is what strains: E A u/L, within the length of the clamps
    t.assertTrue(200e9 * 25e-6 * 0.04 / 40 < force[-1] < 200e9 * 25e-6 * 0.04 / 34, force)
    t.assertAlmostEqual(history["bar.clamp.force_x [N]"][-1] / force[-1], -1, 3)  # the residual adds up along the bar
    t.assertAlmostEqual(history["middle.displacement_x [m]"][-1] / 2e-5, 1, 2)  # half of the displacement, up to that and the bar's contraction
    t.assertEqual(report["bodies"]["bar"]["boundary_conditions"]["clamp"]["kind"], "fixed")
    t.assertEqual(report["bodies"]["bar"]["boundary_conditions"]["pull"]["particles"], 75)
    t.assertEqual(report["increment [s]"], 0.25)


@claim("boundary conditions: check reports the particles of each, and the number of increments")
def _(t):
    out = t.expect_success("check", bar(t), "--out", "r").out
    t.assertIn("  bar.clamp         fixed, 75 particles\n  bar.pull          prescribed, 75 particles\n", out)
    t.assertIn("time\n  increments        4 of 0.25 s\n", out)


@claim("boundary conditions: a relaxation interrupted between increments resumes to the same state and rows")
def _(t):
    many = ("increments: 4", "increments: 40")
    t.expect_success("run", bar(t, many), "--out", "whole")
    process = t.start("run", "bar.yaml", "--out", "stopped")
    rows = t.folder / "stopped/history.csv"
    count = lambda: rows.read_text().count("\n") if rows.exists() else 0  # noqa: E731
    deadline = time.monotonic() + 120
    while process.poll() is None and count() <= 2 and time.monotonic() < deadline:
        time.sleep(0.01)
    process.send_signal(signal.SIGINT)
    process.communicate(timeout=60)
    t.assertEqual(process.returncode, 130)
    t.assertTrue(2 < count() < 42, count())  # header, first row and 40 increments
    t.expect_success("run", "bar.yaml", "--out", "stopped", "--resume")
    t.assertEqual(t.report("stopped")["state_hash"], t.report("whole")["state_hash"])
    t.assertEqual((t.folder / "stopped/history.csv").read_bytes(), (t.folder / "whole/history.csv").read_bytes())


@claim("boundary conditions: a relaxation interrupted within an increment resumes to the same state and rows")
def _(t):
    slow = (("increments: 4", "increments: 2"), ("tolerance: 1e-5", "tolerance: 1e-7"), ("spacing: 1 mm", "spacing: 0.5 mm"))
    t.expect_success("run", bar(t, *slow), "--out", "whole")
    stops = attempts = 0
    code = None
    while code != 0:
        t.assertLess(attempts, 14)
        resume = ["--resume"] if stops else []
        process = t.start("run", "bar.yaml", "--out", "stopped", *resume)
        time.sleep(0.3 * 1.5**attempts)  # longer each time, so that it gets past the set-up and ends on a busy machine too
        attempts += 1
        process.send_signal(signal.SIGINT)
        process.communicate(timeout=60)
        code = process.returncode
        t.assertIn(code, (0, 130, -signal.SIGINT))
        if code == 130 and (t.folder / "stopped/checkpoint.h5").exists():  # absent where it was still setting up
            stops += 1
    t.assertGreater(stops, 0)
    t.assertEqual(t.report("stopped")["state_hash"], t.report("whole")["state_hash"])
    t.assertEqual((t.folder / "stopped/history.csv").read_bytes(), (t.folder / "whole/history.csv").read_bytes())


@claim("boundary conditions: an unknown particle set is refused with its position in the deck")
def _(t):
    done = t.run_program("run", bar(t, ("clamp: {fixed: {particle_set: left}}", "clamp: {fixed: {particle_set: lef}}")))
    t.expect_complaint(done, 2, "bar.yaml:12:", "body bar has no particle set lef; did you mean left?")


@claim("boundary conditions: an absorbing layer is refused where the body continues beyond its face, and accepted at the end of the body")
def _(t):
    def layer(at, face):
        regions = f"particle_sets: {{layer: {{shape: {{box: {{size: [20 mm, 60 mm, 20 mm]}}}}, position: [{at}, 0, 0]}}}}"
        return t.deck(("spacing: 5 mm", f"spacing: 5 mm\n    {regions}\n    boundary_conditions: {{sink: {{absorbing: {{particle_set: layer, face: {face}}}}}}}"))

    for at, face in (("40 mm", "+x"), ("-40 mm", "-x"), ("40 mm", "+y"), ("0 mm", "-z")):
        t.expect_success("check", layer(at, face), "--out", "r")
    for at, face in (("40 mm", "-x"), ("-40 mm", "+x"), ("0 mm", "+x")):
        done = t.run_program("check", layer(at, face), "--out", "r")
        t.expect_complaint(done, 2, "deck.yaml:8:", f"the layer ends where body plate continues towards {face}, ", "extend particle set layer to the end of the body")


@claim("boundary conditions: a run without equilibrium ends with exit code 3, the increment and its residual")
def _(t):
    loose = ("clamp: {fixed: {particle_set: left}}", "clamp: {body_force: {force_density: [0, 1 MN/m3, 0]}}")
    done = t.run_program("run", bar(t, loose, ("tolerance: 1e-5", "max_iterations: 50")), "--out", "r")
    t.assertEqual(done.code, 3)
    t.assertIn("Increment 1 (t = 0.25 s) is not in equilibrium after 50 iterations", done.err)
    t.assertEqual(t.report("r")["outcome"], "failed")


main()
