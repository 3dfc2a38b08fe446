# Copyright The TissueTessellation contributors
# SPDX-License-Identifier: Apache-2.0
"""Bright membranes drawn with NumPy between the cells of a label image give these cells back."""
import unittest

import itk
import numpy as np

from LabelImageToCellWallMeshFilterTest import make_tissue, to_itk


def draw_membranes(labels):
    """200 in the voxels beside another label, 40 in the others."""
    membrane = np.zeros(labels.shape, bool)
    for axis in range(3):
        step = np.diff(labels, axis=axis) != 0
        np.moveaxis(membrane, axis, 0)[:-1] |= np.moveaxis(step, axis, 0)
        np.moveaxis(membrane, axis, 0)[1:] |= np.moveaxis(step, axis, 0)
    return np.where(membrane, 200, 40)


class MembraneToTissueLabelImageFilterTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        # Without the exterior: the cells fill the image.
        cls.labels = make_tissue()[3:-3, 3:-3, 3:-3]
        cls.membranes = draw_membranes(cls.labels)

    def test_minima_of_all_pixel_types_are_the_cells(self):
        for pixel_type in (np.uint8, np.uint16, np.float32):
            with self.subTest(pixel_type=pixel_type):
                image = itk.image_from_array(self.membranes.astype(pixel_type))
                segmentation = itk.MembraneToTissueLabelImageFilter.New(image)
                segmentation.Update()
                self.assertEqual(segmentation.GetNumberOfCells(), 27)
                result = itk.array_from_image(segmentation.GetOutput())
                np.testing.assert_array_equal(np.unique(result), np.arange(1, 28))
                # The label that most voxels of each cell have.
                label_of = np.array([0] + [np.bincount(self.labels[result == cell]).argmax() for cell in range(1, 28)])
                self.assertEqual(len(np.unique(label_of)), 28)
                self.assertGreater((label_of[result] == self.labels).mean(), 0.9)

    def test_cell_image_gives_the_labels(self):
        # Where the cells are, about: they fill less of the image.
        cells = np.where(self.membranes == 40, self.labels, 0).astype(np.uint16)
        result = itk.membrane_to_tissue_label_image_filter(
            to_itk(self.membranes.astype(np.uint8)), cell_image=to_itk(cells)
        )
        array = itk.array_from_image(result)
        self.assertEqual(itk.origin(result), itk.origin(to_itk(cells)))
        np.testing.assert_array_equal(np.unique(array), np.unique(self.labels))
        self.assertGreater((array == self.labels).mean(), 0.9)

    def test_errors_reach_python(self):
        with self.assertRaisesRegex(RuntimeError, "All pixels of the image are 0"):
            itk.membrane_to_tissue_label_image_filter(to_itk(np.zeros((9, 9, 9), np.uint8)))


if __name__ == "__main__":
    unittest.main()
