"""Panels that exist only as facets: a smooth bead has no edge of its own there."""
import json
import math
import random
import struct
import unittest

from command import Case, run


def stadium(x, y, half_length, half_width, height):
    """Height of a bead along x that leaves its sheet without an edge."""
    d = math.hypot(max(abs(x) - half_length, 0.0), y)
    return height * math.cos(math.pi * d / (2 * half_width)) ** 2 if d < half_width else 0.0


def ring(x, y, radius, half_width, height):
    d = abs(math.hypot(x, y) - radius)
    return height * math.cos(math.pi * d / (2 * half_width)) ** 2 if d < half_width else 0.0


def two_beads(x, y):
    return stadium(x + 50, y, 40, 9, 5) + ring(x - 60, y, 26, 9, 5)


class Grid:
    """A height field on a grid of quads."""

    def __init__(self, height, size_x=220.0, size_y=100.0, step=1.5):
        columns, rows = round(size_x / step), round(size_y / step)
        self.points = []
        for i in range(columns + 1):
            for j in range(rows + 1):
                x, y = i * size_x / columns - size_x / 2, j * size_y / rows - size_y / 2
                self.points.append((x, y, height(x, y)))
        self.quads = [(i * (rows + 1) + j, (i + 1) * (rows + 1) + j, (i + 1) * (rows + 1) + j + 1, i * (rows + 1) + j + 1)
                      for i in range(columns) for j in range(rows)]

    @property
    def triangles(self):
        return [t for a, b, c, d in self.quads for t in ((a, b, c), (a, c, d))]

    def moved(self, move):
        self.points = [move(p) for p in self.points]
        return self


def ascii_stl(grid):
    out = ["solid panel"]
    for t in grid.triangles:
        out += ["facet normal 0 0 0", "outer loop", *("vertex %.9g %.9g %.9g" % grid.points[i] for i in t), "endloop",
                "endfacet"]
    return ("\n".join(out) + "\nendsolid panel\n").encode()


def binary_stl(grid, triangles=None):
    triangles = triangles or grid.triangles
    facets = (struct.pack("<12fH", 0, 0, 0, *(x for i in t for x in grid.points[i]), 0) for t in triangles)
    return bytes(80) + struct.pack("<I", len(triangles)) + b"".join(facets)


def obj(grid):
    lines = ["v %.9g %.9g %.9g" % p for p in grid.points] + ["f %d %d %d %d" % tuple(i + 1 for i in q) for q in grid.quads]
    return "\n".join(lines).encode()


def ply(grid, form):
    head = (f"ply\nformat {form} 1.0\nelement vertex {len(grid.points)}\nproperty double x\nproperty double y\n"
            f"property double z\nelement face {len(grid.quads)}\nproperty list uchar int vertex_indices\nend_header\n")
    if form == "ascii":
        rows = ["%.9g %.9g %.9g" % p for p in grid.points] + ["4 %d %d %d %d" % q for q in grid.quads]
        return (head + "\n".join(rows) + "\n").encode()
    order = "<" if form == "binary_little_endian" else ">"
    return head.encode() + b"".join(struct.pack(order + "3d", *p) for p in grid.points) + b"".join(
        struct.pack(order + "B4i", 4, *q) for q in grid.quads)


def nastran(grid, part=lambda quad: 3):
    lines = ["BEGIN BULK", "PSHELL,3,1,1.25", "PSHELL,8,1,0.75"]
    lines += ["GRID,%d,,%.4f,%.4f,%.4f" % (i, *p) for i, p in enumerate(grid.points, 1)]
    lines += ["CQUAD4,%d,%d,%d,%d,%d,%d" % (e, part(q), *(i + 1 for i in q)) for e, q in enumerate(grid.quads, 1)]
    return ("\n".join(lines) + "\nENDDATA\n").encode()


def lsdyna(grid):
    lines = ["*KEYWORD", "*NODE"] + ["%8d%16.6f%16.6f%16.6f" % (i, *p) for i, p in enumerate(grid.points, 1)]
    lines += ["*PART", "floor", "%10d%10d%10d" % (3, 1, 1), "*SECTION_SHELL", "%10d" % 1, "%10g" % 1.25, "*ELEMENT_SHELL"]
    lines += ["%8d%8d%8d%8d%8d%8d" % (e, 3, *(i + 1 for i in q)) for e, q in enumerate(grid.quads, 1)]
    return ("\n".join(lines) + "\n*END\n").encode()


def abaqus(grid):
    lines = ["*NODE"] + ["%d, %.6f, %.6f, %.6f" % (i, *p) for i, p in enumerate(grid.points, 1)]
    lines += ["*ELEMENT, TYPE=S4R, ELSET=floor"] + ["%d, %d, %d, %d, %d" % (e, *(i + 1 for i in q))
                                                    for e, q in enumerate(grid.quads, 1)]
    return ("\n".join(lines) + "\n*SHELL SECTION, ELSET=floor, MATERIAL=steel\n1.25\n").encode()


class FacettedCase(Case):
    def beads(self, name, content, *arguments):
        result = run("beads", self.file(name, content), "--json", "-", *arguments)
        self.assertEqual(0, result.returncode, result.stderr)
        return json.loads(result.stdout)["beads"]

    def check(self, name, content, *arguments, delta=0.12, crests=(5.0, 5.0)):
        """The bead and the ring of `two_beads`."""
        found = self.beads(name, content, *arguments)
        self.assertEqual(["I", "annular"], sorted(bead["kind"] for bead in found))
        for bead in found:
            length, crest = (80, crests[0]) if bead["kind"] == "I" else (2 * math.pi * 26, crests[1])
            self.assertAlmostEqual(1, bead["length"] / length, delta=delta)
            self.assertAlmostEqual(1, bead["width"] / 18, delta=1.3 * delta)
            self.assertAlmostEqual(1, bead["height"] / crest, delta=0.2)
            self.assertTrue(0 < bead["confidence"] <= 1)
        return found


class FacettedPanels(FacettedCase):
    def test_stl(self):
        grid = Grid(two_beads)
        first = self.check("panel.stl", ascii_stl(grid))
        second = self.check("binary.stl", binary_stl(grid))
        self.assertEqual([b["kind"] for b in first], [b["kind"] for b in second])

    def test_obj_and_ply(self):
        grid = Grid(two_beads)
        self.check("panel.obj", obj(grid))
        for form in ("ascii", "binary_little_endian", "binary_big_endian"):
            self.check("panel.ply", ply(grid, form))

    def test_shell_decks(self):
        grid = Grid(two_beads)
        self.check("panel.bdf", nastran(grid))
        self.check("panel.k", lsdyna(grid))
        self.check("panel.inp", abaqus(grid))

    def test_outlines_that_facets_do_not_follow(self):
        grid = Grid(two_beads, step=2)  # the outline is a staircase, its ends would be octagons
        self.check("panel.bdf", nastran(grid))

    def test_coarse_shells(self):
        grid = Grid(two_beads, step=4)  # no node lies on the crest of the straight bead
        crests = [max(z for x, _, z in grid.points if side * x > 0) for side in (-1, 1)]
        self.check("panel.bdf", nastran(grid), delta=0.2, crests=crests)

    def test_curved_sheet(self):
        self.check("panel.stl", binary_stl(Grid(lambda x, y: two_beads(x, y) - x * x / 1200 + y * y / 3000)))

    def test_units(self):
        grid = Grid(two_beads).moved(lambda p: tuple(x / 25.4 for x in p))
        self.check("panel.stl", binary_stl(grid), "--unit", "inch")

    def test_turned_in_space_mirrored_and_upside_down(self):
        c, s = math.cos(0.7), math.sin(0.7)

        def turn(p):
            x, y, z = -p[0], p[1], p[2]
            x, y = c * x - s * y, s * x + c * y
            return x, c * y - s * z, s * y + c * z

        self.check("panel.stl", binary_stl(Grid(two_beads).moved(turn)))

    def test_facets_in_any_order_and_orientation(self):
        grid = Grid(two_beads)
        triangles = grid.triangles
        chance = random.Random(7)
        chance.shuffle(triangles)
        triangles = [t if chance.random() < 0.5 else (t[1], t[0], t[2]) for t in triangles]
        self.check("panel.stl", binary_stl(grid, triangles))

    def test_sheet_that_only_bends(self):
        found = self.beads("panel.stl", binary_stl(Grid(lambda x, y: (x * x + y * y) / 800)))
        self.assertEqual([], found)

    def test_plateau_is_no_bead(self):
        def plateau(x, y):
            d = max(abs(x) - 30, abs(y) - 20, 0)
            return 5 * math.cos(math.pi * d / 24) ** 2 if d < 12 else 0

        self.assertEqual([], self.beads("panel.stl", binary_stl(Grid(plateau))))

    def test_same_result_on_any_number_of_threads(self):
        path = self.file("panel.stl", binary_stl(Grid(two_beads, step=2)))
        one, four = (run("beads", path, "--json", "-", "--jobs", n).stdout for n in (1, 4))
        self.assertEqual(one, four)


class FacettedMeshes(FacettedCase):
    def test_bead_by_blocks(self):
        path = self.file("panel.stl", binary_stl(Grid(two_beads)))
        out = self.folder / "out.json"
        result = run("mesh", path, "-o", self.folder / "out.bdf", "--json", out)
        self.assertIn(result.returncode, (0, 1), result.stderr)
        found = json.loads(out.read_text())
        self.assertEqual(["blocks", "blocks"], [bead["mesh"]["method"] for bead in found["beads"]])
        self.assertEqual(0, found["mesh"]["trias"])


    def test_properties_of_a_deck_are_kept(self):
        grid = Grid(two_beads, step=2)
        path = self.file("panel.bdf", nastran(grid, part=lambda quad: 8 if grid.points[quad[0]][0] > 8 else 3))
        out = self.folder / "out.bdf"
        self.assertIn(run("mesh", path, "-o", out).returncode, (0, 1))
        lines = out.read_text().splitlines()
        field = lambda line, i: line[8 * i:8 * i + 8].strip()
        thickness = {field(l, 1): float(field(l, 3)) for l in lines if l.startswith("PSHELL")}
        self.assertEqual((1.25, 0.75), (thickness["3"], thickness["8"]))
        x = {l[8:24].strip(): float(l[40:56]) for l in lines if l.startswith("GRID*")}
        found = {"3": 0, "8": 0}
        for line in lines:
            if not line.startswith("CQUAD4"):
                continue
            number, middle = field(line, 2), sum(x[field(line, i)] for i in range(3, 7)) / 4
            self.assertEqual(1.25 if middle < 8.5 else 0.75, thickness[number], line)
            found[number] = found.get(number, 0) + 1
        self.assertTrue(found["3"] > 100 and found["8"] > 100, found)


class BrokenFacets(Case):
    """Every broken file is refused with one line."""

    def refuse(self, name, content, *words):
        with self.subTest(name):
            path = self.file(name, content if isinstance(content, bytes) else content.encode())
            line = self.assert_refused("mesh", path, "-o", self.folder / "out.bdf", names=name)
            for word in words:
                self.assertIn(word, line)

    def test_obj(self):
        good = obj(Grid(lambda x, y: 0, step=20)).decode()
        self.refuse("empty.obj", "")
        self.refuse("noise.obj", bytes(range(256)) * 10)
        self.refuse("no_faces.obj", "v 0 0 0\n", "no facets")
        self.refuse("missing.obj", good + "\nf 1 2 9999\n", "line")
        self.refuse("huge.obj", good + "\nf 1 2 99999999999999999999\n", "line")
        self.refuse("nan.obj", good.replace("v -110", "v nan", 1), "not finite")
        self.refuse("word.obj", good.replace("v -110", "v x", 1), "line 1")

    def test_ply(self):
        whole = ply(Grid(lambda x, y: 0, step=20), "binary_little_endian")
        text = ply(Grid(lambda x, y: 0, step=20), "ascii").decode()
        self.refuse("empty.ply", "")
        self.refuse("noise.ply", bytes(range(256)) * 10)
        self.refuse("header.ply", whole[:60], "header")
        self.refuse("cut.ply", whole[:-7], "face")
        self.refuse("count.ply", text.replace("element face ", "element face -"), "element face")
        self.refuse("huge.ply", text.replace("element vertex ", "element vertex 10000"), "vertex")
        self.refuse("index.ply", text.replace("4 0 ", "4 9999 "), "face 1")
        self.refuse("nan.ply", text.replace("-110 ", "nan ", 1), "not finite")
        self.refuse("format.ply", text.replace("ascii", "binary_middle_endian"), "format")

    def test_decks(self):
        grid = Grid(lambda x, y: 0, step=20)
        for name, whole, node in (("a.bdf", nastran(grid).decode(), "GRID,5,"), ("a.inp", abaqus(grid).decode(), "\n5, "),
                                  ("a.k", lsdyna(grid).decode(), "\n       5")):
            self.refuse("empty_" + name, "")
            self.refuse("noise_" + name, bytes(range(256)) * 10)
            self.refuse("nothing_" + name, "$ nothing\n" if name != "a.inp" else "** nothing\n", "no shells")
            self.refuse("missing_" + name, whole.replace(node, node.replace("5", "9"), 1), "node")
            self.refuse("nan_" + name, whole.replace("-110.00", "    nan", 1), "line")
        self.refuse("include.k", "*KEYWORD\n*INCLUDE\nother.k\n*END\n", "line 2", "INCLUDE")
        self.refuse("include.inp", "*INCLUDE, INPUT=other.inp\n", "line 1", "INCLUDE")
        self.refuse("include.bdf", "INCLUDE 'other.bdf'\n", "line 1", "INCLUDE")

    def test_wrong_unit(self):
        path = self.file("a.obj", obj(Grid(lambda x, y: 0, step=20)))
        self.assert_refused("beads", path, "--unit", "furlong", names="furlong")


if __name__ == "__main__":
    unittest.main()
