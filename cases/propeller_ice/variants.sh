#!/usr/bin/env bash
# Runs and measures all variants in the tables of README.md: cases/propeller_ice/variants.sh [RESULTS [PERIMPACT]], as
# scripts/variants.bash describes. Each takes 5 to 10 s on one core, those of half the spacing some minutes.
set -euo pipefail
source "$(dirname "$0")/../../scripts/variants.bash"

stretch=bodies.ice.material.critical_stretch failure=bodies.ice.failure surface=impactors.propeller.surface.propeller
bounds=impactors.propeller.contact_bounds

variant deck

# Critical stretch in tension; in compression too, at three times the stretch or at the same
for value in 0.032 0.01 0.003 0.001; do
  [[ $value == 0.003 ]] || variant "stretch_$value" $stretch=$value
  variant "stretch_${value}_limit" $stretch=$value $failure.compression=limit $failure.critical_compression="$(awk "BEGIN {print 3 * $value}")"
  variant "stretch_${value}_symmetric" $stretch=$value $failure.compression=symmetric
done

# Ice that is crushed (the constants of cases/ice_specimens/crushed.yaml), beside the same critical stretch in tension only; half the step, half the spacing
plasticity="{compressive_strength: 2.3 MPa, failure_strain: 0.003, failure_pressure: 0.2, failure_width: 3, friction_angle: 30 deg}"
weak=($stretch=3.2e-4) crushed=($stretch=3.2e-4 bodies.ice.material.plasticity="$plasticity")
variant stretch_3.2e-4 "${weak[@]}"
variant crushed "${crushed[@]}"
variant crushed_half_step "${crushed[@]}" time.step=9.5e-6
variant crushed_in_contact "${crushed[@]}" contact.impactors.crushing_pressure="2.3 MPa"
variant crushed_in_contact_half_step "${crushed[@]}" contact.impactors.crushing_pressure="2.3 MPa" time.step=9.5e-6
variant stretch_3.2e-4_fine "${weak[@]}" bodies.ice.spacing=0.025
variant crushed_fine "${crushed[@]}" bodies.ice.spacing=0.025 time.end="19.3 ms"
variant crushed_in_contact_fine "${crushed[@]}" contact.impactors.crushing_pressure="2.3 MPa" bodies.ice.spacing=0.025 time.end="19.3 ms"

# Position of the sphere around the shaft, panel size, no fragment contact
variant turned_30 bodies.ice.position="[0.80, 0.721, -1.24881]"
variant turned_60 bodies.ice.position="[0.80, 1.24881, -0.721]"
variant panels_coarse $surface.edge_length=0.3 $surface.blade_edge_length=0.1
variant panels_fine $surface.edge_length=0.075 $surface.blade_edge_length=0.025
variant no_fragments contact.fragments="{law: none}"

# Propeller free in all degrees of freedom
variant free impactors.propeller.free_dofs="[x, y, z, rx, ry, rz]"

# Contact bounds
variant bounds_none $bounds=null
variant bounds_box $bounds="{box: {size: [1.236, 4.12, 4.12]}}"
variant bounds_cylinder $bounds.cylinder_sectors.sector_angle="180 deg"
variant bounds_box_union $bounds="{box_union: {}}"
variant bounds_auto $bounds="{auto: {}}"
