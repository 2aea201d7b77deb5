"""An impactor made with NumPy hits a small plate of ice; plots the force on it.

    PYTHONPATH=build/release/python /usr/bin/python3 python/examples/impact.py [figure.png]

Without PYTHONPATH where the package is installed. Imports numpy and matplotlib (Debian: python3-numpy, python3-matplotlib).
"""

# %% The impactor: a cone of 16 faces, its tip downwards
import sys

import matplotlib.pyplot as plt
import numpy as np

import perimpact

sides, radius, height = 16, 0.015, 0.02  # [m]
angles = 2 * np.pi * np.arange(sides) / sides
rim = np.column_stack([radius * np.cos(angles), radius * np.sin(angles), np.full(sides, height)])
vertices = np.vstack([rim, [[0, 0, 0], [0, 0, height]]])
tip, middle = sides, sides + 1
after = np.roll(np.arange(sides), -1)
faces = [[a, tip, b] for a, b in enumerate(after)] + [[a, b, middle] for a, b in enumerate(after)]
cone = perimpact.Mesh(vertices, faces)

# %% The set-up: the keys of a deck, with Python numbers
setup = {
    "title": "A cone falls on a plate of ice",
    "time": {"end": "170 us"},
    "bodies": {
        "plate": {
            "shape": {"box": {"size": ["84 mm", "84 mm", "20 mm"]}},
            "spacing": "4 mm",
            "material": {"model": "ordinary-state", "youngs_modulus": "9 GPa", "poissons_ratio": 0.25, "density": 917, "critical_stretch": 2e-3},
        }
    },
    "impactors": {
        "cone": {"surface": {"file": cone}, "mass": 0.05, "position": [0, 0, 0.0105], "velocity": [0, 0, -30], "free_dofs": ["z"]},
    },
    "output": {"history_interval": "2 us"},
}
simulation = perimpact.Simulation(setup)

# %% Run it; record the depth of the tip every 10 steps
depths = []
simulation.run(callback=lambda s: depths.append(0.01 - s.impactors["cone"].origin[2]), every=10)

history = simulation.history
force = history["cone.force_z [N]"]
plate = simulation.bodies["plate"]
print(f"{len(plate)} particles, {simulation.steps} steps of {simulation.dt:.3g} s")
print(f"largest force: {force.max():.0f} N at {1e6 * history['time [s]'][force.argmax()]:.1f} us")
print(f"the cone penetrated {1e3 * max(depths):.2f} mm, and {plate.broken_bonds} bonds broke")

# %% Draw the force
figure, axes = plt.subplots(figsize=(7, 3.6), layout="constrained")
axes.step(1e6 * history["time [s]"], 1e-3 * force, where="pre", color="tab:blue")
axes.set(xlabel="time [µs]", ylabel="force on the cone [kN]", title="A cone made with NumPy hits ice at 30 m/s", xlim=(0, 170), ylim=(0, None))
axes.grid(alpha=0.3)
if len(sys.argv) > 1:
    figure.savefig(sys.argv[1], dpi=140)
else:
    plt.show()
