#include "beadmesh/read/panel_reader.h"

#include <cstdio>
#include <utility>

#include "beadmesh/read/cad_reader.h"
#include "beadmesh/read/facet_file.h"
#include "beadmesh/read/input_file.h"
#include "beadmesh/read/shell_deck_panel.h"

namespace beadmesh {
namespace {

/// A panel in metres that is read as one in mm.
void warn_where_tiny(Panel& panel) {
  constexpr double least = 5;  // mm
  const double size = diagonal(panel);
  if (size >= least) return;
  char text[96];
  std::snprintf(text, sizeof text, "the panel is %.3g mm across", size);
  panel.diagnostics.push_back(
      {"read.tiny", Severity::warning, no_index, {}, text, "check its unit, which is " + panel.unit});
}

}  // namespace

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
  warn_where_tiny(*panel);
  return with_skins(std::move(*panel), thin);
}

}  // namespace beadmesh
