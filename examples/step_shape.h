// A shape of the CAD kernel as a STEP file (AP214, mm).
#pragma once

#include <TopoDS_Shape.hxx>
#include <filesystem>

namespace beadmesh::examples {

/// False where the file cannot be written.
bool write_shape(const TopoDS_Shape& shape, const std::filesystem::path& path);

}  // namespace beadmesh::examples
