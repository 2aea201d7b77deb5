#!/usr/bin/env bash
# Runs and measures the three runs of README.md: cases/submarine_surfacing/variants.sh [RESULTS [PERIMPACT]], as
# scripts/variants.bash describes. Run times: README.md.
set -euo pipefail
source "$(dirname "$0")/../../scripts/variants.bash"

variant given
deck=$case/crushed.yaml variant crushed
deck=$case/crushed.yaml variant free "impactors.submarine.free_dofs=[z]" "impactors.submarine.velocity=[0, 0, 1]" time.end=14 time.step=0.135e-3 bodies.ice.spacing=0.4 \
  bodies.ice.material.layers=3 output.frames=50
