"""The submarine: hydrostatic equilibrium with the ice on it, and the energy balance of its runs."""

from rows import AtMost, Row, Within, read_records
from runner import ROOT

CASE = "cases/submarine_surfacing"
TITLE = "A submarine surfaces through ice"
LONG = True
TABLES = (f"{CASE}/variants.sh {{results}}/submarine {{perimpact}}", f"/usr/bin/python3 {CASE}/measure.py --update {{results}}/submarine/given {{results}}/submarine/crushed {{results}}/submarine/free")


def gathered():
    found = {f"{row['run']}, {row['quantity']}": float(row["value"]) for row in read_records(ROOT / CASE / "results.csv")}
    return {
        "rest": (found["free, mass [kg]"] + found["free, force of the ice as a mass [kg]"] + found["free, damping as a mass [kg]"] - found["free, deceleration as a mass [kg]"]) / found["free, displaced mass [kg]"],
        "energy, given": found["given, over the energy exchanged [-]"],
        "energy, crushed": found["crushed, over the energy exchanged [-]"],
        "energy, free": found["free, over the energy exchanged [-]"],
        "floes, given": found["given, fragments above 1 % [-]"],
        "floes, crushed": found["crushed, fragments above 1 % [-]"],
    }


def text(n):
    return f"""A demonstration without an experiment to compare with ([the case](../{CASE}/README.md)). Ice that is crushed leaves {n["floes, crushed"]:.0f} fragments above 1 % of the sheet, with its edge; ice that
fails in tension alone leaves {n["floes, given"]:.0f}."""


def rows():
    energy = "first order of the step, with friction in rubble"
    return [
        Row("free in heave, at the end: mass, ice on it, damping and deceleration over the mass of the water that it displaces", "Archimedes", "rest", "exact", Within(1, 1e-3), "means of rows 10 ms apart over the last 0.3 s"),
        Row("energy balance error over the energy exchanged, prescribed velocity", "energy is conserved", "energy, given", "%", AtMost(0.01), energy),
        Row("the same, ice that is crushed", "energy is conserved", "energy, crushed", "%", AtMost(0.01), energy),
        Row("the same, free in heave", "energy is conserved", "energy, free", "%", AtMost(0.01), energy),
    ]  # fmt: skip
