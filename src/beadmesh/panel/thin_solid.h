// A panel that was modelled with its thickness, as a skin.
#pragma once

#include <string>
#include <string_view>

#include "beadmesh/core/result.h"
#include "beadmesh/panel/panel.h"

namespace beadmesh {

/// Which skin of a thin solid is kept.
enum class Skin {
  outer,   ///< the side with the larger area
  inner,   ///< the other one
  middle,  ///< the outer one moved inwards by half the thickness
  whole    ///< solids stay as they are
};

std::string_view name_of(Skin skin);
/// By its name. Fails with usage.skin.
Result<Skin> skin_of(std::string_view name);

struct ThinSolidOptions {
  Skin skin = Skin::outer;    ///< default: exact surfaces, and the hull that others see
  double least_pairs = 0.75;  ///< default 0.75 of the area must lie opposite to the other side
  double spread = 1.6;        ///< default 1.6: farther than so many thicknesses is not opposite
};

/// Every connected closed piece of the panel that is a thin sheet becomes one of its sides; the faces of the
/// other side and along the rim are left out, and PanelFace::thickness is what rays across have measured.
/// Closed pieces that are no thin sheet stay whole. Both are said in Panel::diagnostics (read.skin,
/// read.solid).
Panel with_skins(Panel panel, const ThinSolidOptions& options = {});

}  // namespace beadmesh
