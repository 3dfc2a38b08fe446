# Copyright The TissueTessellation contributors
# SPDX-License-Identifier: Apache-2.0
"""From a label image to a table of its cells, layer by layer, and to a figure.

Cells of a notebook, for editors that know `# %%`; or: python3 tissue_statistics.py [FOLDER of the results]
"""
# %% A label image: an array of integers (z, y, x). Yours may come from tifffile.imread("labels.tif").
import pathlib
import sys

import itk
import numpy as np

import tissuetessellation

folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".")
spacing = (1.0, 0.5, 0.5)  # micrometres along z, y, x
image = itk.synthetic_tissue_image_source(ttype=itk.Image[itk.US, 3], size=[80, 80, 36], number_of_cells=120)
labels = itk.array_from_image(image)
print(f"{labels.shape} voxels, {len(np.unique(labels)) - 1} cells")

# %% Its walls: each once, shared by its two cells. Positions are x, y, z.
tissue = tissuetessellation.mesh(labels, spacing=spacing)
print(tissue)
print({name: tissue.report[name] for name in ("adjacency2", "meanVolumeError", "minimumTriangleAngle")})
for remark in tissue.remarks[:5]:
    print(f"cell {remark['label']} {remark['text']}")

# %% A row for each cell: pandas.DataFrame(tissue.cells) is the table.
cells = tissue.cells
print("layer  cells  mean volume  sphericity  neighbours")
for layer in np.unique(cells["Layer"]):
    chosen = cells["Layer"] == layer
    means = [cells[name][chosen].mean() for name in ("Volume", "Sphericity", "NumberOfNeighbors")]
    print(f"{layer:5}  {chosen.sum():5}  {means[0]:11.1f}  {means[1]:10.3f}  {means[2]:10.1f}")

# %% Walls between cells of the epidermis, and their share of all walls' area.
epidermis = cells["Label"][cells["Layer"] == 1]
walls = tissue.walls
anticlinal = np.isin(walls["Label0"], epidermis) & np.isin(walls["Label1"], epidermis)
print(f"{anticlinal.sum()} anticlinal walls, {walls['Area'][anticlinal].sum() / walls['Area'].sum():.0%} of the area")

# %% Files for ParaView and others, if meshio is there.
try:
    import meshio
except ImportError:
    print("no meshio: no file")
else:
    meshio.write(folder / "walls.vtu", tissue.to_meshio())

# %% A figure, if matplotlib is there: the epidermis from outside, by the volumes of its cells.
try:
    import matplotlib

    matplotlib.use("Agg")  # Without a window; leave out in a notebook.
    from matplotlib import pyplot
    from mpl_toolkits.mplot3d.art3d import Poly3DCollection
except ImportError:
    print("no matplotlib: no figure")
else:
    is_outer = tissue.boundary_labels[:, 1] == tissue.exterior_label
    volumes = cells["Volume"][np.searchsorted(tissue.labels, tissue.boundary_labels[is_outer, 0])]
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(10, 4), layout="constrained")
    left.boxplot([cells["Volume"][cells["Layer"] == layer] for layer in (1, 2)], labels=["epidermis", "second layer"])
    left.set_ylabel("volume (µm³)")
    right.remove()
    right = figure.add_subplot(1, 2, 2, projection="3d")
    scale = matplotlib.colors.Normalize(volumes.min(), volumes.max())
    colors = matplotlib.colormaps["viridis"](scale(volumes))
    right.add_collection3d(Poly3DCollection(tissue.points[tissue.triangles[is_outer]], facecolors=colors))
    low, high = tissue.points.min(axis=0), tissue.points.max(axis=0)
    right.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), zlim=(low[2], high[2]), xlabel="x (µm)")
    right.set_box_aspect(high - low)
    figure.savefig(folder / "tissue.png", dpi=150)
