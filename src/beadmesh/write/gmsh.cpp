#include "beadmesh/write/gmsh.h"

#include <algorithm>
#include <array>
#include <ostream>
#include <utility>

#include "beadmesh/core/version.h"
#include "beadmesh/write/deck_text.h"

namespace beadmesh {
namespace {

constexpr int line_type = 1, triangle_type = 2, quad_type = 3;

using Line = std::array<Index, 2>;

/// A curve or a surface of the file with what is meshed on it.
struct Entity {
  int dimension = 2;
  Index tag = 0;
  std::vector<Index> groups = {};  ///< physical tags
  std::vector<Line> lines = {};
  std::vector<Index> quads = {}, triangles = {};  ///< element indices
  std::vector<Index> nodes = {};                  ///< those that belong here: on no entity before

  int block_count() const { return !lines.empty() + !quads.empty() + !triangles.empty(); }
};

struct Group {
  int dimension;
  Index tag;
  std::string name;
};

class GmshFile {
 public:
  GmshFile(const ShellMesh& mesh, const DeckOptions& options) : mesh_(mesh), options_(options) {
    for (const ShellPart& part : mesh.parts) groups_.push_back({2, property_id(part, options), part.name});
    for (const NamedSet& set : sets_of(mesh, options))
      groups_.push_back({set.is_of_nodes ? 1 : 2, set.id, set.name});
    std::sort(groups_.begin(), groups_.end(), [](const Group& a, const Group& b) {
      return std::pair(a.dimension, a.tag) < std::pair(b.dimension, b.tag);
    });
    add_curves();
    add_surfaces();
    place_nodes();
  }

  void write(std::ostream& out) const {
    Page page(out);
    page.line("$MeshFormat\n4.1 0 8\n$EndMeshFormat");
    page.line("$Comments");
    write_head(page, mesh_, options_, "");
    page.line("$EndComments");
    write_groups(page);
    write_entities(page);
    write_nodes(page);
    write_elements(page);
  }

 private:
  Index tag_of(const std::string& name) const {
    for (const Group& group : groups_)
      if (group.name == name) return group.tag;
    return no_index;
  }

  void add_curve(const std::string& group, std::vector<Line> lines) {
    if (lines.empty()) return;
    entities_.push_back({1, Index(entities_.size()) + 1, {tag_of(group)}, std::move(lines)});
  }

  void add_curves() {
    for (const BeadSet& bead : mesh_.beads) {
      std::vector<Line> crest;
      for (const std::vector<Index>& line : bead.crest_lines)
        for (size_t i = 1; i < line.size(); ++i) crest.push_back({line[i - 1], line[i]});
      const std::string name = fmt::format("bead_{}", bead.bead);
      add_curve(name + "_crest", std::move(crest));
      add_curve(name + "_boundary", boundary_lines(bead));
    }
  }

  /// Edges that one element of the bead has, in the order of its elements.
  std::vector<Line> boundary_lines(const BeadSet& bead) const {
    std::vector<Line> edges, sorted;
    for (const Index e : bead.elements) {
      const MeshElement& n = mesh_.elements[e].nodes;
      for (int i = 0; i < corner_count(n); ++i) edges.push_back({n[i], n[(i + 1) % corner_count(n)]});
    }
    const auto ascending = [](Line edge) {
      std::sort(edge.begin(), edge.end());
      return edge;
    };
    for (const Line& edge : edges) sorted.push_back(ascending(edge));
    std::sort(sorted.begin(), sorted.end());
    std::erase_if(edges, [&](const Line& edge) {
      const auto [first, last] = std::equal_range(sorted.begin(), sorted.end(), ascending(edge));
      return last - first > 1;
    });
    return edges;
  }

  /// Parts without the beads, then each bead's body and caps.
  void add_surfaces() {
    std::vector<Index> entity_of(mesh_.elements.size(), no_index);
    const auto claim = [&](const std::vector<Index>& elements, const std::string& name,
                           const std::string& more) {
      const Index entity = Index(entities_.size());
      for (const Index e : elements) entity_of[e] = entity;
      if (elements.empty()) return;
      const Index part = property_id(mesh_.parts[mesh_.elements[elements[0]].part], options_);
      entities_.push_back({2, entity + 1, {part, tag_of(name)}});
      if (!more.empty()) entities_.back().groups.push_back(tag_of(more));
    };
    for (const BeadSet& bead : mesh_.beads) {
      const std::string name = fmt::format("bead_{}", bead.bead);
      std::vector<Index> body;
      std::set_difference(bead.elements.begin(), bead.elements.end(), bead.cap_elements.begin(),
                          bead.cap_elements.end(), std::back_inserter(body));
      claim(body, name, "");
      claim(bead.cap_elements, name, name + "_caps");
    }
    std::vector<Index> sheet(mesh_.parts.size(), no_index);
    for (size_t e = 0; e < entity_of.size(); ++e) {
      const Index part = mesh_.elements[e].part;
      if (entity_of[e] == no_index && sheet[part] == no_index) {
        sheet[part] = Index(entities_.size());
        entities_.push_back({2, sheet[part] + 1, {property_id(mesh_.parts[part], options_)}});
      }
      Entity& entity = entities_[entity_of[e] == no_index ? sheet[part] : entity_of[e]];
      (is_quad(mesh_.elements[e].nodes) ? entity.quads : entity.triangles).push_back(Index(e));
    }
  }

  void place_nodes() {
    std::vector<bool> placed(mesh_.nodes.size(), false);
    const auto place = [&](Entity& entity, Index node) {
      if (!placed[node]) entity.nodes.push_back(node);
      placed[node] = true;
    };
    for (Entity& entity : entities_) {
      for (const Line& line : entity.lines)
        for (const Index node : line) place(entity, node);
      for (const auto* elements : {&entity.quads, &entity.triangles})
        for (const Index e : *elements)
          for (int i = 0; i < corner_count(mesh_.elements[e].nodes); ++i)
            place(entity, mesh_.elements[e].nodes[i]);
    }
  }

  void write_groups(Page& page) const {
    page.line("$PhysicalNames\n{}", groups_.size());
    for (const Group& group : groups_) page.line("{} {} \"{}\"", group.dimension, group.tag, group.name);
    page.line("$EndPhysicalNames");
  }

  void write_box(Page& page, const Entity& entity) const {
    Vec3 low{1e300, 1e300, 1e300}, high = -low;
    const auto include = [&](Index node) {
      const Vec3 p = mesh_.nodes[node];
      low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    };
    for (const Line& line : entity.lines)
      for (const Index node : line) include(node);
    for (const auto* elements : {&entity.quads, &entity.triangles})
      for (const Index e : *elements)
        for (int i = 0; i < corner_count(mesh_.elements[e].nodes); ++i) include(mesh_.elements[e].nodes[i]);
    page.text("{} {} {} {} {} {}", low.x, low.y, low.z, high.x, high.y, high.z);
  }

  /// Without corners of curves and curves of surfaces: a mesh needs neither.
  void write_entities(Page& page) const {
    const auto curves = std::count_if(entities_.begin(), entities_.end(),
                                      [](const Entity& entity) { return entity.dimension == 1; });
    page.line("$Entities\n0 {} {} 0", curves, entities_.size() - curves);
    for (const Entity& entity : entities_) {
      page.text("{} ", entity.tag);
      write_box(page, entity);
      page.text(" {}", entity.groups.size());
      for (const Index group : entity.groups) page.text(" {}", group);
      page.line(" 0");
    }
    page.line("$EndEntities");
  }

  void write_nodes(Page& page) const {
    const auto blocks = std::count_if(entities_.begin(), entities_.end(),
                                      [](const Entity& entity) { return !entity.nodes.empty(); });
    const Index first = options_.first_node, count = Index(mesh_.nodes.size());
    page.line("$Nodes\n{} {} {} {}", blocks, count, first, first + count - 1);
    for (const Entity& entity : entities_) {
      if (entity.nodes.empty()) continue;
      page.line("{} {} 0 {}", entity.dimension, entity.tag, entity.nodes.size());
      for (const Index node : entity.nodes) page.line("{}", node + first);
      for (const Index node : entity.nodes)
        page.line("{} {} {}", mesh_.nodes[node].x, mesh_.nodes[node].y, mesh_.nodes[node].z);
    }
    page.line("$EndNodes");
  }

  void write_elements(Page& page) const {
    const Index first = options_.first_element;
    Index blocks = 0, line_id = first + Index(mesh_.elements.size());
    size_t lines = 0;
    for (const Entity& entity : entities_) {
      blocks += entity.block_count();
      lines += entity.lines.size();
    }
    page.line("$Elements\n{} {} {} {}", blocks, mesh_.elements.size() + lines, first,
              line_id - 1 + Index(lines));
    for (const Entity& entity : entities_) {
      if (!entity.lines.empty())
        page.line("{} {} {} {}", entity.dimension, entity.tag, line_type, entity.lines.size());
      for (const Line& line : entity.lines)
        page.line("{} {} {}", line_id++, line[0] + options_.first_node, line[1] + options_.first_node);
      write_block(page, entity, quad_type, entity.quads);
      write_block(page, entity, triangle_type, entity.triangles);
    }
    page.line("$EndElements");
  }

  void write_block(Page& page, const Entity& entity, int type, const std::vector<Index>& elements) const {
    if (elements.empty()) return;
    page.line("{} {} {} {}", entity.dimension, entity.tag, type, elements.size());
    for (const Index e : elements) {
      const MeshElement& n = mesh_.elements[e].nodes;
      page.text("{}", e + options_.first_element);
      for (int i = 0; i < corner_count(n); ++i) page.text(" {}", n[i] + options_.first_node);
      page.end_line();
    }
  }

  const ShellMesh& mesh_;
  const DeckOptions& options_;
  std::vector<Group> groups_;
  std::vector<Entity> entities_;
};

}  // namespace

void write_gmsh(const ShellMesh& mesh, std::ostream& out, const DeckOptions& options) {
  GmshFile(mesh, options).write(out);
}

}  // namespace beadmesh
