# Copyright The TissueTessellation contributors
# SPDX-License-Identifier: Apache-2.0
"""A TissueMesh from ITK's mesh, whose labels are numbers."""
import itk
import numpy as np

from .tissue_mesh import TissueMesh


def _to_array(container, components=1):
    """Of a container of ITK, a copy; (n, components) where these are several."""
    array = itk.array_from_vector_container(container) if container.Size() > 0 else np.zeros(0)
    return array.reshape(-1, components) if components > 1 else array


def _table(names, types, column, number_of_rows):
    """Columns by name; those of vectors as three, and flags as True and False."""
    table = {}
    for name, kind in zip(names, types):
        values = _to_array(column(name)).reshape(number_of_rows, -1).astype(bool if kind == "uint8" else kind)
        if values.shape[1] == 3:
            table.update({name + axis: values[:, i].copy() for i, axis in enumerate("XYZ")})
        else:
            table[name] = values.ravel()
    return table


def _remarks(calculator, label_of):
    remarks = []
    for number, reason, value, text in zip(
        _to_array(calculator.GetRemarkLabels()),
        calculator.GetRemarkReasons(),
        _to_array(calculator.GetRemarkValues()),
        calculator.GetRemarkTexts(),
    ):
        value = float(value)
        if reason == "enclosed":  # Its value is a label, too.
            label = label_of(int(value))
            text = text.replace(f"label {value:g}", f"label {label}")
            value = float(label)
        remarks.append({"label": label_of(int(number)), "reason": reason, "value": value, "text": text})
    return remarks


def _report(mesh, calculator, cells, walls):
    layers = np.bincount(cells["Layer"])[1:]
    return {
        "cells": mesh.GetNumberOfCells(),
        "points": mesh.GetNumberOfPoints(),
        "triangles": mesh.GetNumberOfTriangles(),
        "walls": len(walls["WallId"]),
        "adjacency2": mesh.GetAdjacency2(),
        "adjacency4": mesh.GetAdjacency4(),
        "adjacency4OfNeighbors": mesh.GetAdjacency4OfNeighbors(),
        "falsePairs": mesh.GetNumberOfFalsePairs(),
        "missingPairs": mesh.GetNumberOfMissingPairs(),
        "meanVolumeError": float(np.mean(np.abs(cells["Volume"] / cells["ImageVolume"] - 1))),
        "crossingPairs": mesh.GetNumberOfCrossings(),
        "minimumTriangleAngle": calculator.GetMinimumTriangleAngle(),
        "minimumDihedralAngle": calculator.GetMinimumDihedralAngle(),
        "edgeLengthRatio": calculator.GetEdgeLengthRatio(),
        "exteriorArea": float(cells["ExteriorArea"].sum()),
        "cutArea": float(cells["CutArea"].sum()),
        "cellsOfLayers": layers.tolist(),
    }


def collect(mesh, label_of, offset=(0.0, 0.0, 0.0)):
    """A TissueMesh of an itk.CellWallMesh.

    label_of -- the label of a number; offset -- x, y, z, added to all positions.
    """
    calculator = itk.CellWallMeshStatisticsCalculator.New()
    calculator.SetMesh(mesh)
    calculator.Compute()
    exterior = mesh.GetExteriorLabel()

    def to_labels(container, components=1):
        # Numbers are two's complements in ITK's containers.
        numbers = _to_array(container, components).astype(np.int64)
        known, places = np.unique(numbers, return_inverse=True)
        return np.array([label_of(int(number)) for number in known], dtype=np.int64)[places].reshape(numbers.shape)

    cell_labels = to_labels(calculator.GetCellLabels())
    wall_labels = to_labels(calculator.GetWallLabels(), 2)
    cells = _table(
        calculator.GetCellColumnNames(), calculator.GetCellColumnTypes(), calculator.GetCellColumn, len(cell_labels)
    )
    walls = _table(
        calculator.GetWallColumnNames(), calculator.GetWallColumnTypes(), calculator.GetWallColumn, len(wall_labels)
    )
    cells["Label"] = cell_labels
    walls["Label0"], walls["Label1"] = wall_labels.T.copy()
    for axis, shift in zip("XYZ", offset):
        cells["Center" + axis] += shift
        walls["Center" + axis] += shift
    return TissueMesh(
        points=_to_array(mesh.GetPointCoordinates(), 3) + np.asarray(offset),
        triangles=_to_array(mesh.GetTriangles(), 3).astype(np.int64),
        boundary_labels=to_labels(mesh.GetTriangleLabels(), 2),
        wall_ids=_to_array(mesh.GetTriangleWalls()).astype(np.int64),
        numbers_of_cells=_to_array(mesh.GetNumbersOfCellsAtPoints()).astype(np.uint8),
        cells=cells,
        walls=walls,
        remarks=_remarks(calculator, label_of),
        report=_report(mesh, calculator, cells, walls),
        exterior_label=label_of(exterior),
    )
