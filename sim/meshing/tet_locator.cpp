#include "sim/meshing/tet_locator.h"

#include <algorithm>
#include <cmath>

#include "sim/mesh/topology.h"

namespace griffith {
namespace {

/// Returns the free faces of a soup and the tets behind them.
TriangleSurface free_faces(const TetSoup& soup, std::vector<int>& tet_of_triangle) {
  const TetMesh mesh = build_mesh(soup);
  TriangleSurface surface;
  surface.points = soup.points;
  for (const SurfaceFace& face : surface_faces(mesh)) {
    const auto [a, b, c] = face_nodes(mesh, face.tet, face.face);
    surface.triangles.push_back({a.index(), b.index(), c.index()});
    tet_of_triangle.push_back(face.tet.index());
  }
  return surface;
}

}  // namespace

TetLocator::TetLocator(const TetSoup& soup) : soup_(soup), surface_(free_faces(soup, tet_of_triangle_)) {
  for (const Vec3& point : soup.points) box_.extend(point);
  // About one cell per tet.
  const double edge = std::cbrt(box_.volume() / static_cast<double>(soup.tets.size()));
  for (int axis = 0; axis < 3; ++axis) size_[axis] = std::clamp(static_cast<int>(box_.sizes()[axis] / edge), 1, 512);
  cell_ = box_.sizes().cwiseQuotient(Vec3(size_[0], size_[1], size_[2]));
  fill_cells();
}

std::array<int, 3> TetLocator::cell_of(const Vec3& point) const {
  std::array<int, 3> cell;
  for (int axis = 0; axis < 3; ++axis) {
    const double place = (point[axis] - box_.min()[axis]) / cell_[axis];
    cell[axis] = static_cast<int>(std::clamp(place, 0.0, size_[axis] - 1.0));
  }
  return cell;
}

template <class Visit>
void TetLocator::for_each_cell_of(std::size_t tet, const Visit& visit) const {
  Eigen::AlignedBox3d box;
  for (const int corner : soup_.tets[tet]) box.extend(soup_.points[corner]);
  const auto low = cell_of(box.min()), high = cell_of(box.max());
  for (int z = low[2]; z <= high[2]; ++z)
    for (int y = low[1]; y <= high[1]; ++y)
      for (int x = low[0]; x <= high[0]; ++x) visit(flat({x, y, z}));
}

void TetLocator::fill_cells() {
  first_.assign(static_cast<std::size_t>(size_[0]) * size_[1] * size_[2] + 1, 0);
  for (std::size_t tet = 0; tet < soup_.tets.size(); ++tet)
    for_each_cell_of(tet, [&](int cell) { ++first_[cell + 1]; });
  for (std::size_t cell = 1; cell < first_.size(); ++cell) first_[cell] += first_[cell - 1];
  tets_.resize(first_.back());
  std::vector<int> next = first_;
  for (std::size_t tet = 0; tet < soup_.tets.size(); ++tet)
    for_each_cell_of(tet, [&](int cell) { tets_[next[cell]++] = static_cast<int>(tet); });
}

std::array<double, 4> TetLocator::weights_in(int tet, const Vec3& point) const {
  const auto& [a, b, c, d] = soup_.tets[tet];
  const Vec3 &pa = soup_.points[a], &pb = soup_.points[b], &pc = soup_.points[c], &pd = soup_.points[d];
  const double volume = signed_volume(pa, pb, pc, pd);
  const double wb = signed_volume(pa, point, pc, pd) / volume, wc = signed_volume(pa, pb, point, pd) / volume,
               wd = signed_volume(pa, pb, pc, point) / volume;
  return {1 - wb - wc - wd, wb, wc, wd};
}

EmbeddedPoint TetLocator::locate(const Vec3& point) const {
  EmbeddedPoint best;
  double best_depth = -1e-12;  // a point on a face is inside
  const int cell = flat(cell_of(point));
  for (int i = first_[cell]; i < first_[cell + 1]; ++i) {
    const auto weights = weights_in(tets_[i], point);
    const double depth = *std::min_element(weights.begin(), weights.end());
    if (depth > best_depth) best_depth = depth, best = {tets_[i], weights};
  }
  if (best.tet >= 0) return best;
  const int tet = tet_of_triangle_[surface_.nearest(point).triangle];
  return {tet, weights_in(tet, point)};
}

}  // namespace griffith
