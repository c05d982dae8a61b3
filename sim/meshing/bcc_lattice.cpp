#include "sim/meshing/bcc_lattice.h"

#include <cmath>
#include <string>

#include "sim/core/error.h"

namespace griffith {
namespace {

using Index3 = BccLattice::Index3;

/// Returns the position of `index` in a block of `size`, x fastest.
int flat(const Index3& index, const Index3& size) { return index[0] + size[0] * (index[1] + size[1] * index[2]); }

Index3 unflat(int position, const Index3& size) {
  return {position % size[0], position / size[0] % size[1], position / (size[0] * size[1])};
}

Index3 plus_one(const Index3& size) { return {size[0] + 1, size[1] + 1, size[2] + 1}; }

}  // namespace

BccLattice::BccLattice(const Eigen::AlignedBox3d& box, double cube_edge, const std::string& name) : edge_(cube_edge) {
  const Vec3 counts = (box.sizes() / cube_edge).array().ceil() + 2;
  if (!(counts.prod() <= kMaxCells))
    throw InputError(name, "would take more than 10 million cells", "use a larger element size");
  for (int axis = 0; axis < 3; ++axis) cells_[axis] = static_cast<int>(counts[axis]);
  origin_ = box.center() - cube_edge / 2 * counts;
  middle_count_ = cells_[0] * cells_[1] * cells_[2];
  corner_count_ = (cells_[0] + 1) * (cells_[1] + 1) * (cells_[2] + 1);
}

Index3 BccLattice::coordinates(int vertex) const {
  const bool corner = vertex < corner_count_;
  const Index3 at = corner ? unflat(vertex, plus_one(cells_)) : unflat(vertex - corner_count_, cells_);
  return {2 * at[0] + !corner, 2 * at[1] + !corner, 2 * at[2] + !corner};
}

int BccLattice::vertex(const Index3& coordinates) const {
  const bool corner = coordinates[0] % 2 == 0;
  Index3 at;
  for (int axis = 0; axis < 3; ++axis) {
    if (coordinates[axis] < 0 || coordinates[axis] > 2 * cells_[axis]) return -1;
    at[axis] = coordinates[axis] / 2;
  }
  return corner ? flat(at, plus_one(cells_)) : corner_count_ + flat(at, cells_);
}

Vec3 BccLattice::position(int vertex) const {
  const Index3 at = coordinates(vertex);
  return origin_ + edge_ / 2 * Vec3(at[0], at[1], at[2]);
}

const std::array<Index3, 14>& BccLattice::steps() {
  static constexpr std::array<Index3, 14> kSteps = {{{-2, 0, 0},
                                                     {2, 0, 0},
                                                     {0, -2, 0},
                                                     {0, 2, 0},
                                                     {0, 0, -2},
                                                     {0, 0, 2},
                                                     {-1, -1, -1},
                                                     {1, -1, -1},
                                                     {-1, 1, -1},
                                                     {1, 1, -1},
                                                     {-1, -1, 1},
                                                     {1, -1, 1},
                                                     {-1, 1, 1},
                                                     {1, 1, 1}}};
  return kSteps;
}

std::array<std::array<int, 4>, 4> BccLattice::tets_at(const Index3& cell, int axis) const {
  const Index3 middle = {2 * cell[0] + 1, 2 * cell[1] + 1, 2 * cell[2] + 1};
  Index3 next = middle;
  next[axis] += 2;
  // Corners around the face, from above: one half edge along the axis and one each way across it.
  constexpr std::array<std::array<int, 2>, 4> kRound = {{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
  std::array<int, 4> corners;
  for (int i = 0; i < 4; ++i) {
    Index3 at = middle;
    at[axis] += 1;
    at[(axis + 1) % 3] += kRound[i][0];
    at[(axis + 2) % 3] += kRound[i][1];
    corners[i] = vertex(at);
  }
  std::array<std::array<int, 4>, 4> tets;
  for (int i = 0; i < 4; ++i) tets[i] = {vertex(middle), vertex(next), corners[i], corners[(i + 1) % 4]};
  return tets;
}

}  // namespace griffith
