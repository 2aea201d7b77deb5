#!/usr/bin/env bash
# Measures the claims of docs/validation.md and writes the page: validation/run.sh [--long] [--results FOLDER] [--perimpact PROGRAM] [--update] [TOPIC …]
set -euo pipefail
exec /usr/bin/python3 "$(dirname "$0")/run.py" "$@"
