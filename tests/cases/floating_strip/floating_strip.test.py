"""A floating strip against elementary theory (docs/theory/floating_strip.md). Python: Debian's, with numpy."""

import json
import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
CASE = ROOT / "cases/floating_strip"
sys.path[:0] = [str(ROOT / "tests/cli"), str(CASE)]
from claims import claim, main  # noqa: E402

try:
    import numpy as np
    from measure import Run, bent, compared
    from section import curve
    from theory import LARGEST_MOMENT, Elements, Strip
    from variants import Variant
except ImportError:
    np = None


def needs_numpy():
    if np is None:
        raise unittest.SkipTest("numpy is not installed")


def relaxed(scene, variant, loads, **keys):
    folder = scene.folder / variant.name().replace(" ", "_")
    folder.mkdir()
    (folder / "deck.yaml").write_text(json.dumps(variant.relaxed(loads, **keys)))
    scene.expect_success("run", folder / "deck.yaml", "--out", folder / "out", "--threads", "1")
    return Run(folder / "out")


@claim("floating_strip: theory has its textbook numbers, and elements agree with it")
def theory(scene):
    needs_numpy()
    sheet = Strip()
    scene.assertAlmostEqual(LARGEST_MOMENT, 0.3224, delta=5e-5)
    # 2 m of 1.8 GPa: 1/λ = 26.7 m, breaks at 38.7 kN/m, 20.98 m from its edge, which is then 0.288 m down
    scene.assertAlmostEqual(1 / sheet.rate, 26.71, delta=0.005)
    scene.assertAlmostEqual(sheet.breaking_load, 38.7e3, delta=50)
    scene.assertAlmostEqual(sheet.breaking_distance, 20.98, delta=0.005)
    scene.assertAlmostEqual(sheet.edge_deflection(sheet.breaking_load), 0.288, delta=5e-4)
    elements = Elements(sheet)
    w, moment = elements.solve(1e4)
    # cubic elements of 1.3 m, a twentieth of 1/λ: errors of w as (λ h)⁴/720; the clamp is 8/λ away, where e⁻⁸ = 3e-4 is left of it
    scene.assertLess(np.abs(w - sheet.deflection(1e4, elements.x)).max() / w[0], 4e-4)
    # moments as the square of that size
    scene.assertLess(np.abs(np.abs(moment) - np.abs(sheet.moment(1e4, elements.x))).max() * sheet.rate / 1e4 / LARGEST_MOMENT, 3e-3)
    # a load at a does at the edge what one at the edge does at a (Maxwell and Betti)
    scene.assertAlmostEqual(elements.solve(1e4, at=3.7)[0][0], float(np.interp(3.7, elements.x, w)), delta=2e-4 * w[0])
    # no water on the ice: nothing changes; under water its edge is held less, and the strip breaks sooner
    scene.assertTrue((elements.solve(1e4, flooded=True)[0] == w).all())
    scene.assertLess(elements.breaking_load(flooded=True), elements.breaking_load())


@claim("floating_strip: the moment of a section is proportional to its curvature until the bond nearest to the direction of bending is at its limit, and smaller afterwards")
def section(scene):
    needs_numpy()
    # the largest share of the strain that a bond of 2.5 spacings in the plane has: along an axis, or (2, 1) at 26.6°
    for degrees, nearest in ((0, 0), (10, 10), (22.5, 26.565 - 22.5), (45, 0)):
        curvature, moment, damage = curve(3, 2.015, degrees).T
        first = 1 / np.cos(np.radians(nearest)) ** 2  # over κ₀
        whole = curvature < first + 1e-9
        scene.assertTrue((damage[whole] == 0).all() and damage[np.argmin(whole)] > 0, degrees)  # curvatures are 0.01 apart
        scene.assertLess(np.abs(moment[whole] - curvature[whole]).max(), 1e-9)
        scene.assertLess((moment / curvature)[~whole].max(), 1)  # no bond that breaks makes it stiffer
        scene.assertTrue((np.diff(damage) >= 0).all())


@claim("floating_strip: four calibrated layers bend as the sheet does")
def bends(scene):
    needs_numpy()
    # half as long as in the page, to be quick: the theory is one of that length
    found = compared(relaxed(scene, Variant(4, calibration="z", length=107.0), [-1e4], breaks=False))
    # The calibration is made with imposed displacements of a sheet without sides; here sides are held and 4 particles apart: 3.4 % (page).
    scene.assertAlmostEqual(found["bending stiffness"], 1, delta=0.05)
    # w and M go with the fourth root of the stiffness
    scene.assertAlmostEqual(found["edge deflection"], 1, delta=0.015)
    scene.assertAlmostEqual(found["largest moment"], 1, delta=0.015)
    scene.assertAlmostEqual(found["first bond"], 1, delta=0.1)


@claim("floating_strip: six layers are asked for because three are a third too soft")
def too_few(scene):
    needs_numpy()
    found = compared(relaxed(scene, Variant(3, length=80.0), [-1e4], breaks=False))
    scene.assertAlmostEqual(found["bending stiffness"], 0.636, delta=0.02)  # the page's number, of a strip of 8/λ


@claim("floating_strip: it holds a load 2 % below the one at which its bonds are too long, and comes apart 2 % above it")
def breaks(scene):
    needs_numpy()
    variant = Variant(3, calibration="z", length=80.0)
    whole = relaxed(scene, variant, [-1e4], breaks=False)
    load = -1e4 * (1 - 1 / 3) * whole.strip.strength / whole.strip.modulus / bent(whole)["stretch"]
    iterations = whole.history()["total.iterations [-]"][-1]
    for factor, code in ((0.98, 0), (1.02, 3)):
        deck = variant.relaxed([factor * load])
        # a fragment that has come off is turned over by the load and finds no rest: the search is ended after three times what it takes
        deck["time"]["relax"]["max_iterations"] = int(3 * iterations)
        (scene.folder / "deck.yaml").write_text(json.dumps(deck))
        done = scene.run_program("run", "deck.yaml", "--out", f"out {factor}", "--threads", "1")
        scene.assertEqual(done.code, code, done)
        if code == 0:
            scene.assertEqual(scene.history(f"out {factor}")["ice.broken_bonds [-]"][-1], 0)


@claim("floating_strip: the deck floats where Archimedes has it, with the load of its table")
def deck(scene):
    # with water's damping, which a deck may give
    scene.expect_success("run", CASE / "deck.yaml", "--out", "out", "--force", "--set", "time.end=0.02 s", "--set", "output.frames=0", "--set", "output.history_interval=0.01 s",
                         "--set", "bodies.ice.boundary_conditions.sea.floating.damping=1 1/s", "--threads", "1")  # fmt: skip
    report, history = scene.report("out"), scene.history("out")
    sea = report["bodies"]["ice"]["boundary_conditions"]["sea"]
    scene.assertAlmostEqual(sea["floats_at [m]"], -1 + 2 * 900 / 1025, delta=1e-9)  # found by halving, to rounding
    # 40 kN/m over 4/3 m, at half the rate for the first 1.33 s: 0.02267 of it then; the mean over the row is that of its middle
    last, before = history["time [s]"][-1], history["time [s]"][-2]
    wanted = -40e3 * 4 / 3 * 0.02267 * 0.5 * (last + before) / 1.33
    scene.assertAlmostEqual(history["ice.load.force_z [N]"][-1] / wanted, 1, delta=0.02)  # a step in a row of sixty


main()
