#include "sim/world/setup/build_world.h"

#include <algorithm>
#include <limits>

#include "sim/core/parallel.h"
#include "sim/mesh/mesh_limits.h"
#include "sim/mesh/topology.h"
#include "sim/scene/body_pose.h"
#include "sim/world/bodies/bodies.h"
#include "sim/world/bodies/collision_shape.h"
#include "sim/world/conditions/projectiles.h"
#include "sim/world/contact/contact_phase.h"
#include "sim/world/energy/energy_phase.h"
#include "sim/world/fracture/separation_phase.h"
#include "sim/world/motion/elastic_phase.h"
#include "sim/world/motion/equilibrium.h"
#include "sim/world/motion/explicit_integration.h"
#include "sim/world/output/publish.h"
#include "sim/world/setup/choose_elements.h"
#include "sim/world/setup/place_splinters.h"
#include "sim/world/setup/residual_strains.h"
#include "sim/world/setup/shape_mesh.h"
#include "sim/world/state/corners.h"
#include "sim/world/state/world_state.h"

namespace griffith {
namespace {

void append_nodes(WorldState& world, const BodyDescription& body) {
  NodeArrays& nodes = world.nodes;
  const std::size_t first = nodes.positions.size();
  nodes.resize(world.mesh->rest_positions.size());
  for (std::size_t i = first; i < nodes.positions.size(); ++i) {
    nodes.positions[i] = world.mesh->rest_positions[i];
    nodes.velocities[i] = body.velocity;
  }
}

/// Places a copy of the shape's mesh in the world's.
RestBody append_mesh(Model& model, WorldState& world, int scene_body, const ShapeMesh& shape) {
  const RestBody body{shape.soup, shape.point_of_node, shape.mesh, append(world.mesh.edit(), shape.mesh)};
  const Pose pose = pose_of(model.scene.bodies[scene_body]);
  std::vector<Vec3>& points = world.mesh.edit().rest_positions;
  for (std::size_t i = body.range.first_node; i < points.size(); ++i) points[i] = pose.to_world(points[i]);
  model.points.insert(model.points.end(), shape.point_of_node.begin(), shape.point_of_node.end());
  model.filled_surfaces.push_back(shape.filled_surface);
  for (const std::string& finding : shape.findings)
    model.findings.emplace_back(shape_pointer(model.scene, scene_body), finding, "");
  return body;
}

/// Returns the body's direction of weakness in its rest space.
std::optional<Weakness> place_weakness(const BodyDescription& body) {
  std::optional<Weakness> weakness = body.weakness;
  if (weakness) weakness->direction = pose_of(body).rotation * weakness->direction.normalized();
  return weakness;
}

void draw_strengths(WorldState& world, const std::optional<StrengthScatter>& scatter, NodeId first) {
  if (!scatter) return;
  std::vector<double> volumes;
  for (const NodeId node : IdRange<NodeId>(first.index(), world.mesh->node_count())) {
    volumes.push_back(0);
    for (TetId tet : world.mesh->stars[node]) volumes.back() += world.elements.rest_elements[tet].volume / 4;
  }
  const std::vector<double> factors = strength_factors(*scatter, volumes);
  std::copy(factors.begin(), factors.end(), world.nodes.strength_factors.begin() + first.index());
}

void append_elements(WorldState& world, TetId first) {
  ElementArrays& elements = world.elements;
  elements.resize(world.mesh->tets.size());
  std::vector<RestElement>& rest_elements = elements.rest_elements.edit();
  std::vector<std::uint8_t>& first_surface = elements.first_surface.edit();
  for (const TetId tet : IdRange<TetId>(first.index(), world.mesh->tet_count())) {
    rest_elements[tet] = rest_element(corners_of(world.mesh, tet, world.mesh->rest_positions));
    int faces = 0;
    for (int face = 0; face < 4; ++face) faces |= !world.mesh->neighbors[tet][face].valid() << face;
    first_surface[tet] = static_cast<std::uint8_t>(faces);
  }
}

/// Makes the tets from `first` on quadratic.
void append_edges(WorldState& world, TetId first) {
  std::vector<TetId> tets;
  for (const TetId tet : IdRange<TetId>(first.index(), world.mesh->tet_count())) tets.push_back(tet);
  add_edges(world.mesh, tets, world.tet_edges.edit());
  world.edges.resize(world.tet_edges->ends.size());
}

/// Sets in motion one of the pieces of a scene body that turns about `center`.
void set_initial_motion(WorldState& world, Body& body, const BodyDescription& description, const Vec3& center) {
  for (NodeId node : body.nodes) {
    const Vec3 arm = world.nodes.positions[node] - center;
    world.nodes.velocities[node] += description.angular_velocity.cross(arm);
    const NodeConstraint& constraint = world.nodes.constraints[node];
    world.nodes.velocities[node] = constraint.allowed * world.nodes.velocities[node] + constraint.velocity;
  }
  update_motion(world, body);
}

/// Range of the pieces of a scene body in `world.bodies`, and their shape.
struct Pieces {
  std::size_t first, end;
  const ShapeMesh& shape;
};

/// Adds a body for each piece of the shape, separate from the start or not; only its tets are set.
Pieces add_bodies(WorldState& world, int scene_body, TetId first_tet, const ShapeMesh& shape) {
  const std::size_t first = world.bodies.size();
  Body& body = world.bodies.emplace_back();
  body.id = BodyId(static_cast<std::int64_t>(first));
  body.scene_body = scene_body;
  std::vector<std::vector<TetId>> pieces = shape.pieces;
  for (std::vector<TetId>& piece : pieces)
    for (TetId& tet : piece) tet = tet.shifted(first_tet);
  assign_pieces(world, body.id, std::move(pieces));
  for (std::size_t i = first; i < world.bodies.size(); ++i) world.bodies[i].parent = BodyId();
  return {first, world.bodies.size(), shape};
}

/// Adds all that a scene says of a body, but for what follows from it.
Pieces add_scene_body(Model& model, WorldState& world, int scene_body, const ShapeMesh& shape, const Monitor& monitor) {
  const BodyDescription& description = model.scene.bodies[scene_body];
  const RestBody rest = append_mesh(model, world, scene_body, shape);
  const auto [first_node, first_tet] = rest.range;
  append_nodes(world, description);
  append_elements(world, first_tet);
  place_supports(model.scene, scene_body, rest, world.supports, model.findings);
  place_loads(world, scene_body, rest, world.loads, model.findings);
  place_probes(model.scene, scene_body, rest, world.probes, model.findings);
  place_splinters(model, scene_body, rest, monitor);
  model.element_choices.push_back(choose_elements(model.scene, scene_body, shape.mesh));
  if (model.element_choices.back().order == ElementOrder::quadratic) append_edges(world, first_tet);
  for (NodeId tip : shape.slit_tips) world.nodes.at_crack_front[tip.shifted(first_node)] = 1;
  draw_strengths(world, description.strength_scatter, first_node);
  std::vector<TetId> tets;
  for (const TetId tet : IdRange<TetId>(first_tet.index(), world.mesh->tet_count())) tets.push_back(tet);
  const double quarter = mean_element_size(world.elements.rest_elements, tets) / 4;
  model.min_edges.push_back(description.minimum_element_size > 0 ? description.minimum_element_size : quarter);
  return add_bodies(world, scene_body, first_tet, shape);
}

/// Returns collision_parts(), from the shape if possible.
std::vector<ConvexPart> first_collision_parts(const WorldState& world, const Body& body, const ShapeMesh& shape) {
  const BodyDescription& description = world.model->scene.bodies[body.scene_body];
  if (description.collision == CollisionShape::splinters || shape.convex_parts.empty())
    return collision_parts(world, body);
  const Quat rotation = pose_of(description).rotation;
  std::vector<ConvexPart> parts = shape.convex_parts;
  for (ConvexPart& part : parts)
    for (Vec3& corner : part) corner = rotation * corner;
  return parts;
}

/// Returns the center of mass of all pieces together.
Vec3 center_of_mass(std::span<const Body> pieces) {
  Vec3 moment = Vec3::Zero();
  double mass = 0;
  for (const Body& piece : pieces) {
    moment += piece.motion.mass * piece.motion.center;
    mass += piece.motion.mass;
  }
  return moment / mass;
}

/// Sets all data that follow from the tets of a scene body's pieces, except for their proxies; changes nothing of other
/// scene bodies.
void complete(WorldState& world, const Pieces& pieces) {
  const std::span<Body> bodies = std::span(world.bodies).subspan(pieces.first, pieces.end - pieces.first);
  for (const Body& body : bodies)
    for (TetId tet : body.tets)
      for (NodeId node : world.mesh->tets[tet])
        if (world.mesh->stars[node].front() == tet) world.nodes.masses[node] = node_mass(world, node);
  for (Body& body : bodies) rebuild_shape(world, body);
  for (const Body& body : bodies)
    for (const EdgeId edge : body.edges) world.edges.masses[edge] = edge_mass(world, edge);
  const Vec3 center = center_of_mass(bodies);
  for (Body& body : bodies) {
    set_initial_motion(world, body, world.model->scene.bodies[body.scene_body], center);
    body.collision_parts = first_collision_parts(world, body, pieces.shape);
  }
}

/// Makes the meshes of all bodies. Throws where they are too large together: files tell only now how many tets they
/// have.
void make_meshes(const Scene& scene, ShapeMeshes& shapes, const Monitor& monitor) {
  std::int64_t tets = 0;
  for (int i = 0; i < static_cast<int>(scene.bodies.size()); ++i) {
    monitor.enter("Meshing body " + std::to_string(i + 1) + " of " + std::to_string(scene.bodies.size()));
    tets += shapes.of(scene, i, monitor).mesh.tet_count();
    if (tets > kMaxTets)
      throw InputError("#/bodies/" + std::to_string(i) + "/shape",
                       std::string("brings the scene to more than ") + kMaxTetsText,
                       "use coarser meshes or fewer bodies");
  }
}

/// Bounds of a body, slightly reduced so that touching bodies do not overlap.
struct InnerBounds {
  InnerBounds(const WorldState& world, const Body& body) : scene_body(body.scene_body) {
    constexpr double kMargin = 1e-6;  // of the size
    for (NodeId node : body.nodes) box.extend(world.nodes.positions[node]);
    const Vec3 margin = kMargin * box.sizes();
    box = {box.min() + margin, box.max() - margin};
  }

  int scene_body;
  Eigen::AlignedBox3d box;
};

/// Throws if very many bodies are inside one another: the number of contacts grows with the square of a crowd. The
/// pieces of one body, which may have any shape, fit together. Sweeps along x.
void require_no_crowd(const WorldState& world) {
  constexpr int kMaxPairs = 1'000'000;
  std::vector<InnerBounds> all;
  for (const Body& body : world.bodies) all.emplace_back(world, body);
  std::ranges::sort(all, {}, [](const InnerBounds& bounds) { return bounds.box.min().x(); });
  int pairs = 0;
  for (auto a = all.begin(); a != all.end(); ++a)
    for (auto b = a + 1; b != all.end() && b->box.min().x() < a->box.max().x(); ++b)
      if (a->scene_body != b->scene_body && a->box.intersects(b->box) && ++pairs > kMaxPairs)
        throw InputError("#/bodies", "stand inside one another in more than a million pairs", "move them apart");
}

void allow_flow_of(const Model& model, WorldState& world) {
  for (std::size_t i = 0; i < world.materials.size(); ++i) {
    if (!world.materials[i].yield_strength) continue;
    model.element_choices[i].order == ElementOrder::quadratic ? world.elements.allow_point_strains()
                                                              : world.elements.allow_strains();
  }
}

void add_scene_bodies(Model& model, WorldState& world, const InMemoryMeshes& given, const Monitor& monitor) {
  ShapeMeshes shapes(given);
  std::vector<Pieces> pieces;
  make_meshes(model.scene, shapes, monitor);
  monitor.enter("Building the bodies");
  for (int i = 0; i < static_cast<int>(model.scene.bodies.size()); ++i) {
    pieces.push_back(add_scene_body(model, world, i, shapes.of(model.scene, i, monitor), monitor));
    if (monitor.is_cancelled()) throw Cancelled();
  }
  if (!world.edges.offsets.empty()) {
    world.tet_edges.edit().of_tet.resize(world.mesh->tets.size());
    world.elements.quadratic_states.edit().resize(world.mesh->tets.size());
  }
  allow_flow_of(model, world);
  close_splinters(model);
  world.splinter_state = intact_state(model.splinters);
  update_supports(world, world.time, world.model->scene.simulation.time_step);
  parallel_for(static_cast<int>(pieces.size()), 16, [&](int begin, int end) {
    for (int i = begin; i < end && !monitor.is_cancelled(); ++i) complete(world, pieces[i]);
  });
  if (monitor.is_cancelled()) throw Cancelled();
  require_no_crowd(world);
  add_proxies(world, world.bodies);
}

}  // namespace

void allow_flow(WorldState& world) { allow_flow_of(*world.model, world); }

double node_mass(const WorldState& world, NodeId node) {
  double mass = 0;
  for (TetId tet : world.mesh->stars[node]) {
    const Body& body = world.bodies[world.elements.bodies[tet]];
    mass += world.material_of(body).density * world.elements.rest_elements[tet].volume / 4;
  }
  return mass;
}

double edge_mass(const WorldState& world, EdgeId edge) {
  double mass = 0;
  for (TetId tet : world.mesh->stars[world.tet_edges->ends[edge][0]]) {
    const std::array<EdgeId, 6>& edges = world.tet_edges->of_tet[tet];
    if (std::ranges::find(edges, edge) == edges.end()) continue;
    mass +=
        world.material_of(world.bodies[world.elements.bodies[tet]]).density * world.elements.rest_elements[tet].volume;
  }
  return mass;
}

WorldState build_world(const Scene& scene, const Monitor& monitor, const InMemoryMeshes& given) {
  check_probes(scene);
  for (int i = 0; i < static_cast<int>(scene.bodies.size()); ++i)
    check_residual_stress(scene, i, scene.bodies[i].material);
  const auto model = std::make_shared<Model>();
  model->scene = scene;
  WorldState world(model);
  for (const BodyDescription& body : scene.bodies) {
    world.materials.push_back(body.material);
    model->weaknesses.push_back(place_weakness(body));
  }
  if (const auto& ground = scene.ground)
    world.contact_world.add_ground(ground->height, {ground->friction, ground->restitution});
  add_scene_bodies(*model, world, given, monitor);
  model->extents.resize(scene.bodies.size(), 0);
  for (const Body& body : world.bodies)
    model->extents[body.scene_body] = std::max(model->extents[body.scene_body], body.extent);
  queue_bursts(world);
  for (int i = 0; i < static_cast<int>(world.materials.size()); ++i) check_substep_count(world, i, world.materials[i]);
  for (int i = 0; i < static_cast<int>(scene.bodies.size()); ++i) set_residual_strains(world, i, world.elements);
  if (monitor.is_cancelled()) throw Cancelled();
  monitor.enter("Finding the start");
  find_static_start(world, -1, monitor);
  place_proxies(world);
  update_elements(world);
  evaluate_separation(world, false);
  open_account(world);
  publish(world);
  return world;
}

}  // namespace griffith
