#include "sim/fracture/crack_front.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "sim/elasticity/corner_traction.h"
#include "sim/elasticity/principal_stress.h"
#include "sim/mesh/topology.h"

namespace griffith {
namespace {

struct Side {
  TetId tet;
  std::array<int, 3> corners;
};

/// Returns the faces without a neighbor that contain a node.
void add_sides(const TetMesh& mesh, NodeId node, std::vector<Side>& sides) {
  for (const TetId tet : mesh.stars[node])
    for (int face = 0; face < 4; ++face)
      if (!mesh.neighbors[tet][face].valid() && mesh.tets[tet][face] != node) sides.push_back({tet, kTetFaces[face]});
}

/// Returns the corners of `second` that coincide with those of a face at rest; false if it has no such face.
bool coincide(const TetMesh& mesh, const Side& first, const Side& second, std::array<int, 3>& corners) {
  const auto place = [&](const Side& side, int i) -> const Vec3& {
    return mesh.rest_positions[mesh.tets[side.tet][side.corners[i]]];
  };
  for (int i = 0; i < 3; ++i) {
    int match = -1;
    for (int j = 0; j < 3; ++j)
      if (place(first, i) == place(second, j)) match = j;
    if (match < 0) return false;
    corners[i] = second.corners[match];
  }
  return true;
}

/// Returns the outward direction of a face, of any length.
Vec3 out_of(const Corners& tet, const std::array<int, 3>& corners) {
  const auto place = [&](int i) { return tet.col(corners[i]); };
  return (place(1) - place(0)).cross(place(2) - place(0));
}

/// Smallest cosines of the angle between a plane and an open face that counts as part of a crack along it, and by
/// which the sides of the tets beside it follow.
constexpr double kSameCrack = 0.3, kSamePlane = 0.8;

/// Returns 1 if the first side of an open face is the lower one, seen along a plane's normal, and -1 if it is the upper
/// one; 0 if the face is steeper against the plane than `least_cosine`.
int side_of(const Corners& first, const OpenFace& face, const Vec3& normal, double least_cosine) {
  const Vec3 out = out_of(first, face.first_corners);
  const double cosine = out.dot(normal) / out.norm();
  return std::abs(cosine) < least_cosine ? 0 : cosine > 0 ? 1 : -1;
}

std::ptrdiff_t index_in(const std::vector<TetId>& star, TetId tet) {
  return std::ranges::lower_bound(star, tet) - star.begin();
}

/// Returns the force that holds the sides together, from the lower to the upper one [N]; both accelerate alike.
Vec3 reaction(const TetMesh& mesh, const std::vector<TetId>& star, std::span<const Vec3> forces,
              std::span<const std::uint8_t> above) {
  std::array<Vec3, 2> sums = {Vec3::Zero(), Vec3::Zero()};
  std::array<double, 2> volumes{};
  for (std::size_t i = 0; i < star.size(); ++i) {
    sums[above[i]] += forces[i];
    volumes[above[i]] += rest_volume(mesh, star[i]);
  }
  return (volumes[0] * sums[1] - volumes[1] * sums[0]) / (volumes[0] + volumes[1]);
}

/// Returns the sides of the plane through `place`, by centroids.
std::vector<std::uint8_t> sides_of_plane(std::span<const Corners> star, const Vec3& normal, const Vec3& place) {
  std::vector<std::uint8_t> above;
  for (const Corners& tet : star) above.push_back(normal.dot(tet.rowwise().mean() - place) > 0);
  return above;
}

/// As sides_of_crack(), with the open faces at the node.
std::vector<std::uint8_t> sides_along(const TetMesh& mesh, NodeId node, std::span<const Corners> star,
                                      const Vec3& normal, const Vec3& offset, std::span<const OpenFace> faces) {
  const Vec3 place = star[0].col(local_corner(mesh, mesh.stars[node][0], node));
  std::vector<std::uint8_t> above = sides_of_plane(star, normal, place + offset);
  if (std::ranges::adjacent_find(above, std::ranges::not_equal_to()) == above.end())
    above = sides_of_plane(star, normal, place);
  for (const OpenFace& face : faces) {
    const auto first = index_in(mesh.stars[node], face.first), second = index_in(mesh.stars[node], face.second);
    const int side = side_of(star[first], face, normal, kSamePlane);
    if (side == 0) continue;
    above[first] = side < 0;
    above[second] = side > 0;
  }
  return above;
}

}  // namespace

std::vector<OpenFace> open_faces_at(const TetMesh& mesh, std::span<const NodeId> nodes) {
  std::vector<Side> sides;
  for (const NodeId node : nodes) add_sides(mesh, node, sides);
  std::vector<OpenFace> faces;
  for (std::size_t i = 0; i < sides.size(); ++i)
    for (std::size_t j = i + 1; j < sides.size(); ++j) {
      OpenFace face{sides[i].tet, sides[j].tet, sides[i].corners, {}};
      if (coincide(mesh, sides[i], sides[j], face.second_corners)) faces.push_back(face);
    }
  return faces;
}

Vec3 third_of_face(const TetMesh& mesh, TetId tet, const std::array<int, 3>& corners) {
  const auto place = [&](int i) -> const Vec3& { return mesh.rest_positions[mesh.tets[tet][corners[i]]]; };
  return (place(1) - place(0)).cross(place(2) - place(0)) / 6;
}

Vec3 linked_area(const TetMesh& mesh, NodeId node, std::span<const std::uint8_t> above) {
  const std::vector<TetId>& star = mesh.stars[node];
  Vec3 area = Vec3::Zero();
  for (std::size_t i = 0; i < star.size(); ++i)
    for (int face = 0; face < 4 && above[i] == 0; ++face) {
      const TetId next = mesh.neighbors[star[i]][face];
      if (next.valid() && mesh.tets[star[i]][face] != node && above[index_in(star, next)] != 0)
        area += third_of_face(mesh, star[i], kTetFaces[face]);
    }
  return area;
}

std::vector<std::uint8_t> sides_of_crack(const TetMesh& mesh, NodeId node, std::span<const Corners> star,
                                         const Vec3& normal, const Vec3& offset) {
  return sides_along(mesh, node, star, normal, offset, open_faces_at(mesh, std::span(&node, 1)));
}

Vec3 corner_force(const RestElement& rest, const ElementState& state, int corner) {
  const auto traction = corner_traction(rest, state, corner);
  return -rest.volume * Vec3(traction[0], traction[1], traction[2]);
}

namespace {

/// Returns the energy release rate of a crack across the plane with `normal` [J/m²]. `faces`: the open ones at the
/// node; `above`: per tet of the star, 1 on the upper side of the plane.
double release_between(const TetMesh& mesh, NodeId node, std::span<const Corners> star, std::span<const Vec3> forces,
                       const Vec3& normal, std::span<const OpenFace> faces, std::span<const std::uint8_t> above,
                       std::span<const HeldNode> held) {
  const std::vector<TetId>& tets = mesh.stars[node];
  Vec3 area = linked_area(mesh, node, above), opening = Vec3::Zero();
  double weight = 0, by_bonds = 0;
  for (const OpenFace& face : faces) {
    const Corners &first = star[index_in(tets, face.first)], &second = star[index_in(tets, face.second)];
    const int sign = side_of(first, face, normal, kSameCrack);
    if (sign == 0) continue;
    const Vec3 third = third_of_face(mesh, face.first, face.first_corners);
    area += sign * third;
    for (int i = 0; i < 3; ++i) {
      const int a = face.first_corners[i], b = face.second_corners[i];
      if (mesh.tets[face.first][a] == mesh.tets[face.second][b]) continue;
      const Vec3 apart = second.col(b) - first.col(a);
      const HeldNode bonds = held.empty() ? HeldNode() : held[mesh.tets[face.first][a]];
      const double part = bonds.taken * third.norm();
      opening += sign * part * apart;
      by_bonds += part * apart.norm() * bonds.traction;
      weight += part;
    }
  }
  if (weight == 0 || area.isZero(0)) return 0;
  const double at_node = 0.5 * reaction(mesh, tets, forces, above).dot(opening) / (weight * area.norm());
  return at_node > 0 ? at_node + 0.5 * by_bonds / weight : 0;
}

/// Returns the unit normal of the open faces at a node, as they are now.
Vec3 normal_of_faces(const TetMesh& mesh, NodeId node, std::span<const Corners> star, std::span<const OpenFace> faces) {
  Vec3 sum = Vec3::Zero();
  for (const OpenFace& face : faces) {
    const Vec3 out = out_of(star[index_in(mesh.stars[node], face.first)], face.first_corners);
    sum += sum.dot(out) < 0 ? Vec3(-out) : out;
  }
  return sum.normalized();
}

}  // namespace

CrackAdvance best_advance(const TetMesh& mesh, NodeId node, std::span<const Corners> star, std::span<const Vec3> forces,
                          const Vec3& normal, const Vec3& offset, std::span<const HeldNode> held) {
  constexpr double kClearly = 1.25;  // rates of single nodes scatter by 15 % in each direction
  constexpr double kOpening = 0.9;   // cosine of 26° between force and normal: sheared cracks kink
  const std::vector<OpenFace> faces = open_faces_at(mesh, std::span(&node, 1));
  if (faces.empty()) return {normal, 0};
  const auto sides = [&](const Vec3& plane) { return sides_along(mesh, node, star, plane, offset, faces); };
  const CrackAdvance across{normal, release_between(mesh, node, star, forces, normal, faces, sides(normal), held)};
  const Vec3 straight = normal_of_faces(mesh, node, star, faces);
  const std::vector<std::uint8_t> above = sides(straight);
  const Vec3 pull = reaction(mesh, mesh.stars[node], forces, above);
  if (pull.dot(straight) < kOpening * pull.norm()) return across;
  const double rate = release_between(mesh, node, star, forces, straight, faces, above, held);
  return rate > kClearly * across.energy_release ? CrackAdvance{straight, rate} : across;
}

namespace {

/// Area of a plane through a node over that of a crack, whose sides are whole tets.
constexpr double kPlanesArea = 1.5;

/// Returns a bound of the area of planes through a node [m²]: with a normal n it is ½ Σ |a·n| of the thirds a of the
/// faces opposite the node, at least the smallest eigenvalue of ½ Σ a aᵀ / |a|.
double least_plane_area(const TetMesh& mesh, NodeId node) {
  Mat3 sum = Mat3::Zero();
  for (const TetId tet : mesh.stars[node])
    sum += 0.5 * force_dyad(third_of_face(mesh, tet, kTetFaces[local_corner(mesh, tet, node)]));
  return -largest_principal(-sum).value;
}

/// Returns the forces on a node beyond those that accelerate all its tets alike [N].
std::vector<Vec3> relative_forces(const TetMesh& mesh, NodeId node, std::span<const Vec3> forces) {
  const std::vector<TetId>& star = mesh.stars[node];
  Vec3 total = Vec3::Zero();
  std::vector<double> volumes;
  double volume = 0;
  for (std::size_t i = 0; i < star.size(); ++i) {
    total += forces[i];
    volume += volumes.emplace_back(rest_volume(mesh, star[i]));
  }
  std::vector<Vec3> relative;
  for (std::size_t i = 0; i < star.size(); ++i) relative.push_back(forces[i] - volumes[i] / volume * total);
  return relative;
}

}  // namespace

double energy_release_bound(const TetMesh& mesh, NodeId node, std::span<const Corners> star,
                            std::span<const Vec3> forces) {
  const std::vector<Vec3> relative = relative_forces(mesh, node, forces);
  double most = 0;
  for (const OpenFace& face : open_faces_at(mesh, std::span(&node, 1))) {
    const Corners &first = star[index_in(mesh.stars[node], face.first)],
                  &second = star[index_in(mesh.stars[node], face.second)];
    for (int i = 0; i < 3; ++i) {
      const Vec3 opening = second.col(face.second_corners[i]) - first.col(face.first_corners[i]);
      double work = 0;
      for (const Vec3& force : relative) work += std::max(0.0, force.dot(opening));
      most = std::max(most, work);
    }
  }
  return most > 0 ? 0.5 * most * kPlanesArea / least_plane_area(mesh, node) : 0;
}

}  // namespace griffith
