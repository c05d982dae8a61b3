#include "sim/world/conditions/loads.h"

#include <algorithm>
#include <limits>

#include "sim/core/sort_unique.h"
#include "sim/core/tet_edge_corners.h"
#include "sim/mesh/topology.h"
#include "sim/world/bodies/bonded_pieces.h"
#include "sim/world/conditions/material_point.h"
#include "sim/world/regime/regime_change.h"
#include "sim/world/state/world_state.h"

namespace griffith {
namespace {

bool all_marked(const TetSoup& soup, int tet, const std::vector<std::uint8_t>& marked, int except = -1) {
  for (int corner = 0; corner < 4; ++corner)
    if (corner != except && !marked[soup.tets[tet][corner]]) return false;
  return true;
}

/// Returns the first corner at each marked node.
std::vector<TetCorner> one_corner_a_node(const RestBody& body, std::vector<std::uint8_t> marked) {
  std::vector<TetCorner> corners;
  for (const TetCorner& corner : corners_at(body, marked)) {
    std::uint8_t& is_new = marked[soup_node(body, corner)];
    if (is_new) corners.push_back(corner);
    is_new = 0;
  }
  return corners;
}

std::vector<SurfaceFace> faces_of(const TetMesh& mesh, const RestBody& body, const std::vector<std::uint8_t>& marked) {
  std::vector<SurfaceFace> faces;
  for (int i = 0; i < static_cast<int>(body.soup.tets.size()); ++i)
    for (int face = 0; face < 4; ++face) {
      const TetId tet = TetId(i).shifted(body.range.first_tet);
      if (!mesh.neighbors[tet][face].valid() && all_marked(body.soup, i, marked, face)) faces.push_back({tet, face});
    }
  return faces;
}

std::vector<TetId> tets_of(const RestBody& body, const std::vector<std::uint8_t>& marked) {
  std::vector<TetId> tets;
  for (int i = 0; i < static_cast<int>(body.soup.tets.size()); ++i)
    if (all_marked(body.soup, i, marked)) tets.push_back(TetId(i).shifted(body.range.first_tet));
  return tets;
}

PlacedLoad place_load(const TetMesh& mesh, const Load& load, const RestBody& body) {
  const std::vector<std::uint8_t> marked = nodes_in(body, load.region);
  PlacedLoad placed{load, {}, {}, {}};
  switch (load.kind) {
    case LoadKind::point_force:
      placed.corners = one_corner_a_node(body, marked);
      break;
    case LoadKind::traction:
    case LoadKind::pressure:
      placed.faces = faces_of(mesh, body, marked);
      break;
    case LoadKind::body_force:
      placed.tets = tets_of(body, marked);
      break;
  }
  return placed;
}

const char* loaded_things(LoadKind kind) {
  switch (kind) {
    case LoadKind::point_force:
      return "node";
    case LoadKind::traction:
    case LoadKind::pressure:
      return "surface face with all its nodes";
    case LoadKind::body_force:
      return "tetrahedron with all its nodes";
  }
  return "";
}

/// Returns the edges of a face of a quadratic tet; invalid ones for a linear tet.
std::array<EdgeId, 3> face_edges(const WorldState& world, const SurfaceFace& face) {
  std::array<EdgeId, 3> edges;
  if (!world.tet_edges->is_quadratic(face.tet)) return edges;
  int found = 0;
  for (int edge = 0; edge < 6; ++edge)
    if (kTetEdges[edge][0] != face.face && kTetEdges[edge][1] != face.face)
      edges[found++] = world.tet_edges->of_tet[face.tet][edge];
  return edges;
}

/// Adds `force` to each corner and edge of a face.
void add_to_face(std::span<const NodeId> nodes, std::span<const EdgeId> edges, const Vec3& force,
                 std::span<Vec3> forces, std::span<Vec3> edge_forces) {
  for (const NodeId node : nodes) forces[node] += force;
  for (const EdgeId edge : edges)
    if (edge.valid()) edge_forces[edge] += force;
}

PressedFace pressed_face(const WorldState& world, const SurfaceFace& face, double pressure) {
  return {face_nodes(world.mesh, face.tet, face.face), face_edges(world, face), pressure};
}

void add_point_force(const WorldState& world, const PlacedLoad& placed, double factor, ExternalForces& forces) {
  if (placed.point) return add_force_at(world, *placed.point, factor * placed.load.force, forces);
  const Vec3 force = factor / static_cast<double>(placed.corners.size()) * placed.load.force;
  for (const TetCorner& corner : placed.corners) forces.nodes[node_at(world.mesh->tets, corner)] += force;
}

void add_traction(const WorldState& world, const PlacedLoad& placed, double factor, ExternalForces& forces) {
  for (const SurfaceFace& face : placed.faces) {
    const std::array<NodeId, 3> nodes = face_nodes(world.mesh, face.tet, face.face);
    const Vec3 force = factor * area_vector(world.mesh->rest_positions, nodes).norm() / 3 * placed.load.traction;
    add_to_face(nodes, face_edges(world, face), force, forces.nodes, forces.edges);
  }
}

void add_body_force(const WorldState& world, const PlacedLoad& placed, double factor, ExternalForces& forces) {
  for (TetId tet : placed.tets) {
    const double density = world.material_of(world.bodies[world.elements.bodies[tet]]).density;
    const Vec3 force = factor * density * world.elements.rest_elements[tet].volume / 4 * placed.load.acceleration;
    for (NodeId node : world.mesh->tets[tet]) forces.nodes[node] += force;
  }
}

void add_dead_load(const WorldState& world, const PlacedLoad& placed, double factor, ExternalForces& forces) {
  switch (placed.load.kind) {
    case LoadKind::point_force:
      return add_point_force(world, placed, factor, forces);
    case LoadKind::traction:
      return add_traction(world, placed, factor, forces);
    case LoadKind::pressure:
      return;
    case LoadKind::body_force:
      return add_body_force(world, placed, factor, forces);
  }
}

/// Returns the time at which a load stops acting [s].
double end_of(const Load& load) {
  return load.duration ? load.start + *load.duration : std::numeric_limits<double>::infinity();
}

double factor_at(const Load& load, double time) {
  const double acted = time - load.start;
  if (acted < 0 || (load.duration && acted >= *load.duration)) return 0;
  return acted < load.ramp ? acted / load.ramp : 1;
}

}  // namespace

double load_factor(const Load& load, const TimeSpan& span) {
  if (span.from == span.to) return factor_at(load, span.from);
  const double end = end_of(load), full = std::min(load.start + load.ramp, end);
  const double held = std::max(0.0, std::min(span.to, end) - std::max(span.from, full));
  const double first = std::clamp(span.from, load.start, full) - load.start,
               last = std::clamp(span.to, load.start, full) - load.start;
  const double grown = load.ramp > 0 ? (last - first) * (last + first) / (2 * load.ramp) : 0;
  return (held + grown) / span.duration();
}

ExternalForces no_forces(const WorldState& world) {
  return {std::vector<Vec3>(world.nodes.positions.size(), Vec3::Zero()),
          std::vector<Vec3>(world.edges.offsets.size(), Vec3::Zero())};
}

ExternalForces weights(const WorldState& world) {
  ExternalForces forces = no_forces(world);
  for (std::size_t i = 0; i < forces.nodes.size(); ++i)
    forces.nodes[i] = world.nodes.masses[i] * world.model->scene.gravity;
  return forces;
}

bool changes_after(const Load& load, double time) {
  return load.duration ? time < end_of(load) : time < load.start + load.ramp;
}

void place_loads(const WorldState& world, int scene_body, const RestBody& body, std::vector<PlacedLoad>& all,
                 std::vector<InputError>& findings) {
  const std::vector<Load>& loads = world.model->scene.bodies[scene_body].loads;
  for (std::size_t i = 0; i < loads.size(); ++i) {
    const PlacedLoad& placed = all.emplace_back(place_load(world.mesh, loads[i], body));
    if (!placed.corners.empty() || !placed.faces.empty() || !placed.tets.empty()) continue;
    findings.emplace_back("#/bodies/" + std::to_string(scene_body) + "/loads/" + std::to_string(i) + "/region",
                          std::string("holds no ") + loaded_things(loads[i].kind),
                          "make it larger, or move it: regions are in the body's rest space");
  }
}

std::vector<BodyId> bodies_under(const WorldState& world, const PlacedLoad& placed) {
  std::vector<BodyId> bodies;
  const auto add = [&](TetId tet) { bodies.push_back(world.elements.bodies[tet]); };
  for (const TetCorner& corner : placed.corners) add(corner.tet);
  for (const SurfaceFace& face : placed.faces) add(face.tet);
  for (const TetId tet : placed.tets) add(tet);
  if (placed.point) add(placed.point->tet);
  sort_unique(bodies);
  return bodies;
}

void make_loaded_bodies_elastic(WorldState& world, const TimeSpan& last, const TimeSpan& next) {
  for (const PlacedLoad& placed : world.loads) {
    if (load_factor(placed.load, last) == load_factor(placed.load, next)) continue;
    for (const BodyId id : bodies_under(world, placed)) {
      Body& body = world.bodies[id];
      const bool may_deform = body.rigid && !body.supported() && body.tets.size() > 1;
      if (may_deform && !is_held_by_bonds(world, body)) make_elastic(world, body);
    }
  }
}

std::vector<bool> strained_bodies(const WorldState& world, const TimeSpan& span) {
  std::vector<bool> strained(world.bodies.size(), false);
  for (const PlacedLoad& placed : world.loads) {
    if (load_factor(placed.load, span) == 0) continue;
    std::vector<std::size_t> tets(world.bodies.size(), 0);
    for (const TetId tet : placed.tets) ++tets[world.elements.bodies[tet]];
    for (const BodyId id : bodies_under(world, placed))
      if (tets[id] < world.bodies[id].tets.size()) strained[id] = true;
  }
  return strained;
}

void add_load_forces(const WorldState& world, const TimeSpan& span, ExternalForces& forces) {
  add_dead_forces(world, span, forces);
  for (const std::vector<PressedFace>& faces : pressed_faces(world, span))
    add_pressure(faces, world.nodes.positions, forces.nodes, forces.edges);
}

void add_load(const WorldState& world, const PlacedLoad& placed, double factor, ExternalForces& forces) {
  add_dead_load(world, placed, factor, forces);
  std::vector<PressedFace> pressed;
  if (placed.load.kind == LoadKind::pressure)
    for (const SurfaceFace& face : placed.faces)
      pressed.push_back(pressed_face(world, face, factor * placed.load.pressure));
  add_pressure(pressed, world.nodes.positions, forces.nodes, forces.edges);
}

std::vector<std::vector<PressedFace>> pressed_faces(const WorldState& world, const TimeSpan& span) {
  std::vector<std::vector<PressedFace>> faces(world.bodies.size());
  for (const PlacedLoad& placed : world.loads) {
    const double pressure = load_factor(placed.load, span) * placed.load.pressure;
    if (pressure == 0) continue;
    for (const SurfaceFace& face : placed.faces)
      faces[world.elements.bodies[face.tet]].push_back(pressed_face(world, face, pressure));
  }
  return faces;
}

void add_pressure(std::span<const PressedFace> faces, std::span<const Vec3> positions, std::span<Vec3> forces,
                  std::span<Vec3> edge_forces) {
  for (const PressedFace& face : faces) {
    const Vec3 force = -face.pressure / 3 * area_vector(positions, face.nodes);
    add_to_face(face.nodes, face.edges, force, forces, edge_forces);
  }
}

void add_dead_forces(const WorldState& world, const TimeSpan& span, ExternalForces& forces) {
  for (const PlacedLoad& placed : world.loads)
    if (const double factor = load_factor(placed.load, span); factor != 0) add_dead_load(world, placed, factor, forces);
}

}  // namespace griffith
