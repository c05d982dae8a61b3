#include <Eigen/LU>
#include <algorithm>
#include <limits>

#include "sim/fracture/slit_tips.h"
#include "sim/mesh/mesh_report.h"
#include "sim/mesh/topology.h"
#include "sim/scene/body_pose.h"
#include "sim/world/phases.h"
#include "sim/world/shapes.h"

namespace griffith {
namespace {

void append_nodes(WorldState& world, const BodyDescription& body) {
  NodeArrays& nodes = world.nodes;
  const auto& placed = world.mesh.rest_positions;
  nodes.positions.insert(nodes.positions.end(), placed.begin() + std::ssize(nodes.positions), placed.end());
  nodes.velocities.resize(placed.size(), body.velocity);
  nodes.constraints.resize(placed.size());
  nodes.held.resize(placed.size(), 0);
  nodes.masses.resize(placed.size(), 0);
  nodes.at_crack_front.resize(placed.size(), 0);
  nodes.rows.resize(placed.size(), -1);
  nodes.separations.resize(placed.size());
  nodes.reactions.resize(placed.size(), Vec3::Zero());
}

std::string shape_pointer(int scene_body, const char* shape) {
  return "#/bodies/" + std::to_string(scene_body) + "/shape/" + shape;
}

/// Makes or reads the body's mesh, telling findings and errors by their place in the scene.
TetSoup make_body_soup(WorldState& world, int scene_body, const Monitor& monitor) {
  const Shape& shape = world.scene.bodies[scene_body].shape;
  std::vector<std::string> list;
  try {
    TetSoup soup = make_soup(shape, world.scene.folder, &list, monitor);
    for (const std::string& finding : list)
      world.findings.emplace_back(shape_pointer(scene_body, "surface"), finding, "");
    return soup;
  } catch (const InputError& error) {
    if (!std::holds_alternative<SurfaceShape>(shape)) throw;
    throw InputError(shape_pointer(scene_body, "surface"), error.where() + ": " + error.problem(), error.remedy());
  }
}

/// Places the body's mesh in the world's.
RestBody append_mesh(WorldState& world, int scene_body, const Monitor& monitor) {
  const BodyDescription& description = world.scene.bodies[scene_body];
  RestBody body;
  body.soup = make_body_soup(world, scene_body, monitor);
  MeshReport report = prepare(body.soup, description.name);
  body.node_of_point = std::move(report.node_of_point);
  if (std::holds_alternative<MeshFileShape>(description.shape))
    for (const std::string& finding : findings(report))
      world.findings.emplace_back(shape_pointer(scene_body, "mesh"), finding, "");
  TetSoup placed = body.soup;
  const Pose pose = pose_of(description);
  for (Vec3& point : placed.points) point = pose.to_world(point);
  body.range = append(world.mesh, placed);
  return body;
}

/// The body's direction of weakness, placed as its rest space is.
std::optional<Weakness> place_weakness(const BodyDescription& body) {
  std::optional<Weakness> weakness = body.weakness;
  if (weakness) weakness->direction = pose_of(body).rotation * weakness->direction.normalized();
  return weakness;
}

void draw_strengths(WorldState& world, const std::optional<StrengthScatter>& scatter, NodeId first) {
  world.nodes.strength_factors.resize(world.mesh.stars.size(), 1);
  if (!scatter) return;
  std::vector<double> volumes;
  for (NodeId node = first; node < world.mesh.node_count(); ++node.value) {
    volumes.push_back(0);
    for (TetId tet : world.mesh.stars[node]) volumes.back() += world.elements.rests[tet].volume / 4;
  }
  const std::vector<double> factors = strength_factors(*scatter, volumes);
  std::copy(factors.begin(), factors.end(), world.nodes.strength_factors.begin() + first);
}

void append_elements(WorldState& world, TetId first, BodyId body) {
  ElementArrays& elements = world.elements;
  for (TetId tet = first; tet < world.mesh.tet_count(); ++tet.value) {
    elements.rests.push_back(element_rest(corners_of(world.mesh, tet, world.mesh.rest_positions)));
    int faces = 0;
    for (int face = 0; face < 4; ++face) faces |= !world.mesh.neighbours[tet][face].valid() << face;
    elements.first_surface.push_back(static_cast<std::uint8_t>(faces));
  }
  elements.states.resize(world.mesh.tets.size());
  elements.plastic_strains.resize(world.mesh.tets.size(), Mat3::Zero());
  elements.stresses.resize(world.mesh.tets.size(), Mat3::Zero());
  elements.bodies.resize(world.mesh.tets.size(), body);
  constexpr double kNever = std::numeric_limits<double>::quiet_NaN();
  elements.opened.resize(world.mesh.tets.size(), {kNever, kNever, kNever, kNever});
}

void set_initial_motion(WorldState& world, Body& body, const BodyDescription& description) {
  for (NodeId node : body.nodes) {
    const Vec3 arm = world.nodes.positions[node] - body.motion.center;
    world.nodes.velocities[node] += description.angular_velocity.cross(arm);
    const NodeConstraint& constraint = world.nodes.constraints[node];
    world.nodes.velocities[node] = constraint.allowed * world.nodes.velocities[node] + constraint.velocity;
  }
  update_motion(world, body);
}

void add_scene_body(WorldState& world, int scene_body, const Monitor& monitor) {
  const BodyDescription& description = world.scene.bodies[scene_body];
  const RestBody rest = append_mesh(world, scene_body, monitor);
  const auto [first_node, first_tet] = rest.range;
  append_nodes(world, description);
  place_supports(world, scene_body, rest);
  place_loads(world, scene_body, rest);
  place_probes(world, scene_body, rest);
  place_splinters(world, scene_body, rest);
  update_supports(world, world.time, world.scene.simulation.time_step);

  Body body;
  body.id = BodyId(static_cast<std::int64_t>(world.bodies.size()));
  append_elements(world, first_tet, body.id);
  for (NodeId node : slit_tips(world.mesh, first_tet)) world.nodes.at_crack_front[node] = 1;
  draw_strengths(world, description.strength_scatter, first_node);
  body.scene_body = scene_body;
  for (TetId tet = first_tet; tet < world.mesh.tet_count(); ++tet.value) body.tets.push_back(tet);
  world.bodies.push_back(std::move(body));
  for (NodeId node = first_node; node < world.mesh.node_count(); ++node.value)
    world.nodes.masses[node] = node_mass(world, node);
  const double quarter = mean_element_size(world, world.bodies.back()) / 4;
  world.least_edges.push_back(description.minimum_element_size > 0 ? description.minimum_element_size : quarter);
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

void build_world(WorldState& world, const Monitor& monitor) {
  check_probes(world.scene);
  world.substep_ticks = kTicksPerStep;
  for (const BodyDescription& body : world.scene.bodies) {
    world.materials.push_back(body.material);
    world.weaknesses.push_back(place_weakness(body));
  }
  if (const auto& ground = world.scene.ground)
    world.contact_world.add_ground(ground->height, {ground->friction, ground->restitution});
  for (std::size_t i = 0; i < world.scene.bodies.size(); ++i) add_scene_body(world, static_cast<int>(i), monitor);
  for (std::size_t i = 0; i < world.scene.projectiles.size(); ++i)
    queue_burst(world, world.scene.projectiles[i], "#/projectiles/" + std::to_string(i));
  if (world.scene.simulation.static_start && world.scene.analysis == Analysis::dynamic)
    find_equilibrium(world, 0, 0, true);
  place_stand_ins(world);
  update_elements(world);
  evaluate_separation(world, false);
  publish(world);
}

}  // namespace griffith
