"""Shell meshes: made from panels, judged, written, exchanged with meshio."""
from __future__ import annotations

import os
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Mapping, NamedTuple, Optional, Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._errors import BeadmeshError
from ._panel import BeadOptions, BeadTable, Panel, PathLike, _table

if TYPE_CHECKING:
    import meshio


class Part(NamedTuple):
    """A property of the deck."""

    id: int
    name: str
    thickness: float
    """mm"""


@dataclass(eq=False)
class BeadSet:
    """Elements and nodes of one bead, as ascending indices of the mesh's arrays."""

    bead: int
    kind: str
    shape: str
    elements: NDArray[np.int32]
    crest_nodes: NDArray[np.int32]
    boundary_nodes: NDArray[np.int32]
    cap_elements: NDArray[np.int32]
    """Of the clamps at its ends."""
    crest_lines: list[NDArray[np.int32]]
    """Crest nodes along each line; of a closed line the first is the last."""


class BeadMeshing(NamedTuple):
    """How a bead was meshed."""

    method: str
    """"blocks", "ridge", "face" (as asked for) or "fallback"."""
    elements: int
    elements_across: int
    """Of blocks; else 0."""
    notes: list[str]


@dataclass(frozen=True, eq=False)
class Quality:
    """Figures of m elements, each of shape (m,), and counts."""

    scaled_jacobian: NDArray[np.float64]
    """1 is a square, 0 and below is inverted."""
    warpage: NDArray[np.float64]
    """Degrees between the two triangles of a quad, the larger of both ways to split it."""
    shortest_edge: NDArray[np.float64]
    longest_edge: NDArray[np.float64]
    smallest_angle: NDArray[np.float64]
    """Degrees."""
    largest_angle: NDArray[np.float64]
    quads: int
    triangles: int
    inverted: int
    edges_below_min: int
    irregular_nodes: int
    """Inner nodes without exactly four quads."""


def quality(nodes: ArrayLike, elements: ArrayLike, *, min_edge: float = 0.0) -> Quality:
    """Quality of any shell mesh: nodes (n, 3), elements (m, 4) of indices, -1 as the fourth node of a triangle.

    min_edge: edges shorter than this are counted.
    """
    return Quality(**_core.quality(np.asarray(nodes, np.float64), np.asarray(elements, np.int32), min_edge))


def _column(values: Optional[ArrayLike], count: int) -> NDArray[np.int32]:
    return np.zeros(count, np.int32) if values is None else np.asarray(values, np.int32)


@dataclass(eq=False)
class Mesh:
    """A shell mesh of n nodes and m elements."""

    nodes: NDArray[np.float64]
    """(n, 3), mm."""
    elements: NDArray[np.int32]
    """(m, 4), indices of nodes; -1 as the fourth of a triangle."""
    part: NDArray[np.int32] = None  # type: ignore[assignment]
    """(m,), index in parts. Left out: 0."""
    face: NDArray[np.int32] = None  # type: ignore[assignment]
    """(m,), 1-based number of the panel's face. Left out: 0."""
    bead: NDArray[np.int32] = None  # type: ignore[assignment]
    """(m,), id of the bead, 0: none. Left out: 0."""
    parts: list[Part] = field(default_factory=lambda: [Part(1, "sheet", 1.0)])
    sets: list[BeadSet] = field(default_factory=list)
    """One a bead."""
    title: str = ""
    table: Optional[BeadTable] = None
    """The beads of the panel it was made from."""
    meshing: list[BeadMeshing] = field(default_factory=list)
    """Of each bead of the table."""
    made: Optional["_core.MadeMesh"] = field(default=None, repr=False)
    """What write_report needs; None for meshes that beadmesh.mesh has not made."""

    def __post_init__(self) -> None:
        self.nodes = np.asarray(self.nodes, np.float64)
        self.elements = np.asarray(self.elements, np.int32)
        count = len(self.elements)
        self.part, self.face, self.bead = (_column(c, count) for c in (self.part, self.face, self.bead))

    @property
    def quads(self) -> NDArray[np.int32]:
        """(q, 4)"""
        return self.elements[self.elements[:, 3] >= 0]

    @property
    def triangles(self) -> NDArray[np.int32]:
        """(t, 3)"""
        return self.elements[self.elements[:, 3] < 0][:, :3]

    def quality(self, *, min_edge: float = 0.0) -> Quality:
        """See :func:`quality`."""
        return quality(self.nodes, self.elements, min_edge=min_edge)

    def write(self, path: PathLike, *, id_offset: int = 0, first_node: Optional[int] = None,
              first_element: Optional[int] = None, first_property: Optional[int] = None, analysis: str = "modes") -> None:
        """Writes a deck, whole or not at all. The format goes by the ending: .bdf .nas .dat Nastran, .k .key LS-DYNA, .inp
        Abaqus and CalculiX, .vtu VTK, .msh Gmsh 4.1, .stl.

        id_offset: added to all ids; the first ids overrule it.
        analysis: "modes" for a deck that runs as it is, "none" for one to be included in another.

        Raises BeadmeshError with a code write.*.
        """
        first = id_offset + 1
        options = _core.DeckOptions(first if first_node is None else first_node,
                                    first if first_element is None else first_element,
                                    first if first_property is None else first_property, id_offset, analysis)
        raw = {"title": self.title, "nodes": self.nodes, "elements": self.elements, "part": self.part, "face": self.face,
               "bead": self.bead, "parts": [tuple(part) for part in self.parts], "sets": [vars(one) for one in self.sets]}
        _core.write(raw, os.fspath(path), options)

    def write_report(self, path: PathLike) -> None:
        """Writes the report of the run, whole or not at all: .html in 3-D, or .svg, the flat picture. It shows the mesh as
        beadmesh.mesh made it, whatever was done to the arrays since.

        Raises BeadmeshError with usage.report (another ending; a mesh from elsewhere) or write.*.
        """
        if self.made is None:
            raise BeadmeshError("usage.report", message="there is no report of a mesh that beadmesh.mesh has not made")
        self.made.write_report(os.fspath(path))

    def to_meshio(self) -> "meshio.Mesh":
        """Quads, then triangles, with cell data part (the part's id), bead, face and thickness. Needs meshio."""
        import meshio

        is_quad = self.elements[:, 3] >= 0
        blocks = [(kind, self.elements[mask][:, :corners], mask)
                  for kind, corners, mask in (("quad", 4, is_quad), ("triangle", 3, ~is_quad)) if mask.any()]
        columns = {"part": np.array([part.id for part in self.parts], np.int32)[self.part], "bead": self.bead,
                   "face": self.face, "thickness": np.array([part.thickness for part in self.parts])[self.part]}
        return meshio.Mesh(self.nodes, [(kind, corners) for kind, corners, _ in blocks],
                           cell_data={name: [values[mask] for _, _, mask in blocks] for name, values in columns.items()})

    @classmethod
    def from_meshio(cls, mesh: "meshio.Mesh") -> "Mesh":
        """Quads and triangles of a mesh, in its order; other cells are left out. Cell data part, bead, face and thickness
        are taken over where they are there, as to_meshio names them."""
        blocks = [(k, block) for k, block in enumerate(mesh.cells) if block.type in ("quad", "triangle")]
        elements = [np.full((0, 4), -1, np.int32)]
        for _, block in blocks:
            rows = np.full((len(block.data), 4), -1, np.int32)
            rows[:, :block.data.shape[1]] = block.data
            elements.append(rows)
        joined = lambda name: (np.concatenate([np.asarray(mesh.cell_data[name][k]).ravel() for k, _ in blocks])
                               if name in mesh.cell_data and blocks else None)
        points = np.asarray(mesh.points, np.float64)
        if points.shape[1] == 2:
            points = np.column_stack([points, np.zeros(len(points))])
        ids, thickness = joined("part"), joined("thickness")
        made = cls(points, np.concatenate(elements), face=joined("face"), bead=joined("bead"))
        if ids is not None:
            unique, first, made_part = np.unique(ids, return_index=True, return_inverse=True)
            made.part = made_part.astype(np.int32)
            made.parts = [Part(int(one), f"part_{int(one)}", 1.0 if thickness is None else float(thickness[at]))
                          for one, at in zip(unique, first)]
        return made

    def __repr__(self) -> str:
        return f"<beadmesh.Mesh of {len(self.nodes)} nodes, {len(self.quads)} quads, {len(self.triangles)} triangles>"


Control = Mapping[str, Any]


def mesh(panel: Panel, *, size: float = 5.0, min_edge: Optional[float] = None, thickness: float = 1.0,
         options: Optional[BeadOptions] = None, beads: Optional[Control] = None, kinds: Optional[Mapping[str, Control]] = None,
         single: Optional[Mapping[int, Control]] = None,
         local_sizes: Sequence[tuple[Sequence[float], float, float]] = (), jobs: int = 0) -> Mesh:
    """Meshes a panel: its beads on purpose, the rest around them.

    size, min_edge: target and minimum element length, mm; min_edge is half the size where it is left out.
    thickness: of the sheet, mm, for the parts.
    options: which faces are beads.
    beads, kinds, single: what is asked of all beads, of those of a kind ("I", "generic", "annular"), of one by its id: a
        mapping with any of size, min_edge, elements_across, elements_along, clamp_rows, method.
    local_sizes: balls with another size: ((x, y, z), radius, size).
    jobs: threads, 0 for all cores; the result does not depend on them.

    Ctrl-C (any signal handler that raises) ends it early, at the next face.

    Raises BeadmeshError where nothing could be meshed, or with usage.* and control.*. A bead that defeats its methods is
    meshed as an ordinary face, and a face that defeats every mesher left out: see Mesh.meshing and Mesh.table.diagnostics.
    """
    options = options or BeadOptions()
    composed = panel._with_composites(options, jobs)
    balls = [((float(x), float(y), float(z)), float(radius), float(local)) for (x, y, z), radius, local in local_sizes]
    raw = _core.mesh(composed, size, size / 2 if min_edge is None else min_edge, thickness, options._core(),
                     dict(beads or {}), {k: dict(v) for k, v in (kinds or {}).items()},
                     {int(k): dict(v) for k, v in (single or {}).items()}, balls, jobs)
    raw["parts"] = [Part(*part) for part in raw["parts"]]
    raw["sets"] = [BeadSet(**one) for one in raw["sets"]]
    raw["table"] = _table(raw["table"])
    raw["meshing"] = [BeadMeshing(**one) for one in raw["meshing"]]
    return Mesh(**raw)
