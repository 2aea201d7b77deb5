"""Completeness of contact detection: the counts of docs/theory/detection_evidence.md."""

from rows import AtLeast, AtMost, Exactly, Row, read_records
from runner import ROOT

TITLE = "No missed contact"
TABLE = ROOT / "docs/theory/detection_evidence.csv"
TABLES = ("build/release/tests/fccda/evidence/detection_table > docs/theory/detection_evidence.csv.new",
          "mv docs/theory/detection_evidence.csv.new docs/theory/detection_evidence.csv",
          "/usr/bin/python3 docs/theory/detection_evidence.py")  # fmt: skip
LONG = True


def gathered():
    rows = read_records(TABLE)

    def total(column, of):
        return float(sum(int(row[column]) for row in rows if of(row)))

    def share(reading, shape=None):
        def of(row):
            return row["detector"] == reading and shape in (None, row["shape"])

        return total("found", of) / total("crossings", of)

    def swept(row):
        return row["detector"].startswith("swept")

    shapes = {row["shape"] for row in rows}
    return {
        "crossings": total("crossings", swept),
        "missed": total("crossings", swept) - total("found", swept),
        "paths past": total("past", swept),
        "invented": total("invented", swept),
        "left inside": total("inside", swept) + total("thrown", swept),
        "letter": share("literal"),
        "letter, most": max(share("literal", shape) for shape in shapes),
        "letter, cylinder along z": total("found", lambda row: row["detector"] == "literal" and row["shape"] == "cylinder along z"),
        "repaired": share("corrected"),
        "repaired, flat panels, least": min(share("corrected", shape) for shape in shapes if shape != "torus of warped quads"),
        "shapes": float(len(shapes)),
    }


def text(n):
    return f"""Ten shapes, paths of four lengths, points and spheres. Winding numbers and brute force decide independently of the library which paths cross a surface
([evidence](theory/detection_evidence.md)). A long test repeats all counts. The literal variant of the paper's detector finds {100 * n["letter"]:.0f} % of the
crossings; the corrected variant, with the same method and corrected equations, {100 * n["repaired"]:.0f} %."""


def rows():
    oracle = "winding numbers and brute force over all triangles"
    count = "a count: none may be missed"
    return [
        Row("crossings tested", "[evidence](theory/detection_evidence.md)", "crossings", "count", AtLeast(400_000), "a smaller sample could not resolve one miss in 400 000"),
        Row("`swept` misses none of them", oracle, "missed", "count", Exactly(0), count),
        Row("`swept` reports no contact on paths that pass by", oracle, "invented", "count", Exactly(0), "a count: none may be invented"),
        Row("no particle remains inside, or is relocated to the wrong side", oracle, "left inside", "count", Exactly(0), "a count; deeper than 1e-11 of the shape's size"),
        Row("the literal variant misses more than it finds, on every shape (share found, best shape)", oracle, "letter, most", "%", AtMost(0.5),
            "eq. 20 rejects half of all directions"),
        Row("the literal variant finds nothing on a cylinder along z, the benchmark of the paper", oracle, "letter, cylinder along z", "count", Exactly(0),
            "eqs. 14 and 15 reject every panel of it: a count"),
        Row("the corrected variant finds most crossings of flat panels (share found, worst shape)", oracle, "repaired, flat panels, least", "%", AtLeast(0.85),
            "it misses particles that end beneath the neighbour of the panel they crossed, more often in longer steps; 0.85 is a step of about a panel"),
    ]  # fmt: skip
