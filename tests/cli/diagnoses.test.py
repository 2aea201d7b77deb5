"""Warnings before a run and at its end."""

from claims import changed, claim, main

SURFACE = "surface: {cylinder: {diameter: 40 mm, height: 40 mm, axis: z, edge_length: 4 mm}}"


def warnings(out):
    return [line.removeprefix("warning: ") for line in out.splitlines() if line.startswith("warning: ")]


def box_as_obj(half, inward):
    """A cube of six quads, in metres."""
    corners = [(x, y, z) for z in (-half, half) for y in (-half, half) for x in (-half, half)]
    faces = [(1, 3, 4, 2), (5, 6, 8, 7), (1, 2, 6, 5), (3, 7, 8, 4), (1, 5, 7, 3), (2, 4, 8, 6)]
    lines = ["v %g %g %g" % corner for corner in corners] + ["f %d %d %d %d" % (face[::-1] if inward else face) for face in faces]
    return "\n".join(lines) + "\n"


@claim("diagnoses: a valid deck yields no warning, in check, in run and in run.json")
def _(t):
    for command in "check", "run":
        t.assertEqual(warnings(t.expect_success(command, t.deck(), "--out", "r").out), [])
    t.assertEqual(t.report("r")["warnings"], [])


@claim("diagnoses: an implausible density of a body or impactor yields a warning, one with its unit does not")
def _(t):
    def reported(*changes):
        return [each for each in warnings(t.expect_success("check", t.deck(*changes), "--out", "r").out) if "density" in each]

    steel, mass = "density: 8000 kg/m3", "mass: 1 kg"
    # the numbers of Abaqus's millimetres and tonnes and of handbooks; osmium is the heaviest element
    for written, body in (("7.8e-9", "7.8e-09"), ("7.8", "7.8"), ("22.6", "22.6"), ("78e3", "7.8e+04")):
        printed = reported((steel, f"density: {written}"))
        t.assertEqual(len(printed), 1, written)
        t.assertTrue(printed[0].startswith(f"The density of plate is {body} kg/m3, but solids have 23 to 23000 kg/m3. "), printed)
    for written in ("7.8e-9 t/mm3", "7.8 g/cm3", "22590", "30"):
        t.assertEqual(reported((steel, f"density: {written}")), [], written)
    t.assertIn("The density of cylinder is 7.85 kg/m3", reported((mass, "density: 7.85"))[0])
    t.assertEqual(reported((mass, "density: 7850")), [])


@claim("diagnoses: a body of fewer than four layers yields a warning, unless its bending is calibrated")
def _(t):
    three = ("[100 mm, 60 mm, 20 mm]", "[100 mm, 60 mm, 15 mm]")
    printed = warnings(t.expect_success("check", t.deck(three), "--out", "r").out)
    t.assertEqual(printed, ["Body plate is only 3 particles thick, which makes its stiffness inaccurate, especially in bending. Use a spacing that gives at least 4 "
                            "layers, preferably 6."])  # fmt: skip
    t.assertEqual(warnings(t.expect_success("check", t.deck(three, ("spacing: 5 mm", "spacing: 5 mm\n    bending_calibration: z")), "--out", "r").out), [])


@claim("diagnoses: an inward-oriented surface is reversed with a warning, in check, run and run.json")
def _(t):
    deck = t.deck((SURFACE, "surface: {file: cube.obj}"))
    (t.folder / "cube.obj").write_text(box_as_obj(0.02, inward=False))
    t.assertEqual(warnings(t.expect_success("run", deck, "--out", "right").out), [])
    (t.folder / "cube.obj").write_text(box_as_obj(0.02, inward=True))
    refined = t.deck((SURFACE, "surface: {file: cube.obj}\n    refine: {all: {edge_length: 10 mm}}"))
    t.assertIn("point inward in 1 of its 1 components", t.expect_success("check", refined, "--out", "r").out)
    deck = t.deck((SURFACE, "surface: {file: cube.obj}"))
    for command in "check", "run":
        printed = warnings(t.expect_success(command, deck, "--out", "r").out)
        t.assertEqual(len(printed), 1)
        t.assertIn("The normals of impactor cylinder point inward in 1 of its 1 components and were reversed", printed[0])
    t.assertEqual(t.report("r")["warnings"], printed)
    t.assertEqual(t.history("r"), t.history("right"))


@claim("diagnoses: an impactor without contact is reported after the timers of a run, and in run.json")
def _(t):
    out = t.expect_success("run", t.deck(("-32 m/s", "32 m/s")), "--out", "r").out
    printed = warnings(out)
    t.assertEqual(len(printed), 1)
    t.assertRegex(printed[0], r"^Impactor cylinder had no contact with body plate until t = 2e-05 s: the smallest distance was \S+ m, at t = 0 s\.")
    t.assertGreater(out.index(printed[0]), out.index("monitors"))
    t.assertEqual(t.report("r")["warnings"], printed)


@claim("diagnoses: initial penetration is removed or projected as requested, and the first row has no force")
def _(t):
    sunk = ("position: [0, 50 mm, 0]", "position: [0, 45 mm, 0]")
    found = {}
    for choice in "remove", "project":
        deck = t.deck(sunk, ("to: [0, 30 mm, 0]", "to: [0, 20 mm, 0]"), ("detector: swept}", f"detector: swept, initial_overlap: {choice}}}"))
        checked = warnings(t.expect_success("check", deck, "--out", choice).out)
        t.assertEqual(warnings(t.expect_success("run", deck, "--out", choice).out), checked)
        report, history = t.report(choice), t.history(choice)
        found[choice] = report["impactors"]["cylinder"]["detection"]["plate"]["initial_overlap"]
        t.assertEqual(len(checked), 1)
        t.assertIn(f"{found[choice]} particles that were inside its surface", checked[0])
        t.assertEqual(report["warnings"], checked)
        t.assertEqual(report["bodies"]["plate"]["particles"], 960 - (found[choice] if choice == "remove" else 0))
        t.assertEqual(history["cylinder.force_y [N]"][0], 0)
        t.assertAlmostEqual(history["total.momentum_y [kg m/s]"][-1], -32, delta=32e-10)  # kept to rounding, as after any start
    t.assertEqual(found["remove"], found["project"])
    t.assertGreater(found["remove"], 0)
    done = t.run_program("run", t.deck(sunk), "--out", "error")
    t.expect_complaint(done, 2, "deck.yaml:", f"{found['remove']} particles", "contact.impactors.initial_overlap: remove or project.")


def of(t, word, *changes, arguments=()):
    return [each for each in warnings(t.expect_success("check", t.deck(*changes), "--out", "r", *arguments).out) if word in each]


@claim("diagnoses: a modulus outside the range of solids yields a warning with the probable unit, gels and diamond do not")
def _(t):
    modulus = "youngs_modulus: 191 GPa"
    t.assertEqual(
        of(t, "modulus", (modulus, "youngs_modulus: 70")),
        ["Young's modulus of body plate is 70 Pa, but solids have 1 kPa to 2 TPa. If it is in another unit, append the unit, as in 70 GPa."])
    t.assertEqual(
        of(t, "modulus", (modulus, "youngs_modulus: 191e12")),
        ["Young's modulus of body plate is 1.91e+14 Pa, but solids have 1 kPa to 2 TPa. Check its unit."])
    for plausible in "2 kPa", "1.2 TPa":
        t.assertEqual(of(t, "modulus", (modulus, f"youngs_modulus: {plausible}")), [], plausible)


ICE = """\
title: Sheet
time: {end: 1 s}
bodies:
  sheet:
    shape: {box: {size: [1.5, 1.5, 0.75]}}
    position: [0, 0, -0.284 m]
    spacing: 0.125
    boundary_conditions: {sea: {floating: {level: 0}}}
    material: {model: bond-based, youngs_modulus: 3 GPa, density: 900, flexural_strength: 0.5 MPa, plasticity: {compressive_strength: 3 MPa}}
impactors:
  ball:
    surface: {sphere: {diameter: 1, edge_length: 0.2}}
    position: [2 m, 0, 0]
    mass: 100
    velocity: [-1, 0, 0]
contact:
  impactors: {crushing_pressure: 3 MPa, friction: 0.1}
  fragments: {law: repulsive, friction: 0.2}
"""


def of_ice(t, *changes):
    (t.folder / "ice.yaml").write_text(changed(ICE, *changes))
    return t.expect_success("check", "ice.yaml", "--out", "r").out


@claim("diagnoses: strengths below 1 kPa or above a tenth of Young's modulus yield a warning, those of ice do not")
def _(t):
    t.assertEqual(warnings(of_ice(t)), [])
    flexural, compressive, crushing = "flexural_strength: 0.5 MPa", "{compressive_strength: 3 MPa}", "crushing_pressure: 3 MPa"
    range_of = "but solids have 1 kPa to a tenth of Young's modulus, 3e+08 Pa here."
    unit = "If it is in another unit, append the unit, as in {} MPa."
    t.assertEqual(warnings(of_ice(t, (flexural, "flexural_strength: 0.5"))), [f"The flexural_strength of body sheet is 0.5 Pa, {range_of} {unit.format('0.5')}"])
    t.assertEqual(warnings(of_ice(t, (compressive, "{compressive_strength: 3 GPa}"))), [f"The compressive_strength of body sheet is 3e+09 Pa, {range_of} Check its unit."])
    t.assertEqual(
        warnings(of_ice(t, (crushing, "crushing_pressure: 4"))), [f"The crushing_pressure of the contact with impactors is 4 Pa, {range_of} {unit.format('4')}"])
    t.assertEqual(warnings(of_ice(t, (crushing, "crushing_pressure: 1 kPa"))), [])


@claim("diagnoses: a body that yields before it breaks in bending yields a warning also where a stretch or an energy gives its flexural strength")
def _(t):
    flexural = "flexural_strength: 0.5 MPa"
    for criterion in "critical_stretch: 3e-3", "fracture_energy: 50 kJ/m2":
        found = warnings(of_ice(t, (flexural, criterion)))
        t.assertEqual(len(found), 1, criterion)
        t.assertRegex(found[0], "^The compressive_strength of body sheet is 3e[+]06 Pa, not above its flexural strength of .* Pa, which follows from the stretch")
    t.assertEqual(warnings(of_ice(t, (flexural, "critical_stretch: 1e-4"))), [])


@claim("diagnoses: a body at rest that floats elsewhere than at its level yields a warning with its equilibrium, one that falls does not")
def _(t):
    # 900/1025 of 0.75 m are under water: the middle is 0.2835 m below the level
    place = "position: [0, 0, -0.284 m]"
    above = of_ice(t, (place, "position: [0, 0, 0]"))
    t.assertEqual(warnings(above), ["The water level of sheet.sea is 0 m, but in its position the body floats at a level of 0.2835 m: it will heave. Move the body by -0.2835 m "
                                    "in z, or give it level: 0.2835."])  # fmt: skip
    t.assertIn("water level 0 m, in equilibrium at 0.2835 m\n", above)
    t.assertEqual(warnings(of_ice(t, (place, "position: [0, 0, -0.2985 m]"))), [])  # by 2 % of its thickness
    t.assertEqual(len(warnings(of_ice(t, (place, "position: [0, 0, -0.2986 m]")))), 1)
    t.assertEqual(warnings(of_ice(t, (place, "position: [0, 0, 5 m]\n    velocity: [0, 0, -3 m/s]"))), [])
    t.assertRegex(warnings(of_ice(t, ("density: 900", "density: 1030")))[0], "^The particles of sheet.sea are heavier than the water that they displace, and sink.")


@claim("diagnoses: check prints friction and crushing pressure of the contact, given or by default")
def _(t):
    given = of_ice(t)
    t.assertIn("contact\n  impactors         friction 0.1, material is crushed at 3e+06 Pa\n", given)
    t.assertIn("  fragments         repulsive, friction 0.2, stiffness factor 15, restitution 1\n", given)
    contact = ICE[ICE.index("contact:") :]
    t.assertIn("contact\n  impactors         friction 0, rigid\ntime\n", of_ice(t, (contact, "contact: {fragments: {law: none}}\n")))


@claim("diagnoses: a body that may break without contact between its fragments yields a warning, unless the deck chooses the law, also none")
def _(t):
    breaking = ("density: 8000 kg/m3", "density: 8000 kg/m3, critical_stretch: 0.002")
    contact = "contact:\n"
    t.assertEqual(
        of(t, "fragments", breaking),
        ["Body plate may break, but there is no contact between its fragments: they pass through one another. Add contact: {fragments: {law: repulsive}}, or "
         "law: none, if this does not matter."])
    for law in "none", "repulsive":
        t.assertEqual(of(t, "fragments", breaking, (contact, f"contact:\n  fragments: {{law: {law}}}\n")), [], law)
    t.assertEqual(of(t, "fragments"), [])


@claim("diagnoses: a body that hardens so much under pressure that its bonds break in no uniaxial compression yields a warning")
def _(t):
    breaking = ("density: 8000 kg/m3}", "density: 8000 kg/m3, critical_stretch: 0.002}\n    failure: {compression_hardening: HARDENING}")
    contact = ("contact:\n", "contact:\n  fragments: {law: repulsive}\n")
    for hardening, says in ("0", 0), ("0.249", 0), ("0.25", 1), ("0.3", 1):
        printed = of(t, "compression_hardening", (breaking[0], breaking[1].replace("HARDENING", hardening)), contact)
        t.assertEqual(
            printed,
            says * [f"The compression_hardening of body plate is {hardening}, not below Poisson's ratio, 0.25: it carries any uniaxial compression. Use a smaller one, or "
                    "plasticity with the compressive_strength of the material."], hardening)  # fmt: skip


@claim("diagnoses: warnings of one kind are grouped: more than three name the first and the other subjects, and pairs without contact are one line")
def _(t):
    plate = "    material: {model: ordinary-state, youngs_modulus: 191 GPa, poissons_ratio: 0.25, density: 8000 kg/m3}\n"
    body = "  b{0}: {{shape: {{box: {{size: [20 mm, 20 mm, 20 mm]}}}}, spacing: 5 mm, position: [{1}, 1, 0], material: {{model: bond-based, youngs_modulus: 1 GPa, density: 8}}}}\n"
    many = plate.replace("8000 kg/m3", "8") + "".join(body.format(k, k) for k in range(1, 9))
    deck = t.deck((plate, many))
    printed = warnings(t.expect_success("run", deck, "--out", "r").out)
    density = [each for each in printed if "density" in each]
    t.assertEqual(density, [
        "The density of plate is 8 kg/m3, but solids have 23 to 23000 kg/m3. If it is in another unit, append the unit, as in 7.8 g/cm3 or 7.8e-9 t/mm3. The same "
        "applies to 8 others: b1, b2, b3, b4, b5, …"])
    apart = [each for each in printed if "no contact until" in each]
    t.assertEqual(len(apart), 1)
    t.assertRegex(apart[0], r"^\d of 9 pairs of an impactor and a body had no contact until t = 2e-05 s\. The smallest distance was \S+ m, of impactor cylinder from body \S+ "
                  r"at t = \S+ s\. Check positions, velocities, units and contact bounds, or run longer\.$")
    t.assertEqual(t.report("r")["warnings"], printed)
    # up to three are printed singly
    three = plate.replace("8000 kg/m3", "8") + "".join(body.format(k, k) for k in range(1, 3))
    t.assertEqual(len(of(t, "density", (plate, three))), 3)


main()
