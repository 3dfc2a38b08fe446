# Copyright The TissueTessellation contributors
# SPDX-License-Identifier: Apache-2.0
"""The package tissuetessellation: from arrays of any integers, and from points, to meshes that others read."""
import importlib.util
import pathlib
import sys
import tempfile
import threading
import unittest

import itk
import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "python"))

import tissuetessellation  # noqa: E402

from LabelImageToCellWallMeshFilterTest import EXTERIOR, make_tissue, signed_volume  # noqa: E402

SPACING = (2.0, 1.0, 0.5)  # z, y, x
ORIGIN = (11.0, 5.0, -3.0)


def has(module):
    return importlib.util.find_spec(module) is not None


def is_closed(triangles):
    """Whether every directed edge is there once, and its reverse once."""
    directed = np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
    edges, counts = np.unique(directed, axis=0, return_counts=True)
    reversed_edges = np.unique(directed[:, ::-1], axis=0)
    return (counts == 1).all() and np.array_equal(edges, reversed_edges)


def quick(labels, **options):
    return tissuetessellation.mesh(labels, SPACING, ORIGIN, refinement=0, **options)


class MeshTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.image = make_tissue()
        cls.cells = np.setdiff1d(cls.image, [EXTERIOR])
        cls.tissue = tissuetessellation.mesh(cls.image, SPACING, ORIGIN)

    def test_every_cell_is_closed_and_has_its_volume(self):
        tissue = self.tissue
        self.assertEqual(tissue.exterior_label, EXTERIOR)
        np.testing.assert_array_equal(tissue.labels, self.cells)
        for label, volume in zip(tissue.labels, tissue.cells["Volume"]):
            surface = tissue.surface(label)
            self.assertTrue(is_closed(surface), label)
            self.assertAlmostEqual(signed_volume(tissue.points[surface]), volume, places=6)
            self.assertAlmostEqual(volume / ((self.image == label).sum() * np.prod(SPACING)), 1, delta=0.01)
        with self.assertRaisesRegex(ValueError, "no cell 5"):
            tissue.surface(5)

    def test_points_are_x_y_z_by_spacing_and_origin_of_z_y_x(self):
        low = np.array(ORIGIN)[::-1] + 1.0 * np.array(SPACING)[::-1]
        high = np.array(ORIGIN)[::-1] + 40.0 * np.array(SPACING)[::-1]
        self.assertTrue(((self.tissue.points > low) & (self.tissue.points < high)).all())

    def test_tables_have_a_row_for_each_cell_and_wall(self):
        cells, walls = self.tissue.cells, self.tissue.walls
        self.assertEqual({len(column) for column in cells.values()}, {27})
        self.assertEqual({column.ndim for column in [*cells.values(), *walls.values()]}, {1})
        self.assertTrue(cells["IsClosed"].all())
        self.assertEqual(cells["IsClosed"].dtype, bool)
        self.assertEqual(cells["Label"].dtype, np.int64)
        self.assertEqual(set(cells["Layer"]), set(range(1, cells["Layer"].max() + 1)))
        np.testing.assert_allclose(np.hypot(np.hypot(cells["MajorAxisX"], cells["MajorAxisY"]), cells["MajorAxisZ"]), 1)
        self.assertTrue(np.isnan(cells["MeanCurvature"][cells["Layer"] != 1]).all())
        self.assertEqual(len(walls["Area"]), self.tissue.report["walls"])
        for side in (0, 1):
            of_triangles = walls[f"Label{side}"][self.tissue.wall_ids]
            np.testing.assert_array_equal(of_triangles, self.tissue.boundary_labels[:, side])
        corners = self.tissue.points[self.tissue.triangles]
        areas = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1) / 2
        np.testing.assert_allclose(np.bincount(self.tissue.wall_ids, areas), walls["Area"])

    def test_report_and_remarks(self):
        report = self.tissue.report
        self.assertEqual(report["cells"], 27)
        self.assertEqual(report["cellsOfLayers"], np.bincount(self.tissue.cells["Layer"])[1:].tolist())
        self.assertEqual(report["crossingPairs"], 0)
        self.assertGreater(report["adjacency2"], 0.9)
        self.assertLess(report["meanVolumeError"], 0.001)
        self.assertGreaterEqual(report["minimumTriangleAngle"], 10)
        # A cell in another one, of labels that are no numbers from 1 on.
        image = np.where(self.image == 49, 2**40, self.image.astype(np.int64))
        center = np.argwhere(image == 2**40).mean(axis=0).round().astype(int)
        image[tuple(slice(c - 1, c + 2) for c in center)] = -9
        remarks = [remark for remark in quick(image).remarks if remark["reason"] == "enclosed"]
        self.assertEqual([remark["label"] for remark in remarks], [-9])
        self.assertEqual(remarks[0]["value"], 2**40)
        self.assertIn(str(2**40), remarks[0]["text"])

    def test_integers_of_all_types_and_layouts_give_the_same(self):
        expected = quick(self.image)
        for kind in "uint8 uint16 uint32 uint64 int8 int16 int32 int64 >u2 >i4 >i8".split():
            with self.subTest(type=kind):
                found = quick(self.image.astype(kind))
                np.testing.assert_array_equal(found.points, expected.points)
                np.testing.assert_array_equal(found.boundary_labels, expected.boundary_labels)
                self.assertEqual(found.boundary_labels.dtype, np.int64)
        layouts = {
            "strided": np.repeat(self.image, 2, axis=2)[:, :, ::2],
            "Fortran": np.asfortranarray(self.image),
            "reversed": self.image[::-1].copy()[::-1],
        }
        for name, image in layouts.items():
            with self.subTest(layout=name):
                np.testing.assert_array_equal(quick(image).points, expected.points)

    def test_large_and_negative_labels_come_back(self):
        places = np.searchsorted(self.cells, self.image)
        expected = quick(self.image)
        for low, step in ((-20, 1), (-(2**63), 2**50), (2**31, 2**40)):
            with self.subTest(low=low):
                labels = low + step * np.arange(len(self.cells))
                labels[labels == 0] = 999
                exterior = int(labels.max()) + 5
                image = np.where(self.image == EXTERIOR, exterior, np.sort(labels)[np.minimum(places, 26)])
                found = quick(image)
                np.testing.assert_array_equal(found.triangles, expected.triangles)
                np.testing.assert_array_equal(found.labels, np.sort(labels))
                self.assertEqual(found.exterior_label, exterior)

    def test_zero_is_exterior_unless_it_is_a_cell(self):
        image = np.where(self.image == EXTERIOR, 0, self.image.astype(int) - 60)  # -50, ..., 28
        image[image == 1] = 2
        found = quick(image)
        self.assertEqual(found.exterior_label, 0)
        self.assertEqual(found.labels[0], -50)
        crop = np.where(image[3:-3, 3:-3, 3:-3] == 28, 0, image[3:-3, 3:-3, 3:-3])
        self.assertNotIn(0, quick(crop).labels)
        with_zero = quick(crop, zero_is_cell=True)
        self.assertIn(0, with_zero.labels)
        self.assertTrue((np.diff(with_zero.labels) > 0).all())
        self.assertNotIn(with_zero.exterior_label, with_zero.labels)

    def test_exterior_and_dropped_labels_are_those_of_the_array(self):
        found = quick(self.image, exterior_label=EXTERIOR, drop_labels=[10, 13])
        np.testing.assert_array_equal(found.labels, np.setdiff1d(self.cells, [10, 13]))
        both = quick(self.image, exterior_label=(EXTERIOR, 10))
        np.testing.assert_array_equal(both.labels, np.setdiff1d(self.cells, [10]))
        with self.assertRaisesRegex(ValueError, "exterior label 8 is not a label of the image, which has 28 labels"):
            quick(self.image, exterior_label=8)
        with self.assertRaisesRegex(ValueError, "to be dropped 8"):
            quick(self.image, drop_labels=8)

    def test_what_is_no_label_image_is_refused(self):
        cases = (
            (self.image == 10, "mask"),
            (self.image.astype(float), "must be integers"),
            (self.image[0], "three axes"),
            (np.zeros((0, 4, 4), int), "no voxel"),
            (itk.image_from_array(self.image), "image of ITK"),
            (np.full((4, 4, 4), 2**63, np.uint64), "Label 9223372036854775808 is above the limit"),
        )
        for image, reason in cases:
            with self.subTest(reason=reason), self.assertRaisesRegex(ValueError, reason):
                tissuetessellation.mesh(image)
        with self.assertRaisesRegex(ValueError, "positive"):
            tissuetessellation.mesh(self.image, spacing=(1, 0, 1))
        with self.assertRaisesRegex(ValueError, "65536 labels"):
            tissuetessellation.mesh(np.arange(1, 65537).reshape(64, 32, 32))

    def test_errors_are_the_reasons_of_the_filters(self):
        with self.assertRaises(RuntimeError) as caught:
            tissuetessellation.mesh(np.full((4, 4, 4), 70), exterior_label=70)
        self.assertRegex(str(caught.exception), "^The image has no cell; the exterior label is 70$")
        with self.assertRaisesRegex(RuntimeError, "^[^/]*efinement is 4, must be in 0 .. 3"):
            tissuetessellation.mesh(self.image, refinement=4)
        with self.assertRaisesRegex(ValueError, "preset"):
            tissuetessellation.mesh(self.image, preset="fast")

    def test_options_reach_the_filter_and_their_defaults_are_documented(self):
        self.assertLess(quick(self.image).report["triangles"], self.tissue.report["triangles"])
        paper = tissuetessellation.mesh(self.image, preset="paper", number_of_cycles=1, seed=2, threads=1)
        self.assertEqual(paper.report["cells"], 27)
        source = itk.JunctionsToCellWallMeshFilter.New()
        for option, value in {
            "triangles_per_cell": source.GetTrianglesPerCell(),
            "refinement": source.GetRefinement(),
            "smoothing_iterations": source.GetSmoothingIterations(),
            "seed": source.GetSeed(),
        }.items():
            text = tissuetessellation.mesh.__doc__.split(option + " -- ")[1].split(" -- ")[0]
            self.assertIn(f"default {value:g}", text, option)
        source.UsePaperPreset()
        self.assertIn(f"default {source.GetNumberOfCycles()}", tissuetessellation.mesh.__doc__)

    def test_other_threads_run_meanwhile_and_progress_is_told(self):
        counts = {"meanwhile": 0}
        is_done = threading.Event()

        def count():
            while not is_done.wait(0.002):
                counts["meanwhile"] += 1

        steps = []
        thread = threading.Thread(target=count)
        thread.start()
        try:
            tissuetessellation.mesh(self.image, progress=lambda *step: steps.append((*step, counts["meanwhile"])))
        finally:
            is_done.set()
            thread.join()
        shares, phases, ticks = zip(*steps)
        self.assertEqual(list(shares), sorted(shares))
        self.assertIn("Finding junctions", phases)
        self.assertGreater(len(set(phases)), 2)
        # It counts between two reports of the filter, where Python does nothing else.
        self.assertGreater(max(np.diff(ticks)), 3)

    def test_an_error_in_progress_stops_the_work(self):
        steps = []

        def stop(share, phase):
            steps.append(share)
            if share > 0.35:
                raise KeyError("enough")

        with self.assertRaisesRegex(KeyError, "enough"):
            tissuetessellation.mesh(self.image, progress=stop)
        self.assertLess(steps[-1], 0.9)

    @unittest.skipUnless(has("vtkmodules"), "needs VTK")
    def test_vtk_has_all_arrays_and_reads_them_back(self):
        from vtkmodules.util.numpy_support import vtk_to_numpy
        from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLPolyDataWriter

        with tempfile.TemporaryDirectory() as folder:
            path = f"{folder}/walls.vtp"
            writer = vtkXMLPolyDataWriter()
            writer.SetFileName(path)
            writer.SetInputData(self.tissue.to_vtk())
            self.assertEqual(writer.Write(), 1)
            reader = vtkXMLPolyDataReader()
            reader.SetFileName(path)
            reader.Update()
        data = reader.GetOutput()
        triangles = vtk_to_numpy(data.GetPolys().GetConnectivityArray()).reshape(-1, 3)
        self.check_arrays(
            vtk_to_numpy(data.GetPoints().GetData()),
            triangles,
            lambda name: vtk_to_numpy(data.GetCellData().GetArray(name)),
            vtk_to_numpy(data.GetPointData().GetArray("NumberOfCells")),
        )
        self.assertEqual(data.GetCellData().GetScalars().GetName(), "Label")
        self.assertEqual(data.GetFieldData().GetAbstractArray("SPACE").GetValue(0), "LPS")

    @unittest.skipUnless(has("meshio"), "needs meshio")
    def test_meshio_has_all_arrays_and_reads_them_back(self):
        import meshio

        with tempfile.TemporaryDirectory() as folder:
            path = f"{folder}/walls.vtu"
            meshio.write(path, self.tissue.to_meshio())
            data = meshio.read(path)
        self.assertEqual([block.type for block in data.cells], ["triangle"])
        self.check_arrays(
            data.points, data.cells[0].data, lambda name: data.cell_data[name][0], data.point_data["NumberOfCells"]
        )

    def check_arrays(self, points, triangles, array, numbers_of_cells):
        np.testing.assert_array_equal(points, self.tissue.points)
        np.testing.assert_array_equal(triangles, self.tissue.triangles)
        np.testing.assert_array_equal(numbers_of_cells, self.tissue.numbers_of_cells)
        np.testing.assert_array_equal(array("BoundaryLabels"), self.tissue.boundary_labels)
        np.testing.assert_array_equal(array("Label"), array("Label0"))
        np.testing.assert_array_equal(array("WallId"), self.tissue.wall_ids)
        np.testing.assert_array_equal(array("WallArea"), self.tissue.walls["Area"][self.tissue.wall_ids])
        for label in self.tissue.labels:
            sides = array("BoundaryLabels") == label
            surface = np.concatenate([triangles[sides[:, 0]], triangles[sides[:, 1]][:, ::-1]])
            self.assertTrue(is_closed(surface), label)


class MeshPointsTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        grid = np.stack(np.meshgrid(*3 * [np.arange(3)], indexing="ij"), -1).reshape(-1, 3)
        cls.points = 1e6 + 12 * grid + np.random.default_rng(1).uniform(-2, 2, grid.shape)
        cls.labels = 1000 - 7 * np.arange(27)
        cls.tissue = tissuetessellation.mesh_points(cls.points, cls.labels, voxels_per_cell=500, refinement=0)

    def test_every_point_has_its_closed_cell_around_it(self):
        tissue = self.tissue
        np.testing.assert_array_equal(tissue.labels, np.sort(self.labels))
        self.assertEqual(tissue.exterior_label, 0)
        centers = np.stack([tissue.cells["Center" + axis] for axis in "XYZ"], -1)
        for point, label in zip(self.points, self.labels):
            self.assertTrue(is_closed(tissue.surface(label)))
            self.assertLess(np.linalg.norm(centers[tissue.labels == label][0] - point), 3)
            self.assertLess(np.linalg.norm(tissue.points[tissue.surface(label)].mean(axis=(0, 1)) - point), 6)

    def test_cells_are_cut_at_the_box(self):
        box = np.array([self.points.min(axis=0) - 1, self.points.max(axis=0) + 1])
        cut = tissuetessellation.mesh_points(self.points, box=box, voxels_per_cell=500, refinement=0)
        # Rounded edges bulge to keep their volume, by a voxel and a half.
        bulge = 1.5 * np.cbrt(cut.cells["ImageVolume"].mean() / 500)
        self.assertTrue(((cut.points > box[0] - bulge) & (cut.points < box[1] + bulge)).all())
        self.assertFalse(((self.tissue.points > box[0] - bulge) & (self.tissue.points < box[1] + bulge)).all())
        np.testing.assert_array_equal(cut.labels, np.arange(1, 28))

    def test_what_is_no_tissue_is_refused(self):
        refused = tissuetessellation.mesh_points
        with self.assertRaisesRegex(RuntimeError, "^[^/]*at least 4"):
            refused(self.points[:3])
        for reason, arguments in {
            "three columns": dict(points=self.points[:, :2]),
            "not finite": dict(points=np.where(self.points > 1e6 + 25, np.nan, self.points)),
            "must differ": dict(points=self.points, labels=np.zeros(27, int)),
            "one for each": dict(points=self.points, labels=[1, 2]),
            "layer": dict(points=self.points, layer="perhaps"),
            "corner": dict(points=self.points, box=[[1, 1, 1], [0, 0, 0]]),
        }.items():
            with self.subTest(reason=reason), self.assertRaisesRegex(ValueError, reason):
                refused(**arguments)


if __name__ == "__main__":
    unittest.main()
