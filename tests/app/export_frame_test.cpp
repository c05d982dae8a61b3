#include "app/output/export_frame.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "sim/core/error.h"
#include "sim/mesh/read_mesh.h"
#include "sim/scene/quantities.h"
#include "sim/world/world.h"
#include "tests/world/scenes.h"

namespace griffith::app {
namespace {

World broken_wall() {
  World world(testing::shot_wall(Vec3(3, 3, 1), 1.5, testing::brick(0.02)));
  for (int i = 0; i < 40; ++i) world.step();
  return world;
}

std::filesystem::path output(const std::string& name) { return std::filesystem::path(::testing::TempDir()) / name; }

class ExportFrame : public ::testing::TestWithParam<const char*> {};

TEST_P(ExportFrame, TheMeshReadsBackAsItIs) {
  const World world = broken_wall();
  const Frame frame = world.frame();
  ASSERT_GT(frame.bodies.size(), 1u);
  export_frame(output(GetParam()), frame);
  const TetSoup soup = read_mesh(output(GetParam()));
  ASSERT_EQ(soup.points.size(), frame.nodes.positions.size());
  for (std::size_t i = 0; i < soup.points.size(); ++i) EXPECT_EQ(soup.points[i], frame.nodes.positions[i]);
  ASSERT_EQ(soup.tets.size(), frame.elements.tets.size());
  for (std::size_t i = 0; i < soup.tets.size(); ++i)
    for (int k = 0; k < 4; ++k) EXPECT_EQ(soup.tets[i][k], frame.elements.tets[i][k].index());
}

INSTANTIATE_TEST_SUITE_P(Kinds, ExportFrame, ::testing::Values("frame.vtu", "frame.msh"));

TEST(ExportFrameFields, EveryFieldIsThere) {
  const World world = broken_wall();
  export_frame(output("fields.vtu"), world.frame());
  std::stringstream text;
  text << std::ifstream(output("fields.vtu"), std::ios::binary).rdbuf();
  for (const char* name :
       {"displacement [m]", "velocity [m/s]", "reaction [N]", "separation_stress [Pa]", "utilization",
        "separation_direction", "stress [Pa]", "von_mises [Pa]", "body", "scene_body"})
    EXPECT_NE(text.str().find('"' + std::string(name) + '"'), std::string::npos) << name;
  for (const Quantity* quantity : file_quantities())
    EXPECT_NE(text.str().find("Name=\"" + std::string(quantity->key)), std::string::npos) << quantity->key;
}

TEST(ExportFrameFields, QuadraticTetsAreQuadraticCells) {
  Scene scene;
  BodyDescription block;
  block.shape = BoxShape{Vec3(1, 1, 1), Vec3::Ones(), BoxPattern::five_tet};
  block.elements = ElementOrder::quadratic;
  scene.bodies = {block};
  const World world(scene);
  export_frame(output("quadratic.vtu"), world.frame());
  std::stringstream text;
  text << std::ifstream(output("quadratic.vtu"), std::ios::binary).rdbuf();
  const std::size_t points = world.frame().nodes.positions.size() + world.frame().edges.ends.size();
  EXPECT_EQ(points, 8u + 18u);
  EXPECT_NE(text.str().find("NumberOfPoints=\"26\" NumberOfCells=\"5\""), std::string::npos);
  EXPECT_NE(text.str().find(std::string(5, '\x18')), std::string::npos) << "VTK_QUADRATIC_TETRA";
}

TEST(ExportFrameFields, AnotherEndingIsRefused) {
  EXPECT_THROW(check_export_path("wall.obj"), InputError);
  EXPECT_NO_THROW(check_export_path("wall.vtu"));
}

}  // namespace
}  // namespace griffith::app
