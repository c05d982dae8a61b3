#include <gtest/gtest.h>

#include "sim/mesh/topology.h"
#include "tests/solver/cracked_wall.h"

namespace griffith {
namespace {

using testing::Damage;
using testing::ElasticBox;
using testing::Load;

constexpr ImplicitStep kFrameStep{.dt = 1.0 / 120, .relative_residual = 1e-3};

/// The most iterations that a body of a wall of about 10,000 tets needs under any load.
int max_iterations(BoxPattern pattern, Damage damage, double young_modulus, bool held) {
  const int across = pattern == BoxPattern::five_tet ? 32 : 28;
  ElasticBox wall = testing::cracked_wall(across, 2, pattern, damage, young_modulus, 1 + static_cast<unsigned>(damage));
  if (held)
    for (int i = 0; i < wall.mesh.node_count(); ++i)
      if (wall.mesh.rest_positions[i].y() < -0.999) wall.constraints[i] = NodeConstraint::held();
  int maximum = 0;
  for (const std::vector<TetId>& piece : connected_components(wall.mesh, wall.tets)) {
    ElasticSystem system(wall.mesh, piece, wall.constraints, wall.rows);
    wall.assemble(system, kFrameStep);
    for (Load load : {Load::impact, Load::random_velocities, Load::gravity}) {
      testing::apply(wall, load);
      const SolveReport report = wall.solve(system, kFrameStep);
      EXPECT_TRUE(report.converged);
      maximum = std::max(maximum, report.iterations);
    }
  }
  return maximum;
}

TEST(IterationBound, HoldsForEveryStiffnessAndCrack) {
  for (BoxPattern pattern : {BoxPattern::five_tet, BoxPattern::kuhn})
    for (Damage damage : {Damage::intact, Damage::half_cracked, Damage::in_two, Damage::in_sixteen})
      for (double young_modulus : {1e6, 1e8, 3e10, 4e11})
        for (bool held : {false, true})
          EXPECT_LE(max_iterations(pattern, damage, young_modulus, held), 40)
              << "pattern " << static_cast<int>(pattern) << ", damage " << static_cast<int>(damage) << ", E "
              << young_modulus << (held ? ", held" : ", free");
}

}  // namespace
}  // namespace griffith
