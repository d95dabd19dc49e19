"""The rows of the table: what a shell mesh makes of the beads of a panel."""
from dataclasses import dataclass

import numpy as np

from surface import Surface, heights, patches_of

CREST_TOLERANCE = 0.1  # mm
MOST_SAMPLES = 100000  # of the surface, for the gap; more are thinned evenly


@dataclass
class BeadFigures:
    """Of all beads of a panel together."""
    crest_covered: float      # share of the length of the crest lines
    edges_below_min: int      # of edges of bead elements
    triangles: int
    scaled_jacobian: float    # worst
    irregular: int            # nodes inside beads at which not exactly four quads meet
    gap: float                # mm, largest distance from the surface inside beads to the mesh
    elements: int


def scaled_jacobian(points, elements):
    """Per element the least corner value of the cross product of unit sides along the element's normal (of the
    diagonals of a quad); 1 for a square, and for an equilateral triangle."""
    p = points[elements]
    corners = p.shape[1]
    normal = np.cross(p[:, 2] - p[:, 0], p[:, 3] - p[:, 1]) if corners == 4 else np.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0])
    normal /= np.maximum(np.linalg.norm(normal, axis=1), 1e-300)[:, None]
    side = np.roll(p, -1, axis=1) - p
    side /= np.maximum(np.linalg.norm(side, axis=2), 1e-300)[:, :, None]
    values = np.einsum("ijk,ik->ij", np.cross(np.roll(side, 1, axis=1), side), normal)
    return values.min(axis=1) * (1 if corners == 4 else 2 / np.sqrt(3))


def in_beads(mesh, beads):
    """Which elements (quads first) have their centre in a footprint."""
    centres = np.concatenate([mesh.points[e].mean(axis=1)[:, :2] for e in (mesh.quads, mesh.triangles) if len(e)])
    return np.any([bead.holds(centres) for bead in beads], axis=0)


def irregular_inside(mesh, inside):
    """Nodes with bead elements all around that are not the corner of exactly four quads."""
    quads_at, triangles_at, outside_at = (np.zeros(len(mesh.points), int) for _ in range(3))
    np.add.at(quads_at, mesh.quads.ravel(), 1)
    np.add.at(triangles_at, mesh.triangles.ravel(), 1)
    is_quad = len(mesh.quads)
    np.add.at(outside_at, mesh.quads[~inside[:is_quad]].ravel(), 1)
    np.add.at(outside_at, mesh.triangles[~inside[is_quad:]].ravel(), 1)
    edges, uses = mesh.edges()
    outside_at[edges[uses == 1].ravel()] += 1  # the panel's own boundary
    return int(((outside_at == 0) & ((quads_at != 4) | (triangles_at > 0))).sum())


def resampled(line, step):
    """Points along a polyline of any dimension at even steps of about `step`, both ends included."""
    at = np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(line, axis=0), axis=1))])
    even = np.linspace(0, at[-1], max(2, int(np.ceil(at[-1] / step)) + 1))
    return np.stack([np.interp(even, at, line[:, i]) for i in range(line.shape[1])], axis=1)


@dataclass
class CrestLine:
    """A crest line on the surface, prolonged beyond loose ends, so that the edge at a tip, which goes on, counts as far
    as the crest goes. The crest itself is the stretch from `start` to `end` (mm along the points)."""
    points: np.ndarray
    start: float
    end: float

    def along(self):
        return np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(self.points, axis=0), axis=1))])


def crest_line(line, surface, beyond, step=0.25):
    """A centre line in plan, lifted onto the surface along z and prolonged by `beyond` mm; closed lines are not."""
    if np.linalg.norm(line[0] - line[-1]) < 1e-3:
        beyond = 0.0
    core = resampled(line, step)
    if beyond:
        ends = [(core[0], core[0] - core[1]), (core[-1], core[-1] - core[-2])]
        more = [p + d / np.linalg.norm(d) * beyond * np.linspace(0, 1, int(beyond / step) + 2)[1:, None] for p, d in ends]
        plan = np.concatenate([more[0][::-1], core, more[1]])
        first, last = len(more[0]), len(more[0]) + len(core) - 1
    else:
        plan, first, last = core, 0, len(core) - 1
    z = heights(surface, plan)
    there = ~np.isnan(z)
    points = np.column_stack([plan, z])[there]
    rank = np.cumsum(there) - 1
    at = np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1))])
    return CrestLine(points, at[rank[first]], at[rank[last]])


def feet_on(line, points):
    """Distance of points from a polyline, and how far along it the nearest point is."""
    a, b, at = line.points[:-1], line.points[1:], line.along()
    best, place = np.full(len(points), np.inf), np.zeros(len(points))
    side = b - a
    length2 = np.maximum(np.einsum("ij,ij->i", side, side), 1e-300)
    for i in range(len(a)):
        t = np.clip((points - a[i]) @ side[i] / length2[i], 0, 1)
        distance = np.linalg.norm(points - a[i] - t[:, None] * side[i], axis=1)
        nearer = distance < best
        best[nearer] = distance[nearer]
        place[nearer] = (at[i] + t * (at[i + 1] - at[i]))[nearer]
    return best, place


def covered(line, mesh, edges, tolerance=CREST_TOLERANCE):
    """Length of the crest line that edges cover. An edge covers the stretch between the feet of its two nodes where
    both lie within `tolerance` of the line and the stretch is as long as the edge, within a tenth."""
    at = line.along()
    closed = np.linalg.norm(line.points[0] - line.points[-1]) < 1e-3
    low, high = line.points.min(axis=0) - 1, line.points.max(axis=0) + 1
    near = np.flatnonzero(((mesh.points >= low) & (mesh.points <= high)).all(axis=1))
    distance, place = np.full(len(mesh.points), np.inf), np.zeros(len(mesh.points))
    distance[near], place[near] = feet_on(line, mesh.points[near])
    on = edges[(distance[edges] <= tolerance).all(axis=1)]
    length = np.linalg.norm(mesh.points[on[:, 0]] - mesh.points[on[:, 1]], axis=1)
    marks = np.zeros(max(1, int(round((line.end - line.start) / 0.05))), bool)
    step = (line.end - line.start) / len(marks)
    for (a, b), chord in zip(np.sort(place[on], axis=1), length):
        stretches = [(a, b)]
        if closed and b - a > at[-1] / 2:
            stretches = [(0.0, a), (b, at[-1])]
        if abs(sum(q - p for p, q in stretches) - chord) > 0.1 * chord:
            continue
        for p, q in stretches:
            first, last = (int(round((x - line.start) / step)) for x in (p, q))
            marks[max(0, first):max(0, last)] = True
    return float(marks.mean()) * (line.end - line.start)


class Reference:
    """The surface of a panel as fine facets with corners on it, and its beads."""

    def __init__(self, facets, beads, size):
        self.beads = beads
        self.surface = Surface(facets.points[facets.triangles])
        samples = facets.points[np.any([bead.holds(facets.points[:, :2]) for bead in beads], axis=0)]
        self.samples = samples[::len(samples) // MOST_SAMPLES + 1]
        self.crests = [crest_line(line, self.surface, 2 * size) for bead in beads for line in bead.lines]


def bead_figures(mesh, reference, min_edge):
    """The table's rows for one mesh."""
    inside = in_beads(mesh, reference.beads)
    quads, triangles = mesh.quads[inside[:len(mesh.quads)]], mesh.triangles[inside[len(mesh.quads):]]
    part = type(mesh)(mesh.points, quads, triangles)
    worst = min([float(scaled_jacobian(mesh.points, e).min()) for e in (quads, triangles) if len(e)], default=np.nan)
    edges, _ = mesh.edges()
    bead_edges, _ = part.edges()
    length = np.linalg.norm(mesh.points[bead_edges[:, 0]] - mesh.points[bead_edges[:, 1]], axis=1)
    total = sum(c.end - c.start for c in reference.crests)
    return BeadFigures(
        crest_covered=sum(covered(c, mesh, edges) for c in reference.crests) / total if total else np.nan,
        edges_below_min=int((length < min_edge * (1 - 1e-6)).sum()), triangles=len(triangles), scaled_jacobian=worst,
        irregular=irregular_inside(mesh, inside), elements=int(inside.sum()),
        gap=float(Surface(patches_of(mesh)).distances(reference.samples).max()))
