#!/usr/bin/env bash
# Runs the variants of README.md's tables, one after the other, and measures them: cases/ice_sphere/variants.sh [RESULTS [PERIMPACT]]
# RESULTS: folder of the results (default: results/ice_sphere); variants that are finished there are not run again.
# PERIMPACT: the program (default: build/release/perimpact, as run.sh builds it). A few seconds each on one core; 60 across half a minute.
set -euo pipefail
case=$(cd "$(dirname "$0")" && pwd)
results=${1:-results/ice_sphere}
perimpact=${2:-$case/../../build/release/perimpact}

# variant NAME DECK [key=value ...]: results in $results/NAME
variant() {
  local folder="$results/$1" settings=() setting
  for setting in "${@:3}"; do settings+=(--set "$setting"); done
  grep -qs '"outcome": "finished"' "$folder/run.json" || nice "$perimpact" run "$case/$2" --threads 1 --out "$folder" "${settings[@]}"
  /usr/bin/python3 "$case/measure.py" "$folder"
}
stretch=bodies.ice.material.critical_stretch symmetric=bodies.ice.failure.compression=symmetric pushes="contact.fragments={law: repulsive}"
unbroken=(bodies.ice.material="{model: ordinary-state, youngs_modulus: 1.8 GPa, poissons_ratio: 0.25, density: 900}" time.end="7 ms")

# Dust: every bond breaks at the first touch, in tension and in compression
variant dust deck.yaml $stretch=1e-12 $symmetric
variant dust_pushes deck.yaml $stretch=1e-12 $symmetric "$pushes"

# When bonds break; debris that passes through debris, or pushes it
variant unbroken deck.yaml "${unbroken[@]}" time.end="80 ms"
for value in 0.032 0.01 0.002 3.2e-4; do
  variant "stretch_${value}" deck.yaml $stretch=$value
  variant "stretch_${value}_symmetric" deck.yaml $stretch=$value $symmetric
  variant "stretch_${value}_pushes" deck.yaml $stretch=$value "$pushes"
  variant "stretch_${value}_symmetric_pushes" deck.yaml $stretch=$value $symmetric "$pushes"
done

# Against Hertz: along an axis of the lattice, and askew
for across in 20 40 60; do
  spacing=$(awk "BEGIN {printf \"%.17g\", 1 / $across}")
  variant "hertz_$across" deck.yaml "${unbroken[@]}" bodies.ice.spacing=$spacing output.history="0.05 ms" output.frames=0
  variant "hertz_oblique_$across" oblique.yaml bodies.ice.spacing=$spacing output.history="0.05 ms" output.frames=0
done
