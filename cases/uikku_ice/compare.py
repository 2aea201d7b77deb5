#!/usr/bin/python3
"""Measured resistance, formulas and runs: compare.py [RESULTS ...]

RESULTS: folders of runs, each of the deck whose test is in its title. They are measured, and their rows in results.csv are replaced: the mean of F_x on the
ship over the sample, the last metres of travel, with the standard error of block averages of `perimpact statistics`. Then the table of README.md is printed.
"""

import csv
import re

from decks import HERE, ship_in, tests  # which makes ../ship_ice importable
from measure import history, options, records, refuse, report_of, run  # which makes scripts/results importable
from resistance import iso_19906, lindqvist, riska
from long_run import load_statistics, sizes_of_floes

RESULTS = "results.csv"


def runs():
    """Rows of results.csv by the number of the test."""
    return {int(row["test"]): row for row in records(HERE, RESULTS)}


def measure(folder):
    """The row of results.csv of a run."""
    title = report_of(folder)["setup"]["title"]
    number = int((re.search(r"test (\d+)", title) or "00")[1])
    if number not in tests():
        refuse(f"{folder}: its title, {title}, has none of the tests {', '.join(map(str, tests()))}.")
    if ", free" in title:
        refuse(f"{folder} is a run of free.yaml, whose ship has no speed of its own; compare its mean velocity with that of the test.")
    ship, columns = ship_in(tests()[number]), history(folder)
    begin, end, last = ship.sample_begins, ship.ends, columns["time [s]"][-1]
    if last < end - 0.01 * (end - begin):
        refuse(f"{folder} ends at {last:.1f} s, but the sample of test {number} is from {begin:.1f} to {end:.1f} s. Continue it with --resume.")
    force = load_statistics(folder, "ship.force_x", begin, end)
    largest, median = sizes_of_floes(folder)
    return {
        "test": number, "from [s]": f"{begin:.2f}", "to [s]": f"{min(end, last):.2f}", "mean F_x [N]": force["mean"], "standard error [N]": force["standard_error"],
        "standard error is a lower bound": force["standard_error_is_bound"], "standard deviation [N]": force["standard_deviation"],
        "contact work [J]": f"{-columns['ship.contact_work [J]'][-1]:.6g}", "energy balance error [J]": f"{abs(columns['total.energy_balance_error [J]']).max():.4g}",
        "largest floe [m]": f"{largest:.3g}", "median floe by mass [m]": f"{median:.3g}",
    }  # fmt: skip


def measured(folders):
    """results.csv with the rows of these runs in place of those of the same tests."""
    rows = runs()
    for folder in folders:
        row = measure(folder)
        rows[row["test"]] = row
    write_rows(RESULTS, rows)


def write_rows(name, rows):
    """A table of this folder, from its rows by what they are sorted by."""
    with open(HERE / name, "w", newline="", encoding="utf-8") as lines:
        writer = csv.DictWriter(lines, next(iter(rows.values())), lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows[key] for key in sorted(rows))


def cell(row):
    """Mean and standard error [kN]."""
    if row is None:
        return "not run"
    at_least = "at least " if row["standard error is a lower bound"] == "1" else ""
    return f"{float(row['mean F_x [N]']) / 1e3:.0f} ± {at_least}{float(row['standard error [N]']) / 1e3:.0f}"


def main():
    if folders := options(__doc__, nargs="*").parse_args().results:
        measured(folders)
    found = runs()
    print("| test | H [m] | V [m/s] | σ_f [kPa] | σ_c [MPa] | E [MPa] | measured [kN] | run [kN] | Lindqvist | Lindqvist, R_c + R_b | Riska | ISO 19906, breaking |")
    print("|---|---|---|---|---|---|---|---|---|---|---|---|")
    for number, test in tests().items():
        ship = ship_in(test)
        parts = lindqvist(ship)
        formulas = parts["total"], parts["crushing"] + parts["bending"], riska(ship)["total"], iso_19906(ship)["breaking"]
        print(f"| {number} | {ship.thickness:g} | {ship.speed:g} | {test['flexural strength']:g} | {test['compressive strength']:g} | {test['elastic modulus']:g}"
              f" | {test['resistance']:g} | {cell(found.get(number))} | " + " | ".join(f"{force / 1e3:.0f}" for force in formulas) + " |")


if __name__ == "__main__":
    run(main)
