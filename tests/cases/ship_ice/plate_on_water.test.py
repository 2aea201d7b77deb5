"""The plate on water that the runs of the icebreaker are compared with, beside closed forms."""

import sys
from dataclasses import replace
from math import pi, sqrt
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
sys.path[:0] = [str(ROOT / "tests/cli"), str(ROOT / "cases/ship_ice")]
from claims import claim, main  # noqa: E402
from plate_on_water import Plate, breaking  # noqa: E402
from resistance import GRAVITY, ShipInIce  # noqa: E402

ICE = ShipInIce(strength=768e3)
FOUNDATION = ICE.water * GRAVITY


@claim("plate on water: under a line load on its edge it is Hetenyi's beam, in deflection, in stress and in the distance of the largest stress")
def strip(t):
    ice = replace(ICE, poisson=0.0)  # so that the sides do not bend
    plate = Plate(ice, is_split=False)
    width, pressure = float(plate.x[1]), 1e5
    deflection, force = plate.solve(lambda x, y: pressure * (x < width) * (y < 1e9))
    load = force / float(plate.y[-1])
    t.assertAlmostEqual(load / (pressure * width), 1, delta=1e-9)
    wavenumber = 1 / (sqrt(2) * ice.characteristic_length)
    # the load acts at the distance c = width/2 on average: as at the edge, with a moment P c there, so that w changes by -λ c and the stress by -2 λ c
    away = wavenumber * width / 2
    t.assertAlmostEqual(deflection[0] / (2 * load * wavenumber / FOUNDATION * (1 - away)), 1, delta=0.001)
    _, (stress, distance) = plate.largest(deflection)
    t.assertAlmostEqual(stress / (0.3224 * load / wavenumber * 6 / ice.thickness**2 * (1 - 2 * away)), 1, delta=0.003)
    t.assertAlmostEqual(distance * wavenumber / (pi / 4), 1, delta=0.03)  # points of quadrature


@claim("plate on water: a load on the edge of a whole sheet sinks it by Westergaard's deflection, and one on a corner by that of Ioannides")
def edge_and_corner(t):
    whole, split = Plate(ICE, is_split=False), Plate(ICE, is_split=True)
    patch = lambda x, y: 1e6 * (x * x + y * y < 0.3**2)  # noqa: E731
    deflections = {}
    for name, plate in (("edge", whole), ("corner", split)):
        deflection, force = plate.solve(patch)
        t.assertAlmostEqual(force / (1e6 * pi * 0.3**2 / 4), 1, delta=0.01)
        deflections[name] = deflection[0] / (2 * force)
    # H. M. Westergaard, Public Roads 7 (1926) 25: (1 + 0.4 ν)/√6 P/(k l²), itself an approximation
    expected = (1 + 0.4 * ICE.poisson) / sqrt(6) / (FOUNDATION * ICE.characteristic_length**2)
    t.assertAlmostEqual(deflections["edge"] / expected, 1, delta=0.03)
    # Each of two corners under half of P: A. M. Ioannides, M. R. Thompson, E. J. Barenberg (Transp. Res. Rec. 1043 (1985) 1), (1.205 - 0.69 c/l) P/(k l²) with
    # the side c of the load, fitted to finite elements at ν = 0.15. Westergaard has 1.1 for a load that tends to a point.
    side = 0.3 * sqrt(pi) / 2
    expected = 0.5 * (1.205 - 0.69 * side / ICE.characteristic_length) / (FOUNDATION * ICE.characteristic_length**2)
    t.assertAlmostEqual(deflections["corner"] / expected, 1, delta=0.05)


@claim("plate on water: the forces at which it cracks do not depend on its elements, and the split sheet breaks first")
def elements(t):
    fine, coarse = (Plate(ICE, True, finest, growth) for finest, growth in ((0.15, 1.06), (0.3, 1.12)))
    (force, distance), (roughly, near) = (breaking(plate, ICE.waterline, 2.3e6, 1) for plate in (fine, coarse))
    t.assertAlmostEqual(roughly / force, 1, delta=0.01)
    t.assertAlmostEqual(near / distance, 1, delta=0.1)  # points of quadrature of elements a metre long
    whole, _ = breaking(Plate(ICE, False, 0.3, 1.12), ICE.waterline, 2.3e6, 1)
    t.assertGreater(whole, 1.5 * force)


if __name__ == "__main__":
    main()
