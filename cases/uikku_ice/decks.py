#!/usr/bin/python3
"""Writes the decks of this folder from measured.csv: decks.py [--out FOLDER]

Every number of a deck follows from the row of its test and from the rules below, which README.md explains. None depends on the result of a run with a ship.
"""

import argparse
import csv
import sys
from dataclasses import replace
from math import ceil, exp, pi, sqrt
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE / "../ship_ice"))
from resistance import GRAVITY, ShipInIce  # noqa: E402

# L_bow and L_par reproduce what Hu and Zhou print for Riska's formula (README.md); 0.25 is Poisson's ratio of bond-based peridynamics
UIKKU = ShipInIce(length=150, beam=21.3, draft=9.5, stem=30, waterline=21, parallel=67, bow=38, friction=0.05, poisson=0.25)
LAYERS = 3
ASTERN = 39.0  # [m] of ice behind the stem, the length of the bow
AHEAD, BESIDE = 4, 2  # characteristic lengths of ice ahead of the stem, where a radial crack ran more than two, and beside the hull
APPROACH = 1.5  # [m/s] while the bow makes its channel, which takes one second more for the change to the speed of the test
STEP = 0.5  # over spacing/√(E/ρ), with ρ of the scaled mass; `perimpact check` accepts up to 0.55 for these decks
DISPLACEMENT = 21655  # [t] of the panels of this hull, by `perimpact shape hull`, in water of 1025 kg/m3
RIM_DAMPING = 6.0  # over the natural frequency of heave of the sheet, at its edge: the layer along the edges that absorbs bending waves
TRAVEL = 46.0  # [m] at the speed of the test, with the whole breadth in the ice
SAMPLE = 36.0  # [m] the last of it, at least ten cusps of the formula: the mean is theirs


def tests():
    """Rows of measured.csv by the number of the test, in the units of the file without them in the names."""
    with open(HERE / "measured.csv", newline="", encoding="utf-8") as lines:
        return {int(row["test"]): {name.split(" [")[0]: float(value) for name, value in row.items()} for row in csv.DictReader(lines)}


def name_of(number):
    return "deck.yaml" if number == 302 else f"test_{number}.yaml"


def ship_in(test):
    """Ship and ice of a test, as input of the formulas for resistance."""
    return replace(UIKKU, speed=test["speed"], thickness=test["thickness"], strength=1e3 * test["flexural strength"], young=1e6 * test["elastic modulus"])


def deflection_at_breaking(ship):
    """[m] Deflection of the edge of a floating strip when it breaks under a load on its edge (docs/theory/floating_strip.md)."""
    foundation = ship.water * GRAVITY
    wavenumber = 1 / (sqrt(2) * ship.characteristic_length)
    load = ship.strength * ship.thickness**2 / 6 * wavenumber / 0.3224
    return 2 * load * wavenumber / foundation


def approach(speed):
    """[s] until the ship has the speed of the test, after ASTERN."""
    return (ASTERN - (APPROACH + speed) / 2) / APPROACH + 1


def sample(speed):
    """[s] at which the sample begins."""
    return approach(speed) + (TRAVEL - SAMPLE) / speed


def deck(number, test, is_free=False):
    """The deck of a test; of a ship that is free in surge and heave and driven by the resistance that was measured, where `is_free`."""
    ship = ship_in(test)
    length, spacing = ship.characteristic_length, ship.thickness / LAYERS
    along = 8 * ceil((ASTERN + AHEAD * length) / spacing / 8)
    across = 2 * ceil((ship.beam / 2 + BESIDE * length) / spacing)
    long, wide, edge, layer = along * spacing, across * spacing, 3 * spacing, f"{spacing / 2:.4g} m"
    draft = ship.thickness * ship.ice / ship.water
    entrained = 2 / pi * 0.32 * length  # [m] of water that moves with a cusp
    scaling = 1 + ship.water * entrained / (ship.ice * ship.thickness)
    dry = max(0.0, deflection_at_breaking(ship) - (ship.thickness - draft))
    rim = length  # [m] wide
    heave = sqrt(ship.water * GRAVITY / (ship.ice * scaling * ship.thickness))  # [rad/s]
    fastest = sqrt(1.2 * ship.young / (ship.ice * scaling))  # [m/s] √((λ + 2µ)/ρ) at ν = 1/4
    reflection = exp(-RIM_DAMPING * heave * rim / (3 * fastest))  # of that wave (docs/theory/boundary_conditions.md); bending waves are far slower
    step = STEP * spacing / sqrt(ship.young / (ship.ice * scaling))
    reached = approach(ship.speed)
    end = (ASTERN + TRAVEL) / ship.speed if is_free else reached + TRAVEL / ship.speed
    motion = f"""motion: {{x: {{times: [0, {reached - 1:.4g}, {reached:.4g}], velocities: [{-APPROACH:g}, {-APPROACH:g}, {-ship.speed:g}]}}}}  # makes its channel fast, then breaks ice at the speed of the test"""
    if is_free:
        motion = f"""velocity: [{-ship.speed:g} m/s, 0, 0]
    free_dofs: [x, z]
    floating: {{level: 0, damping: 1}}
    # the resistance that was measured at this speed; until the whole breadth is in the ice the thrust grows as the bow does in it
    loads: {{thrust: {{force: [{-test["resistance"]:g} kN, 0, 0], times: [0, {ASTERN / ship.speed:g}], factors: [0, 1]}}}}"""
    strength = (1 - ship.poisson**2) * test["flexural strength"]
    return f"""# yaml-language-server: $schema=../../docs/guide/deck.schema.json
# MT Uikku in level ice, model test {number} of Hu and Zhou (2016) at full scale. Written by decks.py: why each number is what it is, and what was
# measured, is in README.md of this folder.
title: MT Uikku{", free" if is_free else ""}, test {number}, {ship.thickness:g} m of ice at {ship.speed:g} m/s

time: {{end: {end:.5g} s, step: {1e3 * step:.3g} ms}}                 # {ASTERN + TRAVEL:g} m of travel

bodies:
  sheet:
    shape: {{box: {{size: [{long:.6g} m, {wide:.6g} m, {ship.thickness:g} m]}}}}
    position: [{-long / 2:.6g} m, 0, {ship.thickness / 2 - draft:.4g} m]         # in floating equilibrium
    spacing: {spacing:.7g} m                       # {along} x {across} x {LAYERS} particles
    horizon_ratio: 2.015
    bending_calibration: z
    mass_scaling: {scaling:.3g}                            # the water that moves with a cusp
    moving_window: {{follow: ship, start_after: {ASTERN:g} m}}
    material:
      model: bond-based
      youngs_modulus: {test["elastic modulus"]:g} MPa
      density: {ship.ice:g} kg/m3
      flexural_strength: {strength:.4g} kPa                 # {test["flexural strength"]:g} kPa times 1 - 0.25^2: a wide sheet cannot contract laterally
      # brittle in uniaxial compression, ductile under confinement, granular once crushed
      plasticity: {{compressive_strength: {test["compressive strength"]:g} MPa, failure_strain: 0.003, failure_pressure: 0.2, failure_width: 3, friction_angle: 30 deg}}
    failure: {{no_fail: [far_end, port, starboard]}}
    particle_sets:                                 # of the middle layer, three spacings deep
      far_end: {{shape: {{box: {{size: [{edge:.5g} m, {wide + 1:.4g} m, {layer}]}}}}, position: [{(edge - long) / 2:.6g} m, 0, 0]}}
      port: {{shape: {{box: {{size: [{long - edge:.6g} m, {edge:.5g} m, {layer}]}}}}, position: [{edge / 2:.5g} m, {(edge - wide) / 2:.6g} m, 0]}}
      starboard: {{shape: {{box: {{size: [{long - edge:.6g} m, {edge:.5g} m, {layer}]}}}}, position: [{edge / 2:.5g} m, {(wide - edge) / 2:.6g} m, 0]}}
      # of all layers, one characteristic length wide
      far_rim: {{shape: {{box: {{size: [{rim:.5g} m, {wide + 1:.4g} m, 4 m]}}}}, position: [{(rim - long) / 2:.6g} m, 0, 0]}}
      port_rim: {{shape: {{box: {{size: [{long + 1:.6g} m, {rim:.5g} m, 4 m]}}}}, position: [0, {(rim - wide) / 2:.6g} m, 0]}}
      starboard_rim: {{shape: {{box: {{size: [{long + 1:.6g} m, {rim:.5g} m, 4 m]}}}}, position: [0, {(wide - rim) / 2:.6g} m, 0]}}
    boundary_conditions:
      sea: {{floating: {{level: 0, dry_top: {dry:.2g} m}}}}
      # edges bend and heave freely, like the ice beyond: clamped ones crack under the waves of the bow
      ahead: {{fixed: {{particle_set: far_end, directions: [x, y]}}}}
      left: {{fixed: {{particle_set: port, directions: [x, y]}}}}
      right: {{fixed: {{particle_set: starboard, directions: [x, y]}}}}
      # and bending waves of the bow go out through them
      waves_ahead: {{absorbing: {{particle_set: far_rim, face: -x, reflection: {reflection:.3g}}}}}
      waves_left: {{absorbing: {{particle_set: port_rim, face: -y, reflection: {reflection:.3g}}}}}
      waves_right: {{absorbing: {{particle_set: starboard_rim, face: +y, reflection: {reflection:.3g}}}}}

impactors:
  ship:
    surface: {{hull: {{length: 150 m, breadth: 21.3 m, draft: 9.5 m, freeboard: 6 m, stem_angle: 30 deg, waterline_angle: 21 deg, fullness: 1.4, edge_length: 1.5 m, bow_edge_length: 0.75 m}}}}
    position: [0.25 m, 0, 0]                       # just in front of the upper edge of the ice
    mass: {DISPLACEMENT} t                                  # its displacement
    {motion}
    contact_bounds: {{auto: {{}}}}
    gauges:
      bow: {{surface_parts: [bow]}}
      side: {{surface_parts: [side]}}
      bilge: {{surface_parts: [bilge]}}

contact:
  impactors: {{friction: {ship.friction:g}, crushing_pressure: {test["compressive strength"]:g} MPa}}   # the compressive strength
  fragments: {{law: repulsive, stiffness_factor: 2, friction: 0.1}}

output:
  folder: results/uikku_ice_{"free" if is_free else number}
  frames: 170
  frame_fields: [displacement, damage, plastic_strain]
  history_interval: {0.05 / ship.speed:g} s
"""


def main():
    arguments = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    arguments.add_argument("--out", type=Path, default=HERE)
    folder = arguments.parse_args().out
    for number, test in tests().items():
        (folder / name_of(number)).write_text(deck(number, test), encoding="utf-8")
    (folder / "free.yaml").write_text(deck(302, tests()[302], is_free=True), encoding="utf-8")


if __name__ == "__main__":
    main()
