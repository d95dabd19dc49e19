#include "beadmesh/read/panel_reader.h"

#include <utility>

#include "beadmesh/read/cad_reader.h"
#include "beadmesh/read/input_file.h"
#include "beadmesh/read/stl_reader.h"

namespace beadmesh {

Result<Panel> read_panel(const std::filesystem::path& path, const ReadOptions& options,
                         const Context& context) {
  const Result<FileKind> kind = check_input_file(path);
  if (!kind) return Failure(kind.error());
  if (*kind == FileKind::stl) return read_stl_panel(path, options);
  Result<Panel> panel = read_cad_panel(path, options, context);
  if (!panel) return panel;
  ThinSolidOptions thin;
  thin.skin = options.skin;
  return with_skins(std::move(*panel), thin);
}

}  // namespace beadmesh
