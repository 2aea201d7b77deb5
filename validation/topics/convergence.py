"""Whole runs against exact solutions: the results of docs/theory/convergence.md, with three runs repeated."""

import json

from rows import AtLeast, AtMost, Row, Within, read_records
from runner import ROOT, script_of

TITLE = "Convergence to exact solutions"
TABLE = ROOT / "docs/theory/convergence.csv"
TABLES = ("/usr/bin/python3 docs/theory/convergence.py {perimpact} {results}/convergence_tables",)
LONG = False
SPACE, PLANE = "3-D, ν = 0.3", "plane stress, ν = 0.3"
AGAIN = [("bar", SPACE, 8, "none"), ("pulse", PLANE, 8, "stress"), ("cantilever", PLANE, 8, "stress")]  # seconds each


def found(problem, series, layers, quantity, column="error"):
    for row in read_records(TABLE):
        if (row["problem"], row["series"], int(row["layers"]), row["quantity"]) == (problem, series, layers, quantity):
            return float(row[column])
    raise KeyError(f"{TABLE} holds no {quantity} of {problem}, {series}, {layers} layers")


def gathered():
    return {
        "bar": found("bar", SPACE, 16, "strain"),
        "bar, correspondence": found("bar", "plane stress, correspondence, ν = 0.3", 32, "strain"),
        "pulse": found("pulse", SPACE, 12, "speed"),
        "pulse field": found("pulse", SPACE, 12, "love"),
        "cantilever": found("cantilever", SPACE, 12, "stiffness"),
        "cantilever, plane": found("cantilever", PLANE, 32, "stiffness"),
        "cantilever order": found("cantilever", PLANE, 32, "stiffness", "order"),
        "bending": found("three_points", SPACE, 12, "middle"),
        "hole": found("hole", PLANE, 32, "opening"),
    }


def measure(runner):
    problems = script_of("tests/cases/convergence/problems.py")
    largest = 0.0
    for problem, series, layers, plane in AGAIN:

        def run(name, deck):
            folder = runner.folder("convergence", f"{problem}_{name}".replace(" ", "_"))
            folder.mkdir(parents=True, exist_ok=True)
            (folder / "deck.yaml").write_text(json.dumps(deck))
            return problems.Result(runner.run("convergence", folder.name, folder / "deck.yaml"))

        _, errors = problems.PROBLEMS[problem](problems.Body(layers, plane=plane), run)
        for quantity, error in errors.items():
            largest = max(largest, abs(error - found(problem, series, layers, quantity)))
    return {"again": largest}


def text(n):
    return """Whole runs against exact solutions for a bar, a wave, beams and a plate with a hole, on the finest lattices of
[convergence](theory/convergence.md). That page has all results, and states what does not converge and why. Three of the runs are repeated here."""


def rows():
    exact, page = "exact solution", "[convergence](theory/convergence.md)"
    return [
        Row("strain of a bar in tension, 3-D, 16 layers", exact, "bar", "%", Within(0, 0.005), "the effect of the surface layer is proportional to the spacing: 0.7 % at 8 layers, half of that at 16, plus a margin"),
        Row("the same, correspondence, plane stress, 32 layers", exact, "bar, correspondence", "%", Within(0, 1e-4), "exact in uniform strain; the rest is due to the ends and to relaxation to 1e-7"),
        Row("speed of a pulse, 3-D, 12 layers", exact, "pulse", "%", Within(0, 0.002), "half of the stiffness error, which is 0.2 % at 12 layers"),
        Row("its field, against Love's bar", exact, "pulse field", "%", AtMost(0.005), "d'Alembert's and Love's bars differ by 0.1 %, times the stiffness error"),
        Row("bending stiffness of a cantilever, 3-D, 12 layers", exact, "cantilever", "%", Within(0, 0.025), "second order: 20 % at 4 layers gives 2.2 % at 12"),
        Row("the same, plane stress, 32 layers", exact, "cantilever, plane", "%", Within(0, 0.005), "second order: 22 % at 4 layers gives 0.34 % at 32, plus a constant 0.1 % of the lattice"),
        Row("its order of convergence", "second order expected", "cantilever order", "", AtLeast(1.5), "between 16 and 32 layers, where the constant 0.1 % of the lattice begins to show"),
        Row("three-point bending, deflection, 3-D, 12 layers", exact, "bending", "%", Within(0, 0.03), "as for the cantilever, with shear and supports one spacing wide"),
        Row("opening of a hole in a plate, radius 32 spacings", exact, "hole", "%", Within(0, 0.02), "µ is 6 % too small in plane stress with this horizon, and the hole's edge is a staircase"),
        Row("three of these runs repeated (largest change of an error)", page, "again", "small", AtMost(2e-4), "states are relaxed to 1e-7; rounding differences between processors are far below the limit, changes of a deck are not"),
    ]  # fmt: skip
