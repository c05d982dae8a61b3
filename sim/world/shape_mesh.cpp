#include "sim/world/shape_mesh.h"

#include "sim/error.h"
#include "sim/fracture/slit_tips.h"
#include "sim/mesh/mesh_report.h"
#include "sim/mesh/topology.h"
#include "sim/world/collision_shape.h"
#include "sim/world/shapes.h"

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

/// Makes or reads the mesh, telling errors by their place in the scene where that is all they can be told by.
TetSoup make_body_soup(const Scene& scene, int scene_body, std::vector<std::string>& findings, const Monitor& monitor) {
  const Shape& shape = scene.bodies[scene_body].shape;
  try {
    return make_soup(shape, scene.folder, &findings, monitor);
  } catch (const InputError& error) {
    if (!std::holds_alternative<SurfaceShape>(shape)) throw;
    throw InputError(shape_pointer(scene, scene_body), error.where() + ": " + error.problem(), error.remedy());
  }
}

Vec3 center_of_mass(const TetMesh& mesh, double volume) {
  Vec3 sum = Vec3::Zero();
  for (TetId tet(0); tet < mesh.tet_count(); ++tet.value) sum += rest_volume(mesh, tet) * rest_centroid(mesh, tet);
  return sum / volume;
}

ShapeMesh make_mesh(const Scene& scene, int scene_body, const Monitor& monitor) {
  const BodyDescription& body = scene.bodies[scene_body];
  ShapeMesh made;
  made.soup = make_body_soup(scene, scene_body, made.findings, monitor);
  if (monitor.is_cancelled()) throw Cancelled();
  MeshReport report = prepare(made.soup, body.name, &made.mesh);
  if (monitor.is_cancelled()) throw Cancelled();
  if (std::holds_alternative<MeshFileShape>(body.shape)) made.findings = findings(report);
  made.pieces = connected_components(made.mesh);
  if (made.pieces.size() == 1)
    made.convex_parts =
        tet_parts(made.mesh, made.mesh.rest_positions, made.pieces.front(), center_of_mass(made.mesh, report.volume));
  if (report.coincident_nodes > 0) made.slit_tips = slit_tips(made.mesh);
  made.node_of_point = std::move(report.node_of_point);
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
  return made_.emplace(shape, make_mesh(scene, scene_body, monitor)).first->second;
}

std::string shape_pointer(const Scene& scene, int scene_body) {
  const bool surface = std::holds_alternative<SurfaceShape>(scene.bodies[scene_body].shape);
  return "#/bodies/" + std::to_string(scene_body) + "/shape/" + (surface ? "surface" : "mesh");
}

}  // namespace griffith
