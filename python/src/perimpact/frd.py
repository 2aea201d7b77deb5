"""Results of CalculiX: nodes, elements and vibration modes of a .frd file.

Format: CalculiX CrunchiX and GraphiX manuals, "Result Format", of version 2.20; files written by ccx 2.20.
"""

from collections import Counter
from dataclasses import dataclass, field

import numpy as np

from ._core import InputError

# Faces by positions in the element: corners in order around the face, then the mid-side nodes of its edges in the same order. The mid-side nodes of an
# element are numbered as in the file: those of the first end, those between both ends, those of the second end.
_TETRAHEDRON = [(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)]
_WEDGE = [(0, 2, 1), (3, 4, 5), (0, 1, 4, 3), (1, 2, 5, 4), (2, 0, 3, 5)]
_HEXAHEDRON = [(0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)]
_TETRAHEDRON_EDGES = [(0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3)]
_WEDGE_EDGES = [(0, 1), (1, 2), (2, 0), (0, 3), (1, 4), (2, 5), (3, 4), (4, 5), (5, 3)]
_HEXAHEDRON_EDGES = [(0, 1), (1, 2), (2, 3), (3, 0), (0, 4), (1, 5), (2, 6), (3, 7), (4, 5), (5, 6), (6, 7), (7, 4)]


def _with_mid_sides(faces, edges):
    corners = 1 + max(max(face) for face in faces)
    middle = {frozenset(edge): corners + e for e, edge in enumerate(edges)}
    return [(*face, *(middle[frozenset((face[k - 1], face[k]))] for k in [*range(1, len(face)), 0])) for face in faces]


# by the element types of the format
_SOLIDS = {
    1: _HEXAHEDRON,
    2: _WEDGE,
    3: _TETRAHEDRON,
    4: _with_mid_sides(_HEXAHEDRON, _HEXAHEDRON_EDGES),
    5: _with_mid_sides(_WEDGE, _WEDGE_EDGES),
    6: _with_mid_sides(_TETRAHEDRON, _TETRAHEDRON_EDGES),
}
_SHELLS = {7: 3, 8: 6, 9: 4, 10: 8}  # with their numbers of nodes
_BEAMS = (11, 12)
_CORNERS = {3: 3, 4: 4, 6: 3, 8: 4}  # of a face with so many nodes


@dataclass
class Mode:
    """A mode as the file has it, in the units of the model."""

    frequency: float
    displacement: dict = field(default_factory=dict)  # three numbers for a node
    stress: dict = field(default_factory=dict)  # xx, yy, zz, xy, yz, zx for a node; empty where the file has none


@dataclass
class Results:
    """The contents of a .frd file, in the units of the model."""

    nodes: dict  # three coordinates for a node number
    elements: list  # (type, node numbers)
    modes: list  # Mode, of the last *FREQUENCY step


class _Reader:
    def __init__(self, path):
        self.path = path
        with open(path, encoding="latin-1") as file:
            self.lines = iter(enumerate(file, 1))
            self.number = 0
            self.nodes, self.elements, self.modes = {}, [], {}
            self.step = self.mode = None
            for line in self._rest():
                self._read(line)

    def fail(self, sentence):
        raise InputError(f"{self.path}:{self.number}: {sentence}")

    def _rest(self):
        for self.number, line in self.lines:
            yield line

    def _read(self, line):
        key = line[:5]
        if key == "    2":
            self.nodes = self._values(self._width(line), 3)
        elif key == "    3":
            self._read_elements(self._width(line))
        elif line.startswith("    1PSTEP"):
            self.step, self.mode = self._number(line), None
        elif line.startswith("    1PMODE"):
            self.mode = self._number(line)
        elif key == "  100" and self.mode is not None:
            self._read_result(line)

    def _number(self, line):
        """The last number of the line."""
        if not line.split()[-1].isdigit():
            self.fail("this line has no number of a step or a mode; write the file again.")
        return int(line.split()[-1])

    def _width(self, line):
        """The width of a node number, after the last number of the line, which tells the encoding."""
        encoding = line.split()[-1]
        if encoding not in ("0", "1"):
            self.fail("the block is binary; let ccx write text with *NODE FILE and *EL FILE, without OUTPUT=BINARY.")
        return 10 if encoding == "1" else 5

    def _values(self, width, count):
        """The numbers of each node in the lines up to the end of the block."""
        values, node = {}, None
        for line in self._rest():
            key = line[:3]
            if key == " -3":
                return values
            try:
                numbers = [float(line[at : at + 12]) for at in range(3 + width, len(line.rstrip()), 12)]
                if key == " -1":
                    node = int(line[3 : 3 + width])
                    values[node] = numbers
                elif key == " -2":
                    values[node] += numbers
            except (ValueError, KeyError):
                self.fail("this line is not the values of a node; write the file again.")
            if key == " -1" and len(values[node]) < min(count, 6):
                self.fail(f"node {node} has {len(values[node])} values, but needs {count}; write the file again.")
        self.fail("the file ends within a block; it is truncated: run ccx again.")

    def _read_elements(self, width):
        for line in self._rest():
            key = line[:3]
            if key == " -3":
                return
            try:
                if key == " -1":
                    self.elements.append((int(line[3 + width : 8 + width]), []))
                elif key == " -2":
                    self.elements[-1][1].extend(int(line[at : at + width]) for at in range(3, len(line.rstrip()), width))
            except (ValueError, IndexError):
                self.fail("this line is not an element; write the file again.")
        self.fail("the file ends within the elements; it is truncated: run ccx again.")

    def _read_result(self, line):
        width = self._width(line)
        try:
            frequency = float(line[12:24])
        except ValueError:
            self.fail("a result begins without its frequency; write the file again.")
        name = next(self._rest(), "").split()
        if len(name) < 3 or name[0] != "-4" or not name[2].isdigit():
            self.fail("a result begins without its name and number of components; write the file again.")
        components = {"DISP": 3, "STRESS": 6}.get(name[1])
        if name[1] == "DISPI":
            self.fail("the modes are complex, as those of cyclic symmetry or with damping; compute real modes of the whole body.")
        if components is None:
            return
        for position, line in enumerate(self._rest()):
            if position + 1 == int(name[2]):
                break
        values = self._values(width, components)
        mode = self.modes.setdefault(self.step, {}).setdefault(self.mode, Mode(frequency))
        (mode.displacement if name[1] == "DISP" else mode.stress).update({node: numbers[:components] for node, numbers in values.items()})


def read(path):
    """The nodes, elements and modes of a .frd file in text form, as `Results`.

    Raises InputError, with the line, where the file is damaged or binary, and where it has no modes; OSError where it cannot be read.
    """
    reader = _Reader(path)
    if not reader.modes:
        raise InputError(f"{path}: the file has no vibration modes; write them in a *FREQUENCY step with *NODE FILE and U below it.")
    last = reader.modes[max(reader.modes)]
    return Results(reader.nodes, reader.elements, [last[number] for number in sorted(last)])


def boundary_faces(elements):
    """The faces that only one solid element has, and shell elements, as tuples of node numbers: 3, 4, 6 or 8, the corners first; normals point outward.

    `elements`: (type, node numbers) of `Results`. Beams are left out. Raises InputError for types that the format does not have, and for elements that lack nodes.
    """
    shells, faces = [], []
    for kind, nodes in elements:
        needed = 1 + max(max(face) for face in _SOLIDS[kind]) if kind in _SOLIDS else _SHELLS.get(kind, 0)
        if len(nodes) < needed:
            raise InputError(f"an element of type {kind} has {len(nodes)} nodes, but needs {needed}; write the file again.")
        if kind in _SOLIDS:
            faces += [tuple(nodes[n] for n in face) for face in _SOLIDS[kind]]
        elif kind in _SHELLS:
            shells.append(tuple(nodes[: _SHELLS[kind]]))
        elif kind not in _BEAMS:
            raise InputError(f"an element has the type {kind}, which is not one of the .frd format (1 to 12).")
    corners = [frozenset(face[: _CORNERS[len(face)]]) for face in faces]
    shared = Counter(corners)
    return shells + [face for face, key in zip(faces, corners) if shared[key] == 1]


def arrays(values, nodes, components):
    """The values of the nodes as an array of a row each; not-a-number for nodes without values."""
    none = [np.nan] * components
    return np.array([values.get(node, none) for node in nodes], float).reshape(-1, components)
