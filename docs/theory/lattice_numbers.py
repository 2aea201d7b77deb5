#!/usr/bin/python3
"""The numbers of lattice.md, from the formulas alone: what the lattice makes of uniform strain and of a thin plate.

    /usr/bin/python3 lattice_numbers.py          prints the tables of lattice.md

Shares nothing with the solver. Unit spacing, E = 1, horizon m = 3.015 spacings, infinitesimal strain. Needs numpy.
"""

import numpy as np

M = 3.015  # δ/Δ
RULES = {"hu-ha-bobaru": lambda r: r < M + 0.5, "madenci-oterkus": lambda r: r <= M}


class Solid:
    """E = 1, and the constants of ordinary_state.md for the horizon M."""

    def __init__(self, nu):
        self.nu = nu
        self.mu = 1 / (2 * (1 + nu))
        self.kappa = 1 / (3 * (1 - 2 * nu))
        self.uniaxial = self.kappa + 4 / 3 * self.mu  # λ + 2µ
        self.a = (self.kappa - 5 * self.mu / 3) / 2
        self.b = 15 * self.mu / (2 * np.pi * M**5)
        self.d = 9 / (4 * np.pi * M**4)

    def normalised(self, family):
        self.d = 1 / (M * np.sum(family.n[:, 0] ** 2 * family.v))
        pull = family.n**2 @ self.pull
        self.b = (0.5 - self.a * (1 - 2 * self.nu) ** 2) / (M * np.sum(pull**2 * family.length * family.v))
        return self

    @property
    def pull(self):
        """Strains of a pull along x to unit strain."""
        return np.array([1, -self.nu, -self.nu])


class Family:
    """Bonds of an interior particle: ξ, |ξ|, n and the partial volume v V."""

    def __init__(self, rule):
        cells = np.arange(-4, 5)
        xi = np.array(np.meshgrid(cells, cells, cells)).reshape(3, -1).T.astype(float)
        r = np.linalg.norm(xi, axis=1)
        kept = (r > 0) & RULES[rule](r)
        self.xi, self.length = xi[kept], r[kept]
        self.n = self.xi / self.length[:, None]
        self.v = np.minimum(1, M + 0.5 - self.length)

    def stretch(self, strain):
        return np.einsum("bi,ij,bj->b", self.n, strain, self.n)

    def dilatation(self, solid, strain):
        return solid.d * M * np.sum(self.stretch(strain) * self.v)

    def energy(self, solid, strain):
        s = self.stretch(strain)
        return solid.a * self.dilatation(solid, strain) ** 2 + solid.b * M * np.sum(s**2 * self.length * self.v)


# ---- uniform strain in the interior ----

def uniform_strain(rule, nu, lattice):
    """Number of bonds, then ratios to the continuum: family's volume, dilatation, and energies of five strains."""
    family, solid = Family(rule), Solid(nu)
    if lattice:
        solid.normalised(family)
    x, all_three, shear = np.diag([1.0, 0, 0]), np.eye(3), np.array([[0, 0.5, 0], [0.5, 0, 0], [0, 0, 0]])
    diagonal = np.array([[0.5, 0.5, 0], [0.5, 0.5, 0], [0, 0, 0]])  # unit strain along a face diagonal
    return (
        len(family.v),
        np.sum(family.v) / (4 / 3 * np.pi * M**3),
        family.dilatation(solid, x),
        family.energy(solid, np.diag(solid.pull)) / 0.5,
        family.energy(solid, all_three) / (4.5 * solid.kappa),
        family.energy(solid, x) / (solid.uniaxial / 2),
        family.energy(solid, diagonal) / (solid.uniaxial / 2),
        family.energy(solid, shear) / (solid.mu / 2),
    )


def fracture_energy(rule, lattice):
    """Of bonds broken at one stretch across a lattice plane (100), ν = 1/4: ratio to 9κδs²/5. A cell face is crossed by i bonds of offset i."""
    family, solid = Family(rule), Solid(0.25)
    if lattice:
        solid.normalised(family)
    across = np.maximum(family.xi[:, 0], 0)
    return np.sum(across * 4 * M * solid.b * family.length * family.v / 2) / (9 / 5 * solid.kappa * M)


# ---- a plate of n layers, infinite in x and y, with the classical displacements imposed ----

class Layer:
    """The bonds that a particle of layer k of n still has, and the layers they lead to."""

    def __init__(self, family, k, n):
        to = k + family.xi[:, 2].astype(int)
        self.kept = (to >= 0) & (to < n)
        self.to = to[self.kept]
        self.n = family.n[self.kept]
        self.length, self.v = family.length[self.kept], family.v[self.kept]
        self.height = k - (n - 1) / 2  # of the layer above the middle
        self.middle = self.height + family.xi[self.kept, 2] / 2  # of its bonds


def factors(interpolation, g, k, layer):
    """Factor of each bond of layer k from the numbers g of the layers: three for the energy method, one for the volume method."""
    mean = (g[k] + g[layer.to]) / 2
    if interpolation == "none":
        return np.ones(len(layer.to))
    if interpolation == "volume":
        return 1 / mean
    if interpolation == "mean":
        return np.sum(layer.n**2 * mean, axis=1)
    return 1 / np.sqrt(np.sum((layer.n / mean) ** 2, axis=1))  # "ellipsoid": as Madenci and Oterkus interpolate


def energy_numbers(family, layers, stretches, power, weight, sweeps):
    """g of each layer along each axis: interior sum of stretch^power weight over that of the layer, improved `sweeps` times."""
    whole = stretches(family.n).T ** power @ weight(family)
    lacking = [len(layer.to) < len(family.v) for layer in layers]
    changed = [any(lacking[j] for j in layer.to) or lacks for layer, lacks in zip(layers, lacking)]
    g = np.ones((len(layers), 3))
    for sweep in range(1 + sweeps):
        sums = np.array([(stretches(layer.n) ** power).T @ (weight(layer) * factors("mean", g, k, layer)) for k, layer in enumerate(layers)])
        g = np.where(np.array(changed)[:, None], g * whole / sums, g)
    return g


def plate(rule, correction, lattice, n, nu=0.25):
    """E_eff/E of the membrane and D_eff/D of the plate of n layers."""
    family, solid = Family(rule), Solid(nu)
    if lattice:
        solid.normalised(family)
    layers = [Layer(family, k, n) for k in range(n)]
    if correction == "volume":
        interpolation = "volume"
        g_energy = g_theta = np.array([layer.v.sum() for layer in layers]) / family.v.sum()
    else:
        interpolation, sweeps = {"none": ("none", 0), "ellipsoid": ("ellipsoid", 0), "one sweep": ("mean", 0), "energy": ("mean", 4)}[correction]
        pull = lambda n: n**2 - nu * (1 - n**2)  # of a pull along each axis
        g_energy = energy_numbers(family, layers, pull, 2, lambda bonds: bonds.length * bonds.v, sweeps)
        g_theta = energy_numbers(family, layers, np.square, 1, lambda bonds: bonds.v, sweeps)

    def energy(stretches):
        total = 0
        for k, layer in enumerate(layers):
            s = stretches(layer)
            theta = solid.d * M * np.sum(factors(interpolation, g_theta, k, layer) * s * layer.v)
            total += solid.a * theta**2 + solid.b * M * np.sum(factors(interpolation, g_energy, k, layer) * s**2 * layer.length * layer.v)
        return total

    # unit stress along x; and unit curvature in x with none in y: u = -x z, w = x²/2 + ν/(1-ν) z²/2, whose strain at a bond's middle counts
    membrane = energy(lambda layer: layer.n**2 @ solid.pull)
    bending = energy(lambda layer: -layer.middle * (layer.n**2 @ [1, 0, -nu / (1 - nu)]))
    return membrane / (n / 2), bending / (n**3 / 12 / (1 - nu**2) / 2)


def main():
    print("| family | normalisation | ν | bonds | Σ v V / V_H | dilatation | tension | volumetric strain | along x | along (110) | shear |")
    print("|---" * 11 + "|")
    for rule in RULES:
        for nu in (0.25, 0.3):
            for lattice in (True, False):
                bonds, *ratios = uniform_strain(rule, nu, lattice)
                print(f"| {rule} | {'lattice' if lattice else 'continuum'} | {nu} | {bonds} | " + " | ".join(f"{ratio:.3f}" for ratio in ratios) + " |")
    print("\n| family | normalisation | fracture energy, (100), ν = 1/4 |\n|---|---|---|")
    for rule in RULES:
        for lattice in (True, False):
            print(f"| {rule} | {'lattice' if lattice else 'continuum'} | {fracture_energy(rule, lattice):.3f} |")
    columns = [("hu-ha-bobaru", "energy", True), ("hu-ha-bobaru", "one sweep", True), ("hu-ha-bobaru", "ellipsoid", True), ("hu-ha-bobaru", "volume", True), ("hu-ha-bobaru", "none", True),
               ("madenci-oterkus", "none", False)]  # fmt: skip
    for nu in (0.25, 0.3):
        print(f"\nν = {nu}: E_eff/E of the membrane, D_eff/D of the plate\n")
        print("| layers | " + " | ".join(correction for _, correction, _ in columns[:-1]) + " | published |")
        print("|---" * (len(columns) + 1) + "|")
        for n in (2, 3, 4, 6, 8, 9, 12, 20):
            print(f"| {n} | " + " | ".join("{:.2f}, {:.2f}".format(*plate(*column, n, nu)) for column in columns) + " |")


if __name__ == "__main__":
    main()
