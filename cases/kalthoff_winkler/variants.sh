#!/usr/bin/env bash
# Runs and measures all variants in the table of README.md: cases/kalthoff_winkler/variants.sh [RESULTS [PERIMPACT]], as
# scripts/variants.bash describes. About a minute each on two cores, spacing_0.75 three.
set -euo pipefail
source "$(dirname "$0")/../../scripts/variants.bash"

plate=bodies.plate
stretch=$plate.material.critical_stretch
steel="youngs_modulus: 191 GPa, density: 8000 kg/m3"
longer=(time.end="120 us" output.frames=40)

variant deck

# Fracture energy
variant stretch_0.0057 $stretch=0.0057
variant stretch_0.0075 $stretch=0.0075
variant fracture_energy_42408 "$plate.material={model: ordinary-state, $steel, fracture_energy: 42408 J/m2}"
variant stretch_0.0125 $stretch=0.0125 "${longer[@]}"
variant stretch_0.015 $stretch=0.015 "${longer[@]}"

# Spacing, at the critical stretch and at the fracture energy of the deck; the plate is a multiple of the spacing, with the projectile just above it
coarse=("$plate.spacing=1.5 mm" "$plate.shape.box.size=[198 mm, 99 mm, 9 mm]" "impactors.projectile.position=[0, 99.5001 mm, 0]" "time.step=0.135 us")
fine=("$plate.spacing=0.75 mm" "$plate.shape.box.size=[201 mm, 100.5 mm, 9 mm]" "impactors.projectile.position=[0, 100.2501 mm, 0]" "time.step=0.0675 us")
variant spacing_1.5 "${coarse[@]}"
variant spacing_1.5_same_energy "${coarse[@]}" $stretch=0.008165
variant spacing_0.75 "${fine[@]}"
variant spacing_0.75_same_energy "${fine[@]}" $stretch=0.011547
variant spacing_2 "$plate.spacing=2 mm" "$plate.shape.box.size=[202 mm, 100 mm, 8 mm]" "time.step=0.18 us"
variant horizon_4.015 $plate.horizon_ratio=4.015
variant horizon_4.015_stretch_0.015 $plate.horizon_ratio=4.015 $stretch=0.015 "${longer[@]}"

# Material and method
variant poissons_ratio_0.3 $plate.material.poissons_ratio=0.3
variant bond_based "$plate.material={model: bond-based, $steel, critical_stretch: 0.01}"
variant correction_none $plate.surface_correction=none
variant published $plate.published=true
variant breaks_in_compression $plate.failure.compression=symmetric
variant step_45ns "time.step=0.045 us"

# Notch: contact of its faces, and its width
touch=contact.fragments.law=repulsive
slot() { echo "{shape: {box: {size: [2 mm, 60 mm, 12 mm]}}, position: [$1 mm, 30 mm, 0]}"; }
slots=("$plate.cracks={}" "$plate.holes={left: $(slot -25), right: $(slot 25)}")
variant faces_touch $touch
variant slots "${slots[@]}"
variant slots_faces_touch "${slots[@]}" $touch

# Two dimensions
notch() { echo "polygon: [[$1 mm, 0, 0], [$1 mm, 51 mm, 0]]"; }
notches="$plate.cracks={left: {$(notch -25)}, right: {$(notch 25)}}"
for plane in stress strain; do
  variant plane_$plane $plate.plane=$plane "$notches"
  variant plane_${plane}_stretch_0.0057 $plate.plane=$plane "$notches" $stretch=0.0057
done
variant plane_stress_bond_based $plate.plane=stress "$notches" "$plate.material={model: bond-based, $steel, critical_stretch: 0.01}"

/usr/bin/python3 "$case/figures.py" "$results/deck"
/usr/bin/python3 "$case/figures.py" --variants 0.0057="$results/stretch_0.0057" 0.0075="$results/stretch_0.0075" 0.01="$results/deck" 0.0125="$results/stretch_0.0125"
