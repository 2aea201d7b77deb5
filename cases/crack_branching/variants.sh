#!/usr/bin/env bash
# Runs and measures all variants in the tables of README.md: cases/crack_branching/variants.sh [RESULTS [PERIMPACT]], as
# scripts/variants.bash describes. Under a minute each on two cores, spacing_0.125 five.
set -euo pipefail
source "$(dirname "$0")/../../scripts/variants.bash"

glass=bodies.glass
breaks_at() { echo "$glass.material={model: bond-based, youngs_modulus: 72 GPa, density: 2440 kg/m3, critical_stretch: $1}"; }
spread() { echo "body_force: {particle_set: $1, force_density: [0, ${2}12 GN/m3, 0]}"; }  # over the thickness of the particle set, 1 mm

variant deck

# One thing changed at a time
variant correction_none $glass.surface_correction=none
variant correction_volume $glass.surface_correction=volume
variant family_madenci_oterkus $glass.family=madenci-oterkus
variant normalisation_continuum $glass.normalisation=continuum
variant published $glass.published=true
variant published_continuum_stretch $glass.published=true "$(breaks_at 1.618e-3)"
variant load_spread "$glass.boundary_conditions={pull_up: {$(spread top +)}, pull_down: {$(spread bottom -)}}"
variant may_break_everywhere $glass.failure.no_fail=[]
variant step_25ns "time.step=25 ns"
variant stretch_less "$(breaks_at 1.600e-3)"
variant stretch_more "$(breaks_at 1.632e-3)"
variant poissons_ratio_0.22 $glass.material.model=ordinary-state $glass.material.poissons_ratio=0.22
variant pull_11 $glass.boundary_conditions.pull_{up,down}.pressure.value="-11 MPa"
variant pull_14 $glass.boundary_conditions.pull_{up,down}.pressure.value="-14 MPa"

# Spacing at a fixed horizon, then horizon of four spacings
variant spacing_0.333 "$glass.spacing=0.3333333333333333 mm" $glass.horizon_ratio=3
variant spacing_0.2 "$glass.spacing=0.2 mm" $glass.horizon_ratio=5
variant horizon_2 "$glass.spacing=0.5 mm"
variant horizon_0.5 "$glass.spacing=0.125 mm"

# The resolution of the test
variant coarse "$glass.spacing=0.5 mm" $glass.horizon_ratio=3
