"""Formulas for ships in level ice: the published numbers, limits that can be done by hand, and the page that prints them."""

import re
import subprocess
import sys
from dataclasses import replace
from math import cos, pi, radians, sin, tan
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
sys.path[:0] = [str(ROOT / "tests/cli"), str(ROOT / "cases/ship_ice")]
from claims import claim, main  # noqa: E402
from resistance import GRAVITY, ShipInIce, cusps, held_speed, iso_19906, lindqvist, riska  # noqa: E402

SHIP = ShipInIce()  # the seed paper's


def kilo(value):
    return round(1e-3 * value)


@claim("resistance: Lindqvist gives the table of the seed paper's ship to its last digit")
def table(scene):
    # crushing, bending, submersion, total [kN], computed for the design of this program with another script
    expected = {
        (0.3e6, 0.05): (320, 230, 657, 1719), (0.3e6, 0.10): (376, 261, 918, 2208), (0.3e6, 0.15): (436, 293, 1179, 2702),
        (0.5e6, 0.05): (533, 383, 657, 2264), (0.5e6, 0.10): (627, 435, 918, 2840), (0.5e6, 0.15): (727, 488, 1179, 3425),
        (0.7e6, 0.05): (746, 536, 657, 2809), (0.7e6, 0.10): (877, 609, 918, 3472), (0.7e6, 0.15): (1018, 683, 1179, 4148),
    }  # fmt: skip
    for (strength, friction), numbers in expected.items():
        parts = lindqvist(replace(SHIP, strength=strength, friction=friction))
        found = tuple(kilo(parts[name]) for name in ("crushing", "bending", "submersion", "total"))
        scene.assertEqual(found, numbers, f"{strength} {friction}")


@claim("resistance: Lindqvist without friction and speed is what can be done by hand")
def by_hand(scene):
    still = replace(SHIP, friction=0, speed=0)
    parts = lindqvist(still)
    # half a wedge of strength times H², pushed up the stem
    scene.assertAlmostEqual(parts["crushing"], 0.5 * 0.5e6 * 4 * tan(radians(24)), delta=1e-6)
    # what lies under bottom and sides is lifted against its buoyancy, 125 kg/m3 of it
    scene.assertAlmostEqual(parts["submersion"], 125 * GRAVITY * 2 * 23 * 9 * (23 + 9) / (23 + 2 * 9), delta=1e-6)
    scene.assertEqual(parts["submersion"], parts["of it, potential energy"])
    scene.assertAlmostEqual(parts["total"], parts["crushing"] + parts["bending"] + parts["submersion"], delta=1e-6)
    # bending goes with H^1.5, crushing with H², submersion with H
    thick = lindqvist(replace(still, thickness=4))
    for name, power in (("bending", 1.5), ("crushing", 2), ("submersion", 1)):
        scene.assertAlmostEqual(thick[name] / parts[name], 2**power, delta=1e-12)


@claim("resistance: Riska gives 2205, 405 and 2831 kN for the seed paper's ship")
def riska_numbers(scene):
    parts = riska(SHIP)
    scene.assertEqual((kilo(parts["C1"]), kilo(parts["C2 V"] / SHIP.speed), kilo(parts["total"])), (2205, 405, 2831))
    scene.assertEqual(kilo(riska(replace(SHIP, parallel=80, bow=30))["total"]), 2601)


@claim("resistance: ISO 19906 gives 0.571 and 1562 kN for breaking, and its other parts what they are in simple cases")
def iso(scene):
    parts = iso_19906(SHIP)
    scene.assertEqual((round(parts["xi"], 3), kilo(parts["breaking"])), (0.571, 1562))
    # no friction: xi is the tangent of the slope; a sheet that turns on it weighs 1.5 w h² ρ g over the tangent
    smooth = iso_19906(replace(SHIP, friction=0, ice_friction=0))
    scene.assertAlmostEqual(smooth["xi"], tan(radians(24)), delta=1e-12)
    scene.assertAlmostEqual(smooth["turning"], 1.5 * 23 * 4 * 900 * GRAVITY / tan(radians(24)), delta=1e-6)
    # without rubble nothing is pushed or lifted
    scene.assertEqual((parts["pushing through rubble"], parts["riding up"], parts["lifting rubble"]), (0, 0, 0))
    # rubble that stands as steep as the slope: no triangle of it before the hull, only the sheet that rides up
    steep = iso_19906(replace(SHIP, ride_up=5, repose=24))
    scene.assertAlmostEqual(steep["pushing through rubble"], 0, delta=1e-6)
    scene.assertAlmostEqual(steep["lifting rubble"], 0, delta=1e-6)
    sheet = 23 * 5 * 2 * 900 * GRAVITY * (sin(radians(24)) + 0.1 * cos(radians(24))) / sin(radians(24))
    scene.assertAlmostEqual(steep["riding up"], sheet / (cos(radians(24)) - 0.1 * sin(radians(24))), delta=1e-6)
    # for each metre of a wide slope the breaking force is that of a strip broken at its edge (Hetenyi), 0.68 standing for a rounded 0.669
    strip = 0.5e6 * 4 / 6 / 26.7 / (0.5 * 2**0.5 * 2.718281828459045 ** (-pi / 4))
    wide = iso_19906(replace(SHIP, beam=1e6))
    scene.assertAlmostEqual(wide["breaking"] / wide["xi"] / 1e6 / strip, 1, delta=0.02)  # and the plate's 1 − ν², left out by ISO: 1.6 %


@claim("resistance: cusps are 6.0 m long at rest and 4.7 m at 3 knots")
def lengths(scene):
    found = cusps(SHIP)
    scene.assertEqual((round(found["length at rest"], 1), round(found["length"], 1), round(found["period"], 1)), (6.0, 4.7, 3.0))


@claim("resistance: the page's table is what the script gives")
def page(scene):
    rows = re.findall(r"^\| ([\d.]+) \| ([\d.]+) \| (\d+) \| (\d+) \| (\d+) \| (\d+) \|$", (ROOT / "docs/theory/resistance.md").read_text(), re.M)
    scene.assertEqual(len(rows), 12)
    for strength, friction, *numbers in rows:
        parts = lindqvist(replace(SHIP, strength=1e6 * float(strength), friction=float(friction)))
        scene.assertEqual([kilo(parts[name]) for name in ("crushing", "bending", "submersion", "total")], [int(number) for number in numbers])


@claim("resistance: at the speed that a driven ship holds its resistance is its net thrust, and one that is too weak holds none")
def driven(scene):
    ship = replace(SHIP, thickness=1, bollard_pull=1.5e6, open_water_speed=8)
    for formula in lindqvist, riska:
        speed = held_speed(ship, formula)
        # T_B [1 - V/(3 V_ow) - 2/3 (V/V_ow)²]
        thrust = 1.5e6 * (1 - speed / 24 - 2 * speed * speed / 192)
        scene.assertGreater(speed, 0.1)
        scene.assertAlmostEqual(formula(replace(ship, speed=speed))["total"] / thrust, 1, delta=1e-5)  # of a bisection to 1e-6 m/s
        scene.assertEqual(held_speed(replace(ship, bollard_pull=1e3), formula), 0)


@claim("resistance: a bollard pull without a speed in open water is refused")
def refused(scene):
    said = subprocess.run([sys.executable, ROOT / "cases/ship_ice/resistance.py", "--bollard-pull", "1e6"], capture_output=True, text=True, check=False)
    scene.assertEqual(said.returncode, 2)
    scene.assertIn("--bollard-pull needs --open-water-speed", said.stderr)


main()
