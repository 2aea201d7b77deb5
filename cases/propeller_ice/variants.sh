#!/usr/bin/env bash
# Runs and measures all variants in the tables of README.md: cases/propeller_ice/variants.sh [RESULTS [PERIMPACT]]
# RESULTS: folder of the results (default: results/propeller_ice); finished variants there are reused.
# PERIMPACT: the program (default: build/release/perimpact, as run.sh builds it). Each takes 5 to 10 s on one core.
set -euo pipefail
case=$(cd "$(dirname "$0")" && pwd)
results=${1:-results/propeller_ice}
perimpact=${2:-$case/../../build/release/perimpact}

# variant NAME [key=value ...]: results in $results/NAME
variant() {
  local folder="$results/$1" settings=() setting
  for setting in "${@:2}"; do settings+=(--set "$setting"); done
  grep -qs '"outcome": "finished"' "$folder/run.json" || nice "$perimpact" run "$case/deck.yaml" --threads 1 --out "$folder" --force "${settings[@]}"
  folders+=("$folder")
}
stretch=bodies.ice.material.critical_stretch failure=bodies.ice.failure surface=impactors.propeller.surface.propeller
region=impactors.propeller.contact_bounds
folders=()

variant deck

# Critical stretch in tension; in compression too, at three times the stretch or at the same
for value in 0.032 0.01 0.003 0.001; do
  [[ $value == 0.003 ]] || variant "stretch_$value" $stretch=$value
  variant "stretch_${value}_limit" $stretch=$value $failure.compression=limit $failure.critical_compression="$(awk "BEGIN {print 3 * $value}")"
  variant "stretch_${value}_symmetric" $stretch=$value $failure.compression=symmetric
done

# Position of the sphere around the shaft, panel size, no fragment contact
variant turned_30 bodies.ice.position="[0.80, 0.721, -1.24881]"
variant turned_60 bodies.ice.position="[0.80, 1.24881, -0.721]"
variant panels_coarse $surface.edge_length=0.3 $surface.blade_edge_length=0.1
variant panels_fine $surface.edge_length=0.075 $surface.blade_edge_length=0.025
variant no_fragments contact.fragments="{law: none}"

# Propeller free in all degrees of freedom
variant free impactors.propeller.free_dofs="[x, y, z, rx, ry, rz]"

# Contact bounds
variant region_none $region=null
variant region_box $region="{box: {size: [1.236, 4.12, 4.12]}}"
variant region_cylinder $region.cylinder_sectors.sector_angle="180 deg"
variant region_box_union $region="{box_union: {}}"
variant region_auto $region="{auto: {}}"

/usr/bin/python3 "$case/measure.py" "${folders[@]}"
