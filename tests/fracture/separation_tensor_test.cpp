#include "sim/fracture/separation_tensor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

#include "sim/elasticity/principal_stress.h"
#include "sim/fracture/node_load_sums.h"
#include "sim/mesh/box_mesh.h"
#include "sim/mesh/topology.h"
#include "tests/random_values.h"

namespace griffith {
namespace {

using testing::RandomValues;

/// A box under a homogeneous deformation, ready for evaluation.
struct StressedBox {
  TetMesh mesh;
  std::vector<RestElement> rest_elements;
  std::vector<ElementState> states;
  std::vector<NodeConstraint> constraints;  // none: all are free

  StressedBox(BoxPattern pattern, int cells, const Mat3& deformation, double jitter = 0,
              ElementModel model = ElementModel::corotational) {
    TetSoup soup = make_box(Vec3(2, 1, 1), Vec3::Constant(1.0 / cells), pattern);
    RandomValues random(7);
    for (Vec3& point : soup.points)
      if (is_inside(point)) point += random.vector(jitter / cells);
    mesh = build_mesh(soup);
    Material material;
    material.young_modulus = 1e9;
    material.poisson_ratio = 0;
    material.element_model = model;
    for (int t = 0; t < mesh.tet_count(); ++t) {
      Corners rest, now;
      for (int i = 0; i < 4; ++i) {
        rest.col(i) = mesh.rest_positions[mesh.tets[t][i]];
        now.col(i) = deformation * rest.col(i);
      }
      rest_elements.push_back(rest_element(rest));
      states.push_back(element_state(elastic_law(material), element_deformation(model, rest_elements.back(), now)));
    }
  }
  static bool is_inside(const Vec3& p) {
    return std::abs(p.x()) < 0.99 && std::abs(p.y()) < 0.49 && std::abs(p.z()) < 0.49;
  }
  SeparationInput input() const { return {mesh.tets, mesh.stars, rest_elements, states, constraints}; }
  CandidatePlane plane(int node, const DirectionalStrength& strength = {}) const {
    return candidate_plane(input(), NodeId(node), separation_tensor(input(), NodeId(node)), strength);
  }
  /// True away from the ends, where the grips are.
  bool measured(int node) const { return std::abs(mesh.rest_positions[node].x()) < 0.99; }
};

constexpr double kStrain = 1e-3, kStress = 1e9 * kStrain;

TEST(SeparationTensor, TurnsWithTheBody) {
  RandomValues random(2);
  Mat3 deformation = Mat3::Identity() + random.matrix(1e-3);
  const StressedBox box(BoxPattern::kuhn, 2, deformation);
  for (int trial = 0; trial < 10; ++trial) {
    const Mat3 rotation = random.rotation();
    const StressedBox turned(BoxPattern::kuhn, 2, rotation * deformation);
    for (int node = 0; node < box.mesh.node_count(); ++node) {
      const Mat3 expected = rotation * separation_tensor(box.input(), NodeId(node)) * rotation.transpose();
      EXPECT_LT((separation_tensor(turned.input(), NodeId(node)) - expected).norm(), 1e-7 * expected.norm() + 1e-6);
    }
  }
}

TEST(SeparationStress, EqualsTheUniaxialStressOnEveryMesh) {
  const Mat3 stretch = Vec3(1 + kStrain, 1, 1).asDiagonal();
  RandomValues random(3);
  for (BoxPattern pattern : {BoxPattern::kuhn, BoxPattern::five_tet, BoxPattern::bcc})
    for (int cells : {2, 4})
      for (double jitter : {0.0, 0.15}) {
        const Mat3 rotation = random.rotation();
        const StressedBox bar(pattern, cells, rotation * stretch, jitter);
        for (int node = 0; node < bar.mesh.node_count(); ++node) {
          if (!bar.measured(node)) continue;
          const CandidatePlane plane = bar.plane(node);
          EXPECT_NEAR(plane.stress, kStress, 1e-5 * kStress);
          EXPECT_GT(std::abs(plane.normal.dot(rotation.col(0))), 1 - 1e-10) << "the load axis";
        }
      }
}

TEST(SeparationStress, IsTheTrueStressInLargeStretch) {
  // Green's strain of an extension to 1.5 is 0.625: S = 625 MPa, with unchanged cross sections F S = 937.5 MPa.
  const StressedBox bar(BoxPattern::five_tet, 3, Vec3(1.5, 1, 1).asDiagonal(), 0.1, ElementModel::green_strain);
  for (int node = 0; node < bar.mesh.node_count(); ++node) {
    if (!bar.measured(node)) continue;
    EXPECT_NEAR(bar.plane(node).stress, 937.5e6, 1e3);
  }
}

TEST(SeparationStress, IsExactInEquibiaxialAndHydrostaticTension) {
  for (const Vec3& strains : {Vec3(1, 1, 0), Vec3(1, 1, 1)}) {
    const Mat3 stretch = (Vec3::Ones() + kStrain * strains).asDiagonal();
    const StressedBox box(BoxPattern::five_tet, 3, stretch);
    for (int node = 0; node < box.mesh.node_count(); ++node) {
      EXPECT_GE(box.plane(node).stress, kStress * (1 - 1e-6));
    }
  }
}

TEST(SeparationTensor, PureCompressionSeparatesNothing) {
  const StressedBox box(BoxPattern::five_tet, 3, Vec3::Constant(1 - kStrain).asDiagonal());
  for (int node = 0; node < box.mesh.node_count(); ++node) {
    if (!StressedBox::is_inside(box.mesh.rest_positions[node])) continue;
    EXPECT_LT(principal_values(separation_tensor(box.input(), NodeId(node))).values[2], 1e-3);
  }
}

TEST(SeparationStress, ElementsOfAnAnchorDoNotDiluteIt) {
  // All nodes below x = 0 are supported. Those in that plane see only the stress of the free half.
  StressedBox bar(BoxPattern::bcc, 4, Vec3(1 + kStrain, 1, 1).asDiagonal());
  bar.constraints.assign(bar.mesh.node_count(), {});
  for (int node = 0; node < bar.mesh.node_count(); ++node)
    if (bar.mesh.rest_positions[node].x() < 1e-9) bar.constraints[node] = NodeConstraint::held();
  for (int tet = 0; tet < bar.mesh.tet_count(); ++tet)
    if (rest_centroid(bar.mesh, TetId(tet)).x() < 0) bar.states[tet] = {};
  int border = 0;
  for (int node = 0; node < bar.mesh.node_count(); ++node) {
    if (std::abs(bar.mesh.rest_positions[node].x()) > 1e-9) continue;
    ++border;
    EXPECT_NEAR(bar.plane(node).stress, kStress, 1e-5 * kStress);
  }
  EXPECT_GT(border, 4);
}

TEST(CandidatePlane, TakesTheWeakestDirectionUnderAUniaxialLoad) {
  // Hankinson (1921): the load at an angle a to the grain reaches 1/(cos²a + sin²a/ratio) of the strength along it.
  const StressedBox bar(BoxPattern::five_tet, 3, Vec3(1 + kStrain, 1, 1).asDiagonal(), 0.1);
  const int node = static_cast<int>(
      std::find_if(bar.mesh.rest_positions.begin(), bar.mesh.rest_positions.end(), StressedBox::is_inside) -
      bar.mesh.rest_positions.begin());
  for (double ratio : {0.03, 0.2, 1.0})
    for (double angle : {0.0, 0.2, 0.7, 1.5}) {
      const Vec3 axis(std::cos(angle), std::sin(angle), 0);
      const DirectionalStrength strength = directional_strength({WeaknessKind::grain, axis, ratio}, axis);
      const CandidatePlane plane = bar.plane(node, strength);
      const double expected = std::pow(std::cos(angle), 2) + std::pow(std::sin(angle), 2) / ratio;
      EXPECT_NEAR(plane.stress / strength.fraction(plane.normal), kStress * expected, 1e-4 * kStress * expected)
          << "ratio " << ratio << ", angle " << angle;
    }
}

TEST(SeparationTensor, SupportsAreNoShield) {
  // At the gripped end the reaction is missing from the element forces. Only without the totals does the node see its
  // load.
  StressedBox bar(BoxPattern::five_tet, 3, Vec3(1 + kStrain, 1, 1).asDiagonal());
  for (int node = 0; node < bar.mesh.node_count(); ++node) {
    if (bar.measured(node)) continue;
    const double free = principal_values(separation_tensor(bar.input(), NodeId(node))).values[2];
    bar.constraints.assign(bar.mesh.node_count(), {});
    bar.constraints[node] = NodeConstraint::held();
    const CandidatePlane held = bar.plane(node);
    EXPECT_GT(held.eigenvalue, 10 * std::abs(free));
    EXPECT_NEAR(held.stress, kStress, 1e-5 * kStress);
    bar.constraints.clear();
  }
}

void expect_same_plane(const CandidatePlane& a, const CandidatePlane& b) {
  const auto bits = [](double x) { return std::bit_cast<std::uint64_t>(x); };
  const std::array<double, 9> of_a = {a.normal.x(), a.normal.y(), a.normal.z(), a.eigenvalue, a.stress,
                                      a.pulled.x(), a.pulled.y(), a.pulled.z(), a.volume},
                              of_b = {b.normal.x(), b.normal.y(), b.normal.z(), b.eigenvalue, b.stress,
                                      b.pulled.x(), b.pulled.y(), b.pulled.z(), b.volume};
  for (std::size_t i = 0; i < of_a.size(); ++i)
    EXPECT_TRUE(bits(of_a[i]) == bits(of_b[i]) || (std::isnan(of_a[i]) && std::isnan(of_b[i]))) << i;
  EXPECT_EQ(a.by_tension, b.by_tension);
}

/// Nodes under stress, without any, in an anchor and without numbers, four side by side and one at a time.
TEST(CandidatePlane, OfFourSideBySideHasTheBitsOfOneAtATime) {
  RandomValues random(9);
  for (BoxPattern pattern : {BoxPattern::kuhn, BoxPattern::five_tet}) {
    StressedBox box(pattern, 3, Mat3::Identity() + random.matrix(1e-3), 0.15);
    const int count = box.mesh.node_count();
    box.constraints.assign(count, {});
    for (int node = 0; node < count / 4; ++node) box.constraints[node] = NodeConstraint::held();
    for (int tet = 0; tet < box.mesh.tet_count() / 3; ++tet) box.states[tet] = {};
    box.states.back().tension.xx = box.states.back().stress.xx = std::numeric_limits<double>::quiet_NaN();
    for (double ratio : {1.0, 0.1})
      for (int trial = 0; trial < 60; ++trial) {
        std::array<NodeId, 4> nodes;
        std::array<Mat3, 4> tensors;
        std::array<DirectionalStrength, 4> strengths;
        for (int lane = 0; lane < 4; ++lane) {
          nodes[lane] = trial == 0 ? NodeId(count - 1) : NodeId(random.index(count));
          tensors[lane] = separation_tensor(box.input(), nodes[lane]);
          strengths[lane] = {random.direction(), 1, lane == 3 ? 1 : ratio};
        }
        const std::array<CandidatePlane, 4> planes = candidate_planes(node_loads(box.input(), nodes), strengths);
        for (int lane = 0; lane < 4; ++lane)
          expect_same_plane(planes[lane], candidate_plane(box.input(), nodes[lane], tensors[lane], strengths[lane]));
      }
  }
}

/// Includes supported and sliding nodes, and those without stress or with NaN, in ranges as of threads.
TEST(NodeLoadSums, ElementByElementHaveTheBitsOfStarByStar) {
  RandomValues random(11);
  for (const ElementModel model : {ElementModel::corotational, ElementModel::green_strain}) {
    StressedBox box(BoxPattern::five_tet, 4, Mat3::Identity() + random.matrix(1e-3), 0.15, model);
    const int count = box.mesh.node_count();
    box.constraints.assign(count, {});
    for (int node = 0; node < count / 4; ++node) box.constraints[node] = NodeConstraint::held();
    for (int node = count / 4; node < count / 3; ++node)
      box.constraints[node] = NodeConstraint::sliding(random.direction());
    for (int tet = 0; tet < box.mesh.tet_count(); tet += 3) box.states[tet] = {};
    box.states.back().tension.xx = box.states.back().stress.xx = std::numeric_limits<double>::quiet_NaN();
    std::vector<TetId> tets;
    std::vector<NodeId> nodes;
    for (const TetId tet : IdRange<TetId>(0, box.mesh.tet_count())) tets.push_back(tet);
    for (const NodeId node : IdRange<NodeId>(0, count)) nodes.push_back(node);

    std::vector<NodeLoadSums> sums(count);
    for (int first = 0, last = 0; first < count; first = last) {
      last = std::min(count, first + 1 + random.index(count / 2));
      accumulate_node_loads(box.input(), tets, std::span(nodes).subspan(first, last - first), sums);
    }
    for (const NodeId node : nodes) {
      const Mat3 tensor = separation_tensor(box.input(), node);
      const NodeLoad load = sums[node].load();
      const bool same = std::memcmp(load.tensor.data(), tensor.data(), sizeof tensor) == 0;
      EXPECT_TRUE(same || !(tensor.allFinite() || load.tensor.allFinite())) << node.index();
      const CandidatePlane plane = candidate_planes({load, load, load, load}, {})[1];
      expect_same_plane(plane, candidate_plane(box.input(), node, tensor));
    }
  }
}

TEST(NodeLoadSums, LeaveOtherNodesAlone) {
  const StressedBox box(BoxPattern::kuhn, 2, Mat3::Identity() * (1 + kStrain));
  std::vector<TetId> tets;
  for (const TetId tet : IdRange<TetId>(0, box.mesh.tet_count())) tets.push_back(tet);
  std::vector<NodeLoadSums> sums(box.mesh.node_count());
  for (NodeLoadSums& star : sums) star.area = -1;
  const std::vector<NodeId> nodes = {NodeId(5), NodeId(6), NodeId(7)};
  accumulate_node_loads(box.input(), tets, nodes, sums);
  for (int node = 0; node < box.mesh.node_count(); ++node) EXPECT_EQ(sums[node].area > 0, node >= 5 && node <= 7);
}

/// The definition, dyad by dyad: elements are added two at a time, an odd one by itself.
TEST(SeparationTensor, IsTheSumOfItsDyads) {
  RandomValues random(10);
  const StressedBox box(BoxPattern::kuhn, 2, Mat3::Identity() + random.matrix(1e-3), 0.15);
  for (int node = 0; node < box.mesh.node_count(); ++node) {
    Mat3 sum = Mat3::Zero();
    SplitForce total;
    for (TetId tet : box.mesh.stars[node]) {
      const SplitForce force = split_force(box.input(), tet, NodeId(node));
      sum += force_dyad(force.tensile) - force_dyad(force.compressive);
      total.tensile += force.tensile;
      total.compressive += force.compressive;
    }
    sum -= force_dyad(total.tensile) - force_dyad(total.compressive);
    EXPECT_LT((separation_tensor(box.input(), NodeId(node)) - 0.5 * sum).norm(), 1e-12 * sum.norm() + 1e-9);
  }
}

}  // namespace
}  // namespace griffith
