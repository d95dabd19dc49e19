"""Natural frequencies of a free panel by the program `ccx` (CalculiX), elements S4 and S3."""
import os
import re
import subprocess

import numpy as np

STEEL = {"E": 210000.0, "nu": 0.3, "density": 7.85e-9}  # N, mm, s, tonne
RIGID = 6


def oriented(mesh):
    """The elements of a mesh, turned so that neighbours agree on their side: CalculiX makes a solid of each shell
    element along its normal, and joins opposite normals rigidly."""
    elements = mesh.elements()
    at_edge = {}
    for index, e in enumerate(elements):
        for a, b in zip(e, e[1:] + e[:1]):
            at_edge.setdefault((min(a, b), max(a, b)), []).append((index, a < b))
    neighbours = {}
    for users in at_edge.values():
        for (i, forward), (j, other) in zip(users, users[1:]):
            neighbours.setdefault(i, []).append((j, forward == other))
            neighbours.setdefault(j, []).append((i, forward == other))
    turned = {}
    for seed in range(len(elements)):
        if seed in turned:
            continue
        turned[seed], front = False, [seed]
        while front:
            i = front.pop()
            for j, against in neighbours.get(i, []):
                if j not in turned:
                    turned[j] = turned[i] != against
                    front.append(j)
    return [e[::-1] if turned[i] else e for i, e in enumerate(elements)]


def write_deck(mesh, path, thickness, modes):
    """A free-free frequency step for the first `modes` modes."""
    with open(path, "w") as file:
        file.write("*NODE, NSET=ALL\n")
        for i, (x, y, z) in enumerate(mesh.points):
            file.write(f"{i + 1}, {x:.9g}, {y:.9g}, {z:.9g}\n")
        elements = list(enumerate(oriented(mesh), 1))
        for kind, corners in (("S4", 4), ("S3", 3)):
            rows = [(i, e) for i, e in elements if len(e) == corners]
            if rows:
                file.write(f"*ELEMENT, TYPE={kind}, ELSET=SHEET\n")
                file.writelines(f"{i}, " + ", ".join(str(n + 1) for n in e) + "\n" for i, e in rows)
        file.write(f"*MATERIAL, NAME=STEEL\n*ELASTIC\n{STEEL['E']}, {STEEL['nu']}\n*DENSITY\n{STEEL['density']}\n"
                   f"*SHELL SECTION, ELSET=SHEET, MATERIAL=STEEL\n{thickness}\n"
                   f"*STEP\n*FREQUENCY\n{modes}\n*END STEP\n")


def read_frequencies(path):
    """Hz, ascending, from the table of eigenvalues of a .dat file."""
    with open(path) as file:
        text = file.read()
    table = text[text.index("E I G E N V A L U E"):].split("P A R T I C I P A T I O N")[0]
    rows = re.findall(r"^\s*\d+((?:\s+[-+0-9.E]+){4})\s*$", table, re.M)
    return np.array([float(r.split()[2]) for r in rows])


def elastic_frequencies(mesh, work, thickness=0.8, count=10, timeout=900):
    """The first `count` frequencies (Hz) above the six rigid motions; `work`: path without suffix for ccx's files.
    RuntimeError where ccx fails or the rigid motions are not near zero."""
    write_deck(mesh, work + ".inp", thickness, RIGID + count)
    environment = dict(os.environ, OMP_NUM_THREADS="1")
    done = subprocess.run(["ccx", os.path.basename(work)], cwd=os.path.dirname(work), timeout=timeout, env=environment,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if done.returncode != 0 or not os.path.exists(work + ".dat"):
        raise RuntimeError("ccx: " + done.stdout.strip()[-300:])
    found = read_frequencies(work + ".dat")
    if len(found) < RIGID + count or abs(found[:RIGID]).max() > 0.05 * found[RIGID]:
        raise RuntimeError(f"ccx: not six rigid motions and {count} modes: {found}")
    return found[RIGID:RIGID + count]
