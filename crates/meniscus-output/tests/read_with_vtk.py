"""Reads frames with VTK itself, the library inside ParaView, as a check from outside.

    python3 -m venv /tmp/vtk && /tmp/vtk/bin/pip install vtk
    /tmp/vtk/bin/python crates/meniscus-output/tests/read_with_vtk.py out/CASE/frames/frames.pvd

Prints, for every frame of the collection, its time, points, extent and the
range of each field; ends with an error where VTK and the collection disagree.
"""

import os
import sys
import xml.etree.ElementTree as xml

import vtk
from vtk.util.numpy_support import vtk_to_numpy

path = sys.argv[1]
frames = xml.parse(path).getroot().findall("./Collection/DataSet")
print(f"{path}: {len(frames)} frames, VTK {vtk.vtkVersion().GetVTKVersion()}")
for entry in frames:
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(os.path.join(os.path.dirname(path), entry.get("file")))
    reader.Update()
    assert reader.GetErrorCode() == 0, reader.GetErrorCode()
    grid = reader.GetOutput()
    points = grid.GetNumberOfPoints()
    assert grid.GetNumberOfCells() == points
    assert all(grid.GetCellType(i) == vtk.VTK_VERTEX for i in range(points))
    time = float(entry.get("timestep"))
    field = grid.GetFieldData()
    assert field.GetArray("TimeValue").GetValue(0) == time
    step = field.GetArray("step").GetValue(0)
    dimension = field.GetArray("dimension").GetValue(0)
    print(f"t = {time} s, step {step}, {dimension}D: {points} points in {grid.GetBounds()}")
    data = grid.GetPointData()
    for i in range(data.GetNumberOfArrays()):
        array = data.GetArray(i)
        assert array.GetNumberOfTuples() == points
        values = vtk_to_numpy(array)
        low, high = (values.min(), values.max()) if points else ("-", "-")
        kind = "vector" if array.GetNumberOfComponents() == 3 else "scalar"
        print(f"  {array.GetName()} ({kind}): {low} to {high}")
