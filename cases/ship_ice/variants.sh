#!/usr/bin/env bash
# Runs and measures all variants in the tables of README.md: cases/ship_ice/variants.sh [RESULTS [PERIMPACT]], as
# scripts/variants.bash describes. The deck takes some five minutes on a core; half the step twice, four layers four times as long.
set -euo pipefail
source "$(dirname "$0")/../../scripts/variants.bash"

sheet=bodies.sheet
ship=impactors.ship
half_step=time.step="0.1175 ms"
# of an even number of layers none is in the middle; the one above it is fixed at the edges, so that they can rotate
even() { # spacing, half of it, step
  edge() { echo "$sheet.particle_sets.$1={shape: {box: {size: [$2, $4]}}, position: [$3, $5]}"; }
  layers=("$sheet.spacing=$1" "time.step=$3" "$(edge far_end "2 m, 81 m" "-29 m, 0" "$2" "$2")" "$(edge port "58 m, 2 m" "1 m, -39 m" "$2" "$2")"
    "$(edge starboard "58 m, 2 m" "1 m, 39 m" "$2" "$2")")
}
even "0.5 m" "0.25 m" "0.176 ms"
four_layers=("${layers[@]}")
even "0.25 m" "0.125 m" "0.088 ms"
eight_layers=("${layers[@]}")
cut() { echo "$sheet.cracks={track: {polygon: [[-31, 0, -2], [31, 0, -2], [31, 0, $1], [-31, 0, $1]]}}"; } # up to this height above the middle

variant deck

# Pressure at which the hull crushes the ice in contact; half of the time step; four layers
variant crushing_1.15 "contact.impactors.crushing_pressure=1.15 MPa"
variant crushing_4.6 "contact.impactors.crushing_pressure=4.6 MPa"
variant step_half "$half_step"
variant layers_4 "${four_layers[@]}"

# A stem of a radius of 1 m; tops that stay dry to 3 m, far below every floe
variant stem_radius_1 "$ship.surface.hull.stem_radius=1 m"
variant dry_top_3 "$sheet.boundary_conditions.sea.floating.dry_top=3 m"

# The sheet cut along the track: through all layers, or all but the top one
entry=("time.end=2.1 s" output.frames=21)
variant cut "$(cut 2)" "${entry[@]}"
variant cut_below_top "$(cut 0.33)" "${entry[@]}"
variant cut_layers_4 "$(cut 2)" "${four_layers[@]}" "${entry[@]}"
variant cut_layers_8 "$(cut 2)" "${eight_layers[@]}" "${entry[@]}" # 614 400 particles, half an hour on a core

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
