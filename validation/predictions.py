"""Predictions whose targets were stated before the runs. Unlike a row, one that misses its target is a result and does not make the page fail."""

from dataclasses import dataclass

from rows import Within, read_records, shown
from runner import ROOT, script_of
from topics.ship import resistance

UIKKU = ROOT / "cases/uikku_ice"
REPORTED_APART = "403"  # of MT Uikku: thin ice at a higher speed, which may buckle


@dataclass(frozen=True)
class Prediction:
    subject: str
    reference: str  # where the measured or published value is from
    value: float
    unit: str
    target: Within
    has_target: bool = True  # else the reference is its value, and the result is reported apart

    def line(self):
        """Of the page's table."""
        difference = f"{100 * (self.value / self.target.wanted - 1):+.0f} %".replace("-", "−")
        verdict = "no target" if not self.has_target else "met" if self.target.holds(self.value) else "**not met**"
        target = self.target.text(self.unit) if self.has_target else shown(self.target.wanted, self.unit)
        return f"| {self.subject} | {self.reference} | {shown(self.value, self.unit)} | {target} | {difference} | {verdict} |"


def predictions(numbers):
    """`numbers`: of all topics, "topic.quantity" → value."""
    plastic_sphere = script_of("cases/ice_specimens/measure.py").plastic_sphere
    force, time = plastic_sphere(10e6)
    stopped = numbers["ice_specimens.ball time over plastic sphere"] * plastic_sphere(1e6 * numbers["ice_specimens.ball crushing pressure"])[1]
    radial, split = (Within(numbers[f"ship.elastic plate, {case}"], 0.25, True) for case in ("radial crack", "split"))
    found = [
        Prediction("icebreaker without friction, mean resistance with its full breadth in the ice", "Lindqvist's formula, at rest", numbers["ship.window, mean"], "MN", Within(resistance(), 0.25, True)),
        Prediction(f"the same from first contact on, over {numbers['ship.window, travel']:.0f} m, with the entry of the bow", "the same", numbers["ship.window, mean from first contact"], "MN", Within(resistance(), 0.25, True)),
        Prediction("size of its floes, median by mass", "plates on water: a split sheet breaks 6 to 9 m ahead", numbers["ship.window, median floe"], "m", Within(7.5, 1.5)),
        Prediction("dominant period of its load, full breadth", "floes of this size at 3 knots", numbers["ship.window, period"], "s", Within(5, 1)),
        Prediction("vertical force on its bow at which a radial crack opens, three layers", "elastic plate on water", numbers["ship.radial crack"], "MN", radial),
        Prediction("the same, four layers", "elastic plate on water", numbers["ship.radial crack, four layers"], "MN", radial),
        Prediction("vertical force on its bow at which a sheet cut along the track breaks", "elastic plate on water", numbers["ship.split"], "MN", split),
        Prediction("ball of ice of 1 m on a plate, 20 m/s: largest force", "plastic sphere at 10 MPa", 1e6 * numbers["ice_specimens.ball force"], "MN", Within(force, 0.1, True)),
        Prediction("the same: time until it stops", "plastic sphere at 10 MPa", stopped, "ms", Within(time, 0.1, True)),
        Prediction("flat indenter in the edge of a floating sheet, w/h = 2, pressure over σ_c", "Michel and Blanchet (1983), 27 tests", numbers["ice_specimens.edge_narrow"], "", Within(2.97, 0.2, True)),
    ]  # fmt: skip
    measured = {row["test"]: 1e3 * float(row["resistance [kN]"]) for row in read_records(UIKKU / "measured.csv")}
    ratios = []
    for row in read_records(UIKKU / "results.csv"):
        test, mean = row["test"], float(row["mean F_x [N]"])
        has_target = test != REPORTED_APART
        if has_target:
            ratios.append(mean / measured[test])
        found.append(Prediction(f"MT Uikku, model test {test}, mean resistance", "Hu and Zhou (2016)", mean, "MN", Within(measured[test], 0.3, True), has_target))
    found.append(Prediction(f"MT Uikku, mean of run over measured, {len(ratios)} tests", "Hu and Zhou (2016)", sum(ratios) / len(ratios), "", Within(1, 0.2, True)))
    return found


def table(numbers):
    """Lines of markdown."""
    return ["| prediction | reference | result | target | difference | |", "|---|---|---|---|---|---|", *(one.line() for one in predictions(numbers))]
