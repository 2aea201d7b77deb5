#!/usr/bin/env python3
"""Times crossings with two builds of crossing_cost, in turn, and verifies that their contacts are bitwise the same.

    benchmarks/contact/crossings.py BEFORE AFTER      two programs; about five minutes

Writes results/contact_crossings_<machine>.csv: ns per crossing, the least of the rounds. Exit code 1: a contact differs.
"""

import csv
import io
import os
import subprocess
import sys
from pathlib import Path

import report

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "plate"))
from programs import machine, results_file  # noqa: E402

ROUNDS = 3


def rows_of(program, arguments):
    core = max(os.sched_getaffinity(0))  # not the first core, which handles interrupts
    done = subprocess.run([program, *arguments], capture_output=True, text=True, check=True, preexec_fn=lambda: os.sched_setaffinity(0, {core}))
    return list(csv.DictReader(io.StringIO(done.stdout)))


def compared(programs, order, arguments):
    rounds = [[rows_of(program, ["--rounds", "2", *arguments]) for program in programs] for _ in range(ROUNDS)]
    for at, before in enumerate(rounds[0][0]):
        times = [min(float(one[which][at]["ns/crossing"]) for one in rounds) for which in (0, 1)]
        after = rounds[0][1][at]
        yield {
            "machine": machine(),
            "order": order,
            **{key: before[key] for key in ("motion", "radius", "path", "panels", "contacts")},
            "before [ns]": f"{times[0]:.0f}",
            "after [ns]": f"{times[1]:.0f}",
            "triangles before": before["triangles"],
            "triangles after": after["triangles"],
            "contacts are": "the same" if before["hash"] == after["hash"] else "different",
        }


def main():
    programs = sys.argv[1:]
    if len(programs) != 2:
        print(__doc__, file=sys.stderr)
        return 2
    rows = [row for order, arguments in report.ORDERS.items() for row in compared(programs, order, arguments)]
    report.write(rows, results_file("contact_crossings"))
    return any(row["contacts are"] == "different" for row in rows)


if __name__ == "__main__":
    sys.exit(main())
