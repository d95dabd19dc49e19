"""Shell meshes as arrays, read from Nastran bulk data."""
from dataclasses import dataclass

import numpy as np


@dataclass
class Mesh:
    """Points (n, 3) in the unit of the deck; quads (m, 4) and triangles (k, 3) as rows of points."""
    points: np.ndarray
    quads: np.ndarray
    triangles: np.ndarray

    def elements(self):
        """All elements as tuples of rows, quads first."""
        return [tuple(map(int, e)) for e in self.quads] + [tuple(map(int, e)) for e in self.triangles]

    def size(self):
        return len(self.quads) + len(self.triangles)

    def edges(self):
        """Every edge once, (n, 2), and by how many elements it is used."""
        sides = [np.stack([e, np.roll(e, -1, axis=1)], axis=2).reshape(-1, 2)
                 for e in (self.quads, self.triangles) if len(e)]
        return np.unique(np.sort(np.concatenate(sides), axis=1), axis=0, return_counts=True)


def real(text):
    """A Nastran real: '1.5', '1.5E+2', '1.5D2' or '1.5+2'; blank is zero."""
    text = text.strip().upper().replace("D", "E")
    if not text:
        return 0.0
    try:
        return float(text)
    except ValueError:
        sign = max(text.rfind("+"), text.rfind("-"))
        if sign <= 0:
            raise
        return float(text[:sign] + "E" + text[sign:])


def fields_of(line):
    """First field and data fields of a line in free, small (8 columns) or large (16 columns) field format."""
    if "," in line:
        parts = line.split(",")
        return parts[0].strip(), [p.strip() for p in parts[1:9]]
    width, count = (16, 4) if "*" in line[:8] else (8, 8)
    return line[:8].strip(), [line[8 + width * i:8 + width * (i + 1)].strip() for i in range(count)]


def cards(lines):
    """Cards as [name, field, ...], continuation lines joined."""
    card = None
    for line in lines:
        line = line.split("$")[0].rstrip()
        if not line:
            continue
        head, data = fields_of(line)
        if head == "" or head[0] in "+*":
            if card is not None:
                card += data
            continue
        if card is not None:
            yield card
        card = [head.rstrip("*").upper()] + data
    if card is not None:
        yield card


def read_deck(path):
    """The GRID, CQUAD4 and CTRIA3 cards of a file; ValueError where an element names a node that is not there.
    Nodes that no element uses are left out."""
    nodes, quads, triangles = {}, [], []
    with open(path, errors="replace") as lines:
        for card in cards(lines):
            if card[0] == "GRID":
                nodes[int(card[1])] = [real(x) for x in card[3:6]]
            elif card[0] == "CQUAD4":
                quads.append([int(x) for x in card[3:7]])
            elif card[0] == "CTRIA3":
                triangles.append([int(x) for x in card[3:6]])
    used = sorted({n for e in quads + triangles for n in e})
    missing = [n for n in used if n not in nodes]
    if missing:
        raise ValueError(f"{path}: element on node {missing[0]}, which is not there")
    row = {n: i for i, n in enumerate(used)}
    rows = lambda elements, corners: np.array([[row[n] for n in e] for e in elements], int).reshape(-1, corners)
    return Mesh(np.array([nodes[n] for n in used], float).reshape(-1, 3), rows(quads, 4), rows(triangles, 3))
