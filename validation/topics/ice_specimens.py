"""Specimens of ice that yields: the rows of the case, whose expected.csv has values, tolerances and sources."""

from rows import AtMost, Row, expected_rows
from runner import ROOT, script_of

TITLE = "Specimens of ice that yields"
LONG = False
CASE = "cases/ice_specimens"
DECKS = ("compression", "tension", "brazilian", "bending", "punch", "indentation", "edge_narrow", "edge_wide", "edge_wedge", "edge_cylinder", "ball", "drop")
UNITS = {"MPa": (1e6, ""), "MN": (1e6, "MN"), "ms": (1e-3, "ms"), "-": (1, "")}
HALF = "time.step=2.5 us"  # 5.16 µs where absent


def measure(runner):
    script = script_of(f"{CASE}/measure.py")
    folders = [runner.run("ice_specimens", deck, f"{CASE}/{deck}.yaml", "output.frames=0") for deck in DECKS]
    numbers = {name.rsplit(" [", 1)[0]: value for name, value in script.measure(folders[0].parent).items()}
    halved = runner.run("ice_specimens", "half_step/brazilian", f"{CASE}/brazilian.yaml", "output.frames=0", HALF)
    numbers["splitting at half the step"] = script.measure(halved.parent)["splitting strength [MPa]"] / numbers["splitting strength"]
    return numbers


def text(n):
    return f"""Decks and pictures: [the case](../cases/ice_specimens/README.md). Stresses are in MPa, pressures of indenters in units of the compressive strength of the
deck. The strength is that of the deck in all rows; nothing is fitted to them. Where the material does not reach a measured value, the row has the range that it
reaches, and the case names the measured one."""
