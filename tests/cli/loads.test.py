"""What contact did to the impactor: its pressure-area curves."""

from claims import claim, main, table


@claim("loads: the process curve contains the normal force of history.csv and the faces of the particles, from the first contact on")
def _(t):
    t.expect_success("run", t.deck(("end: 20 us", "end: 40 us")), "--out", "r")
    history, curve = t.history("r"), table(t.folder / "r/pressure_area/cylinder.csv")
    first = next(k for k, force in enumerate(history["cylinder.force_y [N]"]) if force != 0)
    t.assertEqual(curve["time [s]"], history["time [s]"][first:])
    for k, force in enumerate(curve["normal_force [N]"]):
        # contact is along the lowest line of the cylinder and near it, where the normal is inclined and its y component smaller
        t.assertGreaterEqual(force, history["cylinder.force_y [N]"][first + k] * (1 - 1e-12))
        t.assertLess(force, history["cylinder.force_y [N]"][first + k] * 1.05 + 1e-9)
        faces = curve["contact_area [m2]"][k] / 0.005**2
        t.assertAlmostEqual(faces, round(faces), delta=1e-9)  # products of decimal fractions
        t.assertGreaterEqual(curve["contact_area [m2]"][k], curve["mean_contact_area [m2]"][k] * (1 - 1e-12))
        t.assertAlmostEqual(curve["mean_pressure [Pa]"][k] * curve["contact_area [m2]"][k], force, delta=1e-12 * force + 1e-9)


@claim("loads: the face of a particle of a plane body is its spacing times the thickness of the body")
def _(t):
    plane = ("spacing: 5 mm", "spacing: 5 mm\n    plane: stress")
    t.expect_success("run", t.deck(("end: 20 us", "end: 40 us"), plane, ("poissons_ratio: 0.25, ", "")), "--out", "r")
    areas = table(t.folder / "r/pressure_area/cylinder.csv")["contact_area [m2]"]
    t.assertAlmostEqual(min(areas) / (0.005 * 0.02), 2, delta=1e-9)  # two particles at first, on either side of the cylinder's lowest line
    t.assertAlmostEqual(max(areas) / (0.005 * 0.02), round(max(areas) / (0.005 * 0.02)), delta=1e-9)


@claim("loads: the spatial curve decreases, and ends at the total force of the peak")
def _(t):
    # rows as long as the load interval: a horizon of 15 mm at 4886 m/s is 3.07 us, in steps of 0.25 us
    t.expect_success("run", t.deck(("end: 20 us}", "end: 39 us, step: 0.25 us}"), ("history_interval: 2 us", "history_interval: 3 us")), "--out", "r")
    curve, peak = table(t.folder / "r/pressure_area/cylinder.csv"), table(t.folder / "r/pressure_area/cylinder_at_peak.csv")
    area, pressure = peak["area [m2]"], peak["mean_pressure [Pa]"]
    t.assertTrue(5 <= len(area) <= 20, area)
    t.assertEqual(area, sorted(area))
    t.assertGreater(pressure[0], pressure[-1])
    t.assertAlmostEqual(area[-1] * pressure[-1] / max(curve["normal_force [N]"]), 1, delta=1e-9)  # sums over the loaded panels


@claim("loads: without contact there is no curve, and that of an earlier run is removed")
def _(t):
    deck = t.deck()
    t.expect_success("run", deck, "--out", "r", "--force")
    t.assertIn("pressure_area/cylinder.csv", t.files("r"))
    t.expect_success("run", deck, "--out", "r", "--force", "--set", "impactors.cylinder.velocity=[0, 32, 0]")
    t.assertFalse([name for name in t.files("r") if name.startswith("pressure_area")])


main()
