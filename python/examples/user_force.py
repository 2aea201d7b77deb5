"""A user force: a ball hits a plate on springs (Winkler foundation), and the plate rebounds.

    PYTHONPATH=build/release/python /usr/bin/python3 python/examples/user_force.py [figure.png]

Without PYTHONPATH where the package is installed. Imports numpy and matplotlib (Debian: python3-numpy, python3-matplotlib).
"""

# %% The plate and the ball
import sys

import matplotlib.pyplot as plt
import numpy as np

import perimpact

setup = {
    "title": "A ball falls on a plate on springs",
    "time": {"end": "0.8 ms", "step": "1 us"},
    "bodies": {
        "plate": {
            "shape": {"box": {"size": [0.2, 0.2, 0.02]}},
            "spacing": 0.005,
            "material": {"model": "ordinary-state", "youngs_modulus": "2 GPa", "poissons_ratio": 0.25, "density": 1000},
        }
    },
    "impactors": {
        "ball": {
            "surface": {"sphere": {"diameter": "60 mm", "edge_length": "4 mm"}},
            "mass": 0.2,
            "position": [0, 0, 0.0405],
            "velocity": [0, 0, -5],
            "free_dofs": ["z"],
        }
    },
    "output": {"history_interval": "10 us", "probes": {"centre": {"body": "plate", "at": [0, 0, 0]}}},
}

# %% The force: a Winkler foundation, distributed over the thickness of the plate
bedding = 2e9  # [N/m3] foundation stiffness: pressure per deflection
thickness = 0.02  # [m]


def springs(time, body):
    density = np.zeros_like(body.displacements)
    density[:, 2] = -bedding / thickness * body.displacements[:, 2]
    return density  # [N/m3] per slot


# %% With and without springs
deflections = {}
for name, forces in {"free": None, "on springs": {"plate": {"springs": springs}}}.items():
    simulation = perimpact.Simulation(setup, forces=forces)
    simulation.run()
    history = simulation.history
    deflections[name] = history["centre.displacement_z [m]"]
    print(f"{name}: the centre is at {1e3 * deflections[name][-1]:.2f} mm at the end, {1e3 * deflections[name].min():.2f} mm at the lowest")
print(f"work of the springs on the plate: {history['plate.springs.work [J]'][-1]:.3g} J")
print(f"the energy balance error is {np.abs(history['total.energy_balance_error [J]']).max():.1e} J of {0.5 * 0.2 * 5**2:.3g} J")

# %% Draw both
figure, axes = plt.subplots(figsize=(7, 3.6), layout="constrained")
for name, deflection in deflections.items():
    axes.plot(1e3 * history["time [s]"], 1e3 * deflection, label=name)
axes.set(xlabel="time [ms]", ylabel="centre of the plate [mm]", title="Springs under the plate return it", xlim=(0, 0.8))
axes.grid(alpha=0.3)
axes.legend(frameon=False)
if len(sys.argv) > 1:
    figure.savefig(sys.argv[1], dpi=140)
else:
    plt.show()
