#!/usr/bin/env python3
"""Times a run with rubble: copies of its folder are resumed and stopped again; writes results/rubble_<machine>.csv and prints it as a table.

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

INTERRUPTED = 130  # exit code of a run that was stopped by SIGINT, with its results
TIMERS = ("contact", "forces", "fragments", "boundary_conditions")


def resumed(program, given):
    """Milliseconds a step of each timer, and the rows of history.csv."""
    with tempfile.TemporaryDirectory() as parent:
        folder = Path(parent) / "run"
        shutil.copytree(given.folder, folder, ignore=shutil.ignore_patterns("run.lock"))
        process = subprocess.Popen(
            [program, "run", given.deck, "--out", folder, "--resume", "--threads", str(given.threads), "--no-report"],
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
        timers = {name: 1e3 * seconds / steps for name, seconds in report["timers [s]"].items()}
        return timers | {"steps": steps}, (folder / "history.csv").read_text(encoding="utf-8").splitlines()


def main():
    arguments = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    arguments.add_argument("deck", type=Path)
    arguments.add_argument("folder", type=Path)
    arguments.add_argument("--program", type=Path, default=ROOT / "build/release/perimpact")
    arguments.add_argument("--before", type=Path, required=True)
    arguments.add_argument("--seconds", type=float, default=30)
    arguments.add_argument("--rounds", type=int, default=3)
    arguments.add_argument("--threads", type=int, default=2)
    given = arguments.parse_args()
    rows = []
    for number in range(1, given.rounds + 1):
        results = {name: resumed(program, given) for name, program in (("before", given.before), ("perimpact", given.program))}
        (before, history_before), (own, history) = results["before"], results["perimpact"]
        common = min(len(history_before), len(history))
        if history_before[:common] != history[:common]:
            sys.exit("The programs differ in history.csv, so their times are not comparable.")
        for name, (timers, _) in results.items():
            total = sum(milliseconds for timer, milliseconds in timers.items() if timer != "steps")
            cells = {"machine": machine(), "case": given.deck.parent.name, "program": name, "threads": given.threads, "round": number,
                     "steps": timers["steps"], "steps/s": f"{1e3 / total:.3g}"}  # fmt: skip
            cells |= {f"{timer} [ms]": f"{timers.get(timer, 0):.2f}" for timer in TIMERS}
            cells["time over before"] = f"{total / sum(ms for timer, ms in before.items() if timer != 'steps'):.3f}" if name == "perimpact" else ""
            rows.append(cells)
    write_results("rubble", rows)


if __name__ == "__main__":
    main()
