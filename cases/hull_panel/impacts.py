#!/usr/bin/python3
"""Ice hits the panel of this case: rigid, by its vibration modes, and by finite elements (panel.py) that take part in each step.

    PYTHONPATH=build/release/python cases/hull_panel/impacts.py OUT [sphere floe [rigid modal finite]]      minutes each on one core

Writes OUT/<ice>_<panel>.npz with histories of force, deflection, stress and balances, for figures.py, and prints their largest values.

"modal": the reactions of the clamped edges are not known; the residual of momentum compares the contact force with the ice at the end.
"rigid": the ice hits a rigid panel, and the panel of finite elements takes the impulses of that contact, without an effect on the ice: what a design does
that has the force of a rigid panel.
"""

import argparse
from pathlib import Path

import numpy as np
import perimpact
from panel import ExplicitPanel, Model
from perimpact import modes

STEP = 2e-6  # [s] below the stable step of the panel, which is by far the shorter one
MODES = 240
ELASTIC = {"model": "ordinary-state", "youngs_modulus": 1.8e9, "poissons_ratio": 0.25, "density": 900}
AT = [0.0, 0.2, 0.0]  # [m] on a frame


def ice_sphere(speed=1.0, spacing=0.05):
    """The sphere of cases/ice_sphere/deck.yaml, slower."""
    ice = {"shape": {"sphere": {"diameter": 1.0}}, "position": [AT[0], AT[1], 0.5 + 0.001], "velocity": [0, 0, -speed], "spacing": spacing,
           "material": ELASTIC | {"critical_stretch": 0.01}}  # fmt: skip
    return {"ice": ice}, 16e-3


def ice_floe(speed=3.0, spacing=0.04):
    """A block that meets the panel with an edge, oblique, and breaks; E s_c = 0.58 MPa."""
    size = [1.0, 0.8, 0.4]
    tilt = np.radians(20)
    low = 0.5 * (size[0] * np.sin(tilt) + size[2] * np.cos(tilt))
    ice = {"shape": {"box": {"size": size}}, "rotate": [0, tilt, 0], "position": [AT[0], AT[1], low + 0.15 * spacing], "velocity": [0, 0, -speed], "spacing": spacing,
           "material": ELASTIC | {"critical_stretch": 3.2e-4}}  # fmt: skip
    return {"ice": ice}, 16e-3


ICE = {"sphere": ice_sphere, "floe": ice_floe}
PANELS = "rigid", "modal", "finite"


def setup_of(name, model, panel, modes_file=None):
    bodies, end = ICE[name]()
    mesh = perimpact.Mesh(model.points[: model.wet], model.faces)
    impactor = {"surface": {"file": mesh, "orientation": "normals"}, "mass": 1.0}
    if panel == "modal":
        impactor["elastic"] = {"modes": str(modes_file)}
    return {"title": f"{name}, {panel} panel", "time": {"end": end, "step": STEP}, "bodies": bodies, "impactors": {"panel": impactor},
            "contact": {"fragments": {"law": "repulsive"}}, "output": {"frames": 0, "history_interval": 5e-5}}  # fmt: skip


class OneWay:
    """Finite elements that take the impulses of a rigid panel's contacts."""

    def __init__(self, model):
        self.panel, self.model = ExplicitPanel(model), model
        corners = model.points[: model.wet, :2]
        self.low = corners.min(axis=0)
        self.x, self.y = (np.unique(np.round(corners[:, axis], 9)) for axis in (0, 1))
        # the nodes of the plating come row by row
        assert np.allclose(corners[:, 0].reshape(len(self.y), -1), self.x)

    def take(self, contacts, time, dt):
        self.panel.advance(time, dt)
        impulses = np.zeros((self.model.wet, 3))
        places, given = contacts["position"], contacts["impulse"]
        cells, shares = [], []
        for axis, line in ((0, self.x), (1, self.y)):
            at = np.clip((places[:, axis] - line[0]) / (line[1] - line[0]), 0, len(line) - 1 - 1e-9)
            cells.append(at.astype(int))
            shares.append(at - cells[-1])
        for a in (0, 1):
            for b in (0, 1):
                share = (shares[0] if a else 1 - shares[0]) * (shares[1] if b else 1 - shares[1])
                np.add.at(impulses, (cells[1] + b) * len(self.x) + cells[0] + a, share[:, None] * given)
        self.panel.apply(impulses)


class Recorder:
    """Histories of a run: one row every `every` steps."""

    def __init__(self, model, simulation, density, spacing):
        self.model, self.simulation, self.rows = model, simulation, []
        self.body = simulation.bodies["ice"]
        self.particle = density * spacing**3
        self.start = self.ice_momentum()
        self.largest = {"deflection": -1.0}

    def ice_momentum(self):
        return self.particle * self.body.velocities[self.body.slots].sum(axis=0)

    def row(self, u, residual):
        """`u`: displacements of the panel, (6n,); `residual`: of the momentum, [N s]."""
        deflection = -u.reshape(-1, 6)[: self.model.wet, 2]
        self.rows.append([self.simulation.time, deflection.max(), *self.model.largest_stress(u), residual])
        if deflection.max() > self.largest["deflection"]:
            slots = self.body.slots
            self.largest = {"deflection": deflection.max(), "u": u.copy(), "ice": self.body.positions[slots], "damage": self.body.damages[slots]}

    def arrays(self):
        times, deflection, plating, webs, flanges, residual = np.array(self.rows).T
        picture = {f"picture_{name}": values for name, values in self.largest.items()}
        return {"times": times, "deflection": deflection, "plating": plating, "webs": webs, "flanges": flanges, "residual": residual, **picture}


def finite(setup, model, recorder_of, every=25):
    panel = ExplicitPanel(model)
    simulation = perimpact.Simulation(setup, structures={"panel": panel})
    recorder = recorder_of(simulation)

    def record(_):
        lost = recorder.start - recorder.ice_momentum()
        recorder.row(panel.u, np.abs(panel.momentum - panel.support_impulse - lost).max())

    simulation.run(callback=record, every=every)
    return simulation, recorder


def rigid(setup, model, recorder_of, every=25):
    one_way = OneWay(model)
    simulation = perimpact.Simulation(setup)
    recorder = recorder_of(simulation)
    impactor = simulation.impactors["panel"]
    count = 0

    def record(_):
        nonlocal count
        one_way.take(impactor.contacts, simulation.time - simulation.dt, simulation.dt)
        count += 1
        if count % every == 0:
            lost = recorder.start - recorder.ice_momentum()
            recorder.row(one_way.panel.u, np.abs(one_way.panel.contact_impulse - lost).max())

    simulation.run(callback=record)
    return simulation, recorder


def modal(setup, model, recorder_of, shapes, every=25):
    simulation = perimpact.Simulation(setup)
    recorder = recorder_of(simulation)
    impactor = simulation.impactors["panel"]
    columns = shapes.reshape(-1, 6, shapes.shape[1])[: model.wet, :3].reshape(-1, shapes.shape[1])
    coordinates = np.linalg.pinv(columns)

    def record(_):
        moved = impactor.current_vertices - model.points[: model.wet]
        recorder.row(shapes @ (coordinates @ moved.ravel()), 0.0)

    simulation.run(callback=record, every=every)
    history = simulation.history
    given = -np.sum(history["panel.force_z [N]"] * np.diff(history["time [s]"], prepend=0))
    recorder.rows[-1][-1] = abs(given + (recorder.start - recorder.ice_momentum())[2])
    return simulation, recorder


def write_modes(file, model, count):
    frequencies, shapes = model.modes(count)
    stresses = model.wet_stresses(shapes)
    wet = shapes.reshape(-1, 6, count)[: model.wet, :3]
    modes.write(file, model.points[: model.wet], model.faces, frequencies / (2 * np.pi), wet.transpose(2, 0, 1), stresses.transpose(2, 0, 1))
    return shapes


def run(name, panel, model, folder):
    if panel == "modal":
        modes_file = folder / "modes.vtu"
        shapes = write_modes(modes_file, model, MODES)
    setup = setup_of(name, model, panel, modes_file if panel == "modal" else None)
    ice = setup["bodies"]["ice"]

    def recorder_of(simulation):
        return Recorder(model, simulation, ice["material"]["density"], ice["spacing"])

    if panel == "modal":
        simulation, recorder = modal(setup, model, recorder_of, shapes)
    else:
        simulation, recorder = {"finite": finite, "rigid": rigid}[panel](setup, model, recorder_of)
    history = simulation.history
    impulse = np.linalg.norm(recorder.start)
    found = recorder.arrays()
    found |= {"time": history["time [s]"], "force": -history["panel.force_z [N]"], "start": impulse, "energy": history["total.energy [J]"],
              "balance_error": history["total.energy_balance_error [J]"], "broken": recorder.body.broken_bonds, **{name.split(" ")[0]: values for name, values in history.items() if name.startswith(("total.", "ice.", "panel.elastic", "panel.structure"))}}  # fmt: skip
    np.savez_compressed(folder / f"{name}_{panel}.npz", **found)
    return found


def report(name, panel, found):
    steps = np.diff(found["time"], prepend=0)
    print(f"{name}, {panel}: force {found['force'].max() / 1e3:.1f} kN, impulse {np.sum(found['force'] * steps) / found['start']:.4f} of m v, deflection {1e3 * found['deflection'].max():.3f} mm, "
          f"stress {found['plating'].max() / 1e6:.1f} MPa plating, {found['webs'].max() / 1e6:.1f} webs, {found['flanges'].max() / 1e6:.1f} flanges; broken bonds {found['broken']}; "
          f"momentum residual {found['residual'].max() / found['start']:.1e}, energy balance error {np.abs(found['balance_error']).max() / found['energy'][0]:.1e}", flush=True)  # fmt: skip


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("folder", metavar="OUT", type=Path)
    arguments.add_argument("words", nargs="*", metavar="WORD", help=f"of {', '.join([*ICE, *PANELS])}; all where nothing is given")
    given = arguments.parse_args()
    for word in set(given.words) - {*ICE, *PANELS}:
        arguments.error(f"{word} is none of {', '.join([*ICE, *PANELS])}")
    perimpact.use_threads(1)
    folder, words = given.folder, given.words
    folder.mkdir(parents=True, exist_ok=True)
    model = Model()
    for name in [word for word in words if word in ICE] or ICE:
        for panel in [word for word in words if word in PANELS] or PANELS:
            report(name, panel, run(name, panel, model, folder))


if __name__ == "__main__":
    main()
