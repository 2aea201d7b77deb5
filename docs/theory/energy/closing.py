#!/usr/bin/python3
"""Energy balance error from the history.csv of runs: python3 closing.py RESULTS_FOLDER...

Prints for each run the works and dissipation of its last row, the largest energy balance error of all rows, and its ratio to the energy
exchanged: the sum of the largest magnitudes of contact's work on impactors and of the works of boundary conditions."""
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[3] / "scripts/results"))
from csv_reader import history  # noqa: E402

for folder in sys.argv[1:]:
    columns = history(folder)
    largest = {name: max(map(abs, values)) for name, values in columns.items()}
    works = [name for name in columns if name.endswith((".contact_work [J]", ".work [J]"))]
    shown = works + [name for name in columns if name.endswith(("fracture_energy [J]", "_dissipation [J]")) or name == "total.energy [J]"]
    print(folder)
    for name in shown:
        print(f"  {name:42} {columns[name][-1]:12.5g}")
    error, work = largest["total.energy_balance_error [J]"], sum(largest[name] for name in works)
    print(f"  {'largest energy balance error [J]':42} {error:12.3g}   {error / work:.1e} of {work:.5g} J")
