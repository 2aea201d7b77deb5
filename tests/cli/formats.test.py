"""Surfaces as other programs write them: gmsh and meshio (python3-meshio) save, `perimpact mesh` reads. What must come out is computed here with
numpy from the nodes and elements themselves."""

import os
import re
import shutil
import subprocess
import unittest
from collections import Counter

from claims import claim, main

try:
    import meshio
    import numpy as np
except ImportError:
    meshio = None

# how many nodes around a cell of meshio are corners; behind them, those in the middle of its edges
SURFACES = {"triangle": 3, "quad": 4, "triangle6": 3, "quad8": 4}
FACES = {
    "tetra": ["012", "013", "123", "203"],
    "wedge": ["012", "345", "0143", "1254", "2035"],
    "pyramid": ["0123", "014", "124", "234", "304"],
    "hexahedron": ["0123", "4567", "0154", "1265", "2376", "3047"],
}

# two boxes that share a wall, and a ball
SCENE = """\
SetFactory("OpenCASCADE");
Box(1) = {0, 0, 0, 0.5, 1, 1};
Box(2) = {0.5, 0, 0, 0.5, 1, 1};
Sphere(3) = {3, 0, 0, 0.75};
Coherence;
Mesh.MeshSizeMax = 0.5;
"""
BODIES_APART = SCENE.replace("0.5, 0, 0, 0.5", "1.5, 0, 0, 0.5")


def need(*what):
    for name in what:
        missing = meshio is None if name == "meshio" else shutil.which(name) is None
        if missing:
            raise unittest.SkipTest(f"{name} is not installed")


def gmsh(t, *arguments):
    done = subprocess.run(["gmsh", *map(str, arguments), "-v", "2", "-nt", "1"], cwd=t.folder, capture_output=True, text=True, timeout=120)
    t.assertEqual(done.returncode, 0, done)


def triangles_of(points, kind, cells):
    """Rows of three nodes: quads are cut along the shorter diagonal; quadratic cells lose their corners, and what is left is a smaller linear one."""
    corners = SURFACES[kind]
    if cells.shape[1] == 2 * corners:
        middles = cells[:, corners:]
        cut_off = [np.column_stack([cells[:, k], middles[:, k], middles[:, k - 1]]) for k in range(corners)]
        return cut_off + triangles_of(points, "triangle" if corners == 3 else "quad", middles)
    if corners == 3:
        return [cells]
    length = lambda k: np.linalg.norm(points[cells[:, k]] - points[cells[:, k + 2]], axis=1)
    turned = np.where((length(0) <= length(1))[:, None], cells, np.roll(cells, -1, axis=1))
    return [turned[:, [0, 1, 2]], turned[:, [0, 2, 3]]]


def panels_in(kind):
    return {"triangle": 1, "quad": 1, "triangle6": 4, "quad8": 5}[kind]


class Measured:
    """Panels, area and enclosed volume of surface cells, given as (kind, array of node numbers); their orientation may differ, but they must be convex
    together with what `inside` says: a point inside the body of each triangle."""

    def __init__(self, points, cells, inside):
        self.panels, self.area, self.volume = 0, 0.0, 0.0
        for kind, nodes in cells:
            if len(nodes) == 0:
                continue
            self.panels += len(nodes) * panels_in(kind)
            for rows in triangles_of(points, kind, nodes):
                a, b, c = (points[rows[:, k]] for k in range(3))
                normals = np.cross(b - a, c - a) / 2
                self.area += np.linalg.norm(normals, axis=1).sum()
                self.volume += np.abs(np.einsum("ij,ij->i", a - inside((a + b + c) / 3), normals)).sum() / 3


def inside_of_scene(points):
    """The centre of the first box, of the second if it is separate, or of the ball: each body is convex."""
    return np.where(points[:, :1] > 2.1, [[3.0, 0, 0]], np.where(points[:, :1] > 1.25, [[1.75, 0.5, 0.5]], [[0.5, 0.5, 0.5]]))


def surface_cells(mesh, without_wall):
    """Surface cells of the mesh; without those on the wall between the boxes, x = 1/2."""
    for block in mesh.cells:
        if block.type in SURFACES:
            wall = np.isclose(mesh.points[block.data][:, :, 0], 0.5).all(axis=1) & without_wall
            yield block.type, block.data[~wall]


def measured_scene(mesh, without_wall=False):
    return Measured(mesh.points, list(surface_cells(mesh, without_wall)), inside_of_scene)


class Report:
    """The rows of `perimpact mesh`."""

    def __init__(self, t, *arguments):
        self.text = t.expect_success("mesh", *arguments).out
        rows = dict(re.findall(r"^  ([a-z]+) {2,}(.*)$", self.text, re.M))
        self.closure = rows["closure"]
        self.panels = int(rows["panels"].split()[0])
        self.area = float(rows["area"].split()[0])
        self.volume = float(rows["volume"].split()[0]) if "volume" in rows else None
        self.size = [float(word) for word in rows["size"].removesuffix(" m").split(" x ")]
        self.parts = {name: int(panels) for name, panels in re.findall(r"^(?:  parts)? +(\S.*): (\d+) panels, ", self.text, re.M)}


def expect_equal(t, name, expected):
    report = Report(t, name)
    t.assertEqual((report.closure, report.panels), ("closed", expected.panels), name)
    # `mesh` prints five digits, which rounds by 5e-5 at most; floats of 24 bits and texts of six digits round by less
    t.assertAlmostEqual(report.area / expected.area, 1, delta=6e-5, msg=name)
    t.assertAlmostEqual(report.volume / expected.volume, 1, delta=6e-5, msg=name)
    return report


def expect_what_gmsh_saves(t, *forms):
    """Surfaces apart, and solids with a wall in common, in each form: file name and gmsh's options."""
    need("gmsh", "meshio")
    for what, scene, dimension in (("surfaces", BODIES_APART, 2), ("solids", SCENE, 3)):
        (t.folder / f"{what}.geo").write_text(scene)
        gmsh(t, f"{what}.geo", f"-{dimension}", "-format", "msh41", "-o", f"{what}.msh")
        expected = measured_scene(meshio.read(t.folder / f"{what}.msh"), without_wall=dimension == 3)
        for name, *options in forms:
            if dimension == 3 and name.endswith(".stl"):
                continue  # has the wall, but no solids that would say that it is inside
            gmsh(t, f"{what}.msh", "-save", *options, "-o", f"{what}_{name}")
            expect_equal(t, f"{what}_{name}", expected)


@claim("formats: gmsh's own meshes read back equal in every version, text and binary, surfaces and solids")
def _(t):
    expect_what_gmsh_saves(t, ("a.msh", "-format", "msh22"), ("b.msh", "-format", "msh22", "-bin"), ("c.msh", "-format", "msh40"),
                           ("d.msh", "-format", "msh41"), ("e.msh", "-format", "msh41", "-bin"),
                           ("f.msh", "-format", "msh41", "-part", "3"), ("g.msh", "-format", "msh22", "-part", "3"))


@claim("formats: STL files written by gmsh read back equal")
def _(t):
    expect_what_gmsh_saves(t, ("a.stl", "-format", "stl"), ("b.stl", "-format", "stl", "-bin"))


@claim("formats: VTK files written by gmsh read back equal, surfaces and solids")
def _(t):
    expect_what_gmsh_saves(t, ("a.vtk", "-format", "vtk"), ("b.vtk", "-format", "vtk", "-bin"))


@claim("formats: Abaqus files written by gmsh read back equal, surfaces and solids")
def _(t):
    expect_what_gmsh_saves(t, ("a.inp", "-format", "inp"))


@claim("formats: LS-DYNA files written by gmsh read back equal, surfaces and solids")
def _(t):
    expect_what_gmsh_saves(t, ("a.key", "-format", "key"))


@claim("formats: solids of second order that gmsh makes have the skin of its second-order surfaces, though only the solids are saved")
def _(t):
    need("gmsh", "meshio")
    pipe = """SetFactory("OpenCASCADE");
Disk(1) = {0, 0, 0, 1};
Extrude {0, 0, 1} { Surface{1}; Layers{2}; %s }
Mesh.MeshSizeMax = 1; %s"""
    types = {  # Gmsh's numbers of tetrahedra, prisms and hexahedra, incomplete and complete, by how the disk is meshed and extruded
        ("11", "11"): ("", ""),
        ("18", "13"): ("Recombine;", ""),
        ("17", "12"): ("Recombine;", "Recombine Surface{1}; Mesh.RecombinationAlgorithm = 2;"),
    }
    for expected_types, (extrusion, more) in types.items():
        (t.folder / "solids.geo").write_text(pipe % (extrusion, more) + '\nPhysical Volume("steel", 4) = {1};\n')
        (t.folder / "surfaces.geo").write_text(pipe % (extrusion, more) + "\nall() = Surface{:}; Physical Surface(4) = all();\n")
        order = ["-3", "-order", 2, "-setnumber", "Mesh.SecondOrderIncomplete"]
        gmsh(t, "surfaces.geo", *order, 1, "-format", "msh41", "-o", "surfaces.msh")
        mesh = meshio.read(t.folder / "surfaces.msh")
        expected = Measured(mesh.points, list(surface_cells(mesh, False)), lambda points: np.array([0, 0, 0.5]))
        for incomplete in (1, 0):  # complete ones have nodes in the middle of faces too
            for version in ("msh22", "msh41"):
                gmsh(t, "solids.geo", *order, incomplete, "-format", version, "-o", "solids.msh")
                t.assertEqual(list(expect_equal(t, "solids.msh", expected).parts), ["steel"])
                if version == "msh22":
                    elements = (t.folder / "solids.msh").read_text().split("$Elements\n")[1].splitlines()[1:-1]
                    t.assertEqual({line.split()[1] for line in elements}, {expected_types[1 - incomplete]})


@claim("formats: groups of Gmsh are parts, whatever the version of the file")
def _(t):
    need("gmsh")
    (t.folder / "box.geo").write_text("""SetFactory("OpenCASCADE");
Box(1) = {0, 0, 0, 1, 1, 1};
Physical Surface("low side", 7) = {-1, 2};
Physical Surface("all sides", 4) = {1, 3, 4};
Physical Surface(9) = {5};
Physical Volume("steel", 9) = {1};
Transfinite Curve{:} = 2;
Transfinite Surface{:};
""")
    for version in ("msh22", "msh40", "msh41"):
        for partitions in ([], ["-part", "2"]):
            gmsh(t, "box.geo", "-3", "-format", version, "-o", "box.msh", *partitions)
            report = Report(t, "box.msh")
            # each side of the box is two triangles
            t.assertEqual(report.parts, {"all sides + low side": 2, "low side": 2, "all sides": 4, "physical surface 9": 2, "steel": 2})


def meshio_surface():
    """A sphere of triangles between its poles and of quads around its equator, oriented outward."""
    rings, around = 7, 12
    polar, turn = np.pi * np.arange(1, rings) / rings, 2 * np.pi * np.arange(around) / around
    grid = np.array([[np.sin(p) * np.cos(u), np.sin(p) * np.sin(u), np.cos(p)] for p in polar for u in turn])
    points = np.vstack([grid, [[0, 0, 1], [0, 0, -1]]])
    top, bottom = len(grid), len(grid) + 1
    at = lambda ring, k: ring * around + k % around
    triangles = [[top, at(0, k), at(0, k + 1)] for k in range(around)] + [[bottom, at(rings - 2, k + 1), at(rings - 2, k)] for k in range(around)]
    quads = [[at(r, k), at(r + 1, k), at(r + 1, k + 1), at(r, k + 1)] for r in range(rings - 2) for k in range(around)]
    return points, np.array(triangles), np.array(quads)


def meshio_solids():
    """2 x 3 x 2 cubes three times beside one another: of hexahedra, of wedges, and of pyramids and tetrahedra."""
    points, cells = [], {kind: [] for kind in FACES}
    for body in range(3):
        first = len(points)
        shape = (3, 4, 3)
        points += [[4 * body + x, y, z] for z in range(shape[2]) for y in range(shape[1]) for x in range(shape[0])]
        at = lambda x, y, z: first + x + shape[0] * (y + shape[1] * z)
        for z in range(2):
            for y in range(3):
                for x in range(2):
                    c = [at(x, y, z), at(x + 1, y, z), at(x + 1, y + 1, z), at(x, y + 1, z)]
                    c += [at(x, y, z + 1), at(x + 1, y, z + 1), at(x + 1, y + 1, z + 1), at(x, y + 1, z + 1)]
                    if body == 0:
                        cells["hexahedron"].append(c)
                    elif body == 1:
                        cells["wedge"] += [[c[0], c[1], c[2], c[4], c[5], c[6]], [c[0], c[2], c[3], c[4], c[6], c[7]]]
                    else:  # six pyramids over the middle; where cubes meet, their quads do
                        middle = len(points)
                        points.append([4 * body + x + 0.5, y + 0.5, z + 0.5])
                        for face in FACES["hexahedron"]:
                            corners = [c[int(k)] for k in face]
                            # towards the middle the base must be oriented inward
                            base = corners if face == "0123" else corners[::-1]
                            if face == "4567":  # cut in two tetrahedra each: no cube is above the other's lid but at z = 1
                                if z == 0:
                                    cells["pyramid"].append([*base, middle])
                                else:
                                    cells["tetra"] += [[base[0], base[1], base[2], middle], [base[0], base[2], base[3], middle]]
                            else:
                                cells["pyramid"].append([*base, middle])
    return np.array(points, float), {kind: np.array(rows) for kind, rows in cells.items()}


def skin(cells):
    """Faces that one cell only has, by number of corners."""
    faces = [tuple(row[int(k)] for k in face) for kind, rows in cells.items() for row in rows.tolist() for face in FACES[kind]]
    count = Counter(tuple(sorted(face)) for face in faces)
    outer = [face for face in faces if count[tuple(sorted(face))] == 1]
    return [(kind, np.array([face for face in outer if len(face) == n])) for kind, n in (("triangle", 3), ("quad", 4))]


def expect_what_meshio_writes(t, *forms, quads=True, solids=True, pyramids=True):
    """`forms`: (file name, meshio's name of the format, its options)."""
    need("meshio")
    points, triangles, rectangles = meshio_surface()
    if not quads:
        triangles, rectangles = np.vstack([triangles, rectangles[:, [0, 1, 2]], rectangles[:, [0, 2, 3]]]), rectangles[:0]
    surface = [("triangle", triangles), ("quad", rectangles)]
    scenes = [(points, [block for block in surface if len(block[1])], Measured(points, surface, np.zeros_like))]
    if solids:
        points, cells = meshio_solids()
        if not pyramids:
            cells = {kind: cells[kind] for kind in ("hexahedron", "wedge")}  # the tetrahedra stand on pyramids
        middle_of_block = lambda where: np.column_stack([np.where(where[:, 0] < 3, 1, np.where(where[:, 0] < 7, 5, 9)), *(np.full(len(where), v) for v in (1.5, 1))])
        scenes.append((points, list(cells.items()), Measured(points, skin(cells), middle_of_block)))
        if pyramids:
            t.assertAlmostEqual(scenes[1][2].volume, 3 * 12, delta=1e-9)  # rounding
    for name, form, options in forms:
        for points, cells, expected in scenes:
            mesh = meshio.Mesh(points, cells)
            if form.startswith("gmsh"):  # it wants an entity for each kind of cell
                mesh.point_data["gmsh:dim_tags"] = np.tile([2 if cells[0][0] in SURFACES else 3, 1], (len(points), 1))
                for tag in ("gmsh:physical", "gmsh:geometrical"):
                    mesh.cell_data[tag] = [np.full(len(block.data), k + 1) for k, block in enumerate(mesh.cells)]
            meshio.write(t.folder / name, mesh, file_format=form, **options)
            expect_equal(t, name, expected)


@claim("formats: STL files written by meshio read back equal")
def _(t):
    expect_what_meshio_writes(t, ("a.stl", "stl", {"binary": False}), ("b.stl", "stl", {"binary": True}), quads=False, solids=False)


@claim("formats: OBJ files written by meshio read back equal")
def _(t):
    expect_what_meshio_writes(t, ("a.obj", "obj", {}), solids=False)


@claim("formats: PLY files written by meshio read back equal")
def _(t):
    expect_what_meshio_writes(t, ("a.ply", "ply", {"binary": False}), ("b.ply", "ply", {"binary": True}), solids=False)


@claim("formats: OFF files written by meshio read back equal")
def _(t):
    expect_what_meshio_writes(t, ("a.off", "off", {}), quads=False, solids=False)


@claim("formats: VTK files written by meshio read back equal, surfaces and solids")
def _(t):
    expect_what_meshio_writes(t, *((f"{form}_{binary}.vtk", form, {"binary": binary}) for form in ("vtk42", "vtk51") for binary in (False, True)))


@claim("formats: VTU files written by meshio read back equal, surfaces and solids")
def _(t):
    expect_what_meshio_writes(t, ("a.vtu", "vtu", {"binary": False}), ("b.vtu", "vtu", {"compression": None}), ("c.vtu", "vtu", {"compression": "zlib"}))


@claim("formats: Abaqus files written by meshio read back equal, surfaces and solids")
def _(t):
    expect_what_meshio_writes(t, ("a.inp", "abaqus", {}), pyramids=False)  # for which meshio has no name there


@claim("formats: Gmsh files written by meshio read back equal, surfaces and solids")
def _(t):
    expect_what_meshio_writes(t, *((f"{form}_{binary}.msh", form, {"binary": binary}) for form in ("gmsh22", "gmsh") for binary in (False, True)))


# a box of 100 x 60 x 40 and a ball of radius 25
CAD = """SetFactory("OpenCASCADE");
Box(1) = {0, 0, 0, 100, 60, 40};
Sphere(2) = {200, 0, 0, 25};
"""
MILLIMETRE = "SI_UNIT(.MILLI.,.METRE.)"


def step_in_inches(text):
    """Every unit of length becomes the inch, as ISO 10303-41 has it."""
    number = 100000

    def inch(match):
        nonlocal number
        number += 10
        return (f"{match[1]} = ( CONVERSION_BASED_UNIT('INCH',#{number}) LENGTH_UNIT() NAMED_UNIT(#{number + 1}) );\n"
                f"#{number} = LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(25.4),#{number + 2});\n"
                f"#{number + 1} = DIMENSIONAL_EXPONENTS(1.,0.,0.,0.,0.,0.,0.);\n"
                f"#{number + 2} = ( LENGTH_UNIT() NAMED_UNIT(*) {MILLIMETRE} );")

    return re.sub(r"(#\d+) = \( LENGTH_UNIT\(\) NAMED_UNIT\(\*\) SI_UNIT\(\.MILLI\.,\.METRE\.\) \);", inch, text)


@claim("formats: STEP is read in metres, whatever its unit, with 36 panels around a circle, and leaves nothing behind")
def _(t):
    need("gmsh")
    temporary = t.folder / "temporary"
    temporary.mkdir()
    t.environment["TMPDIR"] = str(temporary)
    (t.folder / "part.geo").write_text(CAD)
    gmsh(t, "part.geo", "-0", "-o", "part.step")
    text = (t.folder / "part.step").read_text()
    t.assertIn(MILLIMETRE, text)
    (t.folder / "two 'words'.STP").write_text(text.replace(MILLIMETRE, "SI_UNIT($,.METRE.)"))
    (t.folder / "-inch.step").write_text(step_in_inches(text))
    for name, unit in (("part.step", 0.001), ("two 'words'.STP", 1), ("./-inch.step", 0.0254)):
        report = Report(t, name)
        t.assertEqual(report.closure, "closed")
        t.assertAlmostEqual(report.size[0] / (225 * unit), 1, delta=1e-4)  # four digits; a node is where the sphere reaches x = 225
        t.assertEqual(sorted(report.parts), [f"surface {k}" for k in range(1, 8)])
        # chords of 10 degrees have lost sin(10)/10 = 0.5 % of the area of a sphere in each of two directions, triangles somewhat more
        lost = 1 - (report.area / unit**2 - 24800) / (4 * np.pi * 25**2)
        t.assertTrue(0.003 < lost < 0.01, lost)
        t.assertTrue(0.995 < report.volume / unit**3 / (240000 + 4 / 3 * np.pi * 25**3) < 1)
    t.assertEqual(os.listdir(temporary), [])


@claim("formats: a STEP file that is damaged is refused in the words of the program that reads it, and leaves nothing behind")
def _(t):
    need("gmsh")
    temporary = t.folder / "temporary"
    temporary.mkdir()
    t.environment["TMPDIR"] = str(temporary)
    (t.folder / "part.geo").write_text(CAD)
    gmsh(t, "part.geo", "-0", "-o", "part.step")
    (t.folder / "cut.step").write_text((t.folder / "part.step").read_text()[:3000])
    done = t.run_program("mesh", "cut.step")
    t.expect_complaint(done, 2, "cut.step: gmsh cannot mesh this file: StepFile : ", "Incorrect syntax", "export STL")
    t.assertEqual((done.out, os.listdir(temporary)), ("", []))


def iges_cube(edge, unit_flag, unit, gap):
    """A cube of six bilinear faces (entity 128) that know nothing of one another; one of them is `gap` away from its neighbours. IGES 5.3, sections
    2.2 (lines of 80 columns) and 4.23 (the entity)."""
    lines = []

    def put(text, letter, number):
        lines.append(f"{text:<72}{letter}{number:7d}")

    put("made for a test", "S", 1)
    head = f"1H,,1H;,4Htest,8Htest.igs,4Htest,4Htest,32,38,6,308,15,4Htest,1.0,{unit_flag},{len(unit)}H{unit},1,0.01,15H20260101.000000,1.0E-06,1000.0,4Htest,4Htest,11,0;"
    heads = [head[k : k + 72] for k in range(0, len(head), 72)]
    for k, line in enumerate(heads):
        put(line, "G", k + 1)
    parameters, directory = [], []
    for axis in range(3):
        for side in (0, 1):
            corners = []
            for v in (0, 1):
                for u in (0, 1):
                    place = [0.0, 0.0, 0.0]
                    place[axis], place[(axis + 1) % 3], place[(axis + 2) % 3] = edge * side + gap * (axis == 0 and side == 1), edge * u, edge * v
                    corners += [f"{x:.9f}" for x in place]
            fields = "128 1 1 1 1 0 0 1 0 0 0. 0. 1. 1. 0. 0. 1. 1. 1. 1. 1. 1.".split() + corners + "0. 1. 0. 1.".split()
            rows = [""]
            for k, field in enumerate(fields):
                field += ";" if k == len(fields) - 1 else ","
                if len(rows[-1]) + len(field) > 64:
                    rows.append("")
                rows[-1] += field
            directory.append((len(parameters) + 1, len(rows)))
            parameters += [(row, 2 * len(directory) - 1) for row in rows]
    for k, (first, count) in enumerate(directory):
        put(f"{128:8d}{first:8d}" + 6 * f"{0:8d}" + "00000000", "D", 2 * k + 1)
        put(f"{128:8d}{0:8d}{0:8d}{count:8d}{0:8d}" + 24 * " " + f"{0:8d}", "D", 2 * k + 2)
    for k, (row, entry) in enumerate(parameters):
        lines.append(f"{row:<64}{entry:8d}P{k + 1:7d}")
    put(f"S{1:7d}G{len(heads):7d}D{2 * len(directory):7d}P{len(parameters):7d}", "T", 1)
    return "\n".join(lines) + "\n"


@claim("formats: IGES is read in metres, whatever its unit, and faces a tenth of a micrometre apart are sewn together")
def _(t):
    need("gmsh")
    for name, flag, unit, metres in (("a.igs", 2, "MM", 0.001), ("b.IGES", 1, "IN", 0.0254), ("c.iges", 6, "M", 1)):
        (t.folder / name).write_text(iges_cube(30, flag, unit, gap=1e-7 / metres))
        report = Report(t, name)
        t.assertEqual((report.closure, len(report.parts)), ("closed", 6))
        t.assertAlmostEqual(report.volume / (30 * metres) ** 3, 1, delta=6e-5)  # five digits; the gap is 4e-6 of the edge
    (t.folder / "apart.igs").write_text(iges_cube(30, 2, "MM", gap=0.01))
    t.assertIn("open", Report(t, "apart.igs").closure)


main()
