// What `--debug-svg` needs: the panel as it was read, and what was decided about its faces.
#pragma once

#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "beadmesh/pipeline.h"
#include "beadmesh/report/grouping_svg.h"
#include "outputs.h"

namespace beadmesh::app {

class Grouping {
 public:
  /// Nothing is kept where `name` is empty.
  Grouping(std::string name, const Panel& read) : name_(std::move(name)) {
    if (!name_.empty()) read_ = read;
  }

  std::vector<GroupDecision>* decisions() { return name_.empty() ? nullptr : &decisions_; }

  /// All three must outlive the outputs.
  void add_to(Outputs& outputs, const Panel& composed, const BeadTable& table) const {
    outputs.add(name_, [&](std::ostream& out) { out << grouping_svg(read_, composed, table, decisions_); });
  }

 private:
  std::string name_;
  Panel read_;
  std::vector<GroupDecision> decisions_;
};

}  // namespace beadmesh::app
