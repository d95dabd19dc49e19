"""Meshes of a STEP panel by the program `gmsh`, called with a .geo file. Nothing of it is imported or linked."""
import os
import resource
import subprocess
import time
from dataclasses import dataclass

TIMEOUT = 30  # seconds for one mesh; a variant that needs more is stopped and named


@dataclass
class Variant:
    """One way to ask Gmsh for a quad mesh. `size_factor` corrects for the subdivision of every element."""
    name: str
    algorithm: int
    recombination: int = 1
    subdivision: int = 0
    smoothing: int = 1
    size_factor: float = 1.0


VARIANTS = [
    Variant("Delaunay, blossom", 5),
    Variant("frontal, blossom", 6),
    Variant("frontal for quads, blossom", 8),
    Variant("packing, blossom", 9),
    Variant("frontal, blossom, 20 x smoothing", 6, smoothing=20),
    Variant("frontal, full quad", 6, recombination=2),
    Variant("frontal, blossom full quad", 6, recombination=3),
    Variant("frontal, subdivided", 6, subdivision=1, size_factor=2.0),
]


@dataclass
class Run:
    """How a program's run ended: file (None where it failed), seconds of the clock and of the processor."""
    path: str
    clock: float
    processor: float
    failure: str = ""


def timed(command, out, timeout=TIMEOUT, good=(0,)):
    """Runs a command that writes the file `out`."""
    if os.path.exists(out):
        os.remove(out)
    before, start = resource.getrusage(resource.RUSAGE_CHILDREN), time.time()
    failure = ""
    try:
        done = subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, timeout=timeout)
        if done.returncode not in good or not os.path.exists(out):
            failure = (f"signal {-done.returncode}" if done.returncode < 0 else f"exit {done.returncode}") + \
                " ".join([""] + done.stderr.split())[-200:]
    except subprocess.TimeoutExpired:
        failure = f"no answer in {timeout} s"
    clock, after = time.time() - start, resource.getrusage(resource.RUSAGE_CHILDREN)
    processor = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return Run(None if failure else out, clock, processor, failure)


def run_gmsh(step, out, settings, timeout=TIMEOUT):
    """Meshes the surfaces of a STEP file into a Nastran deck; `settings` are lines of a .geo file."""
    geo = os.path.splitext(out)[0] + ".geo"
    with open(geo, "w") as file:
        file.write(f'Merge "{os.path.abspath(step)}";\n' + "".join(f"{s};\n" for s in settings) +
                   "Mesh.SaveAll = 1;\nMesh.Format = 31;\nMesh.BdfFieldFormat = 2;\n")
    return timed(["gmsh", "-2", "-v", "1", "-nopopup", geo, "-o", out], out, timeout)


def quad_mesh(step, out, size, variant, timeout=TIMEOUT):
    """A mesh of quads (and the triangles Gmsh leaves) of one element size, mm."""
    target = size * variant.size_factor
    return run_gmsh(step, out, [
        f"Mesh.MeshSizeMin = {target}", f"Mesh.MeshSizeMax = {target}", f"Mesh.Algorithm = {variant.algorithm}",
        "Mesh.RecombineAll = 1", f"Mesh.RecombinationAlgorithm = {variant.recombination}",
        f"Mesh.SubdivisionAlgorithm = {variant.subdivision}", f"Mesh.Smoothing = {variant.smoothing}"], timeout)


def facets(step, out, boxes, fine=0.6, coarse=4.0, timeout=900):
    """Triangles that stand for the surface: their corners lie on it. `boxes`: (x low, x high, y low, y high) in which
    they are fine; with 0.6 mm a crest of radius 1 mm lies 0.045 mm over the middle of a side."""
    fields = [f"Field[{i}] = Box; Field[{i}].VIn = {fine}; Field[{i}].VOut = {coarse}; Field[{i}].XMin = {x0}; "
              f"Field[{i}].XMax = {x1}; Field[{i}].YMin = {y0}; Field[{i}].YMax = {y1}; Field[{i}].ZMin = -1e4; "
              f"Field[{i}].ZMax = 1e4" for i, (x0, x1, y0, y1) in enumerate(boxes, 1)]
    every = ", ".join(str(i) for i in range(1, len(boxes) + 1))
    background = f"Field[{len(boxes) + 1}] = Min; Field[{len(boxes) + 1}].FieldsList = {{{every}}}; " \
                 f"Background Field = {len(boxes) + 1}"
    return run_gmsh(step, out, fields + [
        background, "Mesh.Algorithm = 6", "Mesh.MeshSizeExtendFromBoundary = 0", "Mesh.MeshSizeFromPoints = 0"], timeout)
