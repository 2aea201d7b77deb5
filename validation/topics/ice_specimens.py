"""Specimens of ice that yields: the rows of the case, whose expected.csv has values, tolerances and sources."""

from rows import Row, Within, expected_rows, read_records
from runner import ROOT, script_of

TITLE = "Specimens of ice that yields"
LONG = False
CASE = "cases/ice_specimens"
DECKS = ("compression", "tension", "brazilian", "bending", "punch", "indentation", "edge_narrow", "edge_wide", "edge_wedge", "edge_cylinder", "ball", "drop")
HALF = "time.step=2.5 us", "time.end=10.5 ms"  # 5.16 µs where absent; the first bonds break at 9.6 ms


def measure(runner):
    script = script_of(f"{CASE}/measure.py")
    folders = [runner.run("ice_specimens", deck, f"{CASE}/{deck}.yaml", "output.frames=0") for deck in DECKS]
    numbers = {name.rsplit(" [", 1)[0]: value for name, value in script.measure(folders[0].parent).items()}
    halved = runner.run("ice_specimens", "half_step/brazilian", f"{CASE}/brazilian.yaml", "output.frames=0", *HALF)
    numbers["splitting at half the step"] = script.measure(halved.parent)["splitting strength [MPa]"] / numbers["splitting strength"]
    return numbers


def text(n):
    return f"""Decks and pictures: [the case](../cases/ice_specimens/README.md). Stresses are in MPa, pressures of indenters in units of the compressive strength of the
deck. The strength is that of the deck in all rows; nothing is fitted to them. Where the material does not reach a measured value, the row has the range that it
reaches, and the case names the measured one."""


CLAIMS = {
    "compressive strength": "prism in compression [MPa]",
    "tensile strength": "prism in tension [MPa]",
    "splitting strength": "disc pressed across its diameter, 2 P/(π D t) [MPa]",
    "flexural strength": "beam in four-point bending [MPa]",
    "punch": "punch in plane strain, von Mises, over σ_c",
    "indentation over 7.4 A^-0.7": "sphere in a confined block: pressure over 7.4 A^−0.7 MPa, largest",
    "edge_narrow": "flat indenter in the edge of a floating sheet, w/h = 2: pressure over σ_c",
    "edge_wide": "the same, w/h = 8",
    "edge_wedge": "wedge of 120° in the edge of a sheet: pressure over σ_c",
    "edge_cylinder": "cylinder in the edge of a sheet: pressure over σ_c",
    "ball force over plastic sphere": "ball of ice on a plate: largest force over v √(2πR p m), p the mean pressure",
    "ball time to the largest force": "the same: time of the largest force [ms]",
    "drop centre pressure": "sphere dropped on iceberg ice, σ_c = 7 MPa: pressure at the centre [MPa]",
}


def claim(quantity):
    return f"energy balance error over the work: {quantity.removesuffix(' energy error')}" if quantity.endswith("energy error") else CLAIMS.get(quantity, quantity)


def rows():
    table = ROOT / CASE / "expected.csv"
    quantities = [row["quantity"] for row in read_records(table)]
    units = {quantity: "small" if quantity.endswith("energy error") else "" for quantity in quantities}
    halved = Row("the disc at half the time step: strength over that at the full step", "no dependence on the step", "splitting at half the step", "exact", Within(1, 0.01), "the load of the last row before the first bond breaks: rows are 0.05 ms apart, 0.5 % of it")
    return [*expected_rows(table, "", units=units, claims={quantity: claim(quantity) for quantity in quantities}), halved]
