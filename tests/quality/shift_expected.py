"""Sees every comparison of floating-point numbers fail (tests/fixtures/tolerance.hpp).

    shift_expected.py ROOT PROGRAM…            runs the test programs with every expected value moved by twice its tolerance
    shift_expected.py ROOT PROGRAM… --list     also runs them as they are, and lists what each comparison expected and found

Each `== fixtures::relative(…)` and `== fixtures::absolute(…)` of the sources must then be red, each time it is made. One that is not is named: it
is never reached, stands where its failure is not noticed, or has a tolerance below the rounding of its value. Ends with 0 only if there is none.
"""

import csv
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

USE = re.compile(r"\bfixtures::(?:relative|absolute)\(")
ASSERTION = re.compile(r"\b((?:DOCTEST_)?(?:CHECK|REQUIRE|WARN)\w*)\(")
SKIPPED = re.compile(r'//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])\'', re.DOTALL)
FAILED = re.compile(r"^(.+?)[:(](\d+)\)?: (?:FATAL )?ERROR: ([A-Z_]+)\(")


def code_of(path):
    """The text without comments, strings and characters, each replaced by blanks: lines and columns stay."""
    return SKIPPED.sub(lambda found: re.sub(r"[^\n]", " ", found[0]), path.read_text())


def end_of(code, opening):
    """Where the parenthesis at `opening` closes."""
    depth = 0
    for place in range(opening, len(code)):
        depth += {"(": 1, ")": -1}.get(code[place], 0)
        if depth == 0:
            return place
    return len(code)


def place_of(path):
    """tests/io/…: compilers name files by the path they were called with, which a compiler cache changes."""
    return "tests/" + path.rpartition("/tests/")[2]


def comparisons_in(root):
    """(file, first line, last line) of each comparison, and what is wrong with how it is written."""
    found, faults = [], []
    for path in sorted((root / "tests").rglob("*.?pp")):
        if path.name == "tolerance.hpp":
            continue
        code = code_of(path)
        line = lambda place: code.count("\n", 0, place) + 1
        assertions = [(one.start(), end_of(code, one.end() - 1), one[1]) for one in ASSERTION.finditer(code)]
        for use in USE.finditer(code):
            around = [one for one in assertions if one[0] < use.start() < one[1]]
            place = f"{place_of(str(path))}:{line(use.start())}"
            if not around:
                faults.append(f"{place}: stands in no CHECK")
            elif around[-1][2] != "CHECK":
                faults.append(f"{place}: stands in {around[-1][2]}; it must be a CHECK")
            else:
                found.append((place_of(str(path)), line(around[-1][0]), line(around[-1][1])))
    for one in sorted({one for one in found if found.count(one) > 1}):
        faults.append(f"{one[0]}:{one[1]}: two comparisons on one line")
    return found, faults


def run(program, shifted):
    """The rows that the program records of its comparisons, and (file, line) of each CHECK that failed, as often as it did."""
    with tempfile.TemporaryDirectory() as folder:
        record = Path(folder) / "comparisons.csv"
        environment = {**os.environ, "PERIMPACT_COMPARISONS": str(record), "OMP_WAIT_POLICY": "passive"}
        if shifted:
            environment["PERIMPACT_SHIFT_EXPECTED"] = "1"
        failed = []
        process = subprocess.Popen([program, "--no-colors=true"], cwd=folder, env=environment, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, errors="replace")
        for text in process.stdout:
            if one := FAILED.match(text):
                failed.append((place_of(one[1]), int(one[2])))
        process.wait()
        if process.returncode < 0 or not record.exists():
            sys.exit(f"{program} ended with {process.returncode} and left no record of its comparisons")
        with open(record, newline="") as file:
            return [row | {"file": place_of(row["file"])} for row in csv.DictReader(file)], failed


def list_comparisons(rows):
    """Of each place: how often, what was expected, the tolerance, and the largest deviation in tolerances."""
    for row in rows:
        expected = row["smallest"] if row["smallest"] == row["largest"] else f"{row['smallest']} … {row['largest']}"
        tolerance = f"{row['tolerance']} {row['unit']}" if row["kind"] == "absolute" else f"{row['tolerance']} of it"
        print(f"{row['file']}:{row['line']}: {row['made']} times, expected {expected} within {tolerance}, off by {row['deviation']} of that")


def main():
    is_list = "--list" in sys.argv
    root, *programs = (argument for argument in sys.argv[1:] if argument != "--list")
    root = Path(root).resolve()
    comparisons, faults = comparisons_in(root)
    rows, failed = [], []
    for program in map(os.path.abspath, programs):
        if is_list:
            list_comparisons(run(program, False)[0])
        rows_here, failed_here = run(program, True)
        rows += rows_here
        failed += failed_here
    made_in_all = 0
    for file, first, last in comparisons:
        here = [row for row in rows if row["file"] == file and first <= int(row["line"]) <= last]
        made, equal = sum(int(row["made"]) for row in here), sum(int(row["equal"]) for row in here)
        red = sum(1 for place, line in failed if place == file and first <= line <= last)
        made_in_all += made
        name = f"{file}:{first}"
        if made == 0:
            faults.append(f"{name}: never made")
        elif equal or red < made:
            faults.append(f"{name}: made {made} times, red {red} times")
    print("\n".join(faults))
    print(f"{len(comparisons)} comparisons, made {made_in_all} times; {len(faults)} did not go red, or are written otherwise than they should be")
    sys.exit(1 if faults or not comparisons else 0)


if __name__ == "__main__":
    main()
