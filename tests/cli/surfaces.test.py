"""Surfaces from files in decks: every key, what is refused, and contact independent of the form of the file."""

import gzip
import math
import re
import shutil
import subprocess
import unittest
from pathlib import Path

from claims import changed, claim, main, place_of
from shapes import Shape, defects, folded_prism, grid_box, half_hull, moebius, prism, two_rooms

GIVEN = "surface: {cylinder: {diameter: 40 mm, height: 40 mm, axis: z, edge_length: 4 mm}}"
PLACE = "position: [0, 50 mm, 0]"

# its lower face lies a tenth of a millimetre above the particles' spheres, and beyond the plate's edges along z
BOX, BOX_PLACE = (44.0, 40.0, 30.0), "position: [0.5 mm, 50.1 mm, 0]"

# turned by -90 degrees about z it points at the plate; its bow comes between the particles at x = -2.5 and 2.5 mm
HULL, BOW = "file: hull.obj, scale: 5e-6, rotate: [0, 0, -90 deg], translate: [0, 0, 3 mm]", "position: [0, 58 mm, 0]"
LONGER = ("end: 20 us", "end: 40 us")


def use(t, surface, place, *more, name="deck.yaml"):
    return t.deck((GIVEN, f"surface: {{{surface}}}"), (PLACE, place), *more, name=name)


def run(t, folder, *arguments):
    """History of a run with contact."""
    t.expect_success("run", *arguments, "--out", folder, "--threads", "1")
    history = t.history(folder)
    t.assertGreater(max(history["cylinder.contacts [-]"]), 0, folder)
    return history


def expect_close(t, one, other, flipped=()):
    """Equal to rounding, which grows over some hundred steps: sums run over panels and particles in another order. Counts are exact."""
    t.assertEqual(one.keys(), other.keys())
    t.assertEqual(one["cylinder.contacts [-]"], other["cylinder.contacts [-]"])
    kinds = {}
    for name, values in one.items():  # components of one vector have one size, by which rounding is measured
        kind = name.replace("_x", "").replace("_y", "").replace("_z", "")
        kinds[kind] = max(kinds.get(kind, 0), *map(abs, values))
    for name, values in one.items():
        if name == "total.energy_balance_error [J]":
            continue  # itself rounding, of differences of energies
        size = kinds[name.replace("_x", "").replace("_y", "").replace("_z", "")]
        sign = -1 if any(word in name for word in flipped) else 1
        for a, b in zip(values, other[name]):
            t.assertAlmostEqual(a, sign * b, delta=1e-9 * size, msg=name)


@claim("surfaces: half a hull with mirror_merge behaves as the whole hull")
def _(t):
    (t.folder / "hull.obj").write_text(half_hull().obj())
    half = run(t, "half", use(t, HULL + ", mirror_merge: y", BOW, LONGER))
    t.assertEqual(t.report("half")["impactors"]["cylinder"]["surface"]["closure"], "closed")
    (t.folder / "hull.obj").write_text(half_hull().with_image(1).obj())
    whole = run(t, "whole", use(t, HULL, BOW, LONGER))
    expect_close(t, half, whole)
    surfaces = [t.report(folder)["impactors"]["cylinder"]["surface"] for folder in ("half", "whole")]
    t.assertEqual(surfaces[0]["parts"], surfaces[1]["parts"])
    t.assertAlmostEqual(surfaces[0]["volume [m3]"] / surfaces[1]["volume [m3]"], 1, delta=1e-12)  # rounding


@claim("surfaces: a mirrored surface yields mirrored results")
def _(t):
    wedge = prism([(0.0, 0.0), (10.0, 20.0), (-4.0, 20.0)], 30.0)  # steeper on one side, with its edge towards the plate
    (t.folder / "wedge.obj").write_text(wedge.moved(lambda p: (p[0], p[1], p[2] - 15)).obj())
    place = "position: [0, 29 mm, 0]"
    port, starboard = (run(t, mirror, use(t, f"file: wedge.obj, scale: 0.001, mirror: {mirror}", place, LONGER)) for mirror in ("none", "x"))
    expect_close(t, port, starboard, flipped=("position_x", "force_x", "moment_y", "moment_z", "momentum_x", "displacement_x"))
    t.assertGreater(max(map(abs, port["cylinder.force_x [N]"])), 0.01 * max(port["cylinder.force_y [N]"]))  # so it is not its own image


@claim("surfaces: scale, mirror, mirror_merge, rotate and translate act in this order, about the axes x, y and z in this order")
def _(t):
    try:
        from vtp_reader import read_vtp
    except ImportError as missing:
        raise unittest.SkipTest(f"{missing.name} is not installed")
    (t.folder / "box.obj").write_text(grid_box((20, 30, 40), (1, 1, 1)).moved(lambda p: (p[0] + 30, p[1] + 15, p[2] + 50)).obj())
    keys = "file: box.obj, scale: 0.001, mirror: x, mirror_merge: y, rotate: [20 deg, -30 deg, 40 deg], translate: [1 mm, 20 cm, 3 mm]"
    t.expect_success("check", use(t, keys, "position: [0, 0, 0]"), "--out", "r")
    found = [tuple(point) for point in read_vtp(t.folder / "r" / "check" / "cylinder_surface.vtp").points.tolist()]

    def turned(p, axis, degrees):
        c, s, u, v = math.cos(math.radians(degrees)), math.sin(math.radians(degrees)), (axis + 1) % 3, (axis + 2) % 3
        q = list(p)
        q[u], q[v] = c * p[u] - s * p[v], s * p[u] + c * p[v]
        return q

    expected = []
    for x in (-0.020, -0.040):  # mirrored
        for y in (-0.030, 0, 0.030):  # completed: the file's box ends at y = 0
            for z in (0.030, 0.070):
                p = (x, y, z)
                for axis, degrees in enumerate((20, -30, 40)):
                    p = turned(p, axis, degrees)
                expected.append((p[0] + 0.001, p[1] + 0.2, p[2] + 0.003))
    distance = lambda p, q: math.dist(p, q)
    for one, others in (found, expected), (expected, found):
        for p in one:
            t.assertLess(min(distance(p, q) for q in others), 1e-7)  # frames are in single precision
    # the wall between both halves is gone
    unturned = use(t, keys.replace("20 deg, -30 deg, 40 deg", "0, 0, 0"), "position: [0, 0, 0]")
    t.assertRegex(t.expect_success("check", unturned, "--out", "r").out, r"0\.02 x 0\.06 x 0\.04 m\n(.*\n)*  components +1\n")


@claim("surfaces: an angle without its unit is refused before it rotates a ship by 90 radians")
def _(t):
    (t.folder / "box.obj").write_text(grid_box(BOX, (1, 1, 1)).obj())
    deck = use(t, "file: box.obj, scale: 0.001, rotate: [0, 0, 90]", BOX_PLACE)
    done = t.run_program("check", deck)
    at = place_of((t.folder / deck).read_text(), "90]")
    t.expect_complaint(done, 2, f"deck.yaml:{at}: z of rotate is 90, but it must be from -6.2832 to 6.2832", "[90 deg, 0, 0]")
    t.expect_success("check", use(t, "file: box.obj, scale: 0.001, rotate: [0, -360 deg, 180 deg]", BOX_PLACE))


@claim("surfaces: contact occurs on the selected parts only")
def _(t):
    tool, guard = grid_box(BOX, (4, 4, 4)), grid_box(BOX, (2, 2, 2)).moved(lambda p: (p[0] + 50, p[1] - 0.05, p[2]))
    (t.folder / "tool.obj").write_text(tool.obj())
    (t.folder / "both.obj").write_text(Shape({"tool": tool.faces(), "side guard": guard.faces()}).obj())
    alone = run(t, "alone", use(t, "file: tool.obj, scale: 0.001", BOX_PLACE))
    t.assertEqual(run(t, "chosen", use(t, "file: both.obj, scale: 0.001, file_parts: [tool]", BOX_PLACE)), alone)
    both = run(t, "both", use(t, 'file: both.obj, scale: 0.001, file_parts: [tool, "side guard"]', BOX_PLACE))
    t.assertGreater(max(both["cylinder.contacts [-]"]), max(alone["cylinder.contacts [-]"]))
    deck = use(t, "file: both.obj, scale: 0.001, file_parts: [guard]", BOX_PLACE)
    at = place_of((t.folder / deck).read_text(), "surface: {file")
    t.expect_complaint(t.run_program("check", deck), 2, f"deck.yaml:{at}: ", 'the surface has no part "guard"', "its parts are tool, side guard.")


@claim("surfaces: a compressed file yields bitwise identical results")
def _(t):
    stl = grid_box(BOX, (6, 6, 6)).stl().encode()
    (t.folder / "box.stl").write_bytes(stl)
    (t.folder / "box.stl.gz").write_bytes(gzip.compress(stl))
    plain = run(t, "plain", use(t, "file: box.stl, scale: 0.001", BOX_PLACE))
    packed = run(t, "packed", use(t, "file: box.stl.gz, scale: 0.001", BOX_PLACE))
    t.assertEqual(plain, packed)
    t.assertEqual(t.report("plain")["state_hash"], t.report("packed")["state_hash"])


@claim("surfaces: flat surfaces yield the same contact, generated or from a file, with original, coarsened and refined panels")
def _(t):
    (t.folder / "box.obj").write_text(grid_box(BOX, (11, 10, 6)).obj())
    given = run(t, "given", use(t, "file: box.obj, scale: 0.001", BOX_PLACE))
    generated = run(t, "generated", use(t, "box: {size: [44 mm, 40 mm, 30 mm], edge_length: 3 mm}", BOX_PLACE))
    expect_close(t, given, generated)

    below = "refine: {below: {edge_length: 2 mm, box: {size: [30 mm, 10 mm, 30 mm], centre: [0, -20 mm, 0]}}}"
    changes = {"coarsened": "coarsen: {max_deviation: 1 nm}", "refined": below}
    changes["both"] = "\n    ".join(changes.values())
    triangles = {}
    for folder, keys in changes.items():
        expect_close(t, given, run(t, folder, use(t, "file: box.obj, scale: 0.001", BOX_PLACE, ("free_dofs: [y]", f"free_dofs: [y]\n    {keys}"))))
        report = t.report(folder)["impactors"]["cylinder"]
        t.assertEqual(report["surface_as_given"]["panels"], 2 * (110 + 66 + 60))
        t.assertEqual("coarsened" in report, folder != "refined")
        triangles[folder] = report["surface"]["triangles"]
        if folder == "coarsened":
            t.assertEqual((report["coarsened"]["triangles"], triangles[folder]), (12, 12))
            t.assertLessEqual(report["coarsened"]["moved_at_most [m]"], 1e-9)
        t.assertAlmostEqual(report["surface"]["volume [m3]"] / report["surface_as_given"]["volume [m3]"], 1, delta=1e-6)  # a nanometre of centimetres
    t.assertGreater(triangles["refined"], 4 * (110 + 66 + 60))
    t.assertTrue(12 < triangles["both"] < triangles["refined"], triangles)


@claim("surfaces: STEP, Gmsh, Abaqus and LS-DYNA files of a box behave as the box does")
def _(t):
    if shutil.which("gmsh") is None:
        raise unittest.SkipTest("gmsh is not installed")
    (t.folder / "box.geo").write_text("""SetFactory("OpenCASCADE");
Box(1) = {-22, -20, -15, 44, 40, 30};
Mesh.MeshSizeMax = 10;
""")
    for name, *options in (("box.step", "-0"), ("box.msh", "-2"), ("box.inp", "-2"), ("solid.inp", "-3", "-format", "inp"), ("box.key", "-3")):
        done = subprocess.run(["gmsh", "box.geo", *options, "-o", name, "-v", "2"], cwd=t.folder, capture_output=True, text=True, timeout=60)
        t.assertEqual(done.returncode, 0, done)
    expected = run(t, "generated", use(t, "box: {size: [44 mm, 40 mm, 30 mm], edge_length: 3 mm}", BOX_PLACE))
    for name, scale in (("box.step", 1), ("box.msh", 0.001), ("box.inp", 0.001), ("solid.inp", 0.001), ("box.key", 0.001)):
        expect_close(t, expected, run(t, name.replace(".", "_"), use(t, f"file: {name}, scale: {scale}", BOX_PLACE)))


@claim("surfaces: an invalid surface is refused at its position in the deck, with a file of its defective panels")
def _(t):
    cases = (("non-orientable", moebius(), "close a Möbius strip", ", orientation: normals"),
             ("inside out", folded_prism(), "the surface is inside out between them", ", orientation: normals"),
             ("non-manifold edge", two_rooms(), "4 edges have more than two panels", ""),
             ("boundary edge", half_hull(), "the surface is open: 64 edges belong to one panel only", ""))
    for kind, shape, words, more in cases:
        (t.folder / "surface.obj").write_text(shape.obj())
        deck = use(t, f"file: surface.obj, scale: 0.01{more}", "position: [0, 3, 0]")
        at = f"deck.yaml:{place_of((t.folder / deck).read_text(), 'surface: {file')}: cylinder: "
        for command, folder in (("check", "r/check"), ("run", "r")):
            done = t.run_program(command, deck, "--out", "r")
            t.expect_complaint(done, 2, at, words, f"These panels are in {folder}/cylinder_defects.vtp, for ParaView.")
            t.assertEqual(done.out, "Small plate\n")
            t.assertFalse((t.folder / "r" / "run.json").exists())
            try:
                found = defects(t.folder / folder / "cylinder_defects.vtp")
            except ImportError:
                continue
            t.assertEqual(list(found), [kind])
            if kind == "non-manifold edge":
                t.assertEqual(found, {kind: [10]})
    (t.folder / "surface.obj").write_text(grid_box(BOX, (4, 4, 4)).obj())
    deck = use(t, "file: surface.obj, scale: 0.001", BOX_PLACE)
    t.expect_success("check", deck, "--out", "r")
    t.expect_success("run", deck, "--out", "r")
    t.assertEqual([name for name in t.files("r") if "defects" in name], [])  # the file of defects is removed


@claim("surfaces: a surface with an inner wall runs with a declared orientation, and a warning reports its cut edges")
def _(t):
    rooms = two_rooms().moved(lambda p: (44 * (p[0] - 0.5), 40 * (p[1] - 0.5), 15 * (p[2] - 1)))
    (t.folder / "rooms.obj").write_text(rooms.obj())
    inertia = ("free_dofs: [y]", "free_dofs: [y]\n    inertia: [1, 1, 1]")
    out = t.expect_success("run", use(t, "file: rooms.obj, scale: 0.001, orientation: normals", BOX_PLACE, inertia), "--out", "r", "--threads", "1").out
    warnings = [line for line in out.splitlines() if line.startswith("warning: ")]
    t.assertEqual(len(warnings), 1, out)
    t.assertIn("is cut along 4 non-manifold edges", warnings[0])
    t.assertEqual(t.report("r")["impactors"]["cylinder"]["surface"]["cut_edges"], 4)
    rooms.parts[""].pop()  # without the wall it is a box
    (t.folder / "box.obj").write_text(rooms.obj())
    box = run(t, "box", use(t, "file: box.obj, scale: 0.001", BOX_PLACE, inertia))
    t.assertEqual(t.history("r")["cylinder.contacts [-]"], box["cylinder.contacts [-]"])


@claim("surfaces: a self-intersecting surface without an inverted region runs with a warning")
def _(t):
    # a star drawn in one line encloses its middle twice, and nothing inside out
    star = prism([(20 * math.sin(4 * math.pi * k / 5), -20 * math.cos(4 * math.pi * k / 5)) for k in range(5)], 30.0)
    (t.folder / "star.obj").write_text(star.moved(lambda p: (p[0], p[1], p[2] - 15)).obj())
    deck = use(t, "file: star.obj, scale: 0.001", "position: [0, 53 mm, 0]")
    warnings = [line for line in t.expect_success("check", deck, "--out", "r").out.splitlines() if line.startswith("warning: ")]
    t.assertTrue(any("5 panels of impactor cylinder intersect" in line for line in warnings), warnings)


@claim("surfaces: the hull, decks and reports of the guide are those of the program")
def _(t):
    guide = (Path(__file__).resolve().parents[2] / "docs" / "guide" / "surface_meshes.md").read_text()
    (t.folder / "half_hull.obj").write_text(half_hull().obj())
    decks = re.findall(r"^```yaml\n(.*?)^```", guide, re.M | re.S)
    deck = next(text for text in decks if text.startswith("title: "))
    remesh = next(text for text in decks if "coarsen:" in text)
    (t.folder / "my_deck.yaml").write_text(deck)
    (t.folder / "finer.yaml").write_text(changed(deck, ("    mass: 8000 kg\n", "    mass: 8000 kg\n" + remesh)))

    checked = t.expect_success("check", "my_deck.yaml").out
    for quoted in ("closure closed", "size 12 x 2.4 x 1.5 m", "with floe at 0.1303 s"):
        t.assertIn(quoted, guide)
        t.assertIn(quoted, re.sub(" +", " ", checked))
    printed = t.expect_success("mesh", "half_hull.obj").out
    printed += t.expect_success("mesh", "half_hull.obj", "--scale", "0.001", "--spacing", "250 mm").out
    printed += t.expect_success("check", "finer.yaml").out
    quoted = [line[4:] for line in guide.splitlines() if line.startswith("      ")]
    t.assertGreater(len(quoted), 15)
    for line in quoted:
        if not line.startswith("  centroid"):  # x is rounding
            t.assertIn(line, printed.splitlines())


main()
