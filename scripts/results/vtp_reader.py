"""Reads the .vtp files of a run with numpy alone: appended raw arrays, plain or zlib."""

import re
import struct
import xml.etree.ElementTree as xml
import zlib
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
from results_folder import Named, refuse

NUMPY_TYPE = {"Float32": "f4", "Float64": "f8", "Int32": "i4", "Int64": "i8", "UInt8": "u1"}


@dataclass
class Picture:
    points: np.ndarray  # (n, 3) [m]
    point: dict = field(default_factory=dict)  # arrays by name
    cell: dict = field(default_factory=dict)
    panels: list = field(default_factory=list)  # vertex numbers of each panel; empty for particles
    time: float = None  # [s]


def read_vtp(path):
    content = Path(path).read_bytes()
    mark = re.search(rb'<AppendedData encoding="raw">\s*_', content)
    if mark is None:
        raise ValueError(f"{path}: no appended raw data; only .vtp files of perimpact are read here")
    head = xml.fromstring(content[: mark.start()] + b"</VTKFile>")
    order = "<" if head.get("byte_order") == "LittleEndian" else ">"
    compressed = head.get("compressor") is not None

    def sizes(at, count):
        return struct.unpack_from(f"{order}{count}Q", content, at)

    def array(element):
        at = mark.end() + int(element.get("offset"))
        if compressed:
            blocks = sizes(at, 1)[0]
            lengths = sizes(at + 24, blocks)
            at += 24 + 8 * blocks
            parts = []
            for length in lengths:
                parts.append(zlib.decompress(content[at : at + length]))
                at += length
            data = b"".join(parts)
        else:
            data = content[at + 8 : at + 8 + sizes(at, 1)[0]]
        values = np.frombuffer(data, order + NUMPY_TYPE[element.get("type")])
        components = int(element.get("NumberOfComponents", 1))
        return values if components == 1 else values.reshape(-1, components)

    def arrays(section):
        return Named(((element.get("Name"), array(element)) for element in head.findall(f".//{section}/DataArray")), path)

    picture = Picture(points=next(iter(arrays("Points").values())), point=arrays("PointData"), cell=arrays("CellData"))
    polygons = arrays("Polys")
    if polygons:
        picture.panels = np.split(polygons["connectivity"], polygons["offsets"][:-1])
    time = head.find(".//FieldData/DataArray[@Name='TimeValue']")
    if time is not None:
        picture.time = float(time.text)
    return picture


def series(folder, name):
    """(time [s], file) of each picture of a body or impactor, in the results folder of a run."""
    frames = Path(folder) / "frames"
    if (frames / f"{name}.vtkhdf").exists():
        refuse(f"{frames}/{name}.vtkhdf: only .vtp frames are read here; run the deck with --set output.frame_format=vtp.")
    if not (frames / f"{name}.pvd").exists():
        refuse(f"{folder} has no frames of {name}; run the deck with output.frames above 0.")
    entries = xml.parse(frames / f"{name}.pvd").getroot().iter("DataSet")
    return [(float(entry.get("timestep")), Path(folder) / "frames" / entry.get("file")) for entry in entries]


def pictures(folder, name):
    """The pictures of a body or impactor in order, each as (time [s], Picture)."""
    return ((time, read_vtp(file)) for time, file in series(folder, name))


def picture_at(folder, name, time):
    """(time [s], Picture) nearest to that time."""
    nearest, file = min(series(folder, name), key=lambda entry: abs(entry[0] - time))
    return nearest, read_vtp(file)
