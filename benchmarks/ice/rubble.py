#!/usr/bin/env python3
"""Times a run with rubble: copies of its folder are resumed and stopped again; writes results/<name>_<machine>.csv and prints it as a table.

    benchmarks/ice/rubble.py DECK FOLDER --before PROGRAM       FOLDER: results of the deck, of a run that was stopped among rubble

Both programs alternate from the same checkpoint, and the rows of history.csv that both have reached must be identical. Milliseconds a step, by the
timers of run.json, each round a row: where other programs run on the machine, only ratios within a round are comparable.
"""

import argparse
import json
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "benchmarks/plate"))
from programs import machine, write_results  # noqa: E402
from steps import TIMERS, seconds  # noqa: E402

INTERRUPTED = 130  # exit code of a run that was stopped by SIGINT, with its results


def resumed(program, given):
    """Number of steps, run.json, and the rows of history.csv."""
    with tempfile.TemporaryDirectory() as parent:
        folder = Path(parent) / "run"
        shutil.copytree(given.folder, folder, ignore=shutil.ignore_patterns("run.lock"))
        process = subprocess.Popen(
            [program, "run", given.deck, "--out", folder, "--resume", "--threads", str(given.threads), "--no-report", *(word for value in given.set for word in ("--set", value))],
            stdout=subprocess.PIPE, text=True,
        )  # fmt: skip
        time.sleep(given.seconds)
        process.send_signal(signal.SIGINT)
        process.communicate()
        if process.returncode not in (0, INTERRUPTED):
            sys.exit(f"{program} ended with exit code {process.returncode}.")
        report = json.loads((folder / "run.json").read_text(encoding="utf-8"))
        steps = report["steps"] - report["resumed_at_steps"][-1]
        if steps <= 0:
            sys.exit(f"{program} made no step in {given.seconds} s.")
        return steps, report, (folder / "history.csv").read_text(encoding="utf-8").splitlines()


def main():
    arguments = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    arguments.add_argument("deck", type=Path)
    arguments.add_argument("folder", type=Path)
    arguments.add_argument("--program", type=Path, default=ROOT / "build/release/perimpact")
    arguments.add_argument("--before", type=Path, required=True)
    arguments.add_argument("--seconds", type=float, default=30)
    arguments.add_argument("--rounds", type=int, default=3)
    arguments.add_argument("--threads", type=int, default=2)
    arguments.add_argument("--results", default="rubble", help="name of the file of results")
    arguments.add_argument("--set", action="append", default=[], metavar="KEY=VALUE", help="of the run, as perimpact run has it")
    given = arguments.parse_args()
    rows = []
    for number in range(1, given.rounds + 1):
        results = {name: resumed(program, given) for name, program in (("before", given.before), ("perimpact", given.program))}
        histories = [history for _, _, history in results.values()]
        if any(len(set(rows_of_step)) > 1 for rows_of_step in zip(*histories)):
            sys.exit("The programs differ in history.csv, so their times are not comparable.")
        each = {name: 1e3 * seconds(report) / steps for name, (steps, report, _) in results.items()}  # [ms] a step
        for name, (steps, report, _) in results.items():
            cells = {"machine": machine(), "case": f"{given.deck.parent.name}/{given.deck.stem}", "program": name, "threads": given.threads, "round": number,
                     "steps": steps, "steps/s": f"{1e3 / each[name]:.3g}"}  # fmt: skip
            cells |= {f"{timer} [ms]": f"{1e3 * report['timers [s]'].get(timer, 0) / steps:.2f}" for timer in TIMERS}
            cells["time over before"] = f"{each[name] / each['before']:.3f}" if name == "perimpact" else ""
            rows.append(cells)
    write_results(given.results, rows)


if __name__ == "__main__":
    main()
