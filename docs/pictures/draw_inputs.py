"""draw_inputs.py solid SOLID.step OUT.png: a cut through the skins of a thin solid.
draw_inputs.py facets FACETS.stl OUT.png: to which faces the reader gives the facets of a mesh. Both by the Python package."""
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import LineCollection, PolyCollection

import beadmesh

KINDS = {"I": "#56b4e9", "generic": "#e69f00", "annular": "#009e73"}


def cut(panel, y):
    """Segments (k, 2, 2) in x and z where the plane at y cuts the facets."""
    segments = []
    for facets in panel.facets():
        corners = facets.points[facets.triangles]
        side = corners[:, :, 1] > y
        for triangle, above in zip(corners, side):
            ends = [triangle[i] + (y - triangle[i][1]) / (triangle[k][1] - triangle[i][1]) * (triangle[k] - triangle[i])
                    for i, k in ((0, 1), (1, 2), (2, 0)) if above[i] != above[k]]
            if len(ends) == 2:
                segments.append([end[[0, 2]] for end in ends])
    return np.array(segments)


def draw_solid(path, picture):
    figure, axes = plt.subplots(figsize=(11, 2.6), layout="constrained")
    bead = max(beadmesh.beads(beadmesh.read(path)).beads, key=lambda one: one.kind == "I")
    for skin, color, width in (("whole", "#bbbbbb", 6), ("middle", "#e69f00", 2), ("outer", "#0072b2", 2), ("inner", "#009e73", 2)):
        panel = beadmesh.read(path, skin=skin)
        axes.add_collection(LineCollection(cut(panel, bead.point[1]), colors=color, linewidths=width, label=f"--skin {skin}"))
    x, _, z = bead.point
    axes.set(xlim=(x - 26, x + 26), ylim=(z - 10, z + 2), aspect="equal")
    axes.set_axis_off()
    axes.legend(loc="lower center", ncols=4, framealpha=1)
    figure.savefig(picture, dpi=100)


def draw_facets(path, picture):
    panel = beadmesh.read(path)
    kind = {face: bead.kind for bead in beadmesh.beads(panel).beads for face in bead.faces}
    figure, axes = plt.subplots(figsize=(11, 7), layout="constrained")
    for facets in panel.facets():
        color = KINDS.get(kind.get(facets.face), "#f2f2f2")
        axes.add_collection(PolyCollection(facets.points[facets.triangles][:, :, :2], facecolors=color, edgecolors="#777", linewidths=0.4))
    axes.autoscale()
    axes.set(aspect="equal")
    axes.set_axis_off()
    axes.legend(handles=[matplotlib.patches.Patch(facecolor=c, edgecolor="#777", label=f"{k} bead") for k, c in KINDS.items()],
                loc="lower left", framealpha=1)
    figure.savefig(picture, dpi=100)


if __name__ == "__main__":
    {"solid": draw_solid, "facets": draw_facets}[sys.argv[1]](*sys.argv[2:])
