#!/usr/bin/env python3
"""Times the beginning of the ice cases and of the plate on one core, writes results/ice_<machine>.csv and prints it as a table.

    benchmarks/ice/steps.py                          on an idle machine
    benchmarks/ice/steps.py --before PROGRAM         alternates with another build, ten minutes: ratios within one run

Results are those of the fastest round, from the timers of run.json; the final states of both programs must be identical.
"""

import argparse
import json
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "benchmarks/plate"))
from programs import machine, write_results  # noqa: E402

CASES = {  # deck, and simulated time
    "ship": ("ship_ice/deck.yaml", "time.end=0.5 s"),
    "propeller": ("propeller_ice/deck.yaml", "time.end=40 ms"),
    "submarine": ("submarine_surfacing/deck.yaml", "time.end=0.2 s"),
    "uikku": ("uikku_ice/deck.yaml", "time.end=0.1 s"),
    "plate": ("plate_impact/deck.yaml", "time.end=10 us"),
}
TIMERS = ("contact", "forces", "fragments", "boundary_conditions")


def run(program, case):
    deck, end = CASES[case]
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run(
            [program, "run", ROOT / "cases" / deck, "--threads", "1", "--out", folder, "--force", "--set", end, "--set", "output.frames=0"],
            check=True, stdout=subprocess.DEVNULL,
        )  # fmt: skip
        return json.loads((Path(folder) / "run.json").read_text())


def seconds(report):
    return sum(report["timers [s]"].values())


def row(case, program, reports, before=()):
    best = min(reports, key=seconds)
    cells = {"machine": machine(), "case": case, "program": program, "particles": sum(body["particles"] for body in best["bodies"].values()),
             "steps": best["steps"], "rounds": len(reports), "steps/s": f"{best['steps'] / seconds(best):.4g}"}  # fmt: skip
    cells |= {name: f"{best['timers [s]'].get(name, 0) / seconds(best):.3f}" for name in TIMERS}
    return cells | {"of the time before": f"{seconds(best) / min(map(seconds, before)):.3f}" if before else ""}


def main():
    arguments = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    arguments.add_argument("--program", type=Path, default=ROOT / "build/release/perimpact")
    arguments.add_argument("--before", type=Path)
    arguments.add_argument("--rounds", type=int, default=3)
    arguments.add_argument("--cases", nargs="+", choices=CASES, default=list(CASES))
    arguments.add_argument("--results", default="ice", help="the file is results/RESULTS_<machine>.csv")
    given = arguments.parse_args()
    rows = []
    for case in given.cases:
        own, others = [], []
        for _ in range(given.rounds):
            own.append(run(given.program, case))
            if given.before:
                others.append(run(given.before, case))
        if len({report["state_hash"] for report in own + others}) != 1:
            sys.exit(f"{case}: the programs end in different states, so their times are not comparable.")
        if given.before:
            rows.append(row(case, "before", others))
        rows.append(row(case, "perimpact", own, others))
    write_results(given.results, rows)


if __name__ == "__main__":
    main()
