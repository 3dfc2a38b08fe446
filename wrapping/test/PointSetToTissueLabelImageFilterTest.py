# Copyright The TissueTessellation contributors
# SPDX-License-Identifier: Apache-2.0
"""From nuclei drawn with NumPy to points, to the label image of their tissue, to its walls."""
import unittest

import itk
import numpy as np

SPACING = np.array([1.0, 1.0, 2.0])
ORIGIN = np.array([-3.0, 5.0, 11.0])
SIZE = np.array([48, 48, 24])
CELLS = 27


def make_centers():
    """Of 27 cells around a jittered grid, in physical units."""
    grid = np.stack(np.meshgrid(*3 * [np.arange(3)], indexing="ij"), -1).reshape(-1, 3)
    return ORIGIN + 12 + 12 * grid + np.random.default_rng(1).uniform(-2, 2, grid.shape)


def draw_nuclei(centers):
    z, y, x = np.meshgrid(*[np.arange(n) for n in SIZE[::-1]], indexing="ij")
    positions = ORIGIN + SPACING * np.stack([x, y, z], -1)
    array = np.zeros(x.shape)
    for center in centers:
        array += 1000 * np.exp(-((positions - center) ** 2).sum(-1) / (2 * 2.0**2))
    image = itk.image_from_array(array.astype(np.uint16))
    image.SetSpacing(SPACING.tolist())
    image.SetOrigin(ORIGIN.tolist())
    return image


def make_point_set(positions):
    points = itk.PointSet[itk.F, 3].New()
    for i, position in enumerate(positions.tolist()):
        points.SetPoint(i, position)
    return points


def labels_at(labels, positions):
    indices = [labels.TransformPhysicalPointToIndex(position) for position in positions.tolist()]
    return [labels.GetPixel(index) for index in indices]


class PointSetToTissueLabelImageFilterTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.centers = make_centers()
        cls.nuclei = draw_nuclei(cls.centers)
        cls.points = itk.difference_of_gaussians_blob_detection_filter(cls.nuclei)
        cls.labels = itk.point_set_to_tissue_label_image_filter(cls.points, reference_image=cls.nuclei)

    def test_every_cell_holds_its_nucleus(self):
        self.assertEqual(self.points.GetNumberOfPoints(), CELLS)
        positions = itk.array_from_vector_container(self.points.GetPoints())
        self.assertEqual(labels_at(self.labels, positions), list(range(1, CELLS + 1)))
        # The cells are those of the nuclei that were drawn, too.
        self.assertEqual(sorted(labels_at(self.labels, self.centers)), list(range(1, CELLS + 1)))

    def test_labels_are_the_points_numbers_on_a_grid_in_the_box(self):
        array = itk.array_from_image(self.labels)
        np.testing.assert_array_equal(np.unique(array), np.arange(CELLS + 1))
        box = np.array(itk.size(self.labels)) * np.array(itk.spacing(self.labels))
        np.testing.assert_allclose(box, SIZE * SPACING)
        np.testing.assert_allclose(
            np.array(itk.origin(self.labels)) - np.array(itk.spacing(self.labels)) / 2, ORIGIN - SPACING / 2
        )

    def test_walls_of_the_labels_are_those_of_the_nuclei(self):
        mesh = itk.label_image_to_cell_wall_mesh_filter(self.labels, refinement=0)
        self.assertEqual(mesh.GetNumberOfCells(), CELLS)
        labels = itk.array_from_vector_container(mesh.GetTriangleLabels()).reshape(-1, 2)
        np.testing.assert_array_equal(np.unique(labels), np.arange(CELLS + 1))

    def test_votes_tell_which_cells_meet(self):
        tissue = itk.PointSetToTissueLabelImageFilter.New(self.points, reference_image=self.nuclei)
        tissue.Update()
        votes = tissue.GetVotes()
        labels = itk.array_from_vector_container(votes.GetLabels()).reshape(-1, 4)
        shares = itk.array_from_vector_container(votes.GetShares())
        self.assertEqual(len(labels), votes.GetNumberOfVotes())
        self.assertTrue(((shares > 0) & (shares <= 1)).all())
        self.assertTrue((np.diff(labels.astype(int), axis=1) > 0).all())
        self.assertEqual((labels.min(), labels.max()), (0, CELLS))
        by_image = itk.label_image_to_cell_wall_mesh_filter(tissue.GetOutput(), refinement=0)
        by_votes = itk.label_image_to_cell_wall_mesh_filter(tissue.GetOutput(), votes=votes, refinement=0)
        self.assertEqual(by_votes.GetNumberOfCells(), CELLS)
        self.assertNotEqual(by_votes.GetAdjacency4(), by_image.GetAdjacency4())

    def test_points_of_ones_own_and_errors(self):
        labels = itk.point_set_to_tissue_label_image_filter(make_point_set(self.centers), voxels_per_cell=500)
        self.assertEqual(labels_at(labels, self.centers), list(range(1, CELLS + 1)))
        with self.assertRaisesRegex(RuntimeError, "at least 4"):
            itk.point_set_to_tissue_label_image_filter(make_point_set(self.centers[:3]))


if __name__ == "__main__":
    unittest.main()
