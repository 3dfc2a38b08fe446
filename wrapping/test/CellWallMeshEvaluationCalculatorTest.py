# Copyright The TissueTessellation contributors
# SPDX-License-Identifier: Apache-2.0
"""A mesh of cell walls is judged by the label image that it was made of."""
import unittest

import itk

from LabelImageToCellWallMeshFilterTest import make_tissue, to_itk


def evaluate(image, mesh):
    calculator = itk.CellWallMeshEvaluationCalculator[type(image)].New()
    calculator.SetImage(image)
    calculator.SetMesh(mesh)
    calculator.Compute()
    return calculator


class CellWallMeshEvaluationCalculatorTest(unittest.TestCase):
    def test_fitted_walls_are_better_than_those_of_the_junctions_alone(self):
        image = to_itk(make_tissue())
        fitted = evaluate(image, itk.label_image_to_cell_wall_mesh_filter(image))
        unfitted = itk.JunctionsToCellWallMeshFilter.New(itk.label_junction_extraction_filter(image))
        unfitted.UsePaperPreset()
        unfitted.Update()
        stars = evaluate(image, unfitted.GetOutput())
        for figures in (fitted, stars):
            self.assertEqual(figures.GetNumberOfCells(), 27)
            self.assertEqual(figures.GetNumberOfClosedCells(), 27)
            self.assertEqual(figures.GetNumberOfCrowdedCorners(), 0)
            self.assertTrue(0 < figures.GetAdjacency4OfNeighbors() <= 1)
            self.assertEqual(figures.GetNumberOfCellsOfSpheres(), 27)
            self.assertEqual(figures.GetGenusOfExterior(), figures.GetGenusOfExteriorInImage())
        self.assertGreater(fitted.GetAdjacency2(), 0.9)
        self.assertGreater(fitted.GetAdjacency4(), 0.8)
        self.assertGreater(fitted.GetAdjacency2(), stars.GetAdjacency2())
        self.assertEqual(fitted.GetNumberOfCrossings(), 0)
        self.assertGreater(fitted.GetMeanDice(), 0.95)
        self.assertGreater(fitted.GetMeanDice(), stars.GetMeanDice())
        self.assertLess(fitted.GetMeanVolumeError(), 0.01)
        self.assertLess(fitted.GetMeanVolumeError(), stars.GetMeanVolumeError())
        self.assertLess(fitted.GetMeanWallDistance(), stars.GetMeanWallDistance())
        self.assertGreater(fitted.GetMeanTriangleQuality(), 0.8)
        self.assertGreaterEqual(fitted.GetMinimumTriangleAngle(), 10)
        self.assertGreaterEqual(fitted.GetMinimumDihedralAngle(), 10)
        self.assertLess(fitted.GetEdgeLengthRatio(), 100)
        self.assertTrue(0.9 < fitted.GetMeanConvexity() < 1)

    def test_errors_reach_python(self):
        calculator = itk.CellWallMeshEvaluationCalculator[itk.Image[itk.US, 3]].New()
        with self.assertRaisesRegex(RuntimeError, "before Compute"):
            calculator.GetAdjacency2()
        with self.assertRaisesRegex(RuntimeError, "empty"):
            calculator.SetMesh(itk.CellWallMesh.New())


if __name__ == "__main__":
    unittest.main()
