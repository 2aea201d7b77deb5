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

# Ice that is crushed, by rigid contact and in contact, beside the same critical stretch in tension only; half the step, half the spacing
rigid="contact.impactors={friction: 0}" fine=(bodies.ice.spacing=0.025 time.end="19.3 ms")
variant stretch_3.2e-4 $stretch=3.2e-4
deck=$case/crushed.yaml variant crushed "$rigid"
deck=$case/crushed.yaml variant crushed_half_step "$rigid" time.step=9.5e-6
deck=$case/crushed.yaml variant crushed_in_contact
deck=$case/crushed.yaml variant crushed_in_contact_half_step time.step=9.5e-6
variant stretch_3.2e-4_fine $stretch=3.2e-4 bodies.ice.spacing=0.025
deck=$case/crushed.yaml variant crushed_fine "$rigid" "${fine[@]}"
deck=$case/crushed.yaml variant crushed_in_contact_fine "${fine[@]}"

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
