#include "beadmesh/core/diagnostic.h"

#include <gtest/gtest.h>

#include "beadmesh/core/result.h"

namespace beadmesh {
namespace {

TEST(DiagnosticLine, NamesSeverityCodeFaceEntityMessageAndHint) {
  const Diagnostic d{"mesh.bead.fallback",         Severity::warning,   7, "bead 3",
                     "meshed as an ordinary face", "try a smaller size"};
  EXPECT_EQ(to_line(d),
            "warning mesh.bead.fallback: face 7: bead 3: meshed as an ordinary face (try a smaller size)");
}

TEST(DiagnosticLine, LeavesOutWhatIsEmpty) {
  EXPECT_EQ(to_line({"read.empty", Severity::error, no_index, "", "the file is empty", ""}),
            "error read.empty: the file is empty");
}

TEST(DiagnosticLine, IsOneLineWhateverTheMessageHolds) {
  const std::string line = to_line({"a.b", Severity::note, no_index, "x\ny", "first\r\nsecond", "third\n"});
  EXPECT_EQ(line.find_first_of("\r\n"), std::string::npos);
}

TEST(Fail, MakesAnErrorWithItsEntity) {
  const Result<int> failed = fail("read.no_faces", "no faces", "export surfaces", "panel.step", 4);
  ASSERT_FALSE(failed);
  EXPECT_EQ(failed.error().severity, Severity::error);
  EXPECT_EQ(failed.error().face, 4);
  EXPECT_EQ(failed.error().entity, "panel.step");
}

}  // namespace
}  // namespace beadmesh
