#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>

#include "sim/mesh/mesh_report.h"
#include "sim/mesh/read_mesh.h"
#include "sim/mesh/topology.h"
#include "tests/input_error_of.h"
#include "tests/mesh/cell_files.h"
#include "tests/mesh/mesh_invariants.h"

namespace griffith {
namespace {

using testing::cell_files;
using testing::CellMesh;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::mixed_block;
using testing::TemporaryFolder;
using enum CellShape;

MeshFile file_of(const CellMesh& mesh) {
  MeshFile file;
  file.soup.points = mesh.points;
  for (const VolumeCell& cell : mesh.cells) file.add(cell.shape, cell.corners, corner_count(cell.shape));
  return file;
}

/// The mesh that cells are split into, with what prepare() has to tell.
struct Split {
  TetSoup soup;
  MeshReport report;
  TetMesh mesh;
};

Split split(const CellMesh& cells) {
  MeshFile file = file_of(cells);
  split_cells(file, "a mesh");
  Split result;
  result.soup = file.soup;
  result.report = prepare(result.soup, "a mesh", &result.mesh);
  return result;
}

std::string error_of(const CellMesh& cells) {
  return input_error_of([&] { split(cells); });
}

/// The corners of a unit cube in the order of files.
std::vector<Vec3> cube_points() {
  return {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0),
          Vec3(0, 0, 1), Vec3(1, 0, 1), Vec3(1, 1, 1), Vec3(0, 1, 1)};
}

/// Any number of cells of any shapes fill the cube, and each face between two has the same triangles on both sides: no
/// inner face is left as a surface.
TEST(SplitCells, FillsTheVolumeAndMatchesAtFaces) {
  for (const int n : {1, 2, 3, 5})
    for (int seed = 0; seed < 20; ++seed) {
      const Split result = split(mixed_block(n, 0.2, seed));
      SCOPED_TRACE("n " + std::to_string(n) + ", seed " + std::to_string(seed));
      EXPECT_NEAR(result.report.volume, 1, 1e-13);
      EXPECT_EQ(result.report.overlapping_faces, 0);
      EXPECT_EQ(result.report.reoriented_tets, 0);
      EXPECT_EQ(result.report.pieces, 1);
      EXPECT_EQ(surface_faces(result.mesh).size(), 12u * n * n);
      EXPECT_THAT(testing::check_invariants(result.mesh), IsEmpty());
      EXPECT_GT(result.report.worst_quality, 0.02);
    }
}

TEST(SplitCells, EveryFormatGivesTheSameTets) {
  const CellMesh mesh = mixed_block(3, 0.2, 1);
  MeshFile expected = file_of(mesh);
  split_cells(expected, "a mesh");
  for (const auto& sample : cell_files(mesh)) {
    TemporaryFolder folder;
    folder.write(sample);
    CellReport report;
    TetSoup soup = read_mesh(folder.path() / sample.path, &report);
    EXPECT_EQ(report.skipped[static_cast<int>(triangle)], 1) << sample.format;
    EXPECT_EQ(report.skipped[static_cast<int>(line)], 1) << sample.format;
    EXPECT_EQ(report.split, expected.report.split) << sample.format;
    EXPECT_EQ(report.tets_of_split, expected.report.tets_of_split) << sample.format;
    EXPECT_EQ(soup.points.size(), expected.soup.points.size()) << sample.format;
    std::ranges::sort(soup.tets);  // some formats list cells by shape
    std::vector<std::array<int, 4>> tets = expected.soup.tets;
    std::ranges::sort(tets);
    EXPECT_EQ(soup.tets, tets) << sample.format;
  }
}

TEST(SplitCells, ReportsWhatBecameOfThem) {
  CellReport report;
  EXPECT_THAT(findings(report), IsEmpty());
  report.split[static_cast<int>(hexahedron)] = 1200;
  report.split[static_cast<int>(prism)] = 1;
  report.tets_of_split = 7203;
  report.skipped[static_cast<int>(triangle)] = 40;
  report.skipped[static_cast<int>(line)] = 8;
  report.skipped[static_cast<int>(point)] = 1;
  report.higher_order[static_cast<int>(tetrahedron)] = 3;
  EXPECT_THAT(findings(report),
              ElementsAre("1,200 hexahedra and 1 prism split into 7,203 tetrahedra; no volume is skipped",
                          "40 triangles, 8 lines and 1 point skipped: no volume",
                          "3 tetrahedra of second or higher order taken with straight edges, by their corners alone"));
}

/// Tets on three sides of a prism ask for diagonals that wind round it: no fan from a corner fills it.
TEST(SplitCells, APrismBetweenTetsGetsAPointInTheMiddle) {
  CellMesh mesh;
  mesh.points = {Vec3(0, 0, 0), Vec3(1, 0, 0),      Vec3(0, 1, 0),   Vec3(0, 0, 1),     Vec3(1, 0, 1),
                 Vec3(0, 1, 1), Vec3(0.5, -1, 0.5), Vec3(1, 1, 0.5), Vec3(-1, 0.5, 0.5)};
  mesh.add(prism, {0, 1, 2, 3, 4, 5});
  constexpr int kSides[3][4] = {{0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}};
  for (int side = 0; side < 3; ++side) {
    const auto& [a, b, c, d] = kSides[side];
    mesh.add(tetrahedron, {a, b, c, 6 + side});
    mesh.add(tetrahedron, {a, c, d, 6 + side});
  }
  const Split result = split(mesh);
  EXPECT_EQ(result.report.nodes, 10);
  EXPECT_NEAR(result.report.volume, 0.5 + 1.0 / 3 + 1.0 / 3 + 1.0 / 3, 1e-15);
  EXPECT_EQ(surface_faces(result.mesh).size(), 2u + 3 * 4);
  EXPECT_EQ(result.report.overlapping_faces, 0);
}

/// A thin plate's cells need no nodes in their middles.
TEST(SplitCells, ThinCellsGetNoNodes) {
  for (const double thickness : {0.1, 0.03, 0.01}) {
    CellMesh mesh;
    mesh.points = cube_points();
    for (Vec3& point : mesh.points) point.z() *= thickness;
    mesh.add(hexahedron, {0, 1, 2, 3, 4, 5, 6, 7});
    const Split result = split(mesh);
    EXPECT_EQ(result.report.nodes, 8);
    EXPECT_NEAR(result.report.volume, thickness, 1e-15);
  }
}

TEST(SplitCells, ANeighborOfTetsTakesTheirDiagonal) {
  for (const bool other : {false, true}) {
    CellMesh house;
    house.points = cube_points();
    house.points.emplace_back(0.5, 0.5, 2);
    house.add(hexahedron, {0, 1, 2, 3, 4, 5, 6, 7});
    house.add(tetrahedron, other ? std::vector{4, 5, 7, 8} : std::vector{4, 5, 6, 8});
    house.add(tetrahedron, other ? std::vector{5, 6, 7, 8} : std::vector{4, 6, 7, 8});
    const Split result = split(house);
    EXPECT_NEAR(result.report.volume, 4.0 / 3, 1e-15);
    EXPECT_EQ(result.report.pieces, 1);
    EXPECT_EQ(surface_faces(result.mesh).size(), 10u + 4);
  }
}

TEST(SplitCells, CollapsedCornersAndMirroredCellsAreFilledToo) {
  CellMesh mesh;
  mesh.points = cube_points();
  mesh.add(hexahedron, {0, 1, 2, 2, 4, 5, 6, 6});  // a prism
  EXPECT_NEAR(split(mesh).report.volume, 0.5, 1e-15);
  mesh.cells.clear();
  mesh.add(hexahedron, {4, 5, 6, 7, 0, 1, 2, 3});
  EXPECT_NEAR(split(mesh).report.volume, 1, 1e-15);
  mesh.cells.clear();
  mesh.add(prism, {4, 5, 6, 0, 1, 2});
  EXPECT_NEAR(split(mesh).report.volume, 0.5, 1e-15);
}

TEST(SplitCells, CellsThatOverlapThemselvesAreRefusedWithTheirNumber) {
  CellMesh mesh;
  mesh.points = cube_points();
  mesh.add(hexahedron, {0, 1, 2, 3, 4, 5, 6, 7});
  mesh.add(hexahedron, {0, 1, 2, 3, 5, 4, 6, 7});
  mesh.add(pyramid, {0, 1, 2, 3, 0});
  EXPECT_THAT(error_of(mesh), HasSubstr("the cell of nodes 0, 1, 2, 3, 5, 4, 6, 7 overlaps itself or has no volume; 2 "
                                        "such in total (generate the mesh again, or as tetrahedra)"));
}

/// Writes a file, reads it and returns its volume, or the error.
struct ReadFileOf {
  double volume = 0;
  CellReport report;
  std::string error;

  ReadFileOf(const std::string& name, const std::string& content) {
    TemporaryFolder folder;
    folder.write(name, content);
    error = input_error_of([&] {
      TetSoup soup = read_mesh(folder.path() / name, &report);
      volume = prepare(soup).volume;
    });
  }
};

std::string vtk_of(const std::string& cells, const std::string& type, int numbers) {
  return "# vtk DataFile Version 3.0\ntitle\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 8 double\n0 0 0 1 0 0 0 1 0 1 1 "
         "0 "
         "0 0 1 1 0 1 0 1 1 1 1 1\nCELLS 1 " +
         std::to_string(numbers) + "\n" + cells + "\nCELL_TYPES 1\n" + type + "\n";
}

TEST(SplitCells, VoxelsOfVtkAreHexahedra) {
  const ReadFileOf voxel("a.vtk", vtk_of("8 0 1 2 3 4 5 6 7", "11", 9));
  EXPECT_EQ(voxel.error, "no error");
  EXPECT_NEAR(voxel.volume, 1, 1e-15);
}

TEST(SplitCells, WhatCannotBeSplitIsRefused) {
  const ReadFileOf surface("a.vtk", vtk_of("3 0 1 2", "5", 4));
  EXPECT_THAT(surface.error, HasSubstr("a.vtk: has no cells with a volume, only 1 triangle (mesh its volume, too"));
  const ReadFileOf polyhedron("a.vtk", vtk_of("8 0 1 2 3 4 5 6 7", "42", 9));
  EXPECT_THAT(polyhedron.error, HasSubstr("cell 0 has VTK's type 42, which is not split here (1 such)"));
  EXPECT_THAT(polyhedron.error, HasSubstr("Tetrahedralize"));
  const ReadFileOf few("a.vtk", vtk_of("7 0 1 2 3 4 5 6", "12", 8));
  EXPECT_THAT(few.error, HasSubstr("cell 0 has 7 points, not 8"));
}

/// Cells of second order are taken by their corners, and counted.
TEST(SplitCells, MiddleNodesAreLeftOut) {
  std::string nodes = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n20\n";
  for (int i = 0; i < 20; ++i) {
    const Vec3 point = i < 8 ? cube_points()[i] : Vec3(0.5, 0.5, i);
    nodes += std::to_string(i + 1) + " " + std::to_string(point.x()) + " " + std::to_string(point.y()) + " " +
             std::to_string(point.z()) + "\n";
  }
  std::string corners = "1 2 3 4 5 6 7 8";
  for (int i = 9; i <= 20; ++i) corners += " " + std::to_string(i);
  const ReadFileOf hexahedra("a.msh", nodes + "$EndNodes\n$Elements\n1\n1 17 2 1 1 " + corners + "\n$EndElements\n");
  EXPECT_EQ(hexahedra.error, "no error");
  EXPECT_NEAR(hexahedra.volume, 1, 1e-15);
  EXPECT_EQ(hexahedra.report.higher_order[static_cast<int>(hexahedron)], 1);

  std::string medit = "MeshVersionFormatted 2\nDimension 3\nVertices 8\n";
  for (const Vec3& point : cube_points())
    medit += std::to_string(point.x()) + " " + std::to_string(point.y()) + " " + std::to_string(point.z()) + " 0\n";
  const ReadFileOf tets("a.mesh", medit + "TetrahedraP2 1\n1 2 4 5 8 8 8 8 8 8 0\nEnd\n");
  EXPECT_EQ(tets.error, "no error");
  EXPECT_NEAR(tets.volume, 1.0 / 6, 1e-15);
  EXPECT_EQ(tets.report.higher_order[static_cast<int>(tetrahedron)], 1);
}

}  // namespace
}  // namespace griffith
