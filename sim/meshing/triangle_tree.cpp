#include "sim/meshing/triangle_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "sim/geometry/triangle.h"

namespace griffith {
namespace {

constexpr int kLeafTriangles = 4;
/// Smallest distance of a far group of triangles, in its radii.
constexpr double kFarRadii = 3;

Vec3 middle_of(const std::array<Vec3, 3>& corners) { return (corners[0] + corners[1] + corners[2]) / 3; }

Eigen::AlignedBox3d box_of(const std::array<Vec3, 3>& corners) {
  Eigen::AlignedBox3d box;
  for (const Vec3& corner : corners) box.extend(corner);
  return box;
}

/// Returns the solid angle of a triangle seen from `point`, negative from behind (van Oosterom & Strackee 1983, eq. 8).
double solid_angle_of(const std::array<Vec3, 3>& corners, const Vec3& point) {
  const Vec3 a = corners[0] - point, b = corners[1] - point, c = corners[2] - point;
  const double la = a.norm(), lb = b.norm(), lc = c.norm();
  const double denominator = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
  return 2 * std::atan2(a.dot(b.cross(c)), denominator);
}

}  // namespace

TriangleTree::TriangleTree(const TriangleSurface& surface) {
  for (std::size_t i = 0; i < surface.triangles.size(); ++i)
    triangles_.push_back(corners_of(surface, static_cast<int>(i)));
  order_.resize(triangles_.size());
  std::iota(order_.begin(), order_.end(), 0);
  if (!triangles_.empty()) build(0, static_cast<int>(triangles_.size()));
}

int TriangleTree::build(int begin, int end) {
  const int index = static_cast<int>(nodes_.size());
  Node& node = nodes_.emplace_back();
  node.begin = begin;
  node.end = end;
  Eigen::AlignedBox3d middles;
  for (int i = begin; i < end; ++i) {
    node.box.extend(box_of(triangles_[order_[i]]));
    middles.extend(middle_of(triangles_[order_[i]]));
  }
  set_dipole(node);
  if (end - begin <= kLeafTriangles) return index;
  int axis = 0;
  middles.sizes().maxCoeff(&axis);
  const auto before = [&](int a, int b) {
    return std::pair(middle_of(triangles_[a])[axis], a) < std::pair(middle_of(triangles_[b])[axis], b);
  };
  const int split = (begin + end) / 2;
  std::nth_element(order_.begin() + begin, order_.begin() + split, order_.begin() + end, before);
  const int left = build(begin, split), right = build(split, end);
  nodes_[index].left = left;  // `node` may have moved
  nodes_[index].right = right;
  return index;
}

void TriangleTree::set_dipole(Node& node) const {
  double area = 0;
  for (int i = node.begin; i < node.end; ++i) {
    const Vec3 vector = area_vector(triangles_[order_[i]]);
    node.dipole += vector;
    node.center += vector.norm() * middle_of(triangles_[order_[i]]);
    area += vector.norm();
  }
  node.center = area > 0 ? Vec3(node.center / area) : node.box.center();
  for (int i = node.begin; i < node.end; ++i)
    for (const Vec3& corner : triangles_[order_[i]]) node.radius = std::max(node.radius, (corner - node.center).norm());
}

TriangleTree::Nearest TriangleTree::nearest(const Vec3& point) const {
  Nearest best;
  best.distance = std::numeric_limits<double>::infinity();
  find_nearest(0, point, best);
  return best;
}

void TriangleTree::find_nearest(int index, const Vec3& point, Nearest& best) const {
  const Node& node = nodes_[index];
  if (node.left >= 0) {
    const double left = nodes_[node.left].box.exteriorDistance(point);
    const double right = nodes_[node.right].box.exteriorDistance(point);
    const bool left_first = left <= right;
    if (std::min(left, right) < best.distance) find_nearest(left_first ? node.left : node.right, point, best);
    if (std::max(left, right) < best.distance) find_nearest(left_first ? node.right : node.left, point, best);
    return;
  }
  for (int i = node.begin; i < node.end; ++i) {
    const std::array<Vec3, 3>& corners = triangles_[order_[i]];
    const Vec3 weights = closest_on_triangle(point, corners);
    const Vec3 candidate = weights[0] * corners[0] + weights[1] * corners[1] + weights[2] * corners[2];
    const double distance = (candidate - point).norm();
    if (distance < best.distance) best = {distance, candidate, order_[i]};
  }
}

double TriangleTree::winding_number(const Vec3& point) const {
  return nodes_.empty() ? 0 : solid_angle(0, point) / (4 * std::numbers::pi);
}

double TriangleTree::solid_angle(int index, const Vec3& point) const {
  const Node& node = nodes_[index];
  const Vec3 arm = node.center - point;
  const double distance = arm.norm();
  if (distance > kFarRadii * node.radius) return arm.dot(node.dipole) / (distance * distance * distance);
  if (node.left >= 0) return solid_angle(node.left, point) + solid_angle(node.right, point);
  double sum = 0;
  for (int i = node.begin; i < node.end; ++i) sum += solid_angle_of(triangles_[order_[i]], point);
  return sum;
}

bool TriangleTree::visit_box(const Eigen::AlignedBox3d& box, const std::function<bool(int)>& visit) const {
  return nodes_.empty() || visit_box(0, box, visit);
}

bool TriangleTree::visit_box(int index, const Eigen::AlignedBox3d& box, const std::function<bool(int)>& visit) const {
  const Node& node = nodes_[index];
  if (!node.box.intersects(box)) return true;
  if (node.left >= 0) return visit_box(node.left, box, visit) && visit_box(node.right, box, visit);
  for (int i = node.begin; i < node.end; ++i)
    if (box_of(triangles_[order_[i]]).intersects(box) && !visit(order_[i])) return false;
  return true;
}

}  // namespace griffith
