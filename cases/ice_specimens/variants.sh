#!/usr/bin/env bash
# Runs and measures the variants of README.md that validation/run.sh ice_specimens does not: cases/ice_specimens/variants.sh [RESULTS [PERIMPACT]], as
# scripts/variants.bash describes. Some ten minutes on a core.
set -euo pipefail
source "$(dirname "$0")/../../scripts/variants.bash"

of() { # name of the variant, deck, settings: results in NAME/DECK, as measure.py reads them
  deck="$case/$2.yaml" measured="$results/$1" variant "$1/$2" "${@:3}"
}

# The dropped sphere with another yield surface, with twice the spacing, and on the whole cylinder of the tests
riska="bodies.ice.material.plasticity={compressive_strength: 7 MPa}"
coarse="bodies.ice.spacing=12.85 mm"
side() { echo "bodies.ice.particle_sets.$1={shape: {box: {size: [$2, $3, 0.2313]}}, position: [$4, $5, 0.01285]}"; }
whole=("bodies.ice.shape={box: {size: [0.6168, 0.6168, 0.257]}}" "bodies.ice.position=[0, 0, -0.1285]"
  "bodies.ice.particle_sets.base={shape: {box: {size: [1, 1, 0.0257]}}, position: [0, 0, -0.11565]}"
  "$(side left 0.0257 1 -0.29555 0)" "$(side right 0.0257 1 0.29555 0)" "$(side front 0.5654 0.0257 0 -0.29555)" "$(side back 0.5654 0.0257 0 0.29555)")
of kierkegaard_coarse drop "$coarse"
of riska drop "$riska"
of riska_coarse drop "$riska" "$coarse"
of riska_whole drop "$riska" "$coarse" "${whole[@]}"

# The sphere of the block in crushable ice; the beam without the correction of its bending stiffness
of crushed indentation "bodies.ice.material.plasticity={compressive_strength: 2.3 MPa, failure_strain: 0.003, failure_pressure: 0.2, failure_width: 3, friction_angle: 30 deg}"
of uncalibrated bending bodies.ice.bending_calibration=none
