"""`perimpact shape`: surfaces from their dimensions, as files and in decks."""

import csv
import math
import re

from claims import claim, main

HULL = "--length 155 --breadth 23 --draft 9 --stem-angle 24deg --waterline-angle 22deg --edge-length 5 --bow-edge-length 2".split()
PROPELLER = "--diameter 4.12 --pitch-ratio 0.76 --area-ratio 0.669 --hub-ratio 0.301 --edge-length 0.3 --blade-edge-length 0.15".split()


def facts(text):
    return {match[1]: match[2] for match in re.finditer(r"^  (\S.*?) {2,}(\S.*)$", text, re.MULTILINE)}


@claim("shape: a hull is reported, written and read back as the same closed surface with its parts")
def _(t):
    made = t.expect_success("shape", "hull", *HULL, "-o", "hull.obj")
    printed = facts(made.out)
    t.assertEqual(printed["closure"], "closed")
    t.assertEqual(printed["bow, stern"], "56.927 and 39.837 m long")  # 23/tan 22° and 23/tan 30°
    t.assertAlmostEqual(float(printed["displacement"].split()[0]), 21630, delta=300)  # chords of 5 m
    t.assertAlmostEqual(float(printed["block coeff."]), 0.674, delta=0.01)
    read = t.expect_success("mesh", "hull.obj").out
    for name in ("panels", "size", "closure", "components", "area", "volume"):
        t.assertEqual(facts(read)[name], printed[name])
    for part in ("bow", "side", "stern", "bilge", "bottom", "deck"):
        t.assertRegex(read, rf"\b{part}: \d+ panels")


@claim("shape: a propeller is reported with its area ratio, chord and thickness, and written as STL")
def _(t):
    printed = facts(t.expect_success("shape", "propeller", *PROPELLER, "--out", "screw.stl").out)
    t.assertEqual(printed["closure"], "closed")
    t.assertEqual(printed["components"], "5")
    t.assertEqual(printed["area ratio"], "expanded 0.6699 outside r/R = 0.167, 0.5701 outside this hub")
    t.assertEqual(printed["at 0.7 R"], f"chord 1.477 m, thickness 0.06427 m, pitch angle {math.degrees(math.atan(0.76 / 0.7 / math.pi)):.4g} deg")
    t.assertRegex(t.expect_success("mesh", "screw.stl").out, r"blade_4: \d+ panels")


@claim("shape: the list contains every generated surface, and each lists its options")
def _(t):
    listed = t.expect_success("shape", "--list").out
    for name in ("cylinder", "sphere", "box", "hull", "propeller"):
        t.assertRegex(listed, rf"(?m)^{name} +\S.*\.$")
        t.assertIn("--edge-length", t.expect_success("shape", name, "--help").out)
    t.assertIn("--sections-radius", t.expect_success("shape", "propeller", "--help").out)
    t.assertEqual(facts(t.expect_success("shape", "box", "--size", "[1, 2, 3]", "--edge-length", "0.5").out)["volume"], "6 m3")


@claim("shape: missing, wrong-unit and out-of-range values and invalid shapes are one sentence")
def _(t):
    def complaint(*arguments):
        return t.run_program("shape", *arguments)

    t.expect_complaint(complaint("hull"), 2, "perimpact shape hull: --length is missing, a number [m]; perimpact shape hull --help")
    wrong = list(HULL)
    wrong[wrong.index("--length") + 1] = "5 kg"
    t.expect_complaint(complaint("hull", *wrong), 2, "--length: length is \"5 kg\", but that is a mass")
    t.expect_complaint(complaint("hull", *HULL, "--fullness", "9"), 2, "--fullness: fullness is 9, but it must be from 1 to 4")
    t.expect_complaint(complaint("hull", *HULL, "--bilge-radius", "10"), 2, "hull: bilge_radius is 10 m")
    t.expect_complaint(complaint("propeller", "--diameter", "4", "--edge-length", "0.2"), 2, "propeller: pitch_ratio is missing")
    t.expect_complaint(complaint("hull", *HULL, "-o", "hull.ply"), 2, "hull.ply: surfaces are written as .stl or .obj")
    for out, why in (("far/hull.stl", "there is no folder far. Create it first"), ("full.txt/hull.stl", "full.txt is not a folder."), ("hull.obj", "it is a folder.")):
        (t.folder / "full.txt").touch()
        (t.folder / "hull.obj").mkdir(exist_ok=True)
        done = complaint("hull", *HULL, "-o", out)
        t.expect_complaint(done, 2, f"{out} cannot be written: {why}")
        t.assertEqual(done.out, "")  # before the work


@claim("shape: a deck has hull and propeller under the same keys, and reports invalid shapes at their position")
def _(t):
    hull = "surface: {hull: {length: 155 mm, breadth: 23 mm, draft: 9 mm, stem_angle: 24 deg, waterline_angle: 22 deg, edge_length: 5 mm}}"
    screw = "surface: {propeller: {diameter: 60 mm, pitch_ratio: 0.8, area_ratio: 0.6, edge_length: 5 mm}}"
    old = "surface: {cylinder: {diameter: 40 mm, height: 40 mm, axis: z, edge_length: 4 mm}}"
    for surface, part in ((hull, "bow"), (screw, "blade_1")):
        checked = t.expect_success("check", t.deck((old, surface), ("[0, 50 mm, 0]", "[0, 150 mm, 0]"))).out
        t.assertRegex(checked, rf"\b{part}: \d+ panels")
    bad = hull.replace("draft: 9 mm", "draft: 9 mm, bilge_radius: 10 mm")
    deck = t.deck((old, bad))
    t.expect_complaint(t.run_program("check", deck), 2, "deck.yaml:", "hull: bilge_radius is 0.01 m")


@claim("shape: without friction the ice force on the bow of a generated ship has the ratio cot φ, for any panels and stem radius")
def _(t):
    deck = """\
time: {end: 0.3 s}
bodies:
  floe:
    shape: {box: {size: [30, 36, 2]}}
    spacing: 1
    position: [-17, 0, -0.7]
    material: {model: ordinary-state, youngs_modulus: 1.8 GPa, poissons_ratio: 0.25, density: 900, critical_stretch: 3.2e-4}
impactors:
  ship:
    surface: {hull: {length: 155, breadth: 23, draft: 9, stem_angle: 24 deg, waterline_angle: 22 deg, edge_length: 8, bow_edge_length: 3, stem_radius: STEM}}
    mass: 22171 t
    velocity: [-20, 0, 0]
    gauges: {bow: {surface_parts: [bow]}}
output: {frames: 0, history_interval: 0.3 s}
"""
    forces = []
    for stem_radius in ("0", "2 m"):
        (t.folder / "ship.yaml").write_text(deck.replace("STEM", stem_radius))
        t.expect_success("run", "ship.yaml", "--threads", "1", "--out", f"results_{stem_radius[0]}")
        last = list(csv.DictReader((t.folder / f"results_{stem_radius[0]}/history.csv").open()))[-1]
        along, up = (float(last[f"ship.bow.force_{axis} [N]"]) for axis in "xz")
        t.assertGreater(along, 1e4)
        t.assertAlmostEqual(up / along / (1 / math.tan(math.radians(24))), 1, delta=1e-9)  # rounding of a few hundred impulses
        forces.append(along)
    t.assertNotAlmostEqual(forces[0] / forces[1], 1, delta=0.01)  # another shape


main()
