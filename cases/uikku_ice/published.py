#!/usr/bin/python3
"""Which hull and which friction the predictions of Hu and Zhou (2016) imply: published.py

published.csv has their predictions for ten tests by the formulas of Lindqvist and Riska. Lindqvist's formula is linear in three coefficients that follow from stem angle,
angle of entrance, main dimensions and friction alone: least squares of the relative differences give them with their standard errors. No measured resistance is used.
"""

import argparse
from dataclasses import replace
from math import sqrt

import numpy as np
from decks import HERE, ship_in, tests  # which makes ../ship_ice importable
from measure import records
from resistance import lindqvist, lindqvist_speed_factors, riska

PUBLISHED = "published.csv"
TERMS = "crushing", "bending", "submersion"


def ships():
    """The ship of the decks in the ice and at the speed of each published prediction, with their row."""
    ship = ship_in(tests()[302])
    for row in records(HERE, PUBLISHED):
        given = {"thickness": "thickness [m]", "speed": "speed [m/s]"}
        scaled = {"strength": ("flexural strength [kPa]", 1e3), "young": ("elastic modulus [MPa]", 1e6)}
        changes = {name: float(row[key]) for name, key in given.items()} | {name: factor * float(row[key]) for name, (key, factor) in scaled.items()}
        yield replace(ship, **changes), row


def parts_of_lindqvist():
    """The three terms [N] that the formula has for the ship of the decks, a row for each published prediction, and these predictions [N]."""
    parts, published = [], []
    for ship, row in ships():
        found = lindqvist(ship)
        fast, slow = lindqvist_speed_factors(ship)
        parts.append([found["crushing"] * fast, found["bending"] * fast, found["submersion"] * slow])
        published.append(1e3 * float(row["Lindqvist [kN]"]))
    return np.array(parts), np.array(published)


def shares():
    """Of each term, the share of it that the published predictions contain, its standard error, and the scatter of the predictions about their fit."""
    parts, published = parts_of_lindqvist()
    relative = parts / published[:, None]
    found = np.linalg.lstsq(relative, np.ones(len(published)), rcond=None)[0]
    scatter = sqrt(((relative @ found - 1) ** 2).sum() / (len(published) - len(found)))
    return found, scatter * np.sqrt(np.diag(np.linalg.inv(relative.T @ relative))), scatter


def implied_friction():
    """The friction whose crushing term the published predictions contain, and its standard error, at the angles of the decks."""
    ship = ship_in(tests()[302])
    found, errors, _ = shares()

    def crushing(friction):
        return lindqvist(replace(ship, friction=friction))["crushing"]

    def friction_of(share):
        wanted, low, high = share * crushing(ship.friction), 0.0, 0.5
        while high - low > 1e-9:
            middle = (low + high) / 2
            low, high = (middle, high) if crushing(middle) < wanted else (low, middle)
        return low

    return friction_of(found[0]), (friction_of(found[0] + errors[0]) - friction_of(found[0] - errors[0])) / 2


def main():
    argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter).parse_args()
    found, errors, scatter = shares()
    print("| term of Lindqvist's formula | share of it in the published predictions |")
    print("|---|---|")
    for name, share, error in zip(TERMS, found, errors):
        print(f"| {name} | {share:.2f} ± {error:.2f} |")
    friction, error = implied_friction()
    print(f"\nScatter about the fit: {100 * scatter:.1f} %. Friction implied by the crushing term: {friction:.3f} ± {error:.3f}.")
    worst = max(abs(riska(ship)["total"] / (1e3 * float(row["Riska [kN]"])) - 1) for ship, row in ships())
    print(f"Riska's formula with the bow and the midbody of the decks: within {100 * worst:.1f} % of the published predictions.")


if __name__ == "__main__":
    main()
