#!/usr/bin/env bash
# Runs the two rises of README.md, one after the other, and measures them: cases/submarine_surfacing/variants.sh [RESULTS [PERIMPACT]], as
# scripts/variants.bash says. README.md says how long they take.
set -euo pipefail
source "$(dirname "$0")/../../scripts/variants.bash"

variant given
variant free "impactors.submarine.free=[z]" "impactors.submarine.velocity=[0, 0, 1]" time.end=10 bodies.ice.spacing=0.4 time.step=0.2e-3 output.frames=50
