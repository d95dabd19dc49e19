#include "beadmesh/read/facet_file.h"

#include <cmath>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>

#include "beadmesh/read/facet_skin.h"
#include "beadmesh/read/obj_reader.h"
#include "beadmesh/read/ply_reader.h"
#include "beadmesh/read/stl_reader.h"

namespace beadmesh {

Result<Panel> read_facet_panel(const std::filesystem::path& path, FileKind kind, const ReadOptions& options) {
  const std::string name = path.filename().string();
  const std::optional<double> factor = millimetres_per(options.unit);
  if (!factor)
    return fail("read.unit", "the unit '" + options.unit + "' is unknown", "use mm, cm, m, um, in or ft",
                name);
  std::ifstream stream(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  auto facets = kind == FileKind::obj   ? parse_obj(bytes, name)
                : kind == FileKind::ply ? parse_ply(bytes, name)
                                        : parse_stl(bytes, name);
  if (!facets) return Failure(facets.error());
  for (auto& corners : facets->corners)
    for (Vec3& p : corners) {
      p = p * *factor;
      if (!std::isfinite(p.x + p.y + p.z))
        return fail("read.unreadable", "a facet has a corner that is not finite", {}, name);
    }
  Panel panel = panel_of_facets(*facets, options.feature_angle);
  if (panel.faces.empty()) return fail("read.no_faces", "the file has no facets", {}, name);
  panel.input = name;
  panel.unit = options.unit;
  return panel;
}

}  // namespace beadmesh
