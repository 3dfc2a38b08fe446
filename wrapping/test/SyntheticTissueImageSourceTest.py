# Copyright The TissueTessellation contributors
# SPDX-License-Identifier: Apache-2.0
"""Synthetic tissues as NumPy arrays."""
import unittest

import itk
import numpy as np

ImageType = itk.Image[itk.US, 3]
Enums = itk.SyntheticTissueEnums


def make_tissue(**parameters):
    return itk.synthetic_tissue_image_source(ttype=ImageType, size=[40, 36, 32], number_of_cells=20, **parameters)


class SyntheticTissueImageSourceTest(unittest.TestCase):
    def test_dome_has_its_cells_and_an_exterior(self):
        image = make_tissue(spacing=[0.5, 0.5, 1.0], first_cell_label=7)
        array = itk.array_from_image(image)
        self.assertEqual(array.shape, (32, 36, 40))
        self.assertEqual(array.dtype, np.uint16)
        self.assertEqual(list(itk.spacing(image)), [0.5, 0.5, 1.0])
        np.testing.assert_array_equal(np.unique(array), [0, *range(7, 27)])

    def test_shapes_and_cell_models(self):
        block = itk.array_from_image(make_tissue(shape=Enums.Shape_Block, margin=0))
        self.assertTrue(block.all())
        voronoi = itk.array_from_image(
            make_tissue(shape=Enums.Shape_Block, margin=0, cell_model=Enums.CellModel_Voronoi)
        )
        self.assertTrue((block != voronoi).any())

    def test_seeds_and_errors(self):
        arrays = [itk.array_from_image(make_tissue(seed=seed)) for seed in (1, 1, 2)]
        np.testing.assert_array_equal(arrays[0], arrays[1])
        self.assertTrue((arrays[0] != arrays[2]).any())
        with self.assertRaisesRegex(RuntimeError, "Margin of 16 voxels"):
            make_tissue(margin=16)


if __name__ == "__main__":
    unittest.main()
