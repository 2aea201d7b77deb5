"""An undulated sphere of a million triangles, in every format that perimpact and a reference program read."""

import meshio
import numpy as np

FORMATS = ["stl", "ascii.stl", "obj", "ply", "off", "vtk", "vtp", "msh", "inp", "k"]


def sphere(n):
    """12 n² triangles, oriented outward, with shared vertices: the six faces of a cube, projected."""
    u, v = (grid.ravel() for grid in np.meshgrid(np.arange(n + 1), np.arange(n + 1), indexing="ij"))
    faces, points = [], []
    corner = np.arange((n + 1) ** 2).reshape(n + 1, n + 1)
    a, b, c, d = (part.ravel() for part in (corner[:-1, :-1], corner[1:, :-1], corner[1:, 1:], corner[:-1, 1:]))
    for axis in range(3):
        for side in (0, n):
            grid = np.insert(np.column_stack([u, v]), axis, side, axis=1)
            outward = (side > 0) == (axis != 1)  # u × v points along the axis, except for y
            rows = np.vstack([np.column_stack([a, b, c]), np.column_stack([a, c, d])])
            faces.append((rows if outward else rows[:, ::-1]) + len(points) * (n + 1) ** 2)
            points.append(grid)
    places, number = np.unique(np.vstack(points), axis=0, return_inverse=True)
    x = np.tan((places / n - 0.5) * np.pi / 2)  # panels of nearly equal size
    x /= np.linalg.norm(x, axis=1, keepdims=True)
    bump = 1 + 0.05 * np.sin(9 * x[:, :1]) * np.cos(7 * x[:, 1:2] + 1) * np.cos(8 * x[:, 2:])
    return x * bump, number.ravel()[np.vstack(faces)]


def write(folder, triangles=1e6):
    """The files by format, as their native programs write them: floats in STL, doubles or 17 digits elsewhere."""
    points, faces = sphere(round((triangles / 12) ** 0.5))
    mesh = meshio.Mesh(points, [("triangle", faces)])
    files = {kind: folder / f"sphere.{kind}" for kind in FORMATS}

    facets = np.zeros(len(faces), np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")]))
    facets["corners"] = points[faces]
    files["stl"].write_bytes(b"a bumpy sphere".ljust(80) + np.uint32(len(faces)).tobytes() + facets.tobytes())
    with open(files["ascii.stl"], "w", encoding="ascii") as file:
        file.write("solid sphere\n")
        for corners in points[faces].astype("f4"):
            vertices = "".join("      vertex %.9g %.9g %.9g\n" % tuple(corner) for corner in corners)
            file.write(f"  facet normal 0 0 0\n    outer loop\n{vertices}    endloop\n  endfacet\n")
        file.write("endsolid sphere\n")
    with open(files["obj"], "w", encoding="ascii") as file:
        np.savetxt(file, points, "v %.17g %.17g %.17g")
        np.savetxt(file, faces + 1, "f %d %d %d")
    mesh.write(files["ply"], "ply", binary=True)
    mesh.write(files["off"], "off")
    mesh.write(files["vtk"], "vtk", binary=True)
    write_vtp(files["vtp"], points, faces)
    mesh.write(files["msh"], "gmsh", binary=True)
    mesh.write(files["inp"], "abaqus")
    with open(files["k"], "w", encoding="ascii") as file:
        file.write("*KEYWORD\n*NODE\n")
        np.savetxt(file, np.column_stack([np.arange(1, len(points) + 1), points]), "%8d%16.9e%16.9e%16.9e")
        file.write("*ELEMENT_SHELL\n")
        elements = np.column_stack([np.arange(1, len(faces) + 1), np.ones(len(faces), int), faces + 1, faces[:, 2] + 1])
        np.savetxt(file, elements, "%8d" * 6)
        file.write("*END\n")
    return files


def write_vtp(path, points, faces):
    """As ParaView's default, but uncompressed: appended and raw."""
    arrays = [points.astype("<f8"), faces.astype("<i8"), np.arange(3, 3 * len(faces) + 1, 3, dtype="<i8")]
    offsets = np.cumsum([0] + [8 + array.nbytes for array in arrays])
    with open(path, "wb") as file:
        file.write(f"""<?xml version="1.0"?>
<VTKFile type="PolyData" version="1.0" byte_order="LittleEndian" header_type="UInt64">
<PolyData><Fragment NumberOfPoints="{len(points)}" NumberOfPolys="{len(faces)}">
<Points><DataArray type="Float64" NumberOfComponents="3" format="appended" offset="{offsets[0]}"/></Points>
<Polys><DataArray type="Int64" Name="connectivity" format="appended" offset="{offsets[1]}"/>
<DataArray type="Int64" Name="offsets" format="appended" offset="{offsets[2]}"/></Polys>
</Piece></PolyData><AppendedData encoding="raw">_""".encode())
        for array in arrays:
            file.write(np.uint64(array.nbytes).tobytes() + array.tobytes())
        file.write(b"</AppendedData></VTKFile>\n")
