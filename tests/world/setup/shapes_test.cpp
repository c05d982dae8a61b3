#include <gtest/gtest.h>

#include <numbers>

#include "sim/core/error.h"
#include "sim/mesh/mesh_report.h"
#include "sim/world/setup/shape_mesh.h"

namespace griffith {
namespace {

constexpr double kPi = std::numbers::pi;

double volume_of(const Shape& shape) {
  TetSoup soup = make_soup(shape, "");
  return prepare(soup).volume;
}

/// Each shape with its elements `fineness` times finer than it has them.
std::vector<std::pair<Shape, double>> shapes_and_volumes(double fineness, BoxPattern pattern) {
  BoxShape box;
  CylinderShape cylinder;
  DiscShape disc;
  SphereShape sphere;
  PlateWithHoleShape plate;
  NotchedBeamShape beam;
  const auto refine = [&](auto& shape) {
    shape.element_size /= fineness;
    shape.pattern = pattern;
  };
  refine(box), refine(cylinder), refine(disc), refine(sphere), refine(plate), refine(beam);
  return {{box, 1},
          {beam, 4 * 1 * 0.5},
          {cylinder, kPi * 0.25 * 2},
          {disc, kPi * 0.25 * 0.2},
          {sphere, kPi / 6},
          {plate, (4 - kPi * 0.04) * 0.1}};
}

TEST(Shapes, VolumesApproachTheClosedForms) {
  for (const BoxPattern pattern : {BoxPattern::kuhn, BoxPattern::five_tet, BoxPattern::bcc}) {
    const auto coarse = shapes_and_volumes(1, pattern), fine = shapes_and_volumes(2, pattern);
    for (std::size_t i = 0; i < coarse.size(); ++i) {
      const double volume = coarse[i].second;
      const double coarse_error = std::abs(volume_of(coarse[i].first) / volume - 1);
      const double fine_error = std::abs(volume_of(fine[i].first) / volume - 1);
      EXPECT_LT(coarse_error, 0.12) << i;                              // a circle of eight sides lacks 10 %
      EXPECT_LT(fine_error, i < 2 ? 1e-12 : 0.4 * coarse_error) << i;  // flat ones are exact, round ones second order
    }
  }
}

TEST(Shapes, AMeshFileThatIsMissingIsNamed) {
  try {
    make_soup(MeshFileShape{"no_such.msh", 1}, "/some/folder");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(error.where().find("/some/folder/no_such.msh"), std::string::npos) << error.where();
  }
}

}  // namespace
}  // namespace griffith
