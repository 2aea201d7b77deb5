#!/usr/bin/env python3
"""Times contact detection by method, its queries against CGAL and Embree, its share of a run against an impactor of particles, deforming surfaces, and single crossings.

    benchmarks/contact/measure.py               about twenty minutes; nothing else may run meanwhile
    benchmarks/contact/measure.py --only cost   one of cost, queries, share, deforming, crossing
    benchmarks/contact/measure.py --tables      no measurement: rewrites tables and figure

Writes results/contact_{cost,queries,share,deforming,crossing}_<machine>.csv, the tables of README.md and docs/theory/figures/contact_cost.png. Exit code 1:
a claim is not met. 2: something is missing.
"""

import argparse
import csv
import io
import os
import subprocess
import sys
from pathlib import Path

import report

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "benchmarks/plate"))
from programs import machine, results_file  # noqa: E402

PARTICLES = ["1e4", "1e5", "1e6", "1e7"]
PANELS = ["1e2", "1e3", "1e4", "1e5", "1e6"]
QUERY_PANELS = ["1e3", "1e4", "1e5", "1e6"]


def rows_of(build, program, *arguments):
    """The CSV output of a program, run on one core, as dicts."""
    path = build / program
    if not path.exists():
        print(f"error: {path} does not exist; README.md describes how to build it.", file=sys.stderr)
        sys.exit(2)
    core = max(os.sched_getaffinity(0))  # not the first core, which handles interrupts
    done = subprocess.run(
        [path, *map(str, arguments)], capture_output=True, text=True, check=True, preexec_fn=lambda: os.sched_setaffinity(0, {core})
    )
    return list(csv.DictReader(io.StringIO(done.stdout)))


def cost(build):
    rows = []

    def run(*arguments):
        rows.extend(rows_of(build, "contact_cost", *arguments))
        for row in rows[-4:]:
            print("  ".join(f"{value:>12}" for value in row.values()), flush=True)

    for panels in PANELS:
        for particles in PARTICLES:
            run("--particles", particles, "--panels", panels)
    for scene in ("paper", "debris"):
        run("--particles", "1.112e6", "--panels", "2e5", "--scene", scene, "--swept-alone")  # a million after removal of the points inside the hull
    return rows


def queries(build):
    rows = []
    for panels in QUERY_PANELS:
        rows += rows_of(build, "contact_queries", "--panels", panels)
        print(f"queries with {panels} panels done", flush=True)
    return rows


def share(build):
    return rows_of(build, "contact_share", ROOT / "cases/plate_impact/deck.yaml")


def deforming(build):
    return rows_of(build, "contact_deforming")


def crossing(build):
    rows = []
    for order, arguments in report.ORDERS.items():
        rows += [{"order": order, **row} for row in rows_of(build, "crossing_cost", *arguments)]
        print(f"crossings in the order {order} done", flush=True)
    return rows


KINDS = {"cost": cost, "queries": queries, "share": share, "deforming": deforming, "crossing": crossing}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=Path, default=ROOT / "build/release", help="build folder (default: build/release)")
    parser.add_argument("--only", choices=KINDS, help="one kind of measurement")
    parser.add_argument("--tables", action="store_true", help="write tables and figure from the CSV files without measuring")
    arguments = parser.parse_args()
    if not arguments.tables:
        for kind in [arguments.only] if arguments.only else KINDS:
            rows = [{"machine": machine(), **row} for row in KINDS[kind](arguments.build.resolve())]
            report.write(rows, results_file(f"contact_{kind}"))
    report.update_readme()
    report.draw(ROOT / "docs/theory/figures/contact_cost.png")
    claims = report.claims()
    for what, wanted, shown, met in claims:
        print(f"{'met    ' if met else 'NOT MET'} {what}: {shown}, wanted {wanted}")
    return 0 if all(met for *_, met in claims) else 1


if __name__ == "__main__":
    sys.exit(main())
