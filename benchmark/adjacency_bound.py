#!/usr/bin/python3
"""The best adjacency4 that any valid adjacency complex can reach on a label image, beside what the program reaches.

The quadruples of cells that meet in an image are no complex: a block of five cells holds five quadruples, of which a
complex can keep some. An integer programme (HiGHS, through scipy.optimize.milp) proves how many.

In general two cells may have several edges, and four cells several tetrahedra, as they may meet at several places. The
image's quadruples then count as often as they have places (NumberOfClusters of --junctions), and so do the tetrahedra:

    maximize  sum min(x, p) / sum max(x, p)  over the numbers x of tetrahedra of each four cells, p being those of places

In any closed complex, of whatever topology, each triangle is in two tetrahedra, so that each three cells are in an even
number of them. The programme asks for that of the triples of the image's quadruples alone. Tetrahedra that the image has
not, or not so often, are counted, not enumerated: each may be at four triples. What is proven is an upper bound: not all
that fulfils this is a complex.

With --simplicial, for the complexes of --preset paper, four cells have one tetrahedron at most, and the tetrahedra are a set, as the quadruples are:

    maximize  |T & S| / |T | S|   over the sets T of tetrahedra that fulfil what every simplicial complex does:

- every triangle is in none or in two, every cell in four at least;
- the link of a cell, or of the exterior, is a sphere: with n neighbours a cell is in 2 n - 4 tetrahedra;
- the edges at any set of cells are four for each cell at least, because the graph of a closed 3-manifold is rigid in four
  dimensions (Kalai 1987, doi:10.1007/BF01405094; Fogelsanger 1988). It is asked of the sets of cells with few quadruples:
  cells cut by the border of the image, with less than four neighbours, for which a complex needs false tetrahedra.

Tetrahedra outside of S with two or more triangles of S are enumerated; the others ("remote" ones), which cannot close more
than one triangle of S each, enter by their numbers alone, and so do the edges that they alone have. The ratio is maximized
by Dinkelbach's method.

    adjacency_bound.py build/bin/TissueTessellation labels.mha [--simplicial] [--seeds 5] [--timeLimit 300]
        [-- OPTIONS OF THE PROGRAM]

Needs python3-numpy, python3-scipy and python3-vtk9.
"""

import argparse
import collections
import csv
import itertools
import json
import pathlib
import subprocess
import sys
import tempfile

import numpy as np
from scipy.optimize import Bounds, LinearConstraint, milp
from scipy.sparse import coo_matrix
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader


def read_tetrahedra(path):
    """How many tetrahedra of the complex each four labels have."""
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(path))
    reader.Update()
    labels = vtk_to_numpy(reader.GetOutput().GetCellData().GetArray("Labels"))
    return collections.Counter(tuple(sorted(map(int, row))) for row in labels)


def run_program(program, image, options):
    """The number of places of each quadruple of labels that meets in the image, all labels, the number of tetrahedra of
    each quadruple in the complex, and the program's report."""
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder)
        subprocess.run(
            [program, image, path / "walls.vtp", "--junctions", path / "junctions.csv", "--report", path / "report.json",
             "--statistics", path / "cells.csv", "--complex", path / "complex.vtu", "--refinement", "0",
             "--quiet", *options],
            check=True,
        )
        places = collections.Counter()
        with open(path / "junctions.csv", newline="", encoding="ascii") as file:
            for row in csv.DictReader(file):
                places[tuple(sorted(int(row[f"Label{i}"]) for i in range(4)))] += int(row["NumberOfClusters"])
        with open(path / "cells.csv", newline="", encoding="ascii") as file:
            labels = [int(row["Label"]) for row in csv.DictReader(file)]
        report = json.loads((path / "report.json").read_text(encoding="utf-8"))
        return places, labels, read_tetrahedra(path / "complex.vtu"), report


def jaccard(first, second):
    """Of two multisets."""
    return sum((first & second).values()) / sum((first | second).values())


def triangles_of(tetrahedron):
    return itertools.combinations(tetrahedron, 3)


def enumerate_others(reference):
    """Tetrahedra outside of the reference that have two of its triangles: those share an edge."""
    opposite = {}
    for quadruple in reference:
        for edge in itertools.combinations(quadruple, 2):
            opposite.setdefault(edge, set()).update(v for v in quadruple if v not in edge)
    known = set(reference)
    others = set()
    reference_triangles = {t for quadruple in reference for t in triangles_of(quadruple)}
    for edge, vertices in opposite.items():
        joined = [v for v in vertices if tuple(sorted((*edge, v))) in reference_triangles]
        for a, b in itertools.combinations(sorted(joined), 2):
            others.add(tuple(sorted((*edge, a, b))))
    return sorted(others - known), reference_triangles


class Programme:
    """Rows and columns of an integer programme. All columns are whole numbers, from 0 to `upper`. The first `hits` of them
    count tetrahedra that the image has, of which it has `size`; the columns `misses` count others."""

    def __init__(self):
        self.entries, self.low, self.high = [], [], []

    def add_row(self, terms, least, most):
        self.entries.extend((len(self.low), column, value) for column, value in terms)
        self.low.append(least)
        self.high.append(most)

    def solve(self, ratio, time_limit):
        """Maximizes hits - ratio * misses."""
        cost = np.zeros(len(self.upper))
        cost[: self.hits] = -1.0
        cost[self.misses] = ratio
        row, column, value = zip(*self.entries)
        matrix = coo_matrix((value, (row, column)), shape=(len(self.low), len(self.upper))).tocsr()
        return milp(cost, constraints=LinearConstraint(matrix, self.low, self.high), bounds=Bounds(0, self.upper),
                    integrality=np.ones(len(self.upper)), options={"time_limit": time_limit, "mip_rel_gap": 1e-5})


class GeneralProgramme(Programme):
    """Columns: for each quadruple its tetrahedra, as many as it has places at most; for each triple half its tetrahedra,
    and whether another one is at it; the number of other tetrahedra."""

    def __init__(self, places):
        super().__init__()
        self.size, self.hits = sum(places.values()), len(places)
        triples = {}
        for column, quadruple in enumerate(places):
            for triple in triangles_of(quadruple):
                triples.setdefault(triple, []).append(column)
        n, m = len(places), len(triples)
        others = n + 2 * m
        self.misses = [others]
        self.upper = np.concatenate([list(places.values()), np.full(m, np.inf), np.ones(m), [np.inf]])
        for i, members in enumerate(triples.values()):
            self.add_row([(c, 1) for c in members] + [(n + i, -2), (n + m + i, 1)], 0, 0)
        self.add_row([(others, 4)] + [(n + m + i, -1) for i in range(m)], 0, np.inf)


class SimplicialProgramme(Programme):
    """Columns: the tetrahedra (reference, others); for each triangle half its tetrahedra and its remote ones; for each
    cell its remote tetrahedra and remote edges; each edge of a tetrahedron that is a column; the numbers of remote
    tetrahedra and of remote edges."""

    def __init__(self, reference, labels):
        super().__init__()
        others, reference_triangles = enumerate_others(reference)
        self.tetrahedra = reference + others
        triangles, self.edges = {}, {}
        cells = {label: [] for label in labels}
        for column, tetrahedron in enumerate(self.tetrahedra):
            for triangle in triangles_of(tetrahedron):
                triangles.setdefault(triangle, []).append(column)
            for edge in itertools.combinations(tetrahedron, 2):
                self.edges.setdefault(edge, []).append(column)
            for cell in tetrahedron:
                cells[cell].append(column)
        n, m, k = len(self.tetrahedra), len(triangles), len(cells)
        half, remote_at_triangle, remote_at_cell = n, n + m, n + 2 * m
        edges_at_cell, self.first_edge = remote_at_cell + k, remote_at_cell + 2 * k
        self.remote_tetrahedra = self.first_edge + len(self.edges)
        self.remote_edges = self.remote_tetrahedra + 1
        self.upper = np.full(self.remote_edges + 1, np.inf)
        self.upper[: n + 2 * m] = 1
        self.upper[self.first_edge : self.remote_tetrahedra] = 1
        self.size = self.hits = len(reference)
        self.misses = [*range(self.hits, n), self.remote_tetrahedra]

        for i, members in enumerate(triangles.values()):
            self.add_row([(c, 1) for c in members] + [(half + i, -2), (remote_at_triangle + i, 1)], 0, 0)
        links = {cell: [] for cell in cells}
        for i, (edge, members) in enumerate(self.edges.items()):
            for column in members:
                self.add_row([(self.first_edge + i, 1), (column, -1)], 0, np.inf)
            for cell in edge:
                links[cell].append((self.first_edge + i, -2))
        for i, (cell, members) in enumerate(cells.items()):
            star = [(c, 1) for c in members] + [(remote_at_cell + i, 1)]
            self.add_row(star, 4, np.inf)
            self.add_row(star + links[cell] + [(edges_at_cell + i, -2)], -4, -4)
        inside = [remote_at_triangle + i for i, t in enumerate(triangles) if t in reference_triangles]
        outside = [remote_at_triangle + i for i, t in enumerate(triangles) if t not in reference_triangles]
        self.add_row([(self.remote_tetrahedra, 1)] + [(c, -1) for c in inside], 0, np.inf)
        self.add_row([(self.remote_tetrahedra, 4)] + [(c, -1) for c in outside], 0, np.inf)
        self.add_row([(self.remote_tetrahedra, 4)] + [(remote_at_cell + i, -1) for i in range(k)], 0, 0)
        self.add_row([(self.remote_edges, 2)] + [(edges_at_cell + i, -1) for i in range(k)], 0, 0)
        for most in range(1, 8):
            self.add_rigidity([cell for cell, members in cells.items() if sum(c < len(reference) for c in members) <= most])

    def add_rigidity(self, cells):
        """At least four edges for each of a set of cells, every edge counted once."""
        chosen = set(cells)
        terms = [(self.first_edge + i, 1) for i, edge in enumerate(self.edges) if chosen & set(edge)]
        self.add_row(terms + [(self.remote_edges, 1)], 4 * len(chosen), np.inf)


def prove_bound(programme, reached, time_limit):
    """An upper bound of the ratio, of which `reached` is a value that a complex has."""
    ratio, bound = reached, 1.0
    for _ in range(5):
        result = programme.solve(ratio, time_limit)
        if result.mip_dual_bound is None:
            raise RuntimeError(f"HiGHS proved nothing in {time_limit} s: {result.message}")
        # hits <= D + ratio missed, so that hits / (size + missed) is at most the larger one of D / size and the ratio.
        bound = min(bound, max(-result.mip_dual_bound / programme.size, ratio))
        if result.x is None:
            break
        hits = round(result.x[: programme.hits].sum())
        found = hits / (programme.size + round(result.x[programme.misses].sum()))
        if found < ratio + 1e-6:
            break
        ratio = found
    return bound


def main():
    arguments = sys.argv[1:]
    options = []
    if "--" in arguments:
        split = arguments.index("--")
        arguments, options = arguments[:split], arguments[split + 1 :]
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("image", nargs="+")
    parser.add_argument("--simplicial", action="store_true", help="of simplicial complexes alone, as --preset paper makes them")
    parser.add_argument("--seeds", type=int, default=5)
    parser.add_argument("--timeLimit", type=float, default=300.0, help="seconds for each solution of the programme")
    chosen = parser.parse_args(arguments)
    print(f"{'image':32} {'quadruples':>10} {'bound':>8} {'ours':>8} {'lowest':>8} {'gap':>8} {'adjacency2':>10}")
    for image in chosen.image:
        # Only the annealing of a simplicial complex depends on a seed.
        ways = [["--preset", "paper", "--seed", str(seed + 1)] for seed in range(chosen.seeds)]
        runs = [run_program(chosen.program, image, [*way, *options]) for way in (ways if chosen.simplicial else [[]])]
        places, labels, _, report = runs[0]
        stages = [run[3]["stages"]["optimized"] for run in runs]
        adjacency2 = [stage["adjacency2"] for stage in stages]
        if chosen.simplicial:
            adjacency4 = [stage["adjacency4"] for stage in stages]
            programme = SimplicialProgramme(sorted(places), [report["input"]["exteriorLabel"], *labels])
        else:
            adjacency4 = [jaccard(places, run[2]) for run in runs]
            programme = GeneralProgramme(places)
        bound = prove_bound(programme, max(adjacency4), chosen.timeLimit)
        mean = float(np.mean(adjacency4))
        print(f"{pathlib.Path(image).name:32} {len(places):10} {bound:8.4f} {mean:8.4f} {min(adjacency4):8.4f} "
              f"{bound - mean:8.4f} {np.mean(adjacency2):10.4f}", flush=True)


if __name__ == "__main__":
    main()
