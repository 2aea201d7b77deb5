#!/usr/bin/env bash
# Runs and measures all variants in the tables of README.md: cases/ice_sphere/variants.sh [RESULTS [PERIMPACT]], as
# scripts/variants.bash describes. A few seconds each on one core; 60 across half a minute.
set -euo pipefail
source "$(dirname "$0")/../../scripts/variants.bash"

stretch=bodies.ice.material.critical_stretch symmetric=bodies.ice.failure.compression=symmetric pushes="contact.fragments={law: repulsive}"
unbroken=(bodies.ice.material="{model: ordinary-state, youngs_modulus: 1.8 GPa, poissons_ratio: 0.25, density: 900}" time.end="7 ms")

# Dust: every bond breaks on first contact, in tension and in compression
variant dust $stretch=1e-12 $symmetric
variant dust_pushes $stretch=1e-12 $symmetric "$pushes"

# Critical stretch; without and with fragment contact
variant unbroken "${unbroken[@]}" time.end="80 ms"
for value in 0.032 0.01 0.002 3.2e-4; do
  variant "stretch_${value}" $stretch=$value
  variant "stretch_${value}_symmetric" $stretch=$value $symmetric
  variant "stretch_${value}_pushes" $stretch=$value "$pushes"
  variant "stretch_${value}_symmetric_pushes" $stretch=$value $symmetric "$pushes"
done

# Against Hertz: normal to a lattice axis, and oblique
for across in 20 40 60; do
  spacing=$(awk "BEGIN {printf \"%.17g\", 1 / $across}")
  variant "hertz_$across" "${unbroken[@]}" bodies.ice.spacing=$spacing output.history_interval="0.05 ms" output.frames=0
  deck=$case/oblique.yaml variant "hertz_oblique_$across" bodies.ice.spacing=$spacing output.history_interval="0.05 ms" output.frames=0
done
