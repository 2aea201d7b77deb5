"""A floating strip of ice against the elastic beam on water: what docs/theory/floating_strip.md measured."""

from rows import Row, Within, read_records
from runner import ROOT

TITLE = "A floating strip of ice breaks by bending"
TABLE = ROOT / "docs/theory/floating_strip.csv"
TABLES = ("/usr/bin/python3 docs/theory/floating_strip.py {perimpact} {results}/floating_strip",)
LONG = True


def gathered():
    def found(test, series, layers, quantity):
        for row in read_records(TABLE):
            if (row["test"], row["series"], int(row["layers"]), row["quantity"]) == (test, series, layers, quantity):
                return float(row["value"])
        raise KeyError(f"{TABLE} holds no {quantity} of {test}, {series}, {layers} layers")

    return {
        "deflection": found("lift", "plate", 6, "edge deflection") - 1,
        "moment": found("lift", "plate", 6, "largest moment") - 1,
        "stiffness, 12 layers": found("lift", "plate", 12, "bending stiffness") - 1,
        "breaks": found("ramp", "plate", 6, "first bond over theory") - 1,
        "breaks, calibrated": found("ramp", "plate, calibrated", 4, "first bond over theory") - 1,
        "distance": found("ramp", "plate", 6, "distance [m]"),
    }


def text(n):
    return """Ice afloat with a load on its free edge: Hetényi's beam on an elastic foundation is exact for it
([floating strip](theory/floating_strip.md), with fewer and more layers). Six minutes a strip of six layers."""


def rows():
    theory = "M. Hetényi, *Beams on Elastic Foundation* (1946)"
    return [
        Row("deflection of the edge, 6 layers", theory, "deflection", "%", Within(0, 0.03), "the sheet bends 7 % too easily at 6 layers (second order); deflections go as the power −¼ of that: 1.8 %"),
        Row("largest moment, 6 layers", theory, "moment", "%", Within(0, 0.03), "as its power ¼"),
        Row("bending stiffness, 12 layers", theory, "stiffness, 12 layers", "%", Within(0, 0.02), "second order from 7 % at 6 layers, and strips four particles across are up to 2 % stiffer than wide sheets"),
        Row("load at which it breaks, 6 layers", theory, "breaks", "%", Within(0, 0.07), "as the power ¾ of the stiffness, 5 %, and a row of history"),
        Row("the same, 4 layers with `bending_calibration`", theory, "breaks, calibrated", "%", Within(0, 0.05), "calibrated for a wide sheet; narrow strips are 2 to 6 % stiffer"),
        Row("where it breaks, from the edge", theory + ": 20.98 m", "distance", "m", Within(20.98, 3), "the moment is within 1 % of its largest value over ± 2.7 m, and a section is 0.33 m"),
    ]  # fmt: skip
