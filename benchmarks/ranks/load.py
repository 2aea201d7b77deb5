#!/usr/bin/env python3
"""What it gains that bodies are divided by measured load when a run of several processes (ranks) resumes.

    benchmarks/ranks/load.py        a minute on an idle machine: writes results/ranks_load_<machine>.csv

The plate of cases/plate_impact with a cut-out of 160 mm by 45 mm in the side away from the cylinder: of two equal boxes of cells one is mostly empty. Two ranks of one thread run a
number of steps from the beginning, divided by cells, and as many after resuming, divided by the times of the first part. Medians over the rounds. Exit code 1:
the state differs from that of one process.
"""

import argparse
import csv
import json
import os
import statistics
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.append(str(ROOT / "benchmarks/plate"))
import programs  # noqa: E402

WORDS = {
    "time.step": "0.1 us", "output.frames": 0, "output.history_interval": "10 us", "output.checkpoint_interval": 0, "output.lines": "{}",
    "bodies.plate.holes": "{cut: {shape: {box: {size: [160 mm, 50 mm, 20 mm]}}, position: [0, -30 mm, 0]}}",
}  # fmt: skip


def run(arguments, folder, ranks, steps, cores, *more):
    words = [word for key, value in (WORDS | {"time.end": f"{0.1 * steps:g} us"}).items() for word in ("--set", f"{key}={value}")]
    command = [arguments.build / "perimpact", "run", programs.DECK, "--out", f"{folder}/{ranks}", "--threads", "1", "--no-report", *words, *more]
    programs.run(programs.mpirun(ranks) + command, cores, programs.AS_ROOT)
    report = json.loads(Path(f"{folder}/{ranks}/run.json").read_text())
    first = (report.get("resumed_at_steps") or [0])[-1]
    return {"ms/step": 1e3 * sum(report["timers [s]"].values()) / (report["steps"] - first), "imbalance": report.get("communication", {}).get("imbalance"),
            "hash": report["state_hash"], "particles": report["bodies"]["plate"]["particles"]}  # fmt: skip


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=Path, default=ROOT / "build/release", help="build folder (default: build/release)")
    parser.add_argument("--rounds", type=int, default=5, help="number of rounds (default 5)")
    parser.add_argument("--steps", type=int, default=300, help="steps of each part (default 300)")
    arguments = parser.parse_args()
    arguments.build = arguments.build.resolve()
    cores = set(sorted(os.sched_getaffinity(0), reverse=True)[:2])
    rounds = []
    for _ in range(arguments.rounds):
        load = os.getloadavg()[0]
        with tempfile.TemporaryDirectory() as folder:
            by_cells = run(arguments, folder, 2, arguments.steps, cores)
            by_load = run(arguments, folder, 2, 2 * arguments.steps, cores, "--resume")
            one = run(arguments, folder, 1, 2 * arguments.steps, cores)
        rounds.append({"load_before": load, "ms/step by cells": by_cells["ms/step"], "ms/step by load": by_load["ms/step"], "imbalance by cells": by_cells["imbalance"],
                       "imbalance by load": by_load["imbalance"], "gain": by_cells["ms/step"] / by_load["ms/step"], "two ranks against one": one["ms/step"] / by_load["ms/step"]})  # fmt: skip
        print({key: round(value, 3) for key, value in rounds[-1].items()}, flush=True)
        if by_load["hash"] != one["hash"]:
            print("the state of two ranks differs from that of one", file=sys.stderr)
            return 1
    table = [{"machine": programs.machine(), "particles": one["particles"], "rounds": len(rounds)} |
             {f"{key}{end}": f"{of([one_round[key] for one_round in rounds]):.4g}" for key in rounds[0] for end, of in (("", statistics.median), ("_min", min), ("_max", max))}]  # fmt: skip
    programs.write_results("ranks_load", table)
    return 0


if __name__ == "__main__":
    programs.exit_with(main)
