"""Results do not depend on the number of threads: not in a single bit."""

from claims import claim, main

PLATE = ["--set", "output.frames=0"]
ORDINARY = ["--set", "bodies.plate.material.poissons_ratio=0.3"]
BREAKING = ["--set", "bodies.plate.material.critical_stretch=0.002", "--set", "time.end=60 us"]
TUMBLING = ["--set", "impactors.cylinder.free_dofs=[x, y, z, rx, ry, rz]", "--set", "impactors.cylinder.angular_velocity=[300, 200, 1000]", "--set",
            "contact.impactors.friction=0.2", "--set", "impactors.cylinder.position=[3 mm, 56 mm, 2 mm]", "--set", "time.end=300 us"]


def state_with(t, threads, settings):
    t.expect_success("run", "deck.yaml", "--threads", threads, "--out", f"r{threads}", "--force", *PLATE, *settings)
    report = t.report(f"r{threads}")
    t.assertEqual(report["threads"], threads)
    return report["state_hash"]


def same_for_any_number(t, *settings):
    t.deck()
    states = [state_with(t, threads, settings) for threads in (1, 2, 4)]
    t.assertEqual(states, states[:1] * 3)
    histories = [(t.folder / f"r{threads}/history.csv").read_bytes() for threads in (1, 2, 4)]
    t.assertTrue(histories[0] == histories[1] == histories[2], "the histories differ")
    history = t.history("r1")
    t.assertGreater(max(history["cylinder.contacts [-]"]), 0, "nothing was struck")
    return states[0], history


@claim("threads: 1, 2 and 4 are bitwise identical for the impact on a plate")
def _(t):
    same_for_any_number(t)


@claim("threads: 1, 2 and 4 are bitwise identical with a dilatation, at a Poisson's ratio of 0.3")
def _(t):
    same_for_any_number(t, *ORDINARY)


@claim("threads: 1, 2 and 4 are bitwise identical with bond failure")
def _(t):
    for material in ([], ORDINARY):
        _, history = same_for_any_number(t, *BREAKING, *material)
        t.assertGreater(history["plate.broken_bonds [-]"][-1], 100)


@claim("threads: 1, 2 and 4 are bitwise identical for a free, rotating impactor with friction")
def _(t):
    _, history = same_for_any_number(t, *TUMBLING, *ORDINARY)
    spin = [history[f"cylinder.angular_velocity_{axis} [rad/s]"] for axis in "xyz"]
    t.assertTrue(all(abs(each[-1] - each[0]) > 1 for each in spin), f"contact must have changed the spin: {[each[-1] for each in spin]}")


@claim("threads: the state is reproducible, and changes if the impactor is a little faster")
def _(t):
    t.deck()
    first = state_with(t, 1, [])
    t.assertEqual(state_with(t, 1, []), first)
    t.assertNotEqual(state_with(t, 1, ["--set", "impactors.cylinder.velocity=[0, -32.000000001, 0]"]), first)


main()
