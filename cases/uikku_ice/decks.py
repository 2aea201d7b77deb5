#!/usr/bin/python3
"""Writes the decks of this folder from measured.csv: decks.py [--out FOLDER]

Every number of a deck follows from the row of its test and from the rules of ../ship_ice/level_ice.py, which README.md explains. None depends on the result of a
run with a ship.
"""

import argparse
import csv
import sys
from dataclasses import replace
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE / "../ship_ice"))
from level_ice import LevelIceRun  # noqa: E402
from level_ice import deck as deck_of  # noqa: E402
from resistance import bollard_pull  # noqa: E402

# L_bow and L_par reproduce what Hu and Zhou print for Riska's formula (README.md); 0.25 is Poisson's ratio of bond-based peridynamics.
# The displacement is that of the panels of this hull, by `perimpact shape hull`, in water of 1025 kg/m3.
UIKKU = LevelIceRun(
    length=150, beam=21.3, draft=9.5, stem=30, waterline=21, parallel=67, bow=38, friction=0.05, poisson=0.25,
    fullness=1.4, freeboard=6, displacement=21655e3, edge_length=1.5, bow_edge_length=0.75, lead_in=10, sample=36,
)  # fmt: skip

# Tests 103, 104 and 205 have the inertial forces of test 403, the fastest, which makes them affordable [m/s]: README.md
INERTIAL_SPEED = 1.0
UNSCALED = (302,)

# power, diameter of the propeller and speed in open water: README.md
PROPULSION = {"bollard_pull": bollard_pull(11.4e6, 5.6), "open_water_speed": 8.75}
# of the driven ship, in the ice of test 302 and in the same ice of other thicknesses [m]: the speed at which it starts [m/s], an estimate of that which it holds
FREE = {"free.yaml": (1.04, 3.8), "free_0.7m.yaml": (0.7, 4.6), "free_1.4m.yaml": (1.4, 2.4)}


def tests():
    """Rows of measured.csv by the number of the test, in the units of the file without them in the names."""
    with open(HERE / "measured.csv", newline="", encoding="utf-8") as lines:
        return {int(row["test"]): {name.split(" [")[0]: float(value) for name, value in row.items()} for row in csv.DictReader(lines)}


def name_of(number):
    return "deck.yaml" if number == 302 else f"test_{number}.yaml"


def ship_in(test):
    """Ship and ice of a test, and how the ship travels."""
    return replace(
        UIKKU, speed=test["speed"], thickness=test["thickness"], strength=1e3 * test["flexural strength"], young=1e6 * test["elastic modulus"],
        compressive_strength=1e6 * test["compressive strength"], inertial_speed=0.0 if test["test"] in UNSCALED else INERTIAL_SPEED,
    )  # fmt: skip


def heading(number, also=""):
    return f"""# yaml-language-server: $schema=../../docs/guide/deck.schema.json
# MT Uikku in level ice, model test {number} of Hu and Zhou (2016) at full scale{also}. Written by decks.py: why each number is what it is, and what was
# measured, is in README.md of this folder."""


def deck(number, test):
    """The deck of a test."""
    run = ship_in(test)
    return deck_of(run, f"MT Uikku, test {number}, {run.thickness:g} m of ice at {run.speed:g} m/s", heading(number), f"results/uikku_ice_{number}")


def free_ship(name):
    """Ship and ice of a deck of FREE."""
    thickness, speed = FREE[name]
    return replace(ship_in(tests()[302]), **PROPULSION, thickness=thickness, speed=speed)


def free_deck(name):
    """The deck of a ship that is free in surge and heave and driven by its net thrust."""
    run = free_ship(name)
    title = f"MT Uikku, free, test 302, {run.thickness:g} m of ice, starting at {run.speed:g} m/s"
    also = "" if run.thickness == tests()[302]["thickness"] else f", in ice of {run.thickness:g} m"
    return deck_of(run, title, heading(302, also), f"results/uikku_ice_{name.removesuffix('.yaml')}")


def main():
    arguments = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    arguments.add_argument("--out", type=Path, default=HERE)
    folder = arguments.parse_args().out
    folder.mkdir(parents=True, exist_ok=True)
    for number, test in tests().items():
        (folder / name_of(number)).write_text(deck(number, test), encoding="utf-8")
    for name in FREE:
        (folder / name).write_text(free_deck(name), encoding="utf-8")


if __name__ == "__main__":
    main()
