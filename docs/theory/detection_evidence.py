#!/usr/bin/python3
"""Writes the tables of detection_evidence.md from detection_evidence.csv, so that text and numbers agree.

    detection_table > detection_evidence.csv      (built with the tests; one to two minutes)
    /usr/bin/python3 detection_evidence.py         writes the tables
    /usr/bin/python3 detection_evidence.py --check fails where the page holds others
"""

import csv
import re
import sys
from pathlib import Path

HERE = Path(__file__).parent
PAGE = HERE / "detection_evidence.md"
COUNTS = ("crossings", "found", "past", "invented", "inside", "thrown", "by_eq14", "by_eq15", "by_eq17", "by_eq20")


def read():
    """counts[detector][shape][step][name]"""
    counts = {}
    with open(HERE / "detection_evidence.csv", newline="") as file:
        for row in csv.DictReader(file):
            steps = counts.setdefault(row["detector"], {}).setdefault(row["shape"], {})
            steps[float(row["step"])] = {name: int(row[name]) for name in COUNTS}
    return counts


def total(steps):
    return {name: sum(counts[name] for counts in steps.values()) for name in COUNTS}


def thousands(number):
    return f"{number:,}".replace(",", " ")


def percent(part, whole):
    """Never 100 % where one is missing, never 0 % where one is there."""
    if part in (0, whole):
        return f"{100 * part // max(whole, 1)} %" if whole else "–"
    share = 100 * part / whole
    return "< 0.1 %" if share < 0.05 else "> 99.9 %" if share > 99.95 else f"{share:.1f} %"


def swept_table(counts):
    lines = ["| shape | crossings | found | paths past | false | relocated inside | moved through |", "|---|---|---|---|---|---|---|"]
    for shape in counts["swept"]:
        of = [total(counts[detector][shape]) for detector in ("swept", "swept r = 0.005")]
        cells = [" + ".join(thousands(t[name]) for t in of) for name in ("crossings", "found", "past", "invented", "inside", "thrown")]
        lines.append(f"| {shape} | " + " | ".join(cells) + " |")
    return lines


def share_table(counts):
    steps = list(next(iter(counts["literal"].values())))
    lines = ["| shape | " + " | ".join(f"`{reading}` {step:g}" for reading in ("corrected", "literal") for step in steps) + " |"]
    lines.append("|---" * (1 + 2 * len(steps)) + "|")
    for shape in counts["literal"]:
        rows = [counts[reading][shape][step] for reading in ("corrected", "literal") for step in steps]
        lines.append(f"| {shape} | " + " | ".join(percent(row["found"], row["crossings"]) for row in rows) + " |")
    return lines


def reason_table(counts, reading, equations):
    lines = ["| shape | found | " + " | ".join(f"eq. {equation}" for equation in equations) + " | false | inside | moved through |"]
    lines.append("|---" * (5 + len(equations)) + "|")
    for shape, steps in counts[reading].items():
        t = total(steps)
        cells = [percent(t[name], t["crossings"]) for name in ("found", *(f"by_eq{equation}" for equation in equations))]
        cells += [percent(t["invented"], t["past"]), percent(t["inside"], t["found"]), percent(t["thrown"], t["found"])]
        lines.append(f"| {shape} | " + " | ".join(cells) + " |")
    return lines


def without_eq20_table(counts):
    steps = list(next(iter(counts["literal"].values())))
    lines = ["| shape | " + " | ".join(f"{step:g}" for step in steps) + " |", "|---" * (1 + len(steps)) + "|"]
    for shape in counts["literal"]:
        rows = [counts["literal"][shape][step] for step in steps]
        lines.append(f"| {shape} | " + " | ".join(percent(row["found"] + row["by_eq20"], row["crossings"]) for row in rows) + " |")
    return lines


def write(text, name, lines):
    begin, end = f"<!-- detection_evidence.py: {name} -->", "<!-- end -->"
    assert begin in text, f"{PAGE.name} has no marker for the table {name}"
    pattern = re.compile(re.escape(begin) + ".*?" + re.escape(end), re.DOTALL)
    return pattern.sub(lambda _: "\n".join([begin, *lines, end]), text)


def main():
    counts = read()
    for reading, shapes in counts.items():
        for shape, steps in shapes.items():
            t = total(steps)
            missed = sum(t[name] for name in COUNTS if name.startswith("by_"))
            assert reading.startswith("swept") or t["found"] + missed == t["crossings"], f"{reading}, {shape}: a miss without a reason"
    before = PAGE.read_text()
    text = write(before, "swept", swept_table(counts))
    text = write(text, "share", share_table(counts))
    text = write(text, "corrected", reason_table(counts, "corrected", (14, 15, 17)))
    text = write(text, "literal", reason_table(counts, "literal", (14, 15, 17, 20)))
    text = write(text, "without eq. 20", without_eq20_table(counts))
    if "--check" in sys.argv:
        sys.exit(0 if text == before else f"{PAGE.name} differs from detection_evidence.csv; run detection_evidence.py")
    PAGE.write_text(text)


if __name__ == "__main__":
    main()
