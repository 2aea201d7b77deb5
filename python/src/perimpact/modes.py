"""Vibration modes of elastic impactors: from the results of a finite-element program to the file that `elastic.modes` of a deck names.

    python3 -m perimpact.modes panel.frd panel_modes.vtu --units mm t s

    from perimpact import modes
    frequencies, shapes = modes.from_eigenvectors(eigenvalues, vectors, mass)
    modes.write("panel_modes.vtu", points, faces, frequencies, shapes)

Mode shapes are normalised to unit modal mass, φᵀMφ = 1, and have the unit 1/√kg; stresses at unit modal coordinate are in Pa/(m √kg), in the order xx, yy, zz,
xy, yz, zx; positions are in metres, in the axes of the impactor's surface. Free bodies have the modes of a free body, without those of rigid motion. See the
guide, "Elastic impactors".
"""

import argparse
import base64
import sys
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Optional

import numpy as np

from . import frd
from ._core import InputError, Mesh

# what a unit is in SI
LENGTHS = {"m": 1.0, "cm": 1e-2, "mm": 1e-3, "in": 0.0254, "ft": 0.3048}
MASSES = {"kg": 1.0, "g": 1e-3, "t": 1e3}
TIMES = {"s": 1.0, "ms": 1e-3}

_VTK_TYPES = {3: 5, 4: 9, 6: 22, 8: 23}  # triangle, quadrilateral, and both with mid-side nodes
_POLYGON = 7
_FILE_DIGITS = 1e-5  # of the size: CalculiX writes coordinates with six digits


@dataclass
class Modes:
    """Modes on points, in SI. Its fields points, faces, frequencies, shapes and stresses are the arrays of `write`."""

    points: np.ndarray
    faces: list
    frequencies: np.ndarray
    shapes: np.ndarray
    stresses: Optional[np.ndarray] = None

    def __len__(self):
        return len(self.frequencies)


def write(path, points, faces, frequencies, shapes, stresses=None, damping=None):
    """Writes modes to a file (.vtu or .csv) that a deck names in `elastic: {modes: …}`.

    points: (n, 3) [m], in the axes of the impactor's surface.
    faces: point numbers of each face, with 3, 4, 6 or 8 of them (those of the mid-side nodes last) or a polygon; then the file (.vtu) is also the surface of the
    impactor, `surface: {file: …}`. None where the surface comes from elsewhere.
    frequencies: (m,) [Hz].
    shapes: (m, n, 3) [1/√kg], normalised to unit modal mass.
    stresses: (m, n, 6) [Pa/(m √kg)] at unit modal coordinate, in the order xx, yy, zz, xy, yz, zx.
    damping: ratio of critical damping, (m,) or one for all modes.

    Raises InputError where the shapes of the arrays do not fit, numbers are not finite, or a frequency is not positive.
    """
    points, frequencies, shapes = (np.asarray(one, float) for one in (points, frequencies, shapes))
    n, m = len(points), len(frequencies)
    wanted = {"points": (points, (n, 3)), "frequencies": (frequencies, (m,)), "shapes": (shapes, (m, n, 3))}
    if stresses is not None:
        stresses = np.asarray(stresses, float)
        wanted["stresses"] = (stresses, (m, n, 6))
    if damping is not None:
        damping = np.broadcast_to(np.asarray(damping, float), (m,)) if np.ndim(damping) == 0 else np.asarray(damping, float)
        wanted["damping"] = (damping, (m,))
    for name, (array, shape) in wanted.items():
        if array.shape != shape:
            raise InputError(f"{name} has the shape {array.shape}, but {n} points and {m} modes need {shape}.")
        if not np.isfinite(array).all():
            raise InputError(f"{name} has numbers that are not finite.")
    if not m:
        raise InputError("there are no modes to write.")
    if not (frequencies > 0).all():
        raise InputError(f"mode {1 + int(np.argmin(frequencies))} has a frequency of {frequencies.min():g} Hz, but that of an elastic mode is positive; leave out rigid-body modes.")
    faces = [[int(point) for point in face] for face in ([] if faces is None else faces)]
    if any(not 0 <= point < n for face in faces for point in face):
        raise InputError(f"faces has point numbers outside 0 to {n - 1}.")
    writers = {".vtu": _write_vtu, ".csv": _write_csv}
    writer = writers.get(Path(path).suffix.lower())
    if writer is None:
        raise InputError(f"{path}: modes are written as .vtu or .csv.")
    writer(path, Modes(points, faces, frequencies, shapes, stresses), damping)


def _data_array(name, values, attributes=""):
    kinds = {"f": "Float64", "i": "Int64", "u": "UInt8"}
    data = np.ascontiguousarray(values).tobytes()
    text = base64.b64encode(len(data).to_bytes(8, "little") + data).decode()
    return f'<DataArray type="{kinds[values.dtype.kind]}" Name="{name}" {attributes}format="binary">{text}</DataArray>\n'


def _vectors(name, values):
    return _data_array(name, values.astype("<f8"), f'NumberOfComponents="{values.shape[1]}" ')


def _field(name, values):
    return _data_array(name, np.array(values, "<f8"), f'NumberOfTuples="{len(values)}" ')


def _write_vtu(path, modes, damping):
    lengths = [len(face) for face in modes.faces]
    connectivity = np.array([point for face in modes.faces for point in face], "<i8")
    types = np.array([_VTK_TYPES.get(length, _POLYGON) for length in lengths], "u1")
    shapes = [_vectors(f"mode_{k}", shape) for k, shape in enumerate(modes.shapes, 1)]
    stresses = [] if modes.stresses is None else [_vectors(f"stress_{k}", stress) for k, stress in enumerate(modes.stresses, 1)]
    parts = [
        '<?xml version="1.0"?>\n<VTKFile type="UnstructuredGrid" version="1.0" byte_order="LittleEndian" header_type="UInt64">\n<UnstructuredGrid>\n<FieldData>\n',
        _field("frequency [Hz]", modes.frequencies),
        "" if damping is None else _field("damping_ratio", damping),
        f'</FieldData>\n<Piece NumberOfPoints="{len(modes.points)}" NumberOfCells="{len(lengths)}">\n<PointData>\n',
        *shapes,
        *stresses,
        "</PointData>\n<Points>\n",
        _vectors("Points", modes.points),
        "</Points>\n<Cells>\n",
        _data_array("connectivity", connectivity),
        _data_array("offsets", np.cumsum(np.array(lengths, "<i8"), dtype="<i8")),
        _data_array("types", types),
        "</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n",
    ]
    Path(path).write_text("".join(parts), encoding="ascii")


def _write_csv(path, modes, damping):
    columns = ["x [m]", "y [m]", "z [m]"]
    columns += [f"mode_{k}_{axis}" for k in range(1, len(modes) + 1) for axis in "xyz"]
    blocks = [modes.points, *modes.shapes]
    if modes.stresses is not None:
        columns += [f"stress_{k}_{component}" for k in range(1, len(modes) + 1) for component in ("xx", "yy", "zz", "xy", "yz", "zx")]
        blocks += list(modes.stresses)
    with open(path, "w", encoding="ascii") as file:
        head = {"frequency [Hz]": modes.frequencies, **({} if damping is None else {"damping_ratio": damping})}
        for name, values in head.items():
            print(name, *(repr(float(value)) for value in values), sep=", ", file=file)
        print(*columns, sep=", ", file=file)
        for row in np.hstack(blocks):
            print(*(repr(float(value)) for value in row), sep=", ", file=file)


def normalised(shapes, mass):
    """The shapes (m, n, 3) scaled to unit modal mass, φᵀMφ = 1.

    mass: (n,) masses of the points [kg], or the mass matrix [kg] of the 3 n displacements x0, y0, z0, x1, … as an array or a sparse matrix.

    Raises InputError where a modal mass is not positive.
    """
    shapes = np.asarray(shapes, float)
    flat = shapes.reshape(len(shapes), -1)
    weighted = flat * np.repeat(np.asarray(mass, float), 3) if np.ndim(mass) == 1 else (mass @ flat.T).T
    modal = np.einsum("md,md->m", flat, np.asarray(weighted))
    if not (modal > 0).all():
        raise InputError(f"mode {1 + int(np.argmin(modal))} has a modal mass of {modal.min():g} kg, but it must be positive; check the mass matrix.")
    return shapes / np.sqrt(modal)[:, None, None]


def from_eigenvectors(eigenvalues, vectors, mass=None):
    """Frequencies (m,) [Hz] and shapes (m, n, 3) from the solution of K φ = λ M φ in SI, as scipy.sparse.linalg.eigsh or SLEPc gives it.

    eigenvalues: (m,) λ [1/s²].
    vectors: (3 n, m), a column for each mode, of the displacements x0, y0, z0, x1, ….
    mass: as of `normalised`; None where the columns are normalised already.

    Raises InputError where an eigenvalue is not positive: leave out the rigid-body modes.
    """
    eigenvalues, vectors = np.asarray(eigenvalues, float), np.asarray(vectors, float)
    if vectors.ndim != 2 or vectors.shape[0] % 3 or vectors.shape[1] != len(eigenvalues):
        raise InputError(f"vectors has the shape {vectors.shape}, but needs a column of three numbers per point for each of the {len(eigenvalues)} eigenvalues.")
    if not (eigenvalues > 0).all():
        raise InputError(f"eigenvalue {1 + int(np.argmin(eigenvalues))} is {eigenvalues.min():g}, but that of an elastic mode is positive; leave out rigid-body modes.")
    shapes = vectors.T.reshape(len(eigenvalues), -1, 3)
    return np.sqrt(eigenvalues) / (2 * np.pi), shapes if mass is None else normalised(shapes, mass)


def is_rigid(points, shape, tolerance=1e-3):
    """True if the shape (n, 3) is a rigid motion of the points (n, 3): what the best fit of translation and rotation leaves is below `tolerance` of it.

    The eigenvector of a rigid-body mode has the error of an iterative solver, and six digits in files.
    """
    points, shape = np.asarray(points, float), np.asarray(shape, float)
    arm = points - points.mean(axis=0)
    motions = [np.tile(axis, (len(points), 1)) for axis in np.eye(3)] + [np.cross(axis, arm) for axis in np.eye(3)]
    basis = np.stack([motion.ravel() for motion in motions], axis=1)
    fit = np.linalg.lstsq(basis, shape.ravel(), rcond=None)[0]
    return bool(np.linalg.norm(basis @ fit - shape.ravel()) <= tolerance * np.linalg.norm(shape))


def from_calculix(path, units=("m", "kg", "s")):
    """The modes of the last *FREQUENCY step of a .frd file on the boundary of its solids and on its shells, as `Modes` in SI, rigid-body modes included.

    units: of length, mass and time in the model: `("mm", "t", "s")` where stresses are in MPa and densities in t/mm³.

    CalculiX normalises modes to unit modal mass. Raises InputError where the file is damaged or binary, or has no modes; OSError where it cannot be read.
    """
    length, mass, time = _in_si(units)
    results = frd.read(path)
    faces = frd.boundary_faces(results.elements)
    nodes = sorted({node for face in faces for node in face})
    number = {node: k for k, node in enumerate(nodes)}
    unknown = [node for node in nodes if node not in results.nodes]
    if unknown:
        raise InputError(f"{path}: elements have node {unknown[0]}, but the file has no coordinates for it; write the file again.")
    shapes = np.array([frd.arrays(mode.displacement, nodes, 3) for mode in results.modes]) / np.sqrt(mass)
    stresses = None
    if all(mode.stress for mode in results.modes):
        pressure = mass / (length * time**2)
        stresses = np.array([frd.arrays(mode.stress, nodes, 6) for mode in results.modes]) * (pressure / (length * np.sqrt(mass)))
    missing = ~np.isfinite(shapes).all(axis=(0, 2))
    if missing.any():
        raise InputError(f"{path}: node {nodes[int(np.argmax(missing))]} of the boundary has no displacements; write those of all nodes with *NODE FILE.")
    points = length * frd.arrays(results.nodes, nodes, 3)
    frequencies = np.array([mode.frequency for mode in results.modes]) / time
    return Modes(points, [[number[node] for node in face] for face in faces], frequencies, shapes, stresses)


def _in_si(units):
    known = (LENGTHS, MASSES, TIMES)
    for unit, names in zip(units, known):
        if unit not in names:
            raise InputError(f"the unit {unit} is unknown; units are a length ({', '.join(LENGTHS)}), a mass ({', '.join(MASSES)}) and a time ({', '.join(TIMES)}).")
    return tuple(names[unit] for unit, names in zip(units, known))


def on_surface(modes, vertices, faces=None):
    """The modes at vertices (n, 3) [m] of a surface, each at the point nearest to it, with the positions of the vertices.

    Raises InputError for the first vertex that is further from all points than 1e-5 of the size of the surface: six digits, as in a .frd file.
    """
    vertices = np.asarray(vertices, float)
    tolerance = _FILE_DIGITS * np.linalg.norm(np.ptp(vertices, axis=0))
    direction = np.array([0.5403023, 0.6421092, 0.5438214])  # along which planes of a mesh rarely are
    along = modes.points @ direction
    order = np.argsort(along)
    first, last = (np.searchsorted(along[order], vertices @ direction + sign * 2 * tolerance, side) for sign, side in ((-1, "left"), (1, "right")))
    found = np.empty(len(vertices), int)
    for v, vertex in enumerate(vertices):
        near = order[first[v] : last[v]]
        distances = np.linalg.norm(modes.points[near] - vertex, axis=1)
        if not len(near) or distances.min() > tolerance:
            nearest = np.linalg.norm(modes.points - vertex, axis=1).min()
            raise InputError(
                f"vertex {v} of the surface (counted from 0), at {vertex} m, has no node within {tolerance:.3g} m; the nearest is {nearest:.3g} m away. Make the "
                "surface from the mesh of the modes, and check its scale and the units."
            )
        found[v] = near[np.argmin(distances)]
    stresses = None if modes.stresses is None else modes.stresses[:, found]
    return Modes(vertices, [] if faces is None else faces, modes.frequencies, modes.shapes[:, found], stresses)


def chosen(modes, numbers):
    """The modes with these numbers, from 1. Raises InputError for others."""
    for number in numbers:
        if not 1 <= number <= len(modes):
            raise InputError(f"there is no mode {number}; the file has modes 1 to {len(modes)}.")
    which = np.array(numbers, int) - 1
    return replace(modes, frequencies=modes.frequencies[which], shapes=modes.shapes[which], stresses=None if modes.stresses is None else modes.stresses[which])


def _convert(arguments):
    if Path(arguments.results).suffix.lower() != ".frd":
        raise InputError(f"{arguments.results}: only .frd files of CalculiX are converted; for other programs call perimpact.modes.write with their arrays.")
    modes = from_calculix(arguments.results, arguments.units)
    numbers = arguments.modes or range(1, len(modes) + 1)
    kept = [number for number in numbers if arguments.modes or not is_rigid(modes.points, modes.shapes[number - 1])]
    for number in sorted(set(numbers) - set(kept)):
        print(f"mode {number}, {modes.frequencies[number - 1]:.4g} Hz: rigid motion, left out")
    modes = chosen(modes, kept)
    if arguments.surface:
        mesh = Mesh.read(arguments.surface)
        modes = on_surface(modes, arguments.scale * mesh.vertices, [[point for point in face if point >= 0] for face in mesh.faces.tolist()])
    write(arguments.output, modes.points, modes.faces, modes.frequencies, modes.shapes, modes.stresses, arguments.damping)
    for number, frequency in zip(kept, modes.frequencies):
        print(f"mode {number}, {frequency:.4g} Hz: mode_{kept.index(number) + 1}")
    print(f"{arguments.output}: {len(modes)} modes on {len(modes.points)} points{'' if modes.stresses is None else ', with stresses'}")


def main(words=None):
    """The command line; returns the exit code."""
    parser = argparse.ArgumentParser(prog="python3 -m perimpact.modes", description="Modes of a .frd file of CalculiX as a file for `elastic.modes` of a deck.")
    parser.add_argument("results", help=".frd file with the results of a *FREQUENCY step")
    parser.add_argument("output", help="file to write: .vtu, which can also be the impactor's surface, or .csv")
    parser.add_argument("--units", nargs=3, metavar=("LENGTH", "MASS", "TIME"), default=("m", "kg", "s"), help="units of the model, for example mm t s; m kg s where absent")
    parser.add_argument("--surface", metavar="FILE", help="surface of the impactor on nodes of the model; where absent, the boundary of the model")
    parser.add_argument("--scale", type=float, default=1.0, help="factor that converts the surface's coordinates to metres, as in the deck")
    parser.add_argument("--modes", type=lambda text: [int(word) for word in text.split(",")], metavar="1,2,…", help="modes to take; where absent, all but rigid motions")
    parser.add_argument("--damping", type=float, help="ratio of critical damping of all modes")
    try:
        _convert(parser.parse_args(words))
    except (InputError, OSError) as error:
        print(f"error: {error}", file=sys.stderr)
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main())
