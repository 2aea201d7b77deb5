#!/usr/bin/env bash
# Runs the variants of README.md's tables, one after the other, and measures them: cases/ship_ice/variants.sh [RESULTS [PERIMPACT]], as
# scripts/variants.bash says. The deck takes a quarter of an hour on two cores, so do the sweeps each; six layers take an hour.
set -euo pipefail
source "$(dirname "$0")/../../scripts/variants.bash"

sheet=bodies.sheet
ship=impactors.ship

variant deck

# Strength of what is pressed, friction, regions and panels
variant hardening_0 $sheet.failure.compression_hardening=0
variant hardening_0.1 $sheet.failure.compression_hardening=0.1
variant hardening_0.2 $sheet.failure.compression_hardening=0.2
variant friction_0.1 contact.impactors.friction=0.1
variant region_box "$ship.region={box: {size: [178 m, 24 m, 16 m], centre: [75 m, 0, -1.5 m]}, outside: clip}"
variant region_none "$ship.region={}"
variant panels_uniform_1 "$ship.surface.hull.panel=1 m"
variant panels_uniform_3 "$ship.surface.hull.bow_panel=3 m"

# Strength, speed, thickness; half the time at twice the speed, so that the travel is the same
variant strength_0.3 $sheet.material.flexural_strength="0.3 MPa"
variant strength_0.7 $sheet.material.flexural_strength="0.7 MPa"
variant speed_1.5 "$ship.velocity=[-1.5 kn, 0, 0]" "time.end=26.6 s" "output.history=0.1 s"
variant speed_6 "$ship.velocity=[-6 kn, 0, 0]" "time.end=6.65 s" "output.history=0.025 s"
variant thickness_1 "$sheet.shape.box.size=[60 m, 36 m, 1 m]" "$sheet.spacing=0.25 m" "$sheet.position=[-30 m, 0, -0.378 m]" "time.step=0.11 ms"
variant thickness_1.5 "$sheet.shape.box.size=[60 m, 36 m, 1.5 m]" "$sheet.spacing=0.375 m" "$sheet.position=[-30 m, 0, -0.567 m]" "time.step=0.165 ms"

# Six layers
variant six_layers "$sheet.spacing=0.3333333333333333 m" "time.step=0.147 ms"
