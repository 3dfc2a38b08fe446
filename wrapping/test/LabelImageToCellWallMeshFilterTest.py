# Copyright The TissueTessellation contributors
# SPDX-License-Identifier: Apache-2.0
"""A label image made with NumPy becomes a cell-wall mesh, read back as NumPy arrays."""
import unittest

import itk
import numpy as np

EXTERIOR = 7
SPACING = np.array([0.5, 1.0, 2.0])
ORIGIN = np.array([-3.0, 5.0, 11.0])


def make_tissue():
    """27 Voronoi cells around a jittered grid in a box, labels with gaps; indexed z, y, x."""
    size = 42
    grid = np.stack(np.meshgrid(*3 * [np.arange(3)], indexing="ij"), -1).reshape(-1, 3)
    seeds = 9 + 12 * grid + np.random.default_rng(1).uniform(-3, 3, grid.shape)
    voxels = np.stack(np.meshgrid(*3 * [np.arange(size)], indexing="ij"), -1)
    distances = ((voxels[..., np.newaxis, :] - seeds) ** 2).sum(-1)
    labels = (10 + 3 * distances.argmin(-1)).astype(np.uint16)
    inside = ((voxels >= 3) & (voxels < size - 3)).all(-1)
    return np.where(inside, labels, np.uint16(EXTERIOR))


def to_itk(labels):
    image = itk.image_from_array(labels)
    image.SetSpacing(SPACING.tolist())
    image.SetOrigin(ORIGIN.tolist())
    return image


def signed_volume(corners):
    return np.einsum("ij,ij->", corners[:, 0], np.cross(corners[:, 1], corners[:, 2])) / 6


class LabelImageToCellWallMeshFilterTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.image = make_tissue()
        mesh = itk.label_image_to_cell_wall_mesh_filter(to_itk(cls.image))
        cls.mesh = mesh
        cls.points = itk.array_from_vector_container(mesh.GetPointCoordinates()).reshape(-1, 3)
        cls.triangles = itk.array_from_vector_container(mesh.GetTriangles()).reshape(-1, 3)
        cls.labels = itk.array_from_vector_container(mesh.GetTriangleLabels()).reshape(-1, 2)
        cls.cells = np.setdiff1d(cls.image, [EXTERIOR])

    def walls_of(self, cell):
        """The triangles whose normals point out of the cell, and those whose normals point into it."""
        return [self.triangles[self.labels[:, side] == cell] for side in (0, 1)]

    def test_arrays_hold_the_whole_mesh(self):
        self.assertEqual(self.mesh.GetNumberOfCells(), 27)
        self.assertEqual(len(self.points), self.mesh.GetNumberOfPoints())
        self.assertEqual(len(self.triangles), self.mesh.GetNumberOfTriangles())
        self.assertEqual(len(self.labels), len(self.triangles))
        np.testing.assert_array_equal(np.unique(self.triangles), np.arange(len(self.points)))

    def test_points_lie_on_the_tissue(self):
        # The box's voxels end at 2.5 and 38.5: walls that keep the volume of rounded edges bulge, by a voxel
        # and a half at most.
        low, high = ORIGIN + 1.0 * SPACING, ORIGIN + 40.0 * SPACING
        self.assertTrue(((self.points > low) & (self.points < high)).all())

    def test_label_pairs_are_those_of_the_image_with_the_exterior_second(self):
        np.testing.assert_array_equal(np.unique(self.labels[:, 0]), self.cells)
        inner = self.labels[self.labels[:, 1] != EXTERIOR]
        self.assertTrue((inner[:, 0] < inner[:, 1]).all())
        self.assertFalse((self.labels[:, 0] == EXTERIOR).any())

    def test_every_cell_is_a_closed_sphere_with_its_normals_outwards(self):
        for cell in self.cells:
            outward, inward = self.walls_of(cell)
            surface = np.vstack([outward, inward[:, ::-1]])
            directed = np.vstack([surface[:, [0, 1]], surface[:, [1, 2]], surface[:, [2, 0]]])
            # Closed and consistently oriented: every directed edge once, and its reverse once.
            edges = {tuple(edge) for edge in directed.tolist()}
            self.assertEqual(len(edges), len(directed), f"cell {cell}")
            self.assertEqual(edges, {(b, a) for a, b in edges}, f"cell {cell}")
            characteristic = len(np.unique(surface)) - len(edges) // 2 + len(surface)
            self.assertEqual(characteristic, 2, f"cell {cell}")
            self.assertGreater(signed_volume(self.points[surface]), 0, f"cell {cell}")

    def test_cells_have_their_volume_in_physical_units(self):
        # The other cells have an edge of the box, where no four labels meet to hold a corner.
        for cell in 10 + 3 * np.array([4, 10, 12, 13, 14, 16, 22]):
            outward, inward = self.walls_of(cell)
            volume = signed_volume(self.points[outward]) - signed_volume(self.points[inward])
            voxels = (self.image == cell).sum()
            self.assertAlmostEqual(volume / (voxels * SPACING.prod()), 1, delta=0.05)

    def test_parameters_and_errors_reach_python(self):
        coarse = itk.label_image_to_cell_wall_mesh_filter(to_itk(self.image), refinement=0)
        self.assertLess(coarse.GetNumberOfTriangles(), self.mesh.GetNumberOfTriangles())
        one = itk.label_image_to_cell_wall_mesh_filter(to_itk(np.minimum(self.image, EXTERIOR + 1)))
        self.assertEqual(one.GetNumberOfCells(), 1)
        with self.assertRaisesRegex(RuntimeError, "cell"):
            itk.label_image_to_cell_wall_mesh_filter(to_itk(np.minimum(self.image, EXTERIOR)))


if __name__ == "__main__":
    unittest.main()
