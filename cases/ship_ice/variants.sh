#!/usr/bin/env bash
# Runs and measures all variants in the tables of README.md: cases/ship_ice/variants.sh [RESULTS [PERIMPACT]], as
# scripts/variants.bash describes. The deck takes some five minutes on a core; half the step twice, four layers four times as long.
set -euo pipefail
source "$(dirname "$0")/../../scripts/variants.bash"

sheet=bodies.sheet
ship=impactors.ship
# of four layers none is in the middle; one is held, so that the edge can rotate
edge() { echo "$sheet.particle_sets.$1={shape: {box: {size: [$2, 0.4 m]}}, position: [$3, 0.25 m]}"; }
half_step=time.step="0.1175 ms"
four_layers=("$sheet.spacing=0.5 m" "time.step=0.176 ms" "$(edge far_end "2 m, 81 m" "-29 m, 0")" "$(edge port "58 m, 2 m" "1 m, -39 m")"
  "$(edge starboard "58 m, 2 m" "1 m, 39 m")")

variant deck

# Pressure at which the hull crushes the ice in contact; half of the time step; four layers
variant crushing_1.15 "contact.impactors.crushing_pressure=1.15 MPa"
variant crushing_4.6 "contact.impactors.crushing_pressure=4.6 MPa"
variant step_half "$half_step"
variant layers_4 "${four_layers[@]}"

# The sheet cut along the track
variant cut "$sheet.cracks={track: {polygon: [[-31, 0, -2], [31, 0, -2], [31, 0, 2], [-31, 0, 2]]}}" "time.end=2.1 s" output.frames=21

# Rigid contact, with half of the step, panels of 3 m, four layers, and larger horizons, with fragments as stiff in contact
rigid="contact.impactors={friction: 0}"
variant rigid "$rigid"
variant rigid_step_half "$rigid" "$half_step"
variant rigid_panels_uniform_3 "$rigid" "$ship.surface.hull.bow_edge_length=3 m"
variant rigid_layers_4 "$rigid" "${four_layers[@]}"
variant rigid_horizon_2.5 "$rigid" $sheet.horizon_ratio=2.515 contact.fragments.stiffness_factor=6
variant rigid_horizon_3 "$rigid" $sheet.horizon_ratio=3.015 contact.fragments.stiffness_factor=15

# Strength, friction of the hull, and speed at the same travel
variant rigid_flexural_360 "$rigid" "$sheet.material.flexural_strength=360 kPa"
variant rigid_flexural_1440 "$rigid" "$sheet.material.flexural_strength=1440 kPa"
variant rigid_compressive_4.6 "$rigid" "$sheet.material.plasticity.compressive_strength=4.6 MPa"
variant rigid_friction_0.1 "contact.impactors={friction: 0.1}"
variant rigid_speed_6 "$rigid" "$ship.velocity=[-6 kn, 0, 0]" "time.end=6.65 s" "output.history_interval=0.025 s"
