#include "beadmesh/write/whole_files.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <ostream>

#include "write/scratch_folder.h"

namespace beadmesh {
namespace {

namespace fs = std::filesystem;
using test::ScratchFolder;

std::string content(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

WholeFiles::Writer text(const char* words) {
  return [words](std::ostream& out) { out << words; };
}

TEST(WholeFiles, PutsAllFilesInPlaceAtTheCommit) {
  const ScratchFolder folder;
  WholeFiles files;
  ASSERT_TRUE(files.add(folder / "a.txt", text("alpha")));
  ASSERT_TRUE(files.add(folder / "b.txt", text("beta")));
  EXPECT_FALSE(fs::exists(folder / "a.txt"));
  ASSERT_TRUE(files.commit());
  EXPECT_EQ(content(folder / "a.txt"), "alpha");
  EXPECT_EQ(content(folder / "b.txt"), "beta");
  EXPECT_EQ(folder.count(), 2);
}

TEST(WholeFiles, LeavesNothingWithoutACommit) {
  const ScratchFolder folder;
  { std::ofstream(folder / "a.txt") << "before"; }
  {
    WholeFiles files;
    ASSERT_TRUE(files.add(folder / "a.txt", text("after")));
    ASSERT_TRUE(files.add(folder / "b.txt", text("new")));
  }
  EXPECT_EQ(content(folder / "a.txt"), "before");
  EXPECT_EQ(folder.count(), 1);
}

TEST(WholeFiles, RemovesTheFirstFileWhenTheSecondCannotBePutInPlace) {
  const ScratchFolder folder;
  WholeFiles files;
  ASSERT_TRUE(files.add(folder / "a.txt", text("alpha")));
  ASSERT_TRUE(files.add(folder / "b.txt", text("beta")));
  fs::create_directory(folder / "b.txt");  // someone takes the place meanwhile
  const auto done = files.commit();
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().code, "write.rename");
  EXPECT_FALSE(fs::exists(folder / "a.txt"));
}

TEST(WholeFiles, FollowsASymbolicLink) {
  const ScratchFolder folder;
  fs::create_directory(folder / "elsewhere");
  fs::create_symlink(folder / "elsewhere" / "real.txt", folder / "link.txt");
  ASSERT_TRUE(write_whole(folder / "link.txt", text("through")));
  EXPECT_TRUE(fs::is_symlink(folder / "link.txt"));
  EXPECT_EQ(content(folder / "elsewhere" / "real.txt"), "through");
}

TEST(WholeFiles, NamesAStreamThatFailed) {
  const ScratchFolder folder;
  const auto done = write_whole(folder / "a.txt", [](std::ostream& out) { out.setstate(std::ios::badbit); });
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().code, "write.full");
  EXPECT_EQ(folder.count(), 0);
}

TEST(CheckTarget, KnowsWhereAFileCanGo) {
  const ScratchFolder folder;
  EXPECT_TRUE(check_target(folder / "new.bdf"));
  EXPECT_EQ(check_target(folder / "missing" / "new.bdf").error().code, "write.folder");
  EXPECT_EQ(check_target(folder.path()).error().code, "write.target");
  EXPECT_EQ(check_target("/dev/null").error().code, "write.target");
  EXPECT_EQ(check_target("").error().code, "write.target");
  EXPECT_EQ(folder.count(), 0);
}

}  // namespace
}  // namespace beadmesh
