"""The paddle wheel: what its deck promises of gauges, driven motion, loads and two impactors."""

import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "tests/cli"))
from claims import claim, main  # noqa: E402

DECK = ROOT / "cases/ice_paddle/deck.yaml"


def mean_load(time):
    """Impulse of the feeder's load until `time` over its full force of 600 N: the factor rises to 1 within 5 ms [s]."""
    return time - 0.0025 if time > 0.005 else 0.5 * time * time / 0.005


@claim("ice_paddle: the wheel follows its table, the feeder its load, gauges add up, and nothing is left inside")
def paddle(scene):
    scene.expect_success("run", DECK, "--out", "out", "--force", "--set", "time.end=28 ms", "--set", "output.frames=0")
    columns, report = scene.history("out"), scene.report("out")
    rows = [dict(zip(columns, row)) for row in zip(*columns.values())]
    step = report["stability"]["step [s]"]

    struck = 0
    for row in rows:
        time = row["time [s]"]
        # the velocity is the mean over the last step, so it is the table's in the middle of it
        if time > 0:
            scene.assertAlmostEqual(row["paddle.angular_velocity_z [rad/s]"], -20 * min(1, (time - 0.5 * step) / 0.01), delta=1e-9 * 20)
        # one gauge feels the whole wheel about its centre; hub, blade 1 and blade 4 are all that can be struck
        largest = max(abs(row[f"paddle.force_{axis} [N]"]) for axis in "xyz")
        for axis in "xyz":
            whole = row[f"paddle.force_{axis} [N]"]
            scene.assertAlmostEqual(row[f"paddle.wheel.force_{axis} [N]"], whole, delta=1e-12 * largest)  # the same sums in the same order
            parts = sum(row[f"paddle.{gauge}.force_{axis} [N]"] for gauge in ("hub", "blade_1", "blade_4"))
            scene.assertAlmostEqual(parts, whole, delta=1e-12 * largest)  # the same sums in another order
        # the axis is z through the centre of mass, which lies 1e-16 m off the gauge's point
        scene.assertAlmostEqual(row["paddle.wheel.torque [N m]"], row["paddle.moment_z [N m]"], delta=1e-10 * largest)
        struck += largest > 0
        # until the blade strikes, the load is all that gives momentum to ice and feeder: to rounding of 5000 steps
        if struck == 0:
            scene.assertAlmostEqual(row["total.momentum_y [kg m/s]"], 600 * mean_load(time), delta=1e-9)
    scene.assertGreater(struck, 3)
    scene.assertGreater(rows[-1]["ice.broken_bonds [-]"], 1000)
    for impactor in ("paddle", "feeder"):
        detection = report["impactors"][impactor]["detection"]["ice"]
        scene.assertEqual((detection["entered_inside"], detection["unresolved_penetrations"]), (0, 0))
    scene.assertEqual(report["impactors"]["paddle"]["surface"]["solids"], 5)
    scene.assertGreater(report["impactors"]["paddle"]["surface"]["buried_triangles"], 0)


main()
