"""Readers of a report and of output frames, independent of the program: by docs/guide/report.md and by the formats of VTK."""

import base64
import gzip
import json
import re
import struct
import xml.etree.ElementTree as xml
import zlib


def read_pictures(path):
    """The arrays of a .vtp by name: rows of numbers; `points`, and `panels` as lists of corners."""
    content = path.read_bytes()
    head, data = content.split(b"<AppendedData", 1)
    tree = xml.fromstring(head + b"</VTKFile>")
    data = data[data.index(b"_") + 1 :]
    arrays = {}
    for array in tree.iter("DataArray"):
        if array.get("format") != "appended":
            continue
        at = int(array.get("offset"))
        blocks = struct.unpack_from("<Q", data, at)[0]
        sizes = struct.unpack_from(f"<{blocks}Q", data, at + 24)
        at += 24 + 8 * blocks
        raw = b""
        for size in sizes:
            raw += zlib.decompress(data[at : at + size])
            at += size
        letter = {"Float32": "f", "Float64": "d", "Int32": "i"}[array.get("type")]
        numbers = struct.unpack(f"<{len(raw) // struct.calcsize(letter)}{letter}", raw)
        width = int(array.get("NumberOfComponents"))
        arrays[array.get("Name")] = [numbers[k : k + width] for k in range(0, len(numbers), width)]
    if int(tree.find(".//Piece").get("NumberOfPolys")) > 0:
        begin, arrays["panels"] = 0, []
        for (end,) in arrays["offsets"]:
            arrays["panels"].append([corner for (corner,) in arrays["connectivity"][begin:end]])
            begin = end
    return arrays


class Unpacker:
    """One array in successive frames."""

    def __init__(self, width):
        self.width, self.pictures = width, []

    def next(self, content, at, count):
        prediction, bits = content[at], 8 * self.width
        planes = [content[at + 1 + plane * count : at + 1 + (plane + 1) * count] for plane in range(self.width)]
        assert len(planes[-1]) == count, "a blob is too short"
        zero = [0] * count
        before = self.pictures[-1] if prediction % 3 else zero
        before_that = self.pictures[-2] if prediction % 3 == 2 else before if prediction % 3 else zero
        numbers, off = [], 0
        for i in range(count):
            folded = sum(planes[plane][i] << (8 * plane) for plane in range(self.width))
            left = -(folded + 1) // 2 if folded % 2 else folded // 2
            off = left + off if prediction >= 3 else left
            numbers.append((2 * before[i] - before_that[i] + off) % (1 << bits))
        self.pictures.append(numbers)
        return numbers, at + 1 + self.width * count


class ReportFile:
    def __init__(self, path):
        self.text = path.read_text(encoding="utf-8")
        self.scripts = dict(re.findall(r'<script type="(?:application/json|text/plain)" id="([^"]*)">(.*?)</script>', self.text, re.DOTALL))
        self.description = json.loads(self.scripts["description"])
        self.run = json.loads(self.scripts["run"]) if "run" in self.scripts else None
        self.notes, self.times = self.description["notes"], self.description["times [s]"]

    def blob(self, name):
        return gzip.decompress(base64.b64decode(self.scripts[name], validate=True))

    @staticmethod
    def _several(content, widths, count, unpackers=None):
        """`count`: numbers of every array, or of each."""
        at, out = 0, []
        for k, width in enumerate(widths):
            numbers, at = (unpackers[k] if unpackers else Unpacker(width)).next(content, at, count if isinstance(count, int) else count[k])
            out.append(numbers)
        assert at == len(content), "a blob is too long"
        return out

    def curves(self):
        columns, rows = self.description["history"]["columns"], self.description["history"]["rows"]
        words = self._several(self.blob("history"), [4] * len(columns), rows)
        return {column["name"]: [struct.unpack("<f", struct.pack("<I", word))[0] for word in each] for column, each in zip(columns, words)}

    @staticmethod
    def _real(array, numbers):
        return [array["low"] + array["step"] * number for number in numbers]

    def body(self, name):
        """(description, undeformed positions by axis, a dictionary of arrays for each frame)"""
        body = next(each for each in self.description["bodies"] if each["name"] == name)
        count, arrays = body["shown"], body["arrays"]
        places = self._several(self.blob(body["id"]), [array["bytes"] for array in body["undeformed"]], count)
        unpackers = [Unpacker(array["bytes"]) for array in arrays]
        pictures = []
        for number in body["pictures"]:
            numbers = self._several(self.blob(f'{body["id"]}_{number}'), [array["bytes"] for array in arrays], count, unpackers)
            pictures.append({array["name"]: self._real(array, each) for array, each in zip(arrays, numbers)})
        return body, [self._real(array, each) for array, each in zip(body["undeformed"], places)], pictures

    def impactor(self, name):
        """(description, undeformed vertices of the first frame, panels, a dictionary of arrays for each frame; those of the deformation are x, y and z)"""
        impactor = next(each for each in self.description["impactors"] if each["name"] == name)
        content, at, columns = self.blob(impactor["id"]), 0, []
        for count in [impactor["vertices"]] * 3 + [impactor["panels"]] * 4:
            numbers, at = Unpacker(4).next(content, at, count)
            columns.append(numbers)
        vertices = [struct.unpack("<3f", struct.pack("<3I", *words)) for words in zip(*columns[:3])]
        panels = [[corner for corner in corners if corner != 0xFFFFFFFF] for corners in zip(*columns[3:])]
        arrays, pictures = impactor["arrays"] + impactor["deformation"], []
        counts = [impactor["panels"]] * len(impactor["arrays"]) + [impactor["vertices"]] * len(impactor["deformation"])
        unpackers = [Unpacker(array["bytes"]) for array in arrays]
        for number in impactor["pictures"] if arrays else []:
            numbers = self._several(self.blob(f'{impactor["id"]}_{number}'), [array["bytes"] for array in arrays], counts, unpackers)
            pictures.append({array["name"]: self._real(array, each) for array, each in zip(arrays, numbers)})
        return impactor, vertices, panels, pictures
