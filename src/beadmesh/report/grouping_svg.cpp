#include "beadmesh/report/grouping_svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "beadmesh/report/drawing.h"
#include "beadmesh/report/picture_view.h"
#include "beadmesh/report/svg_text.h"

namespace beadmesh {
namespace {

using namespace drawing;

constexpr double margin = 24, header = 104, widest = 1400, tallest = 1100, line_height = 19;

/// What a face became; the order of painting.
enum Role { plain, joined, left, one_face, bead_I, bead_generic, bead_annular, role_count };

struct RoleStyle {
  Color color;
  const char* name;
};

constexpr RoleStyle styles[role_count] = {{{238, 240, 242}, "face by itself"},
                                          {{205, 222, 238}, "sheet joined to one face"},
                                          {{222, 110, 60}, "looked at, left apart"},
                                          {{204, 121, 167}, "one face, no bead"},
                                          {{86, 160, 211}, "I bead"},
                                          {{240, 173, 40}, "generic bead"},
                                          {{46, 178, 140}, "annular bead"}};

Role role_of(BeadKind kind) {
  return kind == BeadKind::I ? bead_I : kind == BeadKind::generic ? bead_generic : bead_annular;
}

PictureView view_of(const Panel& panel) {
  Vec3 sum;
  double whole = 0;
  for (const PanelFace& face : panel.faces) sum += vector_area(face.facets), whole += area(face.facets);
  return view_of_area(sum, whole);
}

class Picture : drawing::SvgText {
 public:
  Picture(const Panel& input, const Panel& composed, const BeadTable& table,
          const std::vector<GroupDecision>& decisions)
      : input_(input),
        composed_(composed),
        table_(table),
        decisions_(decisions),
        view_(view_of(input)),
        frame_(flat_points(), {margin, header}, widest, tallest),
        roles_(input.faces.size(), plain) {
    for (const RejectedFace& face : table.faces_not_beads) words_[face.face] = "no bead: " + face.reason;
    take_decisions();
    take_beads();
  }

  std::string text() {
    const double below = header + frame_.height() + 40, height = below + line_height * (listed_ + 1) + margin;
    put(R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {0:.0f} {1:.0f}" width="{0:.0f}" )"
        R"(height="{1:.0f}" font-family="Helvetica,Arial,sans-serif">)"
        "\n<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n",
        std::max(frame_.width(), 900.0) + 2 * margin, height);
    draw_heading();
    draw_faces();
    draw_labels();
    draw_list(below);
    put("</svg>\n");
    return written();
  }

 private:
  std::vector<Vec2> flat_points() const {
    std::vector<Vec2> flat;
    for (const PanelEdge& edge : input_.edges)
      for (const Index p : edge.points) flat.push_back(view_(input_.points[p]));
    return flat;
  }

  void take_decisions() {
    for (const GroupDecision& decision : decisions_) {
      if (decision.verdict != GroupVerdict::sheet) ++listed_;
      const Role role = decision.verdict == GroupVerdict::sheet  ? joined
                        : decision.verdict == GroupVerdict::left ? left
                                                                 : one_face;
      for (const Index f : decision.faces) roles_[f] = std::max(roles_[f], role);
    }
  }

  void take_beads() {
    std::map<Index, Index> face_of_number;
    for (Index f = 0; f < Index(input_.faces.size()); ++f) face_of_number[input_.faces[f].number] = f;
    for (const Bead& bead : table_.beads) {
      if (!bead.listed) continue;
      for (const Index number : input_numbers(composed_, bead.faces)) {
        words_[number] = fmt::format("bead {}, {} {}", bead.id, name_of(bead.kind), bead.shape);
        if (const auto f = face_of_number.find(number); f != face_of_number.end())
          roles_[f->second] = role_of(bead.kind);
      }
    }
  }

  void draw_heading() {
    put("<text x=\"{}\" y=\"36\" font-size=\"22\" font-weight=\"bold\" fill=\"#1b1f24\">{}: how its faces "
        "were "
        "grouped</text>\n",
        margin, escaped(input_.input.empty() ? "Panel" : input_.input));
    put("<text x=\"{}\" y=\"60\" font-size=\"15\" fill=\"#57606a\">{} faces of the input, {} after grouping, "
        "{} "
        "groups looked at; the numbers are those of the list below</text>\n",
        margin, input_.faces.size(), composed_.faces.size(), listed_);
    double x = margin;
    for (int role = 0; role < role_count; ++role) {
      if (!std::count(roles_.begin(), roles_.end(), role)) continue;
      put("<rect x=\"{:.0f}\" y=\"74\" width=\"18\" height=\"14\" fill=\"{}\" stroke=\"#6e7781\" "
          "stroke-width=\".6\"/><text x=\"{:.0f}\" y=\"86\" font-size=\"14\" fill=\"#1b1f24\">{}</text>\n",
          x, hex(styles[role].color), x + 24, styles[role].name);
      x += 56 + 7.2 * std::string_view(styles[role].name).size();
    }
  }

  /// Large faces first, so that what stands upright on them is seen.
  void draw_faces() {
    std::vector<std::pair<double, Index>> order;
    for (Index f = 0; f < Index(input_.faces.size()); ++f)
      order.emplace_back(-area(input_.faces[f].facets), f);
    std::sort(order.begin(), order.end());
    put("<g id=\"faces\" stroke=\"#57606a\" stroke-width=\"60\" stroke-linejoin=\"round\" "
        "fill-rule=\"evenodd\">\n");
    for (const auto& [size, f] : order) {
      const PanelFace& face = input_.faces[f];
      Path path;
      for (const auto& loop : face.facets.loops) {
        std::vector<Vec2> line;
        for (const Index v : loop) line.push_back(frame_(view_(face.facets.points[v])));
        path.polyline(thinned(line, 0.1), true);
      }
      const auto words = words_.find(face.number);
      put("<path transform=\"scale(.01)\" fill=\"{}\" d=\"{}\"><title>face {}{}</title></path>\n",
          hex(styles[roles_[f]].color), path.text(), face.number,
          words == words_.end() ? "" : ": " + escaped(words->second));
    }
    put("</g>\n");
  }

  /// In the middle of the group's largest face.
  void draw_labels() {
    put("<g id=\"labels\" font-size=\"13\" font-weight=\"bold\" text-anchor=\"middle\" fill=\"#14191f\" "
        "stroke=\"#ffffff\" stroke-width=\"3.5\" stroke-linejoin=\"round\" paint-order=\"stroke\">\n");
    int number = 0;
    for (const GroupDecision& decision : decisions_) {
      if (decision.verdict == GroupVerdict::sheet) continue;
      const Index largest = *std::max_element(
          decision.faces.begin(), decision.faces.end(),
          [&](Index a, Index b) { return area(input_.faces[a].facets) < area(input_.faces[b].facets); });
      const Facets& facets = input_.faces[largest].facets;
      const Triangle t = facets.triangles[facets.triangles.size() / 2];
      const Vec2 at = frame_(view_((facets.points[t[0]] + facets.points[t[1]] + facets.points[t[2]]) / 3.0));
      put("<text x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n", at.x, at.y + 4.5, ++number);
    }
    put("</g>\n");
  }

  void draw_list(double y) {
    put("<g id=\"decisions\" font-size=\"14\" fill=\"#1b1f24\">\n");
    int number = 0;
    for (const GroupDecision& decision : decisions_) {
      if (decision.verdict == GroupVerdict::sheet) continue;
      put("<text x=\"{}\" y=\"{:.0f}\">{}: {}</text>\n", margin, y + line_height * number, number + 1,
          escaped(sentence_of(decision)));
      ++number;
    }
    put("</g>\n");
  }

  std::string sentence_of(const GroupDecision& decision) const {
    constexpr size_t most = 8;
    std::string faces;
    for (size_t i = 0; i < std::min(most, decision.faces.size()); ++i)
      faces += (i == 0 ? "" : ", ") + std::to_string(input_.faces[decision.faces[i]].number);
    if (decision.faces.size() > most) faces += fmt::format(", ... ({} in all)", decision.faces.size());
    std::string verdict = decision.verdict == GroupVerdict::one_face ? "one face, no bead" : "left apart";
    if (decision.verdict == GroupVerdict::bead) {
      const auto words = words_.find(input_.faces[decision.faces.front()].number);
      verdict = words == words_.end() ? "bead" : words->second;
    }
    return fmt::format("{}; {}; faces {}", verdict, decision.reason, faces);
  }

  const Panel& input_;
  const Panel& composed_;
  const BeadTable& table_;
  const std::vector<GroupDecision>& decisions_;
  PictureView view_;
  Frame frame_;
  std::vector<Role> roles_;             ///< per face of the input
  std::map<Index, std::string> words_;  ///< per number of a face
  int listed_ = 0;
};

}  // namespace

std::string grouping_svg(const Panel& input, const Panel& composed, const BeadTable& table,
                         const std::vector<GroupDecision>& decisions) {
  return Picture(input, composed, table, decisions).text();
}

}  // namespace beadmesh
