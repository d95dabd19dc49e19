"""Broken input and wrong usage: one clear line on stderr, exit status 2, nothing written."""
import unittest

from command import Case, example


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


class BrokenPolygons(Case):
    def test_polygons_that_are_none(self):
        for name, text in (("empty.wkt", ""), ("open.wkt", "POLYGON((0 0, 10 0"), ("line.wkt", "LINESTRING(0 0, 1 1)"),
                           ("bow_tie.wkt", "POLYGON((0 0, 10 10, 10 0, 0 10, 0 0))"), ("flat.wkt", "POLYGON((0 0, 1 0, 2 0, 0 0))"),
                           ("number.wkt", "POLYGON((0 0, nan 0, 2 2, 0 0))"), ("empty.poly", ""), ("short.poly", "4 2 0 0\n1 0 0\n")):
            with self.subTest(name):
                self.assert_refused("medial", self.file(name, text.encode()), "--json", "-", names=name)


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
        self.assert_refused("mesh", example("basic"))

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


if __name__ == "__main__":
    unittest.main()
