// What a verb writes: checked before the work begins, put in place together when it is done.
#pragma once

#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

#include "beadmesh/core/result.h"
#include "options.h"

namespace beadmesh::app {

/// All files asked for can be put in place: endings known, folders there and writable, no file twice, none of
/// them the input, at most one on standard output. Fails with usage.output and write.*.
Result<void> check_outputs(const Options& options);

class Outputs {
 public:
  using Writer = std::function<void(std::ostream&)>;

  /// Nothing where `name` is empty.
  void add(const std::string& name, Writer write);
  /// All files, or none: then the text for standard output.
  Result<void> put();
  /// Is standard output taken by data?
  bool uses_stdout() const { return stdout_ != nullptr; }
  /// Names of the files put, for the summary.
  const std::vector<std::string>& names() const { return names_; }

 private:
  std::vector<std::string> names_;
  std::vector<Writer> writers_;
  Writer stdout_;
};

}  // namespace beadmesh::app
