#!/usr/bin/python3
"""The sphere's work in confined crushing by time step and friction, over runs whose speeds differ in the sixth digit.

    python3 crushing.py run PROGRAM FOLDER [RUNS]      writes crushing.csv beside this file, a row a run; some ten minutes of one core at 10 runs
    python3 crushing.py                                the means of crushing.csv, each with its standard error
"""
import csv
import json
import pathlib
import statistics
import subprocess
import sys

HERE = pathlib.Path(__file__).parent
TABLE = HERE / "crushing.csv"
STEP = 3.68e-5  # [s] the automatic one, rounded down
COLUMNS = ["friction", "steps of the automatic one", "run", "work [MJ]", "friction work [MJ]", "energy balance error [MJ]"]


def measured(program, folder, friction, divisor, run):
    results = pathlib.Path(folder) / "crushing"
    settings = {"time.step": f"{STEP / divisor} s", "contact.fragments.friction": friction, "impactors.sphere.velocity": f"[0, 0, {-2 * (1 + run * 1e-6)}]",
                "output.folder": results, "output.frames": 1}
    subprocess.run([program, "run", HERE / "crushing.yaml", "--threads", "1", "--force"] + [part for key, value in settings.items() for part in ("--set", f"{key}={value}")],
                   check=True, stdout=subprocess.DEVNULL)
    with open(results / "history.csv") as file:
        rows = list(csv.DictReader(file))
    work = json.loads((results / "run.json").read_text())["impactors"]
    work = (work[0] if isinstance(work, list) else work["sphere"])["constraint_work [J]"]
    closing = max(abs(float(row["total.energy_balance_error [J]"])) for row in rows)
    return [friction, divisor, run] + [f"{1e-6 * value:.6g}" for value in (work, float(rows[-1]["total.friction_dissipation [J]"]), closing)]


def run_all(program, folder, runs):
    with open(TABLE, "w", newline="") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow(COLUMNS)
        for run in range(runs):
            for friction in (0, 0.1):
                for divisor in (1, 2, 4):
                    table.writerow(measured(program, folder, friction, divisor, run))
                    file.flush()


def print_means():
    with open(TABLE) as file:
        rows = list(csv.DictReader(file))
    print("| µ | step | runs | work of the sphere [MJ] | of which friction [MJ] | largest balance error |\n|---|---|---|---|---|---|")
    for friction, divisor in sorted({(row["friction"], row["steps of the automatic one"]) for row in rows}):
        those = [row for row in rows if (row["friction"], row["steps of the automatic one"]) == (friction, divisor)]
        mean = []
        for column in ("work [MJ]", "friction work [MJ]"):
            values = [float(row[column]) for row in those]
            mean.append(f"{statistics.mean(values):.3f} ± {statistics.stdev(values) / len(values) ** 0.5:.3f}")
        closing = max(float(row["energy balance error [MJ]"]) / float(row["work [MJ]"]) for row in those)
        print(f"| {friction} | 1/{divisor} | {len(those)} | {mean[0]} | {mean[1]} | {100 * closing:.3f} % |")


if sys.argv[1:2] == ["run"]:
    run_all(sys.argv[2], sys.argv[3], int(sys.argv[4]) if len(sys.argv) > 4 else 10)
else:
    print_means()
