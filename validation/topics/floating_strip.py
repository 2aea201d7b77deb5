"""A floating ice strip against the beam on an elastic foundation: the results of docs/theory/floating_strip.md."""

from rows import Row, Within, read_records
from runner import ROOT

TITLE = "Bending failure of a floating ice strip"
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
    return """Floating ice with a load on its free edge. Hetényi's beam on an elastic foundation is the exact solution.
Fewer and more layers: [floating strip](theory/floating_strip.md). A strip of six layers takes six minutes."""


def rows():
    theory = "M. Hetényi, *Beams on Elastic Foundation* (1946)"
    return [
        Row("deflection of the edge, 6 layers", theory, "deflection", "%", Within(0, 0.03), "the bending stiffness is 7 % too small at 6 layers (second order); deflections scale with its power −¼: 1.8 %"),
        Row("largest moment, 6 layers", theory, "moment", "%", Within(0, 0.03), "scales with the power ¼ of the stiffness"),
        Row("bending stiffness, 12 layers", theory, "stiffness, 12 layers", "%", Within(0, 0.02), "second order from 7 % at 6 layers; strips four particles wide are up to 2 % stiffer than wide sheets"),
        Row("failure load, 6 layers", theory, "breaks", "%", Within(0, 0.07), "scales with the power ¾ of the stiffness, 5 %, plus a row of history"),
        Row("the same, 4 layers with `bending_calibration`", theory, "breaks, calibrated", "%", Within(0, 0.05), "calibrated for a wide sheet; narrow strips are 2 to 6 % stiffer"),
        Row("distance of the crack from the edge", theory + ": 20.98 m", "distance", "m", Within(20.98, 3), "the moment is within 1 % of its maximum over ± 2.7 m, and a section is 0.33 m"),
    ]  # fmt: skip
