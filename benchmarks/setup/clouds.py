#!/usr/bin/env python3
"""Times the set-up of point clouds by stage, writes results/setup_<machine>.csv and prints it as a table.

    benchmarks/setup/clouds.py                              about five minutes and 6 GB; nothing else may run meanwhile
    benchmarks/setup/clouds.py --before PROGRAM             alternates with another build: ratios within one run
    benchmarks/setup/clouds.py --edge 50 --rounds 2         smaller: 50 points along each edge

The stages are those of run.json in the fastest round, in wall-clock time, which says little on a busy machine. The processor time is that of the whole run
on all threads: reading the deck, set-up and one step; the least of all rounds. Both programs must end in the same state.
"""

import argparse
import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "benchmarks/plate"), str(ROOT / "benchmarks/memory")]
import memory  # noqa: E402
from programs import machine, write_results  # noqa: E402

STAGES = ("solids and points", "bonds", "surface correction", "time step", "initial forces")
MATERIALS = ("correspondence", "elastic", "state")  # of benchmarks/memory


def run(program, folder, threads):
    """The report of a run of one step, and the processor time of the process [s]."""
    command = [program, "run", "deck.yaml", "--threads", str(threads), "--no-report", "--force", "--set", "time.end=1e-9 s", "--set", "output.frames=0"]
    with subprocess.Popen(command, cwd=folder, stdout=subprocess.DEVNULL, env=os.environ | {"OMP_WAIT_POLICY": "passive"}) as process:
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode != 0:
        sys.exit(f"{program} ended with {process.returncode}")
    return json.loads((folder / "r/run.json").read_text()), usage.ru_utime + usage.ru_stime


def row(material, name, runs, threads, before=()):
    def processor_time(of):
        return min(used for _, used in of)

    best = min((report for report, _ in runs), key=lambda report: sum(report["set_up [s]"].values()))
    stages = best["set_up [s]"]
    cells = {"machine": machine(), "material": material, "program": name, "particles": best["bodies"]["b"]["particles"], "threads": threads, "rounds": len(runs)}
    cells |= {stage + " [s]": f"{stages[stage]:.2f}" for stage in STAGES}
    cells |= {"set-up [s]": f"{sum(stages.values()):.2f}", "processor time of the run [s]": f"{processor_time(runs):.2f}"}
    return cells | {"of that before": f"{processor_time(runs) / processor_time(before):.3f}" if before else ""}


def main():
    arguments = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    arguments.add_argument("--program", type=lambda path: Path(path).resolve(), default=ROOT / "build/release/perimpact")
    arguments.add_argument("--before", type=lambda path: Path(path).resolve())
    arguments.add_argument("--edge", type=int, default=100, help="points along each edge")
    arguments.add_argument("--rounds", type=int, default=2)
    arguments.add_argument("--threads", type=int, default=2)
    given = arguments.parse_args()
    rows = []
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        points = memory.points(folder, 1, given.edge)
        for material in MATERIALS:
            memory.write_deck(folder, 1, lambda *_: points, material, None, "")
            own, others = [], []
            for _ in range(given.rounds):
                own.append(run(given.program, folder, given.threads))
                if given.before:
                    others.append(run(given.before, folder, given.threads))
            if len({report["state_hash"] for report, _ in own + others}) != 1:
                sys.exit(f"{material}: the programs end in different states, so their times are not comparable.")
            if given.before:
                rows.append(row(material, "before", others, given.threads))
            rows.append(row(material, "perimpact", own, given.threads, others))
    write_results("setup", rows)


if __name__ == "__main__":
    main()
