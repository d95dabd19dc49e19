#include "beadmesh/read/panel_reader.h"

#include "beadmesh/read/cad_reader.h"
#include "beadmesh/read/input_file.h"
#include "beadmesh/read/stl_reader.h"

namespace beadmesh {

Result<Panel> read_panel(const std::filesystem::path& path, const ReadOptions& options,
                         const Context& context) {
  const Result<FileKind> kind = check_input_file(path);
  if (!kind) return Failure(kind.error());
  if (*kind == FileKind::stl) return read_stl_panel(path, options);
  return read_cad_panel(path, options, context);
}

}  // namespace beadmesh
