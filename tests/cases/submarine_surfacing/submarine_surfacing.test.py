"""The submarine under ice: its shape, its rise without ice, and the first second of its deck with coarser ice."""

import math
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "tests/cli"))
from claims import claim, main, variants  # noqa: E402

CASE = ROOT / "cases/submarine_surfacing"
DECK = CASE / "deck.yaml"
# half the resolution: two layers, which cannot be calibrated, so that few seconds of computing suffice; the step needs no worry
COARSE = ["bodies.ice.spacing=0.6", "bodies.ice.bending_calibration=none", "time.step=0.2 ms", "time.end=0.6 s", "output.frames=0"]
for side in ("port", "starboard"):
    COARSE.append(f"bodies.ice.particle_sets.{side}.shape.box.size=[63, 0.9, 1.2]")  # two rows of particles are 1.2 m

OPEN_WATER = """\
title: The submarine without ice
time: {{end: 14 s, step: 2 ms}}
bodies:
  nothing:                                      # far above
    shape: {{box: {{size: [0.4 m, 0.4 m, 0.4 m]}}}}
    position: [0, 0, 50 m]
    spacing: 0.1 m
    material: {{model: ordinary-state, youngs_modulus: 1 MPa, density: 900 kg/m3}}
impactors:
  submarine:
    surface: {{file: "{file}"}}
    mass: 2000 t
    position: [0, 0, -8.25]
    free_dofs: [z]
    floating: {{level: 0, added_mass: 0.8, damping: 1.2}}
output: {{folder: results, frames: 0}}
"""


def coarse(*more):
    return [word for setting in (*COARSE, *more) for word in ("--set", setting)]


@claim("submarine_surfacing: the surface is what make_submarine.py writes, closed, and as large as its formulas")
def shape(scene):
    written = subprocess.run([sys.executable, CASE / "make_submarine.py"], capture_output=True, text=True, check=True).stdout
    scene.assertEqual(written, (CASE / "submarine.obj").read_text())
    (scene.folder / "open_water.yaml").write_text(OPEN_WATER.format(file=CASE / "submarine.obj"))
    scene.expect_success("run", "open_water.yaml", "--out", "out", "--force", "--set", "time.end=4 ms")
    surface = scene.report("out")["impactors"]["submarine"]["surface"]
    scene.assertEqual((surface["closure"], surface["components"], surface["rewound"], surface["flipped"]), ("closed", 1, 0, 0))
    # half an ellipsoid, a cylinder and a paraboloid (r = R (1 - ξ²), 8/15 of its cylinder)
    radius, nose, tail = 4, 8, 20
    hull = math.pi * radius**2 * (2 / 3 * nose + (60 - nose - tail) + 8 / 15 * tail)
    # waterlines of the sail are ellipses, π/4 B L; sections of its top half of one, π/4 of a rectangle
    breadth, length, height, top = 2, 10, 3, 0.6
    sail = math.pi / 4 * breadth * length * (height - top + math.pi / 4 * top)
    # panels of 0.8 m on a radius of 4 m lie 0.02 m inside: 1 % of the hull
    scene.assertTrue(0.99 < surface["volume [m3]"] / (hull + sail) < 1, surface["volume [m3]"])


@claim("submarine_surfacing: without ice it comes to rest at its draft, and displaces its mass")
def open_water(scene):
    (scene.folder / "open_water.yaml").write_text(OPEN_WATER.format(file=CASE / "submarine.obj"))
    scene.expect_success("run", "open_water.yaml", "--out", "out", "--force")
    floating, columns = scene.report("out")["impactors"]["submarine"]["floating"], scene.history("out")
    # what is left of 6 m decays with half the damping, e^-0.6 a second over the 9 s since it came out of the water: 0.5 %
    scene.assertAlmostEqual(floating["draft [m]"], floating["draft_at_rest [m]"], delta=0.03)
    scene.assertAlmostEqual(floating["displaced [kg]"] / 2000e3, 1, delta=0.01)
    # deep, lift and damping come to a balance: (ρ V - m) g = c (m + a) v, within e^-1.2 a second of the 3.5 s that it is under water
    lift = (floating["displaced_at_start [kg]"] - 2000e3) * 9.81
    scene.assertAlmostEqual(max(columns["submarine.velocity_z [m/s]"]) / (lift / (1.2 * 1.8 * 2000e3)), 1, delta=0.1)


@claim("submarine_surfacing: perimpact check warns of nothing in any run of variants.sh")
def steps(scene):
    runs = variants(CASE)
    scene.assertEqual([name for _, name, _ in runs], ["given", "crushed", "free"])
    for deck, name, settings in runs:
        scene.expect_no_warning("check", deck, "--out", name, *(word for setting in settings for word in ("--set", setting)))


@claim("submarine_surfacing: at a given speed the sail breaks the sheet before the hull is in contact, and gauges add up")
def given(scene):
    done = scene.run_program("run", DECK, "--out", "out", "--force", *coarse())
    scene.assertEqual(done.code, 0, done.err)
    columns, report = scene.history("out"), scene.report("out")
    scene.assertTrue(all(speed == 2 for speed in columns["submarine.velocity_z [m/s]"]))
    sail, whole = columns["submarine.sail.force_z [N]"], columns["submarine.force_z [N]"]
    for part, total in zip(sail, whole):
        scene.assertAlmostEqual(part, total, delta=1e-9 * abs(min(whole)))  # the same impulses, in another order
    scene.assertTrue(all(force == 0 for force in columns["submarine.hull.force_z [N]"]))
    broken = columns["ice.broken_bonds [-]"]
    scene.assertEqual(broken[next(k for k, force in enumerate(whole) if force != 0) - 1], 0)
    scene.assertGreater(broken[-1], 1000)
    # the top of the sail is 0.95 m above the bottom of the ice by then, 1.2 m thick: the ice above it yields, so the force has fallen from its peak, to 0.63 of it
    mean = [sum(whole[k : k + 5]) / 5 for k in range(len(whole) - 4)]
    scene.assertLess(min(mean), -1e6)
    scene.assertGreater(mean[-1], 0.8 * min(mean))
    scene.assertEqual(report["impactors"]["submarine"]["detection"]["ice"]["entered_inside"], 0)


@claim("submarine_surfacing: ice that pressure hardens takes more force from the sail")
def hardening(scene):
    least = []
    for hardening in (0, 0.15):
        folder = f"hardening_{hardening}"
        settings = coarse("time.end=0.25 s", f"bodies.ice.failure.compression_hardening={hardening}")
        scene.expect_success("run", DECK, "--out", folder, *settings)
        push = scene.history(folder)["submarine.sail.force_z [N]"]
        least.append(min(sum(push[k : k + 5]) / 5 for k in range(len(push) - 4)))
    # pressed along one axis it stands 1/(ν - α), which is 10, in place of 1/ν, which is 4; under the sail it is pressed and bent at once
    scene.assertLess(least[1], 1.5 * least[0])


@claim("submarine_surfacing: free to heave, it gains the momentum that water and ice give it")
def free(scene):
    done = scene.run_program("run", DECK, "--out", "out", "--force", *coarse("impactors.submarine.free_dofs=[z]", "impactors.submarine.velocity=[0, 0, 1]", "time.end=0.5 s"))
    scene.assertEqual(done.code, 0, done.err)
    columns, floating = scene.history("out"), scene.report("out")["impactors"]["submarine"]["floating"]
    times, heavy = columns["time [s]"], floating["mass [kg]"] + floating["added_mass [kg]"]
    scene.assertAlmostEqual(floating["added_mass [kg]"], 0.8 * 2000e3, delta=1e-3)
    momentum = heavy * 1.0
    for k in range(1, len(times)):
        momentum += (columns["submarine.water_force_z [N]"][k] + columns["submarine.force_z [N]"][k]) * (times[k] - times[k - 1])
        scene.assertAlmostEqual(heavy * columns["submarine.velocity_z [m/s]"][k] / momentum, 1, delta=1e-9)  # sums of thousands of impulses
    scene.assertLess(min(columns["submarine.velocity_z [m/s]"]), 1)  # the ice slowed it down


main()
