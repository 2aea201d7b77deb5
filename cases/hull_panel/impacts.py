#!/usr/bin/python3
"""Ice hits the panel of this case: rigid, by its vibration modes, and by finite elements (panel.py) that take part in each step.

    PYTHONPATH=build/release/python cases/hull_panel/impacts.py OUT sphere finite        one of: sphere floe, one of: rigid modal finite

Writes OUT/<ice>_<panel>.npz: histories of force, deflection, stress and balances, which figures.py and README.md use.
"""

import sys
from pathlib import Path

import numpy as np
import perimpact
from panel import SAFETY, ExplicitPanel, Model

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
    ice = {"shape": {"box": {"size": size}}, "rotate": [0, tilt, 0], "position": [AT[0], AT[1], low + 0.6 * spacing], "velocity": [0, 0, -speed], "spacing": spacing,
           "material": ELASTIC | {"critical_stretch": 3.2e-4}}  # fmt: skip
    return {"ice": ice}, 24e-3


ICE = {"sphere": ice_sphere, "floe": ice_floe}


def setup_of(name, model, panel, modes_file=None):
    bodies, end = ICE[name]()
    mesh = perimpact.Mesh(model.points[: model.wet], model.faces)
    impactor = {"surface": {"file": mesh, "orientation": "normals"}, "mass": 1.0}
    if panel == "modal":
        impactor["elastic"] = {"modes": str(modes_file)}
    return {"title": f"{name}, {panel} panel", "time": {"end": end, "step": STEP}, "bodies": bodies, "impactors": {"panel": impactor},
            "contact": {"fragments": {"law": "repulsive"}}, "output": {"frames": 0, "history_interval": 5e-5}}  # fmt: skip
