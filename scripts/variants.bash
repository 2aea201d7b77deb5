# For a case's variants.sh, which sources this: variant NAME [key=value ...] runs the deck with these settings, results in $results/NAME, and measures it.
#   variants.sh [RESULTS [PERIMPACT]]
# Another deck than the case's own: deck=FILE variant NAME …; another folder to be measured, as of a case whose results have the name of their deck: measured=FOLDER variant NAME …
# RESULTS: folder of the results (default: results/<case>); finished variants there are reused.
# PERIMPACT: the program (default: build/release/perimpact, as run.sh builds it).
case=$(cd "$(dirname "$0")" && pwd)
results=${1:-results/$(basename "$case")}
perimpact=${2:-$case/../../build/release/perimpact}

variant() {
  local folder="$results/$1" settings=()
  for setting in "${@:2}"; do settings+=(--set "$setting"); done
  grep -qs '"outcome": "finished"' "$folder/run.json" || nice "$perimpact" run "${deck:-$case/deck.yaml}" --out "$folder" --force "${settings[@]}"
  /usr/bin/python3 "$case/measure.py" "${measured:-$folder}"
}
