"""A run of the plate against expected.csv, row by row.

    check_expected.py EXPECTED FOLDER     # of the results
"""

import csv
import re
import sys

from history import History

SECONDS = {"us": 1e-6}


def seconds(text):
    number, unit = text.split()
    return float(number) * SECONDS[unit]


def values_of(history, quantity):
    """What a row of expected.csv calls a quantity: its unit, and the numbers that must all be as expected."""
    if quantity == "end of contact":
        return "s", [history.end_of_contact()]
    if found := re.fullmatch(r"(\S+) at all times", quantity):
        return history.unit[found[1]], history.column[found[1]]
    if found := re.fullmatch(r"(\S+) largest mean over (.+)", quantity):
        return history.unit[found[1]], [history.largest_mean(found[1], seconds(found[2]))]
    if found := re.fullmatch(r"(\S+)\.displacement_(\w) at (.+)", quantity):
        name, axis, time = found.groups()
        if f"{name}.displacement_{axis}" not in history.column:  # of an impactor, history has the position
            return history.unit[f"{name}.position_{axis}"], [history.moved(f"{name}.position_{axis}", seconds(time))]
    if found := re.fullmatch(r"(\S+) at (.+)", quantity):
        return history.unit[found[1]], [history.at(found[1], seconds(found[2]))]
    raise ValueError(f"expected.csv asks for {quantity!r}, which this check does not understand")


def main():
    history = History(sys.argv[2])
    with open(sys.argv[1], newline="") as file:
        expected = list(csv.DictReader(file))
    assert expected, "expected.csv holds nothing"
    wrong = 0
    for row in expected:
        wanted, tolerance = float(row["value"]), float(row["tolerance"])
        allowed = {"relative": abs(wanted) * tolerance, "absolute": tolerance}[row["relative_or_absolute"]]
        unit, values = values_of(history, row["quantity"])
        assert unit == row["unit"], f"{row['quantity']} is in {unit}, not in {row['unit']}"
        worst = max(values, key=lambda value: abs(value - wanted))
        is_right = all(abs(value - wanted) <= allowed for value in values)  # false for not-a-number
        wrong += not is_right
        print(f"{'    ' if is_right else 'BAD '}{row['quantity']}: {worst:.6g} {unit}, expected {wanted:.6g} within {allowed:.3g} ({row['source']})")
    sys.exit(1 if wrong else 0)


main()
