#!/usr/bin/python3
"""The best adjacency4 that any valid adjacency complex can reach on a label image, beside what the program reaches.

The quadruples of cells that meet in an image are no simplicial complex: a block of five cells holds five quadruples, of
which a complex can keep some. This integer programme (HiGHS, through scipy.optimize.milp) proves how many:

    maximize  |T & S| / |T | S|   over the sets T of tetrahedra that fulfil what every valid complex does:

- every triangle is in none or in two, every cell in four at least;
- the link of a cell is a sphere: with n neighbours a cell is in 2 n - 4 tetrahedra (the exterior, whose link is a sphere
  for each part of the tissue that shares no junction with the others, in 2 n - 4 for each);
- the edges at any set of cells are four for each cell at least, because the graph of a closed 3-manifold is rigid in four
  dimensions (Kalai 1987, doi:10.1007/BF01405094; Fogelsanger 1988). It is asked of the sets of cells with few quadruples:
  cells cut by the border of the image, with less than four neighbours, for which a complex needs false tetrahedra.

Tetrahedra outside of S with two or more triangles of S are enumerated; the others ("remote" ones), which cannot close more
than one triangle of S each, enter by their numbers alone, and so do the edges that they alone have. What is proven is an
upper bound: not every such set is a complex. The ratio is maximized by Dinkelbach's method.

    adjacency_bound.py build/bin/TissueTessellation labels.mha [--seeds 5] [--timeLimit 300] [-- OPTIONS OF THE PROGRAM]

Needs python3-numpy and python3-scipy.
"""

import argparse
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


def run_program(program, image, seed, options):
    """Quadruples of labels that the image shows, all labels, and the program's report."""
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder)
        subprocess.run(
            [program, image, path / "walls.vtp", "--junctions", path / "junctions.csv", "--report", path / "report.json",
             "--statistics", path / "cells.csv", "--refinement", "0", "--seed", str(seed), "--quiet", *options],
            check=True,
        )
        with open(path / "junctions.csv", newline="", encoding="ascii") as file:
            rows = list(csv.DictReader(file))
        with open(path / "cells.csv", newline="", encoding="ascii") as file:
            labels = [int(row["Label"]) for row in csv.DictReader(file)]
        report = json.loads((path / "report.json").read_text(encoding="utf-8"))
    quadruples = {tuple(sorted(int(row[f"Label{i}"]) for i in range(4))) for row in rows}
    return sorted(quadruples), labels, report


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
    """Rows and columns of the integer programme. Columns: the tetrahedra (reference, others); for each triangle half its
    tetrahedra and its remote ones; for each cell its remote tetrahedra and remote edges; each edge of a tetrahedron that is
    a column; the numbers of remote tetrahedra and of remote edges."""

    def __init__(self, reference, others, reference_triangles, labels, exterior, parts):
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
        self.columns = self.remote_edges + 1
        self.binary = list(range(n + 2 * m)) + list(range(self.first_edge, self.remote_tetrahedra))
        self.entries, self.low, self.high = [], [], []

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
            spheres = parts if cell == exterior else 1
            self.add_row(star + links[cell] + [(edges_at_cell + i, -2)], -4 * spheres, -4 * spheres)
        inside = [remote_at_triangle + i for i, t in enumerate(triangles) if t in reference_triangles]
        outside = [remote_at_triangle + i for i, t in enumerate(triangles) if t not in reference_triangles]
        self.add_row([(self.remote_tetrahedra, 1)] + [(c, -1) for c in inside], 0, np.inf)
        self.add_row([(self.remote_tetrahedra, 4)] + [(c, -1) for c in outside], 0, np.inf)
        self.add_row([(self.remote_tetrahedra, 4)] + [(remote_at_cell + i, -1) for i in range(k)], 0, 0)
        self.add_row([(self.remote_edges, 2)] + [(edges_at_cell + i, -1) for i in range(k)], 0, 0)
        for most in range(1, 8):
            self.add_rigidity([cell for cell, members in cells.items() if sum(c < len(reference) for c in members) <= most])

    def add_row(self, terms, least, most):
        self.entries.extend((len(self.low), column, value) for column, value in terms)
        self.low.append(least)
        self.high.append(most)

    def add_rigidity(self, cells):
        """At least four edges for each of a set of cells, every edge counted once."""
        chosen = set(cells)
        terms = [(self.first_edge + i, 1) for i, edge in enumerate(self.edges) if chosen & set(edge)]
        self.add_row(terms + [(self.remote_edges, 1)], 4 * len(chosen), np.inf)

    def solve(self, cost, time_limit):
        row, column, value = zip(*self.entries)
        matrix = coo_matrix((value, (row, column)), shape=(len(self.low), self.columns)).tocsr()
        upper = np.full(self.columns, np.inf)
        upper[self.binary] = 1
        return milp(cost, constraints=LinearConstraint(matrix, self.low, self.high), bounds=Bounds(0, upper),
                    integrality=np.ones(self.columns), options={"time_limit": time_limit, "mip_rel_gap": 1e-5})


def prove_bound(reference, labels, exterior, parts, reached, time_limit):
    """An upper bound of |T & S| / |T | S|, of which `reached` is a value that a complex has."""
    others, reference_triangles = enumerate_others(reference)
    programme = Programme(reference, others, reference_triangles, labels, exterior, parts)
    size = len(reference)
    ratio, bound = reached, 1.0
    for _ in range(5):
        cost = np.zeros(programme.columns)
        cost[:size] = -1.0
        cost[size : size + len(others)] = ratio
        cost[programme.remote_tetrahedra] = ratio
        result = programme.solve(cost, time_limit)
        if result.mip_dual_bound is None:
            raise RuntimeError(f"HiGHS proved nothing in {time_limit} s: {result.message}")
        # hits <= D + ratio missed, so that hits / (size + missed) is at most the larger one of D / size and the ratio.
        bound = min(bound, max(-result.mip_dual_bound / size, ratio))
        if result.x is None:
            break
        hits = round(result.x[:size].sum())
        missed = round(result.x[size : size + len(others)].sum()) + round(result.x[programme.remote_tetrahedra])
        found = hits / (size + missed)
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
    parser.add_argument("--seeds", type=int, default=5)
    parser.add_argument("--timeLimit", type=float, default=300.0, help="seconds for each solution of the programme")
    chosen = parser.parse_args(arguments)
    print(f"{'image':32} {'quadruples':>10} {'bound':>8} {'ours':>8} {'lowest':>8} {'gap':>8} {'adjacency2':>10}")
    for image in chosen.image:
        runs = [run_program(chosen.program, image, seed, options) for seed in range(1, chosen.seeds + 1)]
        reference, labels, report = runs[0]
        exterior = report["input"]["exteriorLabel"]
        adjacency2, adjacency4 = ([run[2]["stages"]["optimized"][f"adjacency{n}"] for run in runs] for n in (2, 4))
        bound = prove_bound(reference, [exterior, *labels], exterior, report["mesh"]["parts"], max(adjacency4),
                            chosen.timeLimit)
        mean = float(np.mean(adjacency4))
        print(f"{pathlib.Path(image).name:32} {len(reference):10} {bound:8.4f} {mean:8.4f} {min(adjacency4):8.4f} "
              f"{bound - mean:8.4f} {np.mean(adjacency2):10.4f}", flush=True)


if __name__ == "__main__":
    main()
