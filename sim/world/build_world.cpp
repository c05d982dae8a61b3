#include <Eigen/LU>
#include <numbers>
#include <variant>

#include "sim/mesh/box_mesh.h"
#include "sim/mesh/mesh_report.h"
#include "sim/mesh/read_mesh.h"
#include "sim/mesh/topology.h"
#include "sim/world/phases.h"

namespace griffith {
namespace {

TetSoup make_soup(const BoxShape& box, const Scene&) { return make_box(box.size, box.element_size, box.pattern); }

TetSoup make_soup(const MeshFileShape& file, const Scene& scene) {
  TetSoup soup = read_mesh(file.path.is_absolute() ? file.path : scene.folder / file.path);
  for (Vec3& point : soup.points) point *= file.scale;
  return soup;
}

Quat rotation_of(const BodyDescription& body) {
  const Vec3 radians = body.rotation_degrees * std::numbers::pi / 180;
  return Quat(Eigen::AngleAxisd(radians.z(), Vec3::UnitZ()) * Eigen::AngleAxisd(radians.y(), Vec3::UnitY()) *
              Eigen::AngleAxisd(radians.x(), Vec3::UnitX()));
}

/// Per node of the prepared soup: 1 where a support holds it. Regions name nodes by their number as read.
std::vector<std::uint8_t> held_nodes(const BodyDescription& body, const TetSoup& soup, const MeshReport& report) {
  constexpr double kTolerance = 1e-9;  // of the body's size
  Eigen::AlignedBox3d bounds;
  for (const Vec3& point : soup.points) bounds.extend(point);
  const double tolerance = kTolerance * bounds.diagonal().norm();
  std::vector<std::uint8_t> held(soup.points.size(), 0);
  for (const Support& support : body.supports)
    for (std::size_t i = 0; i < report.node_of_point.size(); ++i)
      if (const int node = report.node_of_point[i]; node >= 0)
        if (contains(support.region, soup.points[node], static_cast<int>(i), tolerance)) held[node] = 1;
  return held;
}

void append_nodes(WorldState& world, const BodyDescription& body, const std::vector<std::uint8_t>& held) {
  NodeArrays& nodes = world.nodes;
  const auto& placed = world.mesh.rest_positions;
  nodes.positions.insert(nodes.positions.end(), placed.end() - static_cast<std::ptrdiff_t>(held.size()), placed.end());
  nodes.velocities.resize(placed.size(), body.velocity);
  nodes.held.insert(nodes.held.end(), held.begin(), held.end());
  nodes.masses.resize(placed.size(), 0);
  nodes.at_crack_front.resize(placed.size(), 0);
  nodes.rows.resize(placed.size(), -1);
  nodes.separations.resize(placed.size());
}

Corners rest_corners(const TetMesh& mesh, TetId tet) {
  Corners corners;
  for (int i = 0; i < 4; ++i) corners.col(i) = mesh.rest_positions[mesh.tets[tet][i]];
  return corners;
}

void append_elements(WorldState& world, TetId first, BodyId body) {
  ElementArrays& elements = world.elements;
  for (TetId tet = first; tet < world.mesh.tet_count(); ++tet.value)
    elements.rests.push_back(element_rest(rest_corners(world.mesh, tet)));
  elements.states.resize(world.mesh.tets.size());
  elements.tensile_stresses.resize(world.mesh.tets.size(), Mat3::Zero());
  elements.stresses.resize(world.mesh.tets.size(), Mat3::Zero());
  elements.bodies.resize(world.mesh.tets.size(), body);
}

void set_initial_motion(WorldState& world, Body& body, const BodyDescription& description) {
  for (NodeId node : body.nodes) {
    const Vec3 arm = world.nodes.positions[node] - body.motion.center;
    world.nodes.velocities[node] += description.angular_velocity.cross(arm);
    if (world.nodes.held[node]) world.nodes.velocities[node].setZero();
  }
  update_motion(world, body);
}

void add_scene_body(WorldState& world, int scene_body) {
  const BodyDescription& description = world.scene.bodies[scene_body];
  TetSoup soup = std::visit([&](const auto& shape) { return make_soup(shape, world.scene); }, description.shape);
  const MeshReport report = prepare(soup, description.name);
  const std::vector<std::uint8_t> held = held_nodes(description, soup, report);
  const Quat rotation = rotation_of(description);
  for (Vec3& point : soup.points) point = rotation * point + description.position;

  const NodeId first_node(world.mesh.node_count());
  const TetId first_tet(world.mesh.tet_count());
  append(world.mesh, soup);
  append_nodes(world, description, held);

  Body body;
  body.id = BodyId(static_cast<std::int64_t>(world.bodies.size()));
  append_elements(world, first_tet, body.id);
  body.scene_body = scene_body;
  for (TetId tet = first_tet; tet < world.mesh.tet_count(); ++tet.value) body.tets.push_back(tet);
  world.bodies.push_back(std::move(body));
  for (NodeId node = first_node; node < world.mesh.node_count(); ++node.value)
    world.nodes.masses[node] = node_mass(world, node);
  const std::size_t first_piece = world.bodies.size() - 1;
  part_body(world, world.bodies.back().id);
  for (std::size_t i = first_piece; i < world.bodies.size(); ++i) {
    world.bodies[i].parent = BodyId();
    set_initial_motion(world, world.bodies[i], description);
  }
}

}  // namespace

double node_mass(const WorldState& world, NodeId node) {
  double mass = 0;
  for (TetId tet : world.mesh.stars[node]) {
    const Body& body = world.bodies[world.elements.bodies[tet]];
    mass += world.material_of(body).density * world.elements.rests[tet].volume / 4;
  }
  return mass;
}

void build_world(WorldState& world) {
  world.substep_ticks = kTicksPerStep;
  for (const BodyDescription& body : world.scene.bodies) world.materials.push_back(body.material);
  if (const auto& ground = world.scene.ground)
    world.contact_world.add_ground(ground->height, {ground->friction, ground->restitution});
  for (std::size_t i = 0; i < world.scene.bodies.size(); ++i) add_scene_body(world, static_cast<int>(i));
  for (const ProjectileBurst& burst : world.scene.projectiles) queue_burst(world, burst);
  update_elements(world);
  evaluate_separation(world);
  publish(world);
}

}  // namespace griffith
