#!/usr/bin/python3
"""Projects a table and two signals on a tissue, and compares all outputs with what NumPy makes of the same images."""
import csv
import math
import pathlib
import subprocess
import sys

import networkx
import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy


def read_image(path):
    reader = vtk.vtkMetaImageReader()
    reader.SetFileName(str(path))
    reader.Update()
    image = reader.GetOutput()
    values = vtk_to_numpy(image.GetPointData().GetScalars())
    return values.reshape(image.GetDimensions()[::-1]), np.array(image.GetSpacing())


def write_image(path, values, spacing, origin):
    image = vtk.vtkImageData()
    image.SetDimensions(values.shape[::-1])
    image.SetSpacing(spacing)
    image.SetOrigin(origin)
    image.GetPointData().SetScalars(numpy_to_vtk(values.ravel()))
    writer = vtk.vtkMetaImageWriter()
    writer.SetInputData(image)
    writer.SetFileName(str(path))
    writer.SetCompression(False)
    writer.Write()


def rows_of(path):
    with open(path, newline="") as stream:
        return list(csv.DictReader(stream))


def read_vtk(reader, path):
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput().GetCellData()


def require(what, found, expected, tolerance=1e-5):
    found, expected = np.asarray(found, dtype=float), np.asarray(expected, dtype=float)
    if not np.allclose(found, expected, rtol=tolerance, atol=1e-12, equal_nan=True):
        sys.exit(f"{what}: {found[:5]} ..., NumPy has {expected[:5]} ...")


program, folder = sys.argv[1], pathlib.Path(sys.argv[2])
labels, spacing = read_image(folder / "tissue.mha")
cells = [int(label) for label in np.unique(labels) if label != 0]
z, y, x = np.indices(labels.shape)
same = (100 + 3.0 * x - y + 0.25 * z * z).astype(np.float32)
write_image(folder / "same.mha", same, spacing, (0, 0, 0))
# Twice as fine, a linear field in 16 bits, of the lower half of the tissue alone.
half = tuple(2 * n for n in (labels.shape[0] // 2, *labels.shape[1:]))
fine = np.indices(half)[2].astype(np.uint16)
write_image(folder / "fine.mha", fine, spacing / 2, -spacing / 4)
with open(folder / "growth.csv", "w") as table:
    print("cell_id;rate;fate", *(f"{c};{c * 0.5};{'ab'[c % 2]}".replace(".", ",") for c in cells[1:]), sep="\n", file=table)

command = f"""tissue.mha walls.vtp --cellData growth.csv --signal same.mha --signal F=fine.mha --refinement 0 --quiet
  --statistics cells.csv --walls walls.csv --graph graph.graphml --cells cells.vtu --cellSurfaces surfaces.vtp"""
subprocess.run([program, *command.split()], cwd=folder, check=True, stderr=subprocess.DEVNULL)

table = rows_of(folder / "cells.csv")
if [int(row["Label"]) for row in table] != cells:
    sys.exit("the cells of the table are not those of the image")
column = {name: np.array([float(row[name]) if row[name] else math.nan for row in table])
          for name in table[0] if name != "fate"}
voxel = spacing.prod()
require("sameMean", column["sameMean"], [same[labels == c].mean(dtype=float) for c in cells])
require("sameIntegral", column["sameIntegral"], [same[labels == c].sum(dtype=float) * voxel for c in cells])
nearest = labels[: half[0] // 2].repeat(2, 0).repeat(2, 1).repeat(2, 2)
known = np.isin(cells, nearest)
require("FMean", column["FMean"][known], [fine[nearest == c].mean() for c in np.array(cells)[known]])
require("FIntegral", column["FIntegral"][known],
        [fine[nearest == c].sum(dtype=float) * voxel / 8 for c in np.array(cells)[known]])
require("FMean outside", column["FMean"][~known], math.nan * np.ones((~known).sum()))
require("rate", column["rate"], [math.nan, *(c * 0.5 for c in cells[1:])])
if [row["fate"] for row in table] != ["", *("ab"[c % 2] for c in cells[1:])]:
    sys.exit("fate is not that of the table")

rate = dict(zip(cells, column["rate"]))
walls = rows_of(folder / "walls.csv")
for side in "01":
    require(f"rate{side}", [float(row[f"rate{side}"] or "nan") for row in walls],
            [rate.get(int(row[f"Label{side}"]), math.nan) for row in walls])
triangles = read_vtk(vtk.vtkXMLPolyDataReader(), folder / "walls.vtp")
of_wall = vtk_to_numpy(triangles.GetArray("WallId"))
for name in ("sameMean", "sameMean0", "FNearWalls1"):
    require(f"{name} of walls.vtp", vtk_to_numpy(triangles.GetArray(name)),
            np.array([float(row[name] or "nan") for row in walls])[of_wall], 1e-12)
# Of a flat wall the mean of a field that is nearly linear is that at its centre.
flat = [row for row in walls if float(row["Planarity"]) > 0.999 and row["sameMean"]]
at_center = [np.array([float(row[f"Center{axis}"]) for axis in "XYZ"]) / spacing for row in flat]
require("sameMean of walls", [float(row["sameMean"]) for row in flat],
        [100 + 3 * p[0] - p[1] + 0.25 * p[2] ** 2 for p in at_center], 0.02)

graph = networkx.read_graphml(folder / "graph.graphml", node_type=int)
require("sameMean of nodes", [graph.nodes[c]["sameMean"] for c in cells], column["sameMean"], 1e-12)
if "rate" in graph.nodes[cells[0]] or graph.nodes[cells[1]]["fate"] != "ab"[cells[1] % 2]:
    sys.exit("the nodes have not the values of the table")
for a, b, edge in graph.edges(data=True):
    both = [row for row in walls if {int(row["Label0"]), int(row["Label1"])} == {a, b}]
    area = [float(row["Area"]) for row in both]
    require(f"sameMean of edge {a} {b}", edge["sameMean"],
            np.average([float(row["sameMean"]) for row in both], weights=area))

for reader, name in ((vtk.vtkXMLUnstructuredGridReader(), "cells.vtu"), (vtk.vtkXMLPolyDataReader(), "surfaces.vtp")):
    arrays = read_vtk(reader, folder / name)
    index = np.searchsorted(cells, vtk_to_numpy(arrays.GetArray("Label")))
    for values in ("rate", "sameNearWalls", "FIntegral"):
        require(f"{values} of {name}", vtk_to_numpy(arrays.GetArray(values)), column[values][index], 1e-12)
