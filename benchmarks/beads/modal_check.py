#!/usr/bin/env python3
"""How far the natural frequencies of meshes are from those of a fine mesh: beadmesh, and Gmsh at equal element count.

  modal_check.py PROGRAM [PANEL.step ...] [--example single --example basic] [--size 5 --size 8] [--thickness 0.8]
                 [--work DIR] [--page PAGE.md] [--plot PLOT.svg]

Free steel panels, CalculiX elements S4 and S3, the first ten elastic frequencies compared in their order with those of
Gmsh's quads of 1.25 mm. For each size of beadmesh (minimum element length half of it) Gmsh's size is searched until it
has the same number of elements within 3 %. --page writes the table between the markers <!-- modal_check --> of a
page, --plot the errors by mode. Needs: numpy, scipy, the programs gmsh and ccx.
"""
import argparse
import os
import sys
import tempfile

import numpy as np

from deck import read_deck
from doc_page import replace_between_markers
from error_plot import error_plot
from frequencies import elastic_frequencies
from gmsh_program import VARIANTS, quad_mesh
from panels import content_key, example_panels, our_mesh

REFERENCE_SIZE = 1.25  # mm
COUNT_TOLERANCE = 0.03
RIVALS = [v for v in VARIANTS if v.name in ("frontal, blossom", "packing, blossom", "frontal, blossom full quad")]


def reference_frequencies(step, work, thickness):
    """Those of the fine mesh; kept for a STEP file of this content."""
    key = content_key(step)
    path = os.path.join(work, f"{key}-{thickness:g}-frequencies.txt")
    if not os.path.exists(path):
        run = quad_mesh(step, os.path.join(work, key + "-fine.bdf"), REFERENCE_SIZE, RIVALS[0], 600)
        if run.failure:
            raise RuntimeError(f"no reference mesh: {run.failure}")
        np.savetxt(path, elastic_frequencies(read_deck(run.path), os.path.join(work, "fine"), thickness))
    return np.loadtxt(path)


def mesh_of_count(step, out, variant, count, size):
    """Gmsh's mesh with `count` elements within the tolerance, else the nearest of eight tries; None where it fails."""
    best = None
    for _ in range(8):
        run = quad_mesh(step, out, size, variant)
        if run.failure:
            break
        mesh = read_deck(run.path)
        if best is None or abs(mesh.size() - count) < abs(best.size() - count):
            best = mesh
        if abs(mesh.size() - count) <= COUNT_TOLERANCE * count:
            break
        size *= (mesh.size() / count) ** 0.5
    return best


def rows_of(step, args):
    """(size, mesh name, elements, errors in percent) of one panel."""
    exact = reference_frequencies(step, args.work, args.thickness)
    error = lambda mesh: 100 * (elastic_frequencies(mesh, os.path.join(args.work, "modal"), args.thickness) / exact - 1)
    rows = []
    for size in args.size or [5.0, 8.0]:
        run = our_mesh(args.program, step, os.path.join(args.work, "modal-ours.bdf"), size, size / 2)
        if run.failure:
            raise RuntimeError(f"beadmesh: {run.failure}")
        ours = read_deck(run.path)
        rows.append((size, "beadmesh", ours.size(), error(ours)))
        for variant in RIVALS:
            mesh = mesh_of_count(step, os.path.join(args.work, "modal-gmsh.bdf"), variant, ours.size(), size)
            if mesh is not None:
                rows.append((size, "Gmsh, " + variant.name, mesh.size(), error(mesh)))
    return rows


def sign_of(errors):
    return "too stiff" if (errors > 0).all() else "too soft" if (errors < 0).all() else "both"


def table_lines(name, rows):
    """Markdown; the last column is our mean error as a share of that of the row."""
    ours = {size: np.abs(errors).mean() for size, mesh, _, errors in rows if mesh == "beadmesh"}
    lines = []
    for size, mesh, elements, errors in rows:
        mean = np.abs(errors).mean()
        share = "" if mesh == "beadmesh" else f"{ours[size] / mean:.2f}"
        lines.append(f"| {name} | {size:g} | {mesh} | {elements} | {mean:.1f} | {np.abs(errors).max():.1f} | "
                     f"{sign_of(errors)} | {share} |")
    return lines


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("steps", nargs="*", metavar="PANEL.step")
    parser.add_argument("--example", action="append", help="default: single and basic where no STEP file is given")
    parser.add_argument("--size", type=float, action="append")
    parser.add_argument("--thickness", type=float, default=0.8)
    parser.add_argument("--work", default=os.path.join(tempfile.gettempdir(), "beadmesh-beads"))
    parser.add_argument("--page")
    parser.add_argument("--plot")
    return parser.parse_intermixed_args()


def main():
    args = arguments()
    os.makedirs(args.work, exist_ok=True)
    names = args.example or ([] if args.steps else ["single", "basic"])
    steps = [p.step for p in example_panels(args.program, args.work, names)] + args.steps
    lines = ["| panel | size, mm | mesh | elements | mean error, % | max error, % | sign | ours / this |",
             "|---|---:|---|---:|---:|---:|---|---:|"]
    plots = []
    for step in steps:
        name = os.path.splitext(os.path.basename(step))[0]
        print(f"{name} ...", file=sys.stderr, flush=True)
        rows = rows_of(step, args)
        lines += table_lines(name, rows)
        plots += [(f"{name}, {size:g} mm", [r for r in rows if r[0] == size]) for size in dict.fromkeys(r[0] for r in rows)]
    if args.page:
        replace_between_markers(args.page, "modal_check", "\n".join(lines))
    else:
        print("\n".join(lines))
    if args.plot:
        error_plot(args.plot, plots)


if __name__ == "__main__":
    main()
