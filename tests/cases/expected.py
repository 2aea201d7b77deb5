"""Holds what a case's measure.py found against the case's expected.csv."""

import csv


def expect_rows(scene, path, found):
    """Each row of the file asks for one of `found`, which has the units in its names: "angle [deg]"."""
    with open(path, newline="") as file:
        rows = list(csv.DictReader(file))
    scene.assertTrue(rows, f"{path} holds nothing")
    for row in rows:
        name = f"{row['quantity']} [{row['unit']}]"
        scene.assertIn(name, found)
        wanted, tolerance = float(row["value"]), float(row["tolerance"])
        allowed = {"relative": abs(wanted) * tolerance, "absolute": tolerance}[row["relative_or_absolute"]]
        scene.assertIsNotNone(found[name], f"{name} did not happen")
        print(f"{name}: {found[name]:.6g}, expected {wanted:.6g} within {allowed:.3g}")
        scene.assertLessEqual(abs(found[name] - wanted), allowed, f"{name}: {row['reason']}")
