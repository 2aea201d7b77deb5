"""A second, plain reader of STL, OBJ and old VTK text files, packed or not, with numpy: what the program says of a file is compared with this."""

import gzip
import re
from typing import NamedTuple

import numpy as np


class Surface(NamedTuple):
    corners: np.ndarray  # (n, 3, 3) [m] the corners of triangles; polygons are fans of them
    panels: int  # as many as the file has, polygons counted once


def contents_of(path):
    content = path.read_bytes()
    return gzip.decompress(content) if path.suffix == ".gz" else content


def kind_of(path):
    return path.name.removesuffix(".gz").rsplit(".", 1)[-1].lower()


def read(path):
    """None where the file is none of these."""
    read_kind = {"stl": stl, "obj": obj, "vtk": vtk}.get(kind_of(path))
    return read_kind(contents_of(path)) if read_kind else None


def stl(content):
    count = int.from_bytes(content[80:84], "little")
    if len(content) == 84 + 50 * count:
        facets = np.frombuffer(content, np.dtype([("numbers", "<f4", 12), ("attribute", "<u2")]), count, 84)
        return Surface(facets["numbers"].reshape(-1, 4, 3)[:, 1:].astype(float), count)
    vertices = np.array(re.findall(rb"^\s*vertex\s+(\S+)\s+(\S+)\s+(\S+)", content, re.MULTILINE | re.IGNORECASE), float)
    return Surface(vertices.reshape(-1, 3, 3), len(vertices) // 3)


def obj(content):
    rows = [line.split() for line in content.splitlines()]
    vertices = np.array([row[1:4] for row in rows if row[:1] == [b"v"]], float).reshape(-1, 3)
    faces = [[int(word.split(b"/")[0]) for word in row[1:]] for row in rows if row[:1] == [b"f"]]
    return fans(vertices, [[number - 1 for number in face] for face in faces])


def vtk(content):
    words = content.split()
    points = words.index(b"POINTS")
    vertices = np.array(words[points + 3 : points + 3 + 3 * int(words[points + 1])], float).reshape(-1, 3)
    faces = []
    if b"POLYGONS" in words:
        polygons = words.index(b"POLYGONS")
        at = polygons + 3
        for _ in range(int(words[polygons + 1])):
            count = int(words[at])
            faces.append([int(word) for word in words[at + 1 : at + 1 + count]])
            at += 1 + count
    return fans(vertices, faces)


def fans(vertices, faces):
    triangles = [(face[0], face[k], face[k + 1]) for face in faces for k in range(1, len(face) - 1)]
    return Surface(vertices[np.array(triangles, int).reshape(-1, 3)], len(faces))
