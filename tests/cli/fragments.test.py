"""Fragment output of a run."""

import signal
import time

from claims import claim, main, table

BREAKS = ("density: 8000 kg/m3", "density: 8000 kg/m3, critical_stretch: 0.002")
FAST = ("velocity: [0, -32 m/s, 0]", "velocity: [0, -132 m/s, 0]")
LONGER = ("end: 20 us", "end: 30 us, step: 0.05 us")


def arrays_of(path):
    """Names of the point arrays of a .vtp."""
    content = path.read_bytes()
    head = content[: content.index(b"</PointData>")].decode()
    return [part[: part.index('"')] for part in head.split('Name="')[1:] if part[: part.index('"')] != "TimeValue"]


@claim("fragments: a body with a failure criterion has a table over output frames, one at the end, and an array next to the damage")
def _(t):
    t.expect_success("run", t.deck(BREAKS, FAST, LONGER), "--out", "r")
    curve, end, report = table(t.folder / "r/fragments/plate.csv"), table(t.folder / "r/fragments/plate_end.csv"), t.report("r")["bodies"]["plate"]
    for got, wanted in zip(curve["time [s]"], (0, 7.5e-6, 15e-6, 22.5e-6, 30e-6), strict=True):
        t.assertAlmostEqual(got, wanted, delta=1e-15)  # rounding of 600 steps
    # whole at first: one fragment of the whole mass
    t.assertEqual([curve[name][0] for name in list(curve)[1:]], [1, 0, report["mass [kg]"], 0, 1, 0])
    t.assertEqual(report["fragments"]["single_particles"] > 0, True)
    for column, entry in (("fragments [-]", "fragments"), ("single_particles [-]", "single_particles"), ("largest [kg]", "largest [kg]"),
                          ("second_largest [kg]", "second_largest [kg]"), ("above_1_percent [-]", "above_1_percent"), ("outside_largest [kg]", "outside_largest [kg]")):
        t.assertEqual(curve[column][-1], report["fragments"][entry], column)
    particle = 8000 * 0.005**3
    t.assertEqual(len(end["fragment [-]"]), report["fragments"]["fragments"])
    t.assertEqual(sum(end["particles [-]"]) + report["fragments"]["single_particles"], report["particles"])
    for particles, mass in zip(end["particles [-]"], end["mass [kg]"]):
        t.assertAlmostEqual(mass / (particles * particle), 1, delta=1e-12)  # sums of up to 960 numbers
    for frame in range(5):
        t.assertEqual(arrays_of(t.folder / f"r/frames/plate_{frame:05}.vtp"), ["displacement", "velocity", "damage", "fragment"])


@claim("fragments: a body without failure has no fragment output")
def _(t):
    t.expect_success("run", t.deck(FAST), "--out", "r")
    t.assertEqual([name for name in t.files("r") if name.startswith("fragments")], [])
    t.assertNotIn("fragments", t.report("r")["bodies"]["plate"])
    t.assertEqual(arrays_of(t.folder / "r/frames/plate_00001.vtp"), ["displacement", "velocity", "damage"])


@claim("fragments: without output frames there is the final table only, also of an interrupted run")
def _(t):
    t.expect_success("run", t.deck(BREAKS), "--out", "r", "--set", "output.frames=0")
    t.assertEqual([name for name in t.files("r") if name.startswith("fragments")], ["fragments/plate_end.csv"])
    process = t.start("run", t.deck(BREAKS, ("end: 20 us", "end: 100 s"), ("history_interval: 2 us", "history_interval: 2 us\n  checkpoint_interval: 0")), "--out", "long", "--set",
                      "output.frames=0")
    history = t.folder / "long/history.csv"
    while not history.exists() or history.read_bytes().count(b"\n") < 3:
        t.assertIsNone(process.poll())
        time.sleep(0.005)
    process.send_signal(signal.SIGINT)
    process.communicate(timeout=60)
    t.assertEqual(process.returncode, 130)
    t.assertEqual(sum(table(t.folder / "long/fragments/plate_end.csv")["particles [-]"]) + t.report("long")["bodies"]["plate"]["fragments"]["single_particles"], 960)


@claim("fragments: a body separated by a crack starts as two, each with its size and speed")
def _(t):
    deck = t.deck(BREAKS, ("    spacing: 5 mm", "    spacing: 5 mm\n    velocity: [1, 2, 3]\n    cracks: {middle: {polygon: [[20 mm, -1, -1], [20 mm, 1, -1], [20 mm, 1, 1], [20 mm, -1, 1]]}}"),
                  ("position: [0, 50 mm, 0]", "position: [0, 150 mm, 0]"))
    t.expect_success("run", deck, "--out", "r")
    curve, end = table(t.folder / "r/fragments/plate.csv"), table(t.folder / "r/fragments/plate_end.csv")
    t.assertEqual((curve["fragments [-]"], curve["single_particles [-]"]), ([2] * 5, [0] * 5))
    t.assertEqual(end["particles [-]"], [14 * 12 * 4, 6 * 12 * 4])
    moved = 20e-6  # of 20 us at 1 m/s
    for name, wanted in (("centre_x [m]", [-0.015 + moved, 0.035 + moved]), ("centre_z [m]", [3 * moved] * 2), ("extent_x [m]", [0.07, 0.03]), ("extent_y [m]", [0.06] * 2),
                         ("velocity_x [m/s]", [1, 1]), ("velocity_z [m/s]", [3, 3])):
        for got, want in zip(end[name], wanted, strict=True):
            t.assertAlmostEqual(got, want, delta=1e-9)  # no forces but those of rounding


main()
