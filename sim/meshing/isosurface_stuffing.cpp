#include "sim/meshing/isosurface_stuffing.h"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <utility>
#include <vector>

#include "sim/core/parallel.h"
#include "sim/mesh/topology.h"
#include "sim/meshing/bcc_lattice.h"
#include "sim/meshing/cube_tree.h"

namespace griffith {
namespace {

/// A vertex moves onto a cut nearer than this fraction of the edge: the safe choice for curved borders in their
/// section 3.
constexpr double kLongEdgeFraction = 0.24999, kShortEdgeFraction = 0.41189;

/// Crossing of the border and an edge of the lattice.
struct Cut {
  int inner = 0, outer = 0;  ///< vertices
  double fraction = 0;       ///< fraction of the edge, from `inner`
  Vec3 place = Vec3::Zero();
  bool alive = true;  ///< false after one of its vertices moved onto the border
  int point = -1;     ///< index in the soup
};

/// Lattice with its cuts by the border.
class Stuffing {
 public:
  Stuffing(const ImplicitSolid& solid, const BccLattice& lattice, int levels, const Monitor& monitor)
      : solid_(solid), lattice_(lattice), levels_(levels), monitor_(monitor) {}

  TetSoup run() {
    monitor_.enter("Finding the inside");
    find_signs();
    monitor_.enter("Finding the border");
    find_cuts();
    move_vertices();
    monitor_.enter("Filling with tetrahedra");
    fill();
    return std::move(soup_);
  }

 private:
  void find_signs();
  void find_cuts();
  void move_vertices();
  void fill();
  void fill_tet(const std::array<int, 4>& tet);

  Cut* nearest_too_close(int vertex);
  bool diagonal_from_first(int a, int b, int outer) const;
  int point(int vertex);
  int cut_point(int inner, int outer);
  Cut& cut_between(int inner, int outer);
  void add_tet(int a, int b, int c, int d);
  void add_pyramid(int apex, const std::array<int, 4>& quad, bool diagonal_from_start);
  void add_prism(const std::array<int, 3>& top, const std::array<int, 3>& bottom, const std::array<bool, 3>& diagonal);
  void add_truncated_corner(const std::array<int, 4>& inner, int outer);
  void add_wedge(int a, int b, int outer1, int outer2);

  const ImplicitSolid& solid_;
  const BccLattice& lattice_;
  int levels_;
  const Monitor& monitor_;
  std::vector<std::int8_t> signs_;            ///< per vertex: 1 inside, 0 on the border, −1 outside
  std::vector<Cut> cuts_;                     ///< cuts by inner vertex
  std::vector<int> first_cut_;                ///< per vertex: its first cut as the inner one; one more at the end
  std::vector<std::vector<int>> outer_cuts_;  ///< per vertex: its cuts as outer vertex
  std::vector<int> points_;                   ///< per vertex: its point in the soup, -1 while it has none
  std::vector<std::pair<int, Vec3>> moved_;   ///< vertices with their new positions, ascending
  TetSoup soup_;
};

void Stuffing::find_signs() {
  signs_.resize(lattice_.vertex_count());
  std::atomic<bool> cancelled = false;  // only decides about an early end
  parallel_for(lattice_.vertex_count(), 256, [&](int begin, int end) {
    if (cancelled || monitor_.is_cancelled()) {
      cancelled = true;
      return;
    }
    for (int vertex = begin; vertex < end; ++vertex) signs_[vertex] = solid_.inside(lattice_.position(vertex)) ? 1 : -1;
  });
  if (cancelled) throw Cancelled();
}

void Stuffing::find_cuts() {
  outer_cuts_.resize(lattice_.vertex_count());
  for (int vertex = 0; vertex < lattice_.vertex_count(); ++vertex) {
    first_cut_.push_back(static_cast<int>(cuts_.size()));
    if (signs_[vertex] < 0) continue;
    const BccLattice::Index3 at = lattice_.coordinates(vertex);
    for (const auto& step : BccLattice::steps()) {
      const int other = lattice_.vertex({at[0] + step[0], at[1] + step[1], at[2] + step[2]});
      if (other < 0 || signs_[other] > 0) continue;
      outer_cuts_[other].push_back(static_cast<int>(cuts_.size()));
      cuts_.push_back({.inner = vertex, .outer = other});
    }
  }
  first_cut_.push_back(static_cast<int>(cuts_.size()));
  parallel_for(static_cast<int>(cuts_.size()), 64, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) {
      Cut& cut = cuts_[i];
      const Vec3 inner = lattice_.position(cut.inner), outer = lattice_.position(cut.outer);
      cut.fraction = std::clamp(solid_.crossing(inner, outer), 0.0, 1.0);
      cut.place = inner + cut.fraction * (outer - inner);
    }
  });
}

/// Returns the cut nearest to a vertex relative to its permitted distance, if it is closer than that.
Cut* Stuffing::nearest_too_close(int vertex) {
  Cut* nearest = nullptr;
  double minimum = 1;
  const auto consider = [&](Cut& cut) {
    const double fraction = cut.inner == vertex ? cut.fraction : 1 - cut.fraction;
    const double relative =
        fraction / (lattice_.is_long(cut.inner, cut.outer) ? kLongEdgeFraction : kShortEdgeFraction);
    if (cut.alive && relative < minimum) minimum = relative, nearest = &cut;
  };
  for (int i = first_cut_[vertex]; i < first_cut_[vertex + 1]; ++i) consider(cuts_[i]);
  for (const int i : outer_cuts_[vertex]) consider(cuts_[i]);
  return nearest;
}

void Stuffing::move_vertices() {
  for (int vertex = 0; vertex < lattice_.vertex_count(); ++vertex) {
    const Cut* nearest = nearest_too_close(vertex);
    if (nearest == nullptr) continue;
    moved_.emplace_back(vertex, nearest->place);
    signs_[vertex] = 0;
    for (int i = first_cut_[vertex]; i < first_cut_[vertex + 1]; ++i) cuts_[i].alive = false;
    for (const int i : outer_cuts_[vertex]) cuts_[i].alive = false;
  }
}

void Stuffing::fill() {
  points_.assign(lattice_.vertex_count(), -1);
  if (levels_ > 0) {
    const CubeTree tree(
        lattice_, [this](int vertex) { return signs_[vertex] > 0; }, levels_);
    return tree.visit_tets([this](const std::array<int, 4>& tet) { fill_tet(tet); });
  }
  const auto [nx, ny, nz] = lattice_.cells();
  for (int z = 0; z < nz; ++z) {
    if (monitor_.is_cancelled()) throw Cancelled();
    for (int y = 0; y < ny; ++y)
      for (int x = 0; x < nx; ++x)
        for (int axis = 0; axis < 3; ++axis)
          for (const auto& tet : lattice_.tets_at({x, y, z}, axis)) fill_tet(tet);
  }
}

void Stuffing::fill_tet(const std::array<int, 4>& tet) {
  std::array<int, 4> inner, border, outer;
  int inner_count = 0, border_count = 0, outer_count = 0;
  for (const int vertex : tet) {
    if (vertex < 0) return;  // beyond the last cubes, where everything is outside
    if (signs_[vertex] > 0) inner[inner_count++] = vertex;
    if (signs_[vertex] == 0) border[border_count++] = vertex;
    if (signs_[vertex] < 0) outer[outer_count++] = vertex;
  }
  if (inner_count == 0) return;
  if (outer_count == 0) return add_tet(point(tet[0]), point(tet[1]), point(tet[2]), point(tet[3]));
  if (inner_count == 1) {
    std::array<int, 4> corners = {point(inner[0])};
    for (int i = 0; i < border_count; ++i) corners[1 + i] = point(border[i]);
    for (int i = 0; i < outer_count; ++i) corners[1 + border_count + i] = cut_point(inner[0], outer[i]);
    return add_tet(corners[0], corners[1], corners[2], corners[3]);
  }
  if (inner_count == 3) return add_truncated_corner(inner, outer[0]);
  if (outer_count == 2) return add_wedge(inner[0], inner[1], outer[0], outer[1]);
  const auto [a, b] = std::pair(inner[0], inner[1]);
  add_pyramid(point(border[0]), {point(a), point(b), cut_point(b, outer[0]), cut_point(a, outer[0])},
              diagonal_from_first(a, b, outer[0]));
}

/// True if the rest of the face (a, b, outer), a quadrilateral, is split by the diagonal from a to the cut on b's edge;
/// false if by the one from b to the cut on a's. If one cut edge is long, the diagonal ends at its cut; if neither is,
/// the vertex with the even place in the row of the lattice decides (their parity rule). Both tets at the face agree.
bool Stuffing::diagonal_from_first(int a, int b, int outer) const {
  if (lattice_.is_long(a, outer)) return false;
  if (lattice_.is_long(b, outer)) return true;
  const BccLattice::Index3 at_a = lattice_.coordinates(a), at_b = lattice_.coordinates(b);
  for (int axis = 0; axis < 3; ++axis)
    if (at_a[axis] != at_b[axis]) return at_a[axis] / 2 % 2 == 0;
  return true;
}

int Stuffing::point(int vertex) {
  if (points_[vertex] >= 0) return points_[vertex];
  const auto moved = std::lower_bound(moved_.begin(), moved_.end(), vertex,
                                      [](const auto& entry, int wanted) { return entry.first < wanted; });
  const bool has_moved = moved != moved_.end() && moved->first == vertex;
  points_[vertex] = static_cast<int>(soup_.points.size());
  soup_.points.push_back(has_moved ? moved->second : lattice_.position(vertex));
  return points_[vertex];
}

Cut& Stuffing::cut_between(int inner, int outer) {
  int i = first_cut_[inner];
  while (cuts_[i].outer != outer) ++i;
  return cuts_[i];
}

int Stuffing::cut_point(int inner, int outer) {
  Cut& cut = cut_between(inner, outer);
  if (cut.point >= 0) return cut.point;
  cut.point = static_cast<int>(soup_.points.size());
  soup_.points.push_back(cut.place);
  return cut.point;
}

void Stuffing::add_tet(int a, int b, int c, int d) {
  const auto& points = soup_.points;
  if (signed_volume(points[a], points[b], points[c], points[d]) < 0) std::swap(c, d);
  soup_.tets.push_back({a, b, c, d});
}

void Stuffing::add_pyramid(int apex, const std::array<int, 4>& quad, bool diagonal_from_start) {
  const int first = diagonal_from_start ? 0 : 1;
  add_tet(apex, quad[first], quad[first + 1], quad[first + 2]);
  add_tet(apex, quad[first], quad[first + 2], quad[(first + 3) % 4]);
}

/// Adds three tets of a prism. diagonal[i] splits the side between the corners i and i + 1: from top[i] to bottom[i +
/// 1], or from top[i + 1] to bottom[i]. They must not all be equal.
void Stuffing::add_prism(const std::array<int, 3>& top, const std::array<int, 3>& bottom,
                         const std::array<bool, 3>& diagonal) {
  int i = 0;  // corner of the top where two diagonals end
  while (!(diagonal[i] && !diagonal[(i + 2) % 3])) ++i;
  const int j = (i + 1) % 3, k = (i + 2) % 3;
  add_tet(top[i], bottom[0], bottom[1], bottom[2]);
  add_pyramid(top[i], {top[j], top[k], bottom[k], bottom[j]}, diagonal[j]);
}

/// Adds the rest of a tet with one corner outside.
void Stuffing::add_truncated_corner(const std::array<int, 4>& inner, int outer) {
  std::array<int, 3> top, bottom;
  std::array<bool, 3> diagonal;
  for (int i = 0; i < 3; ++i) {
    top[i] = point(inner[i]);
    bottom[i] = cut_point(inner[i], outer);
    diagonal[i] = diagonal_from_first(inner[i], inner[(i + 1) % 3], outer);
  }
  add_prism(top, bottom, diagonal);
}

/// Adds the rest of a tet with two corners outside.
void Stuffing::add_wedge(int a, int b, int outer1, int outer2) {
  const std::array<int, 3> top = {point(a), cut_point(a, outer1), cut_point(a, outer2)};
  const std::array<int, 3> bottom = {point(b), cut_point(b, outer1), cut_point(b, outer2)};
  const bool first = diagonal_from_first(a, b, outer1), last = !diagonal_from_first(a, b, outer2);
  // The side on the border is free: the shorter diagonal, unless all three would be equal.
  const auto& points = soup_.points;
  const bool shorter =
      (points[top[1]] - points[bottom[2]]).squaredNorm() <= (points[top[2]] - points[bottom[1]]).squaredNorm();
  add_prism(top, bottom, {first, first == last ? !first : shorter, last});
}

}  // namespace

TetSoup stuff_isosurface(const ImplicitSolid& solid, const Eigen::AlignedBox3d& box, double cube_edge,
                         const std::string& name, const Monitor& monitor, int levels) {
  const BccLattice lattice(box, cube_edge, name);
  return Stuffing(solid, lattice, levels, monitor).run();
}

}  // namespace griffith
