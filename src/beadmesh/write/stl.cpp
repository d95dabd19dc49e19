#include "beadmesh/write/stl.h"

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <ostream>

#include "beadmesh/core/version.h"
#include "beadmesh/write/deck_text.h"

namespace beadmesh {
namespace {

static_assert(std::endian::native == std::endian::little, "STL is little-endian");

constexpr size_t head_size = 80, record_size = 50;

class Facet {
 public:
  Facet(Vec3 a, Vec3 b, Vec3 c) {
    const Vec3 normal = normalized(cross(b - a, c - a));
    for (const Vec3& v : {normal, a, b, c})
      for (const double coordinate : {v.x, v.y, v.z}) put(float(coordinate));
  }
  const char* bytes() const { return bytes_.data(); }

 private:
  void put(float value) {
    std::memcpy(bytes_.data() + at_, &value, sizeof(value));
    at_ += sizeof(value);
  }

  std::array<char, record_size> bytes_ = {};  // the last two are the attribute, 0
  size_t at_ = 0;
};

std::uint32_t facet_count(const ShellMesh& mesh) {
  std::uint32_t count = 0;
  for (const ShellElement& element : mesh.elements) count += is_quad(element.nodes) ? 2 : 1;
  return count;
}

}  // namespace

void write_stl(const ShellMesh& mesh, std::ostream& out, const DeckOptions&) {
  std::string head = plain(fmt::format("beadmesh {}: {}", version(), mesh.title), head_size);
  head.resize(head_size, ' ');
  const std::uint32_t count = facet_count(mesh);
  out.write(head.data(), head_size);
  out.write(reinterpret_cast<const char*>(&count), sizeof(count));
  for (const ShellElement& element : mesh.elements)
    for (int i = 2; i < corner_count(element.nodes); ++i) {
      const Facet facet(mesh.nodes[element.nodes[0]], mesh.nodes[element.nodes[i - 1]],
                        mesh.nodes[element.nodes[i]]);
      out.write(facet.bytes(), record_size);
    }
}

}  // namespace beadmesh
