#!/usr/bin/env bash
# Measures what docs/validation.md claims, and writes the page anew: validation/run.sh [--long] [--results FOLDER] [--perimpact PROGRAM] [--update] [TOPIC …]
set -euo pipefail
exec /usr/bin/python3 "$(dirname "$0")/run.py" "$@"
