#include "sim/world/setup/shape_mesh.h"

#include <cstdio>
#include <optional>
#include <utility>

#include "sim/core/error.h"
#include "sim/core/file_path.h"
#include "sim/fracture/slit_tips.h"
#include "sim/mesh/box_mesh.h"
#include "sim/mesh/mesh_report.h"
#include "sim/mesh/read_mesh.h"
#include "sim/mesh/shapes.h"
#include "sim/mesh/topology.h"
#include "sim/meshing/mesh_cache.h"
#include "sim/meshing/mesh_surface.h"
#include "sim/world/bodies/collision_shape.h"

namespace griffith {
namespace {

std::size_t hash_of(double length) { return std::hash<double>{}(length); }
std::size_t hash_of(const Vec3& size) { return hash_of(size.x()) ^ 31 * hash_of(size.y()) ^ 1009 * hash_of(size.z()); }

std::size_t hash_of(const BoxShape& box) { return hash_of(box.size); }
std::size_t hash_of(const CylinderShape& cylinder) { return hash_of(Vec3(cylinder.radius, cylinder.length, 0)); }
std::size_t hash_of(const DiscShape& disc) { return hash_of(Vec3(disc.radius, disc.thickness, 0)); }
std::size_t hash_of(const SphereShape& sphere) { return hash_of(sphere.radius); }
std::size_t hash_of(const PlateWithHoleShape& plate) { return hash_of(plate.size); }
std::size_t hash_of(const NotchedBeamShape& beam) { return hash_of(beam.size); }
std::size_t hash_of(const MeshFileShape& file) { return hash_value(file.path); }
std::size_t hash_of(const SurfaceShape& surface) { return hash_value(surface.path); }

/// Checks the size of a mesh: an unusual one means other units.
void check_size(const MeshReport& report, const std::string& name) {
  constexpr double kSmallest = 1e-4, kFarthest = 1e6;  // as the fields of a scene allow [m]
  const double size = (report.maximum - report.minimum).maxCoeff();
  const double farthest = report.minimum.cwiseAbs().cwiseMax(report.maximum.cwiseAbs()).maxCoeff();
  char problem[120];
  if (size < kSmallest)
    std::snprintf(problem, sizeof problem, "measures %.3g m across", size);
  else if (farthest > kFarthest)
    std::snprintf(problem, sizeof problem, "reaches %.3g m from its origin", farthest);
  else
    return;
  throw InputError(name, problem, "bodies measure 0.1 mm at least and lie within 1,000 km: give another scale");
}

Vec3 center_of_mass(const TetMesh& mesh, double volume) {
  Vec3 sum = Vec3::Zero();
  for (const TetId tet : IdRange<TetId>(0, mesh.tet_count())) sum += rest_volume(mesh, tet) * rest_centroid(mesh, tet);
  return sum / volume;
}

/// Returns the name of the mesh in errors: its file, or its shape.
std::string mesh_name(const Scene& scene, const Shape& shape) {
  if (const auto* file = std::get_if<MeshFileShape>(&shape)) return file_path(scene.folder, file->path).string();
  if (const auto* file = std::get_if<SurfaceShape>(&shape)) return file_path(scene.folder, file->path).string();
  return "the shape";
}

/// Returns the mesh that was given for the shape, in meters; empty if it must be read or made.
std::optional<TetSoup> in_memory_soup(const InMemoryMeshes* given, const Shape& shape) {
  const auto* file = std::get_if<MeshFileShape>(&shape);
  const auto* surface = std::get_if<SurfaceShape>(&shape);
  if (given == nullptr || (file == nullptr && surface == nullptr)) return {};
  const auto found = given->find(file ? file->path : surface->path);
  if (found == given->end()) return {};
  TetSoup soup = found->second;
  if (file)
    for (Vec3& point : soup.points) point *= file->scale;
  return soup;
}

ShapeMesh make_mesh(const Scene& scene, const Shape& shape, const InMemoryMeshes* given, const Monitor& monitor) {
  ShapeMesh made;
  std::optional<TetSoup> known = in_memory_soup(given, shape);
  made.soup = known ? std::move(*known) : make_soup(shape, scene.folder, &made.findings, monitor);
  if (std::holds_alternative<SurfaceShape>(shape)) made.filled_surface = std::make_shared<const TetSoup>(made.soup);
  if (monitor.is_cancelled()) throw Cancelled();
  MeshReport report = prepare(made.soup, mesh_name(scene, shape), &made.mesh);
  if (monitor.is_cancelled()) throw Cancelled();
  check_size(report, mesh_name(scene, shape));
  if (std::holds_alternative<MeshFileShape>(shape)) {
    const std::vector<std::string> of_mesh = findings(report);
    made.findings.insert(made.findings.end(), of_mesh.begin(), of_mesh.end());
  }
  made.pieces = connected_components(made.mesh);
  if (made.pieces.size() == 1)
    made.convex_parts = tet_parts(made.mesh, made.mesh.rest_positions, made.pieces.front(),
                                  center_of_mass(made.mesh, report.volume), kCornersOfUndivided);
  if (report.coincident_nodes > 0) made.slit_tips = slit_tips(made.mesh);
  made.point_of_node = std::move(report.point_of_node);
  return made;
}

}  // namespace

std::size_t ShapeMeshes::Hash::operator()(const Shape& shape) const {
  return shape.index() + std::visit([](const auto& of_kind) { return hash_of(of_kind); }, shape);
}

const ShapeMesh& ShapeMeshes::of(const Scene& scene, int scene_body, const Monitor& monitor) {
  const Shape& shape = scene.bodies[scene_body].shape;
  const auto known = made_.find(shape);
  if (known != made_.end()) return known->second;
  try {
    return made_.emplace(shape, make_mesh(scene, shape, given_, monitor)).first->second;
  } catch (const InputError& error) {
    throw InputError(shape_pointer(scene, scene_body),
                     "of \"" + scene.bodies[scene_body].name + "\": " + error.where() + ": " + error.problem(),
                     error.remedy());
  }
}

std::string shape_pointer(const Scene& scene, int scene_body) {
  const Shape& shape = scene.bodies[scene_body].shape;
  const char* kind = std::holds_alternative<MeshFileShape>(shape)  ? "/mesh"
                     : std::holds_alternative<SurfaceShape>(shape) ? "/surface"
                                                                   : "";
  return "#/bodies/" + std::to_string(scene_body) + "/shape" + kind;
}

namespace {

struct Maker {
  const std::filesystem::path& folder;
  std::vector<std::string>* known;  ///< about the file; null: nobody asks
  const Monitor& monitor;

  TetSoup operator()(const BoxShape& box) const { return make_box(box.size, box.element_size, box.pattern); }
  TetSoup operator()(const CylinderShape& cylinder) const {
    return make_cylinder(cylinder.radius, cylinder.length, cylinder.element_size, cylinder.pattern);
  }
  TetSoup operator()(const DiscShape& disc) const {
    return make_cylinder(disc.radius, disc.thickness, disc.element_size, disc.pattern);
  }
  TetSoup operator()(const SphereShape& sphere) const {
    return make_sphere(sphere.radius, sphere.element_size, sphere.pattern);
  }
  TetSoup operator()(const PlateWithHoleShape& plate) const {
    return make_plate_with_hole(plate.size, plate.hole_radius, plate.element_size, plate.pattern);
  }
  TetSoup operator()(const NotchedBeamShape& beam) const {
    return make_notched_beam(beam.size, beam.notch_depth, beam.element_size, beam.pattern);
  }
  TetSoup operator()(const MeshFileShape& file) const {
    CellReport report;
    TetSoup soup = read_mesh(file_path(folder, file.path), &report);
    if (known != nullptr) *known = findings(report);
    for (Vec3& point : soup.points) point *= file.scale;
    return soup;
  }
  TetSoup operator()(const SurfaceShape& shape) const {
    const std::filesystem::path path = file_path(folder, shape.path);
    MeshingSetup setup;
    setup.name = path.string();
    setup.cache = default_mesh_cache();
    setup.monitor = monitor;
    SurfaceMesh mesh = mesh_surface(read_surface(path, shape.scale, setup.monitor), shape.meshing, setup);
    if (known != nullptr) *known = std::move(mesh.findings);
    return std::move(mesh.soup);
  }
};

}  // namespace

TetSoup make_soup(const Shape& shape, const std::filesystem::path& folder, std::vector<std::string>* findings,
                  const Monitor& monitor) {
  return std::visit(Maker{folder, findings, monitor}, shape);
}

}  // namespace griffith
