# Copyright The TissueTessellation contributors
# SPDX-License-Identifier: Apache-2.0
"""Triangular meshes of all cell walls of a tissue, as NumPy arrays.

    import tissuetessellation

    tissue = tissuetessellation.mesh(labels, spacing=(1.0, 0.5, 0.5))  # z, y, x, as the array's axes
    tissue.points, tissue.triangles, tissue.boundary_labels
    pandas.DataFrame(tissue.cells)
    meshio.write("walls.vtu", tissue.to_meshio())

`mesh` takes a label image, `mesh_points` the centres of cells or nuclei; both give a `TissueMesh`. It stands on ITK's
Python wrapping of the C++ module, `itk` with TissueTessellation.
"""
from .reconstruction import mesh, mesh_points
from .tissue_mesh import TissueMesh

__all__ = ["TissueMesh", "mesh", "mesh_points"]
