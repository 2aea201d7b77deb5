"""`perimpact.Results` reads the results folder of a run with NumPy alone; frames in .vtkhdf files need h5py too.

    results = perimpact.Results("results")
    force = results.history["cylinder.force_y [N]"]
    for frame in results.frames["plate"]:
        print(frame.time, frame.point["damage"].max())
"""

import json
import struct
import zlib
from collections.abc import Sequence
from dataclasses import dataclass, field
from os import PathLike
from pathlib import Path
from typing import Any, Union
from xml.etree import ElementTree

import numpy as np

from ._core import InputError

_TYPES = {"Float32": "f4", "Float64": "f8", "Int32": "i4", "Int64": "i8", "UInt8": "u1"}
_APPENDED = b'<AppendedData encoding="raw">'


@dataclass
class Frame:
    """A body or an impactor at one time [s], as in a file of `frames/`.

    points: (n, 3) [m], the particles of a body, or the vertices of the panels of an impactor.
    faces: (m, 4) vertex numbers of each panel, the fourth -1 for triangles; empty for bodies.
    point: arrays of the points by name: {"damage": (n,), "displacement": (n, 3), …}.
    panel: arrays of the panels by name: {"contact_pressure": (m,), …}.

    Names and units: docs/guide/results.md. Row n is the same particle in each frame, except with a moving window, whose particles change, and in thinned frames,
    where the array `particle` has its number.
    """

    time: float
    points: np.ndarray
    faces: np.ndarray
    point: dict[str, np.ndarray] = field(default_factory=dict)
    panel: dict[str, np.ndarray] = field(default_factory=dict)


class Frames(Sequence):
    """The frames of a body or an impactor in the order of their times: `frames[-1]`, `for frame in frames`. A frame is read on access.

    times: (n,) [s].
    """

    times: np.ndarray

    def __init__(self, name, times, read):
        self.name, self.times, self._read = name, np.array(times, float), read

    def __len__(self) -> int:
        return len(self.times)

    def __getitem__(self, number):
        if isinstance(number, slice):
            return [self[k] for k in range(*number.indices(len(self)))]
        return self._read(range(len(self))[number])

    def at(self, time: float) -> Frame:
        """The frame nearest to the time [s]."""
        if not len(self):
            raise InputError(f"there is no frame of {self.name} yet.")
        return self[int(np.argmin(np.abs(self.times - time)))]

    def __repr__(self):
        return f"<perimpact.Frames of {self.name}, {len(self)}>"


class _Named(dict):
    """A dict whose missing keys are an InputError that names those it has."""

    def __init__(self, what, items):
        super().__init__(items)
        self.what = what

    def __missing__(self, name):
        raise InputError(f"there is no {self.what} {name!r} in the results; known here: {', '.join(self) or 'none'}.")


class Results:
    """The results folder of a run, of Python or the command line, finished or not. Files are read on each access, so those of a run in progress are current."""

    def __init__(self, folder: Union[str, PathLike[str]]):
        """folder: the results folder.

        Raises InputError where it contains no run.
        """
        self.folder = Path(folder)
        if not (self.folder / "history.csv").exists():
            reason = "does not exist" if not self.folder.exists() else "has no history.csv, so it is not the results folder of a run"
            raise InputError(f"{self.folder} {reason}; give the folder that output.folder, --out or write_results named.")

    def __repr__(self):
        return f"<perimpact.Results {self.folder}>"

    @property
    def run(self) -> dict[str, Any]:
        """Contents of run.json: outcome, set-up, checks, warnings and timers. Raises InputError while the run has not ended."""
        path = self.folder / "run.json"
        if not path.exists():
            raise InputError(f"{path} is written when a run ends; this run is in progress, or was killed.")
        return json.loads(path.read_text())

    @property
    def columns(self) -> dict[str, dict[str, str]]:
        """Description of the history columns: {column: {"unit", "kind", "meaning"}}; the kind is instantaneous, interval mean or cumulative."""
        path = self.folder / "history.json"
        if not path.exists():
            raise InputError(f"{path} is missing, which describes the columns of history.csv.")
        columns = json.loads(path.read_text())["columns"]
        return _Named("column", {f"{column['name']} [{column['unit'] or '-'}]": {key: column[key] for key in ("unit", "kind", "meaning")} for column in columns})

    @property
    def history(self) -> dict[str, np.ndarray]:
        """The columns of history.csv: {column: array}, such as "cylinder.force_y [N]"."""
        return self.table("history.csv")

    @property
    def lines(self) -> dict[str, dict[float, dict[str, np.ndarray]]]:
        """Displacements along lines: {line: {time [s]: {column: array}}}, such as "displacement_y [m]". Times have ten digits."""
        lines = {}
        for path in (self.folder / "lines").glob("*_t*.csv"):
            name, time = path.stem.rsplit("_t", 1)
            lines.setdefault(name, {})[float(time)] = self.table(path.relative_to(self.folder))
        return _Named("line", {name: dict(sorted(tables.items())) for name, tables in sorted(lines.items())})

    @property
    def frames(self) -> dict[str, Frames]:
        """Frames by name of body or impactor: {name: Frames}."""
        folder = self.folder / "frames"
        return _Named("body or impactor", {path.stem: _READERS[path.suffix](path) for path in sorted(folder.glob("*")) if path.suffix in _READERS})

    def table(self, file: Union[str, PathLike[str]]) -> dict[str, np.ndarray]:
        """The columns of another table: {column: array}.

        file: its path in the folder, such as "fragments/plate.csv".
        """
        path = self.folder / file
        if not path.exists():
            tables = sorted(str(path.relative_to(self.folder)) for path in self.folder.rglob("*.csv"))
            raise InputError(f"there is no table {file} in the results; known here: {', '.join(tables)}.")
        text = path.read_text()
        names, *rows = text[: text.rfind("\n") + 1].splitlines() or [""]  # a run in progress may be writing the last row
        try:
            numbers = np.array([row.split(",") for row in rows], float).reshape(len(rows), names.count(",") + 1)
        except ValueError as error:
            raise InputError(f"{path} is damaged: a row does not have a number for each column.") from error
        return _Named("column", zip(names.split(","), numbers.T.copy()))


def _faces(corners, ends):
    """(m, 4) vertex numbers of triangles and quadrilaterals, from those of all panels and the end of each among them."""
    sizes = np.diff(ends, prepend=0)
    faces = np.full((len(ends), 4), -1)
    faces[np.arange(4) < sizes[:, None]] = corners
    return faces


# ---- .vtp ----


def _vtp_series(path):
    entries = [(float(entry.get("timestep")), path.parent / entry.get("file")) for entry in ElementTree.parse(path).getroot().iter("DataSet")]
    return Frames(path.stem, [time for time, _ in entries], lambda number: _read_vtp(*entries[number]))


def _vtp_array(content, start, element, is_packed):
    """The array of an element. Packed data begins with the number of blocks, two sizes of blocks, and the packed size of each; other data with its size."""
    at = start + int(element.get("offset"))
    (count,) = struct.unpack_from("<Q", content, at)
    if is_packed:
        sizes = struct.unpack_from(f"<{count}Q", content, at + 24)
        ends = at + 24 + 8 * count + np.cumsum((0, *sizes))
        data = b"".join(zlib.decompress(content[first:last]) for first, last in zip(ends[:-1], ends[1:]))
    else:
        data = content[at + 8 : at + 8 + count]
    values = np.frombuffer(data, "<" + _TYPES[element.get("type")])
    components = int(element.get("NumberOfComponents", 1))
    return values if components == 1 else values.reshape(-1, components)


def _read_vtp(time, path):
    try:
        content = path.read_bytes()
        mark = content.index(_APPENDED)
        head = ElementTree.fromstring(content[:mark] + b"</VTKFile>")
        start = content.index(b"_", mark) + 1
        is_packed = head.get("compressor") is not None
        found = {}
        for section in "Points", "PointData", "CellData", "Polys":
            found[section] = {element.get("Name"): _vtp_array(content, start, element, is_packed) for element in head.findall(f".//{section}/DataArray")}
        (points,) = found["Points"].values()
        polygons = found["Polys"] or {"connectivity": np.empty(0, int), "offsets": np.empty(0, int)}
        return Frame(time, points, _faces(polygons["connectivity"], polygons["offsets"]), found["PointData"], found["CellData"])
    except OSError as error:
        raise InputError(f"{path} cannot be read: {error.strerror}.") from error
    except (ValueError, KeyError, struct.error, zlib.error, ElementTree.ParseError) as error:
        raise InputError(f"{path} is damaged, or not a frame of perimpact: {error}.") from error


# ---- .vtkhdf ----


def _vtkhdf_series(path):
    try:
        import h5py
    except ImportError as error:
        raise InputError(f"{path}: reading .vtkhdf frames needs h5py; install it, or write frames with output.frame_format: vtp.") from error

    def read(number):
        with h5py.File(path, "r") as file:
            return _read_vtkhdf(file["VTKHDF"], number)

    with h5py.File(path, "r") as file:
        steps = file["VTKHDF/Steps"]
        times = steps["Values"][: int(steps.attrs["NSteps"])]
    return Frames(path.stem, times, read)


def _read_vtkhdf(root, number):
    """A step. The format has one part a step, or one for all; offsets tell where each array of the step begins."""
    steps = root["Steps"]
    part = int(steps["PartOffsets"][number])

    def rows(array, first, count):
        return array[int(first) : int(first) + int(count)]

    count = root["NumberOfPoints"][part]
    polygons, kinds = root["Polygons"], ["Vertices", "Lines", "Polygons", "Strips"]
    kind = kinds.index("Polygons")
    faces = polygons["NumberOfCells"][part]
    first = steps["CellOffsets"][number][kind] + part  # each part before has one offset more than cells
    ends = rows(polygons["Offsets"], first, faces + 1)
    corners = rows(polygons["Connectivity"], steps["ConnectivityIdOffsets"][number][kind], polygons["NumberOfConnectivityIds"][part])
    cells = sum(int(root[kind]["NumberOfCells"][part]) for kind in kinds)

    def arrays(of, size):
        return {name: rows(array, steps[f"{of}DataOffsets"][name][number], size) for name, array in root.get(f"{of}Data", {}).items()}

    points = rows(root["Points"], steps["PointOffsets"][number], count)
    return Frame(float(steps["Values"][number]), points, _faces(corners, ends[1:]), arrays("Point", count), arrays("Cell", cells))


_READERS = {".pvd": _vtp_series, ".vtkhdf": _vtkhdf_series}
