"""Beads, medial axes, mesh and quality of a panel, drawn with matplotlib. Run it in cells or as a whole:

    python3 draw_panel.py PANEL.step [PICTURE.png]
"""
# %% What is needed
import sys

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import LineCollection, PolyCollection

import beadmesh

COLOURS = {"I": "#4477aa", "generic": "#ccbb44", "annular": "#228833"}
SHEET = "#e8e8e8"

# %% Read the panel, recognise its beads
panel = beadmesh.read(sys.argv[1])
table = beadmesh.beads(panel)
for bead in table.beads:
    print(f"{bead.id:3d}  {bead.kind:8s} {bead.shape:8s} {bead.length:8.1f} mm long, {bead.width:5.1f} wide, {bead.height:4.1f} high")

# %% Mesh it
mesh = beadmesh.mesh(panel, size=5, min_edge=2.5)
quality = mesh.quality(min_edge=2.5)
print(f"{len(mesh.quads)} quads, {len(mesh.triangles)} triangles, scaled Jacobian at least {quality.scaled_jacobian.min():.2f}")

# %% The medial objects of the beads, on the surface
medials = beadmesh.medials(panel, [face for bead in table.beads for face in bead.faces]).objects

# %% Draw: all three as seen along z
figure, (left, middle, right) = plt.subplots(1, 3, figsize=(18, 5), constrained_layout=True)


def draw_elements(axes, **style):
    """The elements as polygons, quads and triangles alike."""
    corners = [mesh.nodes[element[element >= 0], :2] for element in mesh.elements]
    axes.add_collection(drawn := PolyCollection(corners, linewidths=0.2, edgecolors="#888888", **style))
    axes.autoscale()
    axes.set_aspect("equal")
    return drawn


kinds = {bead.id: bead.kind for bead in table.beads}
draw_elements(left, facecolors=[COLOURS[kinds[b]] if b else SHEET for b in mesh.bead])
for one in mesh.sets:
    for line in one.crest_lines:
        left.plot(*mesh.nodes[line, :2].T, color="black", linewidth=1.2)
for bead in table.beads:
    left.annotate(str(bead.id), bead.point[:2], color="white", fontsize=9, ha="center", va="center",
                  bbox=dict(boxstyle="circle,pad=0.2", facecolor="black", linewidth=0))
left.set_title("Beads by kind, crest lines")

# %% The medial axes, coloured by thickness
for _, points, triangles in panel.facets():
    middle.triplot(points[:, 0], points[:, 1], triangles, color="#dddddd", linewidth=0.2)
lines, thickness = [], []
for medial in medials:
    for edge in medial.edges:
        ends = range(len(edge.points) if edge.type == "N" else len(edge.points) - 1)
        lines += [edge.space[[k, (k + 1) % len(edge.points)], :2] for k in ends]
        thickness += [2 * edge.radii[k] for k in ends]
axis = LineCollection(lines, array=np.array(thickness), cmap="viridis", linewidths=2)
middle.add_collection(axis)
middle.set_aspect("equal")
middle.set_title("Medial axes")
figure.colorbar(axis, ax=middle, label="thickness, mm", shrink=0.8)

# %% The quality
drawn = draw_elements(right, array=quality.scaled_jacobian, cmap="cividis", clim=(0.5, 1.0))
right.set_title("Scaled Jacobian")
figure.colorbar(drawn, ax=right, shrink=0.8)

# %% Show or save
if len(sys.argv) > 2:
    figure.savefig(sys.argv[2], dpi=120)
else:
    plt.show()
