"""The stiffened panel of cases/hull_panel: its finite elements, its modes, and its coupling with ice. Python: Debian's, with dolfinx and scipy, and the package of the build."""

import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
sys.path[:0] = [str(Path(sys.argv[1]).resolve().parent / "python"), str(ROOT / "tests/cli"), str(ROOT / "cases/hull_panel")]
from claims import claim, main  # noqa: E402

COARSE = 4  # elements between two frames


def needs(*modules):
    """All are packages of scripts/install_dependencies.sh test; .ci/run fails without them."""
    import importlib.util

    for name in modules:
        if importlib.util.find_spec(name) is None:
            raise unittest.SkipTest(f"{name} is not installed")


@claim("hull_panel: the shell elements converge to thin-plate theory in deflection and frequency, and to beam theory for a frame")
def theory(test):
    needs("dolfinx", "scipy")
    from verify import check_frame, check_plate

    deflection, frequencies = check_plate(16)
    # 20 mm over 1 m: shear adds 0.7 % of deflection, and takes 0.4 to 1.2 % of the frequencies
    test.assertLess(abs(deflection - 1), 0.01)
    test.assertLess(max(abs(frequencies - 1)), 0.015)
    coarse, fine = check_frame(2), check_frame(4)
    test.assertLess(abs(fine - 1), 0.006)
    test.assertLess(abs(fine - 1), 0.6 * abs(coarse - 1))


@claim("hull_panel: the matrices conserve mass, and rigid motion strains no element")
def rigid_motion(test):
    needs("dolfinx", "scipy")
    import numpy as np
    from panel import BAYS, BREADTH, DENSITY, FLANGE, HEIGHT, LENGTH, PLATING, SPACING, WEB, Model

    model = Model(COARSE)
    sections = BAYS * SPACING * PLATING + (BAYS - 1) * (HEIGHT * WEB + BREADTH * FLANGE)
    np.testing.assert_allclose(model.shell.masses.sum(), DENSITY * LENGTH * sections, rtol=1e-12)
    scale = abs(model.stiffness).max()
    for axis in np.eye(3):
        translation = np.hstack([np.tile(axis, (len(model.points), 1)), np.zeros_like(model.points)])
        rotation = np.hstack([np.cross(axis, model.points), np.tile(axis, (len(model.points), 1))])
        for motion in (translation, rotation):
            np.testing.assert_allclose(model.stiffness @ motion.ravel() / scale, 0, atol=1e-13)  # rounding of sums over nine nodes


@claim("hull_panel: 240 modes deflect as the finite elements do under a moving load, within 3 %, which conserve momentum and energy")
def moving_load(test):
    needs("dolfinx", "scipy")
    from panel import Model
    from verify import deviation, move_load, superpose_moving_load

    model = Model(COARSE)
    found = move_load(model, end=25e-3)
    deflection, _ = superpose_moving_load(model, model.modes(240), found["times"])
    test.assertLess(deviation(found["deflection"], deflection), 0.03)
    # the same with too few modes: the comparison can fail
    few, _ = superpose_moving_load(model, model.modes(40), found["times"])
    test.assertGreater(deviation(found["deflection"], few), 0.03)
    test.assertLess(found["impulse"], 1e-11)  # rounding, over ten thousand steps
    test.assertLess(found["energy"], 1e-6)  # central differences conserve it; the load's work is a sum over steps


def hit(test, panel, end):
    """A coarse sphere on the coarse panel: what impacts.py records."""
    import impacts
    from panel import Model

    bodies, _ = impacts.ice_sphere(spacing=0.1)
    impacts.ICE["coarse"] = lambda: (bodies, end)
    return impacts.run("coarse", panel, Model(COARSE), test.folder)


@claim("hull_panel: ice and finite elements, coupled in each step, keep momentum to 1e-10 with the reactions of the clamped edges, and energy to 1e-6")
def coupled(test):
    needs("dolfinx", "scipy")
    found = hit(test, "finite", 12e-3)
    test.assertLess(found["residual"].max() / found["start"], 1e-10)
    # second order in the step; paired with the velocity of one step alone the work of contact is wrong by a few per cent
    test.assertLess(abs(found["balance_error"]).max() / found["energy"][0], 1e-6)
    test.assertGreater(found["deflection"].max(), 5e-4)


@claim("hull_panel: ice that hits the panel's modes causes the force and deflection of that which hits the finite elements, and less than a rigid panel does")
def three_panels(test):
    needs("dolfinx", "scipy")
    rigid, modal, finite = (hit(test, panel, 8e-3) for panel in ("rigid", "modal", "finite"))
    for quantity in ("force", "deflection"):
        of = {name: found[quantity].max() for name, found in (("rigid", rigid), ("modal", modal), ("finite", finite))}
        test.assertLess(abs(of["modal"] / of["finite"] - 1), 0.03, quantity)
        test.assertLess(of["finite"], 0.8 * of["rigid"], quantity)


@claim("hull_panel: a pulse passes from finite elements into particles of the same material without reflection, and with another impedance as theory has it, within 2 %")
def bars(test):
    needs("dolfinx", "scipy")
    import bar

    for ratio in (1.0, 0.5):
        found = bar.run(ratio)
        reflection, transmission, peak = bar.coefficients(found)
        test.assertLess(abs(reflection - (ratio - 1) / (ratio + 1)), 0.02)
        test.assertLess(abs(peak - abs(ratio - 1) / (ratio + 1)), 0.02)
        test.assertLess(abs(ratio * transmission - 2 * ratio / (1 + ratio)), 0.02)
        test.assertLess(found["momentum"], 1e-10)
        test.assertLess(found["energy"], 1e-3)


main()
