#include "app/picture/shards.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "app/output/export_pieces.h"
#include "app/picture/draw_scene_from_frame.h"
#include "enclosed_volume.h"
#include "program.h"
#include "sim/meshing/surface.h"
#include "sim/splinters/convex_polyhedron.h"
#include "sim/world/world.h"
#include "tests/world/scenes.h"

namespace griffith::app {
namespace {

/// A wall that a ball breaks into many pieces, or does not.
Scene wall(double strength) { return testing::shot_wall(Vec3(2, 2, 0.5), 0.5, testing::brick(strength)); }

World broken(const Scene& scene) {
  World world(scene);
  for (int i = 0; i < 30; ++i) world.step();
  EXPECT_GT(world.frame().fragments, 10);
  return world;
}

/// The sum of all area vectors over the area: zero for a closed surface.
double openness(const PieceSurface& surface) {
  Vec3 sum = Vec3::Zero();
  double area = 0;
  for (const std::vector<int>& polygon : surface.polygons) {
    std::vector<Vec3> corners;
    for (const int point : polygon) corners.push_back(surface.points[point]);
    sum += area_vector(corners);
    area += area_vector(corners).norm();
  }
  return sum.norm() / area;
}

/// An icosphere of radius 1, each triangle parted into four `rounds` times.
std::string sphere_obj(int rounds) {
  std::vector<Vec3> points;
  std::vector<std::array<int, 3>> triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                                               {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for (int i = 0; i < 3; ++i)
    for (const double sign : {1.0, -1.0}) points.push_back(sign * Vec3::Unit(i));
  for (int round = 0; round < rounds; ++round) {
    std::map<std::pair<int, int>, int> middles;
    const auto middle = [&](int a, int b) {
      const auto [found, is_new] = middles.try_emplace(std::minmax(a, b), static_cast<int>(points.size()));
      if (is_new) points.push_back((points[a] + points[b]).normalized());
      return found->second;
    };
    std::vector<std::array<int, 3>> finer;
    for (const auto& [a, b, c] : triangles) {
      const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    triangles = std::move(finer);
  }
  std::ostringstream text;
  text.precision(12);
  for (const Vec3& point : points) text << "v " << point.transpose() << '\n';
  for (const auto& [a, b, c] : triangles) text << "f " << a + 1 << ' ' << b + 1 << ' ' << c + 1 << '\n';
  return text.str();
}

/// A ball of a surface with 512 triangles in elements that are much larger.
Scene ball(double strength) {
  test_file("ball.obj", sphere_obj(3));
  Scene scene = wall(strength);
  fill_surface(scene, "ball.obj");
  scene.bodies[0].position = Vec3(0, 1, 0);
  scene.bodies[0].supports = {{HalfSpaceRegion{Vec3(0, -0.7, 0), -Vec3::UnitY()}}};
  return scene;
}

/// Totals of all pieces in a frame's picture.
struct SeenPieces {
  double volume = 0;       ///< [m³]
  double unseen_part = 0;  ///< share of the mass whose pieces own no shard
};

SeenPieces seen_pieces(const Frame& frame, const Shards& shards) {
  const FrameWithShards sharded(frame, shards);
  SeenPieces seen;
  double mass = 0;
  for (const BodyView& body : frame.bodies) mass += body.mass;
  const std::vector<PieceSurface> surfaces = piece_surfaces(sharded.frame());
  for (const BodyView& body : frame.bodies) {
    const PieceSurface& surface = surfaces[body.id];
    seen.volume += enclosed_volume(surface);
    if (surface.polygons.empty()) seen.unseen_part += body.mass / mass;
  }
  return seen;
}

TEST(Shards, AreOneATetAndFillTheBody) {
  const Scene scene = wall(1);
  const World world(scene);
  const Shards shards(world.frame(), scene);
  const SplinterSet& set = shards.set();
  std::set<TetId> owners;
  double volume = 0;
  for (const Splinter& shard : set.splinters) owners.insert(shard.owner), volume += shard.volume;
  EXPECT_NEAR(volume, 2, 1e-9);
  const auto tets = static_cast<double>(world.frame().elements.tets.size());
  EXPECT_GT(static_cast<double>(owners.size()), 0.9 * tets);
  EXPECT_LE(static_cast<double>(set.splinters.size()), 1.5 * tets);
}

TEST(Shards, BodiesWithSplintersOrRemeshingHaveNone) {
  Scene scene = wall(1);
  scene.bodies[0].splinters = BrickSplinters();
  EXPECT_TRUE(Shards(World(scene).frame(), scene).empty());
  scene.bodies[0].splinters.reset();
  scene.bodies[0].remeshing = true;
  EXPECT_TRUE(Shards(World(scene).frame(), scene).empty());
}

TEST(Shards, AreLongAlongTheGrainOfWood) {
  Scene scene = wall(1);
  const auto extents = [&] {
    const World world(scene);
    const Shards shards(world.frame(), scene);
    Vec3 sum = Vec3::Zero();
    for (const Splinter& shard : shards.set().splinters) {
      Eigen::AlignedBox3f box;
      for (const SplinterPart& part : std::span(shards.set().parts).subspan(shard.first_part, shard.parts))
        for (const SplinterFace& face : std::span(shards.set().faces).subspan(part.first_face, part.faces))
          for (int i = 0; i < face.corners; ++i) box.extend(shards.set().corners[face.first_corner + i].rest);
      if (!box.isEmpty()) sum += box.sizes().cast<double>();
    }
    return sum;
  };
  const Vec3 stone = extents();
  scene.bodies[0].material = *find_material_preset("wood_along_grain");
  scene.bodies[0].weakness = Weakness{WeaknessKind::grain, Vec3::UnitX(), 0.1};
  const Vec3 wood = extents();
  EXPECT_LT(stone.x(), 1.3 * stone.y());
  EXPECT_GT(wood.x(), 2 * wood.y());
}

/// Cracks are followed from the first frame to any other at once; a world follows them one by one.
TEST(Shards, AnyFrameShowsWhatFollowingAllCracksGives) {
  Scene authored = wall(0.02);
  authored.bodies[0].splinters = VoronoiSplinters{.size = 0.3};
  World world(authored);
  const std::vector<std::array<TetId, 4>> neighbors(world.frame().elements.neighbors.begin(),
                                                    world.frame().elements.neighbors.end());
  TetMesh mesh;
  mesh.rest_positions.assign(world.frame().nodes.rest_positions.begin(), world.frame().nodes.rest_positions.end());
  mesh.tets.assign(world.frame().elements.tets.begin(), world.frame().elements.tets.end());
  mesh.neighbors = neighbors;
  Eigen::AlignedBox3d box;
  for (Vec3& point : mesh.rest_positions) point -= authored.bodies[0].position, box.extend(point);
  const SplinterSet set = make_splinters(mesh, make_cells(*authored.bodies[0].splinters, box));
  ASSERT_EQ(set.faces.size(), world.frame().splinters.faces.size());
  for (int i = 0; i < 30; ++i) {
    world.step();
    const Frame frame = world.frame();
    std::vector<TetId> cracked;
    for (const TetId tet : IdRange<TetId>(0, std::ssize(neighbors)))
      if (frame.elements.neighbors[tet] != neighbors[tet]) cracked.push_back(tet);
    SplinterState state = intact_state(set);
    follow_cracks(set, frame.elements.neighbors, cracked, state);
    EXPECT_TRUE(std::ranges::equal(state.attached, frame.splinters.attached)) << i;
    std::vector<int> open(frame.splinters.open_walls.begin(), frame.splinters.open_walls.end());
    std::ranges::sort(open);
    std::ranges::sort(state.open_walls);
    // A wall that opened stays open, even if a part falls off with its neighbor later.
    EXPECT_TRUE(std::ranges::includes(open, state.open_walls)) << i;
    EXPECT_LE(static_cast<double>(open.size() - state.open_walls.size()), 0.02 * static_cast<double>(open.size())) << i;
  }
}

TEST(Shards, PiecesShareOutTheBody) {
  const Scene scene = wall(0.02);
  const World start(scene);
  const Shards shards(start.frame(), scene);
  const World world = broken(scene);
  const SeenPieces seen = seen_pieces(world.frame(), shards);
  EXPECT_NEAR(seen.volume, 2, 0.04);  // tets are stretched a little
  EXPECT_LT(seen.unseen_part, 0.03);
}

TEST(Shards, NoTetIsSeenButWithValues) {
  Scene scene = wall(0.02);
  const World start(scene);
  const EmbeddedDisplay display = embedded_display(start.frame(), scene);
  const World world = broken(scene);
  for (const char* quantity : {"material", "body", "plain", "splinter"}) {
    scene.view.quantity = quantity;
    const render::DrawScene drawn = draw_scene_from_frame(world.frame(), display, scene, scene.view, {});
    EXPECT_TRUE(drawn.surface.ids.empty()) << quantity;
    EXPECT_FALSE(drawn.embedded.opened.empty()) << quantity;
  }
  for (const char* quantity : {"von_mises", "utilization", "tet", "crack_age"}) {
    scene.view.quantity = quantity;
    const render::DrawScene drawn = draw_scene_from_frame(world.frame(), display, scene, scene.view, {});
    EXPECT_FALSE(drawn.surface.ids.empty()) << quantity;
    EXPECT_TRUE(drawn.embedded.opened.empty()) << quantity;
  }
  scene.view.quantity = "material";
  scene.view.splinters = false;
  EXPECT_FALSE(draw_scene_from_frame(world.frame(), display, scene, scene.view, {}).surface.ids.empty());
}

TEST(Shards, PartASurfaceWithoutGapOrOverlap) {
  const Scene scene = ball(1);
  const World world(scene);
  const Frame frame = world.frame();
  const Shards shards(frame, scene);
  const std::vector<Skin> whole = make_skins(frame, scene), parted = shards.skins();
  const auto area = [](const Skin& skin) {
    double sum = 0;
    for (int i = 0; i < skin.polygons(); ++i) {
      std::vector<Vec3> corners;
      for (const SkinCorner& corner : skin.polygon(i)) corners.push_back(corner.rest);
      sum += area_vector(corners).norm();
    }
    return sum;
  };
  EXPECT_GT(parted[0].polygons(), 2 * whole[0].polygons());
  EXPECT_NEAR(area(parted[0]), area(whole[0]), 1e-6 * area(whole[0]));
  for (const SkinCorner& corner : parted[0].corners) {
    EXPECT_LT((skin_position(frame, corner) - corner.rest).norm(), 1e-5);
    EXPECT_GT(corner.normal.dot((corner.rest - Vec3(0, 1, 0)).normalized()), 0.97);
  }
}

/// Shards of a ball have round outsides and walls that end there.
TEST(Shards, OfASurfaceAreClosed) {
  const Scene scene = ball(0.01);
  const World start(scene);
  const Shards shards(start.frame(), scene);
  const double all = enclosed_volume(piece_surfaces(FrameWithShards(start.frame(), shards).frame(), shards.skins())[0]);
  const World world = broken(scene);
  const Frame frame = world.frame();
  const FrameWithShards sharded(frame, shards);
  double sum = 0, worst = 0, area_weighted = 0;
  int pieces = 0;
  const std::vector<PieceSurface> surfaces = piece_surfaces(sharded.frame(), shards.skins());
  for (const BodyView& body : frame.bodies) {
    const PieceSurface& surface = surfaces[body.id];
    if (surface.polygons.empty()) continue;
    const double open = openness(surface);
    worst = std::max(worst, open), area_weighted += open, ++pieces;
    sum += enclosed_volume(surface);
  }
  EXPECT_NEAR(sum, all, 0.03 * all);
  EXPECT_LT(area_weighted / pieces, 0.01);
  EXPECT_LT(worst, 0.1);
}

/// A pane of glass that stands on its foot, and a ball that hits it off its middle.
Scene pane() {
  Scene scene = testing::shot_wall(Vec3(1, 1, 0.04), 0.1, *find_material_preset("soda_lime_glass"));
  scene.bodies[0].material.young_modulus = 7e8;
  scene.bodies[0].material.tensile_strength = 5e5;
  scene.bodies[0].material.fracture_toughness = 2e4;
  scene.projectiles[0].position = Vec3(0.25, 0.7, 0.5);
  scene.projectiles[0].direction = Vec3(0, 0, -1);
  return scene;
}

TEST(Shards, OfGlassLieRoundItsFirstCrackWhereverThatIs) {
  const Scene scene = pane();
  World world(scene);
  EmbeddedDisplay display = embedded_display(world.frame(), scene);
  const auto before = display.natural.mesh;
  follow_first_cracks(display, world.frame(), scene);
  EXPECT_EQ(display.natural.mesh, before);  // nothing has cracked
  for (int i = 0; i < 60 && world.frame().crack_events.empty(); ++i) world.step();
  ASSERT_FALSE(world.frame().crack_events.empty());
  const Vec3 impact = world.frame().crack_events.front().rest_position;
  follow_first_cracks(display, world.frame(), scene);
  const auto after = display.natural.mesh;
  EXPECT_NE(after, before);
  double nearest = 1, middle = 0;  // mean distance of the shards from the impact, of small ones and of all
  double small = std::numeric_limits<double>::infinity();
  const SplinterSet& set = display.shards.set();
  for (const Splinter& shard : set.splinters) {
    const SplinterFace& face = set.faces[set.parts[shard.first_part].first_face];
    const double distance = (set.corners[face.first_corner].rest.cast<double>() - impact).norm();
    middle += distance / static_cast<double>(set.splinters.size());
    if (shard.volume < small) small = shard.volume, nearest = distance;
  }
  EXPECT_LT(nearest, 0.3 * middle);
  follow_first_cracks(display, world.frame(), scene);
  EXPECT_EQ(display.natural.mesh, after);  // once is enough
}

TEST(Shards, OfGlassShareOutThePane) {
  const Scene scene = pane();
  World world(scene);
  Shards shards(world.frame(), scene);
  // Soon after: shards that cracks have cut are open there, which counts the more the farther their parts are.
  for (int i = 0; i < 30 && world.frame().fragments <= 10; ++i) world.step();
  const Frame frame = world.frame();
  ASSERT_GT(frame.fragments, 10);
  shards.follow(frame, scene);
  const SeenPieces seen = seen_pieces(frame, shards);
  EXPECT_NEAR(seen.volume, 0.04, 0.001);
  EXPECT_LT(seen.unseen_part, 0.1);
}

/// Corners of all faces of the shards [m], and the tets of their parts.
std::pair<std::vector<Vec3>, std::vector<TetId>> contents(const Shards& shards) {
  std::pair<std::vector<Vec3>, std::vector<TetId>> all;
  for (const SplinterCorner& corner : shards.set().corners) all.first.push_back(corner.rest.cast<double>());
  for (const SplinterPart& part : shards.set().parts) all.second.push_back(part.tet);
  return all;
}

TEST(Shards, AreKeptForBodiesThatStayAsTheyAre) {
  Scene scene = wall(1);
  for (const double x : {3.0, 6.0}) {
    scene.bodies.push_back(scene.bodies[0]);
    scene.bodies.back().name += std::to_string(x);
    scene.bodies.back().position.x() = x;
  }
  const Shards first(World(scene).frame(), scene);
  std::get<BoxShape>(scene.bodies[0].shape).element_size.x() /= 2;  // now the tets of all others have other numbers
  scene.bodies[2].material = *find_material_preset("wood_along_grain");
  const World edited(scene);
  const Shards second(edited.frame(), scene, {}, first.bodies());
  ASSERT_EQ(second.bodies().size(), 3u);
  EXPECT_NE(second.bodies()[0], first.bodies()[0]);
  EXPECT_EQ(second.bodies()[1], first.bodies()[1]);
  EXPECT_NE(second.bodies()[2], first.bodies()[2]) << "shards of wood are long";
  EXPECT_EQ(contents(second), contents(Shards(edited.frame(), scene)));
}

TEST(Shards, OfOnePaneAreMadeAgainWhenItCracks) {
  Scene scene = pane();
  scene.bodies.push_back(scene.bodies[0]);
  scene.bodies[1].name = "other";
  scene.bodies[1].position.x() = 3;
  World world(scene);
  Shards shards(world.frame(), scene);
  const KnownShards before = shards.bodies();
  for (int i = 0; i < 60 && world.frame().crack_events.empty(); ++i) world.step();
  ASSERT_TRUE(shards.follow(world.frame(), scene));
  EXPECT_NE(shards.bodies()[0], before[0]);
  EXPECT_EQ(shards.bodies()[1], before[1]);
}

}  // namespace
}  // namespace griffith::app
