# Copyright The TissueTessellation contributors
# SPDX-License-Identifier: Apache-2.0
"""Nuclei of a synthetic tissue are found where they are."""
import unittest

import itk
import numpy as np


class SyntheticNucleiImageFilterTest(unittest.TestCase):
    def test_detection_finds_the_nuclei(self):
        tissue = itk.synthetic_tissue_image_source(ttype=itk.Image[itk.US, 3], size=[64, 64, 64], number_of_cells=40)
        stain = itk.SyntheticNucleiImageFilter.New(tissue, signal_to_noise=20, seed=3)
        stain.Update()
        nuclei = itk.array_from_vector_container(stain.GetNuclei().GetPoints())
        points = itk.difference_of_gaussians_blob_detection_filter(stain.GetOutput())
        found = itk.array_from_vector_container(points.GetPoints())
        self.assertEqual(len(nuclei), 40)
        distances = np.linalg.norm(nuclei[:, np.newaxis] - found, axis=-1)
        self.assertGreater((distances.min(1) < 1).mean(), 0.95)
        self.assertGreater((distances.min(0) < 1).mean(), 0.95)


if __name__ == "__main__":
    unittest.main()
