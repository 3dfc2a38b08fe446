#!/usr/bin/python3
"""NucleiDetection beside scikit-image's blob_dog, on the same images and scales in one run.

    compare_blob_dog.py build/bin image.mha points.csv MINIMUM_SCALE MAXIMUM_SCALE [--innerOnly] [--repeats 3]
    compare_blob_dog.py build/bin --synthetic [--signalToNoise 5]

points.csv has the true nuclei: x, y, z (or x_..., in the image's units), and radius, or voxels. A blob is true if it
is within the radius of a nucleus that has no nearer one; F1 = 2 true / (blobs + nuclei). `--innerOnly` leaves out
the nuclei that the column touches_border marks, and the blobs within them. Of blob_dog the best F1 of 12 thresholds
counts, of NucleiDetection the default's and its best, and what it finds without any option. Times are medians of wall-clock seconds: the program's with its
start, reading and writing on two threads, and blob_dog's alone.

Needs python3-skimage and python3-numpy. ITK's MetaImage (.mha), local, raw or zlib, is all that this script reads."""
import argparse
import csv
import pathlib
import statistics
import subprocess
import tempfile
import time
import zlib

import numpy as np
from scipy.spatial import cKDTree
from skimage.feature import blob_dog

TYPES = {"MET_UCHAR": "u1", "MET_USHORT": "<u2", "MET_SHORT": "<i2", "MET_FLOAT": "<f4"}


def read_image(path):
    """Voxels, by z, y, x, and spacing, by x, y, z."""
    content = pathlib.Path(path).read_bytes()
    marker = b"ElementDataFile = LOCAL\n"
    end = content.index(marker) + len(marker)
    header = dict(line.split(" = ", 1) for line in content[:end].decode().splitlines())
    voxels = content[end:]
    if header.get("CompressedData") == "True":
        voxels = zlib.decompress(voxels)
    shape = [int(n) for n in header["DimSize"].split()][::-1]
    image = np.frombuffer(voxels, TYPES[header["ElementType"]]).reshape(shape)
    return image, np.array([float(x) for x in header["ElementSpacing"].split()])


def read_nuclei(path, spacing):
    """Positions, radii, and whether the border cuts them."""
    with open(path, newline="") as stream:
        rows = list(csv.DictReader(stream))
    names = [next(n for n in rows[0] if n == axis or n.startswith(axis + "_")) for axis in "xyz"]
    positions = np.array([[float(row[n]) for n in names] for row in rows])
    if "radius" in rows[0]:
        radii = np.array([float(row["radius"]) for row in rows])
    else:
        radii = np.cbrt(np.array([float(row["voxels"]) for row in rows]) * spacing.prod() * 3 / (4 * np.pi))
    cut = np.array([float(row.get("touches_border", 0)) for row in rows]) > 0
    return positions, radii, cut


class Judge:
    def __init__(self, nuclei, inner_only, spacing):
        self.positions, self.radii, self.cut = nuclei
        self.inner_only = inner_only
        self.voxel = np.cbrt(spacing.prod())

    def __call__(self, blobs):
        """F1 and the mean distance of true blobs from their nuclei, in voxels."""
        positions, radii = self.positions, self.radii
        if self.inner_only:
            if len(blobs):
                distance, nearest = cKDTree(positions).query(blobs)
                blobs = blobs[~(self.cut[nearest] & (distance <= radii[nearest]))]
            positions, radii = positions[~self.cut], radii[~self.cut]
        if len(blobs) == 0:
            return 0.0, float("nan")
        pairs = []
        for nucleus, near in enumerate(cKDTree(blobs).query_ball_point(positions, radii)):
            pairs += [(np.linalg.norm(blobs[b] - positions[nucleus]), nucleus, b) for b in near]
        taken, used, errors = set(), set(), []
        for distance, nucleus, blob in sorted(pairs):
            if nucleus not in taken and blob not in used:
                taken.add(nucleus)
                used.add(blob)
                errors.append(distance / self.voxel)
        return 2 * len(errors) / (len(blobs) + len(positions)), float(np.mean(errors)) if errors else float("nan")


def run_program(binaries, image, scales, options=()):
    """Blobs by falling response, their responses, and seconds; `scales` None: found from the image."""
    with tempfile.TemporaryDirectory() as folder:
        points = pathlib.Path(folder) / "points.csv"
        start = time.perf_counter()
        if scales is not None:
            options = [*options, "--minimumScale", str(scales[0]), "--maximumScale", str(scales[1])]
        subprocess.run([binaries / "NucleiDetection", image, points, "--threads", "2", "--quiet", *options], check=True)
        seconds = time.perf_counter() - start
        with open(points, newline="") as stream:
            rows = list(csv.DictReader(stream))
    return (np.array([[float(row[axis]) for axis in "xyz"] for row in rows]).reshape(-1, 3),
            np.array([float(row["response"]) for row in rows]), seconds)


def run_blob_dog(voxels, spacing, scales, threshold):
    start = time.perf_counter()
    found = blob_dog(voxels, min_sigma=scales[0] / spacing[::-1], max_sigma=scales[1] / spacing[::-1],
                     sigma_ratio=2**0.25, threshold=threshold, overlap=0.5)
    return found[:, 2::-1] * spacing, time.perf_counter() - start


def compare(binaries, image, points, scales, inner_only, repeats):
    voxels, spacing = read_image(image)
    voxels = voxels.astype(float)
    judge = Judge(read_nuclei(points, spacing), inner_only, spacing)
    blobs, _, seconds = run_program(binaries, image, None)
    f1, error = judge(blobs)
    print(f"NucleiDetection  F1 {f1:.3f} ({len(blobs)} blobs), without options; error {error:.2f} voxels; {seconds:.2f} s")
    blobs, _, _ = run_program(binaries, image, scales)
    f1, error = judge(blobs)
    every, responses, _ = run_program(binaries, image, scales, ["--relativeThreshold", "0.001"])
    best = max((judge(every[responses >= r])[0] for r in responses), default=0.0)
    ours = statistics.median(run_program(binaries, image, scales)[2] for _ in range(repeats))
    print(f"NucleiDetection  F1 {f1:.3f} ({len(blobs)} blobs), best threshold {best:.3f}; "
          f"error {error:.2f} voxels; {ours:.2f} s")
    # The difference that blob_dog takes is not divided by the step's logarithm.
    top = responses.max() * np.log(2**0.25) if len(responses) else 1.0
    tried = []
    for threshold in np.geomspace(0.1, 0.7, 12) * top:
        found, seconds = run_blob_dog(voxels, spacing, scales, threshold)
        tried.append((*judge(found), len(found), seconds))
    f1, error, number, _ = max(tried)
    theirs = statistics.median(row[3] for row in tried)
    print(f"blob_dog         best F1 {f1:.3f} ({number} blobs); error {error:.2f} voxels; {theirs:.2f} s, "
          f"{theirs / ours:.1f} times as long")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("binaries", type=pathlib.Path)
    parser.add_argument("image", nargs="?")
    parser.add_argument("points", nargs="?")
    parser.add_argument("scales", nargs="*", type=float)
    parser.add_argument("--innerOnly", action="store_true")
    parser.add_argument("--synthetic", action="store_true")
    parser.add_argument("--signalToNoise", type=float, default=5)
    parser.add_argument("--repeats", type=int, default=3)
    arguments = parser.parse_args()
    if not arguments.synthetic:
        if len(arguments.scales) != 2:
            parser.error("an image needs its points and two scales")
        compare(arguments.binaries, arguments.image, arguments.points, arguments.scales, arguments.innerOnly,
                arguments.repeats)
        return
    with tempfile.TemporaryDirectory() as folder:
        for shape, model, seed in (("dome", "anisotropic", 0), ("flower", "division", 1)):
            files = [str(pathlib.Path(folder) / name) for name in ("labels.mha", "nuclei.mha", "nuclei.csv")]
            subprocess.run([arguments.binaries / "SyntheticTissue", files[0], "--size", "120", "120", "44", "--spacing", "0.5",
                            "0.5", "1.5", "--cells", "120", "--shape", shape, "--model", model, "--seed", str(seed),
                            "--nuclei", files[1], "--nucleiPoints", files[2], "--signalToNoise",
                            str(arguments.signalToNoise), "--quiet"], check=True)
            print(f"{shape}, {model}, signal to noise {arguments.signalToNoise:g}")
            compare(arguments.binaries, files[1], files[2], (0.8, 3.0), False, arguments.repeats)


if __name__ == "__main__":
    main()
