#!/usr/bin/env bash
# Runs and measures all variants in the tables of README.md: cases/ice_sphere/variants.sh [RESULTS [PERIMPACT]], as
# scripts/variants.bash describes. A few seconds each on one core; 60 across half a minute, crushed ice
# 40 across and with small steps some minutes.
set -euo pipefail
source "$(dirname "$0")/../../scripts/variants.bash"

stretch=bodies.ice.material.critical_stretch symmetric=bodies.ice.failure.compression=symmetric contact="contact.fragments={law: repulsive}"
unbroken=(bodies.ice.material="{model: ordinary-state, youngs_modulus: 1.8 GPa, poissons_ratio: 0.25, density: 900}" time.end="7 ms")

# Dust: every bond breaks on first contact, in tension and in compression
variant dust $stretch=1e-12 $symmetric
variant dust_contact $stretch=1e-12 $symmetric "$contact"

# Critical stretch; without and with fragment contact
variant unbroken "${unbroken[@]}" time.end="80 ms"
for value in 0.032 0.01 0.002 3.2e-4; do
  variant "stretch_${value}" $stretch=$value
  variant "stretch_${value}_symmetric" $stretch=$value $symmetric
  variant "stretch_${value}_contact" $stretch=$value "$contact"
  variant "stretch_${value}_symmetric_contact" $stretch=$value $symmetric "$contact"
done

# Against Hertz: normal to a lattice axis, and oblique
for across in 20 40 60; do
  spacing=$(awk "BEGIN {printf \"%.17g\", 1 / $across}")
  variant "hertz_$across" "${unbroken[@]}" bodies.ice.spacing=$spacing output.history_interval="0.05 ms" output.frames=0
  deck=$case/oblique.yaml variant "hertz_oblique_$across" bodies.ice.spacing=$spacing output.history_interval="0.05 ms" output.frames=0
done

# Ice that is crushed: time step, as a part of the step that is chosen where none is given; spacing, to 41.4 ms; oblique
deck=$case/crushed.yaml variant crushed_20
for part in 2 4; do
  deck=$case/crushed.yaml variant "crushed_20_step_$part" time.step="$(awk "BEGIN {print 1.9e-5 / $part}")"
done
deck=$case/crushed.yaml variant crushed_in_contact_20 contact.impactors.crushing_pressure="2.3 MPa"
deck=$case/crushed.yaml variant crushed_in_contact_20_step_2 contact.impactors.crushing_pressure="2.3 MPa" time.step=9.5e-6
deck=$case/crushed.yaml variant crushed_40 bodies.ice.spacing=0.025 time.end="41.4 ms"
deck=$case/crushed.yaml variant crushed_in_contact_40 contact.impactors.crushing_pressure="2.3 MPa" bodies.ice.spacing=0.025 time.end="41.4 ms"
deck=$case/oblique.yaml variant crushed_oblique_20 time.end="80 ms" "$contact" $stretch=3.2e-4 \
  bodies.ice.material.plasticity="{compressive_strength: 2.3 MPa, failure_strain: 0.003, failure_pressure: 0.2, failure_width: 3, friction_angle: 30 deg}"
