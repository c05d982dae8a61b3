#pragma once

#include <array>
#include <span>

#include "sim/contact/hull.h"
#include "sim/contact/triple.h"
#include "sim/core/lanes.h"

namespace griffith::contact {

/// Vectors in lanes, one per lane.
struct Triples {
  simd::DoubleLanes x, y, z;
  void set(int lane, const Vec3& v) { x[lane] = v.x(), y[lane] = v.y(), z[lane] = v.z(); }
};
inline simd::DoubleLanes dot(const Triple& a, const Triples& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

/// Edges of a hull in lanes, four side by side. The last four are padded with copies of their first.
class EdgeLanes {
 public:
  static constexpr int kMost = 128;
  struct Four {
    Triples left, right, along;  ///< normals of the faces on both sides, unit vector from end to end
    std::array<int, simd::kDoubleLanes> edges;
  };

  explicit EdgeLanes(const Hull& hull) : hull_(hull) {}
  bool is_full() const { return count_ == kMost; }
  void clear() { count_ = 0; }
  void add(int index) {
    const int first = count_ % simd::kDoubleLanes;
    Four& four = fours_[count_++ / simd::kDoubleLanes];
    const Hull::Edge& edge = hull_.edges[index];
    for (int lane = first; lane < (first == 0 ? simd::kDoubleLanes : first + 1); ++lane) {
      four.left.set(lane, hull_.faces[edge.left].normal);
      four.right.set(lane, hull_.faces[edge.right].normal);
      four.along.set(lane, (hull_.corners[edge.to] - hull_.corners[edge.from]).normalized());
      four.edges[lane] = index;
    }
  }
  std::span<const Four> fours() const {
    return {fours_.data(), static_cast<std::size_t>((count_ + simd::kDoubleLanes - 1) / simd::kDoubleLanes)};
  }
  int count() const { return count_; }

 private:
  const Hull& hull_;
  std::array<Four, kMost / simd::kDoubleLanes> fours_;
  int count_ = 0;
};

}  // namespace griffith::contact
