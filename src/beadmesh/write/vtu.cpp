#include "beadmesh/write/vtu.h"

#include <bit>
#include <cstdint>
#include <cstring>
#include <ostream>

#include "beadmesh/mesh/element_quality.h"
#include "beadmesh/write/deck_text.h"

namespace beadmesh {
namespace {

static_assert(std::endian::native == std::endian::little, "the file says LittleEndian");

constexpr unsigned char quad_cell = 9, triangle_cell = 5;

/// Bytes in base64 (RFC 4648), padded.
std::string base64(const std::vector<unsigned char>& bytes) {
  constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (size_t i = 0; i < bytes.size(); i += 3) {
    const size_t left = bytes.size() - i;
    const unsigned bits = unsigned(bytes[i]) << 16 | (left > 1 ? unsigned(bytes[i + 1]) << 8 : 0) |
                          (left > 2 ? unsigned(bytes[i + 2]) : 0);
    text += digits[bits >> 18];
    text += digits[bits >> 12 & 63];
    text += left > 1 ? digits[bits >> 6 & 63] : '=';
    text += left > 2 ? digits[bits & 63] : '=';
  }
  return text;
}

template <class Value>
constexpr const char* type_name();
template <>
constexpr const char* type_name<double>() {
  return "Float64";
}
template <>
constexpr const char* type_name<std::int32_t>() {
  return "Int32";
}
template <>
constexpr const char* type_name<std::int64_t>() {
  return "Int64";
}
template <>
constexpr const char* type_name<unsigned char>() {
  return "UInt8";
}

template <class Value>
void write_array(Page& page, const char* name, const std::vector<Value>& values, int components = 1) {
  const std::uint64_t size = values.size() * sizeof(Value);
  std::vector<unsigned char> bytes(sizeof(size) + size);
  std::memcpy(bytes.data(), &size, sizeof(size));
  if (size > 0) std::memcpy(bytes.data() + sizeof(size), values.data(), size);
  page.line("<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"binary\">",
            type_name<Value>(), name, components);
  page.line("{}", base64(bytes));
  page.line("</DataArray>");
}

std::vector<std::int32_t> ids(size_t count, Index first) {
  std::vector<std::int32_t> result(count);
  for (size_t i = 0; i < count; ++i) result[i] = Index(i) + first;
  return result;
}

void write_points(Page& page, const std::vector<Vec3>& nodes) {
  std::vector<double> coordinates;
  for (const Vec3& p : nodes) coordinates.insert(coordinates.end(), {p.x, p.y, p.z});
  page.line("<Points>");
  write_array(page, "Points", coordinates, 3);
  page.line("</Points>");
}

void write_cells(Page& page, const ShellMesh& mesh) {
  std::vector<std::int64_t> connectivity, offsets;
  std::vector<unsigned char> types;
  for (const ShellElement& element : mesh.elements) {
    connectivity.insert(connectivity.end(), element.nodes.begin(),
                        element.nodes.begin() + corner_count(element.nodes));
    offsets.push_back(std::int64_t(connectivity.size()));
    types.push_back(is_quad(element.nodes) ? quad_cell : triangle_cell);
  }
  page.line("<Cells>");
  write_array(page, "connectivity", connectivity);
  write_array(page, "offsets", offsets);
  write_array(page, "types", types);
  page.line("</Cells>");
}

void write_point_data(Page& page, const ShellMesh& mesh, const DeckOptions& options) {
  std::vector<std::int32_t> crest(mesh.nodes.size(), 0), boundary(mesh.nodes.size(), 0);
  const auto mark = [](std::vector<std::int32_t>& of_node, const std::vector<Index>& nodes, Index bead) {
    for (const Index node : nodes)
      if (of_node[node] == 0) of_node[node] = bead;
  };
  for (const BeadSet& bead : mesh.beads) {
    mark(crest, bead.crest_nodes, bead.bead);
    mark(boundary, bead.boundary_nodes, bead.bead);
  }
  page.line("<PointData Scalars=\"crest\">");
  write_array(page, "id", ids(mesh.nodes.size(), options.first_node));
  write_array(page, "crest", crest);
  write_array(page, "boundary", boundary);
  page.line("</PointData>");
}

std::int32_t number_of_kind(const std::string& kind) {
  return kind == "I" ? 1 : kind == "generic" ? 2 : kind == "annular" ? 3 : 0;
}

void write_quality(Page& page, const ShellMesh& mesh) {
  std::vector<double> thickness, jacobian, warped, shortest;
  for (const ShellElement& element : mesh.elements) {
    thickness.push_back(mesh.parts[element.part].thickness);
    jacobian.push_back(scaled_jacobian(mesh.nodes, element.nodes));
    warped.push_back(degrees(warpage(mesh.nodes, element.nodes)));
    shortest.push_back(side_lengths(mesh.nodes, element.nodes)[0]);
  }
  write_array(page, "thickness", thickness);
  write_array(page, "scaled_jacobian", jacobian);
  write_array(page, "warpage", warped);
  write_array(page, "shortest_edge", shortest);
}

void write_cell_data(Page& page, const ShellMesh& mesh, const DeckOptions& options) {
  std::vector<std::int32_t> part, bead, face, kind(mesh.elements.size(), 0);
  std::vector<unsigned char> cap(mesh.elements.size(), 0);
  for (const ShellElement& element : mesh.elements) {
    part.push_back(property_id(mesh.parts[element.part], options));
    bead.push_back(element.bead);
    face.push_back(element.face);
  }
  for (const BeadSet& set : mesh.beads) {
    for (const Index e : set.elements) kind[e] = number_of_kind(set.kind);
    for (const Index e : set.cap_elements) cap[e] = 1;
  }
  page.line("<CellData Scalars=\"kind\">");
  write_array(page, "id", ids(mesh.elements.size(), options.first_element));
  write_array(page, "part", part);
  write_array(page, "bead", bead);
  write_array(page, "kind", kind);
  write_array(page, "face", face);
  write_array(page, "cap", cap);
  write_quality(page, mesh);
  page.line("</CellData>");
}

/// Two hyphens would end an XML comment.
std::string for_comment(std::string text) {
  for (size_t at = 0; (at = text.find("--", at)) != std::string::npos;) text.replace(at, 2, "- ");
  return text;
}

}  // namespace

void write_vtu(const ShellMesh& mesh, std::ostream& out, const DeckOptions& options) {
  Page page(out);
  page.line("<?xml version=\"1.0\"?>");
  page.line("<!--");
  for (const std::string& line : head_lines(mesh, options)) page.line("{}", for_comment(line));
  page.line("-->");
  page.line(
      "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\">");
  page.line("<UnstructuredGrid>");
  page.line("<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">", mesh.nodes.size(), mesh.elements.size());
  write_point_data(page, mesh, options);
  write_cell_data(page, mesh, options);
  write_points(page, mesh.nodes);
  write_cells(page, mesh);
  page.line("</Piece>\n</UnstructuredGrid>\n</VTKFile>");
}

}  // namespace beadmesh
