# Copyright The TissueTessellation contributors
# SPDX-License-Identifier: Apache-2.0
"""Gaussian blobs drawn with NumPy are found where they are, with their scale and brightness."""
import unittest

import itk
import numpy as np

SPACING = np.array([0.5, 0.5, 1.0])
ORIGIN = np.array([-3.0, 5.0, 11.0])
SCALE = 1.5
# By falling brightness; x, y, z in voxels.
CENTERS = np.array([[10.3, 12.0, 6.4], [28.0, 11.2, 7.0], [12.1, 29.6, 15.8], [30.5, 28.3, 13.2]])
BRIGHTNESS = np.array([200.0, 170.0, 140.0, 110.0])


def draw_blobs(pixel_type):
    """Indexed z, y, x."""
    z, y, x = np.meshgrid(np.arange(24), np.arange(40), np.arange(42), indexing="ij")
    voxels = np.stack([x, y, z], -1)
    image = np.zeros(x.shape)
    for center, brightness in zip(CENTERS, BRIGHTNESS):
        squares = (((voxels - center) * SPACING) ** 2).sum(-1)
        image += brightness * np.exp(-squares / (2 * SCALE**2))
    return image.astype(pixel_type)


def to_itk(array):
    image = itk.image_from_array(array)
    image.SetSpacing(SPACING.tolist())
    image.SetOrigin(ORIGIN.tolist())
    return image


class DifferenceOfGaussiansBlobDetectionFilterTest(unittest.TestCase):
    def check_positions(self, points):
        positions = itk.array_from_vector_container(points.GetPoints())
        self.assertEqual(positions.shape, CENTERS.shape)
        errors = (positions - ORIGIN) / SPACING - CENTERS
        self.assertLess(np.abs(errors).max(), 0.5)

    def test_blobs_of_all_pixel_types_are_where_they_were_drawn(self):
        for pixel_type in (np.uint8, np.uint16, np.float32):
            with self.subTest(pixel_type=pixel_type):
                image = to_itk(draw_blobs(pixel_type))
                self.check_positions(itk.difference_of_gaussians_blob_detection_filter(image))

    def test_scales_and_responses_are_those_of_the_blobs(self):
        image = to_itk(draw_blobs(np.float32))
        detection = itk.DifferenceOfGaussiansBlobDetectionFilter.New(image, minimum_scale=1, maximum_scale=3)
        detection.Update()
        self.check_positions(detection.GetOutput())
        scales, responses = itk.array_from_vector_container(detection.GetBlobData()).reshape(-1, 2).T
        # -sigma^2 times the Laplacian of a Gaussian blob is greatest at sigma^2 = 2/3 of the blob's.
        np.testing.assert_allclose(scales, SCALE * np.sqrt(2 / 3), rtol=0.1)
        np.testing.assert_allclose(responses / responses[0], BRIGHTNESS / BRIGHTNESS[0], rtol=0.05)
        self.assertGreaterEqual(responses.min(), detection.GetUsedThreshold())
        self.assertEqual(detection.GetUsedMinimumScale(), 1)

    def test_dark_blobs_and_thresholds(self):
        image = to_itk(255 - draw_blobs(np.uint8))
        find = itk.difference_of_gaussians_blob_detection_filter
        self.check_positions(find(image, minimum_scale=1, maximum_scale=3, dark_blobs=True))
        brightest = find(image, minimum_scale=1, maximum_scale=3, dark_blobs=True, relative_threshold=0.8)
        self.assertEqual(brightest.GetNumberOfPoints(), 2)

    def test_errors_reach_python(self):
        with self.assertRaisesRegex(RuntimeError, "scales"):
            itk.difference_of_gaussians_blob_detection_filter(to_itk(draw_blobs(np.uint8)), minimum_scale=1)


if __name__ == "__main__":
    unittest.main()
