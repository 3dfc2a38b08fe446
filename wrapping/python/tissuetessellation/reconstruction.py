# Copyright The TissueTessellation contributors
# SPDX-License-Identifier: Apache-2.0
"""From label images and points to meshes."""
import re
from contextlib import contextmanager

import itk
import numpy as np

from .collecting import collect
from .numbering import Numbering, check_labels, find_free_label

_OPTIONS = """    triangles_per_cell -- of the fitted walls, each counted once, 40 .. 10000; default 150.
    refinement -- times that the triangles of the star-shaped walls are split in four, 0 .. 3; default 1. At 0, fitted
        walls are the fitted stars, of few triangles.
    threads -- how many; default: as many as there are processors. The mesh is the same for any number.
    progress -- called with the share done, 0 .. 1, and a few words for what is being done; what it raises stops
        the work and is passed on.

    The options of the C++ filter that are left out (None) are at its defaults. Other threads of Python run meanwhile.
    What the C++ filters refuse is a RuntimeError, what is refused here a ValueError, with their reasons.
    """

_PIXEL_TYPES = ((np.uint16, "US"), (np.uint32, "UI"), (np.uint64, "UL"), (np.uint8, "UC"))
_LAYERS = {"automatic": "Layer_Automatic", "on": "Layer_On", "off": "Layer_Off"}


def _documented(function):
    function.__doc__ += _OPTIONS
    return function


def _choose_pixel_type(largest):
    """The type of NumPy, and of ITK, of images with numbers up to the largest that the filters are wrapped for."""
    limits = []
    for dtype, name in _PIXEL_TYPES:
        try:
            image_type = itk.Image[getattr(itk, name), 3]
            itk.LabelImageToCellWallMeshFilter[image_type]
        except (KeyError, TypeError):
            continue
        limits.append(np.iinfo(dtype).max)
        if largest <= limits[-1]:
            return dtype, image_type
    raise ValueError(
        f"There are {largest} labels, but ITK's Python is built for images of up to {max(limits, default=0)}: "
        "ITK_WRAP_unsigned_long=ON builds it for more"
    )


@contextmanager
def _reasons(label_of):
    """ITK's errors become their reasons alone, with labels for numbers."""
    try:
        yield
    except RuntimeError as error:
        reason = re.sub(r"(?s)^.*ITK ERROR: \w+\(0x[0-9a-f]+\): ", "", str(error)).strip()
        reason = re.sub(r"(\blabel(?: is)? )(-?\d+)", lambda m: m[1] + str(label_of(int(m[2]))), reason, flags=re.I)
        raise RuntimeError(reason) from None


def _run(source, progress, phase=None):
    """Updates the filter; it tells its phase where none is given. What progress() raises aborts it and is raised."""
    if progress is None:
        source.UpdateLargestPossibleRegion()
        return
    raised = []

    def report():
        try:
            progress(source.GetProgress(), phase or source.GetPhase())
        except BaseException as error:  # An interrupt, too, must not get into ITK.
            raised.append(error)
            source.AbortGenerateDataOn()

    tag = source.AddObserver(itk.ProgressEvent(), report)
    try:
        source.UpdateLargestPossibleRegion()
    except RuntimeError:
        if not raised:
            raise
    finally:
        source.RemoveObserver(tag)
    if raised:
        raise raised[0]


def _set_options(source, options):
    """The options of the C++ filter by their names."""
    preset = options.pop("preset")
    if preset not in ("default", "paper"):
        raise ValueError(f'preset is {preset!r}, must be "default" or "paper"')
    if preset == "paper":
        source.UsePaperPreset()
    for name, value in options.items():
        if value is not None:
            method = "NumberOfWorkUnits" if name == "threads" else name.title().replace("_", "")
            getattr(source, "Set" + method)(value)


def _make_image(numbers, image_type, spacing, origin):
    """An ITK image that views the array. Spacing and origin are z, y, x."""
    image = itk.image_view_from_array(numbers, ttype=image_type)
    for name, values, setter in (("spacing", spacing, image.SetSpacing), ("origin", origin, image.SetOrigin)):
        values = np.asarray(values, dtype=float)
        kind = "positive " if name == "spacing" else ""
        if values.shape != (3,) or not np.isfinite(values).all() or (kind and not (values > 0).all()):
            raise ValueError(f"{name} is {values.tolist()}, must be {kind}numbers for z, y, x")
        setter(values[::-1].tolist())
    return image


def _as_labels(labels):
    """One label or several."""
    return [int(label) for label in np.atleast_1d(np.asarray(labels, dtype=np.int64))]


def _set_exterior(source, numbering, exterior_label, zero_is_cell, drop_labels, drop_suspects):
    for label in [] if exterior_label is None else _as_labels(exterior_label):
        source.AddExteriorLabel(numbering.number_of(label, "The exterior label"))
    for label in _as_labels(drop_labels):
        source.AddDroppedLabel(numbering.number_of(label, "The label to be dropped"))
    source.SetZeroIsCell(zero_is_cell)
    source.SetDropSuspects(drop_suspects)


@_documented
def mesh(
    labels,
    spacing=(1.0, 1.0, 1.0),
    origin=(0.0, 0.0, 0.0),
    exterior_label=None,
    *,
    zero_is_cell=False,
    drop_labels=(),
    drop_suspects=False,
    preset="default",
    smoothing_iterations=None,
    maximum_edge_length=None,
    number_of_cycles=None,
    seed=None,
    triangles_per_cell=None,
    refinement=None,
    threads=None,
    progress=None,
):
    """The mesh of all cell walls of a label image, a TissueMesh.

    labels -- array (z, y, x) of any integer type, a label for each cell and one for the exterior; labels may have gaps
        and be negative, up to 2^63 - 1. The array stays as it is.
    spacing -- size of a voxel along z, y, x.
    origin -- physical position of the centre of the first voxel, z, y, x. (Results are x, y, z.)
    exterior_label -- label of the exterior, or several; default: found in the image. The outside of the image and,
        unless it is a cell, 0 are exterior, too.
    zero_is_cell -- 0 is a cell like others.
    drop_labels -- labels that are no cells, and join the exterior.
    drop_suspects -- drop all labels that by size, place and pieces are suspected to be no cells.
    preset -- "default": the complex comes from the image and the walls are fitted to it; "paper": the method of Cerutti
        et al. 2015 to the letter, a complex of the cells' centres.
    smoothing_iterations -- of walls that are not fitted, 0 .. 10000; default 10.
    maximum_edge_length -- preset "paper": surface triangles with a longer edge are removed in the clean-up; in the
        units of the points; default 0: from the distances of neighbouring cells.
    number_of_cycles -- preset "paper": temperature cycles of the annealing, 0 .. 1000; default 5.
    seed -- preset "paper": of the annealing; default 1.
"""
    array = check_labels(labels)
    numbering = Numbering(array, zero_is_cell)
    dtype, image_type = _choose_pixel_type(len(numbering.labels) - 1)
    source = itk.LabelImageToCellWallMeshFilter[image_type].New()
    # The image views the array, which lives as long as this function.
    numbers = numbering.apply(array, dtype)
    source.SetInput(_make_image(numbers, image_type, spacing, origin))
    with _reasons(numbering.label_of):
        _set_exterior(source, numbering, exterior_label, zero_is_cell, drop_labels, drop_suspects)
        _set_options(
            source,
            {
                "preset": preset,
                "triangles_per_cell": triangles_per_cell,
                "refinement": refinement,
                "smoothing_iterations": smoothing_iterations,
                "maximum_edge_length": maximum_edge_length,
                "number_of_cycles": number_of_cycles,
                "seed": seed,
                "threads": threads,
            },
        )
        _run(source, progress)
        return collect(source.GetOutput(), numbering.label_of)


def _check_points(points):
    array = np.asarray(points, dtype=float)
    if array.ndim != 2 or array.shape[1] != 3:
        raise ValueError(f"points have the shape {array.shape}, must have three columns: x, y, z")
    if not np.isfinite(array).all():
        raise ValueError(f"point {np.flatnonzero(~np.isfinite(array).all(axis=1))[0]} is not finite")
    return array


def _check_point_labels(labels, number_of_points):
    """Those of the points; by default from 1 on. 0 is the exterior's."""
    if labels is None:
        return np.arange(1, number_of_points + 1)
    array = np.asarray(labels)
    if array.shape != (number_of_points,) or array.dtype.kind not in "iu":
        raise ValueError(f"labels are {array.dtype} of shape {array.shape}, must be integers, one for each point")
    if len(np.unique(array)) != len(array) or (array == 0).any():
        raise ValueError("labels of points must differ, and 0 is the exterior's")
    return array.astype(np.int64)


def _make_box(box, offset):
    """A reference image of one voxel that fills the box."""
    lower, upper = np.asarray(box, dtype=float) - offset
    if not (upper > lower).all():
        raise ValueError(f"box is {box}, must be its lower and its upper corner, x, y, z")
    image = itk.Image[itk.US, 3].New()
    image.SetRegions([1, 1, 1])
    image.Allocate(True)
    image.SetSpacing((upper - lower).tolist())
    image.SetOrigin((0.5 * (lower + upper)).tolist())
    return image


def _estimate_tissue(positions, box, layer, voxels_per_cell, threads, progress):
    """The updated filter from points to the label image of their tissue. box -- a reference image or None."""
    points = itk.PointSet[itk.F, 3].New()
    for i, position in enumerate(positions.tolist()):
        points.SetPoint(i, position)
    _, image_type = _choose_pixel_type(len(positions))
    tissue = itk.PointSetToTissueLabelImageFilter[type(points), image_type].New()
    tissue.SetInput(points)
    if box is not None:
        tissue.SetReferenceImage(box)
    tissue.SetLayer(getattr(itk.PointTissueEnums, _LAYERS[layer]))
    tissue.SetVoxelsPerCell(voxels_per_cell)
    if threads is not None:
        tissue.SetNumberOfWorkUnits(threads)
    _run(tissue, progress, "Fitting cells to the points")
    return tissue


@_documented
def mesh_points(
    points,
    labels=None,
    *,
    box=None,
    layer="automatic",
    voxels_per_cell=4000.0,
    triangles_per_cell=None,
    refinement=None,
    threads=None,
    progress=None,
):
    """The mesh of all cell walls of the tissue that is estimated from its cells' centres alone, a TissueMesh.

    points -- (n, 3), x, y, z: at least four centres of cells or nuclei. They are read to seven digits of their extent.
    labels -- of the points' cells, integers other than 0; default: 1, 2, 3, ...
    box -- the box that the points were seen in, its lower and its upper corner, ((x, y, z), (x, y, z)), at which cells
        are cut; default: beyond all points.
    layer -- "on": the tissue is one layer of cells, a sheet or a shell; "off": it is not; "automatic": as points lie.
    voxels_per_cell -- about as many has the mean cell in the label image that is made, at least 50; default 4000.
"""
    array = _check_points(points)
    cell_labels = _check_point_labels(labels, len(array))
    if layer not in _LAYERS:
        raise ValueError(f"layer is {layer!r}, must be one of {', '.join(_LAYERS)}")
    # ITK's points are of single precision: about the middle they are as exact as can be. Cells go by ascending labels.
    offset = np.round(array.mean(axis=0)) if len(array) else np.zeros(3)
    order = np.argsort(cell_labels)
    numbering = np.concatenate([[0], cell_labels[order]])

    def label_of(number):
        return int(numbering[number]) if 0 <= number < len(numbering) else find_free_label(np.sort(cell_labels))

    reference = None if box is None else _make_box(box, offset)
    with _reasons(label_of):
        tissue = _estimate_tissue(array[order] - offset, reference, layer, voxels_per_cell, threads, progress)
        image = tissue.GetOutput()
        source = itk.LabelImageToCellWallMeshFilter[type(image)].New()
        source.SetInput(image)
        source.SetVotes(tissue.GetVotes())
        if (itk.array_view_from_image(image) == 0).any():
            source.SetExteriorLabel(0)
        _set_options(
            source,
            {
                "preset": "default",
                "triangles_per_cell": triangles_per_cell,
                "refinement": refinement,
                "threads": threads,
            },
        )
        _run(source, progress)
        return collect(source.GetOutput(), label_of, offset)
