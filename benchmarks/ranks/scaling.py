#!/usr/bin/env python3
"""Two processes (ranks) against one on this machine, perimpact and LAMMPS PERI alternately; bytes sent, beside those of `perimpact check --ranks`.

    benchmarks/ranks/scaling.py                about five minutes on an idle machine: writes results/ranks_<machine>.csv

strong: the plate of cases/plate_impact on one and on two ranks of one thread. weak: on two ranks a plate twice as long. Each round runs every variant once;
speeds are compared within a round, and the results are medians over the rounds, with minimum and maximum. The load of the machine before each round is
recorded: on a machine that is shared the ratios say less. Exit code 1: bytes differ from the forecast. 2: something is missing.
"""

import argparse
import json
import os
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.append(str(ROOT / "benchmarks/plate"))
import programs  # noqa: E402

STYLES = {"pmb": 0.25, "lps": 0.3}  # of LAMMPS: Poisson's ratio
LENGTH = 0.2  # [m] of the plate


def words(nu, steps, length):
    """Changes of the deck: the family of LAMMPS, bonds that could break, and nothing written during the steps."""
    return programs.changes({
        "time.step": "0.1 us", "time.end": f"{0.1 * steps:g} us", "output.frames": 0, "output.history_interval": f"{0.1 * steps:g} us",
        "output.checkpoint_interval": 0, "bodies.plate.family": "madenci-oterkus", "bodies.plate.material.poissons_ratio": nu,
        "bodies.plate.material.critical_stretch": 0.5, "bodies.plate.shape.box.size": f"[{length}, 0.1, 0.009]",
    })  # fmt: skip


def perimpact(program, nu, steps, ranks, cores, length):
    """Steps per second of the slowest rank's loop over steps, and what the ranks sent."""
    with tempfile.TemporaryDirectory() as folder:
        run = [program, "run", programs.DECK, "--out", f"{folder}/r", "--threads", "1", "--no-report", *words(nu, steps, length)]
        programs.run(programs.mpirun(ranks) + run, cores, programs.AS_ROOT)
        report = json.loads(Path(f"{folder}/r/run.json").read_text())
    seconds = sum(report["timers [s]"].values())
    return {"steps/s": steps / seconds, "hash": report["state_hash"], "communication": report.get("communication", {}), "particles": report["bodies"]["plate"]["particles"]}


def forecast(program, nu, steps, ranks, length):
    command = [program, "check", programs.DECK, "--ranks", str(ranks), "--json", *words(nu, steps, length)]
    done = subprocess.run(command, capture_output=True, text=True, check=True, cwd=tempfile.gettempdir())
    return json.loads(done.stdout)["ranks"]


def variants():
    for nu in STYLES.values():
        yield "perimpact", nu, 1, LENGTH
        yield "perimpact", nu, 2, LENGTH
        yield "perimpact", nu, 2, 2 * LENGTH
    for style in STYLES:
        yield f"LAMMPS peri/{style}", STYLES[style], 1, LENGTH
        yield f"LAMMPS peri/{style}", STYLES[style], 2, LENGTH


def measure(variant, arguments, cores):
    program, nu, ranks, length = variant
    if program == "perimpact":
        return perimpact(arguments.build / "perimpact", nu, arguments.steps, ranks, cores, length)
    style = program.rpartition("/")[2]
    one = programs.lammps(style, arguments.lammps_steps, cores, ranks)
    return {"steps/s": float(one["steps/s"]), "particles": int(one["particles"]), "communication": {}}


def spread(values):
    return {"": f"{statistics.median(values):.4g}", "_min": f"{min(values):.4g}", "_max": f"{max(values):.4g}"}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=Path, default=ROOT / "build/release", help="build folder (default: build/release)")
    parser.add_argument("--rounds", type=int, default=3, help="number of rounds (default 3)")
    parser.add_argument("--steps", type=int, default=100, help="steps of perimpact (default 100)")
    parser.add_argument("--lammps-steps", type=int, default=12, help="timed steps of LAMMPS (default 12)")
    arguments = parser.parse_args()
    arguments.build = arguments.build.resolve()
    cores = set(sorted(os.sched_getaffinity(0), reverse=True)[:2])
    order, rounds, loads = list(variants()), [], []
    for number in range(arguments.rounds):
        loads.append(os.getloadavg()[0])
        rounds.append({variant: measure(variant, arguments, cores) for variant in order})
        for variant in order:
            print(f"round {number + 1}  {str(variant):<50}{rounds[-1][variant]['steps/s']:8.3f} steps/s, load {loads[-1]:.2f}", flush=True)

    rows, failed = [], False
    for variant in order:
        program, nu, ranks, length = variant
        kind = "weak" if length > LENGTH else "strong"
        speeds = [measured[variant]["steps/s"] for measured in rounds]
        one = (program, nu, 1, LENGTH)
        ratios = [measured[variant]["steps/s"] / measured[one]["steps/s"] for measured in rounds]
        row = {"machine": programs.machine(), "program": program, "nu": nu, "scaling": kind if ranks > 1 else "", "ranks": ranks,
               "particles": rounds[0][variant]["particles"], "rounds": len(rounds), "load_before": f"{statistics.median(loads):.2f}"}  # fmt: skip
        row |= {f"steps/s{end}": text for end, text in spread(speeds).items()}
        row |= {f"against_one{end}": text if ranks > 1 else "" for end, text in spread(ratios).items()}
        row |= {"bytes/step": "", "forecast_bytes/step": "", "imbalance": "", "waiting": ""}
        if program == "perimpact" and ranks > 1:
            sent = rounds[0][variant]["communication"]
            told = forecast(arguments.build / "perimpact", nu, arguments.steps, ranks, length)
            shares = [measured[variant]["communication"]["waiting [s]"] * measured[variant]["steps/s"] / arguments.steps for measured in rounds]
            row |= {"bytes/step": f"{sent['largest_sent [byte]'] / arguments.steps:g}", "forecast_bytes/step": told["sent [byte]"],
                    "imbalance": f"{statistics.median(measured[variant]['communication']['imbalance'] for measured in rounds):.3f}",
                    "waiting": f"{statistics.median(shares):.3f}"}  # fmt: skip
            failed = failed or sent["largest_sent [byte]"] != arguments.steps * told["sent [byte]"]
            hashes = {measured[one]["hash"] for measured in rounds} | {measured[variant]["hash"] for measured in rounds} if kind == "strong" else {0}
            if len(hashes) > 1:
                raise programs.CannotRun(f"The state differs between ranks: {sorted(hashes)}")
        rows.append(row)
    programs.write_results("ranks", rows)
    if failed:
        print("NOT MET: the bytes sent differ from the forecast", file=sys.stderr)
    return 1 if failed else 0


if __name__ == "__main__":
    programs.exit_with(main)
