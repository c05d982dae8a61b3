#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "sim/elasticity/quadratic_element.h"
#include "sim/explicit/explicit_bodies.h"
#include "sim/mesh/box_mesh.h"
#include "sim/mesh/tet_edges.h"
#include "sim/mesh/topology.h"

namespace griffith::explicit_dynamics {
namespace {

using Field = std::function<Vec3(const Vec3&)>;

/// A mesh of quadratic tets as explicit bodies, and what it was made of.
struct QuadraticBox {
  TetMesh mesh;
  TetEdges topology;
  std::vector<RestElement> rest_elements;
  std::vector<double> masses, edge_masses;
  Material material;
  ExplicitBodies bodies;

  QuadraticBox(const TetSoup& soup, const Material& of, const Field& place, const Vec3& velocity = Vec3::Zero())
      : mesh(build_mesh(soup)), material(of) {
    std::vector<TetId> all;
    for (const TetId tet : IdRange<TetId>(0, mesh.tet_count())) all.push_back(tet);
    add_edges(mesh, all, topology);
    masses.resize(mesh.rest_positions.size(), 0);
    edge_masses.resize(topology.ends.size(), 0);
    std::vector<std::array<int, 4>> tets;
    std::vector<std::array<int, 6>> edges;
    for (const TetId tet : all) {
      Corners corners;
      std::array<int, 4>& of_tet = tets.emplace_back();
      for (int i = 0; i < 4; ++i) {
        of_tet[i] = mesh.tets[tet][i].index();
        corners.col(i) = mesh.rest_positions[of_tet[i]];
      }
      rest_elements.push_back(rest_element(corners));
      const double mass = material.density * rest_elements.back().volume;
      for (const NodeId node : mesh.tets[tet]) masses[node] += mass / 4;
      std::array<int, 6>& of_edges = edges.emplace_back();
      for (int i = 0; i < 6; ++i) {
        of_edges[i] = topology.of_tet[tet][i].index();
        edge_masses[of_edges[i]] += mass;
      }
    }
    for (std::size_t i = 0; i < masses.size(); ++i) {
      const Vec3& rest = mesh.rest_positions[i];
      bodies.add_node({rest, place(rest) - rest, velocity, Vec3::Zero(), masses[i]});
    }
    for (std::size_t i = 0; i < edge_masses.size(); ++i)
      bodies.add_edge({.offset = offset_of(i, place), .mass = edge_masses[i]});
    bodies.add_body(elastic_law(material), material.density, tets, rest_elements,
                    std::vector<Mat3>(tets.size(), Mat3::Zero()), std::numeric_limits<double>::infinity(), edges);
    bodies.finish();
    bodies.set_step(bodies.stable_step(0.9));
  }

  Vec3 offset_of(std::size_t edge, const Field& place) const {
    const Vec3 &a = mesh.rest_positions[topology.ends[edge][0]], &b = mesh.rest_positions[topology.ends[edge][1]];
    return place((a + b) / 2) - (place(a) + place(b)) / 2;
  }
  QuadraticStates states(TetId tet) const {
    Corners corners;
    EdgeVectors offsets;
    for (int i = 0; i < 4; ++i) corners.col(i) = bodies.position(mesh.tets[tet][i].index());
    for (int i = 0; i < 6; ++i) offsets.col(i) = bodies.edge_offset(topology.of_tet[tet][i].index());
    return quadratic_states(elastic_law(material), rest_elements[tet], corners, offsets);
  }
  double energy() const {
    double sum = 0;
    for (int i = 0; i < bodies.node_count(); ++i) sum += 0.5 * masses[i] * bodies.velocity(i).squaredNorm();
    for (int i = 0; i < bodies.edge_count(); ++i) sum += 0.5 * edge_masses[i] * bodies.edge_velocity(i).squaredNorm();
    for (const TetId tet : IdRange<TetId>(0, mesh.tet_count()))
      sum += rest_elements[tet].volume * states(tet).mean.energy_density;
    return sum;
  }
  void advance(int steps) {
    std::vector<int> flagged;
    for (int i = 0; i < steps; ++i) {
      bodies.compute_forces();
      bodies.advance(1, flagged);
    }
  }
};

/// Turned by half a radian and strained by about that, linearly.
Vec3 strained_by(double strain, const Vec3& rest) {
  const Vec3 strained = rest + strain * Vec3(rest.x() * rest.y(), 0.5 * rest.z() * rest.z() - rest.y(), rest.x());
  return Eigen::AngleAxisd(0.5, Vec3(1, 2, 3).normalized()) * strained + Vec3(4, 5, 6);
}
Vec3 curved(const Vec3& rest) { return strained_by(1e-3, rest); }
/// So strongly that quadratic tets bend and twist within themselves.
Vec3 folded(const Vec3& rest) { return strained_by(0.3, rest); }

/// Expects the accelerations to be those of the elements in double precision.
void expect_exact_accelerations(const Material& material, const Field& place) {
  QuadraticBox box(make_box(Vec3(1, 1, 0.5), Vec3::Constant(0.25), BoxPattern::five_tet), material, place);
  std::vector<Vec3> forces(box.masses.size(), Vec3::Zero()), edge_forces(box.edge_masses.size(), Vec3::Zero());
  double largest = 0;
  for (const TetId tet : IdRange<TetId>(0, box.mesh.tet_count())) {
    const QuadraticForces of_element = quadratic_forces(box.rest_elements[tet], box.states(tet).state);
    for (int i = 0; i < 4; ++i) forces[box.mesh.tets[tet][i]] += of_element.corners.col(i);
    for (int i = 0; i < 6; ++i) edge_forces[box.topology.of_tet[tet][i]] += of_element.edges.col(i);
    largest = std::max(largest, of_element.corners.norm());
  }
  const double dt = box.bodies.stable_step(0.9);
  box.advance(1);
  for (std::size_t i = 0; i < forces.size(); ++i)
    EXPECT_LT((box.bodies.velocity(i) * box.masses[i] / dt - forces[i]).norm(), 1e-3 * largest) << "node " << i;
  for (std::size_t i = 0; i < edge_forces.size(); ++i)
    EXPECT_LT((box.bodies.edge_velocity(i) * box.edge_masses[i] / dt - edge_forces[i]).norm(), 1e-3 * largest)
        << "edge " << i;
}

class QuadraticModels : public ::testing::TestWithParam<ElementModel> {
 protected:
  Material material() const {
    Material material;
    material.element_model = GetParam();
    return material;
  }
};
INSTANTIATE_TEST_SUITE_P(Models, QuadraticModels,
                         ::testing::Values(ElementModel::corotational, ElementModel::green_strain));

TEST_P(QuadraticModels, AccelerationsAreThoseOfTheElementsInDoublePrecision) {
  expect_exact_accelerations(material(), curved);
}

/// The rotation of a corotational frame does work to second order in the strain.
TEST_P(QuadraticModels, AccelerationsAreExactUnderLargeStrain) { expect_exact_accelerations(material(), folded); }

/// At nine tenths of the stable step.
TEST_P(QuadraticModels, LoseWhatViscosityTakesAndGainNothing) {
  QuadraticBox box(make_box(Vec3(1, 1, 0.1), Vec3(0.25, 0.25, 0.1), BoxPattern::kuhn), material(), curved);
  const double start = box.energy();
  double before = start;
  for (int i = 0; i < 20; ++i) {
    box.advance(20);
    EXPECT_LT(box.energy(), 1.02 * before);
    before = box.energy();
  }
  EXPECT_LT(before, start);
}

/// A ball that sticks to the middle of a free pane of glass, 1 m wide, 6 mm thick, 0.1 kg at 30 m/s. An infinite plate
/// takes its speed as exp(−Zt/m), Z = 8 √(Dρh), until waves come back from the edges (Zener 1941).
TEST(QuadraticPane, TakesTheSpeedOfABallAsAPlateDoes) {
  const double thickness = 0.006, mass = 0.1, speed = 30, time = 400e-6;
  const Material glass = *find_material_preset("soda_lime_glass");
  const double bending =
      glass.young_modulus * std::pow(thickness, 3) / 12 / (1 - glass.poisson_ratio * glass.poisson_ratio);
  const double impedance = 8 * std::sqrt(bending * glass.density * thickness);
  const double exact = mass * speed / impedance * (1 - std::exp(-impedance * time / mass));
  for (const auto& [cells, tolerance] : {std::pair(20, 0.5), std::pair(40, 0.12)}) {
    const TetSoup soup = make_box(Vec3(1, 1, thickness), Vec3(1.0 / cells, 1.0 / cells, thickness), BoxPattern::kuhn);
    QuadraticBox pane(soup, glass, [](const Vec3& rest) { return rest; });
    int middle = 0;
    const auto distance = [&](int i) { return (pane.mesh.rest_positions[i] - Vec3(0, 0, thickness / 2)).norm(); };
    for (int i = 0; i < pane.bodies.node_count(); ++i)
      if (distance(i) < distance(middle)) middle = i;
    const double own = pane.masses[middle];
    pane.bodies.node(middle).inverse_mass = 1 / (own + mass);
    pane.bodies.push(middle, Vec3(0, 0, -mass * speed));
    const int steps = static_cast<int>(std::ceil(time / pane.bodies.stable_step(0.8)));
    pane.bodies.set_step(time / steps);
    pane.advance(steps);
    EXPECT_NEAR(-pane.bodies.displacement(middle).z() / exact, 1, tolerance) << cells;
    RecordProperty("deflection_" + std::to_string(cells),
                   std::to_string(-pane.bodies.displacement(middle).z() / exact));
  }
}

/// Stresses are asked for where nodes are to be flagged; forces do not depend on it.
TEST_P(QuadraticModels, MoveAlikeWithoutStresses) {
  const TetSoup soup = make_box(Vec3(1, 1, 0.5), Vec3::Constant(0.25), BoxPattern::five_tet);
  QuadraticBox with(soup, material(), curved), without(soup, material(), curved);
  std::vector<int> flagged;
  for (int i = 0; i < with.bodies.node_count(); ++i)
    with.bodies.node(i).threshold = without.bodies.node(i).threshold = 1;
  with.bodies.compute_forces();
  with.bodies.advance(1, flagged);
  EXPECT_FALSE(flagged.empty());
  without.bodies.compute_forces(false);
  without.bodies.advance(1, flagged);
  EXPECT_TRUE(flagged.empty());
  for (int i = 0; i < with.bodies.node_count(); ++i) EXPECT_EQ(with.bodies.velocity(i), without.bodies.velocity(i));
}

/// A corner that keeps a flat tet of a star has little mass for its stiffness: the microstep becomes shorter, and
/// motion stays bounded.
TEST(QuadraticSolid, ShortensItsMicrostepWhereItParts) {
  const auto place = [](const Vec3& rest) { return curved(rest); };
  TetSoup soup = make_box(Vec3(3, 3, 3), Vec3::Ones(), BoxPattern::kuhn);
  int middle = 0;
  for (int i = 0; i < static_cast<int>(soup.points.size()); ++i)
    if (soup.points[i].norm() < soup.points[middle].norm()) middle = i;
  soup.points[middle].x() += 0.9;
  QuadraticBox box(soup, Material(), place);
  const std::span<const int> star = box.bodies.star(middle);
  const auto volume = [&](int entry) { return box.rest_elements[entry / 4].volume; };
  const int smallest = *std::ranges::min_element(star, {}, volume);
  std::vector<int> others(star.begin(), star.end());
  std::erase(others, smallest);
  const double before = box.bodies.stable_step(0.5), mass = box.material.density * volume(smallest) / 4;
  EXPECT_FALSE(box.bodies.raise_frequencies());
  const int copy = box.bodies.copy_node(middle, mass);
  box.masses[middle] -= mass;
  box.masses.push_back(mass);
  box.bodies.node(middle).inverse_mass = 1 / box.masses[middle];
  box.bodies.part(middle, std::array{copy}, std::array{others, std::vector{smallest}});
  EXPECT_TRUE(box.bodies.raise_frequencies());
  EXPECT_LT(box.bodies.stable_step(0.5), 0.9 * before);
  box.bodies.set_step(box.bodies.stable_step(0.5));
  const auto kinetic = [&] {
    double sum = 0;
    for (int i = 0; i < box.bodies.node_count(); ++i) sum += 0.5 * box.masses[i] * box.bodies.velocity(i).squaredNorm();
    return sum;
  };
  box.advance(200);
  const double early = kinetic();
  box.advance(2000);
  EXPECT_LT(kinetic(), 2 * early);
}

/// An edge that is tied to a held one is held as well: neither moves, and what that takes is counted.
TEST(QuadraticSolid, HoldsEdgesThatAreTiedToHeldOnes) {
  QuadraticBox box(make_box(Vec3(2, 1, 1), Vec3::Ones(), BoxPattern::five_tet), Material(), curved);
  box.advance(20);
  box.bodies.constrain_edge(0, Vec3(1, 0, 0).asDiagonal());
  const auto energy = [&](int edge) {
    return 0.5 * box.edge_masses[edge] * box.bodies.edge_velocity(edge).squaredNorm();
  };
  const double before = energy(0) + energy(1);
  const std::array<std::pair<int, int>, 1> pair = {std::pair(0, 1)};
  const double lost = box.bodies.tie_edges(pair);
  EXPECT_NEAR(before - energy(0) - energy(1), lost, 1e-9 * before);
  const Vec3 first = box.bodies.edge_offset(0), second = box.bodies.edge_offset(1);
  box.advance(20);
  for (const Vec3& moved : {Vec3(box.bodies.edge_offset(0) - first), Vec3(box.bodies.edge_offset(1) - second)}) {
    EXPECT_NE(moved.x(), 0);
    EXPECT_EQ(moved.tail<2>(), Vec2::Zero());
  }
}

/// Edges of a body that was parted go on with the forces of their own tets.
TEST(QuadraticSolid, PartsEdges) {
  const Material material;
  QuadraticBox box(make_box(Vec3(2, 1, 1), Vec3::Ones(), BoxPattern::five_tet), material, curved);
  int edge = 0;  // one that several tets share
  const auto entries_of = [&](int index) {
    std::vector<int> entries;
    for (int tet = 0; tet < box.mesh.tet_count(); ++tet)
      for (int i = 0; i < 6; ++i)
        if (box.topology.of_tet[TetId(tet)][i].index() == index) entries.push_back(box.bodies.edge_entry(tet, i));
    return entries;
  };
  while (entries_of(edge).size() < 2) ++edge;
  const std::vector<int> entries = entries_of(edge);
  const int copy = box.bodies.copy_edge(edge, box.edge_masses[edge]);
  box.bodies.part_edge(
      edge, std::array{copy},
      std::array<std::vector<int>, 2>{std::vector<int>{entries[0]}, {entries.begin() + 1, entries.end()}});
  EXPECT_EQ(box.bodies.edge_offset(copy), box.bodies.edge_offset(edge));
  EXPECT_EQ(box.bodies.edge(edge).count, 1);
  EXPECT_EQ(box.bodies.edge(copy).count, static_cast<int>(entries.size()) - 1);
  box.advance(1);
  EXPECT_NE(box.bodies.edge_velocity(copy), box.bodies.edge_velocity(edge));
}

}  // namespace
}  // namespace griffith::explicit_dynamics
