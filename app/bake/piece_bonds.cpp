#include "app/bake/piece_bonds.h"

#include <algorithm>
#include <map>

#include "sim/fracture/strength_variation.h"
#include "sim/geometry/face_key.h"
#include "sim/meshing/surface.h"

namespace griffith::app {
namespace {

/// One side of a face opened by a crack.
struct OpenedFace {
  int object = 0, scene_body = 0;
  std::array<Vec3, 3> rest, first;  ///< corners at rest and in the first baked frame [m]
  double opened = 0;                ///< time of opening [s]
  double strength = 0;              ///< [Pa]
};

/// Returns the tensile strength across a tet's face, with scatter and weakness, as the mean of its corners [Pa].
double face_strength(const BondInput& input, TetId tet, int face, const Vec3& rest_normal) {
  const TetOrigin from = input.history.origin(0, tet);
  const std::array<NodeId, 4>& nodes = input.history.states()[0].tets[from.tet];
  double factor = 0;
  for (const int corner : kTetFaces[face])
    for (int i = 0; i < 4; ++i) factor += from.weights(i, corner) * input.strength_factors[nodes[i]] / 3;
  const int scene_body = input.last.bodies[input.last.elements.bodies[tet]].scene_body;
  const std::optional<Weakness>& weakness = input.last.weaknesses[scene_body];
  if (weakness) factor *= directional_strength(*weakness, weakness->direction).fraction(rest_normal);
  return factor * input.last.materials[scene_body].tensile_strength;
}

OpenedFace opened_face(const BondInput& input, TetId tet, int face) {
  const Frame& last = input.last;
  const Corners then = input.history.corners(1, tet);
  const BodyId body = last.elements.bodies[tet];
  OpenedFace opened{
      input.object_of_body[body], last.bodies[body].scene_body, {}, {}, last.elements.opened[tet][face], 0};
  for (int i = 0; i < 3; ++i) {
    opened.rest[i] = last.nodes.rest_positions[last.elements.tets[tet][kTetFaces[face][i]]];
    opened.first[i] = then.col(kTetFaces[face][i]);
  }
  opened.strength = face_strength(input, tet, face, area_vector(opened.rest).stableNormalized());
  return opened;
}

std::vector<OpenedFace> opened_faces(const BondInput& input) {
  std::vector<OpenedFace> faces;
  for (const TetId tet : IdRange<TetId>(0, std::ssize(input.last.elements.tets)))
    for (int face = 0; face < 4; ++face)
      if (input.last.elements.opened[tet][face] > input.opened_before) faces.push_back(opened_face(input, tet, face));
  return faces;
}

Vec3 middle_of(const std::array<Vec3, 3>& corners) { return (corners[0] + corners[1] + corners[2]) / 3; }

/// True if `face` lies back to back with `other`, with its center on it.
bool lies_on(const OpenedFace& face, const OpenedFace& other) {
  constexpr double kTolerance = 1e-6;  // fraction of the edge length
  if (face.scene_body != other.scene_body) return false;
  const Vec3 area = area_vector(other.rest), place = middle_of(face.rest);
  const double size = area.norm(), length = std::sqrt(size);
  if (area.dot(area_vector(face.rest)) >= 0) return false;
  if (std::abs(area.dot(place - other.rest[0])) > kTolerance * size * length) return false;
  for (int i = 0; i < 3; ++i)
    if (area_vector(std::array<Vec3, 3>{other.rest[i], other.rest[(i + 1) % 3], place}).dot(area) <
        -kTolerance * size * size)
      return false;
  return true;
}

/// Returns the opposite face of each; -1: unknown. Cracks leave two copies of a face with the same corners at rest.
std::vector<int> partners(std::span<const OpenedFace> faces) {
  std::map<std::pair<int, FaceKey>, int> waiting;
  std::vector<int> partner(faces.size(), -1);
  for (int i = 0; i < std::ssize(faces); ++i) {
    const auto [other, is_new] = waiting.try_emplace({faces[i].scene_body, face_key(faces[i].rest)}, i);
    if (is_new) continue;
    partner[i] = other->second, partner[other->second] = i;
    waiting.erase(other);
  }
  for (const auto& [key, i] : waiting)
    for (const auto& [other_key, k] : waiting)
      if (partner[i] < 0 && lies_on(faces[i], faces[k])) partner[i] = k;
  return partner;
}

/// Adds one side of an opened face: half of its area.
void add_face(BakedBond& bond, const OpenedFace& face) {
  const Vec3 area = area_vector(face.first) / 2;
  bond.area += area.norm();
  bond.center += area.norm() * middle_of(face.first);
  bond.normal += face.object == bond.a ? area : Vec3(-area);
  bond.strength += area.norm() * face.strength;
  bond.break_time = std::max(bond.break_time.value_or(face.opened), face.opened);
}

}  // namespace

std::vector<double> strength_factors_at_start(const Frame& start, const Scene& scene) {
  std::vector<double> factors(start.nodes.positions.size(), 1);
  std::vector<std::vector<NodeId>> nodes(scene.bodies.size());
  for (const NodeId node : IdRange<NodeId>(0, std::ssize(factors)))
    nodes[start.bodies[start.elements.bodies[start.nodes.stars[node].front()]].scene_body].push_back(node);
  for (std::size_t body = 0; body < nodes.size(); ++body) {
    if (!scene.bodies[body].strength_scatter) continue;
    std::vector<double> volumes;
    for (const NodeId node : nodes[body]) {
      volumes.push_back(0);
      for (const TetId tet : start.nodes.stars[node]) volumes.back() += start.elements.rest_elements[tet].volume / 4;
    }
    const std::vector<double> drawn = strength_factors(*scene.bodies[body].strength_scatter, volumes);
    for (std::size_t i = 0; i < drawn.size(); ++i) factors[nodes[body][i]] = drawn[i];
  }
  return factors;
}

std::vector<BakedBond> piece_bonds(const BondInput& input) {
  const std::vector<OpenedFace> faces = opened_faces(input);
  const std::vector<int> partner = partners(faces);
  std::map<std::pair<int, int>, BakedBond> found;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    if (partner[i] < 0 || faces[i].object == faces[partner[i]].object) continue;
    const std::pair<int, int> pair = std::minmax(faces[i].object, faces[partner[i]].object);
    BakedBond& bond =
        found.try_emplace(pair, BakedBond{pair.first, pair.second, 0, Vec3::Zero(), Vec3::Zero(), 0, {}}).first->second;
    add_face(bond, faces[i]);
  }
  std::vector<BakedBond> bonds;
  for (auto& [pair, bond] : found) {
    bond.center /= bond.area;
    bond.strength /= bond.area;
    bond.normal.stableNormalize();
    bonds.push_back(bond);
  }
  return bonds;
}

}  // namespace griffith::app
