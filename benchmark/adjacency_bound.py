#!/usr/bin/python3
"""The best adjacency4 that any valid adjacency complex can reach on a label image, beside what the program reaches.

The quadruples of cells that meet in an image are no simplicial complex: a block of five cells holds five quadruples, of
which a complex can keep some. This integer programme (HiGHS, through scipy.optimize.milp) proves how many. A complex is a
set of tetrahedra in which every triangle is in none or in two, and every cell in four at least:

    maximize  |T & S| / |T | S|   over the sets T of tetrahedra

Tetrahedra outside of S with two or more triangles of S are enumerated; the others ("remote" ones), which cannot close more
than one triangle of S each, enter by their number alone. So what is proven is an upper bound: links of vertices need not
be spheres in it. The ratio is maximized by Dinkelbach's method.

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
    """Quadruples of labels that the image shows, and adjacency2 and adjacency4 of the program's complex."""
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder)
        subprocess.run(
            [program, image, path / "walls.vtp", "--junctions", path / "junctions.csv", "--report", path / "report.json",
             "--refinement", "0", "--seed", str(seed), "--quiet", *options],
            check=True,
        )
        with open(path / "junctions.csv", newline="", encoding="ascii") as file:
            rows = list(csv.DictReader(file))
        optimized = json.loads((path / "report.json").read_text(encoding="utf-8"))["stages"]["optimized"]
    quadruples = [tuple(sorted(int(row[f"Label{i}"]) for i in range(4))) for row in rows]
    return quadruples, optimized["adjacency2"], optimized["adjacency4"]


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


def build_constraints(reference, others, reference_triangles):
    """Columns: tetrahedra (reference, others); per triangle half its tetrahedra and its remote ones; per cell its remote
    ones; the number of remote tetrahedra."""
    tetrahedra = reference + others
    triangles, cells = {}, {}
    for column, tetrahedron in enumerate(tetrahedra):
        for triangle in triangles_of(tetrahedron):
            triangles.setdefault(triangle, []).append(column)
        for cell in tetrahedron:
            cells.setdefault(cell, []).append(column)
    n, m, k = len(tetrahedra), len(triangles), len(cells)
    columns = n + 2 * m + k + 1
    entries, low, high = [], [], []

    def add_row(terms, least, most):
        entries.extend((len(low), column, value) for column, value in terms)
        low.append(least)
        high.append(most)

    for i, members in enumerate(triangles.values()):
        add_row([(c, 1) for c in members] + [(n + i, -2), (n + m + i, 1)], 0, 0)
    for i, members in enumerate(cells.values()):
        add_row([(c, 1) for c in members] + [(n + 2 * m + i, 1)], 4, np.inf)
    inside = [n + m + i for i, t in enumerate(triangles) if t in reference_triangles]
    outside = [n + m + i for i, t in enumerate(triangles) if t not in reference_triangles]
    add_row([(columns - 1, 1)] + [(c, -1) for c in inside], 0, np.inf)
    add_row([(columns - 1, 4)] + [(c, -1) for c in outside], 0, np.inf)
    add_row([(columns - 1, 4)] + [(n + 2 * m + i, -1) for i in range(k)], 0, np.inf)
    row, column, value = zip(*entries)
    matrix = coo_matrix((value, (row, column)), shape=(len(low), columns)).tocsr()
    upper = np.ones(columns)
    upper[n + 2 * m :] = np.inf
    return LinearConstraint(matrix, low, high), Bounds(0, upper)


def prove_bound(reference, time_limit):
    """An upper bound of |T & S| / |T | S|, and the ratio of the best set found."""
    others, reference_triangles = enumerate_others(reference)
    constraint, bounds = build_constraints(reference, others, reference_triangles)
    columns = len(bounds.ub)
    size = len(reference)
    ratio, bound, found = 0.9, 1.0, 0.0
    for _ in range(5):
        cost = np.zeros(columns)
        cost[:size] = -1.0
        cost[size : size + len(others)] = ratio
        cost[-1] = ratio
        result = milp(cost, constraints=constraint, bounds=bounds, integrality=np.ones(columns),
                      options={"time_limit": time_limit, "mip_rel_gap": 1e-5})
        if result.x is None:
            raise RuntimeError(f"HiGHS found nothing in {time_limit} s: {result.message}")
        bound = min(bound, max(-result.mip_dual_bound / size, ratio))
        hits = round(result.x[:size].sum())
        missed = round(result.x[size : size + len(others)].sum()) + round(result.x[-1])
        found = hits / (size + missed)
        if abs(found - ratio) < 1e-6:
            break
        ratio = found
    return bound, found


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
        reference = sorted(set(runs[0][0]))
        bound, _ = prove_bound(reference, chosen.timeLimit)
        adjacency4 = [run[2] for run in runs]
        mean = float(np.mean(adjacency4))
        print(f"{pathlib.Path(image).name:32} {len(reference):10} {bound:8.4f} {mean:8.4f} {min(adjacency4):8.4f} "
              f"{bound - mean:8.4f} {np.mean([run[1] for run in runs]):10.4f}", flush=True)


if __name__ == "__main__":
    main()
