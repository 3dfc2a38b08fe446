#!/usr/bin/python3
"""Computes on a mesh of cell walls with what Debian has for it: a check of meshes, and an example to start from.

    TissueTessellation labels.mha FOLDER/walls.vtp --simulation FOLDER/tissue.geo --simulation FOLDER/tissue.smesh
        --statistics FOLDER/cells.csv
    compute_on_walls.py FOLDER [--only gmsh tetgen calculix] [--thickness T] [--pressure P]

- Gmsh meshes each cell with tetrahedra, its walls kept (`cells.msh`: physical volumes are the cells' labels).
- TetGen does the same without a point more on any wall (`tissue.1.ele`: the region of each tetrahedron).
- CalculiX computes the walls as elastic shells (S3) under the cells' turgor, the pressure difference at each wall
  (`walls.frd`, `walls.dat`). Lengths are those of the mesh; pressures, and Young's modulus, in units of their own.

FOLDER gets all files, and `report.json`: cells meshed, cells whose volume is another one then, tetrahedra, those with a
dihedral angle below 5 degrees, whether the computation came to its end. The exit code is 1 where one of the programs
fails, or leaves a cell out.

Needs python3-meshio and python3-vtk9; gmsh, tetgen, calculix-ccx for the parts.
"""

import argparse
import csv
import json
import pathlib
import shutil
import subprocess
import sys
import time

import meshio
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

PROGRAMS = {"gmsh": "gmsh", "tetgen": "tetgen", "calculix": "ccx"}


class Walls:
    """Points, triangles, and of each triangle the two labels: its normal points from the first to the second. And the
    volume of each cell, by its label."""

    def __init__(self, folder):
        reader = vtkXMLPolyDataReader()
        reader.SetFileName(str(folder / "walls.vtp"))
        reader.Update()
        mesh = reader.GetOutput()
        if mesh.GetNumberOfCells() == 0:
            sys.exit(f"{folder / 'walls.vtp'}: no triangles")
        self.points = vtk_to_numpy(mesh.GetPoints().GetData()).astype(float)
        self.triangles = vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)
        self.labels = vtk_to_numpy(mesh.GetCellData().GetArray("BoundaryLabels")).astype(np.int64)
        with open(folder / "cells.csv", newline="") as stream:
            self.volumes = {int(row["Label"]): float(row["Volume"]) for row in csv.DictReader(stream)}


def worst_angles(points, tetrahedra):
    """The least dihedral angle of each tetrahedron, in degrees."""
    p = points[tetrahedra]
    # Of the face opposite to each corner the normal; the angle at an edge is that between two faces.
    normals = []
    for i in range(4):
        a, b, c = (p[:, j] for j in range(4) if j != i)
        n = np.cross(b - a, c - a)
        n *= np.sign(np.einsum("ij,ij->i", n, p[:, i] - a))[:, None]
        normals.append(n / np.linalg.norm(n, axis=1)[:, None])
    cosines = [-np.einsum("ij,ij->i", normals[i], normals[j]) for i in range(4) for j in range(i)]
    return np.degrees(np.arccos(np.clip(np.max(cosines, 0), -1, 1)))


def volumes_of(points, tetrahedra):
    a, b, c, d = (points[tetrahedra[:, i]] for i in range(4))
    return np.abs(np.einsum("ij,ij->i", b - a, np.cross(c - a, d - a))) / 6


def summarize(walls, points, tetrahedra, labels):
    volumes = volumes_of(points, tetrahedra)
    angles = worst_angles(points, tetrahedra)
    wanted = walls.volumes
    meshed = {label: volumes[labels == label].sum() for label in np.unique(labels)}
    off = {int(c) for c in wanted if not np.isclose(meshed.get(c, 0.0), wanted[c], rtol=1e-9)}
    return {
        "cells": len(wanted),
        "cellsMeshed": len(set(meshed) & set(wanted)),
        "cellsOfOtherVolume": sorted(off | (set(map(int, meshed)) - set(wanted))),
        "tetrahedra": len(tetrahedra),
        "leastAngle": float(angles.min()),
        "tetrahedraBelow5Degrees": int((angles < 5).sum()),
        "cellsWithThem": len(np.unique(labels[angles < 5])),
    }


def run(command, folder, log):
    start = time.monotonic()
    with open(folder / log, "w") as stream:
        code = subprocess.run(command, cwd=folder, stdout=stream, stderr=subprocess.STDOUT).returncode
    return code, round(time.monotonic() - start, 1)


def mesh_with_gmsh(walls, folder):
    command = ["gmsh", "-3", "tissue.geo", "-o", "cells.msh", "-format", "msh22"]
    code, seconds = run(command, folder, "gmsh.log")
    if code != 0 or not (folder / "cells.msh").exists():
        return {"failed": "see gmsh.log", "seconds": seconds}
    mesh = meshio.read(folder / "cells.msh")
    blocks = [i for i, block in enumerate(mesh.cells) if block.type == "tetra"]
    if not blocks:
        return {"failed": "no tetrahedra, see gmsh.log", "seconds": seconds}
    tetrahedra = np.concatenate([mesh.cells[i].data for i in blocks])
    regions = np.concatenate([mesh.cell_data["gmsh:physical"][i] for i in blocks])
    return {**summarize(walls, mesh.points, tetrahedra, regions), "seconds": seconds}


def mesh_with_tetgen(walls, folder):
    code, seconds = run(["tetgen", "-pqAYQ", "tissue.smesh"], folder, "tetgen.log")
    if code != 0 or not (folder / "tissue.1.ele").exists():
        return {"failed": "see tetgen.log", "seconds": seconds}
    points = np.loadtxt(folder / "tissue.1.node", skiprows=1, usecols=(1, 2, 3))
    elements = np.loadtxt(folder / "tissue.1.ele", skiprows=1, dtype=np.int64)
    return {**summarize(walls, points, elements[:, 1:5], elements[:, 5]), "seconds": seconds}


def compute_with_calculix(walls, folder, thickness, pressure):
    """Shells of one material, the turgor a fifth more or less from cell to cell; the lowest points are held."""
    cells = sorted(walls.volumes)
    turgor = dict(zip(cells, pressure * (1 + 0.2 * np.sin(np.arange(len(cells))))))
    height = walls.points[:, 2]
    held = np.nonzero(height <= height.min() + 0.1 * np.ptp(height))[0]
    with open(folder / "walls.inp", "w") as file:
        file.write("*NODE, NSET=ALL\n")
        for i, p in enumerate(walls.points):
            file.write("%d, %.9g, %.9g, %.9g\n" % (i + 1, *p))
        file.write("*ELEMENT, TYPE=S3, ELSET=WALLS\n")
        for i, t in enumerate(walls.triangles):
            file.write("%d, %d, %d, %d\n" % (i + 1, *(t + 1)))
        file.write("*MATERIAL, NAME=WALL\n*ELASTIC\n100., 0.3\n")
        file.write("*SHELL SECTION, ELSET=WALLS, MATERIAL=WALL\n%g\n" % thickness)
        file.write("*BOUNDARY\n" + "".join("%d, 1, 3\n" % (i + 1) for i in held))
        file.write("*STEP\n*STATIC, SOLVER=ITERATIVE CHOLESKY\n*DLOAD\n")
        for i, (first, second) in enumerate(walls.labels):
            # Positive pressure acts against the normal, which points from the first cell to the second.
            file.write("%d, P, %.9g\n" % (i + 1, turgor.get(second, 0.0) - turgor.get(first, 0.0)))
        file.write("*NODE FILE, OUTPUT=2D\nU\n*NODE PRINT, NSET=ALL\nU\n*END STEP\n")
    code, seconds = run(["ccx", "-i", "walls"], folder, "calculix.log")
    log = (folder / "calculix.log").read_text()
    if code != 0 or "Job finished" not in log:
        return {"failed": "see calculix.log", "seconds": seconds}
    rows = [line.split() for line in (folder / "walls.dat").read_text().splitlines()]
    moved = np.array([list(map(float, r[1:])) for r in rows if len(r) == 4 and r[0].isdigit()])
    return {"shells": len(walls.triangles), "largestDisplacement": float(np.linalg.norm(moved, axis=1).max()),
            "seconds": seconds}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--only", nargs="+", choices=PROGRAMS, default=list(PROGRAMS))
    parser.add_argument("--thickness", type=float, default=0.3, help="of the shells, in the units of the mesh")
    parser.add_argument("--pressure", type=float, default=0.1, help="mean turgor; Young's modulus is 100")
    arguments = parser.parse_args()
    absent = [PROGRAMS[name] for name in arguments.only if shutil.which(PROGRAMS[name]) is None]
    if absent:
        sys.exit("not installed: " + ", ".join(absent))
    walls = Walls(arguments.folder)
    compute = {
        "gmsh": lambda: mesh_with_gmsh(walls, arguments.folder),
        "tetgen": lambda: mesh_with_tetgen(walls, arguments.folder),
        "calculix": lambda: compute_with_calculix(walls, arguments.folder, arguments.thickness, arguments.pressure),
    }
    report = {}
    for name in arguments.only:
        report[name] = compute[name]()
        print(name, json.dumps(report[name]))
    (arguments.folder / "report.json").write_text(json.dumps(report, indent=1))
    is_sound = all("failed" not in r and not r.get("cellsOfOtherVolume") for r in report.values())
    return 0 if is_sound else 1


if __name__ == "__main__":
    sys.exit(main())
