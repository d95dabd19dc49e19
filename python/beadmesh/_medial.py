"""Typed medial objects of faces and of plane polygons."""
from __future__ import annotations

import os
from dataclasses import dataclass
from typing import Any, NamedTuple, Optional, Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._errors import Diagnostic
from ._panel import Panel, PathLike


class Thickness(NamedTuple):
    """Diameters of the inscribed circles along an edge: smallest, mean over the length, largest."""

    min: float
    mean: float
    max: float


@dataclass(frozen=True, eq=False)
class MedialEdge:
    """An edge of the medial axis, with n points from its start to its end."""

    type: str
    """By the types of its ends: "S-S", "S-C", "S-J", "C-C", "C-J", "J-J"; "N" is closed and has none."""
    start: Optional[int]
    """Index of a vertex; None for "N"."""
    end: Optional[int]
    length: float
    thickness: Thickness
    points: NDArray[np.float64]
    """(n, 2), in the plane."""
    radii: NDArray[np.float64]
    """(n,), of the inscribed circles."""
    feet: NDArray[np.float64]
    """(n, 2, 2): touching points on the left [:, 0] and on the right [:, 1]."""
    subtended_angles: NDArray[np.float64]
    """(n,), degrees between the directions to the feet."""
    space: Optional[NDArray[np.float64]]
    """(n, 3), the points on the surface of a panel's face; None for a polygon."""


@dataclass(frozen=True, eq=False)
class MedialObject:
    """The medial axis of a region as a graph of v vertices and edges."""

    face: Optional[int]
    """1-based number of the panel's face; None for a polygon."""
    loops: list[NDArray[np.float64]]
    """Boundary in the plane, each (n, 2): the outer loop first, counter-clockwise; holes clockwise."""
    vertex_types: list[str]
    """"J" junction, "C" end in a corner, "S" end in a smooth cap."""
    vertex_points: NDArray[np.float64]
    """(v, 2)."""
    vertex_radii: NDArray[np.float64]
    """(v,), of the inscribed circles."""
    vertex_edges: list[list[int]]
    """Indices of the edges at each vertex, counter-clockwise."""
    vertex_space: Optional[NDArray[np.float64]]
    """(v, 3) on the surface; None for a polygon."""
    edges: list[MedialEdge]

    @property
    def length(self) -> float:
        """Sum over the edges."""
        return sum(edge.length for edge in self.edges)


class PanelMedials(NamedTuple):
    """Medial objects of the faces that have one, and what was wrong with the others."""

    objects: list[MedialObject]
    diagnostics: list[Diagnostic]


def _edge(raw: dict[str, Any]) -> MedialEdge:
    raw["thickness"] = Thickness(*raw["thickness"])
    return MedialEdge(**raw)


def _object(raw: dict[str, Any]) -> MedialObject:
    raw["edges"] = [_edge(edge) for edge in raw["edges"]]
    return MedialObject(**raw)


def medial(loops: Sequence[ArrayLike], *, corners: Optional[Sequence[Sequence[bool]]] = None,
           corner_angle: float = 160.0, chord: float = 0.0, merge_crossings: bool = False) -> MedialObject:
    """The medial object of a plane polygon with holes.

    loops: arrays of shape (n, 2), the points of each loop in order; the first may be repeated at the end. Direction and
        order do not matter: the outermost loop becomes the outer one.
    corners: per loop and point, whether the boundary has a corner there. Left out: where the interior angle is under
        corner_angle (degrees). Points that are no corner stand for a smooth curve.
    chord: greatest distance of the edges' polylines from the axis; 0 for 1e-7 of the size.
    merge_crossings: two near junctions, as in the crossing of an X, become one.

    Raises BeadmeshError with a code delaunay.region.* that names loop and point: too few points, crossing, ...
    """
    arrays = [np.asarray(loop, dtype=np.float64) for loop in loops]
    flags = None if corners is None else [[bool(flag) for flag in loop] for loop in corners]
    return _object(_core.medial_of_loops(arrays, flags, corner_angle, chord, merge_crossings))


def medial_of_file(path: PathLike) -> MedialObject:
    """The medial object of a polygon file: WKT (.wkt, also with circular arcs) or Triangle's .poly."""
    return _object(_core.medial_of_file(os.fspath(path)))


def medials(panel: Panel, faces: Optional[Sequence[int]] = None, *, jobs: int = 0) -> PanelMedials:
    """The medial objects of faces of a panel, by their 1-based numbers; of all of them where none is given.

    A face that closes around itself is cut open. Never fails for a single face: it is missing, with a diagnostic.
    """
    numbers = None if faces is None else [int(face) for face in faces]
    objects, diagnostics = _core.medial_of_faces(panel._core, numbers, jobs)
    return PanelMedials([_object(raw) for raw in objects], [Diagnostic(**one) for one in diagnostics])
