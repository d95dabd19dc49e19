"""The design check against what is true of generated panels."""
import csv
import io
import json
import math
import unittest

from command import Case, contains, example, polygon, run, truth

MEASURES = ["depth", "depth_to_width", "wall_angle", "crown_radius", "root_radius", "bead_distance", "nearest_bead", "rim_distance",
            "hole_distance", "exceeded"]


def gap(a, b):
    """Least distance of two polygons, point to segment both ways."""
    def to_segment(p, q, r):
        length = math.dist(q, r) ** 2
        t = max(0, min(1, ((p[0] - q[0]) * (r[0] - q[0]) + (p[1] - q[1]) * (r[1] - q[1])) / length)) if length else 0
        return math.dist(p, (q[0] + t * (r[0] - q[0]), q[1] + t * (r[1] - q[1])))
    return min(to_segment(p, *segment) for one, other in ((a, b), (b, a)) for p in one for segment in zip(other, other[1:] + other[:1]))


def steepest_and_least_radii(height, half):
    """Of the profile of example beads, height * t^3 (4 - 3 t) at t = distance from the root / half width."""
    angle, crown, root = 0, math.inf, math.inf
    for i in range(2001):
        t = i / 2000
        slope = height / half * (12 * t * t - 12 * t ** 3)
        bend = height / half ** 2 * (24 * t - 36 * t * t) / (1 + slope * slope) ** 1.5
        angle = max(angle, math.degrees(math.atan(slope)))
        if bend < 0:
            crown = min(crown, -1 / bend)
        elif bend > 0:
            root = min(root, 1 / bend)
    return angle, crown, root


class DesignCheck(Case):
    def designs(self, panel, *options, status=0):
        result = run("beads", panel, "--design-check", "--json", "-", *options)
        self.assertEqual(status, result.returncode, result.stderr)
        self.diagnostics = result.stderr.splitlines()
        return {bead["id"]: bead for bead in json.loads(result.stdout)["beads"]}

    def test_round_crests_on_a_flat_panel(self):
        features = truth("basic")
        outlines = {}
        beads = self.designs(example("basic"))
        self.assertEqual(4, len(beads))
        for number, bead in beads.items():
            [feature] = [f for f in features if contains(f, bead["point"])]
            outlines[number] = [polygon(loop) for loop in feature["footprint"]]
            width, height, design = feature["mean_width"], feature["height"], bead["design"]
            if bead["kind"] == "I":  # a taper is judged where it is narrowest: at its smaller cap
                width = 2 * min(edge["r"] for loop in feature["footprint"] for edge in loop if edge["t"] == "A")
            angle, crown, root = steepest_and_least_radii(height, width / 2)
            if bead["kind"] != "generic" and width > 0.95 * feature["mean_width"]:
                self.assertAlmostEqual(height / width, design["depth_to_width"], delta=0.02 * height / width)
                self.assertAlmostEqual(angle, design["wall_angle"], delta=1.5)
                self.assertAlmostEqual(crown, design["crown_radius"], delta=0.2 * crown)
                self.assertAlmostEqual(root, design["root_radius"], delta=0.1 * root)
            elif bead["kind"] == "I":
                self.assertTrue(0.95 * height / width < design["depth_to_width"] < 1.01 * height / width, design)
            self.assertAlmostEqual(height, design["depth"], delta=0.03 * height)
            self.assertGreater(design["sections"], 5)
        for number, bead in beads.items():
            gaps = {other: min(gap(a, b) for a in outlines[number] for b in outlines[other]) for other in outlines if other != number}
            nearest = min(gaps, key=gaps.get)
            self.assertAlmostEqual(gaps[nearest], bead["design"]["bead_distance"], delta=0.1)
            self.assertEqual(nearest, bead["design"]["nearest_bead"])

    def test_fillets_and_upright_walls_of_the_cad_kernel(self):
        """Beads of many faces: 6 mm high, walls upright, root fillet 3 mm, top fillet 2 mm."""
        beads = self.designs(example("filleted"))
        self.assertGreater(len(beads), 2)
        for bead in beads.values():
            design = bead["design"]
            self.assertAlmostEqual(6, design["depth"], delta=0.1)
            self.assertAlmostEqual(90, design["wall_angle"], delta=1)
            self.assertAlmostEqual(2, design["crown_radius"], delta=0.2)
            self.assertAlmostEqual(3, design["root_radius"], delta=0.3)

    def test_limits_are_flagged_and_named(self):
        free = self.designs(example("basic"))
        angles = sorted((bead["design"]["wall_angle"], number) for number, bead in free.items())
        limit = (angles[-1][0] + angles[-2][0]) / 2
        config = self.file("design.toml", f"[design]\nmax_wall_angle = {limit}\nmin_hole_distance = 1.0\n".encode())
        beads = self.designs(example("basic"), "--config", config, status=1)
        self.assertEqual([angles[-1][1]], [number for number, bead in beads.items() if bead["design"]["exceeded"]])
        self.assertEqual(["wall_angle"], beads[angles[-1][1]]["design"]["exceeded"])
        self.assertEqual(1, len([line for line in self.diagnostics if "design.wall_angle" in line and f"bead {angles[-1][1]}" in line]))
        self.assertEqual(0, run("beads", example("basic"), "--config", config).returncode)  # limits alone judge nothing

    def test_table_and_csv(self):
        result = run("beads", example("basic"), "--design-check", "--csv", "-")
        rows = list(csv.DictReader(io.StringIO(result.stdout)))
        self.assertEqual(MEASURES, list(rows[0])[-len(MEASURES):])
        for row, bead in zip(rows, self.designs(example("basic")).values()):
            for name in MEASURES[:-1]:
                value = bead["design"][name]
                if value is None:
                    self.assertEqual("", row[name])
                else:
                    self.assertAlmostEqual(value, float(row[name]), delta=1e-4)
        table = run("beads", example("basic"), "--design-check").stdout
        self.assertIn("depth/width", table)
        self.assertIn(f"{float(rows[0]['wall_angle']):.1f}", table)

    def test_beside_a_mesh_it_says_the_same(self):
        config = self.file("design.toml", b"[design]\nmax_wall_angle = 1.0\n")
        expected = self.designs(example("single"), "--config", config, status=1)[1]["design"]
        table, report = self.folder / "panel.csv", self.folder / "panel.html"
        result = run("mesh", example("single"), "-o", self.folder / "panel.bdf", "--design-check", "--config", config, "--json", "-",
                     "--csv", table, "--report", report)
        self.assertEqual(1, result.returncode, result.stderr)
        self.assertIn("design.wall_angle", result.stderr)
        self.assertEqual(expected, json.loads(result.stdout)["beads"][0]["design"])
        self.assertEqual(["wall_angle"], [row["exceeded"] for row in csv.DictReader(io.StringIO(table.read_text()))])
        self.assertIn('<section id="design"', report.read_text())

    def test_wrong_limits(self):
        for text, names in (("max_wall_angle = -1", "max_wall_angle"), ("min_radius = 3", "design.min_radius"), ("min_root_radius = 'x'", "number")):
            config = self.file("design.toml", f"[design]\n{text}\n".encode())
            self.assert_refused("beads", example("basic"), "--design-check", "--config", config, names=names)


if __name__ == "__main__":
    unittest.main()
