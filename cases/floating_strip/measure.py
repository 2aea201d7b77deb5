#!/usr/bin/python3
"""Results of a floating strip: deflections, moments, stiffness, failure load, and distance of the crack.

    cases/floating_strip/measure.py results/floating_strip       prints the numbers of README.md

The deck has a body `ice` along x, its free edge at the lower end and loaded in its last column of particles by the boundary condition `load`.
"""

import sys
from pathlib import Path

import numpy as np
from theory import Elements, Strip

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "scripts/results"))
from csv_reader import history  # noqa: E402
from results_folder import options, refuse, report_of, run  # noqa: E402
from vtp_reader import read_vtp, series  # noqa: E402

CUT = 0.3  # damage of a particle at a crack: a plane through the lattice cuts 0.4 of the bonds of adjacent particles


class Run:
    """Lattice and frames of a run. Sections are the columns of particles across the strip, starting at the free edge."""

    def __init__(self, folder):
        self.folder = Path(folder)
        self.report = report_of(self.folder)
        self.pictures = [file for _, file in series(self.folder, "ice")]
        places = read_vtp(self.pictures[0]).points.astype(float)
        body = self.report["setup"]["bodies"]["ice"]
        self.spacing, self.length = body["spacing"], body["shape"]["box"]["size"][0]
        self.section, self.row, self.layer = (np.rint((places[:, p] - places[:, p].min()) / self.spacing).astype(int) for p in range(3))
        self.layers = int(self.layer.max()) + 1
        self.x = self.spacing * (np.arange(self.section.max() + 1) + 0.5)
        material, boundaries = body["material"], body["boundary_conditions"]
        self.strip = Strip(
            height=self.layers * self.spacing,
            young=material["youngs_modulus"],
            poisson=material["poissons_ratio"],
            ice=material["density"],
            plate="sides" in boundaries,
        )
        load = boundaries["load"]["body_force"]
        self.at = self.spacing / 2  # x of the load [m]
        self.full_load = -load["force_density"][2] * self.spacing * self.strip.height  # down [N/m]
        self.times, self.factors = load["times"], load["factors"]

    def load(self, time):
        return self.full_load * float(np.interp(time, self.times, self.factors))

    def theory(self):
        return Elements(self.strip, self.length)

    def history(self):
        return history(self.folder)

    def mean(self, values):
        """Of the particles of each section."""
        return np.bincount(self.section, values) / np.bincount(self.section)

    def by_layer(self, values):
        """Means across the strip: a row a layer, a column a section."""
        sums = np.zeros((self.layers, len(self.x)))
        np.add.at(sums, (self.layer, self.section), values)
        return sums / (self.row.max() + 1)


def bent(run, number=-1):
    """An unbroken state: deflection w, moment and curvature of the sections, and what follows from them."""
    picture = read_vtp(run.pictures[number])
    strip, x, load = run.strip, run.x, run.load(picture.time)
    u = run.by_layer(picture.point["displacement"][:, 0].astype(float))
    w = -run.mean(picture.point["displacement"][:, 2].astype(float))
    # by statics, independent of the ice: load and water up to a section
    water = strip.foundation * run.spacing * w
    moment = load * np.maximum(x - run.at, 0) - np.array([(water[:i] * (at - x[:i])).sum() for i, at in enumerate(x)])
    # rotation of the sections, without shear, which the second derivative of w would include
    z = (np.arange(run.layers) - 0.5 * (run.layers - 1)) * run.spacing
    turn = z @ u / (z @ z)
    window = max(1, round(0.5 * strip.height / run.spacing))
    curvature = np.zeros_like(x)
    curvature[window:-window] = (turn[2 * window :] - turn[: -2 * window]) / (2 * window * run.spacing)
    inside = (x > 2 * strip.height) & (x < 1.5 / strip.rate)
    beside_edge = (x > strip.height / 2) & (x < 1.5 * strip.height)  # the loaded column itself is indented
    # of bonds along x in the outermost layers, including the rotation, which contributes 3 % of the small stretch
    between = np.diff([run.by_layer(moved)[[0, -1]] for moved in picture.point["displacement"].T.astype(float)], axis=2) / run.spacing
    stretch = np.sqrt((1 + between[0]) ** 2 + between[1] ** 2 + between[2] ** 2) - 1
    return {
        "load": load,
        "w": w,
        "moment": moment,
        "edge": float(np.polyval(np.polyfit(x[beside_edge], w[beside_edge], 1), 0)),
        "stiffness": abs((moment[inside] @ moment[inside]) / (curvature[inside] @ moment[inside])),
        "stretch": stretch[:, x[:-1] > 2 * strip.height].max(),
    }


def compared(run):
    """An unbroken state relative to elementary theory with the load at its actual position: ratios, and metres."""
    state, strip = bent(run), run.strip
    theory = run.theory()
    w, moment = theory.solve(state["load"], run.at)
    first = (1 - 1 / run.layers) * strip.strength / strip.modulus / state["stretch"] * abs(state["load"])
    return {
        "edge deflection": state["edge"] / w[0],
        "bending stiffness": state["stiffness"] / strip.stiffness,
        "largest moment": np.abs(state["moment"]).max() / np.abs(moment).max(),
        "its distance [m]": float(run.x[np.abs(state["moment"]).argmax()]),
        "curve": float(np.abs(np.interp(run.x, theory.x, w) - state["w"]).max() / abs(w[0])),
        "first bond": first / theory.breaking_load(run.at),
    }


def broken(run):
    """The load [N/m] at which the first bond breaks; of the first frame with a through-crack, its load and the distance of the crack from the edge [m].

    The lowest quarter of the layers is ignored: under compression, it stays intact for a while as a hinge.
    """
    history = run.history()
    bonds = history["ice.broken_bonds [-]"]
    if bonds[-1] == 0:
        return {}
    at = int(np.argmax(bonds > 0))
    found = {"first bond [N/m]": run.load(history["time [s]"][at]), "first bond, time [s]": history["time [s]"][at]}
    for path in run.pictures:
        picture = read_vtp(path)
        through = np.flatnonzero((run.by_layer(picture.point["damage"])[(run.layers + 3) // 4 :] > CUT).all(axis=0))
        if len(through):
            crack = through[: int(np.argmax(np.diff(np.append(through, 10**9)) > run.layers)) + 1]
            found |= {"crack, time [s]": picture.time, "crack [N/m]": run.load(picture.time), "distance [m]": float(run.x[crack].mean())}
            break
    return found


def main():
    strip_run = Run(options(__doc__).parse_args().results)
    strip, theory = strip_run.strip, strip_run.theory()
    print(f"theory: {strip.breaking_load / 1e3:.1f} kN/m with the load on the edge, {strip.breaking_distance:.1f} m from it")
    print(f"        {theory.breaking_load(strip_run.at) / 1e3:.1f} kN/m with the load in the last column, {theory.breaking_load(strip_run.at, flooded=True) / 1e3:.1f} where water gets onto the ice")
    for name, value in broken(strip_run).items():
        print(f"{name:22}{value:.4g}")


if __name__ == "__main__":
    run(main)
