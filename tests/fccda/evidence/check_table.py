"""Checks the numbers recorded in docs/theory/detection_evidence.csv against the program.

    check_table.py DETECTION_TABLE CSV

For swept exactly: everything found, nothing else. For the detector of Zhang et al. within 3 % of the crossings: another standard library
draws other paths from the same seed, and shares of 5000 then scatter by up to 0.7 %; 3 % is four times that.
"""

import csv
import io
import subprocess
import sys


def rows(text):
    return {(row["shape"], row["step"], row["detector"]): row for row in csv.DictReader(io.StringIO(text))}


def main():
    program, kept_file = sys.argv[1:]
    counted = rows(subprocess.run([program], check=True, capture_output=True, text=True).stdout)
    with open(kept_file, newline="") as file:
        kept = rows(file.read())
    assert counted.keys() == kept.keys() and len(counted) == 160
    faults = []
    for which, row in counted.items():
        crossings = int(row["crossings"])
        if which[2].startswith("swept"):
            expected = {"found": crossings, "invented": 0, "inside": 0, "thrown": 0}
            faults += [f"{which}: {name} is {row[name]}, not {value}" for name, value in expected.items() if int(row[name]) != value]
        for name, value in row.items():
            if name not in ("shape", "step", "detector") and abs(int(value) - int(kept[which][name])) > 0.03 * crossings:
                faults.append(f"{which}: {name} is {value}, recorded is {kept[which][name]}")
    print("\n".join(faults))
    sys.exit(1 if faults else 0)


main()
