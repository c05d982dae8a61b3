#pragma once

#include <cmath>
#include <map>

#include "tests/random_values.h"
#include "tests/solver/elastic_box.h"

namespace griffith::testing {

enum class Damage { intact, half_cracked, in_two, in_sixteen };

/// Which side of the cracks a tet is on, as far as a node of it is concerned: nodes are shared within a side alone.
inline int side_of_cracks(Damage damage, const Vec3& centroid, const Vec3& node) {
  if (damage == Damage::intact || (damage == Damage::half_cracked && node.y() <= 1e-9)) return 0;
  if (damage != Damage::in_sixteen) return centroid.x() > 0;
  return static_cast<int>(std::floor(2 * centroid.x())) + 4 * static_cast<int>(std::floor(2 * centroid.y()));
}

/// Separates a soup along x = 0 for y > 0, along all of x = 0, or along the planes between 4 × 4 pieces of half a
/// meter.
inline TetSoup crack(const TetSoup& whole, Damage damage) {
  TetSoup soup;
  std::map<std::pair<int, int>, int> copies;
  for (std::array<int, 4> tet : whole.tets) {
    Vec3 centroid = Vec3::Zero();
    for (int node : tet) centroid += whole.points[node] / 4;
    for (int& node : tet) {
      const auto key = std::pair(node, side_of_cracks(damage, centroid, whole.points[node]));
      const auto [copy, is_new] = copies.try_emplace(key, static_cast<int>(soup.points.size()));
      if (is_new) soup.points.push_back(Vec3(whole.points[node]));
      node = copy->second;
    }
    soup.tets.push_back(tet);
  }
  return soup;
}

/// A wall of 2 × 2 m, `across` × `across` × `through` cells, whose cells stay cubes; turned by a random angle.
inline ElasticBox cracked_wall(int across, int through, BoxPattern pattern, Damage damage, double young_modulus,
                               unsigned seed) {
  const double cell = 2.0 / across;
  ElasticBox wall(crack(make_box(Vec3(2, 2, through * cell), Vec3::Constant(cell), pattern), damage), young_modulus);
  RandomValues random(seed);
  const Mat3 rotation = random.rotation();
  for (Vec3& position : wall.positions) position = rotation * position;
  wall.update_states();
  return wall;
}

enum class Load { impact, random_velocities, gravity };

/// Sets the velocities and external forces of a load.
inline void apply(ElasticBox& wall, Load load) {
  RandomValues random(7);
  std::fill(wall.velocities.begin(), wall.velocities.end(), Vec3::Zero());
  std::fill(wall.forces.begin(), wall.forces.end(), Vec3::Zero());
  for (int i = 0; i < wall.mesh.node_count(); ++i) {
    const Vec3& rest = wall.mesh.rest_positions[i];
    if (load == Load::random_velocities) wall.velocities[i] = random.vector();
    if (load == Load::gravity) wall.forces[i] = wall.masses[i] * Vec3(0, -9.81, 0);
    if (load == Load::impact && (rest - Vec3(0.2, 0.3, rest.z())).norm() < 0.1 && rest.z() > 0)
      wall.forces[i] = Vec3(1e3, -2e3, -1e4);
  }
}

}  // namespace griffith::testing
