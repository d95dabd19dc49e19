"""Time and memory of whole runs: stages, one thread and two, beside Gmsh, over the number of elements.

    python3 benchmarks/speed.py [--gmsh gmsh] [--only NAME] > table.md

Panels come from make_example_panel, so that everybody measures the same. Seconds are of the processor (user and
system, of the whole process) and on the clock; on a machine that does other things only those of the processor, and
those of two programs run in turn, can be compared. Gmsh (a program, if there is one) meshes the same file with quads
of the same size; its fastest run of the usable settings counts.
"""
import argparse
import os
import pathlib
import re
import resource
import subprocess
import sys
import tempfile
import time

PANELS = {  # name: arguments of make_example_panel
    "basic": ["basic"],
    "floor": ["floor"],
    "filleted": ["filleted"],
    "random, 20 beads": ["random", "--seed", "3", "--beads", "20", "--length", "700", "--breadth", "500", "--base", "double"],
    "random, 70 beads": ["random", "--seed", "5", "--beads", "90", "--length", "1400", "--breadth", "1000", "--base", "flat"],
    "large, 0.5 m2": ["random", "--seed", "7", "--beads", "7", "--length", "800", "--breadth", "625", "--base", "flat"],
    "large, 1.25 m2": ["random", "--seed", "7", "--beads", "18", "--length", "1250", "--breadth", "1000", "--base", "flat"],
    "large, 2.5 m2": ["random", "--seed", "7", "--beads", "35", "--length", "1800", "--breadth", "1400", "--base", "flat"],
    "large, 5 m2": ["random", "--seed", "7", "--beads", "70", "--length", "2500", "--breadth", "2000", "--base", "flat"],
}

GMSH_SETTINGS = {  # recombined, as a user would ask for quads
    "frontal quads": ["-algo", "delquad"],
    "frontal, recombined": ["-algo", "front2d"],
}


class Run:
    """One process: what it printed, its seconds and its largest memory."""

    def __init__(self, command):
        start = time.monotonic()
        with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True) as process:
            self.text = process.stdout.read()
            _, status, usage = os.wait4(process.pid, 0)
            process.returncode = os.waitstatus_to_exitcode(status)
        self.clock = time.monotonic() - start
        self.processor = usage.ru_utime + usage.ru_stime
        self.memory = usage.ru_maxrss / 1024
        self.status = process.returncode

    def stages(self):
        """Seconds of the processor per stage, from --timings."""
        rows = re.findall(r"^(\w+) +[\d.]+ +([\d.]+)$", self.text, re.MULTILINE)
        return {name: float(seconds) for name, seconds in rows}

    def clock_of_stages(self):
        rows = re.findall(r"^(\w+) +([\d.]+) +[\d.]+$", self.text, re.MULTILINE)
        return {name: float(seconds) for name, seconds in rows}

    def quads(self):
        found = re.search(r"(\d+) quads", self.text)
        return int(found.group(1)) if found else 0


def mesh(options, step, folder, jobs):
    run = Run([options.program, "mesh", step, "-o", str(folder / "mesh.bdf"), "--jobs", str(jobs), "--timings"])
    if run.status not in (0, 1):
        sys.exit(f"{step}: {run.text}")
    return run


def best_of_gmsh(options, step, folder):
    runs = []
    for arguments in GMSH_SETTINGS.values():
        run = Run([options.gmsh, step, "-2", "-nt", "1", "-clmin", "5", "-clmax", "5", "-setnumber", "Mesh.RecombineAll", "1",
                   *arguments, "-format", "bdf", "-o", str(folder / "gmsh.bdf")])
        if run.status == 0:
            runs.append(run)
    return min(runs, key=lambda run: run.processor, default=None)


STAGES = ["read", "facets", "compose", "recognise", "beads", "sheet", "assemble", "write"]


def measure(options, name, folder):
    step = str(folder / "panel.step")
    subprocess.run([options.make_panel, PANELS[name][0], step, *PANELS[name][1:]], check=True)
    one, two = mesh(options, step, folder, 1), mesh(options, step, folder, 2)
    gmsh = best_of_gmsh(options, step, folder) if options.gmsh else None
    stages, after = one.stages(), lambda run: sum(run.clock_of_stages().get(s, 0) for s in STAGES[2:])
    cells = [name, str(one.quads())] + [f"{stages.get(s, 0):.2f}" for s in STAGES]
    cells += [f"{one.processor:.2f}", f"{gmsh.processor:.2f}" if gmsh else "", f"{one.clock:.2f}", f"{two.clock:.2f}",
              f"{after(one) / max(after(two), 1e-9):.2f}", f"{one.memory:.0f}"]
    print("| " + " | ".join(cells) + " |", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", default="build/release/apps/beadmesh/beadmesh")
    parser.add_argument("--make-panel", default="build/release/examples/make_example_panel")
    parser.add_argument("--gmsh", help="the program to compare with")
    parser.add_argument("--only", help="one panel by its name")
    options = parser.parse_args()
    names = [options.only] if options.only else list(PANELS)
    head = ["panel", "quads", *STAGES, "whole", "Gmsh", "clock, 1 thread", "clock, 2", "after reading: 1 / 2", "MB"]
    print("| " + " | ".join(head) + " |\n|" + "---|" * len(head))
    with tempfile.TemporaryDirectory() as folder:
        for name in names:
            measure(options, name, pathlib.Path(folder))
    print(f"\nmemory of the children at most {resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1024:.0f} MB")


if __name__ == "__main__":
    main()
