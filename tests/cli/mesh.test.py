"""`perimpact mesh`: what a user learns of a surface file, and what the command leaves behind."""

import math
import re
import unittest

from claims import DECK, changed, claim, main
from shapes import Shape, defects, folded_prism, grid_box, half_hull, moebius, prism, two_rooms


def rows(t, *arguments):
    """Value of each row of the report; a list for names with several rows."""
    found = {}
    for line in t.expect_success("mesh", *arguments).out.splitlines()[1:]:
        match = re.match(r"  (?:  )?(\S.*?)? {2,}(\S.*)$", line)
        if match:
            name = match[1] or name  # a row without a name continues the one above
            found.setdefault(name, []).append(match[2])
    return {name: values[0] if len(values) == 1 else values for name, values in found.items()}


def write(t, name, shape):
    (t.folder / name).write_text(shape.stl() if name.endswith(".stl") else shape.obj())
    return name


def need_numpy():
    try:
        import numpy  # noqa: F401
    except ImportError:
        raise unittest.SkipTest("numpy is not installed")


@claim("mesh: a box in millimetres yields a warning about units, the same in metres does not")
def _(t):
    box = write(t, "box.stl", grid_box((2000, 1000, 500), (4, 2, 1)))
    given, scaled, twice = rows(t, box), rows(t, box, "--scale", "0.001"), rows(t, box, "--scale", "1e-7")
    t.assertEqual((given["size"], scaled["size"]), ("2000 x 1000 x 500 m", "2 x 1 x 0.5 m"))
    t.assertIn("--scale 0.001 (`scale: 0.001` in the deck) makes it 2 m", given["unit?"])
    t.assertNotIn("unit?", scaled)
    t.assertIn("smaller than any tool", twice["unit?"])


@claim("mesh: panels are compared with a spacing in any unit")
def _(t):
    box = write(t, "box.obj", grid_box((2, 1, 0.5), (4, 2, 1)))  # squares of half a metre
    printed = rows(t, box, "--spacing", "500 mm")
    t.assertEqual(printed, rows(t, box, "--spacing", "0.5"))
    t.assertEqual(printed["median panel"], "0.5 m, 1 spacings: adequate")
    t.assertRegex(printed["wall thickness"], r"^0\.5 m, 1 spacings, at panel \d+, ")
    t.assertIn("finer than useful", rows(t, box, "--spacing", "2.01 m")["median panel"])
    t.assertIn("adequate", rows(t, box, "--spacing", "1.99 m")["median panel"])
    t.assertIn("sufficient on flat areas", rows(t, box, "--spacing", "0.249")["median panel"])

    # twelve sides about a circle of 1 m: they turn by 30 degrees, and the sagitta of an arc of their width is w θ/8
    tube = write(t, "tube.obj", prism([(math.cos(math.pi * k / 6), math.sin(math.pi * k / 6)) for k in range(12)], 4.0))
    sagitta = 2 * math.sin(math.pi / 12) * (math.pi / 6) / 8
    for ratio, verdict in ((0.49, "sufficient"), (0.51, "too coarse there")):
        printed = rows(t, tube, "--spacing", sagitta / ratio)["chord error"]
        t.assertTrue(printed.startswith(f"at most {sagitta:.3g} m, {ratio:.2g} spacings, at panel "), printed)
        t.assertIn(f": {verdict}", printed)


@claim("mesh: only the named parts are read, and an unknown one is reported")
def _(t):
    hull = write(t, "hull.obj", half_hull())
    both = rows(t, hull)
    t.assertEqual([part.split(" panels")[0] for part in both["parts"]], ["shell: 192", "deck: 24"])
    t.assertTrue(rows(t, hull, "--part", "deck")["panels"].startswith("24 (46 triangles"))
    t.assertEqual(rows(t, hull, "--part", "deck", "--part", "shell")["panels"], both["panels"])
    t.expect_complaint(t.run_program("mesh", hull, "--part", "dck"), 2, 'hull.obj: the surface has no part "dck"; did you mean deck?', "shell, deck")


@claim("mesh: the output of --out reads back equal, closed, oriented outward and with part names")
def _(t):
    parts = half_hull().with_image(1).moved(lambda p: tuple(0.001 * x for x in p)).turned_over()
    plain = grid_box((0.7, 0.3, 0.1), (4, 3, 2)).turned_over()
    without_panels = lambda part: re.sub(r"\d+ panels, ", "", part)  # quads have become triangles
    equal = "size", "edges", "closure", "components", "area", "volume"
    for name, shape in (("parts", parts), ("plain", plain)):
        given = rows(t, write(t, name + ".obj", shape))
        t.assertEqual(given["closure"], "closed")
        t.assertIn("inward normals reversed", str(given["repaired"]))
        for out in f"{name}_out.stl", f"{name}_out.obj":
            t.assertIn(f"the repaired surface is in {out}", t.expect_success("mesh", name + ".obj", "--out", out).out)
            back = rows(t, out)
            t.assertEqual({row: back[row] for row in equal}, {row: given[row] for row in equal}, out)
            t.assertEqual(re.findall(r"\d+", back["panels"])[1:], re.findall(r"\d+", given["panels"])[1:], out)  # triangles and vertices
            repaired = back.get("repaired", "")
            t.assertRegex(repaired, r"^(|\d+ coincident vertices merged)$", out)  # nothing but what STL repeats
            t.assertEqual([without_panels(part) for part in back.get("parts", [])], [without_panels(part) for part in given.get("parts", [])])
            t.assertEqual("parts" in back, name == "parts")
            t.assertEqual((t.folder / out).read_bytes().startswith(b"solid shell\n"), out == "parts_out.stl")


@claim("mesh: a boundary loop is reported with length and position, and that of half a ship with the key that completes it")
def _(t):
    hull = half_hull()
    printed = rows(t, write(t, "half.obj", hull), "--scale", "0.001")
    # stem, keel, stem and the middle of the deck, which has as many edges as the keel
    t.assertTrue(printed["boundary loops"].startswith("64 edges, length 27 m, extent 12 x 0 x 1.5 m about (0, 0, -0.75) m"), printed["boundary loops"])
    t.assertIn("`mirror_merge: y`", printed["half?"])
    hull.parts["shell"].pop(100)  # a hole besides
    holed = rows(t, write(t, "holed.obj", hull))
    t.assertNotIn("half?", holed)
    t.assertEqual([re.match(r"\d+ edges", loop)[0] for loop in holed["boundary loops"]], ["64 edges", "4 edges"])  # the longest first
    t.assertNotIn("half?", rows(t, write(t, "whole.obj", half_hull().with_image(1))))


@claim("mesh: the file of defects contains exactly the defective panels, in metres")
def _(t):
    need_numpy()
    from vtp_reader import read_vtp

    box = grid_box((3, 3, 3), (3, 3, 3))
    hole = box.faces().index(next(face for face in box.faces() if all(abs(sum(p[k] for p in face) / 4 - c) < 1e-12 for k, c in enumerate((0, 0, 1.5)))))
    around = [face for k, face in enumerate(box.faces()) if k != hole]
    missing = set(box.faces()[hole])
    beside = [k for k, face in enumerate(around) if len(missing & set(face)) == 2]
    t.assertEqual(len(beside), 4)
    write(t, "box.v2.obj", Shape({"": around}))
    t.expect_success("mesh", "box.v2.obj", "--scale", "0.5")
    t.assertEqual(defects(t.folder / "box.v2_defects.vtp"), {"boundary edge": beside})
    picture = read_vtp(t.folder / "box.v2_defects.vtp")
    shown = [[tuple(point) for point in picture.points[panel].tolist()] for panel in picture.panels]
    t.assertEqual(shown, [[tuple(0.5 * x for x in corner) for corner in around[k]] for k in beside])

    printed = rows(t, write(t, "folded.obj", folded_prism()))
    t.assertIn("repair the fold", printed["inside out"])
    # sides 0 and 5 meet at the origin, and side 3 intersects both
    t.assertEqual(defects(t.folder / "folded_defects.vtp"), {"inside out": [0, 3, 5]})

    printed = rows(t, write(t, "rooms.obj", two_rooms()))
    t.assertTrue(printed["non-manifold"].startswith("4 edges with more than two panels; on 4 of them a panel could not be paired"), printed)
    t.assertEqual(defects(t.folder / "rooms_defects.vtp"), {"boundary edge": [10]})

    write(t, "band.obj", moebius())
    done = t.run_program("mesh", "band.obj")
    t.expect_complaint(done, 2, "band.obj: the panels ", "close a Möbius strip", "band_defects.vtp, for ParaView")
    named = [int(word) for word in re.search(r"panels (\d+) and (\d+)", done.err).groups()]
    t.assertEqual(defects(t.folder / "band_defects.vtp"), {"non-orientable": sorted(named)})
    t.assertEqual(abs(named[0] - named[1]) % 10, 1)  # neighbours

    write(t, "sound.obj", box)
    t.expect_success("mesh", "sound.obj")
    t.assertNotIn("sound_defects.vtp", t.files("."))


@claim("mesh: command-line errors are reported in one sentence")
def _(t):
    box = write(t, "box.obj", grid_box((1, 1, 1), (1, 1, 1)))
    for arguments, begins in (((box, "--spacing", "3 kg"), "--spacing is 3 kg: that is a mass"),
                              ((box, "--spacing", "0"), "--spacing is 0, but it must be above 0"),
                              ((box, "--scale", "-1"), "--scale is -1, but it must be above 0"),
                              ((box, "--out", "box.ply"), "box.ply: surfaces are written as .stl or .obj"),
                              (("bax.obj",), "bax.obj: there is no such file"),
                              (("box.slt",), "box.slt: `.slt` is not a supported surface format; did you mean `.stl`?"),
                              (("box.3dm",), "box.3dm: `.3dm` is not a supported surface format; the formats are .stl")):
        t.expect_complaint(t.run_program("mesh", *arguments), 2, begins)
    done = t.run_program("mesh", box, "--out", "nowhere/box.stl")
    t.expect_complaint(done, 2, "nowhere/box.stl cannot be written", "there is no folder nowhere")


@claim("mesh: rounding gaps are reported with the tolerance that closes them, and --weld and the deck close them")
def _(t):
    cube = [(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)]
    faces = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
    text = ""
    for number, face in enumerate(faces):  # each face with corners of its own, off by some micrometres
        text += "".join("v %.7f %.7f %.7f\n" % tuple(x + 6e-7 * ((7 * number + 3 * axis) % 11 - 5) for axis, x in enumerate(cube[v])) for v in face)
        text += "f -4 -3 -2 -1\n"
    (t.folder / "cube.obj").write_text(text)
    out = t.expect_success("mesh", "cube.obj").out
    t.assertIn("open, 24 boundary edges", out)
    suggestion = re.search(r"--weld (\S+) \(`weld: (\S+)` in the deck\) closes the surface", out)
    t.assertTrue(suggestion, out)
    t.assertIn("closure           closed", t.expect_success("mesh", "cube.obj", "--weld", suggestion[1]).out)
    t.assertIn("closure           closed", t.expect_success("mesh", "cube.obj", "--weld", "0.02 mm").out)
    t.expect_complaint(t.run_program("mesh", "cube.obj", "--weld", "2 kg"), 2, "--weld")
    deck = changed(DECK, ("surface: {cylinder: {diameter: 40 mm, height: 40 mm, axis: z, edge_length: 4 mm}}", "surface: {file: cube.obj, scale: 0.04, weld: 0.4 um}"))
    (t.folder / "deck.yaml").write_text(deck)
    t.assertIn("closed", t.expect_success("check", "deck.yaml").out)


@claim("mesh: the file of defects has the whole name without the format, so that wall-0.25 and wall-0.5 differ")
def _(t):
    for name in ("wall-0.25.obj", "wall-0.5.obj"):
        (t.folder / name).write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
        t.expect_success("mesh", name)
    t.assertEqual(t.files("."), ["wall-0.25.obj", "wall-0.25_defects.vtp", "wall-0.5.obj", "wall-0.5_defects.vtp"])


main()
