"""Settings of the mesh: options, configuration file, presets, single beads, local sizes."""
import json
import unittest

from command import Case, example, run


class Controls(Case):
    """What is asked of a bead is done, or named."""

    def mesh(self, *options, status=0):
        """The finished run and its beads."""
        table = self.folder / "beads.json"
        result = run("mesh", example("basic"), "-o", self.folder / "panel.bdf", "--json", table, *options)
        self.assertEqual(status, result.returncode, result.stderr)
        return result, json.loads(table.read_text())["beads"]

    def used(self, *options):
        _, beads = self.mesh(*options)
        return [bead["mesh"] for bead in beads]

    def config(self, text):
        return "--config", self.file("settings.toml", text.encode())

    def across(self, *options):
        return [bead.get("elements_across") for bead in self.used(*options)]

    def test_elements_across_of_all_of_a_kind_and_of_one(self):
        first, second, third, ring = self.across("--size", "4", "--min-edge", "1.2", *self.config(
            "[mesh.bead]\nelements_across = 2\n[mesh.bead.annular]\nelements_across = 6\n"
            "[[mesh.beads]]\nid = 2\nelements_across = 4\n"))
        self.assertEqual([2, 4, 2, 6], [first, second, third, ring])

    def test_options_win_over_the_file(self):
        config = self.config("[mesh.bead]\nelements_across = 2\n[[mesh.beads]]\nid = 1\nelements_across = 2\n")
        self.assertEqual([2, 2, 2, 2], self.across(*config))
        self.assertEqual([2, 4, 4, 4], self.across(*config, "--elements-across", "4"))
        self.assertEqual([4, 2, 2, 2], self.across(*config, "--bead", "id=1,across=4"))

    def test_a_bead_by_a_point(self):
        [point] = [bead["point"] for bead in self.mesh()[1] if bead["id"] == 3]
        at = ":".join(map(str, point))
        self.assertEqual(2, self.across("--bead", f"at={at},across=2")[2])
        self.assertEqual(2, self.across(*self.config(f"[[mesh.beads]]\npoint = {point}\nelements_across = 2\n"))[2])

    def test_method_and_size_of_one_bead(self):
        beads = self.used("--bead", "id=1,method=ridge", "--bead", "id=2,method=face", "--bead", "id=4,size=4,min-edge=3")
        self.assertEqual(["ridge", "face", "blocks", "blocks"], [bead["method"] for bead in beads])
        self.assertEqual([5, 5, 5, 4], [bead["size"] for bead in beads])
        self.assertEqual([2.5, 2.5, 2.5, 3], [bead["min_edge"] for bead in beads])
        self.assertNotIn("elements_across", beads[0])

    def test_method_of_all(self):
        self.assertEqual(["face"] * 4, [bead["method"] for bead in self.used("--method", "face")])

    def test_elements_around_and_clamp_rows(self):
        usual, more = self.used(), self.used("--bead", "id=4,along=40", "--bead", "id=1,rows=4")
        self.assertEqual(40 * more[3]["elements_across"], more[3]["elements"])
        self.assertEqual(usual[1:3], more[1:3])
        self.assertNotEqual(usual[0]["elements"], more[0]["elements"])

    def test_what_cannot_be_met_is_named(self):
        result, beads = self.mesh("--bead", "id=4,along=90")
        self.assertIn("elements along 90", beads[3]["mesh"]["notes"][0])
        self.assertIn("bead 4", result.stderr)
        self.assertEqual([], beads[0]["mesh"]["notes"])

    def test_presets(self):
        for name, size, min_edge in (("crash", 5, 2.5), ("nvh", 10, 4), ("durability", 5, 1.5)):
            with self.subTest(preset=name):
                _, beads = self.mesh("--preset", name)
                self.assertEqual({(size, min_edge)}, {(b["mesh"]["size"], b["mesh"]["min_edge"]) for b in beads})

    def test_local_size(self):
        options = "--min-edge", "2"
        usual = self.used(*options)
        by_option = self.used(*options, "--local-size", "at=-67:72:0,radius=25,size=3")
        self.assertEqual(usual[1], by_option[1])
        self.assertLess(by_option[0]["size"], 4)
        self.assertGreater(by_option[0]["elements"], usual[0]["elements"])
        by_file = self.used(*options, *self.config("[[mesh.local_size]]\npoint = [-67, 72, 0]\nradius = 25\nsize = 3.0\n"))
        self.assertEqual(by_option, by_file)


class KeptEdges(Case):
    def test_a_point_without_an_edge_is_named(self):
        config = self.file("settings.toml", b"[mesh]\nkeep_edges = [[0, 0, 400]]\n")
        result = run("mesh", example("basic"), "-o", self.folder / "panel.bdf", "--config", config, "--keep-edge", "0:0:500")
        self.assertEqual(0, result.returncode, result.stderr)
        for point in ("(0, 0, 400)", "(0, 0, 500)"):
            self.assertIn(f"no edge to keep at {point}", result.stderr)


class Washers(Case):
    """Rings of quads around the holes of the example basic."""

    def around(self, *options):
        """Boundary nodes of each small free loop, and of those that are a ring deep how many quads touch them."""
        deck = self.folder / "panel.bdf"
        result = run("mesh", example("basic"), "-o", deck, *options)
        self.assertEqual(0, result.returncode, result.stderr)
        return holes_of(deck.read_text())

    def test_one_ring_by_default(self):
        for hole in self.around():
            self.assertEqual(0, len(hole) % 2)
            self.assertEqual({2}, set(hole))

    def test_none_when_not_wanted(self):
        self.assertTrue(any(set(hole) != {2} for hole in self.around("--washer-rows", "0")))

    def test_by_file(self):
        config = self.file("settings.toml", b"[mesh.holes]\nrows = 2\nwidth = 4.0\nelements_around = 12\n")
        self.assertTrue(all(len(hole) == 12 and set(hole) == {2} for hole in self.around("--config", config)))

    def test_senseless_values_are_refused(self):
        for option, value in (("--washer-rows", "-1"), ("--washer-width", "0")):
            self.assert_refused("mesh", example("basic"), "-o", self.folder / "out.bdf", option, value, names="washer")


def holes_of(text):
    """For each free loop of fewer than 30 nodes: number of quads at each of its nodes."""
    quads = [[int(line[8 * k:8 * k + 8]) for k in range(3, 7)] for line in text.splitlines() if line.startswith("CQUAD4")]
    ahead, valence = {}, {}
    sides = {(a, b) for q in quads for a, b in zip(q, q[1:] + q[:1])}
    for a, b in sides:
        if (b, a) not in sides:
            ahead[b] = a
    for q in quads:
        for n in q:
            valence[n] = valence.get(n, 0) + 1
    holes = []
    while ahead:
        node, loop = next(iter(ahead)), []
        while node in ahead:
            loop.append(valence[node])
            node = ahead.pop(node)
        if len(loop) < 30:
            holes.append(loop)
    return holes


class WrongControls(Case):
    def refuse(self, *options, names):
        self.assert_refused("mesh", example("basic"), "-o", self.folder / "out.bdf", *options, names=names)

    def refuse_config(self, text, *names):
        path = self.file("bad.toml", text.encode())
        with self.subTest(text):
            line = self.assert_refused("mesh", example("basic"), "-o", self.folder / "out.bdf", "--config", path)
            for name in names:
                self.assertIn(name, line)

    def test_counts_that_make_no_sense(self):
        for option, value in (("--elements-across", "3"), ("--elements-across", "0"), ("--elements-across", "4.5"),
                              ("--elements-along", "-1"), ("--clamp-rows", "0"), ("--method", "paint")):
            with self.subTest(option=option, value=value):
                self.refuse(option, value, names=value)

    def test_beads_that_are_not_there(self):
        self.refuse("--bead", "id=9,across=4", names="bead 9")
        self.refuse("--bead", "at=0:0:90,across=4", names="(0, 0, 90)")

    def test_texts_that_say_nothing(self):
        for text in ("id=3,colour=red", "across=4", "id=1,at=0:0:0", "id=0", "id=x", "at=1:2", "at=1:2:x", "id=1,across=",
                     "id=1,,across=4", "id=1,id=2", "id=1,method=paint", "id=1,across=3", "id=1,size=2", "id=1,min-edge=1"):
            with self.subTest(text):
                self.refuse("--bead", text, names="")
        for text in ("1:2", "x:y:z", "at=1:2:3"):
            with self.subTest(text):
                self.refuse("--keep-edge", text, names=text)
        for text in ("at=0:0:0,radius=10", "at=0:0:0,radius=0,size=3", "radius=5,size=3", "at=0:0:0,radius=9,size=1",
                     "at=0:0:0,radius=nan,size=3"):
            with self.subTest(text):
                self.refuse("--local-size", text, names="size")

    def test_configurations_are_refused_with_their_line(self):
        self.refuse_config("[mesh.bead]\nsize = 4\nacross = 4\n", ":3", "mesh.bead.across")
        self.refuse_config("[mesh.bead.T]\nsize = 4\n", ":1", "mesh.bead.T")
        self.refuse_config("[mesh]\nsize = 4\n", ":2", "mesh.size")
        self.refuse_config("[mesh.bead.I]\nclamp_rows = 1.5\n", ":2", "mesh.bead.I.clamp_rows", "whole number")
        self.refuse_config("[mesh.bead]\nmethod = 'paint'\n", ":2", "ridge")
        self.refuse_config("[[mesh.beads]]\nelements_across = 4\n", ":1", "id")
        self.refuse_config("[[mesh.beads]]\nid = 1\npoint = [0, 0, 0]\n", ":1", "point")
        self.refuse_config("[[mesh.beads]]\npoint = [0, 0]\n", ":2", "mesh.beads.point")
        self.refuse_config("[mesh.beads]\nid = 1\n", ":1", "[[mesh.beads]]")
        self.refuse_config("[[mesh.local_size]]\nradius = 3\nsize = 3\n", ":1", "point")
        self.refuse_config("[mesh]\nkeep_edges = [[1, 2]]\n", ":2", "mesh.keep_edges")
        self.refuse_config("chordal_deviation = -1\n", "chordal deviation")
        self.refuse_config("[mesh.holes]\nrow = 3\n", ":2", "mesh.holes.row")
        self.refuse_config("[mesh.holes]\nelements_around = 7\n", "even")
        self.refuse_config("mesh = 3\n", ":1", "table")
        self.refuse_config("[[mesh.beads]]\nid = 7\n", "bead 7")
        self.refuse_config("[mesh.bead]\nelements_across = 5\n", "5")


if __name__ == "__main__":
    unittest.main()
