# Copyright The TissueTessellation contributors
# SPDX-License-Identifier: Apache-2.0
"""Junctions of a label image made with NumPy against what NumPy finds there, and the mesh that they make."""
import unittest

import itk
import numpy as np

from LabelImageToCellWallMeshFilterTest import EXTERIOR, ORIGIN, SPACING, make_tissue, to_itk


def pairs_of_faces(image):
    """The pairs of labels on the two sides of a voxel face."""
    pairs = set()
    for axis in range(3):
        sides = np.stack([np.moveaxis(image, axis, 0)[:-1].ravel(), np.moveaxis(image, axis, 0)[1:].ravel()], 1)
        pairs.update(map(tuple, np.sort(sides, 1)[sides[:, 0] != sides[:, 1]].tolist()))
    return pairs


class LabelJunctionExtractionFilterTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.image = make_tissue()
        cls.junctions = itk.label_junction_extraction_filter(to_itk(cls.image))
        cls.cells = np.setdiff1d(cls.image, [EXTERIOR])

    def get(self, name, components=1):
        array = itk.array_from_vector_container(getattr(self.junctions, "Get" + name)())
        return array.reshape(-1, components) if components > 1 else array

    def test_cells(self):
        np.testing.assert_array_equal(self.get("CellLabels"), self.cells)
        numbers = np.array([(self.image == cell).sum() for cell in self.cells])
        np.testing.assert_allclose(self.get("CellVolumes"), numbers * SPACING.prod())
        centers = [np.argwhere(self.image == cell).mean(0)[::-1] * SPACING + ORIGIN for cell in self.cells]
        np.testing.assert_allclose(self.get("CellCenters", 3), centers)

    def test_walls_are_the_pairs_that_share_a_face(self):
        labels = self.get("WallLabels", 2)
        self.assertEqual({tuple(sorted(pair)) for pair in labels.tolist()}, pairs_of_faces(self.image))
        self.assertEqual(len(self.get("WallAreas")), len(labels))
        self.assertGreater(self.get("WallAreas").min(), 0)

    def test_four_cells_of_each_junction_are_around_it(self):
        labels = self.get("JunctionLabels", 4)
        places = (self.get("JunctionPositions", 3) - ORIGIN) / SPACING
        self.assertEqual(len(labels), len(places))
        self.assertGreater(len(labels), 27)
        for four, place in zip(labels, places):
            x, y, z = np.rint(place).astype(int)
            self.assertTrue(np.isin(four, self.image[z - 2 : z + 3, y - 2 : y + 3, x - 2 : x + 3]).all())

    def test_junctions_and_label_volume_make_a_mesh_of_all_cells(self):
        extraction = itk.LabelJunctionExtractionFilter.New(to_itk(self.image), generate_label_volume=True)
        extraction.Update()
        volume = extraction.GetLabelVolume()
        self.assertEqual(volume.GetNumberOfVoxels(), self.image.size)
        mesh = itk.junctions_to_cell_wall_mesh_filter(extraction.GetOutput(), label_volume=volume, refinement=0)
        self.assertEqual(mesh.GetNumberOfCells(), 27)
        labels = itk.array_from_vector_container(mesh.GetTriangleLabels()).reshape(-1, 2)
        np.testing.assert_array_equal(np.unique(labels), np.union1d(self.cells, [EXTERIOR]))

    def test_without_a_label_volume_only_the_paper_preset_makes_a_mesh(self):
        extraction = itk.LabelJunctionExtractionFilter.New(to_itk(self.image))
        extraction.Update()
        self.assertEqual(extraction.GetLabelVolume().GetNumberOfVoxels(), 0)
        reconstruction = itk.JunctionsToCellWallMeshFilter.New(extraction.GetOutput())
        with self.assertRaisesRegex(RuntimeError, "label volume"):
            reconstruction.Update()
        reconstruction.UsePaperPreset()
        reconstruction.Update()
        self.assertEqual(reconstruction.GetOutput().GetNumberOfCells(), 27)

    def test_options_and_errors_reach_python(self):
        extraction = itk.LabelJunctionExtractionFilter.New(to_itk(self.image), exterior_label=10)
        extraction.Update()
        labels = itk.array_from_vector_container(extraction.GetOutput().GetCellLabels())
        np.testing.assert_array_equal(labels, np.setdiff1d(self.image, [10]))
        with self.assertRaisesRegex(RuntimeError, "label"):
            itk.label_junction_extraction_filter(to_itk(self.image), exterior_label=8)


if __name__ == "__main__":
    unittest.main()
