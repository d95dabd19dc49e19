"""The rules that no mesh may break, checked on the Nastran deck by code that the mesher has no part in."""
import math
import pathlib


def read_deck(path):
    """Nodes by id, elements as tuples of node ids; small and large fields as the program writes them."""
    nodes, elements = {}, []
    lines = iter(path.read_text(encoding="utf-8").splitlines())
    for line in lines:
        card = line[:8].strip()
        if card == "GRID*":
            second = next(lines)
            nodes[int(line[8:24])] = tuple(_real(text) for text in (line[40:56], line[56:72], second[8:24]))
        elif card == "GRID":
            nodes[int(line[8:16])] = tuple(_real(line[a : a + 8]) for a in (24, 32, 40))
        elif card in ("CQUAD4", "CTRIA3"):
            corners = 4 if card == "CQUAD4" else 3
            elements.append(tuple(int(line[a : a + 8]) for a in range(24, 24 + 8 * corners, 8)))
    return nodes, elements


def _real(text):
    """Also 1.5-3, as Nastran shortens 1.5E-3."""
    text = text.strip()
    for i in range(len(text) - 1, 0, -1):
        if text[i] in "+-" and text[i - 1] not in "eE":
            return float(text[:i] + "e" + text[i:])
    return float(text)


def _minus(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def _cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def _dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def scaled_jacobian(points):
    """Least over the corners: sine of the angle, against the normal of the whole element."""
    n = len(points)
    across = (_minus(points[2], points[0]), _minus(points[(3) % n], points[1]))
    normal = _cross(*across) if n == 4 else _cross(_minus(points[1], points[0]), across[0])
    length = math.sqrt(_dot(normal, normal))
    worst = 1.0
    for i in range(n):
        ahead, back = _minus(points[(i + 1) % n], points[i]), _minus(points[i - 1], points[i])
        scale = math.sqrt(_dot(ahead, ahead) * _dot(back, back)) * length
        worst = min(worst, _dot(_cross(ahead, back), normal) / scale if scale > 0 else -1.0)
    return worst


def broken_rules(path, min_edge):
    """A line for every kind of defect; empty where the mesh is sound."""
    nodes, elements = read_deck(pathlib.Path(path))
    broken = []
    sides = {}
    short = inverted = 0
    for element in elements:
        points = [nodes[n] for n in element]
        if len(set(element)) < len(element):
            broken.append(f"element {element} meets a node twice")
        inverted += scaled_jacobian(points) <= 0
        for a, b in zip(element, element[1:] + element[:1]):
            sides.setdefault((a, b), 0)
            sides[a, b] += 1
    for (a, b), uses in sides.items():
        if uses > 1:
            broken.append(f"edge {a}-{b} is used {uses} times in one direction")
        if a < b or (b, a) not in sides:
            short += math.dist(nodes[a], nodes[b]) < min_edge * (1 - 1e-4)
    if not elements:
        broken.append("no elements")
    if inverted:
        broken.append(f"{inverted} elements inverted")
    if short:
        broken.append(f"{short} edges under {min_edge:g} mm")
    if len({tuple(sorted(element)) for element in elements}) < len(elements):
        broken.append("an element stands twice")
    unused = len(nodes) - len({n for element in elements for n in element})
    if unused:
        broken.append(f"{unused} nodes without element")
    return broken + _double_nodes(nodes, min_edge / 10)


def _double_nodes(nodes, tolerance):
    """Nodes nearer than the tolerance: in the same or neighbouring cells of a grid."""
    cells = {}
    for number, point in nodes.items():
        cells.setdefault(tuple(math.floor(x / tolerance) for x in point), []).append(number)
    double = 0
    for cell, members in cells.items():
        near = [n for dx in (-1, 0, 1) for dy in (-1, 0, 1) for dz in (-1, 0, 1)
                for n in cells.get((cell[0] + dx, cell[1] + dy, cell[2] + dz), ())]
        double += sum(a < b and math.dist(nodes[a], nodes[b]) < tolerance for a in members for b in near)
    return [f"{double} pairs of nodes in one place"] if double else []
