#!/usr/bin/python3
"""Bending moment that a section of a lattice carries as its bonds break: section.py [--layers 3 --horizon-ratio 2.015 …]

A wide plate of a few layers is bent about an axis in its plane: strain z κ in the direction of bending, none across, thickness strain −ν/(1 − ν) of it, and no
membrane force. The strain is the same everywhere in a layer, so a bond is broken in all of its places at once. Bonds break beyond the critical stretch (docs/theory/damage.md).
Prints, for several directions of bending in the lattice, the moment over that at which the outermost layer reaches the critical stretch, M₀, at curvatures over that one, κ₀.
A brittle section carries nothing beyond κ₀.
"""

import argparse
import itertools

import numpy as np

CURVATURES = (1.05, 1.2, 1.5, 2.0)  # over κ₀
STEP = 0.01  # of the curvature
ANGLES = (0.0, 10.0, 22.5, 35.0, 45.0)  # [deg] between bending and an axis of the lattice


class Section:
    """Bonds of a column of particles, in spacings; partial volumes by Hu, Ha and Bobaru (docs/theory/lattice.md)."""

    def __init__(self, layers, horizon_ratio, degrees, poisson=0.25):
        reach = int(np.ceil(horizon_ratio + 0.5))
        of_layers = ((layer, np.array(offset)) for layer in range(layers) for offset in itertools.product(range(-reach, reach + 1), repeat=3))
        bonds = [(layer, offset, np.linalg.norm(offset)) for layer, offset in of_layers if 0 <= layer + offset[2] < layers]
        bonds = [bond for bond in bonds if 0 < bond[2] < horizon_ratio + 0.5]
        self.layer = np.array([layer for layer, _, _ in bonds])
        offset, self.length = np.array([offset for _, offset, _ in bonds]), np.array([length for _, _, length in bonds])
        self.volume = np.minimum(1, horizon_ratio + 0.5 - self.length)
        n = offset / self.length[:, None]
        angle = np.radians(degrees)
        self.share = (n[:, 0] * np.cos(angle) + n[:, 1] * np.sin(angle)) ** 2 - poisson / (1 - poisson) * n[:, 2] ** 2  # of the strain of its layer
        self.height = self.layer - (layers - 1) / 2 + offset[:, 2] / 2
        self.first_curvature = 2 / (layers - 1)  # critical stretch 1 in the outermost layer
        self.intact = np.ones(len(bonds), bool)

    def strains(self, curvature):
        """Of each bond; the membrane strain makes the membrane force vanish."""
        stiffness = self.volume * self.length * self.share**2 * self.intact
        total = stiffness.sum()
        membrane = -curvature * (stiffness * self.height).sum() / total if total > 0 else 0.0
        return (membrane + curvature * self.height) * self.share

    def moment(self, curvature):
        return (self.volume * self.length * self.share * self.strains(curvature) * self.height * self.intact).sum()

    def break_bonds(self, curvature):
        """The most stretched first, since the others are relieved or loaded by them."""
        while True:
            beyond = np.where(self.intact, self.strains(curvature), 0)
            if beyond.max() <= 1 + 1e-12:
                return
            self.intact &= beyond < beyond.max() - 1e-9

    def damage_of_top(self):
        top = self.layer == self.layer.max()
        return 1 - (self.volume * self.intact)[top].sum() / self.volume[top].sum()


def curve(layers, horizon_ratio, degrees, largest=2.5):
    """(curvature over κ₀, moment over M₀, damage of the top layer), from 0 on."""
    section = Section(layers, horizon_ratio, degrees)
    first = section.moment(section.first_curvature)
    found = []
    for relative in np.arange(STEP, largest + STEP / 2, STEP):
        section.break_bonds(relative * section.first_curvature)
        found.append((relative, section.moment(relative * section.first_curvature) / first, section.damage_of_top()))
    return np.array(found)


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--layers", type=int, nargs="+", default=[3, 4, 6])
    arguments.add_argument("--horizon-ratio", type=float, nargs="+", default=[2.015, 3.015])
    given = arguments.parse_args()
    headings = "".join(f" {curvature:g} κ₀ |" for curvature in CURVATURES)
    print(f"| layers | horizon, spacings | direction | first bond |{headings} largest beyond 1.05 κ₀ |\n|---|---|---|---|{'---|' * len(CURVATURES)}---|")
    for layers, horizon_ratio, degrees in itertools.product(given.layers, given.horizon_ratio, ANGLES):
        curvature, moment, damage = curve(layers, horizon_ratio, degrees).T
        first = curvature[damage > 0][0]
        moments = "".join(f" {np.interp(at, curvature, moment):.2f} |" for at in CURVATURES)
        print(f"| {layers} | {horizon_ratio:g} | {degrees:g}° | {first:.2f} κ₀ |{moments} {moment[curvature > 1.05].max():.2f} |")


if __name__ == "__main__":
    main()
