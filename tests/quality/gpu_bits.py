"""Kernels for GPUs call no function of <bit> but popcount(): nvcc compiles the others without an error, since they are constexpr, but to wrong code, as their
builtins are of the host. Nothing else shows it where there is no GPU.

    gpu_bits.py SOURCES
"""

import re
import sys
from pathlib import Path

CALL = re.compile(r"std::(count[lr]_(?:zero|one)|bit_(?:width|ceil|floor)|rot[lr])|__builtin_c[lt]z")


def faults_of(file, name):
    lines = file.read_text(encoding="utf-8").splitlines()
    for number, line in enumerate(lines):
        if not CALL.search(line.split("//")[0]):
            continue
        # the definition around it: the nearest line before that is indented less
        indent = len(line) - len(line.lstrip())
        start = next((n for n in range(number, -1, -1) if lines[n].strip() and len(lines[n]) - len(lines[n].lstrip()) < indent), number)
        while start > 0 and (lines[start].startswith(" ") or not re.search(r"\w\(", lines[start])):
            start -= 1
        if "FCCDA_HD" in lines[start] or "FCCDA_HD" in line:
            yield f"{name}:{number + 1}: {CALL.search(line)[0]} in a function for GPUs, for which nvcc compiles it to wrong code"


def main():
    root = Path(sys.argv[1])
    faults = [fault for file in sorted(root.rglob("*.hpp")) if "FCCDA_HD" in file.read_text(encoding="utf-8") for fault in faults_of(file, file.relative_to(root))]
    if faults:
        print(*faults, sep="\n")
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
