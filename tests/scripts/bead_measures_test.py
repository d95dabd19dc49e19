"""The measuring modules of benchmarks/beads give the answers that are known beforehand."""
import math
import os
import sys
import tempfile
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "benchmarks", "beads"))

import numpy as np

from deck import Mesh, read_deck
from doc_page import replace_between_markers
from frequencies import oriented, read_frequencies
from measures import Reference, bead_figures, covered, crest_line, irregular_inside, scaled_jacobian
from surface import Surface, heights, nearest_on_triangles, patches_of
from truth import Bead, polygon

NO_TRIANGLES = np.zeros((0, 3), int)


def grid(columns, rows, step=1.0, z=lambda x, y: 0 * x):
    """Squares over [0, columns * step] x [0, rows * step], lifted by z."""
    x, y = (a.ravel() for a in np.meshgrid(np.arange(columns + 1.0) * step, np.arange(rows + 1.0) * step, indexing="ij"))
    at = lambda i, j: i * (rows + 1) + j
    quads = [[at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)] for i in range(columns) for j in range(rows)]
    return Mesh(np.column_stack([x, y, z(x, y)]), np.array(quads), NO_TRIANGLES)


def written(text):
    file = tempfile.NamedTemporaryFile("w", suffix=".bdf", delete=False)
    with file:
        file.write(text)
    return file.name


class Reading(unittest.TestCase):
    def read(self, text):
        path = written(text)
        try:
            return read_deck(path)
        finally:
            os.remove(path)

    def test_all_field_formats(self):
        small = f"{'GRID':8}{1:8}{'':8}{'0.0':>8}{'1.5+1':>8}{'-2-1':>8}\n"
        large = f"{'GRID*':8}{2:16}{'':16}{'1.0':>16}{'0.0':>16}*\n{'*':8}{'3.D0':>16}\n"
        free = "GRID,3,,1.,1.,0.\nGRID,4,,0.,1.,0.\nGRID,9,,7.,7.,7.\nCQUAD4,1,1,1,2,3,4\n"
        mesh = self.read("$ comment\n" + small + large + free + f"{'CTRIA3':8}{2:8}{1:8}{1:8}{2:8}{3:8}\n")
        self.assertEqual(mesh.points.tolist(), [[0, 15, -0.2], [1, 0, 3], [1, 1, 0], [0, 1, 0]])
        self.assertEqual((mesh.quads.tolist(), mesh.triangles.tolist()), ([[0, 1, 2, 3]], [[0, 1, 2]]))

    def test_element_on_a_node_that_is_not_there(self):
        with self.assertRaisesRegex(ValueError, "node 7"):
            self.read("GRID,1,,0.,0.,0.\nGRID,2,,1.,0.,0.\nCTRIA3,1,1,1,2,7\n")


class Distances(unittest.TestCase):
    triangle = np.array([[[0, 0, 0], [2, 0, 0], [0, 2, 0]]], float)

    def distance(self, *point):
        return float(nearest_on_triangles(np.array([point], float), self.triangle)[0])

    def test_over_the_inside_beside_a_side_and_off_a_corner(self):
        self.assertAlmostEqual(self.distance(0.5, 0.5, -3), 3)
        self.assertAlmostEqual(self.distance(1, -3, 4), 5)
        self.assertAlmostEqual(self.distance(2, 2, 0), math.sqrt(2))
        self.assertAlmostEqual(self.distance(-1, -2, 2), 3)

    def test_search_is_exact_with_triangles_of_every_size(self):
        random = np.random.default_rng(7)
        triangles = random.uniform(-5, 5, (300, 1, 3)) + random.uniform(-1, 1, (300, 3, 3)) * random.uniform(0.01, 8, (300, 1, 1))
        points = random.uniform(-9, 9, (60, 3))
        brute = [min(nearest_on_triangles(np.repeat(p[None], 300, 0), triangles)) for p in points]
        np.testing.assert_allclose(Surface(triangles).distances(points, first=2), brute, atol=1e-12)

    def test_patch_of_a_warped_quad_lies_between_its_diagonals(self):
        warped = Mesh(np.array([[0, 0, 0], [1, 0, 1], [1, 1, 0], [0, 1, 1]], float), np.array([[0, 1, 2, 3]]), NO_TRIANGLES)
        surface = Surface(patches_of(warped, 2))
        self.assertAlmostEqual(float(surface.distances([[0.5, 0.5, 0.5]])[0]), 0)
        self.assertAlmostEqual(float(heights(surface, np.array([[0.5, 0.5]]))[0]), 0.5)
        self.assertTrue(np.isnan(heights(surface, np.array([[3.0, 0.5]]))[0]))


class Quality(unittest.TestCase):
    def test_scaled_jacobian(self):
        points = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [1.5, math.sqrt(0.75), 0], [0.5, math.sqrt(0.75), 0]])
        values = scaled_jacobian(points, np.array([[0, 1, 2, 3], [0, 1, 4, 5]]))
        np.testing.assert_allclose(values, [1, math.sin(math.pi / 3)])
        np.testing.assert_allclose(scaled_jacobian(points, np.array([[0, 1, 5]])), [1])

    def test_irregular_nodes_only_inside(self):
        mesh = grid(4, 4)
        everywhere = np.ones(16, bool)
        self.assertEqual(irregular_inside(mesh, everywhere), 0)
        fan = Mesh(np.array([[0, 0, 0]] + [[math.cos(k * math.pi / 3), math.sin(k * math.pi / 3), 0] for k in range(6)]),
                   np.array([[0, 1, 2, 3], [0, 3, 4, 5], [0, 5, 6, 1]]), NO_TRIANGLES)
        self.assertEqual(irregular_inside(fan, np.ones(3, bool)), 1)
        self.assertEqual(irregular_inside(fan, np.array([True, True, False])), 0)


class Crest(unittest.TestCase):
    sheet = Surface(patches_of(grid(40, 10)))

    def share(self, line, mesh):
        crest = crest_line(np.array(line, float), self.sheet, 4)
        return covered(crest, mesh, mesh.edges()[0]) / (crest.end - crest.start)

    def test_line_along_edges(self):
        self.assertAlmostEqual(self.share([[5, 5], [35, 5]], grid(8, 2, 5)), 1, places=2)

    def test_tips_inside_an_edge(self):
        self.assertAlmostEqual(self.share([[7, 5], [33, 5]], grid(8, 2, 5)), 1, places=2)

    def test_line_beside_the_edges(self):
        self.assertEqual(self.share([[5, 5.2], [35, 5.2]], grid(8, 2, 5)), 0)

    def test_line_that_leaves_the_edges_half_way(self):
        self.assertAlmostEqual(self.share([[5, 5], [20, 5], [20.1, 7], [35, 7]], grid(8, 2, 5)), 15 / 32, places=1)

    def test_line_across_edges(self):
        self.assertEqual(self.share([[5, 2.5], [35, 2.5]], grid(8, 2, 5)), 0)

    def test_closed_line(self):
        angles = np.linspace(0, 2 * math.pi, 201)
        circle = np.column_stack([20 + 4 * np.cos(angles), 5 + 4 * np.sin(angles)])
        nodes = np.column_stack([circle[5::20], np.zeros(10)])
        ring = Mesh(np.concatenate([nodes, [[20, 5, 0]]]), np.zeros((0, 4), int),
                    np.array([[k, (k + 1) % 10, 10] for k in range(10)]))
        self.assertAlmostEqual(self.share(circle, ring), 1, places=2)


class Figures(unittest.TestCase):
    def test_roof_that_the_mesh_cuts_off(self):
        roof = lambda x, y: 3 - np.abs(y - 3)
        facets = Mesh(*self.as_triangles(grid(24, 12, 0.5, roof)))
        bead = Bead("I", [np.array([[2, 0.0], [10, 0], [10, 6], [2, 6]])], [np.array([[3.0, 3], [9, 3]])])
        figures = bead_figures(grid(6, 3, 2, roof), Reference(facets, [bead], 2), 2.5)
        self.assertAlmostEqual(figures.gap, 1, places=9)  # the ridge lies over the middle of a row that is flat
        self.assertEqual((figures.crest_covered, figures.triangles, figures.irregular, figures.elements), (0, 0, 0, 12))
        self.assertAlmostEqual(figures.scaled_jacobian, 1)
        self.assertEqual(figures.edges_below_min, 4 * 4 + 5)  # 2 mm along the roof and across its flat row

    @staticmethod
    def as_triangles(mesh):
        return mesh.points, np.zeros((0, 4), int), np.concatenate([mesh.quads[:, [0, 1, 2]], mesh.quads[:, [0, 2, 3]]])


class Others(unittest.TestCase):
    def test_polygon_of_lines_and_arcs(self):
        loop = polygon([{"t": "L", "p": [-1, -1], "q": [1, -1]}, {"t": "A", "c": [1, 0], "r": 1, "a0": -math.pi / 2, "ang": math.pi},
                        {"t": "L", "p": [1, 1], "q": [-1, 1]}, {"t": "S", "pts": [[-1, 1], [-1, 0], [-1, -1]]}])
        x, y = loop.T
        area = abs(np.dot(x, np.roll(y, -1)) - np.dot(y, np.roll(x, -1))) / 2
        self.assertAlmostEqual(area, 4 + math.pi / 2, places=1)
        self.assertEqual(Bead("I", [loop]).holds(np.array([[0, 0], [1.9, 0], [1.9, 0.9]])).tolist(), [True, True, False])

    def test_elements_turned_to_one_side(self):
        mesh = grid(3, 1)
        mesh.quads[1] = mesh.quads[1][::-1]
        directed = [d for e in oriented(mesh) for d in zip(e, e[1:] + e[:1])]
        self.assertEqual(len(directed), len(set(directed)))

    def test_frequencies_of_a_table(self):
        path = written("     E I G E N V A L U E   O U T P U T\n\n MODE NO    EIGENVALUE    FREQUENCY\n\n"
                       "      1   0.1000000E+02   0.3162278E+01   0.5032921E+00   0.0000000E+00\n"
                       "      2   0.4000000E+02   0.6324555E+01   0.1006584E+01   0.0000000E+00\n\n"
                       "     P A R T I C I P A T I O N   F A C T O R S\n\n      1   0.1E+01   0.1E+01   0.1E+01   0.1E+01\n")
        self.assertEqual(read_frequencies(path).tolist(), [0.5032921, 1.006584])
        os.remove(path)

    def test_text_between_markers(self):
        path = written("a\n<!-- x -->\nold\n<!-- /x -->\nb\n")
        replace_between_markers(path, "x", "new\n")
        with open(path) as file:
            self.assertEqual(file.read(), "a\n<!-- x -->\n\nnew\n\n<!-- /x -->\nb\n")
        self.assertRaises(ValueError, replace_between_markers, path, "y", "new")
        os.remove(path)


if __name__ == "__main__":
    unittest.main()
