#include "beadmesh/read/panel_reader.h"

#include <utility>

#include "beadmesh/read/cad_reader.h"
#include "beadmesh/read/facet_file.h"
#include "beadmesh/read/input_file.h"
#include "beadmesh/read/shell_deck_panel.h"

namespace beadmesh {

Result<Panel> read_panel(const std::filesystem::path& path, const ReadOptions& options,
                         const Context& context) {
  const Result<FileKind> kind = check_input_file(path);
  if (!kind) return Failure(kind.error());
  if (*kind == FileKind::shells) return read_shell_panel(path, options);
  if (*kind == FileKind::stl || *kind == FileKind::obj || *kind == FileKind::ply)
    return read_facet_panel(path, *kind, options);
  Result<Panel> panel = read_cad_panel(path, options, context);
  if (!panel) return panel;
  ThinSolidOptions thin;
  thin.skin = options.skin;
  return with_skins(std::move(*panel), thin);
}

}  // namespace beadmesh
