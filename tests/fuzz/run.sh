#!/usr/bin/env bash
# Fuzzes the readers of surface files: tests/fuzz/run.sh [SECONDS [FORMAT…]], 600 seconds each and all formats by default.
# Starts from what the tests write (seeds.cpp) and tests/fuzz/corpus, which it leaves as it is; what it finds goes to build/fuzz/found/<format>/. Ends with an error where a reader
# crashes, hangs for 10 seconds, or takes more than a gigabyte for inputs of at most 16 kB.
set -euo pipefail
cd "$(dirname "$0")/../.."

seconds=${1:-600}
shift || true
formats=("$@")
if ((${#formats[@]} == 0)); then formats=(stl obj ply off vtk vtp msh inp k stl.gz); fi

cmake --preset fuzz >/dev/null
cmake --build --preset fuzz
build/fuzz/tests/fuzz/fuzz_seeds build/fuzz/seeds
failed=()
for format in "${formats[@]}"; do
  found=build/fuzz/found/$format
  mkdir -p "$found/corpus" tests/fuzz/corpus/"$format"
  dictionary=tests/fuzz/dictionaries/$format.dict
  echo "== $format"
  OMP_NUM_THREADS=1 build/fuzz/tests/fuzz/"fuzz_${format//./_}" "$found/corpus" "tests/fuzz/corpus/$format" "build/fuzz/seeds/$format" -max_total_time="$seconds" -max_len=16384 -timeout=10 \
    -rss_limit_mb=1024 -artifact_prefix="$found/" $([[ -f $dictionary ]] && echo "-dict=$dictionary") -print_final_stats=1 >"$found/log" 2>&1 || failed+=("$format")
  grep -E "^(stat::number_of_executed_units|stat::peak_rss_mb|Done|SUMMARY)" "$found/log" || true
done
if ((${#failed[@]} > 0)); then
  echo "error: these readers failed, see build/fuzz/found/<format>/log: ${failed[*]}" >&2
  exit 1
fi
