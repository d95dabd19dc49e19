#include "beadmesh/read/polygon_reader.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <string>

#include "beadmesh/read/poly_reader.h"
#include "beadmesh/read/polygon_text.h"
#include "beadmesh/read/wkt_reader.h"

namespace beadmesh {

Result<PlanarRegion> parse_wkt(std::string_view text) {
  return read::wkt_region(text);
}

Result<PlanarRegion> parse_poly(std::string_view text) {
  return read::poly_region(text);
}

Result<PlanarRegion> read_polygon(const std::filesystem::path& path) {
  const std::string ending = read::lower_case(path.extension().string());
  const auto failure = [&](const char* code, const char* message) {
    return fail(code, message, {}, path.string());
  };
  if (ending != ".wkt" && ending != ".poly")
    return failure("read.ending", "a plane polygon ends in .wkt or .poly");
  std::error_code error;
  if (!std::filesystem::exists(path, error)) return failure("read.not_found", "there is no such file");
  if (std::filesystem::is_directory(path, error)) return failure("read.directory", "this is a directory");
  std::ifstream file(path, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  if (!file) return failure("read.unreadable", "the file cannot be read");
  if (std::all_of(text.begin(), text.end(), read::is_space))
    return failure("read.empty", "the file is empty");
  auto region = ending == ".wkt" ? parse_wkt(text) : parse_poly(text);
  if (!region) {
    Diagnostic& diagnostic = region.error();
    diagnostic.entity =
        path.filename().string() + (diagnostic.entity.empty() ? "" : ", " + diagnostic.entity);
  }
  return region;
}

}  // namespace beadmesh
