# Copyright The TissueTessellation contributors
# SPDX-License-Identifier: Apache-2.0
"""Cells that NumPy has parted by walls of background grow together again."""
import unittest

import itk
import numpy as np

from LabelImageToCellWallMeshFilterTest import EXTERIOR, make_tissue


class LabelGapClosingImageFilterTest(unittest.TestCase):
    def test_gaps_are_closed_and_the_exterior_stays(self):
        labels = make_tissue()
        exterior = labels == EXTERIOR
        eroded = np.where(exterior, 0, labels).astype(np.uint16)
        for axis in range(3):
            step = (np.diff(labels, axis=axis) != 0) & (np.diff(exterior.astype(int), axis=axis) == 0)
            np.moveaxis(eroded, axis, 0)[1:][np.moveaxis(step, axis, 0)] = 0
        gaps = (eroded == 0) & ~exterior
        closing = itk.LabelGapClosingImageFilter.New(itk.image_from_array(eroded), gap_width=2)
        closing.Update()
        closed = itk.array_from_image(closing.GetOutput())
        self.assertEqual(closing.GetNumberOfChangedVoxels(), (closed != eroded).sum())
        np.testing.assert_array_equal(closed[eroded != 0], eroded[eroded != 0])
        self.assertGreater((closed[gaps] != 0).mean(), 0.95)
        self.assertLess((closed[exterior] != 0).mean(), 0.01)
        with self.assertRaisesRegex(RuntimeError, "gap width"):
            itk.label_gap_closing_image_filter(itk.image_from_array(eroded), gap_width=-1)


if __name__ == "__main__":
    unittest.main()
