"""Broken input and wrong usage: one clear line on stderr, exit status 2, nothing written."""
import json
import math
import unittest

from command import Case, example, run


class BrokenPanels(Case):
    """Every verb that reads a panel refuses it, and names the file."""

    def assert_all_verbs_refuse(self, panel):
        for arguments in (("mesh", panel, "-o", self.folder / "out.bdf"),
                          ("mesh", panel, "-o", self.folder / "out.bdf", "--json", "-"),
                          ("beads", panel), ("beads", panel, "--json", self.folder / "out.json"),
                          ("medial", panel, "--json", "-")):
            with self.subTest(arguments=arguments):
                self.assert_refused(*arguments, names=panel.name)

    def test_missing_file(self):
        self.assert_all_verbs_refuse(self.folder / "missing.step")

    def test_empty_file(self):
        for name in ("empty.step", "empty.iges", "empty.brep", "empty.stl"):
            self.assert_all_verbs_refuse(self.file(name))

    def test_truncated_step(self):
        whole = example("basic").read_bytes()
        for part in (0.02, 0.5, 0.98):
            self.assert_all_verbs_refuse(self.file("truncated.step", whole[: int(len(whole) * part)]))

    def test_not_what_the_ending_says(self):
        self.assert_all_verbs_refuse(self.file("text.step", b"this is no STEP file\n"))
        self.assert_all_verbs_refuse(self.file("noise.step", bytes(range(256)) * 40))

    def test_directory(self):
        folder = self.folder / "folder.step"
        folder.mkdir()
        self.assert_all_verbs_refuse(folder)

    def test_step_without_faces(self):
        self.assert_all_verbs_refuse(example("no-faces"))

    def test_loop_that_crosses_itself(self):
        self.assert_all_verbs_refuse(example("bow-tie"))
        self.assert_all_verbs_refuse(example("figure-of-eight"))

    def test_unknown_ending(self):
        self.assert_all_verbs_refuse(self.file("panel.xyz", b"panel"))


SQUARE = [(0, 0), (10, 0), (10, 10), (0, 10)]


def square(x, y, side):
    return [(x, y), (x + side, y), (x + side, y + side), (x, y + side)]


def wkt(*loops):
    """Loops with their first points repeated at the end."""
    return "POLYGON(" + ", ".join("(" + ", ".join(f"{x} {y}" for x, y in l + l[:1]) + ")" for l in loops) + ")"


def poly(*loops):
    """Vertices numbered from 1 through all loops."""
    points, segments = [p for loop in loops for p in loop], []
    for loop in loops:
        first = len(segments) + 1
        segments += [(first + i, first + (i + 1) % len(loop)) for i in range(len(loop))]
    lines = [f"{len(points)} 2", *(f"{i} {x} {y}" for i, (x, y) in enumerate(points, 1)),
             f"{len(segments)}", *(f"{i} {a} {b}" for i, (a, b) in enumerate(segments, 1)), "0"]
    return "\n".join(lines) + "\n"


class BrokenPolygons(Case):
    def refuse(self, name, text, *parts):
        """A line that names the file and all `parts`."""
        with self.subTest(name):
            path = self.file(name, text if isinstance(text, bytes) else text.encode())
            for outputs in (("--json", "-"), ("--json", self.folder / "o.json", "--svg", self.folder / "o.svg")):
                line = self.assert_refused("medial", path, *outputs, names=name)
                for part in parts:
                    self.assertIn(part, line)

    def refuse_both(self, name, loops, parts_of_wkt, parts_of_poly):
        self.refuse(name + ".wkt", wkt(*loops), *parts_of_wkt)
        self.refuse(name + ".poly", poly(*loops), *parts_of_poly)

    def test_polygons_that_are_none(self):
        for name, text in (("empty.wkt", ""), ("open.wkt", "POLYGON((0 0, 10 0"), ("line.wkt", "LINESTRING(0 0, 1 1)"),
                           ("blank.wkt", " \n\t"), ("empty.poly", ""), ("short.poly", "4 2 0 0\n1 0 0\n"),
                           ("noise.wkt", bytes(range(256)) * 40), ("noise.poly", bytes(range(256)) * 40),
                           ("zeros.wkt", bytes(10000)), ("zeros.poly", bytes(10000)),
                           ("brackets.wkt", "POLYGON" + "(" * 100000), ("empty_ring.wkt", "POLYGON((0 0,1 0,0 1),())")):
            self.refuse(name, text)

    def test_several_polygons(self):
        text = "((0 0,10 0,10 10,0 0)),((20 0,30 0,30 10,20 0))"
        self.refuse("multi.wkt", f"MULTIPOLYGON({text})", "several polygons")
        self.refuse("two.wkt", "POLYGON((0 0,10 0,10 10,0 0))\nPOLYGON((20 0,30 0,30 10,20 0))", "line 2", "one polygon")

    def test_open_loops(self):
        self.refuse("open.poly", "3 2\n1 0 0\n2 4 0\n3 0 3\n2\n1 1 2\n2 2 3\n0\n", "line 2", "vertex 1")
        self.refuse("branch.poly", poly(SQUARE).replace("4 4 1\n0", "4 2 4\n0"), "vertex 2")
        self.refuse("arc.wkt", "CURVEPOLYGON(CIRCULARSTRING(0 0, 1 1, 2 0))", "loop 1", "point 3")

    def test_numbers(self):
        for bad in ("nan", "inf", "-inf", "1e300", "5e-324", "1e999", "1e-400", "x", "0x10"):
            self.refuse_both("number", [SQUARE, [(1, 1), (3, 1), (bad, 3)]], ("loop 2", "point 3"), ())

    def test_too_few_points(self):
        self.refuse("one.wkt", "POLYGON((1 1))", "loop 1", "1 point,")
        self.refuse("two.wkt", "POLYGON((1 1, 2 2, 1 1))", "loop 1", "2 points")
        self.refuse("hole.wkt", wkt(SQUARE, [(1, 1), (2, 2)]), "loop 2", "2 points")

    def test_repeated_points(self):
        self.refuse_both("twice", [[(0, 0), (9, 0), (9, 0), (9, 9)]], ("point 2 of loop 1", "point 3 of loop 1 (9, 0)"),
                         ("vertex 2", "vertex 3 (9, 0)"))
        self.refuse_both("again", [[(0, 0), (9, 0), (9, 9), (9, 0), (5, -5)]], ("point 2 of loop 1", "point 4 of loop 1"),
                         ("vertex 2", "vertex 4"))
        self.refuse("closed_twice.wkt", "POLYGON((0 0, 9 0, 9 9, 0 0, 0 0))", "point 4 of loop 1")

    def test_repeated_loops(self):
        hole = square(2, 2, 2)
        self.refuse_both("loop", [SQUARE, SQUARE], ("point 1 of loop 2", "point 1 of loop 1"), ("vertex 5", "vertex 1"))
        self.refuse_both("turned", [SQUARE, SQUARE[2:] + SQUARE[:2]], ("loop 2", "loop 1"), ("vertex",))
        self.refuse_both("reversed", [SQUARE, SQUARE[::-1]], ("loop 2", "loop 1"), ("vertex",))
        self.refuse_both("hole", [SQUARE, hole, hole], ("point 1 of loop 3", "point 1 of loop 2"), ("vertex 9", "vertex 5"))

    def test_no_area(self):
        self.refuse_both("flat", [[(0, 0), (1, 0), (2, 0)]], ("loop 1",), ("vertex 1",))
        self.refuse_both("back", [SQUARE, [(1, 1), (2, 2), (4, 4), (3, 3)]], ("loop 2",), ("vertex 5",))

    def test_spikes(self):
        self.refuse_both("out", [[(0, 0), (20, 0), (10, 0), (10, 10)]], ("point 3 of loop 1 (10, 0)",), ("vertex 3 (10, 0)",))
        self.refuse_both("in", [[(0, 0), (10, 0), (10, 10), (5, 10), (5, 5), (5, 10), (0, 10)]],
                         ("point 4 of loop 1", "point 6 of loop 1"), ("vertex 4", "vertex 6"))

    def test_crossing(self):
        self.refuse_both("bow_tie", [[(0, 0), (10, 10), (10, 0), (0, 10)]], tuple(f"point {i} of loop 1" for i in (1, 2, 3, 4)),
                         tuple(f"vertex {i} " for i in (1, 2, 3, 4)))
        self.refuse_both("holes", [SQUARE, square(1, 1, 4), square(3, 3, 4)], ("loop 2", "loop 3"), ("vertex 6", "vertex 9"))
        self.refuse_both("outer", [SQUARE, square(5, 5, 10)], ("loop 1", "loop 2"), ("vertex",))
        self.refuse("arc.wkt", "CURVEPOLYGON((0 0,10 0,10 10,0 10,0 0),CIRCULARSTRING(2 5, 12 5, 2 5))", "loop 2", "arc")

    def test_touching(self):
        self.refuse_both("itself", [[(0, 0), (10, 0), (10, 10), (5, 0), (0, 10)]], ("point 4 of loop 1 (5, 0)",), ("vertex 4",))
        self.refuse_both("wall", [SQUARE, [(0, 5), (5, 2), (5, 8)]], ("point 1 of loop 2 (0, 5)",), ("vertex 5",))
        self.refuse_both("corner", [SQUARE, [(0, 0), (5, 2), (2, 5)]], ("point 1 of loop 2",), ("vertex 5",))
        self.refuse_both("holes", [SQUARE, square(1, 1, 3), square(4, 4, 3)], ("point 1 of loop 3",), ("vertex 9",))

    def test_misplaced_holes(self):
        self.refuse_both("outside", [SQUARE, square(20, 20, 2)], ("loop 2", "outside"), ("vertex 5", "outside"))
        self.refuse_both("nested", [SQUARE, square(1, 1, 8), square(2, 2, 3)], ("loop 3", "hole"), ("vertex 9", "hole"))


class UnusualPolygons(Case):
    """Odd, but right: never refused, never half an answer."""

    def medial(self, name, text):
        result = run("medial", self.file(name, text.encode()), "--json", "-")
        self.assertEqual(0, result.returncode, result.stderr)
        self.assertEqual("", result.stderr)
        [face] = json.loads(result.stdout, parse_constant=self.fail)["faces"]
        kinds = [v["type"] for v in face["vertices"]]
        return {kind: kinds.count(kind) for kind in kinds}

    def test_the_outer_loop_may_come_last_and_run_any_way(self):
        ring = {"C": 4, "J": 4}
        hole = square(3, 3, 4)
        for loops in ([SQUARE, hole], [hole, SQUARE], [SQUARE[::-1], hole], [hole[::-1], SQUARE[2:] + SQUARE[:2]]):
            with self.subTest(loops=loops):
                self.assertEqual(ring, self.medial("ring.wkt", wkt(*loops)))
                self.assertEqual(ring, self.medial("ring.poly", poly(*loops)))

    def test_collinear_points_are_no_corners(self):
        points = [(i / 10, 0) for i in range(200)] + [(20, 0), (20, 3), (20, 10), (7, 10), (0, 10)]
        self.assertEqual({"C": 4, "J": 2}, self.medial("points.wkt", wkt(points)))

    def test_large_small_and_far(self):
        for scale in (1e-30, 1e-12, 1e12, 1e30):
            with self.subTest(scale=scale):
                rectangle = [(x * scale, y * scale) for x, y in ((0, 0), (20, 0), (20, 10), (0, 10))]
                self.assertEqual({"C": 4, "J": 2}, self.medial("scaled.wkt", wkt(rectangle)))
        far = [(x + 1e9, y - 1e9) for x, y in ((0, 0), (2, 0), (2, 1), (0, 1))]
        self.assertEqual({"C": 4, "J": 2}, self.medial("far.wkt", wkt(far)))

    def test_arcs(self):
        stadium = ("CURVEPOLYGON(COMPOUNDCURVE((0 -8, 40 -8), CIRCULARSTRING(40 -8, 48 0, 40 8), (40 8, 0 8), "
                   "CIRCULARSTRING(0 8, -8 0, 0 -8)))")
        self.assertEqual({"S": 2}, self.medial("stadium.wkt", stadium))

    def test_a_spiral_of_many_points(self):
        n = 20000
        angles = [math.sqrt(400 + 360000 * i / n) for i in range(n)]
        wall = lambda r: [((a + r) * math.cos(a), (a + r) * math.sin(a)) for a in angles]
        spiral = wall(1.5) + wall(-1.5)[::-1]
        self.assertLess(len(self.medial("spiral.wkt", wkt(spiral))), 4)
        spiral[5000], spiral[9000] = spiral[9000], spiral[5000]
        self.assert_refused("medial", self.file("crossing.wkt", wkt(spiral).encode()), "--json", "-", names="crossing.wkt")

    def test_thousands_of_holes(self):
        n = 40
        holes = [square(4 * i + 1 + 0.1 * ((3 * i + 5 * k) % 7), 4 * k + 1 + 0.1 * ((5 * i + 2 * k) % 7), 1.3)
                 for i in range(n) for k in range(n)]
        result = run("medial", self.file("holes.wkt", wkt(square(0, 0, 4 * n), *holes).encode()), "--json", "-")
        self.assertEqual(0, result.returncode, result.stderr)
        [face] = json.loads(result.stdout)["faces"]
        self.assertEqual(n * n + 1, face["loops"])
        self.assertEqual(n * n, len(face["edges"]) - len(face["vertices"]) + 1)


class WrongUsage(Case):
    def refuse(self, *options, names=None, out="out.bdf"):
        self.assert_refused("mesh", example("basic"), "-o", self.folder / out, *options, names=names)

    def test_sizes_that_make_no_sense(self):
        for size in ("0", "-5", "nan", "inf", "abc", ""):
            with self.subTest(size=size):
                self.refuse("--size", size, names="size")

    def test_minimum_edge_above_the_size(self):
        self.refuse("--size", "5", "--min-edge", "6", names="6")

    def test_minimum_edge_that_makes_no_sense(self):
        for edge in ("-1", "nan", "x"):
            with self.subTest(edge=edge):
                self.refuse("--min-edge", edge, names="edge")

    def test_jobs_and_thickness(self):
        self.refuse("--jobs", "-1", names="jobs")
        self.refuse("--thickness", "0", names="thickness")

    def test_output_folder_that_does_not_exist(self):
        self.refuse(out="nowhere/out.bdf", names="nowhere")
        self.refuse("--json", self.folder / "nowhere" / "beads.json", names="nowhere")
        self.refuse("--report", self.folder / "nowhere" / "report.html", names="nowhere")

    def test_output_that_is_a_folder(self):
        (self.folder / "folder.bdf").mkdir()
        self.refuse(out="folder.bdf", names="folder.bdf")

    def test_output_of_unknown_format(self):
        self.refuse(out="out.doc", names="out.doc")

    def test_configuration_that_is_missing_or_broken(self):
        self.refuse("--config", self.folder / "missing.toml", names="missing.toml")
        self.refuse("--config", self.file("broken.toml", b"size = = 5\n"), names="broken.toml")

    def test_unknown_verb_option_or_preset(self):
        self.assert_refused()
        self.assert_refused("paint", example("basic"))
        self.refuse("--colour", "red")
        self.refuse("--preset", "paint", names="paint")

    def test_mesh_without_output(self):
        self.assert_refused("mesh", example("basic"), names="--output")

    def test_a_slip_gets_a_suggestion(self):
        line = self.assert_refused("mash", example("basic"), names="'mash'")
        self.assertIn("did you mean mesh?", line)
        self.refuse("--sise", "3", names="there is no option --sise (did you mean --size?")
        self.refuse("--colour=red", names="there is no option --colour (see beadmesh mesh --help)")
        self.refuse("more.step", names="more.step")
        self.assert_refused("beads", names="see beadmesh beads --help")
        self.assert_refused(names="beadmesh mesh PANEL -o DECK")
        self.assert_refused("--verbose", names="--verbose")

    def test_face_that_does_not_exist(self):
        for face in ("0", "-1", "99", "one"):
            with self.subTest(face=face):
                self.assert_refused("medial", example("basic"), "--face", face, "--json", "-", names=face)

    def test_a_refusal_keeps_the_old_output(self):
        self.file("out.bdf", b"$ of yesterday\n")
        self.refuse("--size", "0")


class BrokenMeshes(Case):
    def test_check_refuses_what_is_no_mesh(self):
        self.assert_refused("check", self.folder / "missing.bdf", names="missing.bdf")
        self.assert_refused("check", self.file("empty.bdf"), names="empty.bdf")
        self.assert_refused("check", self.file("noise.bdf", bytes(range(256)) * 40), names="noise.bdf")

    def test_check_refuses_what_are_no_limits(self):
        deck = self.file("square.bdf", b"GRID,1,,0.,0.,0.\nGRID,2,,5.,0.,0.\nGRID,3,,5.,5.,0.\nGRID,4,,0.,5.,0.\n"
                                       b"CQUAD4,1,1,1,2,3,4\n")
        self.assertEqual(0, run("check", deck, "--preset", "crash").returncode)
        self.assert_refused("check", deck, "--preset", "cfd", names="cfd")
        self.assert_refused("check", deck, "--criteria", self.folder / "missing.criteria", names="missing.criteria")
        self.assert_refused("check", deck, "--criteria", self.file("empty.criteria"), names="empty.criteria")
        self.assert_refused("check", deck, "--criteria", self.file("noise.criteria", bytes(range(256))),
                            names="noise.criteria")
        self.assert_refused("check", deck, "--save-criteria", self.folder / "limits.criteria", names="limits")
        self.assert_refused("check", deck, "--preset", "crash", "--save-criteria", deck, names="square.bdf")


if __name__ == "__main__":
    unittest.main()
