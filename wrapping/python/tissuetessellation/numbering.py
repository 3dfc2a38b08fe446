# Copyright The TissueTessellation contributors
# SPDX-License-Identifier: Apache-2.0
"""Labels of any integer type as the consecutive numbers that ITK's wrapped images hold, and back."""
import numpy as np

# Ranges of labels up to this are looked up in a table, others are sorted.
_LARGEST_TABLE = 2**24
_LARGEST_LABEL = np.iinfo(np.int64).max


def check_labels(labels):
    """The label image as an array of integers with three axes. Raises ValueError."""
    if hasattr(labels, "GetSpacing"):
        raise ValueError(
            "labels are an image of ITK, whose place would be lost: pass itk.array_from_image(image), with its spacing "
            "and origin"
        )
    array = np.asarray(labels)
    if array.dtype == bool:
        raise ValueError(
            "labels are True and False, a mask: number its pieces first, as scipy.ndimage.label() or "
            "skimage.measure.label() does"
        )
    if array.dtype.kind not in "iu":
        raise ValueError(f"labels are {array.dtype}, must be integers: labels.astype(np.int64), if they are whole")
    if array.ndim != 3:
        raise ValueError(f"labels have the shape {array.shape}, must have three axes: z, y, x")
    if array.size == 0:
        raise ValueError(f"labels have the shape {array.shape}: there is no voxel")
    if int(array.max()) > _LARGEST_LABEL:
        raise ValueError(f"Label {array.max()} is above the limit of {_LARGEST_LABEL}")
    return array


def find_free_label(labels):
    """The greatest negative label that is none of those, which ascend: for an exterior that has none of its own."""
    negative = labels[labels < 0][::-1]
    taken = negative == -1 - np.arange(len(negative))
    return -1 - (len(taken) if taken.all() else int(np.argmin(taken)))


class Numbering:
    """The labels of an image, numbered in their order.

    Number 0 is label 0, the background, whether the image has it or not; where 0 is a cell like others it has a number
    like others, and no voxel has the number 0. `labels` are those of the numbers from 0 on (int64).
    """

    def __init__(self, array, zero_is_cell=False):
        low, high = int(array.min()), int(array.max())
        self._low = low
        self._table = None
        if high - low < _LARGEST_TABLE:
            is_there = np.zeros(high - low + 1, dtype=bool)
            for plane in array:
                is_there[self._offsets(plane)] = True
            found = low + np.flatnonzero(is_there)
        else:
            found = np.unique(np.concatenate([np.unique(plane.astype(np.int64)) for plane in array]))
        self._present = found.astype(np.int64)
        first = find_free_label(self._present) if zero_is_cell else 0
        self.labels = np.concatenate([[first], self._present if zero_is_cell else self._present[self._present != 0]])
        self.labels = self.labels.astype(np.int64)
        # Of the labels that are there, in their order.
        self._numbers = np.arange(1, len(self._present) + 1)
        if not zero_is_cell:
            self._numbers -= np.cumsum(self._present == 0)
            self._numbers[self._present == 0] = 0
        if high - low < _LARGEST_TABLE:
            self._table = np.zeros(high - low + 1, dtype=np.int64)
            self._table[self._present - low] = self._numbers

    def _offsets(self, plane):
        return plane.astype(np.int64) - self._low

    def number_of(self, label, what):
        """The number of a label, which must be there. \"what\" is said of it otherwise (ValueError)."""
        place = np.searchsorted(self._present, label)
        if place == len(self._present) or self._present[place] != label:
            others = np.count_nonzero(self._present != 0)
            raise ValueError(f"{what} {label} is not a label of the image, which has {others} labels other than 0")
        return int(self._numbers[place])

    def apply(self, array, dtype):
        """The image by numbers, contiguous."""
        numbers = np.empty(array.shape, dtype=dtype)
        for plane, result in zip(array, numbers):
            if self._table is not None:
                result[...] = self._table[self._offsets(plane)]
            else:
                result[...] = self._numbers[np.searchsorted(self._present, plane.astype(np.int64))]
        return numbers

    def label_of(self, number):
        """The label of a number; of one that is no label's, which stands for the exterior, a label that no cell has."""
        return int(self.labels[number]) if 0 <= number < len(self.labels) else find_free_label(self._present)
