"""perimpact check: what would run, before it runs."""

import json
import os
import re
import time
import xml.etree.ElementTree as xml

from claims import claim, main


def rows_of(text):
    """The last value of each named row; names take the first 20 columns."""
    return {line[2:20].strip(): line[20:].strip() for line in text.splitlines() if line.startswith("  ")}


@claim("check: prints particles, bonds, memory, surface, first contact, step and duration, and agrees with the run")
def _(t):
    rows = rows_of(t.expect_success("check", t.deck(), "--out", "r").out)
    t.expect_success("run", t.deck(), "--out", "r")
    report = t.report("r")
    t.assertEqual(rows["particles"], "960 (20 x 12 x 4 cells of 0.005 m)")
    t.assertEqual(rows["bonds"].split()[0], str(report["bodies"]["plate"]["bonds"]))
    t.assertRegex(rows["peak"], r"^about \d+ MB: ")
    surface = report["impactors"]["cylinder"]["surface"]
    t.assertEqual(rows["panels"], f"{surface['panels']} ({surface['triangles']} triangles, {surface['vertices']} vertices)")
    t.assertEqual((rows["closure"], rows["size"], rows["components"]), ("closed", "0.04 x 0.04 x 0.04 m", "1"))
    step, steps = re.match(r"(\S+) s, (\d+) steps", rows["step"]).groups()
    t.assertEqual(rows["samples"], f"12 points of plate, written after step {steps}")
    t.assertEqual((step, int(steps)), (f"{report['stability']['step [s]']:.4g}", report["steps"]))


@claim("check: the modes of an elastic impactor are counted, with the mass for which they have unit modal mass")
def _(t):
    corners = [(x, y, z) for x in (-0.02, 0.02) for y in (-0.02, 0.02) for z in (-0.02, 0.02)]
    faces = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    triangles = [(a, b, c) for a, b, c, _ in faces] + [(a, c, d) for a, _, c, d in faces]
    (t.folder / "cube.obj").write_text("".join("v {} {} {}\n".format(*corner) for corner in corners) + "".join(f"f {a + 1} {b + 1} {c + 1}\n" for a, b, c in triangles))
    modes = "".join(f"{x},{y},{z},{25 * x},0,0,0,{50 * z},0\n" for x, y, z in corners)  # φ² is 1/4 and 1 everywhere: of a structure of 4 kg, and of 1 kg
    (t.folder / "modes.csv").write_text("frequency [Hz], 300, 2000\nx [m], y [m], z [m], mode_1_x, mode_1_y, mode_1_z, mode_2_x, mode_2_y, mode_2_z\n" + modes)
    deck = t.deck(("surface: {cylinder: {diameter: 40 mm, height: 40 mm, axis: z, edge_length: 4 mm}}", "surface: {file: cube.obj}\n    elastic: {modes: modes.csv}"))
    rows = rows_of(t.expect_success("check", deck, "--out", "r").out)
    t.assertEqual(rows["modes"], "2, 300 to 2000 Hz; of a uniform structure of 1 to 4 kg, if they have unit modal mass")


@claim("check: the first contact is predicted to the step")
def _(t):
    # In this little time the plate does not answer yet. A row a step, so that the first row with contacts is the step.
    t.expect_success("run", t.deck(("20 us}", "20 us, step: 0.5 us}")), "--out", "r", "--set", "output.history_interval=0.5 us")
    out = t.expect_success("check", "deck.yaml", "--out", "r").out
    time, step = re.search(r"with plate at (\S+) s \(step (\d+)\)", out).groups()
    contacts = t.history("r")["cylinder.contacts [-]"]
    first = next(k for k, count in enumerate(contacts) if count > 0)
    t.assertEqual(int(step), first)
    t.assertTrue((first - 1) * 0.5e-6 < float(time) <= first * 0.5e-6, (time, first))


@claim("check: lists the parts of a surface, and mass, centre of mass and inertia of the impactor")
def _(t):
    deck = t.deck(("mass: 1 kg", "density: 8000 kg/m3"))
    out = t.expect_success("check", deck, "--out", "r").out
    rows = rows_of(out)
    t.expect_success("run", deck, "--out", "r", "--force")
    report = t.report("r")["impactors"]["cylinder"]
    volume = report["surface"]["volume [m3]"]
    t.assertAlmostEqual(report["mass [kg]"], 8000 * volume, delta=1e-15)  # one product
    t.assertEqual(rows["mass"], f"{report['mass [kg]']:.5g} kg")
    t.assertTrue(rows["inertia"].startswith(f"xx {report['inertia [kg m2]'][0]:.5g}, yy "), rows["inertia"])
    # of the round cylinder, which the panels lie within by up to a hundredth
    t.assertAlmostEqual(report["inertia [kg m2]"][2] / (0.5 * report["mass [kg]"] * 0.02**2), 1, delta=0.02)
    parts = report["surface"]["parts"]
    t.assertEqual(list(parts), ["bottom", "side", "top"])
    t.assertEqual(sum(part["panels"] for part in parts.values()), report["surface"]["panels"])
    t.assertEqual(rows["parts"], f"bottom: {parts['bottom']['panels']} panels, {parts['bottom']['area [m2]']:.5g} m2")
    t.assertIn(f"  {'':<18}top: {parts['top']['panels']} panels", out)


@claim("check: a density warns of possibly overlapping parts of the surface, which count twice, unless the impactor is fully constrained")
def _(t):
    def cube(low):
        corners = [[low + (v >> axis & 1) * 0.02 for axis in range(3)] for v in range(8)]
        return [[corners[v] for v in quad] for quad in ((0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5))]

    cylinder = "{cylinder: {diameter: 40 mm, height: 40 mm, axis: z, edge_length: 4 mm}}"
    for second, warns in (0.01, True), (0.03, False):
        quads = cube(0) + cube(second)
        lines = [f"v {x} {y} {z}" for quad in quads for x, y, z in quad] + [f"f {4 * k + 1} {4 * k + 2} {4 * k + 3} {4 * k + 4}" for k in range(len(quads))]
        (t.folder / "cubes.obj").write_text("\n".join(lines))
        out = t.expect_success("check", t.deck((cylinder, "{file: cubes.obj}"), ("mass: 1 kg", "density: 8000")), "--out", "r").out
        t.assertEqual("warning: The surface of cylinder has 2 components whose bounding boxes meet" in out, warns, out)
        held = t.deck((cylinder, "{file: cubes.obj}"), ("mass: 1 kg", "density: 8000"), ("free_dofs: [y]", "free_dofs: []"))
        t.assertNotIn("bounding boxes meet", t.expect_success("check", held, "--out", "r").out)


@claim("check: the first contact of an impactor that tables or loads move is not predicted")
def _(t):
    out = t.expect_success("check", t.deck(("free_dofs: [y]", "free_dofs: [y]\n    loads: {tow: {force: [0, -1 kN, 0]}}")), "--out", "r").out
    t.assertIn("not predicted for plate: motion tables or loads change the velocity", out)


@claim("check: an impactor without contact is reported with its distance")
def _(t):
    out = t.expect_success("check", t.deck(("-32 m/s", "32 m/s")), "--out", "r").out
    t.assertRegex(out, r"none with plate before the end, initial distance \S+ m; check position, velocity and units")


@claim("check: writes body, surface and contact bounds as VTP in their positions, without changing results")
def _(t):
    t.expect_success("run", t.deck(("free_dofs: [y]", "free_dofs: [y]\n    contact_bounds: {box: {size: [50 mm, 50 mm, 30 mm], centre: [0, 1 mm, 0]}, on_exceed: clip}")), "--out", "r")
    before = {name: (t.folder / "r" / name).read_bytes() for name in t.files("r")}
    t.expect_success("check", "deck.yaml", "--out", "r")
    t.assertEqual(t.files("r/check"), ["cylinder_contact_bounds.vtp", "cylinder_surface.vtp", "plate.vtp"])
    t.assertEqual({name: (t.folder / "r" / name).read_bytes() for name in t.files("r") if not name.startswith("check/")}, before)
    for name, points in ("plate", 960), ("cylinder_contact_bounds", 8):
        content = (t.folder / f"r/check/{name}.vtp").read_bytes()
        head = xml.fromstring(content[: content.index(b"<AppendedData")] + b"</VTKFile>")
        t.assertEqual(head.find(".//Piece").get("NumberOfPoints"), str(points))


@claim("check: every kind of contact bounds is reported, written as VTP and recorded in run.json")
def _(t):
    cylinder = "{cylinder_sectors: {axis: [0, 0, 1], radius: 21 mm, length: 40 mm, hub_radius: 21 mm, point: [0, 0, 0], blades: 1, sector_angle: 90 deg, start_angle: 0}}"
    halves = "{box_union: {boxes: {left: {size: [20 mm, 40 mm, 40 mm], centre: [-10 mm, 0, 0]}, right: {size: [20 mm, 40 mm, 40 mm], centre: [10 mm, 0, 0]}}}}"
    for region, kind, share, fitted in [
        (None, "none", None, None),
        ("{box: {size: [40 mm, 40 mm, 40 mm]}}", "box", 1, None),
        (halves, "box_union", 1, None),
        ("{box_union: {count: 4, gain: 0}}", "box_union", None, "boxes fitted to the surface"),
        (cylinder, "cylinder_sectors", 3.14159 * 21 * 21 / 1600, None),
        ("{cylinder_sectors: {}}", "cylinder_sectors", 3.14159 / 4, "axis, point, radius, length, hub_radius, blades, sector_angle, start_angle fitted to the surface; "
         "the angular gaps between its blades are negligible, so that the fan is the whole cylinder"),
        ("{auto: {}}", "cylinder_sectors", 3.14159 / 4, "chosen: the cylinder with sectors"),
    ]:
        deck = t.deck(("free_dofs: [y]", f"free_dofs: [y]\n    contact_bounds: {region}")) if region else t.deck()
        out = t.expect_success("check", deck, "--out", "r").out
        rows = rows_of(out)
        t.expect_success("run", deck, "--out", "r", "--force")
        report = t.report("r")["impactors"]["cylinder"]["contact_bounds"]
        t.assertEqual(report["kind"], kind)
        t.assertEqual("cylinder_contact_bounds.vtp" in " ".join(t.files("r/check")), region is not None)
        if region is None:
            t.assertEqual(rows["contact bounds"], "none: contact on the whole surface")
            continue
        t.assertEqual(rows["contact bounds"], kind)
        t.assertIs(report["clips"], False)
        # boxes are widened by 1e-8 of the coordinates
        t.assertAlmostEqual(report["volume [m3]"] / (0.04**3), report["share_of_bounding_box"], 4)
        if share:
            t.assertAlmostEqual(report["share_of_bounding_box"], share, 4)
        words = f"{100 * (1 - report['share_of_bounding_box']):.0f} % less" if report["share_of_bounding_box"] <= 1 else " m3, "
        t.assertIn(words, rows["bounds volume"])
        t.assertEqual(report.get("fitted"), rows.get("bounds fitted"))
        t.assertTrue((fitted or "None") in str(report.get("fitted")), report)
        for file in (t.folder / "r").rglob("*_contact_bounds.vtp"):
            file.unlink()


@claim("check: reports panels before and after coarsening and refinement, as does run.json, and parts are preserved")
def _(t):
    keys = "coarsen: {max_deviation: 0.2 mm, max_edge_length: 10 mm}\n    refine: {struck: {edge_length: 1 mm, surface_part: side, box: {size: [20 mm, 20 mm, 10 mm], centre: [0, -20 mm, 0]}}}"
    plain = t.deck()
    t.expect_success("run", plain, "--out", "plain")
    given = t.report("plain")["impactors"]["cylinder"]["surface"]
    deck = t.deck(("free_dofs: [y]", f"free_dofs: [y]\n    {keys}"))
    rows = rows_of(t.expect_success("check", deck, "--out", "r").out)
    t.expect_success("run", deck, "--out", "r", "--force")
    report = t.report("r")["impactors"]["cylinder"]
    t.assertEqual({**report["surface_as_given"], "buried_triangles": 0}, given)
    surface, coarsened = report["surface"], report["coarsened"]
    t.assertTrue(rows["as given"].startswith(f"{given['panels']} panels ({given['triangles']} triangles, edges "), rows)
    t.assertTrue(rows["coarsened"].startswith(f"to {coarsened['triangles']} triangles; maximum deviation of the surface "), rows)
    t.assertEqual(rows["refined"], f"to {surface['triangles']} triangles")
    t.assertEqual(rows["panels"], f"{surface['panels']} ({surface['triangles']} triangles, {surface['vertices']} vertices)")
    t.assertLess(coarsened["triangles"], given["triangles"])
    t.assertLess(2 * coarsened["triangles"], surface["triangles"])
    t.assertLessEqual(coarsened["moved_at_most [m]"], 0.2e-3)
    # sums over some thousand triangles, rounded
    t.assertAlmostEqual(surface["volume [m3]"] - given["volume [m3]"], coarsened["volume_change [m3]"], delta=1e-12 * given["volume [m3]"])
    t.assertEqual((surface["closure"], list(surface["parts"])), ("closed", ["bottom", "side", "top"]))


@claim("check: an impossible refinement is refused at its position, with its name")
def _(t):
    for wish, sentence in [
        ("{edge_length: 1 mm, part: sides}", 'struck: the surface has no part "sides"; did you mean side? Its parts are bottom, side, top.'),
        ("{edge_length: 1 nm}", "struck: an edge length of 1e-09 m would give about 6e+16 panels, more than the limit of 3e+07; use 5e-05 m or more."),
    ]:
        failed = t.run_program("check", t.deck(("free_dofs: [y]", f"free_dofs: [y]\n    refine: {{struck: {wish}}}")), "--out", "r")
        t.assertEqual((failed.code, failed.err), (2, f"error: deck.yaml:15:5: {sentence}\n"))


@claim("check: refuses what run refuses, with the same sentence")
def _(t):
    changes = [
        ("free_dofs: [y]", "free_dofs: [y]\n    contact_bounds: {box_union: {boxes: {a: {size: [40 mm, 40 mm, 30 mm]}}}}"), ("5 mm", "5 kg"),
        ("end: 20 us", "end: 20 us, step: 3 us"), ("[0, 50 mm, 0]", "[0, 40 mm, 0]"), ("to: [0, 30 mm, 0]", "to: [0, 1, 0]"),
    ]  # fmt: skip
    for change in changes:
        deck = t.deck(change)
        checked, run = (t.run_program(command, deck, "--out", "r") for command in ("check", "run"))
        t.expect_complaint(checked, 2, "deck.yaml:")
        t.assertEqual((checked.code, checked.err), (run.code, run.err))



@claim("check: --ranks states the shares, ghosts, memory and messages of ranks and the duration of a step, in text as in JSON")
def _(t):
    deck = t.deck(("poissons_ratio: 0.25", "poissons_ratio: 0.3"))  # 20 x 12 x 4 cells
    out = t.expect_success("check", deck, "--ranks", "2").out
    ranks = json.loads(t.expect_success("check", deck, "--ranks", "2", "--json").out)["ranks"]
    body = ranks["bodies"]["plate"]
    t.assertEqual((ranks["count"], body["mean_cells"], body["largest_cells"], body["largest_neighbours"]), (2, 480, 480, 1))
    t.assertEqual(body["largest_ghosts"], 3 * 20 * 4)  # a layer of three cells along the cut across y
    t.assertIn("\n  plate             at most 480 cells on a rank, 1.000 times the mean of 480; ghosts: at most 240; neighbours: at most 1\n", out)
    t.assertEqual((ranks["messages"], ranks["sent [byte]"]), (2, 240 * (48 + 8)))  # positions and velocities, then dilatations
    t.assertEqual((ranks["reductions"], ranks["reduced [byte]"], ranks["collections"]), (3, 24, 1))
    t.assertIn("\n  messages          2, at most 13440 bytes; 3 reductions of 24 bytes in all; collections of contacts: 1\n", out)
    t.assertRegex(out, r"\n  duration          about [\d.e-]+ ms: [\d.e-]+ ms of computing on \d+ threads?, [\d.e-]+ ms of messages \(latency 2e-06 s, bandwidth 1e\+10 byte/s\)\n")
    t.assertAlmostEqual(ranks["step [s]"] - ranks["computing [s]"], 6 * 2e-6 + (13440 + 24) / 1e10, delta=1e-12)
    slow = json.loads(t.expect_success("check", deck, "--ranks", "2", "--json", "--latency", "1e-3", "--bandwidth", "1e6").out)["ranks"]
    t.assertAlmostEqual(slow["step [s]"] - slow["computing [s]"], 6 * 1e-3 + (13440 + 24) / 1e6, delta=1e-9)
    t.assertFalse((t.folder / "results").exists())
    t.assertIs(ranks["includes_fragments"], True)
    fragments = t.deck(("contact:\n", "contact:\n  fragments: {law: repulsive}\n"), ("density: 8000 kg/m3", "density: 8000 kg/m3, critical_stretch: 0.002"))
    t.assertIn("\n  fragments         contact between them adds messages and reductions, which are not forecast\n", t.expect_success("check", fragments, "--ranks", "2").out)
    t.assertIs(json.loads(t.expect_success("check", fragments, "--ranks", "2", "--json").out)["ranks"]["includes_fragments"], False)


@claim("check: more ranks than blocks of cells are refused with one sentence")
def _(t):
    done = t.run_program("check", t.deck(), "--ranks", "1000")
    sentence = "1000 ranks are too many: the bodies can be divided among at most 144, since lattices are cut across x at multiples of eight cells only, and point clouds between blocks of eight particles. Use fewer."
    t.assertEqual((done.code, done.err), (2, f"error: deck.yaml:3:1: {sentence}\n"))


@claim("check: --ranks states the shares and messages of a body from a file of points, and the duration of a step")
def _(t):
    (t.folder / "points.csv").write_text("x [m],y [m],z [m],volume [m3]\n" +
                                         "".join(f"{0.005 * k},{0.005 * j},{0.005 * i},1.25e-7\n" for k in range(16) for j in range(4) for i in range(4)))
    cloud = t.deck(("shape: {box: {size: [100 mm, 60 mm, 20 mm]}}\n    spacing: 5 mm", "shape: {points: {file: points.csv}}"))
    ranks = json.loads(t.expect_success("check", cloud, "--ranks", "2", "--json").out)["ranks"]
    body = ranks["bodies"]["plate"]
    t.assertEqual((ranks["count"], body["mean_cells"], body["largest_cells"], body["largest_neighbours"]), (2, 128, 128, 1))
    t.assertEqual(ranks["messages"], 1)  # positions and velocities
    t.assertEqual(ranks["sent [byte]"], body["largest_ghosts"] * 48)  # each sends as much as it receives: the cloud is symmetric
    t.assertGreater(ranks["step [s]"], ranks["computing [s]"])
    t.assertIn("particles         256 (points of a file, mean spacing 0.005 m)", t.expect_success("check", cloud, "--ranks", "2").out)


@claim("check: of a hundred million particles on ten thousand ranks the shares are stated within 10 s, without building the body")
def _(t):
    deck = t.deck(("[100 mm, 60 mm, 20 mm]", "[2.32, 2.32, 2.32]"), ("[0, 50 mm, 0]", "[0, 2, 0]"))
    begin = time.monotonic()
    with t.start("check", deck, "--ranks", "10000", "--threads", "2", "--json") as process:
        said = process.stdout.read()
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
    t.assertEqual(process.returncode, 0)
    ranks = json.loads(said)["ranks"]
    body = ranks["bodies"]["plate"]
    t.assertEqual((ranks["count"], body["mean_cells"]), (10000, 464**3 / 10000))
    t.assertLess(body["largest_cells"] / body["mean_cells"], 1.12)
    t.assertLessEqual(body["largest_neighbours"], 26)
    t.assertLess(usage.ru_utime + usage.ru_stime, 2 * 10)  # of two threads: the machine may be busy
    t.assertLess(time.monotonic() - begin, 60)
    t.assertLess(1024 * usage.ru_maxrss, 200e6)


main()
