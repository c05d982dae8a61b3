#include "sim/meshing/mesh_surface.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <fstream>
#include <limits>
#include <random>

#include "sim/core/error.h"
#include "sim/core/hash_bytes.h"
#include "sim/mesh/mesh_report.h"
#include "sim/mesh/topology.h"
#include "sim/meshing/mesh_cache.h"
#include "sim/meshing/mesh_quality.h"
#include "surfaces.h"
#include "tests/mesh/mesh_invariants.h"

namespace griffith {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using namespace griffith::testing;

MeshingOptions options(MeshingMethod method, double element_size) {
  MeshingOptions result;
  result.method = method;
  result.element_size = element_size;
  return result;
}

bool tetgen_is_installed() {
  return run_process({"tetgen", "-h"}, {10, std::int64_t{1} << 30}).end != ProcessOutcome::End::not_found;
}

/// Returns the quality of a mesh after checks that it is fit for a world.
MeshQuality checked_quality(const SurfaceMesh& mesh) {
  TetSoup soup = mesh.soup;
  const MeshReport report = prepare(soup);
  EXPECT_EQ(report.reoriented_tets + report.removed_tets + report.removed_nodes + report.pinched_nodes, 0);
  EXPECT_EQ(report.overlapping_faces, 0);
  EXPECT_THAT(check_invariants(build_mesh(soup)), IsEmpty());
  return mesh_quality(soup);
}

std::string message_of(const TriangleSurface& surface, const MeshingOptions& wanted, const MeshingSetup& setup = {}) {
  try {
    mesh_surface(surface, wanted, setup);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TriangleSurface open_box() {
  TriangleSurface box = box_surface(Vec3::Zero(), Vec3::Ones());
  box.triangles.pop_back();
  return box;
}

TriangleSurface crossing_boxes() {
  return together(box_surface(Vec3::Zero(), Vec3::Ones()), box_surface(Vec3(0.5, 0.3, 0.2), Vec3(1.5, 0.8, 0.7)));
}

class MeshSurfaceByTetgen : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!tetgen_is_installed()) GTEST_SKIP() << "TetGen is not installed";
  }
};

TEST_F(MeshSurfaceByTetgen, KeepsTheVolumeExactlyAndTheElementsSmall) {
  for (const TriangleSurface& surface :
       {torus_surface(1, 0.4, 24, 12), sphere_surface(0.7, 10), box_surface(Vec3::Zero(), Vec3(1, 1, 0.05))}) {
    for (const double size : {0.3, 0.15}) {
      const SurfaceMesh mesh = mesh_surface(surface, options(MeshingMethod::tetgen, size));
      EXPECT_EQ(mesh.method, MeshingMethod::tetgen);
      const MeshQuality quality = checked_quality(mesh);
      EXPECT_NEAR(quality.volume, mesh.surface_report.volume, 1e-9 * quality.volume);
      EXPECT_GT(quality.min_dihedral, 1);
      EXPECT_LT(quality.mean_edge, 1.2 * size);
      for (const auto& tet : mesh.soup.tets)
        EXPECT_LE(signed_volume(mesh.soup.points[tet[0]], mesh.soup.points[tet[1]], mesh.soup.points[tet[2]],
                                mesh.soup.points[tet[3]]),
                  1.01 * std::pow(1.3 * size, 3) / (6 * std::sqrt(2.0)));
    }
  }
}

TEST_F(MeshSurfaceByTetgen, GradingMakesFewerElements) {
  const MeshingOptions uniform = options(MeshingMethod::tetgen, 0.15);
  MeshingOptions graded = uniform;
  graded.grading = 4;
  const TriangleSurface ball = sphere_surface(1, 10);
  EXPECT_LT(mesh_surface(ball, graded).soup.tets.size(), mesh_surface(ball, uniform).soup.tets.size() * 7 / 10);
}

TEST_F(MeshSurfaceByTetgen, CavitiesStayEmptyAndPartsStayParts) {
  TriangleSurface inner = box_surface(Vec3::Constant(0.3), Vec3::Constant(0.7));
  turn_inside_out(inner);
  const TriangleSurface hollow = together(box_surface(Vec3::Zero(), Vec3::Ones()), inner);
  const SurfaceMesh mesh = mesh_surface(hollow, options(MeshingMethod::tetgen, 0.3));
  EXPECT_NEAR(checked_quality(mesh).volume, 1 - 0.064, 1e-9);
  const TriangleSurface two =
      together(box_surface(Vec3::Zero(), Vec3::Ones()), box_surface(Vec3(2, 0, 0), Vec3(3, 1, 1)));
  const SurfaceMesh pieces = mesh_surface(two, options(MeshingMethod::tetgen, 0.5));
  EXPECT_NEAR(checked_quality(pieces).volume, 2, 1e-9);
  EXPECT_EQ(connected_components(build_mesh(pieces.soup)).size(), 2u);
}

TEST_F(MeshSurfaceByTetgen, SaysWhyItRefuses) {
  const MeshingOptions wanted = options(MeshingMethod::tetgen, 0.3);
  EXPECT_THAT(message_of(open_box(), wanted), HasSubstr("TetGen cannot mesh it: the surface is open"));
  EXPECT_THAT(message_of(crossing_boxes(), wanted), HasSubstr("passes through itself"));
}

TEST_F(MeshSurfaceByTetgen, LimitsAndCancellingEndIt) {
  const TriangleSurface torus = torus_surface(1, 0.4, 60, 30);
  MeshingSetup hasty;
  hasty.name = "torus.obj";
  hasty.limits.seconds = 0.2;
  EXPECT_THAT(message_of(torus, options(MeshingMethod::tetgen, 0.03), hasty),
              HasSubstr("torus.obj: TetGen cannot mesh it: TetGen did not finish within the time limit of 0.2 s"));
  MeshingSetup small;
  small.limits.memory_bytes = std::int64_t{40} << 20;
  EXPECT_THAT(message_of(torus, options(MeshingMethod::tetgen, 0.04), small), HasSubstr("memory limit of 40 MB"));
  MeshingSetup unwanted;
  std::string last;
  unwanted.monitor.stage = [&](std::string_view stage) { last = stage; };
  unwanted.monitor.cancelled = [&] { return last.starts_with("TetGen: Refining"); };
  EXPECT_THROW(mesh_surface(torus, options(MeshingMethod::tetgen, 0.03), unwanted), Cancelled);
}

TEST_F(MeshSurfaceByTetgen, WhereItTakesTooLongTheLatticeFillsAndIsNotKept) {
  MeshingSetup hasty;
  hasty.cache = test_folder() / "cache";
  hasty.limits.seconds = 0.01;
  const TriangleSurface torus = torus_surface(1, 0.4, 60, 30);
  for (int i = 0; i < 2; ++i) {
    const SurfaceMesh mesh = mesh_surface(torus, options(MeshingMethod::automatic, 0.1), hasty);
    EXPECT_EQ(mesh.method, MeshingMethod::volumetric);
    EXPECT_THAT(mesh.findings, Contains(HasSubstr("because TetGen did not finish within the time limit of 0.01 s")));
    EXPECT_FALSE(mesh.from_cache) << "with more time it is another mesh";
  }
}

TEST(MeshSurface, TheLatticeTakesSoundSurfacesToo) {
  for (const TriangleSurface& surface : {torus_surface(1, 0.4, 40, 20), sphere_surface(0.7, 20)}) {
    const SurfaceMesh mesh = mesh_surface(surface, options(MeshingMethod::volumetric, 0.12));
    const MeshQuality quality = checked_quality(mesh);
    EXPECT_NEAR(quality.volume, mesh.surface_report.volume, 0.03 * quality.volume);
    EXPECT_GT(quality.min_dihedral, 10.78);
    EXPECT_LT(quality.max_dihedral, 164.75);
  }
}

TEST(MeshSurface, OpenAndCrossingSurfacesFallBackOnTheLattice) {
  const SurfaceMesh open = mesh_surface(open_box(), options(MeshingMethod::automatic, 0.1));
  EXPECT_EQ(open.method, MeshingMethod::volumetric);
  EXPECT_THAT(open.findings, Contains(HasSubstr("because the surface is open")));
  EXPECT_NEAR(checked_quality(open).volume, 1, 0.1);
  const SurfaceMesh crossing = mesh_surface(crossing_boxes(), options(MeshingMethod::automatic, 0.07));
  EXPECT_THAT(crossing.findings, Contains(HasSubstr("because the surface passes through itself")));
  EXPECT_NEAR(checked_quality(crossing).volume, 1 + 0.25 / 2, 0.06);  // the common part counts once
  TriangleSurface everted = open_box();
  turn_inside_out(everted);
  EXPECT_NEAR(checked_quality(mesh_surface(everted, options(MeshingMethod::automatic, 0.1))).volume, 1, 0.1);
}

TEST(MeshSurface, ASurfaceWithoutAnInsideIsRefused) {
  TriangleSurface sheet;
  sheet.points = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0)};
  sheet.triangles = {{0, 1, 2}, {0, 2, 3}};
  EXPECT_THAT(message_of(sheet, options(MeshingMethod::automatic, 0.3)), HasSubstr("no inside that could be filled"));
  const TriangleSurface foil = box_surface(Vec3::Zero(), Vec3(1, 1, 0.001));
  EXPECT_THAT(message_of(foil, options(MeshingMethod::volumetric, 0.3)), HasSubstr("thinner than the elements"));
}

/// For any coarse lattice on a thin ring, lost volume is reported with a sufficient size, and refused if it is most of
/// it.
TEST(MeshSurface, LostVolumeIsReportedWithARemedy) {
  const TriangleSurface ring = torus_surface(1, 0.03, 60, 12);
  char remedy[64];
  std::snprintf(remedy, sizeof remedy, "element size below %.2g m", 2 * enclosed_volume(ring) / surface_area(ring));
  int reported = 0, refused = 0;
  for (const double size : {0.012, 0.02, 0.03, 0.04, 0.05, 0.06, 0.07, 0.08}) {
    const std::string message = message_of(ring, options(MeshingMethod::volumetric, size));
    refused += !message.empty();
    if (!message.empty()) {
      EXPECT_THAT(message, ::testing::AnyOf(HasSubstr(std::string("would be lost (give an ") + remedy),
                                            HasSubstr("thinner than the elements everywhere")));
      continue;
    }
    const SurfaceMesh mesh = mesh_surface(ring, options(MeshingMethod::volumetric, size));
    const double volume = mesh_quality(mesh.soup).volume, whole = mesh.surface_report.volume;
    const bool has_word = !mesh.findings.empty() && mesh.findings.back().find(remedy) != std::string::npos;
    EXPECT_EQ(has_word, std::abs(volume / whole - 1) >= 0.05) << size;
    EXPECT_GT(volume, 0.5 * whole);
    reported += has_word;
  }
  EXPECT_GT(reported, 0);
  EXPECT_GT(refused, 0);
}

TEST(MeshSurface, ASlipOfTheElementSizeIsRefusedAtOnce) {
  for (const MeshingMethod method : {MeshingMethod::automatic, MeshingMethod::tetgen, MeshingMethod::volumetric})
    EXPECT_THAT(message_of(sphere_surface(1, 8), options(method, 1e-4)), HasSubstr("larger element size"));
}

TEST(MeshSurface, TheCacheGivesTheSameMeshAgain) {
  MeshingSetup setup;
  setup.cache = test_folder() / "cache";
  const TriangleSurface ball = sphere_surface(1, 8);
  const MeshingOptions wanted = options(MeshingMethod::volumetric, 0.3);
  const SurfaceMesh made = mesh_surface(ball, wanted, setup), recalled = mesh_surface(ball, wanted, setup);
  EXPECT_FALSE(made.from_cache);
  EXPECT_TRUE(recalled.from_cache);
  EXPECT_EQ(made.soup.points, recalled.soup.points);
  EXPECT_EQ(made.soup.tets, recalled.soup.tets);
  EXPECT_EQ(made.findings, recalled.findings);
  EXPECT_FALSE(mesh_surface(ball, options(MeshingMethod::volumetric, 0.31), setup).from_cache);
  TriangleSurface other = ball;
  other.points[3].x() += 1e-12;
  EXPECT_FALSE(mesh_surface(other, wanted, setup).from_cache);
}

TEST(MeshSurface, DamagedCacheEntriesAreIgnored) {
  MeshingSetup setup;
  setup.cache = test_folder();
  const TriangleSurface ball = sphere_surface(1, 6);
  const MeshingOptions wanted = options(MeshingMethod::volumetric, 0.5);
  const SurfaceMesh made = mesh_surface(ball, wanted, setup);
  const std::filesystem::path entry = std::filesystem::directory_iterator(setup.cache)->path();
  std::ifstream file(entry, std::ios::binary);
  const std::string good{std::istreambuf_iterator<char>(file), {}};
  for (const std::size_t length : {std::size_t{0}, std::size_t{20}, good.size() / 2, good.size() - 1}) {
    std::ofstream(entry, std::ios::binary) << good.substr(0, length);
    EXPECT_FALSE(read_cache_entry(entry)) << length;
  }
  std::string bent = good;
  bent[good.size() / 2] ^= 1;
  std::ofstream(entry, std::ios::binary) << bent;
  const SurfaceMesh again = mesh_surface(ball, wanted, setup);
  EXPECT_FALSE(again.from_cache);
  EXPECT_EQ(again.soup.points, made.soup.points);
  EXPECT_TRUE(mesh_surface(ball, wanted, setup).from_cache);
}

/// Writes an entry with a correct hash: counts of `header`, then `content`.
void write_crafted_entry(const std::filesystem::path& path, const std::array<std::int32_t, 4>& header,
                         const std::string& content, const LatticeParting& parting = {}) {
  const std::string bytes = std::string(reinterpret_cast<const char*>(header.data()), sizeof header) +
                            std::string(reinterpret_cast<const char*>(&parting), sizeof parting) + content;
  const std::uint64_t sum = hash_bytes(bytes);
  std::ofstream(path, std::ios::binary) << "griffith mesh 5\n"
                                        << std::string(reinterpret_cast<const char*>(&sum), sizeof sum) << bytes;
}

TEST(MeshSurface, CraftedCacheEntriesAreIgnored) {
  const std::filesystem::path entry = test_folder() / "entry.tets";
  constexpr int kMethod = static_cast<int>(MeshingMethod::volumetric),
                kMaximum = std::numeric_limits<std::int32_t>::max();
  std::string content(4 * sizeof(Vec3), '\0');
  const auto append_tet = [&content](std::array<std::int32_t, 4> tet) {
    content.append(reinterpret_cast<const char*>(tet.data()), sizeof tet);
  };
  append_tet({0, 1, 2, 3});
  write_crafted_entry(entry, {kMethod, 0, 4, 1}, content);
  EXPECT_TRUE(read_cache_entry(entry));
  const std::array<std::int32_t, 4> headers[] = {
      {kMethod, -1, 4, 1}, {kMethod, kMaximum, 4, 1}, {kMethod, 0, -4, 1}, {kMethod, 0, kMaximum, 1},
      {kMethod, 0, 4, -1}, {kMethod, 0, 4, kMaximum}, {0, 0, 4, 1},        {77, 0, 4, 1},
      {kMethod, 0, 3, 1}};
  for (const auto& header : headers) {
    write_crafted_entry(entry, header, content);
    EXPECT_FALSE(read_cache_entry(entry)) << header[0] << ' ' << header[1] << ' ' << header[2] << ' ' << header[3];
  }
  for (const LatticeParting& parting :
       {LatticeParting{.pieces = 0}, LatticeParting{.joined = -1}, LatticeParting{.element_size = std::nan("")},
        LatticeParting{.least_size = -1}}) {
    write_crafted_entry(entry, {kMethod, 0, 4, 1}, content, parting);
    EXPECT_FALSE(read_cache_entry(entry));
  }
  for (const int corner : {-1, 4, kMaximum}) {
    content.resize(4 * sizeof(Vec3));
    append_tet({0, 1, 2, corner});
    write_crafted_entry(entry, {kMethod, 0, 4, 1}, content);
    EXPECT_FALSE(read_cache_entry(entry)) << corner;
  }
}

TEST(MeshSurface, RandomTrianglesAreMeshedOrRefused) {
  std::mt19937 random(21);
  std::uniform_real_distribution<double> uniform(-1, 1);
  int meshed = 0;
  for (int sample = 0; sample < 20; ++sample) {
    TriangleSurface soup;
    const int points = 4 + static_cast<int>(random() % 12), triangles = 4 + static_cast<int>(random() % 60);
    for (int i = 0; i < points; ++i) soup.points.emplace_back(uniform(random), uniform(random), uniform(random));
    for (int i = 0; i < triangles; ++i) {
      const auto corner = [&] { return static_cast<int>(random() % static_cast<unsigned>(points)); };
      soup.triangles.push_back({corner(), corner(), corner()});
    }
    try {
      const MeshQuality quality = checked_quality(mesh_surface(soup, options(MeshingMethod::automatic, 0.25)));
      EXPECT_GT(quality.volume, 0);
      ++meshed;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr("surface: "));
    }
  }
  EXPECT_GT(meshed, 3);
}

TEST(MeshSurface, SurfacesOfTheScenesAreMeshed) {
  struct Case {
    const char* name;
    MeshingMethod method;
    double element_size;
  };
  // TetGen keeps each of the bear's 6,216 triangles, which takes a while.
  for (const Case& model : {Case{"bear.obj", MeshingMethod::volumetric, 0.1},
                            {"vase.obj", MeshingMethod::automatic, 0.05},
                            {"vase.obj", MeshingMethod::volumetric, 0.012}}) {
    const SurfaceMesh mesh =
        mesh_surface(read_surface(shipped_surface(model.name)), options(model.method, model.element_size));
    const MeshQuality quality = checked_quality(mesh);
    EXPECT_NEAR(quality.volume, mesh.surface_report.volume, 0.05 * quality.volume) << model.name;
  }
}

}  // namespace
}  // namespace griffith
