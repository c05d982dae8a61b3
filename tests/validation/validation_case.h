#pragma once

#include <span>
#include <string>
#include <vector>

namespace griffith::validation {

/// Comparison of a result with its expected value.
enum class Check {
  near,      ///< no further than the tolerance from what is expected
  at_most,   ///< no larger than what is expected
  at_least,  ///< no smaller than what is expected
};

/// Which mesh a figure comes from.
struct MeshLabel {
  std::string pattern;     ///< "kuhn", "five_tet", "bcc", or "-" where no mesh is cut
  std::string resolution;  ///< "n = 4"
};

/// One figure with its closed form; all are ratios unless `quantity` names a unit.
struct Row {
  MeshLabel mesh;
  std::string quantity;
  double expected = 0, got = 0, tolerance = 0;
  Check check = Check::near;

  double error() const { return got - expected; }
  bool passes() const;
};

Row near(const MeshLabel& mesh, const std::string& quantity, double expected, double got, double tolerance);
Row at_most(const MeshLabel& mesh, const std::string& quantity, double limit, double got);
Row at_least(const MeshLabel& mesh, const std::string& quantity, double limit, double got);

/// Extent of refinement: seconds for tests, minutes for the table.
enum class Extent { test, table };

/// A known answer and the figures that the program gives.
struct Case {
  const char* name;   ///< for a test: letters alone
  const char* title;  ///< for the table
  const char* about;  ///< what is compared with what, a sentence or two
  std::vector<Row> (*run)(Extent extent);
};

/// All cases, in the order of the table.
std::span<const Case> cases();

// Each runs one case; cases.cpp says what about.
std::vector<Row> affine_deformation(Extent extent);
std::vector<Row> rigid_motion(Extent extent);
std::vector<Row> difference_quotients(Extent extent);
std::vector<Row> cantilever_tip_load(Extent extent);
std::vector<Row> cantilever_gravity(Extent extent);
std::vector<Row> locking(Extent extent);
std::vector<Row> bar_in_tension(Extent extent);
std::vector<Row> three_point_bending(Extent extent);
std::vector<Row> plate_with_hole(Extent extent);
std::vector<Row> brazilian_disc(Extent extent);
std::vector<Row> longitudinal_wave(Extent extent);
std::vector<Row> free_fall(Extent extent);
std::vector<Row> mode_decay(Extent extent);
std::vector<Row> long_run(Extent extent);

}  // namespace griffith::validation
