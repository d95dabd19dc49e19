"""The checker of the random panels finds what it is there for."""
import pathlib
import tempfile
import unittest

import hard_rules


DECK = """GRID           1              0.      0.      0.
GRID           2             10.      0.      0.
GRID           3             10.     10.      0.
GRID           4              0.     10.      0.
GRID           5             20.      0.      0.
GRID           6             20.     10.   1.5-1
CQUAD4         1       1       1       2       3       4
CQUAD4         2       1       2       5       6       3
"""


class HardRules(unittest.TestCase):
    def broken(self, deck, min_edge=5):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "deck.bdf"
            path.write_text(deck, encoding="utf-8")
            return hard_rules.broken_rules(path, min_edge)

    def test_a_sound_mesh(self):
        self.assertEqual([], self.broken(DECK))

    def test_short_edges(self):
        self.assertEqual(["7 edges under 11 mm"], self.broken(DECK, 11))

    def test_an_element_turned_over_in_itself(self):
        self.assertIn("1 elements inverted", self.broken(DECK.replace("2       5       6       3", "2       6       5       3")))

    def test_neighbours_against_each_other(self):
        deck = DECK.replace("2       5       6       3", "3       6       5       2")
        self.assertEqual(["edge 2-3 is used 2 times in one direction"], self.broken(deck))

    def test_nodes_that_are_not_shared(self):
        deck = DECK + "GRID           7             10.      0.      0.\n"
        self.assertEqual(["1 nodes without element", "1 pairs of nodes in one place"], self.broken(deck))

    def test_an_element_that_stands_twice(self):
        deck = DECK + "CQUAD4         3       1       2       5       6       3\n"
        self.assertIn("an element stands twice", self.broken(deck))


if __name__ == "__main__":
    unittest.main()
