#include "sim/elasticity/quadratic_frequency.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sim/core/tet_edge_corners.h"
#include "sim/elasticity/quadratic_stiffness.h"
#include "sim/mesh/box_mesh.h"
#include "sim/mesh/tet_edges.h"
#include "sim/mesh/topology.h"
#include "tests/random_values.h"

namespace griffith {
namespace {

using testing::RandomValues;

/// Degrees of freedom of corners, then edges.
using Field = Eigen::Matrix3Xd;

/// A mesh of quadratic elements at rest with the masses of microsteps.
struct Vibrating {
  Material material;
  TetMesh mesh;
  TetEdges topology;
  std::vector<RestElement> rest_elements;
  std::vector<std::array<int, 4>> corners;
  std::vector<std::array<int, 6>> edges;
  Eigen::RowVectorXd masses;

  explicit Vibrating(const TetSoup& soup, double poisson_ratio) : mesh(build_mesh(soup)) {
    material.poisson_ratio = poisson_ratio;
    const auto nodes = static_cast<int>(mesh.rest_positions.size());
    std::vector<TetId> all;
    for (const TetId tet : IdRange<TetId>(0, mesh.tet_count())) all.push_back(tet);
    add_edges(mesh, all, topology);
    masses = Eigen::RowVectorXd::Zero(nodes + topology.edge_count());
    for (const TetId tet : all) {
      Corners places;
      for (int i = 0; i < 4; ++i) {
        places.col(i) = mesh.rest_positions[mesh.tets[tet][i]];
        corners.resize(tet.index() + 1);
        corners.back()[i] = mesh.tets[tet][i].index();
      }
      rest_elements.push_back(rest_element(places));
      const double mass = material.density * rest_elements.back().volume;
      for (const int corner : corners.back()) masses[corner] += mass / 4;
      for (int i = 0; i < 6; ++i) {
        edges.resize(tet.index() + 1);
        edges.back()[i] = topology.of_tet[tet][i].index();
        masses[nodes + edges.back()[i]] += mass;
      }
    }
  }

  int index(std::size_t element, int i) const {
    return i < 4 ? corners[element][i] : static_cast<int>(mesh.rest_positions.size()) + edges[element][i - 4];
  }
  Field stiffness_times(const Field& field) const {
    Field product = Field::Zero(3, field.cols());
    const ElementState rest_state;
    for (std::size_t e = 0; e < rest_elements.size(); ++e)
      for (int row = 0; row < 10; ++row) {
        const auto blocks = quadratic_stiffness_row(elastic_law(material), rest_elements[e], rest_state, row);
        for (int j = 0; j < 10; ++j) product.col(index(e, row)) += blocks.block(j) * field.col(index(e, j));
      }
    return product;
  }
  /// Returns the highest frequency by power iteration, from below [rad/s].
  double highest() const {
    RandomValues random(1);
    Field field(3, masses.size());
    for (int i = 0; i < field.cols(); ++i) field.col(i) = random.vector(1);
    double square = 0;
    for (int i = 0; i < 60; ++i) {
      Field next = stiffness_times(field);
      const double mass_norm = (field.array().square().rowwise() * masses.array()).sum();
      square = field.cwiseProduct(next).sum() / mass_norm;
      next.array().rowwise() /= masses.array();
      field = next / next.norm();
    }
    return std::sqrt(square);
  }
  double bound() const {
    return highest_quadratic_frequency(elastic_law(material), material.density, rest_elements, corners, edges);
  }
};

TetSoup shaken(TetSoup soup, double size) {
  RandomValues random(2);
  for (Vec3& point : soup.points) point += random.vector(size);
  return soup;
}

/// No frequency of a mesh exceeds the bound, which is close.
TEST(QuadraticFrequency, BoundsRegularMeshesClosely) {
  for (const double poisson_ratio : {0.0, 0.22, 0.45})
    for (const BoxPattern pattern : {BoxPattern::five_tet, BoxPattern::kuhn})
      for (const double thickness : {1.0, 0.1}) {
        const Vibrating box(make_box(Vec3(3, 3, thickness), Vec3(1, 1, thickness), pattern), poisson_ratio);
        const double ratio = box.bound() / box.highest();
        EXPECT_GT(ratio, 1);
        EXPECT_LT(ratio, pattern == BoxPattern::five_tet && poisson_ratio < 0.3 ? 1.3 : 1.6);
      }
}

/// Meshes that were shaken may exceed it by their few stiffest elements.
TEST(QuadraticFrequency, BoundsIrregularMeshes) {
  const Vibrating box(shaken(make_box(Vec3(3, 3, 3), Vec3::Ones(), BoxPattern::kuhn), 0.2), 0.22);
  const double ratio = box.bound() / box.highest();
  EXPECT_GT(ratio, 1 / kFewOverMost);
  EXPECT_LT(ratio, 2);
}

}  // namespace
}  // namespace griffith
