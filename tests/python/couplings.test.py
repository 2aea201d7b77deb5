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
