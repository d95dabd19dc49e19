"""What is true of a panel: the footprints and centre lines of its beads in plan, from the JSON beside its STEP file.

Two forms are read: a list `features` as `make_example_panel` writes it (footprints of lines, arcs and splines), and a
short one, `beads` with polygons as `loops` and lines as `crest`."""
import json
import math
from dataclasses import dataclass, field

import numpy as np

KINDS = ("I", "generic", "annular")


@dataclass
class Bead:
    shape: str
    loops: list                                 # polygons (n, 2), mm
    lines: list = field(default_factory=list)   # centre lines (n, 2), mm, from cap centre to cap centre, or closed

    def box(self, margin):
        """(x low, x high, y low, y high) of the footprint, enlarged by `margin` mm."""
        points = np.concatenate(self.loops)
        (x0, y0), (x1, y1) = points.min(axis=0) - margin, points.max(axis=0) + margin
        return float(x0), float(x1), float(y0), float(y1)

    def holds(self, plan):
        """Which of the plan points (n, 2) lie in the footprint: an odd number of sides to their right."""
        odd = np.zeros(len(plan), bool)
        x, y = plan[:, 0], plan[:, 1]
        for loop in self.loops:
            for (ax, ay), (bx, by) in zip(loop, np.roll(loop, -1, axis=0)):
                across = (ay > y) != (by > y)
                if across.any():
                    odd ^= across & (x < ax + (bx - ax) * (y - ay) / (by - ay))
        return odd


def arc_points(arc, chord=0.01):
    """Points from an arc's start up to, but without, its end; `chord`: mm between arc and polygon."""
    step = 2 * math.acos(1 - min(1.0, chord / arc["r"]))
    count = max(2, math.ceil(abs(arc["ang"]) / step))
    angles = arc["a0"] + arc["ang"] * np.arange(count) / count
    return [[arc["c"][0] + arc["r"] * math.cos(a), arc["c"][1] + arc["r"] * math.sin(a)] for a in angles]


def polygon(edges):
    """A loop of edges {t: L, p, q}, {t: A, c, r, a0, ang} or {t: S, pts} as a polygon."""
    points = []
    for edge in edges:
        if edge["t"] == "L":
            points.append(edge["p"][:2])
        elif edge["t"] == "A":
            points += arc_points(edge)
        else:
            points += [p[:2] for p in edge["pts"][:-1]]
    return np.array(points, float)


def plan(points):
    return np.array([p[:2] for p in points], float)


def read_truth(path):
    """The beads of a truth file, of what the paper's rule calls a bead only."""
    with open(path) as file:
        data = json.load(file)
    if "features" in data:
        return [Bead(f["shape"], [polygon(loop) for loop in f["footprint"]], [plan(l) for l in f["centrelines"]])
                for f in data["features"] if f["paper_rule"] in KINDS]
    return [Bead(b["type"], [plan(l) for l in b["loops"]], [plan(l) for l in b["crest"]]) for b in data["beads"]]
