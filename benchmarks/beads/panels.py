"""The panels of a benchmark: our own examples, and folders of STEP files with their truth beside them."""
import hashlib
import os
import subprocess
from dataclasses import dataclass

import numpy as np

from deck import Mesh, read_deck
from gmsh_program import facets, timed

EXAMPLES = ("single", "basic", "rotated", "curved", "floor")


@dataclass
class Panel:
    name: str
    step: str
    truth: str


def maker_beside(program):
    """`make_example_panel` of the build that `program` is from."""
    return os.path.join(os.path.dirname(os.path.abspath(program)), "..", "..", "examples", "make_example_panel")


def example_panels(program, work, names=EXAMPLES):
    panels = []
    for name in names:
        panel = Panel(name, os.path.join(work, name + ".step"), os.path.join(work, name + ".truth.json"))
        subprocess.run([maker_beside(program), name, panel.step, panel.truth], check=True)
        panels.append(panel)
    return panels


def panels_in(folder):
    """Every NAME.step with NAME.truth.json or NAME.json beside it."""
    panels = []
    for file in sorted(os.listdir(folder)):
        stem = os.path.join(folder, file[:-5])
        truth = next((stem + end for end in (".truth.json", ".json") if os.path.exists(stem + end)), None)
        if file.endswith(".step") and truth:
            panels.append(Panel(file[:-5], os.path.join(folder, file), truth))
    return panels


def selected(panels, names):
    missing = set(names) - {p.name for p in panels}
    if missing:
        raise SystemExit("no such panel: " + ", ".join(sorted(missing)))
    return [p for p in panels if not names or p.name in names]


def content_key(step):
    """A name for the content of a STEP file; its header, which carries the time of writing, is left out."""
    with open(step, "rb") as file:
        return hashlib.sha256(file.read().split(b"DATA;", 1)[-1]).hexdigest()[:12]


def facets_of(panel, beads, work):
    """The fine facets of a panel, made once for a STEP file of this content."""
    kept = os.path.join(work, f"facets-{content_key(panel.step)}.npz")
    if not os.path.exists(kept):
        run = facets(panel.step, kept[:-4] + ".bdf", [bead.box(margin=1) for bead in beads])
        if run.failure:
            raise RuntimeError(f"{panel.name}: no reference facets: {run.failure}")
        mesh = read_deck(run.path)
        os.remove(run.path)
        np.savez(kept, points=mesh.points, triangles=mesh.triangles)
    with np.load(kept) as file:
        return Mesh(file["points"], np.zeros((0, 4), int), file["triangles"])


def our_mesh(program, step, out, size, min_edge, timeout=600):
    """A run of beadmesh; exit status 1 is a mesh with something named that fell short."""
    return timed([program, "mesh", step, "-o", out, "--size", str(size), "--min-edge", str(min_edge)], out, timeout, (0, 1))
