"""Tests of scripts/check_includes.py on small trees of its own."""
import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))
import check_includes  # noqa: E402


class CheckIncludes(unittest.TestCase):
    def breaches(self, files):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            for name, text in files.items():
                path = root / name
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(text)
            return check_includes.check(root)

    def test_an_arrow_in_order_passes(self):
        self.assertEqual([], self.breaches({
            "src/beadmesh/mesh/a.cpp": '#include "beadmesh/mesh/a.h"\n#include "beadmesh/core/vector.h"\n#include <vector>\n',
            "src/beadmesh/mesh/a.h": '#include "beadmesh/bead/bead.h"\n',
        }))

    def test_an_arrow_back_is_named_with_its_line(self):
        lines = self.breaches({"src/beadmesh/delaunay/a.cpp": '#include <vector>\n#include "beadmesh/medial/b.h"\n'})
        self.assertEqual(["src/beadmesh/delaunay/a.cpp:2: delaunay must not include medial (beadmesh/medial/b.h)"], lines)

    def test_neighbours_do_not_see_each_other(self):
        self.assertEqual(1, len(self.breaches({"src/beadmesh/write/a.cpp": '#include "beadmesh/report/b.h"\n'})))
        self.assertEqual(1, len(self.breaches({"src/beadmesh/medial/a.cpp": '#include "beadmesh/read/b.h"\n'})))

    def test_pipeline_uses_all_but_input_and_output(self):
        self.assertEqual([], self.breaches({"src/beadmesh/pipeline.cpp": '#include "beadmesh/mesh/a.h"\n'}))
        for room in ("read", "write", "report"):
            self.assertEqual(1, len(self.breaches({"src/beadmesh/pipeline.cpp": f'#include "beadmesh/{room}/a.h"\n'})))

    def test_a_room_below_the_pipeline_does_not_see_it(self):
        self.assertEqual(1, len(self.breaches({"src/beadmesh/mesh/a.cpp": '#include "beadmesh/pipeline.h"\n'})))

    def test_opencascade_stays_in_read(self):
        self.assertEqual([], self.breaches({"src/beadmesh/read/a.cpp": "#include <TopoDS.hxx>\n"}))
        for name in ("src/beadmesh/panel/a.cpp", "apps/beadmesh/main.cpp", "tests/panel/a_test.cpp"):
            self.assertEqual(1, len(self.breaches({name: "#include <TopoDS.hxx>\n"})), name)

    def test_third_party_headers_stay_out_of_what_others_see(self):
        header = {"src/beadmesh/panel/a.h": "#include <fmt/format.h>\n#include <tl/expected.hpp>\n"}
        self.assertEqual([], self.breaches(header))
        user = {"src/beadmesh/flatten/b.cpp": '#include "beadmesh/panel/c.h"\n',
                "src/beadmesh/panel/c.h": '#include "beadmesh/panel/a.h"\n'}
        self.assertEqual(["src/beadmesh/panel/a.h:1: third-party header in a public header (fmt/format.h)"],
                         self.breaches(header | user))

    def test_an_unknown_room_is_named(self):
        self.assertEqual(1, len(self.breaches({"src/beadmesh/attic/a.cpp": "\n"})))


if __name__ == "__main__":
    unittest.main()
