"""Reads the files of vtp_examples.cpp and compares every value with the formulas it was written from.

    check_vtp.py PROGRAM vtk    with VTK's own reader (exit code 77, skipped, where VTK is not installed)
    check_vtp.py PROGRAM ours   with scripts/results/vtp_reader.py
"""

import subprocess
import sys
import tempfile
import xml.etree.ElementTree as xml
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[3] / "scripts/results"))
try:
    import numpy as np
    from vtp_reader import Picture, read_vtp

    if sys.argv[2] == "vtk":
        from vtkmodules.util.numpy_support import vtk_to_numpy
        from vtkmodules.vtkCommonCore import vtkCommand
        from vtkmodules.vtkCommonDataModel import vtkDataObject
        from vtkmodules.vtkFiltersCore import vtkThreshold
        from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(77)


def vtk_output(path):
    complaints = []
    reader = vtkXMLPolyDataReader()
    for event in (vtkCommand.ErrorEvent, vtkCommand.WarningEvent):
        reader.AddObserver(event, lambda *_: complaints.append(path))
    reader.SetFileName(str(path))
    reader.Update()
    assert not complaints, f"VTK complains about {path}"
    return reader.GetOutput()


def read_with_vtk(path):
    data = vtk_output(path)

    def arrays(attributes):
        return {attributes.GetArrayName(i): vtk_to_numpy(attributes.GetArray(i)) for i in range(attributes.GetNumberOfArrays())}

    points = vtk_to_numpy(data.GetPoints().GetData()) if data.GetNumberOfPoints() else np.zeros((0, 3))
    picture = Picture(points, arrays(data.GetPointData()), arrays(data.GetCellData()))
    cells = [[data.GetCell(c).GetPointId(p) for p in range(data.GetCell(c).GetNumberOfPoints())] for c in range(data.GetNumberOfPolys())]
    picture.panels = cells
    if data.GetNumberOfPoints() and not cells:
        assert data.GetNumberOfVerts() == data.GetNumberOfPoints()
        assert all(data.GetCell(c).GetPointId(0) == c for c in range(0, data.GetNumberOfVerts(), 997))
    time = data.GetFieldData().GetArray("TimeValue")
    if time is not None:
        picture.time = time.GetValue(0)
    return picture


def expect_equal(got, wanted, what):
    got, wanted = np.asarray(got), np.asarray(wanted)
    assert got.dtype == wanted.dtype and got.shape == wanted.shape and (got == wanted).all(), f"{what}: {got} instead of {wanted}"


def check_particles(picture, count):
    i, axis = np.meshgrid(np.arange(count), np.arange(3), indexing="ij")
    assert picture.time == 1 / 3
    if count == 0:
        assert len(picture.points) == 0
        return
    expect_equal(picture.points, (i * (axis + 1) / 1024).astype("f4"), "points")
    expect_equal(picture.point["displacement"], ((i + axis) / 4096).astype("f4"), "displacement")
    expect_equal(picture.point["energy"], np.arange(count) / 3, "energy")
    expect_equal(picture.point['a <b> & "c"'], (5 - np.arange(count)).astype("i4"), "number")
    expect_equal(picture.cell["even"], (np.arange(count) % 2 == 0).astype("u1"), "even")


def check_surface(picture):
    expect_equal(picture.points, [[0.0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [2, 0.5, 1 / 3]], "vertices")
    assert [list(panel) for panel in picture.panels] == [[0, 1, 2, 3], [1, 4, 2]]
    expect_equal(picture.cell["pressure"], [2.5e6, -1], "pressure")


def check_region(picture):
    assert len(picture.panels) == 12 and all(len(panel) == 4 for panel in picture.panels)
    expect_equal(picture.points.min(axis=0), [-1.0, -2, -3], "low corner")
    expect_equal(picture.points.max(axis=0), [5.0, 2, 3], "high corner")


def check_series(folder, read):
    """The list is well-formed, and every listed file can be read."""
    frames = xml.parse(folder / "series.pvd").findall("./Collection/DataSet")
    assert [float(frame.get("timestep")) for frame in frames] == [0, 1e-6]
    for frame in frames:
        check_particles(read(folder / frame.get("file")), 10)


def check_threshold(path):
    """Each particle is a separate cell: a threshold keeps exactly the selected ones."""
    threshold = vtkThreshold()
    threshold.SetInputData(vtk_output(path))
    threshold.SetInputArrayToProcess(0, 0, 0, vtkDataObject.FIELD_ASSOCIATION_POINTS, "energy")
    threshold.SetThresholdFunction(vtkThreshold.THRESHOLD_UPPER)
    threshold.SetUpperThreshold(33000 - 0.5)
    threshold.Update()
    kept = vtk_to_numpy(threshold.GetOutput().GetPointData().GetArray("energy"))
    expect_equal(kept, np.arange(98999, 100000) / 3, "kept by the threshold")


def main():
    program, reader = sys.argv[1:]
    read = read_with_vtk if reader == "vtk" else read_vtp
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        subprocess.run([program, name], check=True)
        for kind in ("plain", "zlib"):
            check_particles(read(folder / f"particles_{kind}.vtp"), 100_000)
            check_particles(read(folder / f"empty_{kind}.vtp"), 0)
            check_surface(read(folder / f"surface_{kind}.vtp"))
        check_region(read(folder / "region.vtp"))
        check_series(folder, read)
        if reader == "vtk":
            check_threshold(folder / "particles_zlib.vtp")


main()
