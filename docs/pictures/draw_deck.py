"""draw_deck.py DECK.inp BEAD OUT.png: a bead as its deck describes it, read by meshio: part, sets of elements and of nodes."""
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import meshio
import numpy as np
from matplotlib.collections import PolyCollection


def elements_of(mesh, name):
    """Corners of the elements of a set."""
    return [corners for block, members in zip(mesh.cells, mesh.cell_sets[name]) for corners in block.data[members]]


def draw_elements(axes, mesh, rows, label, color):
    plan = mesh.points[:, :2]
    axes.add_collection(PolyCollection([plan[corners] for corners in rows], facecolors=color, edgecolors="#555", linewidths=0.7,
                                       label=f"{label}: {len(rows)} elements"))


def draw_nodes(axes, mesh, name, size, **style):
    members = mesh.points[mesh.point_sets[name], :2]
    axes.scatter(*members.T, s=size, zorder=3, edgecolors="#222", linewidths=0.8, label=f"{name}: {len(members)} nodes", **style)


def main(deck, bead, picture):
    mesh, name = meshio.read(deck), f"bead_{bead}"
    figure, axes = plt.subplots(figsize=(11, 6.2), layout="constrained")
    draw_elements(axes, mesh, [corners for block in mesh.cells for corners in block.data], "all", "#f4f4f4")
    draw_elements(axes, mesh, elements_of(mesh, name), name, "#f3c677")
    draw_elements(axes, mesh, elements_of(mesh, f"{name}_caps"), f"{name}_caps", "#56b4e9")
    draw_nodes(axes, mesh, f"{name}_boundary", 18, color="white")
    draw_nodes(axes, mesh, f"{name}_crest", 24, color="#222")
    bounds = np.array([mesh.points[corners, :2] for corners in elements_of(mesh, name)]).reshape(-1, 2)
    (left, bottom), (right, top) = bounds.min(axis=0) - 8, bounds.max(axis=0) + 8
    axes.set(xlim=(left, right), ylim=(bottom, top), aspect="equal")
    axes.set_axis_off()
    axes.legend(loc="lower left", framealpha=1)
    figure.savefig(picture, dpi=100)


if __name__ == "__main__":
    main(sys.argv[1], int(sys.argv[2]), sys.argv[3])
