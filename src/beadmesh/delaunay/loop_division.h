// A loop whose segments are divided by sizes that vary along it. Internal to this room.
#pragma once

#include <algorithm>
#include <vector>

#include "beadmesh/delaunay/boundary_sampling.h"

namespace beadmesh::delaunay {

/// Keeps a greatest length ("size") for every segment, and divides the loop's given segments by it.
class LoopDivision {
 public:
  /// No limit makes a segment shorter than `least`.
  LoopDivision(const PlanarLoop& loop, Index number, const SamplingOptions& options, double least);

  const std::vector<BoundarySample>& samples() const { return samples_; }
  std::size_t size() const { return samples_.size(); }
  double length() const { return length_; }
  double segment_length(std::size_t i) const { return end_of(i) - samples_[i].position; }
  /// The segment from sample i shall be no longer than `size`.
  void limit(std::size_t i, double size) {
    if (size < size_[i]) size_[i] = std::min(size_[i], std::max(size, least_));
  }
  /// The smooth piece between two corners that segment i is on, and the number of pieces.
  Index piece(std::size_t i) const { return given_[given_of_[i]].piece; }
  Index pieces() const { return pieces_; }
  /// Limits segments that are too long beside their neighbours; false where there is none.
  bool limit_by_neighbours();
  /// Smoothes the sizes along the loop. Returns the number of samples that divide() will make at most.
  double prepare();
  /// Divides by the sizes; true where the number of samples grew.
  bool divide();

 private:
  struct Given {  // a point of the loop and the segment that starts there
    Vec2 point;
    double position = 0, length = 0;
    bool corner = false;
    bool facet = false;  // the segment stands for a piece of a smooth curve
    Index curve = 0;
    Index piece = 0;
  };

  void read(const PlanarLoop& loop);
  void mark_facets(bool has_curves);
  void number_pieces();
  void start_undivided();
  double end_of(std::size_t i) const { return i + 1 < size() ? samples_[i + 1].position : length_; }
  std::size_t after(std::size_t i) const { return i + 1 < size() ? i + 1 : 0; }
  std::size_t before(std::size_t i) const { return i > 0 ? i - 1 : size() - 1; }
  const Given& given_after(std::size_t g) const { return given_[g + 1 < given_.size() ? g + 1 : 0]; }
  const Given& given_before(std::size_t g) const { return given_[g > 0 ? g - 1 : given_.size() - 1]; }
  void smooth_sizes();
  void share_sizes_at_corners();
  double pieces_wanted(double from, double to, std::size_t first, std::size_t end) const;
  void divide_segment(std::size_t g, std::size_t first, std::size_t end, std::vector<double>& cuts) const;
  void cut_evenly(double from, double to, std::size_t first, std::size_t end, double leniency,
                  std::vector<double>& cuts) const;

  Index number_;
  double grading_, growth_, least_, length_ = 0;
  std::vector<Given> given_;
  Index pieces_ = 1;
  std::vector<BoundarySample> samples_;
  std::vector<std::size_t> given_of_;  // per sample: the given segment that it is on
  std::vector<double> size_;           // per segment between samples
};

}  // namespace beadmesh::delaunay
