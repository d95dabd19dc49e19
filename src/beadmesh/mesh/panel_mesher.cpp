#include "beadmesh/mesh/panel_mesher.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>
#include <optional>

#include "beadmesh/mesh/chain_counts.h"
#include "beadmesh/mesh/chain_nodes.h"
#include "beadmesh/mesh/controlled_bead.h"
#include "beadmesh/mesh/face_mesher.h"
#include "beadmesh/mesh/face_shortfalls.h"
#include "beadmesh/mesh/ring_counts.h"
#include "beadmesh/panel/chain.h"

namespace beadmesh {
namespace {

/// Lengths are checked on the facets while meshing, on the exact surface and its edges at the end: the
/// difference, a share of the length on the surface and half the chord of the facets at edges, needs some
/// room.
double with_room(double min_edge) {
  return min_edge + std::max(0.01 * min_edge, 0.025);
}

/// Runs the tasks at once, each thread the largest that is left: a large one begun last would be waited for.
template <class Task>
void largest_first(const std::vector<size_t>& sizes, Task task) {
  std::vector<size_t> order(sizes.size());
  std::iota(order.begin(), order.end(), size_t(0));
  std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) { return sizes[a] > sizes[b]; });
  std::atomic<size_t> next = 0;
  tbb::parallel_for(size_t(0), sizes.size(), [&](size_t) { task(order[next++]); });
}

/// The mesh of one face with the way from its nodes to those on the boundary.
struct FaceMesh {
  PlanarMesh mesh;
  std::vector<std::pair<Index, Index>> boundary;  ///< (node of the face, boundary node of the panel)
  std::vector<std::vector<Index>> crest_lines;
  std::vector<Index> cap_elements;
  std::vector<BlockLine> block_lines;
};

class PanelMesher {
 public:
  PanelMesher(const Panel& panel, const StudiedPanel& studied, const PanelMesherOptions& options,
              std::vector<BeadMeshControl> controls, const Context& context)
      : panel_(panel),
        studied_(studied),
        options_(options),
        controls_(std::move(controls)),
        context_(context),
        inner_min_edge_(with_room(options.min_edge)),
        field_(options.size, options.local_sizes, {options.chordal_deviation, 1.05 * inner_min_edge_}),
        chains_(chains_of(panel)),
        nodes_(panel, chains_),
        face_meshes_(panel.faces.size()),
        bead_of_face_(panel.faces.size(), no_index) {
    // The elements across beads follow their section already.
    const SizeField of_beads(options.size, options.local_sizes);
    out_.table = studied.table;
    for (size_t b = 0; b < studied.table.beads.size(); ++b)
      bead_of_face_[studied.table.beads[b].faces[0]] = Index(b);
    out_.meshing.resize(studied.table.beads.size());
    for (size_t b = 0; b < controls_.size(); ++b) {
      out_.meshing[b].size =
          controls_[b].size.value_or(of_beads.of_face(panel.faces[face_of(Index(b))].facets));
      out_.meshing[b].min_edge = controls_[b].min_edge.value_or(options.min_edge);
    }
  }

  Result<PanelMesh> run() {
    context_.report("beads", 0);
    mesh_beads();
    context_.report("sheet", 0);
    place_remaining_chains();
    mesh_faces();
    if (context_.is_cancelled()) return fail("mesh.cancelled", "cancelled");
    context_.report("assemble", 0);
    assemble();
    if (out_.mesh.elements.empty()) return fail("mesh.nothing", "no face of the panel could be meshed");
    for (Diagnostic& one : face_shortfalls(out_.mesh, options_.min_edge))
      out_.table.diagnostics.push_back(std::move(one));
    drop_unlisted();
    return std::move(out_);
  }

 private:
  // ---------------------------------------------------------------- beads

  /// Beads that share a chain are done one after the other, in the order of their numbers; groups in
  /// parallel.
  void mesh_beads() {
    count_rings();
    const auto groups = bead_groups();
    std::vector<std::optional<BeadMesh>> meshes(out_.meshing.size());
    std::vector<size_t> single, shared;
    for (size_t g = 0; g < groups.size(); ++g) (groups[g].size() == 1 ? single : shared).push_back(g);
    std::atomic<int> done = 0;
    std::vector<size_t> facets;
    for (size_t g : single) facets.push_back(facet_count(face_of(groups[g][0])));
    largest_first(facets, [&](size_t i) {
      const Index b = groups[single[i]][0];
      meshes[b] = attempt_bead(b);
      context_.report("beads", double(++done) / double(groups.size()));
    });
    for (Index b = 0; b < Index(meshes.size()); ++b)
      if (meshes[b]) accept(b, std::move(*meshes[b]));
    for (size_t g : shared)
      for (Index b : groups[g])
        if (auto mesh = attempt_bead(b)) accept(b, std::move(*mesh));
  }

  std::vector<std::vector<Index>> bead_groups() const {
    const Index n = Index(out_.meshing.size());
    std::vector<Index> group(n);
    for (Index b = 0; b < n; ++b) group[b] = b;
    for (bool changed = true; changed;) {
      changed = false;
      for (const Chain& chain : chains_.chains) {
        if (chain.faces[0] == no_index || chain.faces[1] == no_index) continue;
        const Index a = bead_of_face_[chain.faces[0]], b = bead_of_face_[chain.faces[1]];
        if (a == no_index || b == no_index || group[a] == group[b]) continue;
        group[a] = group[b] = std::min(group[a], group[b]);
        changed = true;
      }
    }
    std::vector<std::vector<Index>> groups(n);
    for (Index b = 0; b < n; ++b) groups[group[b]].push_back(b);
    groups.erase(std::remove_if(groups.begin(), groups.end(), [](const auto& g) { return g.empty(); }),
                 groups.end());
    return groups;
  }

  /// Elements along all loops of all rings, before any of them is meshed.
  void count_rings() {
    std::vector<RingBetween> rings;
    for (Index b = 0; b < Index(out_.meshing.size()); ++b) {
      const auto& loops = chains_.loops[face_of(b)];
      const Bead& bead = studied_.table.beads[b];
      if (bead.kind != BeadKind::annular || loops.size() != 2 || !boundary_is_closed_chains(face_of(b)))
        continue;
      rings.push_back({{loops[0][0].chain, loops[1][0].chain},
                       bead.width,
                       out_.meshing[b].size,
                       out_.meshing[b].min_edge,
                       controls_[b].elements_along.value_or(0)});
    }
    std::vector<double> lengths;
    for (const Chain& chain : chains_.chains) lengths.push_back(chain.length());
    ring_counts_ = counts_of_rings(rings, lengths);
  }

  size_t facet_count(Index face) const { return panel_.faces[face].facets.triangles.size(); }

  Index face_of(Index bead) const { return studied_.table.beads[bead].faces[0]; }

  bool boundary_is_closed_chains(Index face) const {
    for (Index l = 0; l < Index(chains_.loops[face].size()); ++l) {
      if (nodes_.segments_of(face, l).empty()) return false;
      for (const ChainUse& use : chains_.loops[face][l])
        if (!chains_.chains[use.chain].closed) return false;
    }
    return true;
  }

  std::optional<BeadMesh> attempt_bead(Index b) {
    if (context_.is_cancelled()) return std::nullopt;
    const Index face = face_of(b);
    BeadMeshing& meshing = out_.meshing[b];
    if (controls_[b].method == BeadMethod::face) return std::nullopt;
    if (!boundary_is_closed_chains(face)) {
      meshing.notes.push_back("its boundary is shared by several faces or has corners");
      return std::nullopt;
    }
    const FaceStudy& study = *studied_.studies[face];
    BeadMesherOptions options{meshing.size, with_room(meshing.min_edge), {}, {}, controls_[b]};
    for (Index l = 0; l < Index(study.region.loops.size()); ++l) {
      options.elements_on_loop.push_back(ring_counts_[chains_.loops[face][l][0].chain]);
      options.prescribed.emplace_back();
      for (const LoopNode& node : nodes_.nodes_of_loop(face, l, study.region))
        options.prescribed.back().push_back(node.position);
    }
    auto mesh = mesh_bead_as_asked(study, *studied_.medials[face], studied_.table.beads[b].kind, options);
    if (mesh) return std::move(*mesh);
    meshing.notes.push_back(mesh.error().message);
    return std::nullopt;
  }

  void accept(Index b, BeadMesh mesh) {
    const Index face = face_of(b);
    const PlanarRegion& region = studied_.studies[face]->region;
    FaceMesh out;
    std::vector<BoundaryPosition> fresh;
    std::vector<Index> fresh_nodes;
    for (Index l = 0; l < Index(region.loops.size()); ++l) {
      const auto known = nodes_.nodes_of_loop(face, l, region);
      for (const BoundaryNode& node : mesh.boundary) {
        if (node.at.loop != l) continue;
        if (known.empty()) {
          fresh.push_back(node.at);
          fresh_nodes.push_back(node.node);
        } else {
          out.boundary.emplace_back(node.node, nearest(known, mesh.mesh.nodes[node.node]));
        }
      }
    }
    const auto ids = nodes_.place_from_face(face, region, fresh);
    for (size_t i = 0; i < ids.size(); ++i) out.boundary.emplace_back(fresh_nodes[i], ids[i]);
    out.crest_lines = std::move(mesh.crest_lines);
    out.cap_elements = std::move(mesh.cap_elements);
    out.block_lines = std::move(mesh.block_lines);
    out_.meshing[b].blocks = mesh.blocks;
    out_.meshing[b].method = mesh.method;
    out_.meshing[b].elements = int(mesh.mesh.elements.size());
    out_.meshing[b].notes = std::move(mesh.notes);
    out_.meshing[b].elements_across = mesh.elements_across;
    for (const std::string& refusal : mesh.refusals) {
      out_.meshing[b].notes.push_back(refusal);
      out_.table.diagnostics.push_back(
          {"mesh.bead.control", Severity::warning, panel_.faces[face].number,
           studied_.table.beads[b].listed ? "bead " + std::to_string(studied_.table.beads[b].id) : "",
           refusal, ""});
    }
    out.mesh = std::move(mesh.mesh);
    face_meshes_[face] = std::move(out);
  }

  static Index nearest(const std::vector<LoopNode>& nodes, Vec2 p) {
    const auto best = std::min_element(nodes.begin(), nodes.end(), [&](const LoopNode& a, const LoopNode& b) {
      return squared_norm(a.flat - p) < squared_norm(b.flat - p);
    });
    return best->id;
  }

  // ---------------------------------------------------------------- the rest

  /// Closed chains around holes, with what a washer is wide there.
  void choose_washers() {
    washer_widths_.assign(chains_.chains.size(), 0.0);
    for (Index face = 0; face < Index(panel_.faces.size()); ++face) {
      if (face_meshes_[face] || bead_of_face_[face] != no_index) continue;
      for (size_t l = 1; l < chains_.loops[face].size(); ++l) {
        const auto& uses = chains_.loops[face][l];
        const Chain& chain = chains_.chains[uses[0].chain];
        const bool is_free = chain.faces[0] == no_index || chain.faces[1] == no_index;
        if (uses.size() != 1 || !chain.closed || !is_free || nodes_.is_set(uses[0].chain)) continue;
        washer_widths_[uses[0].chain] =
            washer_width(options_.washers, chain.length() / pi, size_of_face(face), inner_min_edge_)
                .value_or(0);
      }
    }
  }

  void place_remaining_chains() {
    choose_washers();
    std::vector<int> counts;
    std::vector<bool> free_faces;
    for (size_t c = 0; c < chains_.chains.size(); ++c)
      counts.push_back(nodes_.is_set(Index(c)) ? nodes_.count(Index(c)) : 0);
    const std::vector<int> before = counts;
    const auto around = options_.washers.elements_around;
    for (size_t c = 0; c < counts.size(); ++c)
      if (around && washer_widths_[c] > 0 && chains_.chains[c].length() / *around > 1.04 * inner_min_edge_)
        counts[c] = *around;
    for (const auto& mesh : face_meshes_) free_faces.push_back(!mesh.has_value());
    ChainCountOptions options{options_.size, inner_min_edge_, {}, {}};
    // Counted in the middle of the first row.
    for (const double width : washer_widths_) options.longer.push_back(pi * width);
    if (!field_.is_uniform())
      for (const Chain& chain : chains_.chains) options.sizing.push_back(field_.along(panel_, chain));
    assign_chain_counts(chains_, free_faces, counts, options);
    for (size_t c = 0; c < counts.size(); ++c) {
      if (before[c]) continue;
      if (field_.is_uniform())
        nodes_.place_evenly(Index(c), counts[c]);
      else
        nodes_.place_at(Index(c), options.sizing[c].stations(counts[c]));
    }
  }

  void mesh_faces() {
    std::vector<std::string> reasons(panel_.faces.size());
    std::atomic<int> done = 0;
    std::vector<size_t> facets;
    for (size_t f = 0; f < panel_.faces.size(); ++f) facets.push_back(facet_count(Index(f)));
    largest_first(facets, [&](size_t f) {
      if (!face_meshes_[f] && studied_.studies[f] && !context_.is_cancelled())
        reasons[f] = mesh_one_face(Index(f));
      context_.report("sheet", double(++done) / double(panel_.faces.size()));
    });
    for (size_t f = 0; f < reasons.size(); ++f) {
      if (!reasons[f].empty())
        out_.table.diagnostics.push_back({"mesh.face.failed", Severity::error, panel_.faces[f].number, "",
                                          reasons[f], "the face is missing in the mesh"});
      if (bead_of_face_[f] != no_index && out_.meshing[bead_of_face_[f]].method.empty())
        note_fallback(bead_of_face_[f], face_meshes_[f] ? int(face_meshes_[f]->mesh.elements.size()) : 0);
    }
  }

  void note_fallback(Index b, int elements) {
    BeadMeshing& meshing = out_.meshing[b];
    meshing.elements = elements;
    if (controls_[b].method == BeadMethod::face) {
      meshing.method = "face";
      return;
    }
    meshing.method = "fallback";
    if (!studied_.table.beads[b].listed) return;
    std::string why;
    for (const std::string& note : meshing.notes) why += (why.empty() ? "" : "; ") + note;
    out_.table.diagnostics.push_back(
        {"mesh.bead.fallback", Severity::warning, panel_.faces[face_of(b)].number,
         "bead " + std::to_string(studied_.table.beads[b].id), "meshed as an ordinary face: " + why, ""});
  }

  double size_of_face(Index face) const {
    const Index b = bead_of_face_[face];
    return b == no_index ? field_.of_face(panel_.faces[face].facets) : out_.meshing[b].size;
  }

  std::vector<Washer> washers_of(Index face) const {
    std::vector<Washer> out;
    for (Index l = 1; l < Index(chains_.loops[face].size()); ++l)
      if (const double width = washer_widths_[chains_.loops[face][l][0].chain]; width > 0)
        out.push_back({l, options_.washers.rows, width});
    return out;
  }

  /// Empty where it went well, else the reason.
  std::string mesh_one_face(Index face) {
    const FaceStudy& study = *studied_.studies[face];
    NodeLoops loops;
    FaceMesh out;
    for (Index l = 0; l < Index(study.region.loops.size()); ++l) {
      const auto nodes = nodes_.nodes_of_loop(face, l, study.region);
      if (nodes.size() < 3) return "a boundary loop has no room for three nodes";
      loops.loops.emplace_back();
      for (const LoopNode& node : nodes) {
        const Index local = Index(loops.nodes.size());
        loops.nodes.push_back(node.flat);
        loops.loops.back().push_back(local);
        out.boundary.emplace_back(local, node.id);
      }
    }
    auto mesh = mesh_face(loops, *study.map, {size_of_face(face), inner_min_edge_, washers_of(face)});
    if (!mesh) return mesh.error().message;
    out.mesh = std::move(*mesh);
    face_meshes_[face] = std::move(out);
    return {};
  }

  // ---------------------------------------------------------------- the whole

  void assemble() {
    ShellMesh& shell = out_.mesh;
    shell.title = panel_.input;
    std::vector<Index> used(nodes_.points().size(), no_index);
    for (size_t f = 0; f < face_meshes_.size(); ++f)
      if (face_meshes_[f]) add_face(Index(f), used);
    for (BeadSet& set : shell.beads) {
      std::sort(set.crest_nodes.begin(), set.crest_nodes.end());
      set.crest_nodes.erase(std::unique(set.crest_nodes.begin(), set.crest_nodes.end()),
                            set.crest_nodes.end());
    }
    std::vector<MeshElement> elements;
    for (const ShellElement& element : shell.elements) elements.push_back(element.nodes);
    out_.quality = summarise(shell.nodes, elements, options_.min_edge);
    judge_all(elements);
  }

  void judge_all(const std::vector<MeshElement>& elements) {
    std::vector<ElementGroup> parts, beads;
    for (const ShellPart& part : out_.mesh.parts) parts.push_back({part.name, {}});
    for (Index e = 0; e < Index(elements.size()); ++e)
      parts[out_.mesh.elements[e].part].elements.push_back(e);
    for (const BeadSet& set : out_.mesh.beads)
      beads.push_back({"bead " + std::to_string(set.bead), set.elements});
    out_.judged =
        judge(out_.mesh.nodes, elements,
              options_.criteria.value_or(criteria_of_sizes(options_.size, options_.min_edge)), parts, beads);
  }

  Index listed_bead(Index face) const {
    const Index b = bead_of_face_[face];
    return b != no_index && studied_.table.beads[b].listed ? b : no_index;
  }

  /// What is only meshed like a bead is sheet to everybody else.
  void drop_unlisted() {
    size_t kept = 0;
    for (size_t b = 0; b < out_.table.beads.size(); ++b) {
      if (!out_.table.beads[b].listed) continue;
      if (kept != b) {
        out_.table.beads[kept] = std::move(out_.table.beads[b]);
        out_.table.medials[kept] = std::move(out_.table.medials[b]);
        out_.meshing[kept] = std::move(out_.meshing[b]);
      }
      ++kept;
    }
    out_.table.beads.resize(kept);
    out_.table.medials.resize(kept);
    out_.meshing.resize(kept);
  }

  void add_face(Index face, std::vector<Index>& used) {
    const FaceMesh& mesh = *face_meshes_[face];
    ShellMesh& shell = out_.mesh;
    std::vector<Index> global(mesh.mesh.nodes.size(), no_index);
    for (const auto& [local, id] : mesh.boundary) {
      if (used[id] == no_index) {
        used[id] = Index(shell.nodes.size());
        shell.nodes.push_back(nodes_.points()[id]);
      }
      global[local] = used[id];
    }
    const SurfaceMap& map = *studied_.studies[face]->map;
    Index hint = no_index;
    for (size_t n = 0; n < global.size(); ++n) {
      if (global[n] != no_index) continue;
      const FacetPoint at = map.locate(mesh.mesh.nodes[n], hint);
      hint = at.triangle;
      global[n] = Index(shell.nodes.size());
      shell.nodes.push_back(map.surface_point(at));
    }
    const Index b = listed_bead(face);
    const Index part = part_of(face, b);
    const Index first = Index(shell.elements.size());
    for (MeshElement element : mesh.mesh.elements) {
      turn_to_surface(element, mesh.mesh, map);
      for (Index& n : element)
        if (n != no_index) n = global[n];
      shell.elements.push_back(
          {element, part, panel_.faces[face].number, b == no_index ? 0 : studied_.table.beads[b].id});
    }
    if (b != no_index) add_set(b, mesh, global, first);
    if (b != no_index) add_block_lines(b, mesh, global);
  }

  /// A quad starts at the corner whose diagonal lies nearer to the surface: programs that split quads along
  /// it then see the better triangles. A plain quad stays as it is.
  void turn_to_surface(MeshElement& quad, const PlanarMesh& mesh, const SurfaceMap& map) const {
    if (!is_quad(quad)) return;
    Vec2 centre;
    Vec3 corner[4];
    FacetPoint at;
    for (int i = 0; i < 4; ++i) {
      centre += mesh.nodes[quad[i]] / 4;
      at = map.locate(mesh.nodes[quad[i]], at.triangle);
      corner[i] = map.facet_point(at);
    }
    const Vec3 middle = map.facet_point(map.locate(centre, at.triangle));
    const double first = distance(middle, (corner[0] + corner[2]) / 2),
                 second = distance(middle, (corner[1] + corner[3]) / 2);
    if (second < first - 1e-3 * options_.size) std::rotate(quad.begin(), quad.begin() + 1, quad.end());
  }

  void add_set(Index b, const FaceMesh& mesh, const std::vector<Index>& global, Index first) {
    const Bead& bead = studied_.table.beads[b];
    BeadSet set{bead.id, name_of(bead.kind), bead.shape, {}, {}};
    for (Index e = first; e < Index(out_.mesh.elements.size()); ++e) set.elements.push_back(e);
    for (const auto& line : mesh.crest_lines) {
      set.crest_lines.emplace_back();
      for (Index n : line) set.crest_lines.back().push_back(global[n]);
      set.crest_nodes.insert(set.crest_nodes.end(), set.crest_lines.back().begin(),
                             set.crest_lines.back().end());
    }
    for (Index e : mesh.cap_elements) set.cap_elements.push_back(first + e);
    set.boundary_nodes = boundary_nodes(out_.mesh, set.elements);
    out_.mesh.beads.push_back(std::move(set));
  }

  void add_block_lines(Index b, const FaceMesh& mesh, const std::vector<Index>& global) {
    for (const BlockLine& line : mesh.block_lines) {
      BlockSideLine side{line.kind, {}};
      for (const Index n : line.nodes) side.points.push_back(out_.mesh.nodes[global[n]]);
      out_.meshing[b].block_lines.push_back(std::move(side));
    }
  }

  /// One property for each part, kind of region and thickness, made when first needed.
  Index part_of(Index face, Index b) {
    const PanelFace& of = panel_.faces[face];
    const PanelPart* part = of.part == no_index ? nullptr : &panel_.parts[of.part];
    std::string name = b == no_index ? "sheet" : "bead_" + name_of(studied_.table.beads[b].kind);
    if (part && panel_.parts.size() > 1)
      name = (part->name.empty() ? "part " + std::to_string(of.part + 1) : part->name) + " " + name;
    // What is measured differs by less than matters from face to face.
    const double thickness =
        of.thickness > 0 ? std::max(0.01, std::round(100 * of.thickness) / 100) : options_.thickness;
    auto& parts = out_.mesh.parts;
    for (size_t p = 0; p < parts.size(); ++p)
      if (parts[p].name == name && parts[p].thickness == thickness) return Index(p);
    parts.push_back({free_property_id(b == no_index && part ? part->id : 0), name, thickness});
    return Index(parts.size()) - 1;
  }

  /// The one asked for, where it is free; else the first above all that there are.
  Index free_property_id(Index wanted) const {
    Index last = 0;
    bool is_free = wanted > 0;
    for (const PanelPart& part : panel_.parts) last = std::max(last, part.id);
    for (const ShellPart& part : out_.mesh.parts) {
      last = std::max(last, part.id);
      is_free = is_free && part.id != wanted;
    }
    return is_free ? wanted : last + 1;
  }

  const Panel& panel_;
  const StudiedPanel& studied_;
  PanelMesherOptions options_;
  std::vector<BeadMeshControl> controls_;  ///< per bead
  const Context& context_;
  double inner_min_edge_;
  SizeField field_;
  ChainSet chains_;
  ChainNodes nodes_;
  std::vector<int> ring_counts_;       ///< per chain: elements along loops of rings, 0 for others
  std::vector<double> washer_widths_;  ///< per chain; 0: no hole with a washer
  std::vector<std::optional<FaceMesh>> face_meshes_;
  std::vector<Index> bead_of_face_;
  PanelMesh out_;
};

}  // namespace

Result<PanelMesh> mesh_studied_panel(const Panel& panel, const StudiedPanel& studied,
                                     const PanelMesherOptions& options, const Context& context) {
  auto controls = controls_of_beads(options.controls, panel, studied.table, options.size, options.min_edge);
  if (!controls) return tl::unexpected(controls.error());
  if (auto good = check_local_sizes(options.local_sizes, options.min_edge); !good)
    return tl::unexpected(good.error());
  if (auto good = check_washers(options.washers); !good) return tl::unexpected(good.error());
  return PanelMesher(panel, studied, options, std::move(*controls), context).run();
}

}  // namespace beadmesh
