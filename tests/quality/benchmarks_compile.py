"""The sources of the benchmarks compile, without being translated: that would take several times as long.

    benchmarks_compile.py BUILD        configured with -DPERIMPACT_BENCHMARKS=ON
"""

import json
import os
import shlex
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

FOLDER = Path(__file__).resolve().parents[2] / "benchmarks"


def check(entry):
    words = shlex.split(entry["command"])
    at = words.index("-o")
    done = subprocess.run([*words[:at], *words[at + 2 :], "-fsyntax-only"], cwd=entry["directory"], capture_output=True, text=True)
    return done.returncode, done.stderr


def main():
    commands = json.loads((Path(sys.argv[1]) / "compile_commands.json").read_text())
    ours = [entry for entry in commands if FOLDER in Path(entry["file"]).parents]
    if not ours:
        sys.exit(f"{sys.argv[1]} is not configured with -DPERIMPACT_BENCHMARKS=ON")
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        found = list(pool.map(check, ours))
    for code, text in found:
        if code:
            print(text, file=sys.stderr)
    print(f"{len(ours)} sources of benchmarks, {sum(code != 0 for code, _ in found)} of which do not compile")
    sys.exit(any(code for code, _ in found))


main()
