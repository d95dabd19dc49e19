"""Beads of sheet-metal panels: recognised, classified, meshed on purpose.

    import beadmesh
    panel = beadmesh.read("floor.step")
    for bead in beadmesh.beads(panel).beads:
        print(bead.id, bead.kind, bead.shape, bead.length, bead.width)
    mesh = beadmesh.mesh(panel, size=5)
    mesh.write("floor.bdf")

Lengths are in mm, angles in degrees, numbers of faces and beads count from 1, indices of arrays from 0. Long calls
release the interpreter's lock. Failures raise BeadmeshError, which carries the diagnostic.
"""
from ._core import __version__
from ._errors import BeadmeshError, Diagnostic
from ._medial import MedialEdge, MedialObject, PanelMedials, Thickness, medial, medial_of_file, medials
from ._mesh import BeadMeshing, BeadSet, Mesh, Part, Quality, mesh, quality
from ._panel import Bead, BeadOptions, BeadTable, Facets, Panel, RejectedFace, beads, read

BeadmeshError.__module__ = Diagnostic.__module__ = __name__  # as users see them in tracebacks

__all__ = [
    "Bead", "BeadMeshing", "BeadOptions", "BeadSet", "BeadTable", "BeadmeshError", "Diagnostic", "Facets", "MedialEdge",
    "MedialObject", "Mesh", "Panel", "PanelMedials", "Part", "Quality", "RejectedFace", "Thickness", "__version__",
    "beads", "medial", "medial_of_file", "medials", "mesh", "quality", "read",
]
