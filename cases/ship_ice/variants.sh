#!/usr/bin/env bash
# Runs and measures all variants in the tables of README.md: cases/ship_ice/variants.sh [RESULTS [PERIMPACT]], as
# scripts/variants.bash describes. The deck takes ten minutes on a core, six layers five times as long.
set -euo pipefail
source "$(dirname "$0")/../../scripts/variants.bash"

sheet=bodies.sheet
ship=impactors.ship

variant deck

# Speed, at the same travel
variant speed_6 "$ship.velocity=[-6 kn, 0, 0]" "time.end=6.65 s" "output.history_interval=0.025 s"
variant speed_4.5 "$ship.velocity=[-4.5 kn, 0, 0]" "time.end=8.87 s" "output.history_interval=0.0333 s"

# Thickness, in four layers, in floating equilibrium
variant thickness_3 "$sheet.shape.box.size=[60 m, 36 m, 3 m]" "$sheet.spacing=0.75 m" "$sheet.position=[-30 m, 0, -1.1341 m]" "time.step=0.33 ms"
variant thickness_2.5 "$sheet.shape.box.size=[60 m, 36.25 m, 2.5 m]" "$sheet.spacing=0.625 m" "$sheet.position=[-30 m, 0, -0.9451 m]" "time.step=0.275 ms"
variant thickness_1.5 "$sheet.shape.box.size=[60 m, 36 m, 1.5 m]" "$sheet.spacing=0.375 m" "$sheet.position=[-30 m, 0, -0.5671 m]" "time.step=0.165 ms"

# Strength
variant stretch_2e-4 $sheet.material.critical_stretch=2e-4
variant stretch_5e-4 $sheet.material.critical_stretch=5e-4

# Panels of 3 m at the bow too; friction; compression hardening
variant panels_uniform_3 "$ship.surface.hull.bow_edge_length=3 m"
variant friction_0.1 contact.impactors.friction=0.1
variant hardening_0.2 $sheet.failure.compression_hardening=0.2

# Six layers
variant six_layers "$sheet.spacing=0.3333333333333333 m" "time.step=0.147 ms"

# Which crack opens first: first metres of the bow in ice that is crushed or flows; the sheet cut along the track, through all layers or all but the top one
deck="$case/crushing.yaml"
ductile="$sheet.material.plasticity={compressive_strength: 2.3 MPa}"
cut() { echo "$sheet.cracks={track: {polygon: [[-24, 0, -2], [24, 0, -2], [24, 0, $1], [-24, 0, $1]]}}"; }
variant crushing
variant ductile "$ductile" "time.end=2.1 s" output.frames=21
variant top_layer_whole "$ductile" "$(cut 0.6)" "time.end=2.1 s" output.frames=21
variant cut "$ductile" "$(cut 2)" "time.end=2.1 s" output.frames=21
eight_layers=("$sheet.spacing=0.25 m" "$sheet.shape.box.size=[28 m, 48 m, 2 m]" "$sheet.position=[-14 m, 0, -0.7561 m]" "time.step=0.11 ms"
  "$ship.position=[0.3 m, 0, 0]" "time.end=1 s" output.frames=10
  "$sheet.particle_sets={far_end: {shape: {box: {size: [0.7 m, 48 m, 4 m]}}, position: [-13.65 m, 0, 0]}, port: {shape: {box: {size: [27.3 m, 0.7 m, 4 m]}}, position: [0.35 m, -23.65 m, 0]}, starboard: {shape: {box: {size: [27.3 m, 0.7 m, 4 m]}}, position: [0.35 m, 23.65 m, 0]}}")
variant ductile_8_layers "$ductile" "${eight_layers[@]}"
variant cut_8_layers "$ductile" "$(cut 2)" "${eight_layers[@]}"

# The paper's sheet of crushed ice, with a rim that does not break
deck="$case/paper.yaml"
variant paper_crushed "$sheet.material.plasticity={compressive_strength: 2.3 MPa, failure_strain: 0.003, failure_pressure: 0.2, failure_width: 3, friction_angle: 30 deg}" \
  "$sheet.failure={no_fail: [far_end, port, starboard]}"
