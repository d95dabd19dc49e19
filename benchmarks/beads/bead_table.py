#!/usr/bin/env python3
"""What beadmesh and the program Gmsh make of the beads of panels, in one run.

  bead_table.py PROGRAM [PANEL ...] [--folder DIR ...] [--size 5] [--min-edge 2.5] [--timeout 30] [--work DIR] [--page PAGE.md]

Panels are our own examples (`make_example_panel` of the build that PROGRAM is from) and, with --folder, STEP files with a
truth file beside them. Every Gmsh variant of gmsh_program.py meshes every panel; the row "best Gmsh" takes each column
from the variant that is best in it. --all prints the variants one by one. --page writes the tables between the
markers <!-- bead_table --> of a page instead. Needs: numpy, scipy, the program gmsh.
"""
import argparse
import math
import os
import sys
import tempfile

from deck import read_deck
from doc_page import replace_between_markers
from gmsh_program import TIMEOUT, VARIANTS, quad_mesh
from measures import Reference, bead_figures
from panels import example_panels, facets_of, our_mesh, panels_in, selected
from truth import read_truth

COLUMNS = [  # title, figure, greater is better, format
    ("crest covered, %", "crest_covered", True, lambda x: f"{100 * x:.1f}"),
    ("edges below", "edges_below_min", False, str),
    ("triangles", "triangles", False, str),
    ("scaled Jacobian, min", "scaled_jacobian", True, lambda x: f"{x:.2f}"),
    ("irregular nodes", "irregular", False, str),
    ("gap, mm", "gap", False, lambda x: f"{x:.2f}"),
    ("processor, s", "processor", False, lambda x: f"{x:.2f}"),
    ("clock, s", "clock", False, lambda x: f"{x:.2f}"),
]


def figures_of(run, reference, min_edge):
    """Figures by name of a finished run."""
    figures = vars(bead_figures(read_deck(run.path), reference, min_edge))
    return {**figures, "processor": run.processor, "clock": run.clock}


def best_of(rows):
    """The best figure of each column, and the range of the number of elements."""
    best = {}
    for _, name, greater, _ in COLUMNS:
        values = [r[name] for r in rows if not math.isnan(r[name])]
        best[name] = (max if greater else min)(values, default=math.nan)
    counts = sorted(r["elements"] for r in rows)
    best["elements"] = f"{counts[0]} to {counts[-1]}" if counts else "-"
    return best


def line(panel, program, figures):
    cells = [text(figures[name]) if not math.isnan(figures[name]) else "-" for _, name, _, text in COLUMNS]
    return "| " + " | ".join([panel, program, str(figures["elements"])] + cells) + " |"


def header():
    titles = ["panel", "program", "elements"] + [c[0] for c in COLUMNS]
    return ["| " + " | ".join(titles) + " |", "|---|---|" + "---:|" * (len(titles) - 2)]


def quicker(runs):
    """The run with the least processor time of those that gave a mesh, else the last."""
    return min((r for r in runs if r.path), key=lambda r: r.processor, default=runs[-1])


def panel_rows(panel, args):
    """Lines of one panel and the variants that failed as (variant, why)."""
    beads = read_truth(panel.truth)
    reference = Reference(facets_of(panel, beads, args.work), beads, args.size)
    out = os.path.join(args.work, f"{panel.name}-ours.bdf")
    ours = quicker([our_mesh(args.program, panel.step, out, args.size, args.min_edge) for _ in range(2)])
    if ours.failure:
        raise RuntimeError(f"{panel.name}: {ours.failure}")
    lines = [line(panel.name, "beadmesh", figures_of(ours, reference, args.min_edge))]
    good, failed = [], []
    for variant in VARIANTS:
        out = os.path.join(args.work, f"{panel.name}-gmsh.bdf")
        run = quad_mesh(panel.step, out, args.size, variant, args.timeout)
        if run.failure:
            failed.append((variant.name, run.failure))
            continue
        good.append(figures_of(run, reference, args.min_edge))
        if args.all:
            lines.append(line(panel.name, variant.name, good[-1]))
    lines.append(line(panel.name, "best Gmsh", best_of(good)))
    return lines, failed


def table(panels, args):
    """The table as Markdown lines, and below it what failed."""
    lines, failures = header(), {}
    for panel in panels:
        print(f"{panel.name} ...", file=sys.stderr, flush=True)
        try:
            rows, failed = panel_rows(panel, args)
        except (RuntimeError, ValueError) as error:
            rows, failed = [f"| {panel.name} | failed: {error} |" + " |" * (len(COLUMNS) + 1)], []
        lines += rows
        print("\n".join(rows), file=sys.stderr, flush=True)
        for variant, why in failed:
            failures.setdefault(f"{variant}: {why}", []).append(panel.name)
    lines += [""] + [f"Gmsh failed with {why} ({', '.join(names)})." for why, names in failures.items()]
    return lines


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("names", nargs="*", metavar="PANEL")
    parser.add_argument("--folder", action="append", default=[])
    parser.add_argument("--size", type=float, default=5.0)
    parser.add_argument("--min-edge", type=float, default=2.5)
    parser.add_argument("--timeout", type=float, default=TIMEOUT)
    parser.add_argument("--work", default=os.path.join(tempfile.gettempdir(), "beadmesh-beads"))
    parser.add_argument("--all", action="store_true")
    parser.add_argument("--page")
    return parser.parse_intermixed_args()


def main():
    args = arguments()
    os.makedirs(args.work, exist_ok=True)
    panels = example_panels(args.program, args.work)
    for folder in args.folder:
        panels += panels_in(folder)
    text = "\n".join([f"Size {args.size:g} mm, minimum element length {args.min_edge:g} mm.", ""] +
                     table(selected(panels, args.names), args))
    if args.page:
        replace_between_markers(args.page, "bead_table", text)
    else:
        print(text)


if __name__ == "__main__":
    main()
