"""Whole runs against exact solutions: what docs/theory/convergence.md measured, and a part of it anew."""

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
    return """Decks, runs, and exact solutions for a bar, a wave, beams and a plate with a hole; the finest lattices of
[convergence](theory/convergence.md), where all of it is, with what does not converge and why. Three of these runs are made anew here."""


def rows():
    exact, page = "exact solution", "[convergence](theory/convergence.md)"
    return [
        Row("strain of a bar in tension, 3-D, 16 layers", exact, "bar", "%", Within(0, 0.005), "the surface layer's share falls with the spacing: 0.7 % at 8 layers, half of it at 16 with some to spare"),
        Row("the same, correspondence, plane stress, 32 layers", exact, "bar, correspondence", "%", Within(0, 1e-4), "exact in uniform strain; what is left comes from the ends and relaxation to 1e-7"),
        Row("speed of a pulse, 3-D, 12 layers", exact, "pulse", "%", Within(0, 0.002), "half of the stiffness' error, which is 0.2 % at 12 layers"),
        Row("its field, against Love's bar", exact, "pulse field", "%", AtMost(0.005), "d'Alembert's and Love's bars differ by 0.1 %, times the stiffness' error"),
        Row("bending stiffness of a cantilever, 3-D, 12 layers", exact, "cantilever", "%", Within(0, 0.025), "of second order: 20 % at 4 layers makes 2.2 % at 12"),
        Row("the same, plane stress, 32 layers", exact, "cantilever, plane", "%", Within(0, 0.005), "of second order: 22 % at 4 layers makes 0.34 % at 32, and the lattice's own 0.1 %"),
        Row("its order of convergence", "second order expected", "cantilever order", "", AtLeast(1.5), "between 16 and 32 layers, where the lattice's constant 0.1 % begins to show"),
        Row("three-point bending, deflection, 3-D, 12 layers", exact, "bending", "%", Within(0, 0.03), "as the cantilever, with shear and supports of a spacing"),
        Row("opening of a hole in a plate, 32 spacings a radius", exact, "hole", "%", Within(0, 0.02), "µ is 6 % too small in plane stress with this horizon, and the hole's edge is a staircase"),
        Row("three of these runs made anew (largest change of an error)", page, "again", "small", AtMost(2e-4), "states are relaxed to 1e-7; what another processor rounds differently is far below, the deck's own changes are not"),
    ]  # fmt: skip
