#!/usr/bin/python3
"""How far the balance of energy is from closing, from the history.csv of runs: python3 closing.py RESULTS_FOLDER...

Prints of each run the works and losses of its last row, the largest closing error of all rows, and that over the energy that changed
hands: the sum of the largest magnitudes of contact's work on impactors and of the works of boundaries."""
import csv
import sys


def columns(folder):
    with open(f"{folder}/history.csv") as file:
        rows = list(csv.DictReader(file))
    return {name: [float(row[name]) for row in rows] for name in rows[0]}


for folder in sys.argv[1:]:
    history = columns(folder)
    largest = {name: max(map(abs, values)) for name, values in history.items()}
    works = [name for name in history if name.endswith((".contact_work [J]", ".work [J]"))]
    told = works + [name for name in history if name.endswith("fracture_energy [J]") or "loss" in name or name == "total.energy [J]"]
    print(folder)
    for name in told:
        print(f"  {name:42} {history[name][-1]:12.5g}")
    error, work = largest["total.energy_balance_error [J]"], sum(largest[name] for name in works)
    print(f"  {'largest closing error [J]':42} {error:12.3g}   {error / work:.1e} of {work:.5g} J")
