"""The contact library alone: grains of a particle code in NumPy fall on a paddle wheel and make it turn.

    PYTHONPATH=build/release/python /usr/bin/python3 python/examples/grains.py [figure.png]

Without PYTHONPATH where the package is installed. Imports numpy and matplotlib (Debian: python3-numpy, python3-matplotlib).
"""

# %% The wheel: four paddles, each a box, on a shaft along y
import sys

import matplotlib.pyplot as plt
import numpy as np

from perimpact import fccda

box = fccda.Mesh.box(size=[0.05, 1.0, 1.6], edge_length=0.2)
quarter = np.array([[0, 0, 1], [0, 1, 0], [-1, 0, 0]])  # rotation by 90 degrees about y
vertices = np.vstack([box.vertices, box.vertices @ quarter.T])
faces = np.vstack([box.faces[:, :3], box.faces[:, :3] + len(box.vertices)])
paddles = fccda.Surface(fccda.Mesh(vertices, faces), name="paddles")
wheel = fccda.RigidBody(40.0, inertia=[12, 10, 12], free_dofs=["ry"])  # fixed in position, free to rotate about y
detector = fccda.ContactDetector(paddles, radius=0.01)

# %% The grains: a stream of balls that fall on one side of the wheel
rng = np.random.default_rng(7)
count, mass, dt = 6000, 0.01, 1e-3  # [-] [kg] [s]
x = rng.uniform([0.1, -0.45, 1.0], [0.6, 0.45, 7.0], (count, 3))
velocity = np.tile([0.0, 0.0, -1.0], (count, 1))
gravity = np.array([0, 0, -9.81])

# %% The particle code: its time loop with two calls of the library
times, spins, given = [], [], 0.0
start = mass * velocity[:, 2].sum()
for step in range(1000):
    x_t0 = x.copy()
    velocity += dt * gravity
    x += dt * velocity
    motion = wheel.advance(dt)
    contacts = detector.detect(motion, x_t0, x)
    sum = fccda.respond(contacts, motion, wheel, x_t0=x_t0, x_t1=x, velocity=velocity, mass=mass, friction=0.3, detector=detector)
    given += sum.impulse[2]
    times.append((step + 1) * dt)
    spins.append(wheel.angular_velocity[1])

lost = start + 1000 * dt * count * mass * gravity[2] - mass * velocity[:, 2].sum()
print(f"the wheel turns with {spins[-1]:.2f} rad/s after 1 s")
print(f"momentum balance of grains and wheel: {abs(lost - given) / abs(given):.0e} relative error")
print(f"grains inside a paddle: {len(detector.points_inside(wheel.pose, x))}")

# %% Draw the grains about the wheel
figure, (scene, curve) = plt.subplots(1, 2, figsize=(8, 4), layout="constrained")
scene.scatter(x[:, 0], x[:, 2], s=1.5, color="tab:brown", linewidths=0)
corners = wheel.pose.to_world(paddles.vertices)
for triangle in corners[paddles.triangles]:
    scene.fill(triangle[:, 0], triangle[:, 2], color="tab:blue", linewidth=0)
scene.set(xlim=(-1.5, 1.5), ylim=(-1.5, 1.5), aspect="equal", xlabel="x [m]", ylabel="z [m]", title="Grains after 1 s")
curve.plot(times, spins)
curve.set(xlabel="time [s]", ylabel="angular velocity [rad/s]", title="Angular velocity of the wheel", xlim=(0, 1))
curve.grid(alpha=0.3)
if len(sys.argv) > 1:
    figure.savefig(sys.argv[1], dpi=130)
else:
    plt.show()
