# Copyright The TissueTessellation contributors
# SPDX-License-Identifier: Apache-2.0
"""A signal is projected on the cells and walls of a tissue."""
import unittest

import itk
import numpy as np

from LabelImageToCellWallMeshFilterTest import EXTERIOR, make_tissue, to_itk


class CellSignalCalculatorTest(unittest.TestCase):
    def test_means_are_those_of_the_cells_voxels(self):
        labels = make_tissue()
        signal = np.random.default_rng(1).random(labels.shape, dtype=np.float32)
        extraction = itk.LabelJunctionExtractionFilter.New(to_itk(labels), generate_label_volume=True)
        extraction.Update()
        mesher = itk.JunctionsToCellWallMeshFilter.New(extraction.GetOutput(), label_volume=extraction.GetLabelVolume())
        mesher.Update()
        image = to_itk(signal)
        calculator = itk.CellSignalCalculator[type(image)].New()
        calculator.SetImage(image)
        calculator.SetLabelVolume(extraction.GetLabelVolume())
        calculator.SetMesh(mesher.GetOutput())
        calculator.Compute()
        means = itk.array_from_vector_container(calculator.GetMeans())
        integrals = itk.array_from_vector_container(calculator.GetIntegrals())
        cells = [label for label in np.unique(labels) if label != EXTERIOR]
        np.testing.assert_allclose(means, [signal[labels == cell].mean() for cell in cells], rtol=1e-5)
        np.testing.assert_allclose(integrals, [signal[labels == cell].sum() for cell in cells], rtol=1e-5)
        walls = itk.array_from_vector_container(calculator.GetMeansOfWalls())
        self.assertTrue(((0 <= walls) & (walls <= 1)).all())

    def test_errors_reach_python(self):
        calculator = itk.CellSignalCalculator[itk.Image[itk.F, 3]].New()
        with self.assertRaisesRegex(RuntimeError, "not set"):
            calculator.Compute()


if __name__ == "__main__":
    unittest.main()
