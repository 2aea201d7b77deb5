#!/usr/bin/python3
"""Empirical and semi-analytical formulas for a ship in level ice: Lindqvist 1989, Riska 1997, ISO 19906, cusps.

    cases/ship_ice/resistance.py                                      the ship of Zhang et al. in 2 m of ice at 3 knots
    cases/ship_ice/resistance.py --thickness 1 --speed 2.5 --friction 0.1

SI units; angles in degrees. Formulas, symbols, sources and ranges of validity: docs/theory/resistance.md.
"""

import argparse
import re
from dataclasses import dataclass, fields, replace
from math import atan, cos, inf, pi, radians, sin, sqrt, tan

GRAVITY = 9.81  # [m/s2]


@dataclass(frozen=True)
class ShipInIce:
    """Each field is an option of the command line; its comment is the help."""

    length: float = 155.0  # L of the ship at the waterline [m]
    beam: float = 23.0  # B [m]
    draft: float = 9.0  # T [m]
    stem: float = 24.0  # φ, between stem and waterline [deg]
    waterline: float = 22.0  # α, between waterline at the stem and centre line [deg]
    parallel: float = 70.0  # L_par, length of the parallel midbody [m]
    bow: float = 40.0  # L_bow, length of the bow [m]
    speed: float = 1.543  # V [m/s]
    thickness: float = 2.0  # H of the ice [m]
    strength: float = 0.5e6  # σ_b, flexural strength of the ice [Pa]
    young: float = 1.8e9  # E of the ice [Pa]
    poisson: float = 0.25  # ν of the ice
    ice: float = 900.0  # ρ_i [kg/m3]
    water: float = 1025.0  # ρ_w [kg/m3]
    friction: float = 0.1  # µ between ice and hull
    ride_up: float = 0.0  # h_r, ride-up height of ice on the slope, for ISO 19906 [m]
    ice_friction: float = 0.1  # µ_i of ice on ice, for ISO 19906
    porosity: float = 0.3  # e of rubble, for ISO 19906
    repose: float = 10.0  # θ, angle of the rubble's surface, for ISO 19906 [deg]
    cohesion: float = 0.0  # c of rubble, for ISO 19906 [Pa]
    inner_friction: float = 45.0  # φ_r of rubble, for ISO 19906 [deg]
    bollard_pull: float = 0.0  # T_B, thrust at zero speed of a ship that is driven by its net thrust [N]
    open_water_speed: float = 0.0  # V_ow at which the net thrust vanishes [m/s]; needed with --bollard-pull

    @property
    def characteristic_length(self):
        """l = [E H³/(12 (1 − ν²) ρ_w g)]^¼ [m]"""
        return (self.young * self.thickness**3 / (12 * (1 - self.poisson**2) * self.water * GRAVITY)) ** 0.25


def lindqvist_speed_factors(ship):
    """1 + 1.4 V/√(g H), of crushing and bending, and 1 + 9.4 V/√(g L), of submersion."""
    return 1 + 1.4 * ship.speed / sqrt(GRAVITY * ship.thickness), 1 + 9.4 * ship.speed / sqrt(GRAVITY * ship.length)


def lindqvist(ship):
    """R = (R_c + R_b)(1 + 1.4 V/√(g H)) + R_s (1 + 9.4 V/√(g L)) [N], with its parts."""
    phi, alpha, mu, H, B, T = radians(ship.stem), radians(ship.waterline), ship.friction, ship.thickness, ship.beam, ship.draft
    psi = atan(tan(phi) / sin(alpha))
    crushing = 0.5 * ship.strength * H**2 * (tan(phi) + mu * cos(phi) / cos(psi)) / (1 - mu * sin(phi) / cos(psi))
    stiffness = sqrt(ship.young / (12 * (1 - ship.poisson**2) * GRAVITY * ship.water))
    slide = tan(psi) + mu * cos(phi) / (sin(alpha) * cos(psi))
    bending = 27 / 64 * ship.strength * B * H**1.5 / stiffness * slide * (1 + 1 / cos(psi))
    under = 0.7 * ship.length - T / tan(phi) - B / (4 * tan(alpha))
    bow = T * cos(phi) * cos(psi) * sqrt(1 / sin(phi) ** 2 + 1 / tan(alpha) ** 2)
    buoyancy = (ship.water - ship.ice) * GRAVITY * H * B
    lifting, rubbing = buoyancy * T * (B + T) / (B + 2 * T), buoyancy * mu * (under + bow)
    fast, slow = lindqvist_speed_factors(ship)
    submersion = lifting + rubbing
    total = (crushing + bending) * fast + submersion * slow
    return {"crushing": crushing, "bending": bending, "submersion": submersion, "of it, potential energy": lifting, "total": total}


def riska(ship):
    """R = C1 + C2 V [N], with both parts; the formula uses kN, m and m/s."""
    H, B, T, L, bow = ship.thickness, ship.beam, ship.draft, ship.length, ship.bow
    standing = 0.23 * B * ship.parallel * H / (2 * T / B + 1)
    standing += (1 + 0.021 * ship.stem) * (4.58 * B * H**2 + 1.47 * bow * H**2 + 0.29 * B * bow * H)
    moving = (1 + 0.063 * ship.stem) * (18.9 * H**1.5 + 0.67 * B * H) + 1.55 * H * (1 + 1.2 * T / B) * B**2 / sqrt(L)
    return {"C1": 1e3 * standing, "C2 V": 1e3 * moving * ship.speed, "total": 1e3 * (standing + moving * ship.speed)}


def iso_19906(ship):
    """The horizontal force of a level sheet that breaks on a wide slope (Croasdale) [N], with its parts. The slope is the stem's."""
    alpha, theta, inner = radians(ship.stem), radians(ship.repose), radians(ship.inner_friction)
    mu, mu_i, H, w, h = ship.friction, ship.ice_friction, ship.ride_up, ship.beam, ship.thickness
    weight, rubble = ship.ice * GRAVITY, ship.ice * GRAVITY * (1 - ship.porosity)
    xi = (sin(alpha) + mu * cos(alpha)) / (cos(alpha) - mu * sin(alpha))
    crack = w + pi**2 / 4 * ship.characteristic_length
    breaking = 0.68 * xi * ship.strength * (ship.water * GRAVITY * h**5 / ship.young) ** 0.25 * crack
    slope = 1 - tan(theta) / tan(alpha)
    pushing = w * H**2 * mu_i * rubble * slope**2 / (2 * tan(theta))
    on_slope = 0.5 * mu_i * (mu_i + mu) * rubble * H**2 * sin(alpha) * (1 / tan(theta) - 1 / tan(alpha)) * slope
    on_slope += 0.5 * (mu_i + mu) * rubble * H**2 * cos(alpha) / tan(alpha) * slope
    on_slope += H * h * weight * (sin(alpha) + mu * cos(alpha)) / sin(alpha)
    riding = w * on_slope / (cos(alpha) - mu * sin(alpha))
    lifting = 0.5 * w * H * xi * slope * (H * rubble * (1 / tan(theta) - 1 / tan(alpha) + tan(inner) * slope) + 2 * ship.cohesion)
    turning = 1.5 * w * h**2 * weight * cos(alpha) / (sin(alpha) - mu * cos(alpha))
    total = (breaking + pushing + riding + lifting + turning) / (1 - breaking / (ship.strength * crack * h))
    parts = {"breaking": breaking, "pushing through rubble": pushing, "riding up": riding, "lifting rubble": lifting, "turning": turning}
    return {"xi": xi, **parts, "total": total}


def cusps(ship):
    """Length of a cusp R = C_l l (1 + C_v v_n) [m], C_l = 0.32, C_v = −0.144 s/m, at v_n = 0 and V, and the period of the load R/V [s]."""
    still = 0.32 * ship.characteristic_length
    moving = still * (1 - 0.144 * ship.speed)
    return {"length at rest": still, "length": moving, "period": moving / ship.speed if ship.speed else inf}


def bollard_pull(power, diameter, quality=0.78):
    """T_B = K_e (P D)^⅔ [N] of a ship with the power P [W] and propellers of the diameter D [m]; K_e 0.78 for one propeller, 0.98 for two, 1.12 for three."""
    return 1e3 * quality * (1e-3 * power * diameter) ** (2 / 3)


def net_thrust_factor(relative_speed):
    """Thrust less the resistance of open water, over the bollard pull; `relative_speed`: over the speed in open water."""
    return 1 - relative_speed / 3 - 2 * relative_speed**2 / 3


def net_thrust(ship):
    """[N] at its speed."""
    return ship.bollard_pull * net_thrust_factor(ship.speed / ship.open_water_speed)


def held_speed(ship, formula):
    """[m/s] at which the net thrust equals the total of a formula, by bisection; 0 where the resistance at rest is larger than the bollard pull."""
    slow, fast = 0.0, ship.open_water_speed
    while fast - slow > 1e-6:
        middle = replace(ship, speed=(slow + fast) / 2)
        slow, fast = (middle.speed, fast) if net_thrust(middle) > formula(middle)["total"] else (slow, middle.speed)
    return slow


def help_of_fields(file):
    """The comments of the fields of a dataclass in this source file, by their names."""
    with open(file, encoding="utf-8") as lines:
        return {line.split(":")[0].strip(): line.split("# ")[1].strip().replace("%", "%%") for line in lines if re.match(r"    \w+: (float|int) = .*# ", line)}


def options():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    descriptions = help_of_fields(__file__)
    for field in fields(ShipInIce):
        parser.add_argument("--" + field.name.replace("_", "-"), type=float, default=field.default, help=f"{descriptions[field.name]}; {field.default:g} where absent")
    ship = ShipInIce(**vars(parser.parse_args()))
    if ship.bollard_pull and not ship.open_water_speed > 0:
        parser.error("--bollard-pull needs --open-water-speed, the speed at which the net thrust vanishes.")
    return ship


def main():
    ship = options()
    for title, parts in (("Lindqvist 1989", lindqvist(ship)), ("Riska 1997", riska(ship)), ("ISO 19906, sloping structure", iso_19906(ship))):
        print(f"{title} [kN]")
        for name, value in parts.items():
            print(f"  {name:28}{value:10.3f}" if name == "xi" else f"  {name:28}{1e-3 * value:10.0f}")
    if ship.bollard_pull:
        print(f"Net thrust [kN]\n  {f'at {ship.speed:g} m/s':28}{1e-3 * net_thrust(ship):10.0f}\nSpeed held [m/s]")
        for title, formula in (("Lindqvist 1989", lindqvist), ("Riska 1997", riska)):
            print(f"  {title:28}{held_speed(ship, formula):10.2f}")
    print("Cusps of broken ice")
    for (name, value), unit in zip(cusps(ship).items(), ("m", "m", "s")):
        print(f"  {name:28}{value:10.2f} {unit}")


if __name__ == "__main__":
    main()
