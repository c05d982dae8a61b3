#include "sim/meshing/lattice_parting.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <regex>

#include "sim/mesh/mesh_report.h"
#include "surfaces.h"

namespace griffith {
namespace {

using ::testing::HasSubstr;
using namespace griffith::testing;

/// A solid of revolution about x: balls of radius 0.5 m about −0.8 m and 0.8 m, and a bar of radius `bar` between them.
TriangleSurface dumbbell(double bar) {
  constexpr int kRows = 120, kAround = 24;
  TriangleSurface surface = grid_surface(kRows + 1, kAround, false, true, [=](int i, int j) {
    const double x = -1.3 + 2.6 * i / kRows, phi = -2 * std::numbers::pi * j / kAround;
    const double ball = std::sqrt(std::max(0.0, 0.25 - (std::abs(x) - 0.8) * (std::abs(x) - 0.8)));
    const double radius = std::abs(x) < 0.8 ? std::max(ball, bar) : ball;
    return Vec3(x, radius * std::cos(phi), radius * std::sin(phi));
  });
  weld_points(surface);
  std::erase_if(surface.triangles, [](const auto& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
  return surface;
}

SurfaceMesh meshed(const TriangleSurface& surface, double element_size, const MeshingSetup& setup = {}) {
  MeshingOptions options;
  options.method = MeshingMethod::volumetric;
  options.element_size = element_size;
  return mesh_surface(surface, options, setup);
}

int pieces_in(SurfaceMesh mesh) { return prepare(mesh.soup).pieces; }

std::string parting_in(const SurfaceMesh& mesh) {
  for (const std::string& finding : mesh.findings)
    if (finding.find("the lattice parts it") != std::string::npos) return finding;
  return "";
}

/// The element size that a finding names as the remedy [m].
double remedy_in(const std::string& finding) {
  std::smatch match;
  const bool found = std::regex_search(finding, match, std::regex("an element size of ([0-9.e-]+) m keeps it in 1$"));
  return found ? std::stod(match[1]) : 0;
}

TEST(LatticeParting, IsReportedWithTheElementSizeThatKeepsItTogether) {
  for (const double bar : {0.05, 0.07}) {
    const SurfaceMesh parted = meshed(dumbbell(bar), 0.25);
    EXPECT_EQ(pieces_in(parted), 2);
    EXPECT_THAT(parting_in(parted), HasSubstr("into 2 pieces"));
    const double remedy = remedy_in(parting_in(parted));
    ASSERT_GT(remedy, 0) << parting_in(parted);
    EXPECT_LT(remedy, 0.25);
    const SurfaceMesh kept = meshed(dumbbell(bar), remedy);
    EXPECT_EQ(pieces_in(kept), 1);
    EXPECT_EQ(parting_in(kept), "");
  }
}

/// A spout is often a shell of its own that reaches into the pot.
TEST(LatticeParting, IsReportedShellsThatCross) {
  const TriangleSurface pot = sphere_surface(0.5, 12);
  TriangleSurface spout = dumbbell(0.05);
  move(spout, Vec3(0.8, 0.003, 0.002));
  const std::string finding = parting_in(meshed(together(pot, spout), 0.25));
  EXPECT_THAT(finding, HasSubstr("into 2 pieces"));
  EXPECT_GT(remedy_in(finding), 0) << finding;
}

TEST(LatticeParting, WhatIsInPartsAnywayIsNotReported) {
  TriangleSurface other = sphere_surface(0.5, 8);
  move(other, Vec3(2, 0, 0));
  EXPECT_EQ(parting_in(meshed(together(sphere_surface(0.5, 8), other), 0.2)), "");
  EXPECT_EQ(parting_in(meshed(sphere_surface(0.5, 8), 0.2)), "");
}

TEST(LatticeParting, WithoutARemedySaysWhatWasTried) {
  const std::string finding = parting_in(meshed(dumbbell(0.001), 0.4));
  EXPECT_THAT(finding, HasSubstr("into 2 pieces"));
  EXPECT_THAT(finding, HasSubstr("give a smaller element size"));
}

TEST(LatticeParting, IsReportedAMeshThatWasMadeBefore) {
  MeshingSetup setup;
  setup.cache = test_folder();
  const SurfaceMesh first = meshed(dumbbell(0.05), 0.25, setup), second = meshed(dumbbell(0.05), 0.25, setup);
  EXPECT_TRUE(second.from_cache);
  EXPECT_NE(parting_in(first), "");
  EXPECT_EQ(parting_in(first), parting_in(second));
}

}  // namespace
}  // namespace griffith
