#!/usr/bin/python3
"""Reads the grids of a folder by meshio: each polyhedron has as many faces as the table of the cells says of its label."""
import csv
import pathlib
import sys

import meshio

folder = pathlib.Path(sys.argv[1])
with open(folder / "cells.csv", newline="") as stream:
    faces = {int(row["Label"]): int(row["NumberOfTriangles"]) for row in csv.DictReader(stream)}
grid = meshio.read(folder / "cells.vtu")
read = {
    int(label): len(cell)
    for block, labels in zip(grid.cells, grid.cell_data["Label"])
    for cell, label in zip(block.data, labels)
}
if read != faces:
    sys.exit("the cells' faces by meshio are not those of the table")
kinds = {block.type for block in meshio.read(folder / "complex.vtu").cells}
if "tetra" not in kinds:
    sys.exit(f"the complex has {kinds} by meshio, no tetrahedra")
