#!/usr/bin/env python3
"""Reads with VTK what `plumb export` wrote, and prints what VTK sees of it.

    vtk_states.py FILE.vtkhdf | FILE.pvd

A line a state: the time, then the coordinates of its points; of a file for which this VTK is too old (below 9.3) that
is the first state alone. Ends with 77 where there is no VTK.
"""

import pathlib
import sys
import xml.etree.ElementTree

try:
    import vtk
except ImportError:
    print("there is no VTK for this Python (Debian's python3-vtk9)")
    sys.exit(77)


def show(time, data):
    points = [number for k in range(data.GetNumberOfPoints()) for number in data.GetPoint(k)]
    print(*(repr(float(number)) for number in [time, *points]))


def main():
    path = pathlib.Path(sys.argv[1])
    if path.suffix == ".vtkhdf":
        reader = vtk.vtkHDFReader()
        reader.SetFileName(str(path))
        if not reader.CanReadFile(str(path)):
            sys.exit("VTK does not take it for one of its files")
        vtk.vtkObject.GlobalWarningDisplayOff()
        reader.UpdateInformation()
        key = vtk.vtkStreamingDemandDrivenPipeline.TIME_STEPS()
        information = reader.GetOutputInformation(0)
        if not information.Has(key):
            reader.Update()
            show(0, reader.GetOutput())
        else:
            for k in range(information.Length(key)):
                time = information.Get(key, k)
                reader.UpdateTimeStep(time)
                show(time, reader.GetOutput())
        return
    for piece in xml.etree.ElementTree.parse(path).getroot()[0]:
        reader = vtk.vtkXMLPolyDataReader()
        reader.SetFileName(str(path.parent / piece.get("file")))
        reader.Update()
        data = reader.GetOutput()
        names = [data.GetPointData().GetArrayName(k) for k in range(data.GetPointData().GetNumberOfArrays())]
        units = [data.GetPointData().GetArray(name).GetInformation().Get(vtk.vtkDataArray.UNITS_LABEL()) for name in names]
        print("fields", *(f"{name} [{unit}]" for name, unit in zip(names, units)), file=sys.stderr)
        if data.GetFieldData().GetArray("TimeValue").GetValue(0) != float(piece.get("timestep")):
            sys.exit(f"{piece.get('file')} is of another time than {path.name} says")
        show(float(piece.get("timestep")), data)


if __name__ == "__main__":
    main()
