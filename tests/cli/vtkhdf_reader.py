"""Readers of .vtkhdf series, independent of the program: h5py by the offsets of the format, and VTK's own vtkHDFReader from 9.3 on.

Each gives the number of steps, and a step as (time, Picture) like vtp_reader.
"""

import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).parents[2] / "scripts/results"))
from vtp_reader import Picture  # noqa: E402

KINDS = "Vertices", "Lines", "Polygons", "Strips"


class ByOffsets:
    """https://docs.vtk.org/en/latest/vtk_file_formats/vtkhdf_file_format/vtkhdf_specifications.html, word for word."""

    def __init__(self, path):
        import h5py

        self.root = h5py.File(path, "r")["VTKHDF"]
        assert self.root.attrs["Type"] == b"PolyData" and list(self.root.attrs["Version"]) == [2, 0]
        self.steps = int(self.root["Steps"].attrs["NSteps"])
        for name in "Values", "PartOffsets", "NumberOfParts", "PointOffsets", "CellOffsets", "ConnectivityIdOffsets":
            assert len(self.root["Steps"][name]) >= self.steps, name
        assert len(self.root["Steps/Values"]) == self.steps  # VTK copies all of them into an array of NSteps

    def step(self, number):
        steps, picture = self.root["Steps"], Picture(None)
        first_part, parts = int(steps["PartOffsets"][number]), int(steps["NumberOfParts"][number])
        assert parts == 1
        points = int(self.root["NumberOfPoints"][first_part])
        at = int(steps["PointOffsets"][number])
        picture.points = self.root["Points"][at : at + points]
        cells = 0
        for column, kind in enumerate(KINDS):
            group = self.root[kind]
            count, ids = int(group["NumberOfCells"][first_part]), int(group["NumberOfConnectivityIds"][first_part])
            cell, corner = int(steps["CellOffsets"][number][column]), int(steps["ConnectivityIdOffsets"][number][column])
            cell += first_part  # CellOffsets count cells, and every part before has one offset more than cells: as vtkHDFReader.cxx reads them
            ends = group["Offsets"][cell : cell + count + 1]
            corners = group["Connectivity"][corner : corner + ids]
            assert len(ends) == count + 1 and len(corners) == ids and ends[-1] == ids
            cells += count
            if kind == "Polygons" and count:
                picture.panels = np.split(corners, ends[1:-1])
            elif kind == "Vertices" and count:
                assert (ends == np.arange(points + 1)).all() and (corners == np.arange(points)).all()
            else:
                assert count == 0
        for of, count, arrays in ("Point", points, picture.point), ("Cell", cells, picture.cell):
            for name, array in self.root.get(f"{of}Data", {}).items():
                at = int(steps[f"{of}DataOffsets"][name][number])
                arrays[name] = array[at : at + count]
                assert len(arrays[name]) == count, name
        picture.time = float(steps["Values"][number])
        return picture


class WithVtk:
    def __init__(self, path):
        from vtkmodules.vtkCommonCore import vtkCommand
        from vtkmodules.vtkIOHDF import vtkHDFReader

        self.reader, self.complaints = vtkHDFReader(), []
        for event in (vtkCommand.ErrorEvent, vtkCommand.WarningEvent):
            self.reader.AddObserver(event, lambda *_: self.complaints.append(path))
        assert self.reader.CanReadFile(str(path))
        self.reader.SetFileName(str(path))
        self.reader.UpdateInformation()
        self.steps = self.reader.GetNumberOfSteps()

    def step(self, number):
        from vtkmodules.util.numpy_support import vtk_to_numpy

        self.reader.SetStep(number)
        self.reader.Modified()
        self.reader.Update()
        data = self.reader.GetOutputDataObject(0)
        assert not self.complaints

        def arrays(attributes):
            return {attributes.GetArrayName(i): vtk_to_numpy(attributes.GetArray(i)) for i in range(attributes.GetNumberOfArrays())}

        picture = Picture(vtk_to_numpy(data.GetPoints().GetData()), arrays(data.GetPointData()), arrays(data.GetCellData()))
        if data.GetNumberOfPolys():
            ends = vtk_to_numpy(data.GetPolys().GetOffsetsArray())
            picture.panels = np.split(vtk_to_numpy(data.GetPolys().GetConnectivityArray()), ends[1:-1])
        else:
            assert data.GetNumberOfVerts() == data.GetNumberOfPoints()
            assert (vtk_to_numpy(data.GetVerts().GetConnectivityArray()) == np.arange(data.GetNumberOfPoints())).all()
        picture.time = self.reader.GetTimeValue()
        return picture


def expect_same(found, wanted):
    """Every number of two pictures, bit by bit, and the type of each array."""
    assert found.time == wanted.time, (found.time, wanted.time)
    assert found.points.dtype == wanted.points.dtype and found.points.tobytes() == wanted.points.tobytes()
    for a, b in (found.point, wanted.point), (found.cell, wanted.cell):
        assert set(a) == set(b), (set(a), set(b))
        for name in b:
            assert a[name].dtype == b[name].dtype and a[name].shape == b[name].shape and a[name].tobytes() == b[name].tobytes(), name
    assert len(found.panels) == len(wanted.panels) and all((a == b).all() for a, b in zip(found.panels, wanted.panels))
