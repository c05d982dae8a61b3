#include "sim/meshing/volumetric.h"

#include <cmath>

#include "sim/meshing/isosurface_stuffing.h"
#include "sim/meshing/triangle_tree.h"

namespace griffith {
namespace {

/// True for inside points, of inverted surfaces too.
bool is_inside(const TriangleTree& tree, const Vec3& point) { return std::abs(tree.winding_number(point)) >= 0.5; }

/// Returns the border between an inner and an outer point as a fraction of the way. The signed distance finds it in few
/// steps (regula falsi); bisection does where it jumps, across a hole.
double crossing(const TriangleTree& tree, const Vec3& inner, const Vec3& outer) {
  constexpr int kMaxSteps = 12;
  constexpr double kTolerance = 1e-4;  // fraction of the way
  const double length = (outer - inner).norm();
  double low = 0, high = 1;
  double depth = tree.nearest(inner).distance, height = tree.nearest(outer).distance;
  for (int i = 0; i < kMaxSteps; ++i) {
    const double fraction =
        i % 3 == 2 || depth + height == 0 ? (low + high) / 2 : low + (high - low) * depth / (depth + height);
    const Vec3 point = inner + fraction * (outer - inner);
    const double distance = tree.nearest(point).distance;
    if (distance < kTolerance * length) return fraction;
    if (is_inside(tree, point))
      low = fraction, depth = distance;
    else
      high = fraction, height = distance;
  }
  return (low + high) / 2;
}

}  // namespace

TetSoup stuff_surface(const TriangleSurface& surface, double element_size, double grading, const std::string& name,
                      const Monitor& monitor) {
  const TriangleTree tree(surface);
  const Eigen::AlignedBox3d box = bounds(surface);
  ImplicitSolid solid;
  solid.inside = [&](const Vec3& point) { return box.contains(point) && is_inside(tree, point); };
  solid.crossing = [&](const Vec3& inner, const Vec3& outer) { return crossing(tree, inner, outer); };
  return stuff_isosurface(solid, box, element_size, name, monitor, static_cast<int>(std::log2(grading)));
}

}  // namespace griffith
