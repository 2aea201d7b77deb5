"""Bodies from files, with holes and cracks, and point clouds, from the deck to output frames."""

import unittest

from claims import DECK, changed, claim, main, place_of
from shapes import Shape, grid_box

SHAPE = "shape: {box: {size: [100 mm, 60 mm, 20 mm]}}\n    spacing: 5 mm"
NO_LINES = ("\n  lines:\n    along_y: {body: plate, from: [0, -30 mm, 0], to: [0, 30 mm, 0]}", "")


def centres():
    """Of the particles of the plate, in metres."""
    steps = lambda n: [(k - (n - 1) / 2) * 0.005 for k in range(n)]
    return [(x, y, z) for z in steps(4) for y in steps(12) for x in steps(20)]


@claim("a plate enclosed by a surface file behaves as the box of the same size")
def _(t):
    (t.folder / "plate.stl").write_text(grid_box((100.0, 60.0, 20.0), (3, 2, 1)).stl())
    t.expect_success("run", t.deck(), "--out", "box")
    t.expect_success("run", t.deck((SHAPE, "shape: {file: plate.stl, scale: 0.001}\n    spacing: 5 mm")), "--out", "file")
    box, file = t.report("box")["bodies"]["plate"], t.report("file")["bodies"]["plate"]
    t.assertEqual((file["particles"], file["bonds"]), (box["particles"], box["bonds"]))
    t.assertAlmostEqual(file["mass_of_solid [kg]"], 0.96, 12)
    one, other = t.history("box"), t.history("file")
    t.assertGreater(max(one["cylinder.contacts [-]"]), 0)
    t.assertEqual(one["cylinder.contacts [-]"], other["cylinder.contacts [-]"])
    # the corners are rounded when they are scaled, which moves the lattice by 1e-17 m
    for column in ("cylinder.velocity_y [m/s]", "plate.kinetic_energy [J]"):
        scale = max(map(abs, one[column]))
        t.assertTrue(all(abs(a - b) <= 1e-9 * scale for a, b in zip(one[column], other[column])), column)


@claim("check reports a solid with a hole and a crack, and writes it as VTP")
def _(t):
    body = """shape: {sphere: {diameter: 60 mm}}
    spacing: 5 mm
    cracks: {notch: {polygon: [[0, 0, -1], [1, 0, -1], [1, 0, 1], [0, 0, 1]]}}"""
    out = t.expect_success("check", t.deck((SHAPE, body), NO_LINES), "--out", "r").out
    t.assertRegex(out, r"particles +\d+ \(12 x 12 x 12 cells of 0.005 m\)")
    t.assertRegex(out, r"mass +[\d.]+ kg; [-+][\d.]+ % relative to the solid \(0.90478 kg\)")
    t.assertRegex(out, r"crack notch +\d+ bonds cut")
    t.assertIn("plate.vtp", t.files("r/check"))
    holed = t.expect_success("check", t.deck((SHAPE, body + "\n    holes: {bore: {shape: {box: {size: [20 mm, 20 mm, 1]}}, position: [20 mm, 0, 0]}}"), NO_LINES)).out
    t.assertNotIn("relative to the solid", holed)  # its volume is unknown


@claim("a point cloud from a CSV file runs, and frames number its particles as the file does")
def _(t):
    rows = "".join(f"{1000 * x!r}, {y!r}, {z!r}, 0.125\n" for x, y, z in centres())
    (t.folder / "cloud.csv").write_text("x [mm], y [m], z [m], volume [cm3]\n" + rows)
    t.expect_success("run", t.deck((SHAPE, "shape: {points: {file: cloud.csv}}")), "--out", "r")
    body = t.report("r")["bodies"]["plate"]
    t.assertEqual(body["particles"], 960)
    t.assertAlmostEqual(body["mass [kg]"], 0.96, 12)
    t.assertGreater(max(t.history("r")["cylinder.contacts [-]"]), 0)
    t.assertIn(b'Name="original"', (t.folder / "r/frames/plate_00004.vtp").read_bytes())


@claim("points written by meshio as VTU and VTK, plain, compressed and text, are bitwise identical to those of a CSV file")
def _(t):
    try:
        import meshio
        import numpy as np
    except ImportError:
        raise unittest.SkipTest("meshio is not installed") from None
    points = np.array(centres())
    volumes = np.linspace(1.0, 1.1, len(points)) * 1.25e-7
    (t.folder / "cloud.csv").write_text(
        "x [m], y [m], z [m], volume [m3]\n" + "".join(f"{x!r}, {y!r}, {z!r}, {v!r}\n" for (x, y, z), v in zip(points.tolist(), volumes.tolist()))
    )
    cloud = meshio.Mesh(points, [("vertex", np.arange(len(points))[:, None])], point_data={"noise": points[:, 0], "speed": points, "volume": volumes})
    forms = {
        "packed.vtu": dict(binary=True, compression="zlib"),
        "plain.vtu": dict(binary=True, compression=None),
        "binary.vtk": dict(binary=True, file_format="vtk42"),
        "text.vtk": dict(binary=False, file_format="vtk42"),
        "newer.vtk": dict(binary=True, file_format="vtk51"),
    }
    t.expect_success("run", t.deck((SHAPE, "shape: {points: {file: cloud.csv}}")), "--out", "csv")
    for name, options in forms.items():
        cloud.write(t.folder / name, **options)
        t.expect_success("run", t.deck((SHAPE, f"shape: {{points: {{file: {name}}}}}")), "--out", name + "_run")
        t.assertEqual(t.report(name + "_run")["state_hash"], t.report("csv")["state_hash"], name)
    (t.folder / "packed.vtu").rename(t.folder / "PACKED.VTU")  # as other systems write extensions
    t.expect_success("run", t.deck((SHAPE, "shape: {points: {file: PACKED.VTU}}")), "--out", "upper")
    t.assertEqual(t.report("upper")["state_hash"], t.report("csv")["state_hash"])


@claim("a VTK file without volumes is refused with the list of its arrays")
def _(t):
    header = "# vtk DataFile Version 3.0\n\nASCII\nDATASET POLYDATA\nPOINTS 2 float\n0 0 0 1 0 0\nPOINT_DATA 2\nSCALARS mass float\nLOOKUP_TABLE default\n1 2\n"
    for text, sentence in [
        (header, "there is no scalar point array `volume`; the file has `mass`"),
        (header + "SCALARS volume float\nLOOKUP_TABLE default\n1 -2\n", " the volume of point 1, counted from 0, is -2 m3"),
        (header[: header.index("POINT_DATA")], "there is no scalar point array `volume`; the file has none"),
    ]:
        (t.folder / "cloud.vtk").write_text(text)
        done = t.run_program("check", t.deck((SHAPE, "shape: {points: {file: cloud.vtk}}")))
        t.expect_complaint(done, 2, "deck.yaml:", f"{t.folder.resolve() / 'cloud.vtk'}:", sentence)
    vtu = '<VTKFile type="UnstructuredGrid"><UnstructuredGrid><Piece NumberOfPoints="1" NumberOfCells="0"><Points><DataArray type="Float32" NumberOfComponents="3" format="ascii">0 0 0</DataArray></Points><PointData><DataArray type="Float32" Name="mass" format="ascii">1</DataArray></PointData></Piece></UnstructuredGrid></VTKFile>'
    (t.folder / "cloud.vtu").write_text(vtu)
    done = t.run_program("check", t.deck((SHAPE, "shape: {points: {file: cloud.vtu}}")))
    t.expect_complaint(done, 2, "deck.yaml:", "cloud.vtu:1: the piece has no scalar point array `volume`; it has `mass`.")


@claim("errors in a file of a solid or point cloud are reported at its key, and with the line in the file")
def _(t):
    cube = grid_box((100.0, 60.0, 20.0), (1, 1, 1))
    (t.folder / "open.stl").write_text(Shape({"": cube.parts[""][1:]}).stl())
    change = (SHAPE, "shape: {file: open.stl, scale: 0.001}\n    spacing: 5 mm")
    place = place_of(changed(DECK, change), "shape: {file")
    t.expect_complaint(t.run_program("check", t.deck(change)), 2, f"deck.yaml:{place}: ", "the surface is open: 4 of its edges have a panel on one side only")
    (t.folder / "cloud.csv").write_text("x [m], y [m], z [m], volume [m3]\n0, 0, 0, 1\n0, 0, 1, zero\n")
    done = t.run_program("check", t.deck((SHAPE, "shape: {points: {file: cloud.csv}}")))
    t.expect_complaint(done, 2, str(t.folder.resolve() / "cloud.csv") + ":3: ", '"0, 0, 1, zero" is not four comma-separated numbers')


main()
