#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "app/bake/piece_bonds.h"
#include "baked_run.h"
#include "program.h"
#include "sim/fracture/strength_variation.h"
#include "sim/meshing/surface.h"
#include "sim/scene/scene_reader.h"
#include "tests/world/scenes.h"

namespace griffith::app {
namespace {

Scene baked_wall() { return testing::shot_wall(Vec3(2, 2, 0.5), 0.5, testing::brick(0.02)); }

/// A wall whose pieces show their tets, cut by remeshing.
Scene remeshed_wall() {
  Scene scene = baked_wall();
  scene.bodies[0].remeshing = true;
  return scene;
}

TriangleSurface surface_of(const BakedMesh& mesh) { return {mesh.points, all_triangles(mesh), {}, {}}; }

/// The sum of area vectors over the area: 0 for a closed surface.
double openness_of(const BakedMesh& mesh) {
  const TriangleSurface surface = surface_of(mesh);
  Vec3 sum = Vec3::Zero();
  for (int i = 0; i < std::ssize(surface.triangles); ++i) sum += area_vector(corners_of(surface, i));
  return sum.norm() / surface_area(surface);
}

double mass_of_pieces(const Bake& bake) {
  double mass = 0;
  for (const BakedObject& object : bake.objects) mass += object.scene_body >= 0 ? object.mass : 0;
  return mass;
}

TEST(Bake, PiecesOfTetsEncloseTheirMass) {
  for (const int first : {0, 12}) {
    const Scene scene = remeshed_wall();
    const Bake bake = baked_run(scene, first, 30);
    ASSERT_GT(bake.objects.size(), 10u);
    EXPECT_NEAR(mass_of_pieces(bake), 2 * scene.bodies[0].material.density, 1e-6);
    for (const BakedObject& object : bake.objects) {
      EXPECT_LT(openness_of(object.mesh), 1e-9) << object.name;
      if (object.scene_body < 0 || first > 0) continue;  // in later frames pieces are strained
      EXPECT_NEAR(enclosed_volume(surface_of(object.mesh)), object.mass / scene.bodies[0].material.density,
                  1e-6)  // the wall is strained by its weight
          << object.name;
    }
  }
}

TEST(Bake, ShardsShareOutTheBody) {
  const Bake bake = baked_run(baked_wall(), 0, 30);
  ASSERT_GT(bake.objects.size(), 10u);
  double volume = 0;
  for (const BakedObject& object : bake.objects) {
    EXPECT_LT(openness_of(object.mesh), 1e-5) << object.name;
    if (object.scene_body >= 0) volume += enclosed_volume(surface_of(object.mesh));
  }
  EXPECT_NEAR(volume, 2, 1e-5);
}

/// Bricks that are larger than the tets: pieces that own none cut what they have out of them.
TEST(Bake, PiecesSmallerThanSplintersShareThemOut) {
  Scene scene = baked_wall();
  scene.bodies[0].splinters = BrickSplinters{.size = Vec3(1, 0.7, 0.5)};
  const Bake bake = baked_run(scene, 0, 30);
  double volume = 0;
  for (const BakedObject& object : bake.objects) {
    if (object.scene_body < 0) continue;
    EXPECT_LT(openness_of(object.mesh), 1e-5) << object.name;
    EXPECT_GT(enclosed_volume(surface_of(object.mesh)), 1e-6) << object.name;
    volume += enclosed_volume(surface_of(object.mesh));
  }
  EXPECT_NEAR(volume, 2, 1e-4);
}

/// Joints are mortar on the surface of the wall as in its cracks.
TEST(Bake, JointsAreOfMortar) {
  Scene scene = baked_wall();
  scene.bodies[0].splinters = BrickSplinters{Vec3(0.24, 0.19, 0.24), 0.01, Vec3(0.1, 0.1, -0.12)};
  const Bake bake = baked_run(scene, 0, 30);
  std::array<double, kLooks> areas = {};
  for (const BakedObject& object : bake.objects) {
    if (object.scene_body < 0) continue;
    for (int look = 0; look < kLooks; ++look)
      areas[look] += surface_area({object.mesh.points, object.mesh.triangles[look], {}, {}});
  }
  EXPECT_EQ(bake.materials[bake.objects[0].materials[static_cast<int>(Look::mortar)]].name, "wall_mortar");
  const double outside = 2 * (2 * 2 + 2 * 0.5 + 2 * 0.5), joints = 1 - 0.24 / 0.25 * 0.19 / 0.2;
  EXPECT_NEAR(areas[static_cast<int>(Look::outside)], outside * (1 - joints), 0.01 * outside);
  EXPECT_GT(areas[static_cast<int>(Look::mortar)], outside * joints);
}

/// Pieces of a body that shows the surface of a file are closed though walls of shards only come near to it, and what
/// owns no shard takes its share.
TEST(Bake, PiecesShareOutTheSurfaceOfAFile) {
  const Scene scene = read_scene(std::filesystem::path(GRIFFITH_SOURCE_DIR) / "scenes/vase_shot.json");
  const Bake bake = baked_run(scene, 0, 20);
  const double whole = mass_of_pieces(bake) / scene.bodies[0].material.density;
  double volume = 0;
  for (const BakedObject& object : bake.objects) {
    if (object.scene_body < 0) continue;
    EXPECT_LT(openness_of(object.mesh), 1e-5) << object.name;
    EXPECT_GT(enclosed_volume(surface_of(object.mesh)), 0) << object.name;
    volume += enclosed_volume(surface_of(object.mesh));
  }
  ASSERT_GT(bake.objects.size(), 50u);
  EXPECT_NEAR(volume, whole, 1e-3 * whole);
}

TEST(Bake, FirstPosesPutPiecesWhereTheFirstFrameHasThem) {
  for (const Scene& scene : {baked_wall(), remeshed_wall()}) {
    World world(scene);
    for (int i = 0; i < 12; ++i) world.step();
    Eigen::AlignedBox3d frame_box, box;
    for (const Vec3& position : world.frame().nodes.positions) frame_box.extend(position);
    for (const BakedObject& object : baked_run(scene, 12, 30).objects)
      for (const Vec3& point : object.mesh.points)
        if (object.scene_body >= 0) box.extend(placed(object.poses.front(), point));
    EXPECT_LT((box.min() - frame_box.min()).norm(), 1e-5);
    EXPECT_LT((box.max() - frame_box.max()).norm(), 1e-5);
  }
}

TEST(Bake, DeformedPointsAreWhereTheLastFrameHasThem) {
  const Scene scene = remeshed_wall();
  World world(scene);
  for (int i = 0; i < 30; ++i) world.step();
  const Bake bake = baked_run(scene, 0, 30, true);
  Eigen::AlignedBox3d frame_box, box;
  for (const Vec3& position : world.frame().nodes.positions) frame_box.extend(position);
  for (const BakedObject& object : bake.objects) {
    if (object.scene_body < 0) continue;
    ASSERT_EQ(object.deformed_points.size(), 31u);
    for (const Vec3& point : object.deformed_points.back()) box.extend(placed(object.poses.back(), point));
    for (std::size_t i = 0; i < object.mesh.points.size(); ++i)
      EXPECT_LT((object.deformed_points.front()[i] - object.mesh.points[i]).norm(), 1e-9);
  }
  EXPECT_LT((box.min() - frame_box.min()).norm(), 1e-9);
  EXPECT_LT((box.max() - frame_box.max()).norm(), 1e-9);
}

TEST(Bake, AFreeBodyMovesAndTurnsEvenly) {
  Scene scene = testing::struck_block(testing::brick(1e3));
  scene.projectiles.clear();
  scene.bodies[0].velocity = Vec3(1, 2, 3);
  scene.bodies[0].angular_velocity = Vec3(0, 0, 2);
  const Bake bake = baked_run(scene, 0, 60);
  ASSERT_EQ(bake.objects.size(), 1u);
  const std::vector<Pose>& poses = bake.objects[0].poses;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const double time = bake.times[i];
    EXPECT_LT((poses[i].translation - poses[0].translation - time * Vec3(1, 2, 3)).norm(), 1e-6) << i;
    const Quat turned(Eigen::AngleAxisd(2 * time, Vec3::UnitZ()));
    EXPECT_LT(poses[i].rotation.angularDistance(turned), 1e-2) << i;
  }
  EXPECT_EQ(bake.frames_per_second, 120);
  EXPECT_FALSE(bake.objects[0].break_time);
}

TEST(Bake, WhatRestsStaysWhereItIs) {
  Scene scene = baked_wall();
  scene.projectiles.clear();
  scene.bodies[0].material = testing::brick(1);
  const Bake bake = baked_run(scene, 0, 20);
  ASSERT_EQ(bake.objects.size(), 1u);
  for (const Pose& pose : bake.objects[0].poses) {
    EXPECT_LT((pose.translation - bake.objects[0].poses[0].translation).norm(), 1e-7);
    EXPECT_LT(pose.rotation.angularDistance(Quat::Identity()), 1e-7);
  }
}

/// Until a crack parts them, they move as the body does.
TEST(Bake, PiecesOfAWholeBodyMoveTogether) {
  const Bake bake = baked_run(baked_wall(), 0, 30);
  for (std::size_t frame = 0; frame < bake.times.size() && bake.times[frame] < 0.05; ++frame)
    for (const BakedObject& object : bake.objects) {
      if (object.scene_body < 0) continue;
      EXPECT_LT((object.poses[frame].translation - object.poses[0].translation).norm(), 1e-4);
      EXPECT_LT(object.poses[frame].rotation.angularDistance(Quat::Identity()), 1e-3);
    }
}

TEST(Bake, BondsLieBetweenTheirPieces) {
  for (const Scene& scene : {baked_wall(), remeshed_wall()}) {
    const Bake bake = baked_run(scene, 0, 30);
    ASSERT_FALSE(bake.bonds.empty());
    double inside = 0, bonds = 0;
    for (const BakedObject& object : bake.objects)
      inside += surface_area({object.mesh.points, object.mesh.triangles[static_cast<int>(Look::inside)], {}, {}});
    for (const BakedBond& bond : bake.bonds) {
      const BakedObject &a = bake.objects[bond.a], &b = bake.objects[bond.b];
      EXPECT_LT(bond.a, bond.b);
      EXPECT_NEAR(bond.normal.norm(), 1, 1e-12);
      EXPECT_NEAR(bond.strength, scene.bodies[0].material.tensile_strength, 1e-6 * bond.strength);
      ASSERT_TRUE(bond.break_time);
      EXPECT_GT(*bond.break_time, 0.05);
      EXPECT_GE(a.break_time, bond.break_time);
      EXPECT_GE(b.break_time, bond.break_time);
      bonds += bond.area;
    }
    if (scene.bodies[0].remeshing) {
      EXPECT_LE(2 * bonds, inside * (1 + 1e-9));  // the rest are cracks within pieces
      EXPECT_GE(2 * bonds, 0.8 * inside);
    }
  }
}

/// A bar of two blocks of 1 m, whose common face x = 0 opened at 0.25 s.
class PartedBlocks {
 public:
  PartedBlocks(const Scene& scene) : world_(scene), frame_(world_.frame()) {
    bodies_.assign(frame_.bodies.begin(), frame_.bodies.end());
    bodies_.push_back(bodies_[0]);
    for (const TetId tet : IdRange<TetId>(0, std::ssize(frame_.elements.tets))) {
      body_of_.push_back(BodyId(is_right(tet)));
      std::array<double, 4>& opened = opened_.emplace_back();
      for (int face = 0; face < 4; ++face) {
        const TetId beyond = frame_.elements.neighbors[tet][face];
        opened[face] = beyond.valid() && is_right(beyond) != is_right(tet) ? 0.25 : std::nan("");
      }
    }
    frame_.bodies = bodies_;
    frame_.elements.bodies = body_of_;
    frame_.elements.opened = opened_;
  }

  const Frame& frame() const { return frame_; }
  std::vector<BakedBond> bonds(const std::vector<double>& strength_factors) const {
    const MeshState mesh = {{frame_.elements.tets.begin(), frame_.elements.tets.end()},
                            {frame_.nodes.positions.begin(), frame_.nodes.positions.end()}};
    const MeshHistory history({mesh, mesh}, frame_.nodes.rest_positions);
    return piece_bonds({frame_, history, strength_factors, std::vector<int>{0, 1}, 0});
  }

 private:
  bool is_right(TetId tet) const {
    double x = 0;
    for (const NodeId node : frame_.elements.tets[tet]) x += frame_.nodes.rest_positions[node].x();
    return x > 0;
  }

  World world_;
  Frame frame_;
  std::vector<BodyView> bodies_;
  std::vector<BodyId> body_of_;
  std::vector<std::array<double, 4>> opened_;
};

Scene two_blocks(double element_size) {
  Scene scene = testing::struck_block(testing::brick(0.02));
  scene.projectiles.clear();
  scene.bodies[0].shape = BoxShape{Vec3(2, 1, 1), Vec3::Constant(element_size), BoxPattern::kuhn};
  return scene;
}

TEST(PieceBonds, OfTwoBlocksHaveTheAreaAndStrengthOfTheirCommonFace) {
  const Scene scene = two_blocks(0.5);
  const PartedBlocks blocks(scene);
  const auto factor = [](const Vec3& place) { return 2 + place.y() + 3 * place.z(); };
  std::vector<double> factors;
  for (const Vec3& place : blocks.frame().nodes.rest_positions) factors.push_back(factor(place));
  const std::vector<BakedBond> bonds = blocks.bonds(factors);
  ASSERT_EQ(bonds.size(), 1u);
  const BakedBond& bond = bonds[0];
  const Vec3 middle = scene.bodies[0].position;
  EXPECT_NEAR(bond.area, 1, 1e-12);
  EXPECT_LT((bond.center - middle).norm(), 1e-12);
  EXPECT_LT((bond.normal - Vec3::UnitX()).norm(), 1e-12);
  EXPECT_NEAR(bond.strength, factor(middle) * scene.bodies[0].material.tensile_strength, 1e-6 * bond.strength);
  EXPECT_EQ(bond.break_time, 0.25);
}

/// The mean over the face of what varies linearly between its nodes: inner nodes count for a square, those on edges
/// for half of one.
TEST(PieceBonds, AverageScatterOverTheFace) {
  for (const int seed : {1, 2, 3}) {
    constexpr int kCells = 8;
    Scene scene = two_blocks(1.0 / kCells);
    scene.bodies[0].strength_scatter = StrengthScatter{.weibull_modulus = 5, .seed = seed};
    const PartedBlocks blocks(scene);
    const std::vector<double> factors = strength_factors_at_start(blocks.frame(), scene);
    double sum = 0, corners = 0;
    for (std::size_t i = 0; i < factors.size(); ++i) {
      const Vec3 place = (blocks.frame().nodes.rest_positions[i] - scene.bodies[0].position).cwiseAbs();
      if (place.x() > 1e-9) continue;
      const int sides = (place.y() > 0.5 - 1e-9) + (place.z() > 0.5 - 1e-9);
      (sides == 2 ? corners : sum) += factors[i] / (sides == 1 ? 2 : 1);
    }
    const double strength = blocks.bonds(factors).at(0).strength / scene.bodies[0].material.tensile_strength;
    // A corner has a sixth of a square or a third.
    EXPECT_GE(strength, (sum + corners / 6) / (kCells * kCells) * (1 - 1e-9));
    EXPECT_LE(strength, (sum + corners / 3) / (kCells * kCells) * (1 + 1e-9));
    EXPECT_GT(std::abs(strength - 1), 1e-3);
  }
}

TEST(Bake, NamesAreWordsEachGivenOnce) {
  Scene scene = baked_wall();
  scene.bodies[0].name = "2 läufe";
  std::set<std::string> names;
  const Bake bake = baked_run(scene, 0, 30);
  for (const BakedObject& object : bake.objects) {
    EXPECT_THAT(object.name, ::testing::MatchesRegex("[A-Za-z_][A-Za-z0-9_]*"));
    EXPECT_TRUE(names.insert(object.name).second) << object.name;
  }
}

TEST(Bake, ShotsAppearWhenTheyAreFired) {
  const Bake bake = baked_run(baked_wall(), 0, 30);
  const BakedObject& shot = bake.objects.back();
  EXPECT_EQ(shot.scene_body, -1);
  EXPECT_GT(shot.first_frame, 0);
  EXPECT_EQ(shot.poses.size() + static_cast<std::size_t>(shot.first_frame), bake.times.size());
  EXPECT_NEAR(enclosed_volume(surface_of(shot.mesh)), 4 / 3.0 * 3.14159 * 0.008, 0.1 * 0.0335);
}

}  // namespace
}  // namespace griffith::app
