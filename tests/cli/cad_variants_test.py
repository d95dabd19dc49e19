"""One panel as different systems hand it over: always the same beads. Many-faced panels, assemblies, damaged files."""
import json
import os
import pathlib
import random
import re
import signal
import subprocess
import unittest
from xml.etree import ElementTree

from command import MAKE_EXAMPLE_PANEL, PROGRAM, TIMEOUT, Case, contains, example, run

VARY_PANEL = os.environ["VARY_PANEL"]
SVG = "{http://www.w3.org/2000/svg}"


class VariedCase(Case):
    def vary(self, name, *options, source=None):
        path = self.folder / name
        subprocess.run([VARY_PANEL, source or example("filleted"), path, *map(str, options)], check=True, timeout=TIMEOUT)
        return path

    def table(self, path, *options):
        result = run("beads", path, "--json", "-", *options)
        self.assertIn(result.returncode, (0, 1), result.stderr)
        return json.loads(result.stdout)

    def diagnostics(self, table):
        return {d["code"]: d["message"] for d in table["diagnostics"]}


class CadVariants(VariedCase):
    def assert_same_beads(self, table, reference):
        rows = lambda t: sorted((b["kind"], b["shape"], b["length"], b["width"], b["height"]) for b in t["beads"])
        self.assertEqual([r[:2] for r in rows(reference)], [r[:2] for r in rows(table)])
        for ours, theirs in zip(rows(table), rows(reference)):
            for a, b in zip(ours[2:], theirs[2:]):
                self.assertAlmostEqual(1, a / b, delta=0.01)

    def setUp(self):
        super().setUp()
        self.reference = self.table(example("filleted"))
        self.assertEqual(4, len(self.reference["beads"]))

    def test_formats_units_and_places(self):
        for name, options, reading in (("a.igs", ["--turn"], []),
                                       ("b.brep", ["--turn", "--unit", "m"], ["--unit", "m"]),
                                       ("c.step", ["--turn", "--unit", "m"], []),
                                       ("d.step", ["--unit", "inch", "--mirror"], []),
                                       ("e.igs", ["--unit", "inch", "--turn", "--mirror"], []),
                                       ("f.igs", ["--unit", "m"], [])):
            with self.subTest(name=name, options=options):
                self.assert_same_beads(self.table(self.vary(name, *options), *reading), self.reference)

    def test_order_and_orientation_of_faces(self):
        for name in ("a.step", "b.igs", "c.brep"):
            with self.subTest(name=name):
                table = self.table(self.vary(name, "--shuffle", "--flip", "--turn", "--seed", 3))
                self.assert_same_beads(table, self.reference)
                self.assertIn("read.turned_over", self.diagnostics(table))

    def test_doubled_faces_are_left_out(self):
        table = self.table(self.vary("double.step", "--double", 5, "--shuffle"))
        self.assertIn("read.duplicates", self.diagnostics(table))
        self.assert_same_beads(table, self.reference)

    def test_gaps_are_sewn_up_to_the_tolerance(self):
        loose = self.vary("loose.step", "--gap", 0.004)
        self.assert_same_beads(self.table(loose), self.reference)
        self.assertEqual([], self.table(loose, "--gap", 1e-4)["beads"])

    def test_narrow_faces_and_short_edges_are_taken_up(self):
        """All faces cut twice, 0.05 mm apart: strips of sheet, of beads, and of a round emboss, which stays no bead."""
        path = self.vary("slivers.step", "--sliver", 0.05)
        self.assert_same_beads(self.table(path), self.reference)
        deck = self.folder / "slivers.bdf"
        result = run("mesh", path, "-o", deck, "--size", 10, "--json", "-")
        self.assertIn(result.returncode, (0, 1), result.stderr)
        quality = json.loads(result.stdout)["mesh"]["quality"]
        self.assertEqual(0, quality["edges_below_min"])

    def test_a_solid_becomes_a_skin(self):
        for options, thickness in ((["--thickness", 1.2, "--turn"], 1.2), (["--thickness", -0.8, "--shuffle"], 0.8)):
            solid = self.vary("solid.step", *options)
            for skin in ("outer", "inner", "middle"):
                with self.subTest(thickness=thickness, skin=skin):
                    table = self.table(solid, "--skin", skin)
                    self.assertIn("read.skin", self.diagnostics(table))
                    self.assertEqual(sorted((b["kind"], b["shape"]) for b in self.reference["beads"]),
                                     sorted((b["kind"], b["shape"]) for b in table["beads"]))
                    self.assertEqual([thickness], [part["thickness"] for part in table["parts"]])

    def test_the_measured_thickness_is_a_property(self):
        deck = self.folder / "solid.bdf"
        result = run("mesh", self.vary("solid.step", "--thickness", 1.2), "-o", deck, "--size", 8)
        self.assertIn(result.returncode, (0, 1), result.stderr)
        cards = [line for line in deck.read_text().splitlines() if line.startswith("PSHELL")]
        self.assertEqual({"1.2"}, {card[24:32].strip() for card in cards})

    def test_a_skin_of_another_name_is_refused(self):
        self.assert_refused("beads", example("filleted"), "--skin", "both", names="both")


class ManyFacedPanels(VariedCase):
    """Random beads with walls and fillets: every one is found with its kind, nothing else is."""

    def check(self, *options):
        step, truth = self.folder / "walls.step", self.folder / "truth.json"
        subprocess.run([MAKE_EXAMPLE_PANEL, "random", step, truth, *options], check=True, timeout=TIMEOUT)
        features = json.loads(truth.read_text())["features"]
        wanted = [i for i, f in enumerate(features) if f["paper_rule"] != "none"]
        found = {}
        for bead in self.table(step)["beads"]:
            owners = [i for i, f in enumerate(features) if contains(f, bead["point"])]
            self.assertEqual(1, len(owners), bead)
            found[owners[0]] = bead
        self.assertEqual(wanted, sorted(found))
        for i in wanted:
            self.assertEqual(features[i]["paper_rule"], found[i]["kind"])
            self.assertGreater(len(found[i]["faces"]), 8)
            self.assertAlmostEqual(1, found[i]["width"] / features[i]["mean_width"], delta=0.05)

    def test_drafted_walls(self):
        for seed, base in ((1, "flat"), (4, "cylinder"), (6, "double")):
            with self.subTest(seed=seed, base=base):
                self.check("--walls", "--beads", "7", "--seed", str(seed), "--base", base)

    def test_fillets_of_the_kernel(self):
        self.check("--kernel", "--beads", "5", "--seed", "3")

    def test_rings_that_share_loops_are_rings_of_their_own(self):
        step, truth = self.folder / "corrugated.step", self.folder / "truth.json"
        subprocess.run([MAKE_EXAMPLE_PANEL, "shapes", step, truth, "--walls", "--only", "corrugated", "--width", "12"], check=True,
                       timeout=TIMEOUT)
        features = json.loads(truth.read_text())["features"]
        beads = self.table(step)["beads"]
        self.assertEqual(len(features), len(beads))
        for bead in beads:
            self.assertEqual("annular", bead["kind"])
            self.assertEqual(13, len(bead["faces"]))
        for true, found in zip(sorted(f["centreline_length"] for f in features), sorted(b["length"] for b in beads)):
            self.assertAlmostEqual(1, found / true, delta=0.01)


class Grouping(VariedCase):
    """The picture of the decisions."""

    def texts(self, svg, group):
        return [t.text for t in ElementTree.parse(svg).iterfind(f".//{SVG}g[@id='{group}']/{SVG}text")]

    def test_each_face_and_each_decision_is_in_the_picture(self):
        svg = self.folder / "grouping.svg"
        table = json.loads(run("beads", example("filleted"), "--json", "-", "--debug-svg", svg).stdout)
        faces = {}
        for path in ElementTree.parse(svg).iterfind(f".//{SVG}g[@id='faces']/{SVG}path"):
            number, words = re.fullmatch(r"face (\d+)(?:: (.*))?", path.find(f"{SVG}title").text).groups()
            faces[int(number)] = words
        self.assertEqual(set(range(1, 89)), set(faces))
        for bead in table["beads"]:
            for face in bead["faces"]:
                self.assertEqual(f"bead {bead['id']}, {bead['kind']} {bead['shape']}", faces[face])
        decisions = self.texts(svg, "decisions")
        self.assertEqual(len(decisions), len(self.texts(svg, "labels")))
        self.assertEqual(4, sum("; it is a bead by the rule for one face;" in d for d in decisions))
        emboss = [d for d in decisions if "one face, no bead" in d]
        self.assertEqual(1, len(emboss))
        self.assertRegex(emboss[0], r"aspect ratio [01]\.\d\d < 2\.00")

    def test_a_picture_is_an_svg(self):
        self.assert_refused("beads", example("filleted"), "--debug-svg", self.folder / "grouping.png", names="--debug-svg")


class WrongUnits(VariedCase):
    def test_a_panel_of_hundreds_of_metres_is_refused(self):
        brep = self.vary("panel.brep")
        line = self.assert_refused("beads", brep, "--unit", "m", names="read.too_large")
        self.assertRegex(line, r"377 m across, over 50 m \(check its unit, which is m\)")

    def test_a_panel_smaller_than_a_bead_is_named(self):
        table = self.table(self.vary("panel.brep", "--unit", "m"))
        self.assertRegex(self.diagnostics(table)["read.tiny"], r"is 0\.377 mm across")


class Assemblies(VariedCase):
    def test_each_component_is_a_part_with_name_and_colour(self):
        path = self.vary("two.step", "--copies", 2)
        text = path.read_text()
        names = iter(["two panels", "left panel", "right panel"])
        text = re.sub(r"PRODUCT\('[^']*',\s*'[^']*'", lambda m: f"PRODUCT('{(name := next(names))}','{name}'", text)
        shell = re.search(r"#(\d+) = SHELL_BASED_SURFACE_MODEL", text)[1]
        context = re.search(r"#(\d+) = \( ?GEOMETRIC_REPRESENTATION_CONTEXT", text)[1]
        colour = (f"#900001=COLOUR_RGB('',0.2,0.4,0.6);\n#900002=FILL_AREA_STYLE_COLOUR('',#900001);\n"
                  f"#900003=FILL_AREA_STYLE('',(#900002));\n#900004=SURFACE_STYLE_FILL_AREA(#900003);\n"
                  f"#900005=SURFACE_SIDE_STYLE('',(#900004));\n#900006=SURFACE_STYLE_USAGE(.BOTH.,#900005);\n"
                  f"#900007=PRESENTATION_STYLE_ASSIGNMENT((#900006));\n#900008=STYLED_ITEM('',(#900007),#{shell});\n"
                  f"#900009=MECHANICAL_DESIGN_GEOMETRIC_PRESENTATION_REPRESENTATION('',(#900008),#{context});\n")
        head, tail = text.rsplit("ENDSEC;", 1)
        path.write_text(head + colour + "ENDSEC;" + tail)
        table = self.table(path)
        self.assertEqual(8, len(table["beads"]))
        self.assertEqual(["left panel", "right panel"], [part["name"] for part in table["parts"]])
        self.assertEqual([88, 88], [len(part["faces"]) for part in table["parts"]])
        for got, wanted in zip(table["parts"][0]["colour"], (0.2, 0.4, 0.6)):
            self.assertAlmostEqual(wanted, got, places=3)
        deck = self.folder / "two.bdf"
        self.assertIn(run("mesh", path, "-o", deck, "--size", 10).returncode, (0, 1))
        titles = re.findall(r"\$ property \d+: (.*)", deck.read_text())
        self.assertIn("left panel sheet", titles)
        self.assertIn("right panel bead_I", titles)


NUMBER = {".step": rb"-?\d+\.\d*(?:E[-+]?\d+)?", ".igs": rb"-?\d+\.\d*(?:D[-+]?\d+)?", ".brep": rb"-?\d+\.?\d*"}
ENTITY = {".step": rb"#\d+", ".igs": rb"\b\d+\b", ".brep": rb"\b\d+\b"}


def damaged(data, ending, seed):
    """The file with flipped bits, lines lost or exchanged, wrong numbers, or references to the wrong place."""
    chance, out = random.Random(seed), bytearray(data)
    pick = lambda pattern: chance.choice([m.span() for m in re.finditer(pattern, data)])
    kind = chance.randrange(6)
    if kind == 0:
        for _ in range(chance.choice((1, 3, 20))):
            out[chance.randrange(len(out))] ^= 1 << chance.randrange(8)
    elif kind == 1:
        begin, end = pick(NUMBER[ending])
        out[begin:end] = chance.choice((b"NaN", b"1.E308", b"-1.E300", b"0.", b"INF", b"1.E-320"))
    elif kind == 2:
        (begin, end), (a, b) = pick(ENTITY[ending]), pick(ENTITY[ending])
        out[begin:end] = data[a:b]
    elif kind == 3:
        return data[:chance.randrange(len(data))]
    else:
        lines = data.split(b"\n")
        i, k = chance.randrange(len(lines) - 2), chance.randrange(len(lines))
        if kind == 4:
            del lines[i:i + chance.choice((1, 1, 5, 40))]
        else:
            lines[i], lines[k] = lines[k], lines[i]
        return b"\n".join(lines)
    return bytes(out)


class DamagedCad(VariedCase):
    """Whatever is in a file, the program ends in time and by itself."""

    def test_damaged_files(self):
        for ending in NUMBER:
            whole = self.vary("whole" + ending)
            for seed in range(int(os.environ.get("DAMAGED_FILES", "10"))):
                with self.subTest(ending=ending, seed=seed):
                    path = self.file("damaged" + ending, damaged(whole.read_bytes(), ending, seed))
                    result = run("beads", path)
                    self.assertIn(result.returncode, (0, 1, 2), result.stderr)
                    if result.returncode == 2:
                        self.assertEqual(1, len([l for l in result.stderr.splitlines() if l.startswith("error")]))

    def test_a_crash_while_reading_is_a_refusal(self):
        pipe = self.folder / "pipe.brep"
        os.mkfifo(pipe)
        with subprocess.Popen([PROGRAM, "beads", pipe], stderr=subprocess.PIPE, text=True) as program:
            with open(pipe, "wb"):  # as soon as the program opens it for reading
                program.send_signal(signal.SIGSEGV)
                message = program.communicate(timeout=TIMEOUT)[1]
        self.assertEqual(2, program.returncode)
        self.assertRegex(message, r"\Aerror read\.crashed: pipe\.brep: .*\n\Z")


if __name__ == "__main__":
    unittest.main()
