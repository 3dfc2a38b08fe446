# Copyright The TissueTessellation contributors
# SPDX-License-Identifier: Apache-2.0
"""The exterior's label is told from those of the cells."""
import unittest

import itk

from LabelImageToCellWallMeshFilterTest import EXTERIOR, make_tissue, to_itk


class ExteriorLabelImageCalculatorTest(unittest.TestCase):
    def find(self, array):
        image = to_itk(array)
        calculator = itk.ExteriorLabelImageCalculator[type(image)].New()
        calculator.SetImage(image)
        calculator.Compute()
        return calculator

    def test_label_around_the_cells_and_none_in_a_crop(self):
        labels = make_tissue()
        self.assertTrue(self.find(labels).GetHasExteriorLabel())
        self.assertEqual(self.find(labels).GetExteriorLabel(), EXTERIOR)
        self.assertFalse(self.find(labels[3:-3, 3:-3, 3:-3].copy()).GetHasExteriorLabel())


if __name__ == "__main__":
    unittest.main()
