#!/usr/bin/python3
"""The same crack by an independent program of one page:

    cases/crack_branching/reference.py                        the deck's discretisation: two minutes
    cases/crack_branching/reference.py --spacing 0.5 --ratio 3 --family madenci-oterkus --constants continuum

Bond-based peridynamics in plane stress on whole arrays: all bonds of one offset (i, j) on the lattice at once. Symplectic Euler at a fixed
fraction of the stable step; stretch s, force density c s along the deformed bond; a bond breaks irreversibly beyond s_0; pressure on the outermost
row; no surface correction. The printed quantities are measured by measure.py.

    family      hu-ha-bobaru: |xi| < delta + dx/2, partial volumes within dx/2 of delta; madenci-oterkus: |xi| <= delta, partial volumes too
    constants   lattice: c such that the energy at equal stretch in all directions is exact, s_0 such that a plane between two rows takes exactly G_0;
                continuum: c = 9 E/(pi h delta^3), s_0 = sqrt(4 pi G_0/(9 E delta))
"""

import argparse

import numpy as np
from measure import measure, show

E, RHO, G0, SIGMA = 72e9, 2440.0, 135.0, 12e6  # [Pa] [kg/m3] [J/m2] [Pa]
LENGTH, WIDTH, END, PICTURE = 0.1, 0.04, 50e-6, 0.5e-6  # [m] [m] [s] [s]; the thickness is 1 m


def offsets(spacing, horizon, family):
    """(i, j, length [m], share of the volume) of half of the bonds of an interior particle."""
    reach = horizon + (spacing / 2 if family == "hu-ha-bobaru" else 1e-9 * spacing)
    most = int(reach / spacing) + 1
    for i in range(most + 1):
        for j in range(-most if i else 1, most + 1):
            length = np.hypot(i, j) * spacing
            if length < reach:
                yield i, j, length, min(1.0, (horizon + spacing / 2 - length) / spacing)


def simulate(spacing, horizon, family, constants, safety=0.7):
    """Yields (time [s], positions [m], damage), as measure.frames does."""
    nx, ny, volume = round(LENGTH / spacing), round(WIDTH / spacing), spacing**2
    x, y = np.meshgrid((np.arange(nx) + 0.5) * spacing - LENGTH / 2, (np.arange(ny) + 0.5) * spacing - WIDTH / 2, indexing="ij")
    places = np.column_stack([x.ravel(), y.ravel()])
    half = list(offsets(spacing, horizon, family))

    if constants == "lattice":  # equal stretch s: 1/4 sum c s^2 |xi| v V = E s^2/(1 - nu), nu = 1/3; fracture: sum over bonds through a plane of c s_0^2 |xi|/2
        c = 6 * E / sum(2 * length * part * volume for _, _, length, part in half)
        energy = sum(0.5 * c * length * part * volume * abs(j) * spacing for _, j, length, part in half)
        critical = np.sqrt(G0 / energy)
    else:
        c, critical = 9 * E / (np.pi * horizon**3), np.sqrt(4 * np.pi * G0 / (9 * E * horizon))
    step = safety * np.sqrt(2 * RHO / sum(2 * c * part * volume / length for _, _, length, part in half))

    bonds, whole = [], np.zeros((nx, ny))
    never = np.abs(y) > WIDTH / 2 - horizon  # no bond breaks along the loaded edges
    for i, j, length, part in half:
        a = slice(0, nx - i), slice(max(0, -j), ny - max(0, j))
        b = slice(i, nx), slice(max(0, j), ny - max(0, -j))
        share = y[a] / (y[a] - y[b]) if j else np.full(y[a].shape, np.nan)  # position on the bond where y is 0
        notched = (share > 0) & (share < 1) & (x[a] + share * (x[b] - x[a]) <= 1e-9 * spacing)
        intact = np.where(notched, 0.0, 1.0)
        bonds.append((a, b, i * spacing, j * spacing, length, part, intact, never[a] | never[b]))
        whole[a] += part
        whole[b] += part

    u, velocity, load = np.zeros((2, nx, ny)), np.zeros((2, nx, ny)), np.zeros((2, nx, ny))
    load[1, :, -1], load[1, :, 0] = SIGMA / spacing, -SIGMA / spacing
    picture = 0.0
    for n in range(int(END / step) + 1):
        if n * step >= picture:
            left = np.zeros((nx, ny))
            for a, b, _, _, _, part, intact, _ in bonds:
                left[a] += part * intact
                left[b] += part * intact
            yield n * step, places, (1 - left / whole).ravel()
            picture += PICTURE
        force = load.copy()
        for a, b, dx, dy, length, part, intact, kept in bonds:
            ex, ey = dx + u[0][b] - u[0][a], dy + u[1][b] - u[1][a]
            now = np.hypot(ex, ey)
            stretch = now / length - 1
            intact[(stretch > critical) & ~kept] = 0
            pull = c * part * volume * stretch * intact / now
            force[0][a] += pull * ex
            force[1][a] += pull * ey
            force[0][b] -= pull * ex
            force[1][b] -= pull * ey
        velocity += step / RHO * force
        u += step * velocity


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--spacing", type=float, default=0.25, help="[mm]")
    parser.add_argument("--ratio", type=float, default=4.0, help="horizon in spacings")
    parser.add_argument("--family", choices=["hu-ha-bobaru", "madenci-oterkus"], default="hu-ha-bobaru")
    parser.add_argument("--constants", choices=["lattice", "continuum"], default="lattice")
    wanted = parser.parse_args()
    spacing = 1e-3 * wanted.spacing
    show("reference", measure(simulate(spacing, wanted.ratio * spacing, wanted.family, wanted.constants)))
