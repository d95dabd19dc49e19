"""Decks of an example panel as other programs read them: meshio, Gmsh, CalculiX, and a keyword reader of our own."""
import collections
import functools
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

import meshio
import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent / "cli"))
from command import Case, example, run  # noqa: E402
from keyword_file import KeywordFile  # noqa: E402

ENDINGS = ("bdf", "k", "inp", "vtu", "msh", "stl")
KINDS = {"I": 1, "generic": 2, "annular": 3}
SIZE = ("--size", "8")
Deck = collections.namedtuple("Deck", "path table")
_folder = tempfile.TemporaryDirectory()


@functools.cache
def deck(ending, *options):
    """The example panel meshed with elements of 8 mm and some options, and its bead table."""
    name = "_".join(("mesh",) + options).replace("--", "")
    path = pathlib.Path(_folder.name) / f"{name}.{ending}"
    table = path.with_suffix(f".{ending}.json")
    done = run("mesh", example("basic"), "-o", path, "--json", table, *SIZE, *options)
    assert done.returncode <= 1, done.stderr
    return Deck(path, json.loads(table.read_text()))


def count(mesh, kind):
    return sum(len(block.data) for block in mesh.cells if block.type == kind)


def gmsh_counts(path):
    """Nodes, quads, triangles, physical surfaces and curves, as the program gmsh counts them."""
    script = path.with_suffix(".geo")
    script.write_text(f'Merge "{path}";\ns() = Physical Surface{{:}};\nc() = Physical Curve{{:}};\n'
                      'Printf("counts %g %g %g %g %g", Mesh.NbNodes, Mesh.NbQuadrangles, Mesh.NbTriangles, #s(), #c());\n')
    done = subprocess.run(["gmsh", "-parse_and_exit", str(script)], capture_output=True, text=True, timeout=120)
    assert done.returncode == 0 and "Error" not in done.stdout + done.stderr, done.stdout
    return [int(word) for word in re.search(r"counts (.*)", done.stdout + done.stderr)[1].split()]


class ReadBack(Case):
    """Counts of nodes, elements and sets are those of the bead table."""

    def assert_counts(self, made, nodes, quads, trias):
        expected = made.table["mesh"]
        self.assertGreater(expected["quads"], 800)
        self.assertEqual((expected["nodes"], expected["quads"], expected["trias"]), (nodes, quads, trias))

    def assert_bead_elements(self, made, elements_of_bead):
        for bead in made.table["beads"]:
            self.assertEqual(bead["mesh"]["elements"], elements_of_bead[bead["id"]])

    def test_every_format_has_the_same_nodes(self):
        points = {}
        for ending in ENDINGS[:1] + ENDINGS[2:5]:
            points[ending] = meshio.read(deck(ending).path).points
        points["k"] = np.array(list(KeywordFile(deck("k").path).nodes.values()))
        for ending in ("k", "inp", "vtu"):
            self.assertLess(np.abs(points[ending] - points["bdf"]).max(), 1e-7, ending)
        by_place = [p[np.lexsort(np.round(p, 6).T)] for p in (points["msh"], points["bdf"])]
        self.assertLess(np.abs(by_place[0] - by_place[1]).max(), 1e-7)

    def test_nastran(self):
        made = deck("bdf")
        mesh = meshio.read(made.path)
        self.assert_counts(made, len(mesh.points), count(mesh, "quad"), count(mesh, "triangle"))
        self.assert_counts(made, *gmsh_counts(made.path)[:3])

    def test_ls_dyna(self):
        made = deck("k")
        file = KeywordFile(made.path)
        shapes = collections.Counter(len(corners) for _, corners in file.shells.values())
        self.assert_counts(made, len(file.nodes), shapes[4], shapes[3])
        self.assert_bead_elements(made, {b: len(file.shell_sets[10000 + b].members) for b in range(1, 5)})
        self.assertEqual({"sheet", "bead_I", "bead_generic", "bead_annular"}, {name for name, *_ in file.parts.values()})
        for part, corners in file.shells.values():
            self.assertIn(part, file.parts)
            self.assertTrue(set(corners) <= file.nodes.keys())
        for _, section, material in file.parts.values():
            self.assertEqual([1.0] * 4, file.sections[section])
            self.assertEqual((7.85e-9, 210000, 0.3), file.materials[material])
        self.assertIn("*CONTROL_TERMINATION", file.keywords)
        self.check_sets(made, file.shells, file.node_sets, file.shell_sets)

    def check_sets(self, made, shells, node_sets, shell_sets):
        """Crest, boundary and caps by their meaning."""
        for bead in (b["id"] for b in made.table["beads"]):
            elements = set(shell_sets[10000 + bead].members)
            edges = collections.Counter()
            for e in elements:
                corners = shells[e][1]
                edges.update(frozenset(pair) for pair in zip(corners, corners[1:] + corners[:1]))
            boundary = {node for edge, uses in edges.items() if uses == 1 for node in edge}
            self.assertEqual(boundary, set(node_sets[30000 + bead].members))
            crest = set(node_sets[20000 + bead].members)
            self.assertTrue(crest <= {node for e in elements for node in shells[e][1]})
            is_ring = made.table["beads"][bead - 1]["kind"] == "annular"
            self.assertEqual(made.table["beads"][bead - 1]["ends"], len(crest & boundary))
            self.assertEqual(is_ring, 40000 + bead not in shell_sets)
            if not is_ring:
                caps = set(shell_sets[40000 + bead].members)
                self.assertTrue(caps < elements)
                tips = crest & boundary
                at_tips = {e for e in elements if tips & set(shells[e][1])}
                self.assertTrue(at_tips <= caps)

    def test_abaqus(self):
        made = deck("inp")
        mesh = meshio.read(made.path)
        self.assert_counts(made, len(mesh.points), count(mesh, "quad"), count(mesh, "triangle"))
        self.assert_bead_elements(made, {b: sum(map(len, mesh.cell_sets[f"bead_{b}"])) for b in range(1, 5)})
        reference = KeywordFile(deck("k").path)
        for bead in range(1, 5):
            for base, name in ((20000, "crest"), (30000, "boundary")):
                self.assertEqual(len(reference.node_sets[base + bead].members), len(mesh.point_sets[f"bead_{bead}_{name}"]))
        for bead in range(1, 4):
            self.assertEqual(len(reference.shell_sets[40000 + bead].members),
                             sum(map(len, mesh.cell_sets[f"bead_{bead}_caps"])))

    def test_vtu(self):
        made = deck("vtu")
        mesh = meshio.read(made.path)
        self.assert_counts(made, len(mesh.points), count(mesh, "quad"), count(mesh, "triangle"))
        cells = {name: np.concatenate(blocks) for name, blocks in mesh.cell_data.items()}
        self.assert_bead_elements(made, {b: (cells["bead"] == b).sum() for b in range(1, 5)})
        for bead in made.table["beads"]:
            self.assertEqual({KINDS[bead["kind"]]}, set(cells["kind"][cells["bead"] == bead["id"]]))
            self.assertEqual({bead["faces"][0]}, set(cells["face"][cells["bead"] == bead["id"]]))
        self.assertEqual({0}, set(cells["kind"][cells["bead"] == 0]))
        quality = made.table["mesh"]["quality"]
        self.assertAlmostEqual(quality["scaled_jacobian_min"], cells["scaled_jacobian"].min(), places=5)
        self.assertAlmostEqual(quality["edge_min"], cells["shortest_edge"].min(), places=5)
        reference = KeywordFile(deck("k").path)
        for bead in range(1, 5):
            crest = {n + 1 for n in np.flatnonzero(mesh.point_data["crest"] == bead)}
            self.assertEqual(set(reference.node_sets[20000 + bead].members), crest)

    def test_gmsh(self):
        made = deck("msh")
        nodes, quads, trias, surfaces, curves = gmsh_counts(made.path)
        self.assert_counts(made, nodes, quads, trias)
        self.assertEqual((4 + 4 + 3, 8), (surfaces, curves))  # parts, beads, caps; crests, boundaries
        mesh = meshio.read(made.path)
        self.assert_counts(made, len(mesh.points), count(mesh, "quad"), count(mesh, "triangle"))
        members = lambda name: sum(len(part) for part in mesh.cell_sets[name])
        self.assert_bead_elements(made, {b: members(f"bead_{b}") for b in range(1, 5)})
        reference = KeywordFile(deck("k").path)
        for bead in range(1, 5):  # a boundary of loops has as many lines as nodes
            self.assertEqual(len(reference.node_sets[30000 + bead].members), members(f"bead_{bead}_boundary"))

    def test_stl(self):
        made = deck("stl")
        mesh = meshio.read(made.path)
        expected = made.table["mesh"]
        self.assertEqual(expected["nodes"], len(mesh.points))
        self.assertEqual(2 * expected["quads"] + expected["trias"], count(mesh, "triangle"))
        self.assertEqual(made.path.stat().st_size, 84 + 50 * count(mesh, "triangle"))
        self.assertTrue(made.path.read_bytes().startswith(b"beadmesh "))


class Solver(Case):
    """CalculiX runs the deck as it is."""

    def test_modes_of_the_free_panel(self):
        made = deck("inp")
        done = subprocess.run(["ccx", made.path.stem], cwd=made.path.parent, capture_output=True, text=True, timeout=600)
        self.assertEqual(0, done.returncode, done.stdout[-2000:])
        self.assertNotIn("*ERROR", done.stdout)
        self.assertIn("Job finished", done.stdout)
        modes = made.path.with_suffix(".dat").read_text()
        rows = re.findall(r"^\s+\d+((?:\s+[-+0-9.E]+){4})\s*$", modes.split("P A R T I C I P A T I O N")[0], re.M)
        hertz = [float(row.split()[2]) for row in rows]
        self.assertEqual(16, len(hertz))
        self.assertLess(max(map(abs, hertz[:6])), 0.05 * hertz[6])  # six rigid motions
        self.assertGreater(hertz[6], 1)


class Numbering(Case):
    """Ids start where they are asked to, in every format that has them."""

    def test_offset(self):
        options = ("--id-offset", "7000", "--first-node", "501")
        expected = deck("k").table["mesh"]
        file = KeywordFile(deck("k", *options).path)
        self.assertEqual(range(501, 501 + expected["nodes"]), range(min(file.nodes), max(file.nodes) + 1))
        self.assertEqual((7001, 7000 + expected["quads"]), (min(file.shells), max(file.shells)))
        self.assertEqual({7001, 7002, 7003, 7004}, set(file.parts))
        self.assertEqual({7001}, set(file.materials))
        self.assertIn(17001, file.shell_sets)
        plain = KeywordFile(deck("k").path)
        self.assertEqual([e + 7000 for e in plain.shell_sets[10001].members], file.shell_sets[17001].members)
        self.assertEqual([n + 500 for n in plain.node_sets[20001].members], file.node_sets[27001].members)
        for ending in ("bdf", "inp", "msh"):
            shifted, first = deck(ending, *options).path, deck(ending).path
            a, b = meshio.read(shifted), meshio.read(first)
            self.assertTrue(np.array_equal(a.points, b.points), ending)
            for x, y in zip(a.cells, b.cells):
                self.assertTrue(np.array_equal(x.data, y.data), ending)
            self.assertNotEqual(shifted.read_text(), first.read_text())

    def test_from_the_configuration_file(self):
        config = self.file("ids.toml", b"size = 8\n[deck]\nid_offset = 7000\nfirst_node = 501\n")
        out = self.folder / "mesh.k"
        self.assertLessEqual(run("mesh", example("basic"), "-o", out, "--config", config).returncode, 1)
        self.assertEqual(deck("k", "--id-offset", "7000", "--first-node", "501").path.read_bytes(), out.read_bytes())

    def test_ids_that_do_not_fit(self):
        out = self.folder / "mesh.k"
        self.assert_refused("mesh", example("basic"), "-o", out, "--first-node", "0", names="first node id")
        self.assert_refused("mesh", example("basic"), "-o", out, "--first-element", "99999000", names="99999999")
        self.assert_refused("mesh", example("basic"), "-o", out, "--analysis", "crash", names="modes, none")


class ForInclusion(Case):
    """--analysis none leaves out what makes the solver run."""

    def test_no_control(self):
        words = {"bdf": ("SOL 103", "CEND", "BEGIN BULK", "EIGRL", "ENDDATA", "METHOD"),
                 "k": ("*CONTROL", "*TITLE"), "inp": ("*HEADING", "*STEP", "*FREQUENCY")}
        for ending, parts in words.items():
            made = deck(ending, "--analysis", "none")
            for part in parts:
                self.assertNotIn(part, made.path.read_text())
                self.assertIn(part, deck(ending).path.read_text())

    def test_nastran_sets_are_bulk_data(self):
        made = deck("bdf", "--analysis", "none")
        lines = made.path.read_text().splitlines()
        start = next(i for i, line in enumerate(lines) if line.startswith("SET1       10001"))
        members = lines[start][16:].split()
        for line in lines[start + 1:]:
            if not line.startswith("        "):
                break
            members += line.split()
        reference = KeywordFile(deck("k").path).shell_sets[10001].members
        self.assertEqual(reference, [int(m) for m in members])

    def test_calculix_includes_it(self):
        part = deck("inp", "--analysis", "none")
        whole = self.folder / "run.inp"
        whole.write_text(f"*INCLUDE, INPUT={part.path}\n*BOUNDARY\nbead_1_boundary, 1, 6\n*STEP\n*STATIC\n"
                         f"*CLOAD\nbead_2_crest, 3, 1.0\n*NODE PRINT, NSET=bead_2_crest\nU\n*END STEP\n")
        done = subprocess.run(["ccx", "run"], cwd=self.folder, capture_output=True, text=True, timeout=600)
        self.assertEqual(0, done.returncode, done.stdout[-2000:])
        self.assertNotIn("*ERROR", done.stdout)
        table = (self.folder / "run.dat").read_text()
        moved = [float(line.split()[3]) for line in table.splitlines() if re.match(r"\s+\d+\s", line)]
        self.assertTrue(moved and min(moved) > 0, table[:500])


if __name__ == "__main__":
    unittest.main()
