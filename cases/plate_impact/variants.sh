#!/usr/bin/env bash
# Runs all variants of this case and draws the figures: cases/plate_impact/variants.sh [RESULTS [PERIMPACT]]
# RESULTS: folder of the results (default: results/plate_impact); finished variants there are reused.
# PERIMPACT: the program (default: build/release/perimpact, as run.sh builds it). About a minute per variant on two cores; results: README.md.
set -euo pipefail
case=$(cd "$(dirname "$0")" && pwd)
results=${1:-results/plate_impact}
perimpact=${2:-$case/../../build/release/perimpact}

# variant NAME [--set key=value ...]: results in $results/NAME
variant() {
  local folder="$results/$1"
  shift
  if grep -qs '"outcome": "finished"' "$folder/run.json"; then
    echo "== $folder is finished"
    return
  fi
  echo "== $folder"
  mkdir -p "$folder"
  nice "$perimpact" run "$case/deck.yaml" --out "$folder" --force "$@" | tee "$folder/log.txt"
}
# the same, with the set-up as frames
checked() {
  local folder="$results/$1"
  [[ -d "$folder/check" ]] || nice "$perimpact" check "$case/deck.yaml" --out "$folder" "${@:2}"
  variant "$@"
}
last_frame_only=(--set output.frames=1)

# Figures 14 to 17: panel sizes, and the original method with the exact cylinder
checked panel_2mm --set impactors.cylinder.surface.cylinder.edge_length="2 mm"
checked panel_1.5mm --set impactors.cylinder.surface.cylinder.edge_length="1.5 mm" "${last_frame_only[@]}"
checked panel_1mm --set impactors.cylinder.surface.cylinder.edge_length="1 mm" "${last_frame_only[@]}"
checked panel_0.5mm --set impactors.cylinder.surface.cylinder.edge_length="0.5 mm" "${last_frame_only[@]}"
checked panel_0.1mm --set impactors.cylinder.surface.cylinder.edge_length="0.1 mm" "${last_frame_only[@]}"
variant analytic --set contact.impactors.detector=analytic "${last_frame_only[@]}"

# One thing changed at a time, with panels of 1 mm
variant region_none --set impactors.cylinder.contact_bounds={} --set output.frames=0
variant radius_0 --set contact.impactors.radius_ratio=0 --set output.frames=0
variant correction_volume --set bodies.plate.surface_correction=volume --set output.frames=0
variant correction_none --set bodies.plate.surface_correction=none --set output.frames=0
variant published_lattice --set bodies.plate.published=true --set output.frames=0

# The paper's detector treats particles as points; quads of 2 mm, since it tests every panel against every particle in the contact bounds
published=(--set contact.impactors.detector=published --set contact.impactors.radius_ratio=0 --set output.frames=0
  --set impactors.cylinder.surface.cylinder.edge_length="2 mm" --set impactors.cylinder.surface.cylinder.panel_shape=quads)
variant published_repaired "${published[@]}"
variant published_letter "${published[@]}" --set contact.impactors.variant=literal

/usr/bin/python3 "$case/table.py" "$results"
/usr/bin/python3 "$case/figures.py" "$results"/panel_*mm "$results/analytic"
