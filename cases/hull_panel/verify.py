#!/usr/bin/python3
"""The finite elements of this case against theory, and the panel's modes against the panel, both under the same moving load:

    cases/hull_panel/verify.py                  prints the numbers of README.md, "The panel, checked"; two minutes on one core
    cases/hull_panel/verify.py moving.npz       also writes the curves of the moving load, for figures.py
"""

import argparse

import numpy as np
from panel import BAYS, BREADTH, DENSITY, FLANGE, HEIGHT, PLATING, POISSON, SAFETY, SPACING, WEB, YOUNG, ExplicitPanel, Model, grid, merged

COUNTS = 20, 40, 80, 160, 240, 320  # modes
SHOWN = 240
PATCH, TOTAL, SPEED = (0.6, 0.4), 100e3, 25.0  # [m] along x, y; [N]; [m/s] along y, across the frames


def plate(count, side=1.0):
    points, quads = grid((side, 0, 0), (0, side, 0), (0, 0, 0), (count, count), 0)
    points -= [side / 2, side / 2, 0]
    edge = np.abs(points[:, :2]).max(axis=1) > side / 2 - 1e-9
    return Model(mesh=(points, quads, np.full(len(quads), PLATING), np.zeros(len(quads), int)), clamped=edge)


def check_plate(count):
    """A clamped square plate of 1 m, over thin-plate theory: deflection under uniform pressure, 0.00126532 p a⁴/D
    (R. L. Taylor, S. Govindjee: Commun. Numer. Methods Eng. 20 (2004) 757), and ω a² √(ρt/D) = 35.985, 73.394 (twice), 108.22 (A. W. Leissa: J. Sound
    Vib. 31 (1973) 257)."""
    model = plate(count)
    rigidity = YOUNG * PLATING**3 / 12 / (1 - POISSON**2)
    deflection = -model.solve(model.pressure(1.0))[:, 2].min() / (0.00126532 / rigidity)
    frequencies = model.modes(4)[0] * np.sqrt(DENSITY * PLATING / rigidity) / [35.985, 73.394, 73.394, 108.22]
    return deflection, frequencies


def check_frame(per_height):
    """A cantilever of one frame with its flanges, L = 2 m, under a transverse force at its end, over F L³/(3 E I) + F L/(G A_web). The plating is as broad as the flange, so
    that no shear lag matters."""
    length = 2.0
    size = HEIGHT / per_height
    parts = [grid((length, 0, 0), (0, BREADTH, 0), (0, -BREADTH / 2, 0), (round(length / size), 2), 0)]
    for first, second, corner, counts in (((length, 0, 0), (0, 0, -HEIGHT), (0, 0, 0), (round(length / size), per_height)),
                                          ((length, 0, 0), (0, BREADTH, 0), (0, -BREADTH / 2, -HEIGHT), (round(length / size), 2))):  # fmt: skip
        parts.append(grid(first, second, corner, counts, sum(len(points) for points, _ in parts)))
    points, quads = merged(np.vstack([points for points, _ in parts]), np.vstack([cells for _, cells in parts]))
    part = np.repeat([0, 1, 2], [len(cells) for _, cells in parts])
    thickness = np.array([PLATING, WEB, FLANGE])[part]
    model = Model(mesh=(points, quads, thickness, part), clamped=points[:, 0] < 1e-9)
    end = np.flatnonzero((points[:, 0] > length - 1e-9) & (np.abs(points[:, 1]) < 1e-9))
    forces = np.zeros((len(points), 6))
    forces[end, 2] = -1.0 / len(end)
    deflection = -model.solve(forces)[end, 2].mean()
    areas, places = np.array([PLATING * BREADTH, WEB * HEIGHT, FLANGE * BREADTH]), np.array([0, -HEIGHT / 2, -HEIGHT])
    centroid = areas @ places / areas.sum()
    inertia = areas @ (places - centroid) ** 2 + WEB * HEIGHT**3 / 12 + (PLATING**3 + FLANGE**3) * BREADTH / 12
    return deflection / (length**3 / (3 * YOUNG * inertia) + length / (YOUNG / (2 * (1 + POISSON)) * WEB * HEIGHT))


class MovingLoad:
    """A pressure patch, cos² in both directions, of TOTAL newtons that crosses the panel along y; forces are interpolated between samples."""

    def __init__(self, model, interval=1e-4):
        half = BAYS * SPACING / 2 + PATCH[1] / 2
        self.end = 2 * half / SPEED
        self.interval = interval
        self.samples = []
        for k in range(int(np.ceil(self.end / interval)) + 2):
            centre = -half + SPEED * k * interval

            def pressure(x, y, centre=centre):
                a, b = x / PATCH[0], (y - centre) / PATCH[1]
                inside = (np.abs(a) < 0.5) & (np.abs(b) < 0.5)
                return np.where(inside, 4 * TOTAL / (PATCH[0] * PATCH[1]) * np.cos(np.pi * a) ** 2 * np.cos(np.pi * b) ** 2, 0)

            self.samples.append(model.pressure(pressure)[: model.wet, 2])
        self.samples = np.array(self.samples)
        self.shape = len(model.points), 6

    def normal(self, time):
        k, part = divmod(time / self.interval, 1)
        k = min(int(k), len(self.samples) - 2)
        return (1 - part) * self.samples[k] + part * self.samples[k + 1]

    def __call__(self, time):
        forces = np.zeros(self.shape)
        normal = self.normal(time)
        forces[: len(normal), 2] = normal
        return forces


def superpose(frequencies, loads, dt):
    """Modal coordinates (steps, modes) after each step dt under modal forces loads (steps + 1, modes), linear in between; exact."""
    w = frequencies
    c, s = np.cos(w * dt), np.sin(w * dt)
    q, p = np.zeros_like(w), np.zeros_like(w)
    found = []
    for before, after in zip(loads[:-1], loads[1:]):
        slope = (after - before) / dt
        a, b = q - before / w**2, p - slope / w**2  # of the free vibration around the static solution
        q = a * c + b / w * s + after / w**2
        p = -a * w * s + b * c + slope / w**2
        found.append(q)
    return np.array(found)


def move_load(model, every=40, end=None):
    """Under the moving load, by finite elements: times [s] and, there, the deflection (rows, wet) [m] of the plating, stresses (rows, wet, 6) on its wet side; how far
    momentum and energy are from balance, over the impulse and the work of the load."""
    load = MovingLoad(model)
    dt = SAFETY * model.stable_step()
    panel = ExplicitPanel(model, load)
    times, deflection, stress, residual, energy = [], [], [], 0.0, 0.0
    for step in range(int((end or load.end) / dt)):
        panel.advance(step * dt, dt)
        if step % every == every - 1:
            times.append((step + 1) * dt)
            deflection.append(panel.displacements()[: model.wet, 2].copy())
            stress.append(model.wet_stresses(panel.u))
            residual = max(residual, np.abs(panel.momentum - panel.load_impulse - panel.support_impulse).max())
            energy = max(energy, abs(panel.kinetic_energy + panel.elastic_energy - panel.work))
    return {"times": np.array(times), "deflection": np.array(deflection), "stress": np.array(stress), "impulse": residual / abs(panel.load_impulse[2]),
            "energy": energy / panel.work, "steps": step + 1, "step": dt}  # fmt: skip


def superpose_moving_load(model, modes, times):
    """Deflection and stress as move_load(), of these modes."""
    frequencies, shapes = modes
    normal = shapes.reshape(-1, 6, len(frequencies))[: model.wet, 2]
    load = MovingLoad(model)
    loads = np.array([load.normal(time) @ normal for time in (0.0, *times)])
    q = superpose(frequencies, loads, times[0])
    return q @ normal.T, np.einsum("vck,tk->tvc", model.wet_stresses(shapes), q)


def deviation(finite, modal):
    """Largest difference over the largest magnitude."""
    return np.abs(finite - modal).max() / np.abs(finite).max()


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("file", nargs="?", help="moving.npz, for figures.py")
    file = arguments.parse_args().file
    for count in (8, 16, 32):
        deflection, frequencies = check_plate(count)
        print(f"clamped plate, {count} elements a side: deflection {deflection:.4f}, frequencies {' '.join(f'{f:.4f}' for f in frequencies)} of thin-plate theory")
    for per_height in (2, 4, 8):
        print(f"frame, {per_height} elements over its height: deflection {check_frame(per_height):.4f} of beam theory")
    for per_bay in (4, 8, 16):
        model = Model(per_bay)
        u = model.solve(model.pressure(1e5))
        print(f"panel, {per_bay} elements a bay: {len(model.points)} nodes, {model.shell.masses.sum():.2f} kg, deflection under 100 kPa {-1e3 * u[:, 2].min():.4f} mm, lowest "
              f"frequency {model.modes(1)[0][0] / 2 / np.pi:.2f} Hz, stable step {1e6 * model.stable_step():.3f} us")  # fmt: skip
    model = Model(8)
    frequencies, shapes = model.modes(COUNTS[-1])
    print(f"modes: {frequencies[0] / 2 / np.pi:.1f} to {frequencies[-1] / 2 / np.pi:.1f} Hz")
    found = move_load(model)
    print(f"moving load, finite elements: {found['steps']} steps of {1e6 * found['step']:.3f} us; momentum residual {found['impulse']:.1e} of the impulse, energy residual {found['energy']:.1e} of the work")
    print(f"largest deflection {1e3 * np.abs(found['deflection']).max():.4f} mm")
    for count in COUNTS:
        deflection, stress = superpose_moving_load(model, (frequencies[:count], shapes[:, :count]), found["times"])
        if count == SHOWN:
            shown = deflection
        print(f"    {count} modes, to {frequencies[count - 1] / 2 / np.pi:.0f} Hz: deflection differs by {100 * deviation(found['deflection'], deflection):.3f} %, stress by "
              f"{100 * deviation(found['stress'], stress):.2f} % of the largest")  # fmt: skip
    if file:
        np.savez_compressed(file, times=found["times"], finite=found["deflection"], modal=shown, points=model.points[: model.wet])


if __name__ == "__main__":
    main()
