"""The verbs on example panels: files, tables, kinds, determinism."""
import functools
import json
import math
import pathlib
import tempfile
import types
import unittest

from command import Case, contains, example, run, truth

_folder = tempfile.TemporaryDirectory()


# Letters that a person might as well give: a shape not listed must be named as it is.
ALSO = {"U": {"C", "J", "G", "arc"}, "trident": {"comb", "tree"}}


def beads_of(name):
    result = run("beads", example(name), "--json", "-")
    return result, json.loads(result.stdout)


@functools.cache
def meshed():
    """The panel `basic` with deck, table and report, made once for all tests: what was printed, and the files in their folder."""
    folder = pathlib.Path(_folder.name)
    deck, table, report = (folder / name for name in ("panel.bdf", "panel.json", "panel.html"))
    result = run("mesh", example("basic"), "-o", deck, "--preset", "crash", "--json", table, "--report", report)
    return types.SimpleNamespace(result=result, folder=folder, deck=deck, table=table, report=report)


class Recognition(Case):
    """Every bead is found with its kind, nothing else is."""

    def assert_recognised(self, name, flat=False):
        """`flat`: the height is over the plane of the boundary, which is the designed height on a flat base only."""
        result, table = beads_of(name)
        self.assertEqual(0, result.returncode, result.stderr)
        self.assertEqual("beadmesh.beads/1", table["schema"])
        features = truth(name)
        found = {}
        for bead in table["beads"]:
            owners = [i for i, f in enumerate(features) if contains(f, bead["point"])]
            self.assertEqual(1, len(owners), f"bead {bead['id']} at {bead['point']} lies on no feature")
            self.assertNotIn(owners[0], found)
            found[owners[0]] = bead
        for i, feature in enumerate(features):
            with self.subTest(feature=i + 1, shape=feature["shape"]):
                if feature["paper_rule"] == "none":
                    self.assertNotIn(i, found)
                    continue
                self.assertIn(i, found)
                self.assert_like(found[i], feature)
                if flat:
                    self.assertAlmostEqual(1, found[i]["height"] / feature["height"], delta=0.1)

    def assert_like(self, bead, feature):
        self.assertEqual(feature["paper_rule"], bead["kind"])
        self.assertIn(bead["shape"], {feature["shape"]} | ALSO.get(feature["shape"], set()))
        self.assertEqual(feature["loops"], bead["loops"])
        self.assertAlmostEqual(1, bead["length"] / feature["centreline_length"], delta=0.1)
        self.assertAlmostEqual(1, bead["width"] / feature["mean_width"], delta=0.05)

    def test_basic(self):
        self.assert_recognised("basic", flat=True)

    def test_rotated(self):
        self.assert_recognised("rotated", flat=True)

    def test_curved(self):
        self.assert_recognised("curved")

    def test_floor(self):
        self.assert_recognised("floor")

    def test_every_shape(self):
        self.assert_recognised("shapes", flat=True)

    def test_mix_by_chance(self):
        self.assert_recognised("random")


class ManyFaces(Case):
    """Beads whose fillets, walls and tops are faces of their own."""

    def test_each_is_one_bead(self):
        result, table = beads_of("filleted")
        self.assertEqual(0, result.returncode, result.stderr)
        self.assertEqual([("I", "I"), ("I", "arc"), ("annular", "ring"), ("generic", "T")],
                         sorted((bead["kind"], bead["shape"]) for bead in table["beads"]))
        faces = [face for bead in table["beads"] for face in bead["faces"]]
        self.assertEqual(len(faces), len(set(faces)), "a face belongs to one bead")
        for bead in table["beads"]:
            self.assertGreaterEqual(len(bead["faces"]), 13)
            self.assertAlmostEqual(6, bead["height"], delta=0.1)

    def test_mesh_keeps_the_minimum_over_narrow_fillets(self):
        table = self.folder / "filleted.json"
        result = run("mesh", example("filleted"), "-o", self.folder / "filleted.bdf", "--json", table)
        self.assertIn(", 0 below the minimum", result.stdout)
        self.assertEqual(["blocks"] * 4, [bead["mesh"]["method"] for bead in json.loads(table.read_text())["beads"]])


class Files(Case):
    def test_mesh_writes_all_it_is_asked_for(self):
        made = meshed()
        self.assertEqual(0, made.result.returncode, made.result.stderr)
        self.assertEqual({made.deck, made.table, made.report}, set(made.folder.iterdir()), "no file is left over")
        self.assertIn("CQUAD4", made.deck.read_text())
        self.assertIn("SET", made.deck.read_text())
        self.assert_table(json.loads(made.table.read_text()))
        self.assertIn("generic", made.result.stdout, "the summary shows the bead table")

    def test_the_flat_picture(self):
        deck, report = self.folder / "panel.bdf", self.folder / "report.svg"
        result = run("mesh", example("single"), "-o", deck, "--report", report)
        self.assertEqual(0, result.returncode, result.stderr)
        self.assertEqual({deck, report}, set(self.contents()))
        self.assertIn("<svg", report.read_text())

    def assert_table(self, table):
        self.assertEqual("basic.step", table["input"])
        self.assertEqual("mm", table["unit"])
        self.assertEqual(list(range(1, len(table["beads"]) + 1)), [b["id"] for b in table["beads"]])
        for bead in table["beads"]:
            self.assertGreater(bead["mesh"]["elements"], 0)
            self.assertTrue(all(len(p) == 3 for line in bead["ridge"] for p in line))
        self.assertTrue(all(f["reason"] for f in table["faces_not_beads"]))
        self.assertGreater(table["mesh"]["quads"], 0)

    def test_html_report_stands_alone(self):
        text = meshed().report.read_text()
        self.assertIn("<html", text)
        for link in ('src="http', "src='http", 'href="http', "@import"):
            self.assertNotIn(link, text)

    def test_minimum_edge_holds_by_the_programs_own_check(self):
        deck = self.folder / "panel.bdf"
        run("mesh", example("single"), "-o", deck, "--size", "6", "--min-edge", "3")
        result = run("check", deck, "--min-edge", "3", "--json", "-")
        self.assertEqual(0, result.returncode, result.stderr)
        self.assertGreater(json.loads(result.stdout)["mesh"]["quads"], 100)

    def test_limits_of_a_preset_and_of_a_file(self):
        deck, table, limits = meshed().deck, self.folder / "check.json", self.folder / "limits.criteria"
        first = run("check", deck, "--preset", "crash", "--save-criteria", limits, "--json", table)
        self.assertIn("property 1:", first.stdout)
        judged = json.loads(table.read_text())
        self.assertEqual(12, len(judged["criteria"]))
        self.assertEqual(judged["parts"][0]["elements"], sum(p["elements"] for p in judged["parts"][1:]))
        self.assertEqual(0, judged["parts"][0]["measures"][0]["failed"], "no edge is below the minimum")
        again = run("check", deck, "--criteria", limits, "--json", "-")
        self.assertEqual(first.returncode, again.returncode)
        self.assertEqual(judged, json.loads(again.stdout))
        loose = self.file("loose.criteria", b"1 min length 1 1 5 4 3 2.5 0\n")
        self.assertEqual(0, run("check", deck, "--criteria", loose).returncode)
        strict = self.file("strict.criteria", b"1 min length 1 1 9 8 7 6 0\n")
        failing = run("check", deck, "--criteria", strict)
        self.assertEqual(1, failing.returncode)
        self.assertIn("past the limits", failing.stderr)

    def test_what_mesh_says_of_criteria_is_what_check_finds(self):
        made, report = meshed(), self.folder / "check.json"
        run("check", made.deck, "--preset", "crash", "--json", report)
        panel, judged = json.loads(made.table.read_text()), json.loads(report.read_text())
        found, whole = panel["mesh"]["quality"]["criteria"], judged["parts"][0]
        self.assertEqual((whole["elements"], whole["failing"]), (found["elements"], found["failing"]))
        self.assertEqual({m["name"]: m["failed"] for m in whole["measures"] if m["name"] != "chordal dev"}, found["failed"])
        self.assertEqual(2.5, found["limits"]["min length"])
        self.assertIn(f"criteria: {found['failing']} of {found['elements']} elements fail", made.result.stdout)
        for bead, row in zip(judged["beads"], panel["beads"], strict=True):
            self.assertEqual(f"bead {row['id']}, kind {row['kind']}, shape {row['shape']}", bead["name"])
            self.assertEqual((row["mesh"]["elements"], row["mesh"]["failing"]), (bead["elements"], bead["failing"]))

    def test_limits_given_to_mesh_count(self):
        deck = self.folder / "panel.bdf"
        strict = self.file("strict.criteria", b"1 min length 1 1 9 8 7 6 0\n")
        failing = run("mesh", example("single"), "-o", deck, "--criteria", strict)
        self.assertEqual(1, failing.returncode)
        self.assertIn("past the limits", failing.stderr)
        self.assertTrue(deck.exists())
        self.assert_refused("mesh", example("single"), "-o", self.folder / "other.bdf", "--criteria",
                            self.folder / "missing.criteria", names="missing.criteria")

    def test_repair_moves_nodes_and_nothing_else(self):
        spoilt, mended, report = (self.folder / name for name in ("spoilt.bdf", "mended.bdf", "check.json"))
        lines = meshed().deck.read_text().splitlines(keepends=True)
        rows = [i for i, line in enumerate(lines) if line.startswith("GRID*")]
        for i in rows[-400::20]:  # the last nodes lie inside the sheet
            lines[i] = lines[i][:40] + f"{float(lines[i][40:56]) + 2.2:16.8f}" + lines[i][56:]
        spoilt.write_text("".join(lines))
        before = json.loads(run("check", spoilt, "--preset", "crash", "--json", "-").stdout)["parts"][0]["failing"]
        result = run("check", spoilt, "--preset", "crash", "--repair", mended, "--json", report)
        table = json.loads(report.read_text())
        after = table["parts"][0]["failing"]
        self.assertEqual(before, table["repair"]["failing_before"])
        self.assertLess(after, before - 10)
        self.assertIn(f"repair: {before} -> {after} failing", result.stdout)
        again = json.loads(run("check", mended, "--preset", "crash", "--json", "-").stdout)
        self.assertEqual(table["parts"], again["parts"])
        keep = [line for line in mended.read_text().splitlines() if not line.startswith(("GRID*", "*"))]
        self.assertEqual([line.rstrip("\n") for line in lines if not line.startswith(("GRID*", "*"))], keep)

    def test_repair_needs_limits_and_another_file(self):
        deck = self.file("panel.bdf", meshed().deck.read_bytes())
        self.assert_refused("check", deck, "--repair", self.folder / "out.bdf", names="limits")
        self.assert_refused("check", deck, "--preset", "crash", "--repair", deck, names="panel.bdf")
        self.assert_refused("check", deck, "--preset", "crash", "--repair", self.folder / "out.txt", names="out.txt")
        for ending in (".k", ".inp"):
            other = self.folder / f"panel{ending}"
            run("mesh", example("single"), "-o", other)
            self.assert_refused("check", other, "--preset", "crash", "--repair", self.folder / "out.bdf", names="Nastran")

    def test_minimum_edge_holds_in_the_deck(self):
        points, quads = read_deck(meshed().deck.read_text())
        self.assertGreater(len(quads), 500)
        shortest = min(length(points[a], points[b]) for q in quads for a, b in zip(q, q[1:] + q[:1]))
        self.assertGreaterEqual(shortest, 2.5 - 1e-6)


def read_deck(text):
    """Grid points and quadrangles of a deck in large field grids and small field elements."""
    points, quads, lines = {}, [], text.splitlines()
    for i, line in enumerate(lines):
        if line.startswith("GRID*"):
            points[int(line[8:24])] = (float(line[40:56]), float(line[56:72]), float(lines[i + 1][8:24]))
        elif line.startswith("CQUAD4"):
            quads.append([int(line[k : k + 8]) for k in (24, 32, 40, 48)])
    return points, quads


def length(p, q):
    return sum((a - b) ** 2 for a, b in zip(p, q)) ** 0.5


class StandardOutput(Case):
    def test_json_to_standard_output_is_nothing_but_json(self):
        deck = self.folder / "panel.bdf"
        for arguments in (("mesh", example("single"), "-o", deck, "--json", "-"), ("beads", example("basic"), "--json", "-"),
                          ("medial", example("basic"), "--face", "2", "--json", "-")):
            with self.subTest(verb=arguments[0]):
                result = run(*arguments)
                self.assertEqual(0, result.returncode, result.stderr)
                self.assertTrue(json.loads(result.stdout)["schema"].startswith("beadmesh."))

    def test_timings_go_to_standard_error(self):
        result = run("mesh", example("single"), "-o", self.folder / "panel.bdf", "--json", "-", "--timings")
        self.assertEqual(0, result.returncode, result.stderr)
        json.loads(result.stdout)
        rows = [line.split() for line in result.stderr.splitlines()]
        self.assertEqual(["stage", "read", "facets", "compose", "recognise", "beads", "sheet", "assemble", "write", "all",
                          "memory"], [row[0] for row in rows])
        self.assertAlmostEqual(float(rows[-2][1]), sum(float(row[1]) for row in rows[1:-2]), delta=0.01)
        self.assertGreater(float(rows[-2][2]), 0)

    def test_csv_has_a_row_a_bead(self):
        result = run("beads", example("basic"), "--csv", "-")
        self.assertEqual(0, result.returncode, result.stderr)
        self.assertEqual(1 + 4, len(result.stdout.splitlines()))

    def test_a_quiet_run_has_no_diagnostics(self):
        result = run("beads", example("basic"))
        self.assertEqual("", result.stderr)
        self.assertIn("annular", result.stdout)

    def test_help_and_version(self):
        for option in ("--help", "--version"):
            result = run(option)
            self.assertEqual(0, result.returncode)
            self.assertIn("beadmesh", result.stdout)
            self.assertEqual("", result.stderr)


class MedialObject(Case):
    def medial(self, *arguments):
        result = run("medial", *arguments, "--json", "-")
        self.assertEqual(0, result.returncode, result.stderr)
        return json.loads(result.stdout)["faces"]

    def test_of_a_rectangle(self):
        [face] = self.medial(self.file("rectangle.wkt", b"POLYGON((0 0, 40 0, 40 20, 0 20, 0 0))"))
        self.assertEqual(1, face["loops"])
        junctions = [v for v in face["vertices"] if v["type"] == "J"]
        self.assertEqual([10, 30], sorted(round(v["point"][0]) for v in junctions))
        self.assertTrue(all(abs(v["radius"] - 10) < 0.1 for v in junctions))

    def test_of_a_square_ring_is_one_closed_axis(self):
        [face] = self.medial(self.file("ring.wkt", b"POLYGON((0 0,60 0,60 60,0 60,0 0),(10 10,50 10,50 50,10 50,10 10))"))
        self.assertEqual(2, face["loops"])

    def test_of_every_face_of_a_panel(self):
        faces = self.medial(example("basic"))
        self.assertEqual(list(range(1, 8)), [f["face"] for f in faces])

    def test_of_a_tube_that_is_cut_open(self):
        [face] = self.medial(self.file("tube.stl", tube(radius=10, length=30, facets=48)))
        self.assertEqual(1, face["loops"])
        self.assertAlmostEqual(30, face["plane_image"]["cut_length"], delta=1e-3)
        self.assertEqual(2, len(face["plane_image"]["cut_sides"]))
        self.assertAlmostEqual(1, face["plane_image"]["distortion"]["max_ratio"], delta=1e-3)
        self.assertEqual(4, sum(v["type"] == "C" for v in face["vertices"]))
        self.assertAlmostEqual(30, max(e["thickness"]["max"] for e in face["edges"]), delta=0.01)
        for vertex in face["vertices"]:  # back on the tube
            self.assertAlmostEqual(10, math.hypot(*vertex["point"][:2]), delta=0.05)

    def test_the_summary_names_the_cut(self):
        result = run("medial", self.file("tube.stl", tube(radius=10, length=30, facets=48)))
        self.assertIn("cut open over 30.00", result.stdout)

    def test_one_thread_or_two_the_same_bytes(self):
        outputs = []
        for jobs in ("1", "2"):
            picture = self.folder / f"{jobs}.svg"
            result = run("medial", example("basic"), "--jobs", jobs, "--json", "-", "--svg", picture)
            outputs.append((result.stdout, picture.read_bytes()))
        self.assertEqual(*outputs)

    def test_picture_with_feet(self):
        picture = self.folder / "face.svg"
        run("medial", example("basic"), "--face", "3", "--svg", picture, "--feet")
        self.assertIn('class="feet"', picture.read_text())

    def test_picture(self):
        picture = self.folder / "face.svg"
        result = run("medial", example("basic"), "--face", "3", "--svg", picture)
        self.assertEqual(0, result.returncode, result.stderr)
        self.assertIn("<svg", picture.read_text())


def tube(radius, length, facets):
    """The wall of a tube as STL text."""
    def point(i, z):
        return f"vertex {radius * math.cos(2 * math.pi * i / facets):.9f} {radius * math.sin(2 * math.pi * i / facets):.9f} {z}"

    triangles = [t for i in range(facets)
                 for t in ((point(i, 0), point(i + 1, 0), point(i + 1, length)), (point(i, 0), point(i + 1, length), point(i, length)))]
    lines = ["solid tube"]
    for triangle in triangles:
        lines += ["facet normal 0 0 0", "outer loop", *triangle, "endloop", "endfacet"]
    return "\n".join(lines + ["endsolid tube", ""]).encode()


class Determinism(Case):
    def test_one_thread_or_two_the_same_bytes(self):
        for name in ("basic", "curved"):
            runs = []
            for jobs in ("1", "2", "2"):
                folder = self.folder / f"{name}{len(runs)}"
                folder.mkdir()
                result = run("mesh", example(name), "-o", folder / "p.bdf", "--json", folder / "p.json",
                             "--report", folder / "p.svg", "--jobs", jobs)
                self.assertIn(result.returncode, (0, 1), result.stderr)
                runs.append({path.name: path.read_bytes() for path in folder.iterdir()})
            self.assertEqual(runs[0], runs[1])
            self.assertEqual(runs[1], runs[2])


if __name__ == "__main__":
    unittest.main()
