#!/usr/bin/python3
"""Writes a deck for a ship in level ice, from the data of ship and ice:

    cases/ship_ice/level_ice.py --length 150 --beam 21.3 --draft 9.5 --stem 30 --waterline 21 --fullness 1.4 --displacement 21655e3 --friction 0.05 \\
        --thickness 1.04 --young 1273e6 --strength 669e3 --compressive-strength 2.49e6 --speed 0.5 --out my_ship.yaml

SI units; angles in degrees. The ship opens its channel at --approach-speed until its full breadth is in the ice, then advances at --speed for --lead-in and for
--sample, over which the mean is to be taken. With --bollard-pull it is free in surge and heave, and driven by its net thrust. The rules and their reasons: docs/guide/ship_in_level_ice.md.
"""

import argparse
import sys
from dataclasses import dataclass, fields
from math import ceil, exp, pi, radians, sqrt, tan
from pathlib import Path

from resistance import GRAVITY, ShipInIce, cusps, help_of_fields, net_thrust_factor

STEP = 0.5  # over spacing/√(E/ρ), with ρ of the scaled mass; `perimpact check` accepts up to 0.55 for such decks
NEEDED = ("length", "beam", "draft", "stem", "waterline", "friction", "thickness", "young", "strength", "compressive_strength", "speed")  # of the command line
RIM_DAMPING = 6.0  # over the natural frequency of heave of the sheet, at its edge: the layer along the edges that absorbs bending waves


@dataclass(frozen=True)
class LevelIceRun(ShipInIce):
    """A ship, the ice, and how far the ship travels in it. Each field is an option of the command line; its comment is the help."""

    layers: int = 3  # of particles in the thickness; three crack within 4 % of the load of theory
    fullness: float = 2.0  # p of the hull: its bow is p B/(2 tan α) long
    stem_radius: float = 0.0  # of the waterlines of the hull at its stem [m]; a sharp edge where 0
    freeboard: float = 6.0  # height of the hull above the water [m]
    displacement: float = 22171e3  # mass of the ship [kg]; without effect unless --bollard-pull is given
    compressive_strength: float = 2.3e6  # σ_c of the ice [Pa]
    crushing_pressure: float = 0.0  # pressure at which the hull crushes the ice [Pa]; σ_c where 0
    edge_length: float = 0.0  # of the panels of the hull [m]; four spacings where 0
    bow_edge_length: float = 0.0  # of those of its bow [m]; two spacings where 0
    ahead: float = 4.0  # ice ahead of the stem, in characteristic lengths; radial cracks must not reach its end
    beside: float = 2.0  # ice on either side of the hull, in characteristic lengths
    astern: float = 0.0  # ice behind the stem, which slides along the hull [m]; the length of the bow where 0
    approach_speed: float = 1.5  # while the bow opens its channel [m/s]
    inertial_speed: float = 0.0  # speed at which the ice would have the inertial forces of the run [m/s]: a slower ship has heavier ice, and longer steps
    lead_in: float = 0.0  # travel at the speed of the run before the sample [m]; one characteristic length where 0
    sample: float = 0.0  # travel over which the mean is taken [m]; ten cusps at rest where 0

    @property
    def spacing(self):
        """Δ [m]"""
        return self.thickness / self.layers

    @property
    def bow_length(self):
        """Of the hull, in full metres [m]."""
        return float(ceil(self.fullness * self.beam / (2 * tan(radians(self.waterline)))))

    @property
    def travels(self):
        """Travel at the speed of the run before the sample, and in it [m]."""
        return self.lead_in or float(ceil(self.characteristic_length)), self.sample or float(ceil(10 * cusps(self)["length at rest"]))

    @property
    def entrained_depth(self):
        """Depth of the water that moves with a cusp, (2/π) 0.32 l [m] (docs/theory/floating_bodies.md)."""
        return 2 / pi * cusps(self)["length at rest"]

    @property
    def mass_scaling(self):
        """Density of the ice in the run over its own: inertia of the ice with this water, and of `inertial_speed`."""
        return (1 + self.water * self.entrained_depth / (self.ice * self.thickness)) * self.inertia

    @property
    def dry_top(self):
        """Depth below which the top of the ice is flooded: deflection at breaking, less the freeboard of the ice [m]."""
        return max(0.0, deflection_at_breaking(self) - self.thickness * (1 - self.ice / self.water))

    @property
    def step(self):
        """Δt [s], rounded to three digits."""
        return 1e-3 * float(f"{1e3 * STEP * self.spacing / sqrt(self.young / (self.ice * self.mass_scaling)):.3g}")

    @property
    def inertia(self):
        """Inertial forces of the run over those of the ice and its water: above one for a ship that is slower than `inertial_speed`."""
        return max(1.0, self.inertial_speed / self.speed) ** 2

    @property
    def approach(self):
        """Speed of the approach [m/s]: `approach_speed`, or slower where its inertial forces would be more than four times as large."""
        return self.approach_speed * min(1.0, 2 / sqrt(self.inertia))

    @property
    def approach_time(self):
        """Time from which the ship has the speed of the run [s]: it takes a second to change it. A free ship: at its initial speed."""
        if self.bollard_pull:
            return self.bow_length / self.speed
        return (self.bow_length - (self.approach + self.speed) / 2) / self.approach + 1

    @property
    def sample_begins(self):
        """[s]"""
        return self.approach_time + self.travels[0] / self.speed

    @property
    def ends(self):
        """[s]"""
        return self.approach_time + sum(self.travels) / self.speed


def deflection_at_breaking(ship):
    """[m] Deflection of the edge of a floating strip when it breaks under a load on its edge (docs/theory/floating_strip.md)."""
    foundation = ship.water * GRAVITY
    wavenumber = 1 / (sqrt(2) * ship.characteristic_length)
    load = ship.strength * ship.thickness**2 / 6 * wavenumber / 0.3224
    return 2 * load * wavenumber / foundation


def metres(size, cells, spacing):
    """A size as text, with as few digits as make it `cells` spacings as written in the deck, which may be off by 1e-6 of it."""
    texts = (f"{size:.{digits}g}" for digits in range(6, 18))
    return next(text for text in texts if abs(float(text) / (cells * float(spacing)) - 1) < 9e-7)


def refuse(sentence):
    print(sentence, file=sys.stderr)
    sys.exit(2)


def expect_possible(run):
    """Exits with a sentence where no deck can be written."""
    for name in ("length", "beam", "draft", "speed", "thickness", "strength", "young", "ice", "water", "displacement", "compressive_strength", "approach_speed", "fullness", "ahead", "beside"):
        if not getattr(run, name) > 0:
            refuse(f"--{name.replace('_', '-')} is {getattr(run, name):g}, but must be positive.")
    for name in ("friction", "ice_friction", "stem_radius", "crushing_pressure", "edge_length", "bow_edge_length", "inertial_speed", "astern", "lead_in", "sample", "bollard_pull", "open_water_speed"):
        if not getattr(run, name) >= 0:
            refuse(f"--{name.replace('_', '-')} is {getattr(run, name):g}, but must not be negative.")
    if run.bollard_pull and not run.open_water_speed > run.speed:
        refuse(f"--open-water-speed is {run.open_water_speed:g}, but must exceed --speed ({run.speed:g}), at which the ship starts.")
    if run.open_water_speed and not run.bollard_pull:
        refuse("--open-water-speed is given without --bollard-pull, the thrust at zero speed; give both, or neither.")
    for name in ("stem", "waterline"):
        if not 2 <= getattr(run, name) < 90:
            refuse(f"--{name} is {getattr(run, name):g}, but must be an angle from 2 to 90 degrees.")
    if not 1 <= run.fullness <= 4:
        refuse(f"--fullness is {run.fullness:g}, but must be from 1 to 4.")
    for name, least in (("strength", 1e3), ("compressive_strength", 1e3), ("young", 1e6)):
        if getattr(run, name) < least:
            refuse(f"--{name.replace('_', '-')} is {getattr(run, name):g} Pa, but ice has more than {least:g} Pa; give it in Pa, such as 550e3.")
    if run.layers < 2:
        refuse(f"--layers is {run.layers}, but must be at least 2: one layer does not bend.")
    if 0 < run.astern < run.bow_length:
        refuse(f"--astern is {run.astern:g}, but must be at least the length of the bow ({run.bow_length:g} m), so that the full breadth of the ship is in the ice.")
    if run.compressive_strength <= run.strength:
        refuse(f"--compressive-strength ({run.compressive_strength:g} Pa) must exceed --strength ({run.strength:g} Pa), the flexural strength.")
    if run.ice >= run.water:
        refuse(f"--ice is {run.ice:g} kg/m3, but ice of {run.water:g} kg/m3 and more does not float.")


def deck(run, title, heading, folder):
    """The deck as text. `heading`: comment lines before the title; `folder` of the results."""
    spacing, travels = run.spacing, sum(run.travels)
    written = f"{spacing:.7g}"
    astern = run.astern or run.bow_length
    along = 8 * ceil((astern + run.ahead * run.characteristic_length) / spacing / 8)
    across = 2 * ceil((run.beam / 2 + run.beside * run.characteristic_length) / spacing)
    long, wide, edge = along * spacing, across * spacing, 3 * spacing
    layer, height = f"{spacing / 2:.4g} m", "0" if run.layers % 2 else f"{spacing / 2:.4g}"  # of the fixed layer: one alone lets the edge rotate
    draft = run.thickness * run.ice / run.water
    scaling, rim = run.mass_scaling, run.characteristic_length
    heave = sqrt(run.water * GRAVITY / (run.ice * scaling * run.thickness))  # [rad/s]
    fastest = sqrt(1.2 * run.young / (run.ice * scaling))  # [m/s] √((λ + 2µ)/ρ) at ν = 1/4
    reflection = exp(-RIM_DAMPING * heave * rim / (3 * fastest))  # of that wave (docs/theory/boundary_conditions.md); bending waves are far slower
    reached = run.approach_time
    motion = f"""motion: {{x: {{times: [0, {reached - 1:.4g}, {reached:.4g}], velocities: [{-run.approach:g}, {-run.approach:g}, {-run.speed:g}]}}}}  # opens its channel, then breaks ice at the speed of the run"""
    if run.bollard_pull:
        relative = [tenths / 10 for tenths in range(13)]
        speeds = ", ".join(f"{share * run.open_water_speed:.4g}" for share in relative)
        factors = ", ".join(f"{round(net_thrust_factor(share), 4):g}" for share in relative)
        motion = f"""velocity: [{-run.speed:g} m/s, 0, 0]
    free_dofs: [x, z]
    floating: {{level: 0, damping: 1}}
    # thrust less the resistance of open water
    loads: {{net_thrust: {{force: [{-1e-3 * run.bollard_pull:.5g} kN, 0, 0], speeds: [{speeds}], speed_factors: [{factors}]}}}}"""
    flexural = 1e-3 * (1 - run.poisson**2) * run.strength
    return f"""{heading}
title: {title}

time: {{end: {run.ends:.5g} s, step: {1e3 * run.step:.3g} ms}}                 # {run.bow_length + travels:g} m of travel

bodies:
  sheet:
    shape: {{box: {{size: [{metres(long, along, written)} m, {metres(wide, across, written)} m, {metres(run.thickness, run.layers, written)} m]}}}}
    position: [{-long / 2:.6g} m, 0, {run.thickness / 2 - draft:.4g} m]         # in floating equilibrium
    spacing: {written} m                       # {along} x {across} x {run.layers} particles
    horizon_ratio: 2.015
    bending_calibration: z
    mass_scaling: {scaling:.3g}                            # the water that moves with a cusp{f", and the inertial forces of {run.inertial_speed:g} m/s" if run.inertial_speed > run.speed else ""}
    moving_window: {{follow: ship, start_after: {astern:g} m}}
    material:
      model: bond-based
      youngs_modulus: {1e-6 * run.young:g} MPa
      density: {run.ice:g} kg/m3
      flexural_strength: {flexural:.4g} kPa                 # {1e-3 * run.strength:g} kPa times 1 - 0.25^2: a wide sheet cannot contract laterally
      # brittle in uniaxial compression, ductile under confinement, granular once crushed
      plasticity: {{compressive_strength: {1e-6 * run.compressive_strength:g} MPa, failure_strain: 0.003, failure_pressure: 0.2, failure_width: 3, friction_angle: 30 deg}}
    failure: {{no_fail: [far_end, port, starboard]}}
    particle_sets:                                 # of the {"" if run.layers % 2 else "upper "}middle layer, three spacings deep
      far_end: {{shape: {{box: {{size: [{edge:.5g} m, {wide + 1:.4g} m, {layer}]}}}}, position: [{(edge - long) / 2:.6g} m, 0, {height}]}}
      port: {{shape: {{box: {{size: [{long - edge:.6g} m, {edge:.5g} m, {layer}]}}}}, position: [{edge / 2:.5g} m, {(edge - wide) / 2:.6g} m, {height}]}}
      starboard: {{shape: {{box: {{size: [{long - edge:.6g} m, {edge:.5g} m, {layer}]}}}}, position: [{edge / 2:.5g} m, {(wide - edge) / 2:.6g} m, {height}]}}
      # of all layers, one characteristic length wide
      far_rim: {{shape: {{box: {{size: [{rim:.5g} m, {wide + 1:.4g} m, {2 * ceil(run.thickness / 2 + 1)} m]}}}}, position: [{(rim - long) / 2:.6g} m, 0, 0]}}
      port_rim: {{shape: {{box: {{size: [{long + 1:.6g} m, {rim:.5g} m, {2 * ceil(run.thickness / 2 + 1)} m]}}}}, position: [0, {(rim - wide) / 2:.6g} m, 0]}}
      starboard_rim: {{shape: {{box: {{size: [{long + 1:.6g} m, {rim:.5g} m, {2 * ceil(run.thickness / 2 + 1)} m]}}}}, position: [0, {(wide - rim) / 2:.6g} m, 0]}}
    boundary_conditions:
      sea: {{floating: {{level: 0, dry_top: {run.dry_top:.2g} m}}}}
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
    surface: {{hull: {{length: {run.length:g} m, breadth: {run.beam:g} m, draft: {run.draft:g} m, freeboard: {run.freeboard:g} m, stem_angle: {run.stem:g} deg, waterline_angle: {run.waterline:g} deg, fullness: {run.fullness:g}, {f"stem_radius: {run.stem_radius:g} m, " if run.stem_radius else ""}edge_length: {run.edge_length or 4 * spacing:.4g} m, bow_edge_length: {run.bow_edge_length or 2 * spacing:.4g} m}}}}
    position: [0.25 m, 0, 0]                       # just in front of the upper edge of the ice
    mass: {1e-3 * run.displacement:.10g} t                                  # its displacement
    {motion}
    contact_bounds: {{auto: {{}}}}
    gauges:
      bow: {{surface_parts: [bow]}}
      side: {{surface_parts: [side]}}
      bilge: {{surface_parts: [bilge]}}

contact:
  impactors: {{friction: {run.friction:g}, crushing_pressure: {1e-6 * (run.crushing_pressure or run.compressive_strength):g} MPa}}   # {"given" if run.crushing_pressure else "the compressive strength"}
  fragments: {{law: repulsive, stiffness_factor: 2, friction: {run.ice_friction:g}}}

output:
  folder: {folder}
  frames: 170
  frame_fields: [displacement, damage, plastic_strain, fragment]
  history_interval: {0.05 / run.speed:g} s
"""


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    descriptions = help_of_fields(__file__) | help_of_fields(Path(__file__).with_name("resistance.py"))
    formulas_alone = {"poisson", "parallel", "bow", "ride_up", "porosity", "repose", "cohesion", "inner_friction"}  # bond-based ice has ν = 1/4
    for field in fields(LevelIceRun):
        if field.name in formulas_alone:
            continue
        needed = field.name in NEEDED
        absent = "; needed" if needed else f"; {field.default:g} where absent" if field.default else ""
        parser.add_argument(
            "--" + field.name.replace("_", "-"), type=type(field.default), required=needed, default=field.default, help=descriptions[field.name] + absent
        )
    parser.add_argument("--out", type=Path, required=True, help="file of the deck, which must not exist")
    given = vars(parser.parse_args())
    out = given.pop("out")
    run = LevelIceRun(**given)
    expect_possible(run)
    if out.exists():
        refuse(f"{out} exists; remove it, or choose another --out.")
    title = f"A ship of {run.length:g} m in {run.thickness:g} m of level ice, {f'driven by up to {1e-3 * run.bollard_pull:g} kN' if run.bollard_pull else f'at {run.speed:g} m/s'}"
    heading = "# Written by level_ice.py. The guide page 'A ship in level ice' (docs/guide/ship_in_level_ice.md) gives the reason for each number."
    out.write_text(deck(run, title, heading, f"results/{out.stem}"), encoding="utf-8")
    print(f"{out}: {run.bow_length + sum(run.travels):g} m of travel, about {round(run.ends / run.step, -3):.0f} steps")
    columns = "ship.force_x,ship.velocity_x" if run.bollard_pull else "ship.force_x"
    print(f"Mean of the sample: perimpact statistics results/{out.stem} --from {run.sample_begins:.2f} --to {run.ends:.2f} --columns {columns}")
    print(f"Width of the channel: perimpact statistics results/{out.stem} --channel sheet:x")


if __name__ == "__main__":
    main()
