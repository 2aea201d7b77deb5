"""User forces."""

import copy

import package
from claims import claim, main

import numpy as np
import perimpact


def free_plate(**changes):
    """The plate without impactor, and its time step."""
    setup = copy.deepcopy(package.SETUP)
    del setup["impactors"], setup["contact"]
    setup["time"].update(changes)
    return setup


@claim("a user force equals the deck's body_force in motion, work and momentum")
def as_body_force(test):
    density = [3e7, 0, -1e7]  # [N/m3]
    deck = free_plate()
    deck["bodies"]["plate"]["boundary_conditions"] = {"push": {"body_force": {"force_density": density}}}
    ours = perimpact.Simulation(free_plate(), forces={"plate": {"push": lambda time, body: density}})
    theirs = perimpact.Simulation(deck)
    ours.run(), theirs.run()
    a, b = ours.bodies["plate"], theirs.bodies["plate"]
    moved = np.abs(b.displacements).max()
    np.testing.assert_allclose(a.displacements, b.displacements, rtol=0, atol=1e-12 * moved + 1e-16)  # w/V · f and positions round differently from f
    test.assertEqual(list(ours.history), list(theirs.history))
    for column in ("plate.push.force_x [N]", "plate.push.work [J]", "total.momentum_z [kg m/s]"):
        np.testing.assert_allclose(ours.history[column], theirs.history[column], rtol=1e-9)  # sums of 960 terms in another order, over 100 steps


@claim("under a uniform force the body falls as symplectic Euler predicts, from the first step")
def falls(test):
    acceleration = np.array([0, 0, -9.81])
    simulation = perimpact.Simulation(free_plate(), forces={"plate": {"weight": lambda time, body: body.density * acceleration}})
    simulation.run()
    plate, n = simulation.bodies["plate"], simulation.step_number
    wanted = acceleration * simulation.dt**2 * n * (n + 1) / 2  # x_n = X + Σ k a dt²
    far = 0.06  # [m] magnitude of the coordinates, for rounding
    np.testing.assert_allclose(plate.displacements[plate.slots], np.broadcast_to(wanted, (len(plate), 3)), rtol=0, atol=n * n * 1e-16 * far)


@claim("with a spring on every particle the body oscillates at the analytical frequency, and energy is conserved")
def swings(test):
    omega = 2e5  # [rad/s] 0.6 of a period in the run
    amplitude = 1e-5  # [m]
    setup = free_plate(end=20e-6, step=2e-7)
    setup["bodies"]["plate"]["velocity"] = [omega * amplitude, 0, 0]

    def spring(time, body):
        return -body.density * omega**2 * body.displacements

    simulation = perimpact.Simulation(setup, forces={"plate": {"spring": spring}})
    simulation.run()
    plate = simulation.bodies["plate"]
    # all particles move alike, so bonds do not deform. Symplectic Euler: 2 sin(Ω dt/2) = ω dt, and velocities are half a step behind
    dt, n = simulation.dt, simulation.step_number
    phase = 2 * np.arcsin(0.5 * omega * dt)
    x = [0.0, omega * amplitude * dt]
    while len(x) <= n:
        x.append(2 * x[-1] - x[-2] - (omega * dt) ** 2 * x[-1])
    test.assertAlmostEqual(plate.displacements[plate.slots, 0].mean() / amplitude, x[n] / amplitude, delta=1e-9)  # rounding of positions, 1e-17/1e-5, by n²
    test.assertAlmostEqual(x[n] / (omega * amplitude * dt), np.sin(n * phase) / np.sin(phase), places=9)
    history = simulation.history
    kinetic, work = history["plate.kinetic_energy [J]"], history["plate.spring.work [J]"]
    test.assertGreater(np.ptp(work), 0.9 * kinetic.max())  # it supplied nearly all kinetic energy
    # the velocity of each instant is interpolated, which has a ripple of (ω dt)² = 1.6e-3
    np.testing.assert_allclose(kinetic - work, kinetic[0], rtol=0, atol=2e-3 * kinetic.max())
    # the balance accounts for the ripple and closes to rounding, at the level of the rounding of positions in bonds
    test.assertLess(np.abs(history["total.energy_balance_error [J]"]).max(), 1e-9 * kinetic.max())


@claim("a force may be given for all particles, per particle or per slot, with the same result")
def shapes(test):
    def per_particle(time, body):
        return 1e6 * np.stack([body.references[body.slots, 1], 0 * body.slots, time * 1e9 + 0 * body.slots], axis=1)

    def per_slot(time, body):
        forces = np.full((len(body.occupied), 3), np.nan)  # empty slots are not evaluated
        forces[body.slots] = per_particle(time, body)
        return forces[:, ::-1][:, ::-1]  # a view with different strides

    hashes = []
    for function in (per_particle, per_slot):
        simulation = perimpact.Simulation(free_plate(), forces={"plate": {"own": function}})
        simulation.run()
        hashes.append(simulation.state_hash)
    test.assertEqual(hashes[0], hashes[1])
    same_for_all = perimpact.Simulation(free_plate(), forces={"plate": {"own": lambda time, body: (1, 2, 3)}})
    per_each = perimpact.Simulation(free_plate(), forces={"plate": {"own": lambda time, body: np.tile([1.0, 2, 3], (len(body), 1))}})
    same_for_all.run(), per_each.run()
    test.assertEqual(same_for_all.state_hash, per_each.state_hash)


@claim("an invalid user force is refused with a sentence, and an exception in its function propagates and ends the simulation")
def refused(test):
    def made(function, body="plate"):
        return perimpact.Simulation(free_plate(), forces={body: {"own": function}})

    with test.assertRaises(perimpact.InputError) as error:
        made(lambda time, body: np.zeros((7, 3)))
    test.assertEqual(
        str(error.exception),
        "the user force plate.own returned an array of the shape (7, 3), but must return force densities [N/m3] of the shape (3,) for all particles, "
        "(960, 3) per particle or (1152, 3) per slot.",
    )
    with test.assertRaises(perimpact.InputError) as error:
        made(lambda time, body: None)
    test.assertTrue(str(error.exception).startswith("the user force plate.own returned nothing, but"), error.exception)
    with test.assertRaises(perimpact.InputError) as error:
        made(lambda time, body: 0, body="plat")
    test.assertEqual(str(error.exception), "forces refers to body plat, which does not exist; did you mean plate?")
    for forces, sentence in (
        ([1], 'forces is of type list, but it must be a dict {"body": {"name": function}}.'),
        ({3: {"own": print}}, "forces: 3 is a key, but keys are names of bodies."),
        ({"plate": print}, 'forces["plate"] is of type builtin_function_or_method, but it must be a dict {"name": function}.'),
        ({"plate": {3: print}}, 'forces["plate"]: 3 is a key, but keys are names of user forces.'),
        ({"plate": {"own": 3}}, 'forces["plate"]["own"] is of type int, but it must be a function of time and body.'),
    ):
        with test.assertRaises(perimpact.InputError) as error:
            perimpact.Simulation(free_plate(), forces=forces)
        test.assertEqual(str(error.exception), sentence)
    with test.assertRaises(perimpact.RunError) as error:
        made(lambda time, body: [np.nan, 0, 0])
    test.assertIn("plate.own is not finite on 960 particles", str(error.exception))
    relaxing = free_plate(relax={})
    del relaxing["output"]
    with test.assertRaises(perimpact.InputError) as error:
        perimpact.Simulation(relaxing, forces={"plate": {"own": lambda time, body: [0, 0, 0]}})
    test.assertTrue(str(error.exception).startswith("time.relax: user forces such as own are not supported with time.relax"), error.exception)

    def fails_later(time, body):
        if time > 5e-6:
            raise ZeroDivisionError("as the user's code has it")
        return [0, 0, 0]

    simulation = made(fails_later)
    with test.assertRaisesRegex(ZeroDivisionError, "as the user's code has it"):
        simulation.run()
    with test.assertRaisesRegex(perimpact.RunError, "aborted by an error"):
        simulation.step()


@claim("references to the body kept by a function remain valid where the simulation failed to build")
def kept(test):
    seen = []

    def keeps(time, body):
        seen.extend([body, body.positions, body.damages])
        raise LookupError("not today")

    with test.assertRaises(LookupError):
        perimpact.Simulation(free_plate(), forces={"plate": {"own": keeps}})
    body, positions, damages = seen
    test.assertTrue(np.isfinite(positions[:960]).all() and damages.sum() == 0)
    with test.assertRaises(perimpact.RunError):
        body.positions


main()
