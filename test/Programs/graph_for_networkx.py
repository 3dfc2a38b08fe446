#!/usr/bin/python3
"""Reads the graph of a folder by NetworkX: nodes are the rows of the cells' table, edges what the walls' table adds up to."""
import collections
import csv
import math
import pathlib
import sys

import networkx


def rows_of(path):
    with open(path, newline="") as stream:
        return list(csv.DictReader(stream))


folder = pathlib.Path(sys.argv[1])
graph = networkx.read_graphml(folder / "graph.graphml", node_type=int)
cells = {int(row["Label"]): row for row in rows_of(folder / "cells.csv")}
if graph.is_directed() or set(graph.nodes) != set(cells):
    sys.exit("the nodes by NetworkX are not the cells of the table")
for label, row in cells.items():
    known = {name: float(value) for name, value in row.items() if value}
    if dict(graph.nodes[label]) != known:
        sys.exit(f"node {label} is {dict(graph.nodes[label])}, its row {known}")

areas = collections.defaultdict(float)
for row in rows_of(folder / "walls.csv"):
    pair = (int(row["Label0"]), int(row["Label1"]))
    if pair[1] in cells:
        areas[pair] += float(row["Area"])
if {tuple(sorted(edge)) for edge in graph.edges} != set(areas):
    sys.exit("the edges by NetworkX are not the pairs of cells in the table of the walls")
for (a, b), area in areas.items():
    if not math.isclose(graph.edges[a, b]["weight"], area):
        sys.exit(f"edge {a} {b} weighs {graph.edges[a, b]['weight']}, its walls have {area}")
for label in cells:
    if graph.degree[label] != int(cells[label]["NumberOfNeighbors"]):
        sys.exit(f"cell {label} has {graph.degree[label]} edges")
