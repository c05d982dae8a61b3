#include "sim/meshing/cube_tree.h"

#include <algorithm>

namespace griffith {
namespace {

using Index3 = BccLattice::Index3;

/// Calls f for all cells from `low` to before `high`. Returns true if all calls do.
template <class F>
bool all_cells(const Index3& low, const Index3& high, const F& f) {
  for (int z = low[2]; z < high[2]; ++z)
    for (int y = low[1]; y < high[1]; ++y)
      for (int x = low[0]; x < high[0]; ++x)
        if (!f(Index3{x, y, z})) return false;
  return true;
}

Index3 plus(Index3 a, int b) {
  for (int& component : a) component += b;
  return a;
}

/// Returns the center of a cube in half edges; `width` in lattice cubes.
Index3 middle_of(const Index3& origin, int width) {
  return {2 * origin[0] + width, 2 * origin[1] + width, 2 * origin[2] + width};
}

/// Returns the first lattice cube of the aligned larger cube that contains `cell`.
Index3 aligned(Index3 cell, int width) {
  for (int& component : cell) component -= component % width;
  return cell;
}

}  // namespace

CubeTree::CubeTree(const BccLattice& lattice, const std::function<bool(int vertex)>& is_deep, int levels)
    : lattice_(lattice) {
  find_deep_cubes(is_deep);
  for (int level = 1; level <= levels; ++level) merge(level);
}

bool CubeTree::contains(const Index3& cell) const {
  const Index3 count = lattice_.cells();
  for (int axis = 0; axis < 3; ++axis)
    if (cell[axis] < 0 || cell[axis] >= count[axis]) return false;
  return true;
}

std::size_t CubeTree::index(const Index3& cell) const {
  const auto [nx, ny, nz] = lattice_.cells();
  return (static_cast<std::size_t>(cell[2]) * static_cast<std::size_t>(ny) + static_cast<std::size_t>(cell[1])) *
             static_cast<std::size_t>(nx) +
         static_cast<std::size_t>(cell[0]);
}

int CubeTree::level(const Index3& cell) const { return contains(cell) ? std::max(0, int(levels_[index(cell)])) : 0; }

void CubeTree::find_deep_cubes(const std::function<bool(int vertex)>& is_deep) {
  const auto [nx, ny, nz] = lattice_.cells();
  levels_.reserve(static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny) * static_cast<std::size_t>(nz));
  all_cells({0, 0, 0}, {nx, ny, nz}, [&](const Index3& cell) {
    const bool deep =
        is_deep(lattice_.vertex(middle_of(cell, 1))) && all_cells(cell, plus(cell, 2), [&](const Index3& corner) {
          return is_deep(lattice_.vertex({2 * corner[0], 2 * corner[1], 2 * corner[2]}));
        });
    levels_.push_back(deep ? 0 : -1);
    return true;
  });
}

/// True if the cubes in and around a block have at least that level.
bool CubeTree::surroundings_reach(const Index3& origin, int width, int level) const {
  return all_cells(plus(origin, -1), plus(origin, width + 1),
                   [&](const Index3& cell) { return contains(cell) && levels_[index(cell)] >= level; });
}

void CubeTree::merge(int level) {
  const int width = 1 << level;
  const auto [nx, ny, nz] = lattice_.cells();
  std::vector<Index3> merged;
  all_cells({0, 0, 0}, {nx / width, ny / width, nz / width}, [&](const Index3& block) {
    const Index3 origin = {width * block[0], width * block[1], width * block[2]};
    if (surroundings_reach(origin, width, level - 1)) merged.push_back(origin);
    return true;
  });
  for (const Index3& origin : merged)
    all_cells(origin, plus(origin, width), [&](const Index3& cell) {
      levels_[index(cell)] = static_cast<std::int8_t>(level);
      return true;
    });
}

void CubeTree::visit_tets(const Visit& visit) const {
  const auto [nx, ny, nz] = lattice_.cells();
  all_cells({0, 0, 0}, {nx, ny, nz}, [&](const Index3& cell) {
    if (aligned(cell, 1 << level(cell)) != cell) return true;  // not the first of its cube
    for (int axis = 0; axis < 3; ++axis)
      for (const int side : {-1, 1}) visit_face(cell, axis, side, visit);
    return true;
  });
}

/// Visits the tets at a face of a cube, unless they belong to the cube beyond it: one of the same level before it, or a
/// smaller one.
void CubeTree::visit_face(const Index3& origin, int axis, int side, const Visit& visit) const {
  const int own = level(origin), width = 1 << own;
  Index3 next = origin;
  next[axis] += side > 0 ? width : -1;
  const int other = level(next);
  if (other < own || (other == own && side < 0)) return;
  if (own == 0 && other == 0) {
    for (const auto& tet : lattice_.tets_at(origin, axis)) visit(tet);
    return;
  }
  const Index3 middle = middle_of(origin, width);
  Index3 face = middle;
  face[axis] += side * width;
  const std::vector<int> border = outline(face, axis, own);
  const auto count = static_cast<int>(border.size());
  const int a = lattice_.vertex(middle), b = lattice_.vertex(middle_of(aligned(next, 1 << other), 1 << other));
  if (other == own) {
    for (int i = 0; i < count; ++i) visit({a, b, border[i], border[(i + 1) % count]});
    return;
  }
  for (int i = 1; i + 1 < count; ++i)
    for (const int apex : {a, b}) visit({apex, border[0], border[i], border[i + 1]});
}

/// Returns the vertices around a face, including the midpoints of its edges where smaller cubes touch. The first one is
/// a midpoint if there is any, so that no three vertices from it are collinear.
std::vector<int> CubeTree::outline(const Index3& middle, int axis, int level) const {
  constexpr std::array<std::array<int, 2>, 8> kRound = {
      {{-1, -1}, {0, -1}, {1, -1}, {1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}}};
  const int half = 1 << level;
  std::vector<int> border;
  std::size_t first = 0;
  for (std::size_t i = 0; i < kRound.size(); ++i) {
    Index3 place = middle;
    place[(axis + 1) % 3] += half * kRound[i][0];
    place[(axis + 2) % 3] += half * kRound[i][1];
    const bool is_middle = i % 2 == 1;
    if (is_middle && !touches_smaller(place, level)) continue;
    if (is_middle) first = border.size();
    border.push_back(lattice_.vertex(place));
  }
  std::rotate(border.begin(), border.begin() + static_cast<std::ptrdiff_t>(first), border.end());
  return border;
}

/// True if a cube of a lower level has a corner at the midpoint of an edge.
bool CubeTree::touches_smaller(const Index3& place, int level) const {
  if (level == 0) return false;
  const Index3 cell = {place[0] / 2, place[1] / 2, place[2] / 2};
  return !all_cells(plus(cell, -1), plus(cell, 1), [&](const Index3& round) { return this->level(round) >= level; });
}

}  // namespace griffith
