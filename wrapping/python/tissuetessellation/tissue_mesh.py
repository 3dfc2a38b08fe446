# Copyright The TissueTessellation contributors
# SPDX-License-Identifier: Apache-2.0
"""The mesh of a tissue's walls with what is known of its cells."""
from dataclasses import dataclass
from typing import Any, Dict, List

import numpy as np

# The walls' columns that triangles have, as in the files of the program.
_WALL_ARRAYS = ("Area", "Planarity", "PlaneDistance", "MeanCurvature", "CutArea")


@dataclass(eq=False, repr=False)
class TissueMesh:
    """The triangular mesh of all walls of a tissue: each wall once, shared by its two cells.

    Positions and vectors are x, y, z in physical units (LPS), those of the spacing and the origin that were given; the
    array's axes are the other way round. The triangles of all walls of a cell form a closed surface, at most four
    cells (three and the exterior) meet at a point, and a triangle's normal, by the right-hand rule, points from the
    first cell of its wall to the second. Of two cells the one of the smaller label is the first, the exterior is always
    the second. What cannot be measured is NaN.

    points           float64 (n, 3)  the points
    triangles        int64 (m, 3)    indices of the points
    boundary_labels  int64 (m, 2)    labels of the two cells that a triangle separates
    wall_ids         int64 (m,)      the triangle's wall, a row of `walls`; the triangles of a wall follow each other
    numbers_of_cells uint8 (n,)      cells that meet at a point: 2 within a wall, 3 on the line of three, 4 at a corner
    cells            columns of one row a cell, by ascending labels: `pandas.DataFrame(tissue.cells)`. README's
                     "Statistics", by the same names: Label, CenterX, ..., Volume, SurfaceArea, Layer, ...
    walls            columns of one row a wall: WallId, Label0, Label1, Area, CenterX, ..., MeanCurvature, CutArea
    remarks          what to know of single cells: {"label", "reason", "value", "text"}, by README's names of remarks
    report           figures of the whole, by the names of the program's report
    exterior_label   the label that stands for the exterior; where the image has none, one that no cell has
    """

    points: np.ndarray
    triangles: np.ndarray
    boundary_labels: np.ndarray
    wall_ids: np.ndarray
    numbers_of_cells: np.ndarray
    cells: Dict[str, np.ndarray]
    walls: Dict[str, np.ndarray]
    remarks: List[Dict[str, Any]]
    report: Dict[str, Any]
    exterior_label: int

    @property
    def labels(self):
        """The labels of the cells, int64, ascending."""
        return self.cells["Label"]

    def surface(self, label):
        """The closed surface of a cell: its triangles (k, 3), turned outwards. Raises ValueError for other labels."""
        if label not in self.labels:
            raise ValueError(f"There is no cell {label}: the mesh has {len(self.labels)} cells")
        outward = self.triangles[self.boundary_labels[:, 0] == label]
        inward = self.triangles[self.boundary_labels[:, 1] == label]
        return np.concatenate([outward, inward[:, ::-1]])

    def triangle_arrays(self):
        """The arrays of the triangles by the names that the program's walls.vtp has."""
        arrays = {
            "Label": self.boundary_labels[:, 0],
            "BoundaryLabels": self.boundary_labels,
            "Label0": self.boundary_labels[:, 0],
            "Label1": self.boundary_labels[:, 1],
            "WallId": self.wall_ids.astype(np.int32),
        }
        arrays.update({"Wall" + name: self.walls[name][self.wall_ids] for name in _WALL_ARRAYS})
        return arrays

    def to_vtk(self):
        """A vtkPolyData with all arrays, as the program's walls.vtp; `Label` is active. Needs VTK's Python."""
        from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
        from vtkmodules.vtkCommonCore import vtkPoints, vtkStringArray
        from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

        def add(attributes, name, values):
            array = numpy_to_vtk(np.ascontiguousarray(values), deep=True)
            array.SetName(name)
            attributes.AddArray(array)

        data = vtkPolyData()
        points = vtkPoints()
        points.SetData(numpy_to_vtk(np.ascontiguousarray(self.points), deep=True))
        data.SetPoints(points)
        polygons = vtkCellArray()
        polygons.SetData(3, numpy_to_vtkIdTypeArray(np.ascontiguousarray(self.triangles).ravel(), deep=True))
        data.SetPolys(polygons)
        for name, values in self.triangle_arrays().items():
            add(data.GetCellData(), name, values)
        data.GetCellData().SetActiveScalars("Label")
        add(data.GetPointData(), "NumberOfCells", self.numbers_of_cells)
        space = vtkStringArray()
        space.SetName("SPACE")
        space.InsertNextValue("LPS")
        data.GetFieldData().AddArray(space)
        return data

    def to_meshio(self):
        """A meshio.Mesh with the same arrays: `meshio.write("walls.vtu", tissue.to_meshio())`. Needs meshio."""
        import meshio

        return meshio.Mesh(
            self.points,
            [("triangle", self.triangles)],
            point_data={"NumberOfCells": self.numbers_of_cells},
            cell_data={name: [values] for name, values in self.triangle_arrays().items()},
        )

    def __repr__(self):
        return (
            f"TissueMesh({len(self.labels)} cells, {len(self.walls['WallId'])} walls, {len(self.points)} points, "
            f"{len(self.triangles)} triangles)"
        )
