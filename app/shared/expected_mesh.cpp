#include "app/shared/expected_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <variant>
#include <vector>

#include "sim/core/error.h"
#include "sim/core/file_path.h"
#include "sim/meshing/surface.h"
#include "sim/scene/shape_fields.h"

namespace griffith::app {
namespace {

constexpr double kPi = 3.14159265358979323846;

struct Estimate {
  const std::filesystem::path& folder;
  const Monitor& monitor;
  std::vector<std::pair<const SurfaceShape*, double>> surfaces =
      {};  ///< surfaces counted so far; reading one takes long

  static double in_cells(double volume, const Vec3& cell, BoxPattern pattern) {
    return tets_per_cell(pattern) * std::max(volume / cell.prod(), 1.0);
  }
  static double in_cylinder(double radius, double length, const Vec2& cell, BoxPattern pattern) {
    return in_cells(kPi * radius * radius * length, swept(cell), pattern);
  }

  double operator()(const BoxShape& box) const { return in_cells(box.size.prod(), box.element_size, box.pattern); }
  double operator()(const CylinderShape& cylinder) const {
    return in_cylinder(cylinder.radius, cylinder.length, cylinder.element_size, cylinder.pattern);
  }
  double operator()(const DiscShape& disc) const {
    return in_cylinder(disc.radius, disc.thickness, disc.element_size, disc.pattern);
  }
  double operator()(const SphereShape& sphere) const {
    return in_cells(4 * kPi / 3 * std::pow(sphere.radius, 3), Vec3::Constant(sphere.element_size), sphere.pattern);
  }
  double operator()(const PlateWithHoleShape& plate) const {
    constexpr double kTowardHole = 3;  // factor on the number of cells, which shrink toward the hole
    return kTowardHole * in_cells(plate.size.prod(), swept(plate.element_size), plate.pattern);
  }
  double operator()(const NotchedBeamShape& beam) const {
    return in_cells(beam.size.prod(), beam.element_size, beam.pattern);
  }
  double operator()(const MeshFileShape&) const { return 0; }
  double operator()(const SurfaceShape& shape) {
    if (!shape.meshing.element_size) return 0;  // a twentieth of the diagonal: never many
    const auto known = std::ranges::find_if(surfaces, [&](const auto& counted) { return *counted.first == shape; });
    if (known != surfaces.end()) return known->second;
    return surfaces.emplace_back(&shape, in_surface(shape)).second;
  }
  double in_surface(const SurfaceShape& shape) const try {
    const TriangleSurface surface = read_surface(file_path(folder, shape.path), shape.scale, monitor);
    constexpr double kTetsPerCube = 8.5;  // regular tets in a cube as wide as their edge
    // The bounding box is the better estimate if holes make the volume meaningless.
    const double box = bounds(surface).volume(), enclosed = std::abs(enclosed_volume(surface));
    const double volume = enclosed > 0.01 * box && enclosed <= box ? enclosed : box;
    return kTetsPerCube * volume / std::pow(*shape.meshing.element_size * shape.meshing.grading, 3);
  } catch (const InputError&) {
    return 0;  // building the body reports it, with its place in the scene
  }
};

/// Volume of a shape [m³]; 0 for files.
struct Volume {
  double operator()(const BoxShape& box) const { return box.size.prod(); }
  double operator()(const NotchedBeamShape& beam) const { return beam.size.prod(); }
  double operator()(const PlateWithHoleShape& plate) const { return plate.size.prod(); }
  double operator()(const CylinderShape& of) const { return kPi * of.radius * of.radius * of.length; }
  double operator()(const DiscShape& of) const { return kPi * of.radius * of.radius * of.thickness; }
  double operator()(const SphereShape& of) const { return 4 * kPi / 3 * std::pow(of.radius, 3); }
  double operator()(const MeshFileShape&) const { return 0; }
  double operator()(const SurfaceShape&) const { return 0; }
};

/// Returns the volume of a splinter of the pattern [m³]; infinite for radial ones, which are few, and for files.
double splinter_volume(const SplinterPattern& pattern) {
  if (const auto* voronoi = std::get_if<VoronoiSplinters>(&pattern))
    return std::pow(voronoi->size, 3) * voronoi->elongation;
  if (const auto* bricks = std::get_if<BrickSplinters>(&pattern)) return (bricks->size.array() + bricks->mortar).prod();
  return std::numeric_limits<double>::infinity();
}

}  // namespace

double expected_splinters(const Scene& scene) {
  double sum = 0;
  for (const BodyDescription& body : scene.bodies)
    if (body.splinters) sum += std::visit(Volume(), body.shape) / splinter_volume(*body.splinters);
  return sum;
}

double expected_tets(const Scene& scene, const Monitor& monitor) {
  double sum = 0;
  Estimate estimate{scene.folder, monitor};
  for (const BodyDescription& body : scene.bodies) sum += std::visit(estimate, body.shape);
  return sum;
}

}  // namespace griffith::app
