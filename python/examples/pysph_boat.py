"""Water of PySPH and surfaces of fccda: a dam breaks, and the wave lifts a boat that floats in the tank. PySPH computes the water, fccda its contact with
boat and tank, after each step.

    PYTHONPATH=build/release/python /usr/bin/python3 python/examples/pysph_boat.py [figure.png [seconds [spacing]]]

PySPH compiles its loops in the first run (a minute). Two dimensions, as a slice of 1 m.
Imports pysph, numpy and matplotlib (Debian: python3-pysph, python3-numpy, python3-matplotlib).
"""

# %% The surfaces: prisms along z, y points upwards
import sys

import matplotlib.pyplot as plt
import numpy as np
from pysph.base.kernels import CubicSpline
from pysph.base.nnps import LinkedListNNPS
from pysph.base.utils import get_particle_array_wcsph
from pysph.solver.solver import Solver
from pysph.sph.basic_equations import ContinuityEquation
from pysph.sph.equation import Group
from pysph.sph.integrator import EulerIntegrator
from pysph.sph.integrator_step import IntegratorStep
from pysph.sph.wc.basic import MomentumEquation, TaitEOS

from perimpact import fccda

end, spacing = (float(sys.argv[2]) if len(sys.argv) > 2 else 0.8), (float(sys.argv[3]) if len(sys.argv) > 3 else 0.01)
length, depth, dam = 2.0, 0.14, [0.5, 0.4]  # [m] of the tank, the water in it, the water behind the dam


def prism(outline, ends):
    """The walls of a prism along z, 1 m wide, normals to the left of the outline's direction."""
    count = len(outline)
    vertices = np.vstack([np.column_stack([outline, np.full(count, z)]) for z in (-0.5, 0.5)])
    walls = [[i, i + count, (i + 1) % count + count, (i + 1) % count] for i in range(count if ends else count - 1)]
    caps = [list(range(count)), list(range(2 * count - 1, count - 1, -1))] if ends else []
    return fccda.Mesh(vertices, walls + caps)


hull = np.array([[-0.15, 0.06], [0.15, 0.06], [0.1, -0.045], [-0.1, -0.045]])
boat_surface = fccda.Surface(prism(hull, ends=True), name="boat")
tank_surface = fccda.Surface(prism([[0, 2], [0, 0], [length, 0], [length, 2]], ends=False), orientation="normals", name="tank")
boat = fccda.RigidBody.filling(boat_surface, 400, position=[1.2, depth, 0], free_dofs=["x", "y", "rz"])
tank = fccda.RigidBody(1.0)  # no degree of freedom is free
boat_detector, tank_detector = (fccda.ContactDetector(surface, radius=0.45 * spacing) for surface in (boat_surface, tank_surface))

# %% The water: particles and equations of PySPH, weakly compressible
density, gravity = 1000.0, np.array([0, -9.81, 0])  # [kg/m3] [m/s2]
grid = np.stack(np.meshgrid(*(np.arange(spacing / 2, size, spacing) for size in (length, dam[1])), indexing="ij"), axis=-1).reshape(-1, 2)
grid = grid[(grid[:, 1] < depth) | (grid[:, 0] < dam[0])]
x = np.column_stack([grid, np.zeros(len(grid))])
x = np.delete(x, boat_detector.points_inside(boat.pose, x), axis=0)
mass, sound = density * spacing**2, 10 * np.sqrt(2 * 9.81 * dam[1])  # [kg] [m/s]
dt = 0.25 * spacing / sound
water = get_particle_array_wcsph(name="water", x=x[:, 0], y=x[:, 1], m=mass, h=1.3 * spacing, rho=density)


class Density(ContinuityEquation):
    """Advances the density with the velocities of the last step; the momentum equation then uses it."""

    def post_loop(self, d_idx, d_rho, d_arho, dt):
        d_rho[d_idx] += dt * d_arho[d_idx]


class Step(IntegratorStep):
    """Symplectic Euler. A particle moves with its new velocity, which is what fccda requires: x(t1) = x(t0) + dt velocity."""

    def stage1(self, d_idx, d_u, d_v, d_au, d_av, d_x, d_y, dt):
        d_u[d_idx] += dt * d_au[d_idx]
        d_v[d_idx] += dt * d_av[d_idx]
        d_x[d_idx] += dt * d_u[d_idx]
        d_y[d_idx] += dt * d_v[d_idx]


equations = [
    Group([Density("water", ["water"])]),
    Group([TaitEOS("water", None, rho0=density, c0=sound, gamma=7.0)]),
    Group([MomentumEquation("water", ["water"], c0=sound, alpha=0.1, beta=0.0, gy=gravity[1])]),
]
kernel = CubicSpline(dim=2)
solver = Solver(kernel=kernel, dim=2, integrator=EulerIntegrator(water=Step()), dt=dt, tf=end, adaptive_timestep=False, pfreq=10**9)

# %% The coupling, called by PySPH after each step
run = {"x": x, "given": np.zeros(3), "floor": [], "lost": 0, "residual": [], "energy": [], "frames": []}


def resolve(detector, body, dt, x_t0, x_t1, velocity):
    """One surface; changes x_t1, velocity and the body. Returns the points in contact."""
    motion = body.advance(dt)
    contacts = detector.detect(motion, x_t0, x_t1)
    sum = fccda.respond(contacts, motion, body, x_t0=x_t0, x_t1=x_t1, velocity=velocity, mass=mass, detector=detector)
    run["given"] += sum.impulse
    if body is tank:
        run["floor"].append(sum.impulse[1] / dt)
    return contacts["point"]


def state():
    return np.column_stack([water.x, water.y, water.z]), np.column_stack([water.u, water.v, water.w])


def contact(solver):
    dt = solver.dt  # PySPH shortens the last step to meet the end
    x_t1, velocity = state()
    boat.add_impulse(dt * boat.mass * gravity, [0, 0, 0])
    moved = resolve(boat_detector, boat, dt, run["x"], x_t1, velocity)
    resolve(tank_detector, tank, dt, run["x"], x_t1, velocity)
    for point in moved:
        tank_detector.moved(point)
    water.x[:], water.y[:] = x_t1[:, 0], x_t1[:, 1]
    water.u[:], water.v[:] = velocity[:, 0], velocity[:, 1]
    run["x"] = x_t1
    if solver.count % 20 == 0:
        observe(solver.t + dt)


# %% What is recorded: momentum, energy, and water where none should be
def observe(time):
    x, velocity = state()
    run["residual"].append(np.abs(mass * velocity.sum(axis=0) + run["given"] - time * mass * len(x) * gravity).max())
    kinetic = 0.5 * mass * (velocity**2).sum() + boat.kinetic_energy
    run["energy"].append(kinetic - mass * (x @ gravity).sum() - boat.mass * boat.position @ gravity)
    beyond = (x[:, 0] < 0) | (x[:, 0] > length) | (x[:, 1] < 0)
    run["lost"] += len(boat_detector.points_inside(boat.pose, x)) + int(beyond.sum())
    run["frames"].append((time, boat.pose, x[:, :2].copy(), np.linalg.norm(velocity, axis=1)))


observe(0.0)
solver.set_parallel_manager(None)
solver.setup([water], equations, LinkedListNNPS(dim=2, particles=[water], radius_scale=kernel.radius_scale))
solver.set_disable_output(True)
solver.add_post_step_callback(contact)
solver.solve(show_progress=False)

print(f"{len(x)} particles, {solver.count} steps: the boat has risen by {max(pose.position[1] for _, pose, *_ in run['frames']) - depth:.3f} m")
print(f"momentum of water, boat and tank: {max(run['residual']) / np.abs(run['given']).max():.0e} of the impulse does not balance")
print(f"energy: {run['energy'][0]:.2f} J, then never more than {max(run['energy'][1:]):.2f} J, at the end {run['energy'][-1]:.2f} J")
print(f"particles in the boat or outside the tank: {run['lost']}")
late = np.mean(run["floor"][-len(run["floor"]) // 4 :])
print(f"force on the tank, mean of the last quarter: {-late:.1f} N, weight of water and boat: {(mass * len(x) + boat.mass) * 9.81:.1f} N")

# %% Draw four times
figure, axes = plt.subplots(4, 1, figsize=(7, 6), dpi=90, layout="constrained")
for scene, which in zip(axes, np.linspace(0, len(run["frames"]) - 1, 4).round().astype(int)):
    time, pose, place, speed = run["frames"][which]
    dots = scene.scatter(*place.T, c=speed, s=4 * (spacing / 0.01) ** 2, cmap="viridis", vmin=0, vmax=2.5, linewidths=0)
    scene.fill(*pose.to_world(np.column_stack([hull, np.zeros(4)]))[:, :2].T, color="#d9a066", ec="#8a5a2b")
    scene.plot([0, 0, length, length], [0.5, 0, 0, 0.5], color="#22313f", lw=1)
    scene.set(xlim=(-0.01, length + 0.01), ylim=(-0.01, 0.5), aspect="equal")
    scene.text(length / 2, 0.42, f"{time:.2f} s", ha="center")
    scene.set_axis_off()
figure.colorbar(dots, ax=axes, label="speed [m/s]", shrink=0.5)
if len(sys.argv) > 1:
    figure.savefig(sys.argv[1])
else:
    plt.show()
