"""Panels and their beads."""
from __future__ import annotations

import os
from dataclasses import dataclass
from typing import Any, NamedTuple, Optional, Union

import numpy as np
from numpy.typing import NDArray

from . import _core
from ._errors import Diagnostic

PathLike = Union[str, "os.PathLike[str]"]


@dataclass(frozen=True)
class BeadOptions:
    """Which faces are beads."""

    min_aspect_ratio: float = 2.0
    """Least mean of length / thickness over the medial edges."""
    max_joint_angle: float = 10.0
    """Degrees; a sharper joint in a loop is a corner, and the face no bead."""
    max_loops: int = 2
    """Ladders of two windows have three loops."""
    min_rise: float = 0.03
    """Least height of the crest over the sheet, per width."""

    def _core(self) -> "_core.BeadOptions":
        return _core.BeadOptions(self.min_aspect_ratio, self.max_joint_angle, self.max_loops, self.min_rise)


@dataclass(frozen=True, eq=False)
class Bead:
    """A row of the bead table. Lengths in mm."""

    id: int
    """1-based, in the order of the faces."""
    kind: str
    """"I", "generic" or "annular"."""
    shape: str
    """What a person sees: "I", "arc", "T", "comb", "ring", ..."""
    faces: list[int]
    """1-based numbers of its faces in the input."""
    point: tuple[float, float, float]
    """A point on the crest."""
    loops: int
    length: float
    """Sum over the medial edges."""
    width: float
    """Mean thickness along them."""
    height: float
    """How far the crest rises over the boundary."""
    aspect_ratio: float
    confidence: float
    """From 0 to 1; below 1 where the bead was found in facets without an edge of its own."""
    junctions: int
    ends: int
    medial_edges: int
    ridge: list[NDArray[np.float64]]
    """Crest lines in space, each of shape (n, 3); a closed one ends with its first point."""


class RejectedFace(NamedTuple):
    """A face that is no bead."""

    face: int
    reason: str


@dataclass(frozen=True, eq=False)
class BeadTable:
    """The beads of a panel, and why its other faces are none."""

    beads: list[Bead]
    faces_not_beads: list[RejectedFace]
    diagnostics: list[Diagnostic]


class Facets(NamedTuple):
    """The facets of one face: points of shape (n, 3) in mm, triangles of shape (m, 3), int32, indices of points."""

    face: int
    points: NDArray[np.float64]
    triangles: NDArray[np.int32]


def _table(raw: dict[str, Any]) -> BeadTable:
    return BeadTable([Bead(**bead) for bead in raw["beads"]], [RejectedFace(*face) for face in raw["faces_not_beads"]],
                     [Diagnostic(**one) for one in raw["diagnostics"]])


class Panel:
    """A sheet-metal panel as faces with their exact surfaces. Made by :func:`read`."""

    def __init__(self, core: "_core.Panel") -> None:
        self._core = core
        self._composed: dict[BeadOptions, "_core.Panel"] = {}

    @property
    def input(self) -> str:
        """Name of the file."""
        return self._core.input

    @property
    def unit(self) -> str:
        """Unit of the file; everything here is in mm."""
        return self._core.unit

    @property
    def face_count(self) -> int:
        return self._core.face_count

    @property
    def diagnostics(self) -> list[Diagnostic]:
        """What the reader mended or left out."""
        return [Diagnostic(**one) for one in self._core.diagnostics]

    def facets(self) -> list[Facets]:
        """The facets of every face, in the order of the file."""
        return [Facets(*face) for face in self._core.facets()]

    def _with_composites(self, options: BeadOptions, jobs: int) -> "_core.Panel":
        """Beads of many faces as one face each; made once for the same options."""
        if options not in self._composed:
            self._composed[options] = _core.compose(self._core, options._core(), jobs)
        return self._composed[options]

    def __repr__(self) -> str:
        return f"<beadmesh.Panel {self.input!r}, {self.face_count} faces>"


def read(path: PathLike, *, unit: str = "mm", chord: float = 0.05, angle: float = 12.0, max_facet: float = 0.0,
         sew_tolerance: float = 0.01, feature_angle: float = 40.0, skin: str = "outer", jobs: int = 0) -> Panel:
    """Reads a panel by the ending of its file: STEP, IGES, BREP, STL, OBJ, PLY, shells of a Nastran, LS-DYNA or Abaqus deck.

    unit: of files that carry none (all but STEP and IGES): mm, cm, m, um, in, ft.
    chord, angle, max_facet: distance (mm) and turn (degrees) of the facets, their longest edge (mm; 0: no limit).
    sew_tolerance: free edges closer than this (mm) are one.
    feature_angle: facets that turn by more (degrees) are different faces.
    skin: what a thin solid becomes: its "outer", "inner" or "middle" skin, or "whole".
    jobs: threads, 0 for all cores.

    Ctrl-C is heard while it reads, and raises once the file is read.

    Raises BeadmeshError with a code read.*: no such file, truncated, no faces, unknown ending, ...
    """
    return Panel(_core.read(os.fspath(path), unit, chord, angle, max_facet, sew_tolerance, feature_angle, skin, jobs))


def beads(panel: Panel, options: Optional[BeadOptions] = None, *, jobs: int = 0) -> BeadTable:
    """Recognises the beads of a panel. Never fails for a single face: it is listed with its reason.

    Ctrl-C ends it early.
    """
    options = options or BeadOptions()
    composed = panel._with_composites(options, jobs)
    return _table(_core.beads(composed, options._core(), jobs))
