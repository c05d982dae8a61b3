#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/core/temporary_folder.h"
#include "sim/mesh/box_mesh.h"
#include "sim/mesh/topology.h"
#include "sim/splinters/splinters.h"
#include "tests/input_error_of.h"
#include "tests/random_values.h"
#include "tests/splinters/cell_files.h"

namespace griffith {
namespace {

using testing::box_cell;
using testing::BoxCell;
using ::testing::HasSubstr;
using testing::write_cells;

std::filesystem::path file(const std::string& name) {
  static const TemporaryFolder folder;
  return folder.path() / name;
}

std::string message_of(const std::vector<BoxCell>& cells, int faces = 6) {
  return input_error_of([&] { read_cells(write_cells(file("cells.obj"), cells, faces), 1); });
}

const BoxCell kLeft = box_cell("left", Vec3(-1, -1, -1), Vec3(0, 1, 1));
const BoxCell kRight = box_cell("right", Vec3(0, -1, -1), Vec3(1, 1, 1));

TEST(FileCells, TwoBoxesMeetInAWall) {
  const CellPartition cells = read_cells(write_cells(file("two.obj"), {kLeft, kRight}), 2);
  ASSERT_EQ(cells.size(), 2u);
  int inner = 0;
  for (const CellWall& wall : cells[0].walls) {
    if (wall.neighbor < 0) continue;
    ++inner;
    EXPECT_EQ(wall.neighbor, 1);
    EXPECT_NEAR(wall.inside.distance(Vec3(1, 0.3, 0.2)), 1, 1e-6);
  }
  EXPECT_EQ(inner, 1);
  EXPECT_EQ(cells[0].walls.size(), 6u);
  double extent = 0;
  for (const CellWall& wall : cells[1].walls) extent = std::max(extent, wall.inside.offset);
  EXPECT_NEAR(extent, 2, 1e-5) << "scaled";
}

/// A side of a brick in running bond has several neighbors, each of which covers its own part of it.
TEST(FileCells, ASideMayHaveSeveralNeighbors) {
  const CellPartition cells =
      read_cells(write_cells(file("three.obj"), {kLeft, box_cell("low", Vec3(0, -1, -1), Vec3(1, 0.2, 1)),
                                                 box_cell("high", Vec3(0, 0.2, -1), Vec3(1, 1, 1))}),
                 1);
  const TetMesh mesh = build_mesh(make_box(Vec3(1, 1, 1), Vec3::Constant(0.5), BoxPattern::five_tet));
  const SplinterSet set = make_splinters(mesh, cells);
  ASSERT_EQ(set.splinters.size(), 3u);
  EXPECT_NEAR(set.splinters[0].volume, 0.5, 1e-9);
  std::map<std::pair<int, int>, double> areas;
  for (const SplinterFace& face : set.faces) {
    if (face.beyond < 0) continue;
    Vec3 area = Vec3::Zero();
    const auto at = [&](int i) { return Vec3(set.corners[face.first_corner + i].rest.cast<double>()); };
    for (int i = 2; i < face.corners; ++i) area += (at(i - 1) - at(0)).cross(at(i) - at(0)) / 2;
    areas[{set.parts[face.part].splinter.index(), set.parts[face.beyond].splinter.index()}] += area.norm();
  }
  const auto number = [&](const Vec3& inside) {  // of the splinter there
    for (std::size_t i = 0; i < set.splinters.size(); ++i) {
      Vec3 mean = Vec3::Zero();
      double count = 0;
      for (const SplinterFace& face : set.faces)
        if (set.parts[face.part].splinter == SplinterId(static_cast<std::int64_t>(i)))
          for (int k = 0; k < face.corners; ++k, ++count)
            mean += set.corners[face.first_corner + k].rest.cast<double>();
      if ((mean / count - inside).norm() < 0.3) return static_cast<int>(i);
    }
    return -1;
  };
  const int left = number(Vec3(-0.25, 0, 0)), low = number(Vec3(0.25, -0.15, 0)), high = number(Vec3(0.25, 0.4, 0));
  EXPECT_NEAR((areas[{left, low}]), 0.7, 1e-6);
  EXPECT_NEAR((areas[{low, left}]), 0.7, 1e-6);
  EXPECT_NEAR((areas[{left, high}]), 0.3, 1e-6);
  EXPECT_NEAR((areas[{low, high}]), 0.5, 1e-6);
}

TEST(FileCells, EachFaultNamesTheCell) {
  EXPECT_EQ(message_of({kLeft, kRight}), "no error");
  BoxCell dented = kRight;
  dented.corners[7] = Vec3(0.2, 0.1, 0.1);
  EXPECT_THAT(message_of({kLeft, dented}), HasSubstr("cell \"right\": is not convex"));
  EXPECT_THAT(message_of({kLeft}, 5), HasSubstr("cell \"left\": is not closed"));
  BoxCell flat = kRight;
  for (Vec3& corner : flat.corners) corner.x() = 0;
  EXPECT_THAT(message_of({kLeft, flat}), HasSubstr("cell \"right\": has no volume"));
  BoxCell moved = kRight;
  for (Vec3& corner : moved.corners) corner.x() -= 0.01;
  const std::string overlap = message_of({kLeft, moved});
  EXPECT_THAT(overlap, HasSubstr("cell \"left\": overlaps the cell \"right\" by 0.04 m3"));
  BoxCell twin = kLeft;
  twin.name = "twin";
  EXPECT_THAT(message_of({kLeft, twin}), HasSubstr("cell \"left\": overlaps the cell \"twin\""));
  EXPECT_THAT(message_of({}), HasSubstr("cells.obj"));
}

TEST(FileCells, WhatTheyLeaveOutIsMeasuredAndPlaced) {
  const TetMesh mesh = build_mesh(make_box(Vec3(4, 1, 1), Vec3::Constant(0.5), BoxPattern::five_tet));
  const CellPartition cells = read_cells(write_cells(file("short.obj"), {kLeft, kRight}), 1);
  const Uncovered uncovered = uncovered_part(mesh, make_splinters(mesh, cells));
  EXPECT_NEAR(uncovered.volume, 2, 1e-9);
  EXPECT_GT(std::abs(uncovered.place.x()), 1);
}

TEST(FileCells, RandomBoxesAreTakenOrRefused) {
  testing::RandomValues random(7);
  int refused = 0;
  for (int i = 0; i < 20; ++i) {
    std::vector<BoxCell> cells;
    for (int k = 0; k < 4; ++k) {
      BoxCell cell = box_cell("cell_" + std::to_string(k), Vec3(k, 0, 0), Vec3(k + 1, 1, 1));
      cell.corners[random.index(8)] += 0.2 * (i % 4) * random.direction();
      cells.push_back(cell);
    }
    const std::string message = message_of(cells);
    const bool is_read = message == "no error";
    refused += !is_read;
    EXPECT_TRUE(is_read || message.find("cell \"cell_") != std::string::npos) << message;
    EXPECT_TRUE(i % 4 != 0 || is_read) << message;
  }
  EXPECT_GE(refused, 10);
}

}  // namespace
}  // namespace griffith
