"""Claims about the icebreaker's decks. Python with numpy; the runs are on a coarse, short sheet."""

import math
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
CASE = ROOT / "cases/ship_ice"
sys.path[:0] = [str(ROOT / "tests/cli"), str(CASE), str(ROOT / "cases/uikku_ice"), str(ROOT / "validation")]
from claims import claim, main  # noqa: E402
from topics.ship import SHORT  # noqa: E402


def short(t, *settings, folder="r"):
    """The first 1.5 s of a sheet 20 m long, between fixed edges."""
    words = [word for setting in [*SHORT, *settings] for word in ("--set", setting)]
    t.expect_success("run", CASE / "deck.yaml", "--out", folder, "--force", *words)
    return t.history(folder)


@claim("ship: the step that the paper prints is refused, with how far it is from the longest stable one")
def _(t):
    said = t.run_program("check", CASE / "paper.yaml", "--set", "time.step=3.76 ms")
    t.expect_complaint(said, 2, "--set time.step: the time step of 0.00376 s is", "times the critical time step of these bodies", "unstable")
    times = float(said.err.split("the time step of 0.00376 s is ")[1].split()[0])
    # Of the infinite lattice it is 7.2 in the continuum's constants, by its dynamical matrix; the calibration of three layers makes bonds 1.32 times as stiff. Surface
    # factors of a sheet whose layers are all at its surface make the body's own stiffest mode higher still: found 9.57 by Lanczos' method.
    t.assertGreater(times, 7.2 * math.sqrt(1.32))
    t.assertAlmostEqual(times, 9.57, delta=0.1)


@claim("ship: the breadth that measure.py reports is that of the hull's panels, with a sharp stem and with one of a radius")
def _(t):
    from measure import bow_length, breadth_in_ice, breadth_of_waterline

    hull = {"breadth": 23.0, "fullness": 2.0, "waterline_angle": math.radians(22)}
    for radius in (0.0, 1.0, 4.0):
        hull["stem_radius"] = radius
        said = t.expect_success("shape", "hull", "--length", "155", "--breadth", "23", "--draft", "9", "--freeboard", "6", "--stem-angle", "90 deg", "--waterline-angle", "22 deg",
                                "--stem-radius", f"{radius} m", "--edge-length", "1", "--out", f"{radius}.obj")  # fmt: skip
        t.assertAlmostEqual(float(re.search(r"bow, stern +(\S+) and", said.out)[1]) / bow_length(hull), 1, delta=1e-4)  # as printed
        corners = [[float(word) for word in line.split()[1:4]] for line in (t.folder / f"{radius}.obj").read_text().splitlines() if line.startswith("v ")]
        rail = {}
        for x, y, z in corners:
            if z == 6 and x < 70:
                rail[x] = max(rail.get(x, 0), y)
        t.assertGreater(len(rail), 50)
        for x, y in rail.items():
            t.assertAlmostEqual(float(breadth_of_waterline(hull, x)), 2 * y, delta=1e-3)  # m; the tangent point is found to a fifth of a millimetre
        # the area of the polygon of the rail, inscribed in the waterline: chords of a metre
        places = sorted(x for x in rail if x < 40)
        area = sum((rail[a] + rail[b]) * (b - a) for a, b in zip(places, places[1:]))
        t.assertAlmostEqual(breadth_in_ice(hull, places[-1])[1] * places[-1] / area, 1, delta=0.002)


@claim("ship: no deck of the case gives a warning")
def _(t):
    for deck in ("deck.yaml", "paper.yaml", "window.yaml"):
        t.expect_no_warning("check", CASE / deck, "--out", "checked")


@claim("ship: the sheet that follows the ship has the water, the dry top and the damping at its edges that follow from its plate")
def _(t):
    from level_ice import RIM_DAMPING, deflection_at_breaking
    from resistance import GRAVITY, ShipInIce

    text = (CASE / "window.yaml").read_text(encoding="utf-8")
    number = lambda name: float(re.search(rf"{name}: ([\d.]+)", text)[1])  # noqa: E731
    plate = ShipInIce(thickness=2, strength=0.768e6)
    t.assertAlmostEqual(number("flexural_strength") / 720, 1, delta=1e-9)  # (1 − ν²) 768 kPa
    depth = 2 / math.pi * 0.32 * plate.characteristic_length
    t.assertAlmostEqual(number("entrained_depth"), depth, delta=0.005)
    freeboard = plate.thickness * (1 - plate.ice / plate.water)
    t.assertAlmostEqual(number("dry_top"), deflection_at_breaking(plate) - freeboard, delta=0.005)
    t.assertAlmostEqual(float(re.search(r"far_rim: {shape: {box: {size: \[([\d.]+)", text)[1]), plate.characteristic_length, delta=0.005)
    # the full breadth of the bow must be in the ice: its length is p (B/2)/tan α with the fullness p = 2 of a hull that gives none
    bow = 23 / math.tan(math.radians(22))
    t.assertGreater(number("start_after"), bow)
    length = float(re.search(r"size: \[([\d.]+)", text)[1])
    t.assertGreater(length - number("start_after"), 4 * plate.characteristic_length)
    # what moves weighs ρ h + ρ_w d and the damping acts on the ice, ρ h, alone
    ratio = 1 + plate.water * depth / (plate.ice * plate.thickness)
    heave = math.sqrt(plate.water * GRAVITY / (plate.ice * plate.thickness * ratio))
    damping, fastest = RIM_DAMPING * heave * ratio, math.sqrt(1.2 * plate.young / plate.ice)
    t.assertAlmostEqual(number("reflection"), math.exp(-damping * plate.characteristic_length / (3 * fastest)), delta=0.0005)


@claim("ship: without friction F_z on the bow is cot 24 deg times F_x, and the ice breaks")
def _(t):
    rows = short(t)
    back, up = (sum(rows[f"ship.bow.force_{axis} [N]"]) for axis in "xz")
    t.assertGreater(back, 0)
    # every panel of the bow has this ratio to rounding; 2 % is what the case promises, ten digits are what it keeps
    t.assertAlmostEqual(up / back, 1 / math.tan(math.radians(24)), delta=1e-6)
    t.assertGreater(rows["sheet.broken_bonds [-]"][-1], 100)
    t.assertGreater(max(rows["ship.bow.force_x [N]"]), 1e5)


@claim("ship: with friction F_x on the bow is larger for the same F_z")
def _(t):
    rows = short(t, "contact.impactors.friction=0.1")
    back, up = (sum(rows[f"ship.bow.force_{axis} [N]"]) for axis in "xz")
    t.assertLess(up / back, 0.95 / math.tan(math.radians(24)))
    # sliding straight down a buttock turns the force by atan(µ |N|/N_xz), |N|/N_xz = √(1 + (sin φ/tan α)²); panels of 3 m at the stem stand at 18 deg or more
    steepest = 0.1 * math.sqrt(1 + (math.sin(math.radians(24)) / math.tan(math.radians(18))) ** 2)
    tangent = math.tan(math.radians(24))
    t.assertGreater(up / back, (1 - steepest * tangent) / (tangent + steepest))


@claim("ship: the energy balance of the first impact closes within 2 % of the ship's work")
def _(t):
    rows = short(t)
    work = -rows["ship.contact_work [J]"][-1]
    t.assertGreater(work, 1e4)
    t.assertLess(max(abs(error) for error in rows["total.energy_balance_error [J]"]), 0.02 * work)


@claim("ship: the contributions to the resistance add up to the work of the ship")
def _(t):
    import numpy as np
    from contributions import contributions

    rows = short(t, "contact.impactors.friction=0.1")
    parts, ship, travel = contributions({name: np.array(column) for name, column in rows.items()}, 0.2, 1)
    t.assertAlmostEqual(travel, 0.8 * 1.5433, delta=0.04)  # a row
    t.assertGreater(ship, 100)
    t.assertAlmostEqual(sum(parts.values()), ship, delta=0.01 * ship)  # kinetic energy of rows is that of interpolated velocities
    t.assertGreater(parts["fracture"], 0.003 * ship)
    t.assertGreater(parts["crushing in contact with the hull"], 0.02 * ship)
    t.assertGreater(parts["friction and inelastic contact of the hull"], 0.02 * ship)


@claim("ship: a load that falls to half of the mean has ended, and one that only swings has not")
def _(t):
    import numpy as np
    from measure import times_of_loads

    time = np.arange(0, 30, 0.05)
    force = np.zeros_like(time)
    for begin in (2, 11, 20):  # every nine seconds, for four; each swings by a third, faster than a second and slower
        on = (time > begin) & (time < begin + 4)
        force[on] = 3 + np.sin(2 * math.pi * 5 * time[on]) + np.sin(2 * math.pi * time[on] / 2)
    found = times_of_loads(time, force)
    t.assertEqual(len(found), 3)
    # the mean over a second passes that of all (1.2 of 3) while the load is half in it: within half a second of its begin
    for begin, at in zip((2, 11, 20), found):
        t.assertAlmostEqual(at, begin, delta=0.5)
    t.assertEqual(len(times_of_loads(time, np.full_like(time, 3.0) + np.sin(time))), 1)


@claim("ship: a bow that is never in contact with the ice is reported in a sentence, and a sheet in one piece has no floes")
def _(t):
    import json

    import numpy as np
    from measure import history, travel_in_ice
    from results_folder import Missing
    from long_run import sizes_of_floes

    (t.folder / "fragments").mkdir()
    (t.folder / "history.csv").write_text("time [s],ship.position_x [m],ship.bow.force_x [N]\n0,0,0\n1,-2,0\n")
    (t.folder / "run.json").write_text(json.dumps({"setup": {"bodies": {"sheet": {"material": {"density": 900}, "shape": {"box": {"size": [60, 80, 2]}}}}}}))
    with t.assertRaisesRegex(Missing, r"history\.csv: the bow is never in contact with the ice; continue the run with --resume\.$"):
        travel_in_ice(history(t.folder))
    pieces = t.folder / "fragments/sheet_end.csv"
    pieces.write_text("fragment [-],particles [-],mass [kg]\n0,100,8640000\n")
    t.assertTrue(all(np.isnan(side) for side in sizes_of_floes(t.folder)))
    pieces.write_text("fragment [-],particles [-],mass [kg]\n0,100,8640000\n1,4,45000\n2,2,28800\n")
    t.assertEqual(sizes_of_floes(t.folder), (5, 5))


@claim("ship: through-cracks are counted along the track of the ship, not cracks of one face or beside it")
def _(t):
    import numpy as np
    from measure import through_cracks

    x, y, z = (axis.ravel() for axis in np.meshgrid(np.arange(-40, 0, 0.5), np.arange(-15, 15, 0.5) + 0.25, np.arange(4) * 0.5, indexing="ij"))
    places, damage = np.stack([x, y, z], axis=1), np.zeros(len(x))
    count = lambda: through_cracks(places, damage, 23.0)  # noqa: E731
    t.assertEqual(count(), 0)
    damage[np.abs(x + 10 + y**2 / 20) < 0.8] = 0.5  # an arc, 3 particles wide
    t.assertEqual(count(), 1)
    damage[np.abs(x + 25) < 0.3] = 0.4  # a straight one
    t.assertEqual(count(), 2)
    damage[x > -1] = 1  # the crushed edge
    t.assertEqual(count(), 3)
    damage[(np.abs(x + 33) < 0.3) & (z > 0)] = 0.9  # not through the lowest layer
    damage[(np.abs(x + 36) < 0.3) & (np.abs(y) > 5)] = 0.9  # beside the middle: 13 of the 23 m
    t.assertEqual(count(), 4)
    damage[(np.abs(x + 38) < 0.3) & (np.abs(y) > 7)] = 0.9  # 9 of the 23 m
    t.assertEqual(count(), 4)


if __name__ == "__main__":
    main()
