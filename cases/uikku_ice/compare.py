#!/usr/bin/python3
"""Measured resistance, formulas and runs: compare.py [RESULTS ...]

Prints the table of README.md. RESULTS: folders of runs, each of the deck whose test is in its title; their mean is that of F_x on the ship over the last
SAMPLE metres of travel, with the standard error of block averages of `perimpact statistics`.
"""

import csv
import json
import re
import subprocess
import sys
from pathlib import Path

from decks import HERE, sample, ship_in, tests  # which makes ../ship_ice importable
from resistance import iso_19906, lindqvist, riska

PERIMPACT = HERE / "../../build/release/perimpact"
STATISTICS = "statistics.csv"


def run_of(folder):
    """Number of the test, and a cell of the table: mean and standard error [kN], or how far the run has come."""
    report = json.loads((folder / "run.json").read_text(encoding="utf-8"))
    title = report["setup"]["title"]
    if ", free" in title:
        sys.exit(f"{folder} is a run of free.yaml, whose ship has no speed of its own; compare its mean velocity with that of the test.")
    number = int(re.search(r"test (\d+)", title)[1])
    begin = sample(tests()[number]["speed"])
    with open(folder / "history.csv", newline="", encoding="utf-8") as lines:
        end = float(list(csv.DictReader(lines))[-1]["time [s]"])
    if end <= begin:
        return number, f"ends at {end:.1f} s"
    subprocess.run([PERIMPACT, "statistics", folder, "--from", str(begin), "--columns", "ship.force_x"], check=True, stdout=subprocess.DEVNULL)
    with open(folder / STATISTICS, newline="", encoding="utf-8") as lines:
        row = next(csv.DictReader(lines))
    at_least = "at least " if row["standard_error_is_bound"] == "1" else ""
    return number, f"{float(row['mean']) / 1e3:.0f} ± {at_least}{float(row['standard_error']) / 1e3:.0f}"


def main():
    runs = dict(run_of(Path(name)) for name in sys.argv[1:])
    print("| test | H [m] | V [m/s] | σ_f [kPa] | σ_c [MPa] | E [MPa] | measured [kN] | run [kN] | Lindqvist | Lindqvist, R_c + R_b | Riska | ISO 19906, breaking |")
    print("|---|---|---|---|---|---|---|---|---|---|---|---|")
    for number, test in tests().items():
        ship = ship_in(test)
        parts = lindqvist(ship)
        formulas = parts["total"], parts["crushing"] + parts["bending"], riska(ship)["total"], iso_19906(ship)["breaking"]
        print(f"| {number} | {ship.thickness:g} | {ship.speed:g} | {test['flexural strength']:g} | {test['compressive strength']:g} | {test['elastic modulus']:g}"
              f" | {test['resistance']:g} | {runs.get(number, 'not run')} | " + " | ".join(f"{force / 1e3:.0f}" for force in formulas) + " |")


if __name__ == "__main__":
    main()
