"""A row of the validation page: claim, source, result, tolerance and its reason. It passes, or it fails."""

import csv
from dataclasses import dataclass
from pathlib import Path

# unit of a table: (size in SI, digits behind the point)
UNITS = {
    "mm": (1e-3, 3), "µm": (1e-6, 2), "m": (1, 2), "nm": (1e-9, 2), "µs": (1e-6, 1), "ms": (1e-3, 2), "s": (1, 2), "m/s": (1, 2), "km/s": (1e3, 2), "MN": (1e6, 3),
    "kN/m": (1e3, 1), "N s": (1, 2), "°": (1, 1), "%": (1e-2, 2), "J": (1, 2), "": (1, 3), "count": (1, 0), "exact": (1, None), "small": (1, None),
}  # fmt: skip


def shown(value, unit):
    """As on the page: 4.805 mm."""
    size, digits = UNITS[unit]
    if unit == "count":
        return f"{value:,.0f}".replace(",", " ")
    text = f"{value / size:.2g}" if unit == "small" else f"{value / size:.{digits}f}" if digits is not None else f"{value / size:.10g}"
    return text.replace("-", "−") + ("" if unit in ("", "exact", "small") else unit if unit == "°" else f" {unit}")


@dataclass(frozen=True)
class Within:
    """wanted ± tolerance, which is a share of `wanted` where relative."""

    wanted: float
    tolerance: float
    relative: bool = False

    @property
    def allowed(self):
        return self.tolerance * (abs(self.wanted) if self.relative else 1)

    def holds(self, value):
        return abs(value - self.wanted) <= self.allowed

    def outside(self):
        """Numbers just outside, for the test that each row can fail."""
        return [self.wanted - 1.001 * self.allowed, self.wanted + 1.001 * self.allowed]

    def text(self, unit):
        by = f"{100 * self.tolerance:.3g} %" if self.relative else shown(self.tolerance, unit)
        return f"{shown(self.wanted, unit)} ± {by}"


@dataclass(frozen=True)
class AtMost:
    limit: float

    def holds(self, value):
        return value <= self.limit

    def outside(self):
        return [self.limit + 0.001 * max(abs(self.limit), 1e-300)]

    def text(self, unit):
        return f"at most {shown(self.limit, unit)}"


@dataclass(frozen=True)
class AtLeast:
    limit: float

    def holds(self, value):
        return value >= self.limit

    def outside(self):
        return [self.limit - 0.001 * max(abs(self.limit), 1e-300)]

    def text(self, unit):
        return f"at least {shown(self.limit, unit)}"


@dataclass(frozen=True)
class Between:
    low: float
    high: float

    def holds(self, value):
        return self.low <= value <= self.high

    def outside(self):
        margin = 0.001 * (self.high - self.low)
        return [self.low - margin, self.high + margin]

    def text(self, unit):
        return f"{shown(self.low, unit)} to {shown(self.high, unit)}"


@dataclass(frozen=True)
class Exactly:
    wanted: float

    def holds(self, value):
        return value == self.wanted

    def outside(self):
        return [self.wanted - 1, self.wanted + 1]

    def text(self, unit):
        return shown(self.wanted, unit)


@dataclass(frozen=True)
class Row:
    claim: str
    source: str  # of the expected value
    number: str  # its name among the numbers
    unit: str
    bound: Within | AtMost | AtLeast | Between | Exactly
    reason: str  # of the tolerance

    def passes(self, numbers):
        return self.bound.holds(numbers[self.number])

    def line(self, numbers):
        """Of the page's table."""
        cells = (self.claim, self.source, shown(numbers[self.number], self.unit), self.bound.text(self.unit), self.reason, "pass" if self.passes(numbers) else "**FAIL**")
        return "| " + " | ".join(cells) + " |"


def expected_rows(path, prefix, source_of=None, units=None, claims=None, ranges=()):
    """Rows of a case's expected.csv, the single source of the values it must reproduce; numbers are named prefix + quantity. `ranges`: quantities that are to lie
    anywhere within an interval, which the page then shows in place of a value and its tolerance."""
    rows = []
    for row in read_records(path):
        kind = row["relative_or_absolute"] == "relative"
        bound = Within(float(row["value"]), float(row["tolerance"]), kind)
        quantity = row["quantity"]
        if quantity in ranges:
            bound = Between(bound.wanted - bound.allowed, bound.wanted + bound.allowed)
        rows.append(Row((claims or {}).get(quantity, quantity), row["source"], prefix + quantity, (units or {})[quantity], bound, row["reason"]))
    return rows


def read_records(path):
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def read_columns(path):
    """Columns of numbers by their names, as plain lists."""
    with open(path, newline="", encoding="utf-8") as file:
        names, *rows = csv.reader(file)
    return {name: [float(row[i]) for row in rows] for i, name in enumerate(names)}


def read_numbers(path):
    """Numbers measured by a topic: name → value."""
    return {row["quantity"]: float(row["value"]) for row in read_records(path)} if Path(path).exists() else {}


def write_numbers(path, numbers):
    with open(path, "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["quantity", "value"])
        writer.writerows([name, f"{value:.9g}"] for name, value in numbers.items())
