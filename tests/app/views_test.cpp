#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <memory>
#include <numeric>

#include "app/output/output.h"
#include "app/picture/draw_scene_from_frame.h"
#include "app/picture/glyph_shape.h"
#include "app/picture/named_view.h"
#include "app/picture/picture_options.h"
#include "app/picture/scene_legend.h"
#include "app/picture/shown_mesh.h"
#include "program.h"
#include "renderer/egl_context.h"
#include "sim/scene/quantities.h"
#include "sim/scene/view_names.h"
#include "sim/world/world.h"

namespace griffith::app {
namespace {

constexpr int kWidth = 480, kHeight = 320;

/// A wall with everything that a view can show: a support that slides, one that pushes, loads, probes, shots.
Scene rich_wall() {
  Scene scene = small_wall();
  BodyDescription& wall = scene.bodies[0];
  wall.shape = BoxShape{Vec3(2, 2, 0.5), Vec3::Constant(0.25), BoxPattern::five_tet};
  Support sliding{BoxRegion{Vec3(1, -0.5, -0.25), Vec3(1, 0.5, 0.25)}};
  sliding.kind = SupportKind::sliding;
  sliding.normal = Vec3::UnitX();
  wall.supports.push_back(sliding);
  Load load;
  load.region = BoxRegion{Vec3(-1, 1, -0.25), Vec3(1, 1, 0.25)};
  load.force = Vec3(0, -2e4, 0);
  wall.loads = {load};
  Probe probe;
  probe.name = "top";
  probe.body = "wall";
  probe.at = ProbePoint{Vec3(0.5, 0.9, 0.25)};
  scene.probes = {probe};
  return scene;
}

class ViewsTest : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    context_ = std::make_unique<render::EglContext>();
    renderer_ = std::make_unique<render::Renderer>();
    scene_ = rich_wall();
    world_ = std::make_unique<World>(scene_);
    display_ = std::make_unique<EmbeddedDisplay>(embedded_display(world_->frame(), scene_));
    Scene whole = scene_;
    whole.simulation.fracture = false;
    struck_ = std::make_unique<World>(whole);
    Scene hard = scene_;
    hard.projectiles[0].speed *= 3;
    broken_ = std::make_unique<World>(hard);
    while (struck_->frame().contacts.empty() && struck_->frame().step < 60) struck_->step();
    for (int step = 0; step < 20; ++step) broken_->step();
    ASSERT_GT(broken_->frame().bodies.size(), 1u);
  }
  static void TearDownTestSuite() {
    renderer_.reset();
    context_.reset();
  }
  void SetUp() override { scene_.view.quality = PictureQuality::draft; }  // shows the same in a fraction of the time

  static render::DrawScene drawn(const World& world, const std::string& names) {
    const Frame frame = world.frame();
    ViewSettings view = scene_.view;
    use_named_view(view, names, frame, Vec3(2, 1, 5));
    return draw_scene_from_frame(frame, *display_, scene_, view, {});
  }

  static render::Image picture(const World& world, const std::string& names) {
    const render::DrawScene scene = drawn(world, names);
    const render::Camera camera = {{1.5f, 1.7f, 3.2f}, {0, 1, 0}, 40};
    renderer_->render(scene, camera, picture_options(kWidth, kHeight, 4, scene_.view));
    return renderer_->image();
  }

  static std::unique_ptr<render::EglContext> context_;
  static std::unique_ptr<render::Renderer> renderer_;
  static std::unique_ptr<World> world_, struck_, broken_;
  static std::unique_ptr<EmbeddedDisplay> display_;
  static Scene scene_;
};

std::unique_ptr<render::EglContext> ViewsTest::context_;
std::unique_ptr<render::Renderer> ViewsTest::renderer_;
std::unique_ptr<World> ViewsTest::world_, ViewsTest::struck_, ViewsTest::broken_;
std::unique_ptr<EmbeddedDisplay> ViewsTest::display_;
Scene ViewsTest::scene_;

/// Pixels whose hue is that of `color`, lit or shaded, but not grays.
int pixels_like(const render::Image& image, const render::Rgb& color) {
  const Eigen::Vector3f wanted = Eigen::Vector3f(color.r, color.g, color.b).normalized();
  int count = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const auto pixel = image.pixel(x, y);
      const Eigen::Vector3f seen(pixel[0], pixel[1], pixel[2]);
      const bool is_colored = seen.maxCoeff() - seen.minCoeff() > 0.15f * seen.maxCoeff();
      count += is_colored && seen.norm() > 60 && seen.normalized().dot(wanted) > 0.97f;
    }
  return count;
}

struct LayerCase {
  const char* name;
  render::Rgb color;  ///< color of its symbols
  bool struck;        ///< shown when the wall is struck, else when it has broken
};

TEST_F(ViewsTest, EveryLayerShowsItsSignsInItsColors) {
  const LayerCase cases[] = {
      {"stress_axes", sign_color::kCompression, true},
      {"stress_ellipsoids", sign_color::kCompression, true},
      {"separation_axes", sign_color::kCompression, true},
      {"velocities", sign_color::kVelocity, true},
      {"contacts", sign_color::kImpulse, true},
      {"fracture_planes", {0.36f, 0.26f, 0.52f}, false},  // the old ones: there are many
      {"candidate_plane", sign_color::kBelow, true},
      {"element_forces", sign_color::kTension, true},
      {"body_frames", {0.86f, 0.22f, 0.20f}, true},
      {"collision_shapes", id_color(0), true},
      {"supports", sign_color::kSupport, true},
      {"loads", sign_color::kLoad, true},
      {"probes", sign_color::kProbe, true},
  };
  ASSERT_EQ(std::size(cases), view_layers().size());
  const render::Image plain_struck = picture(*struck_, "plain"), plain_broken = picture(*broken_, "plain");
  for (const LayerCase& test : cases) {
    const render::Image& plain = test.struck ? plain_struck : plain_broken;
    const render::Image image = picture(test.struck ? *struck_ : *broken_, test.name);
    save_picture(test_folder() / (std::string(test.name) + ".png"), image);  // for people to look at
    EXPECT_GT(pixels_like(image, test.color), pixels_like(plain, test.color) + 4) << test.name;
  }
}

TEST_F(ViewsTest, EveryQuantityAndStyleGivesAPictureOfItsOwn) {
  std::map<std::string, render::Image> pictures;
  for (const Quantity* quantity : view_quantities()) {
    if (quantity->key == "splinter" || quantity->key == "texture") continue;  // the wall has neither
    pictures[std::string(quantity->key)] = picture(*broken_, std::string(quantity->key) + "+exploded");
  }
  for (const char* name : {"wireframe", "shrunken", "slice", "exploded", "surface"})
    pictures[name] = picture(*broken_, name);
  for (auto a = pictures.begin(); a != pictures.end(); ++a)
    for (auto b = std::next(a); b != pictures.end(); ++b) {
      const bool the_same = a->first == "exploded" && b->first == "von_mises";
      EXPECT_EQ(a->second == b->second, the_same) << a->first << ", " << b->first;
    }
}

TEST_F(ViewsTest, TheDeformationIsMagnifiedAsTheNameSays) {
  ViewSettings view;
  use_named_view(view, "von_mises+deformed=250", struck_->frame(), Vec3::UnitZ());
  EXPECT_EQ(view.deformation_scale, 250);
  EXPECT_EQ(view.quantity, "von_mises");
  EXPECT_EQ(picture(*struck_, "deformed=1"), picture(*struck_, "von_mises"));
  EXPECT_FALSE(picture(*struck_, "deformed=1000") == picture(*struck_, "von_mises"));
  for (const char* wrong : {"deformed=", "deformed=x", "deformed=-1", "deformed=1e9", "deformed=2 "})
    EXPECT_THROW(use_named_view(view, wrong, struck_->frame(), Vec3::UnitZ()), InputError) << wrong;
}

TEST_F(ViewsTest, NothingOfAViewInfluencesAnother) {
  scene_.view.quality = PictureQuality::standard;  // with all passes of the renderer
  const render::Image before = picture(*struck_, "utilization");
  for (const ViewLayerInfo& layer : view_layers()) picture(*struck_, std::string(layer.key) + "+slice");
  EXPECT_EQ(picture(*struck_, "utilization"), before);
}

TEST_F(ViewsTest, UnknownNamesAreRefusedWithAllThatThereAre) {
  ViewSettings view;
  try {
    use_named_view(view, "utilization+sliced", world_->frame(), Vec3::UnitZ());
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(error.problem().find("sliced"), std::string::npos);
    for (const char* known : {"utilization", "stress_axes", "wireframe", "slice"})
      EXPECT_NE(error.remedy().find(known), std::string::npos);
  }
}

TEST_F(ViewsTest, SymmetricRangeReachesAsFarBelowZero) {
  ViewSettings view;
  view.quantity = "pressure";
  view.symmetric = true;
  const Frame frame = struck_->frame();
  const auto drawn = draw_scene_from_frame(frame, embedded_display(frame, scene_), scene_, view, {});
  const render::ScalarStyle& style = drawn.surface.scalar_style;
  EXPECT_EQ(style.minimum, -style.maximum);
  EXPECT_EQ(std::accumulate(style.histogram.begin(), style.histogram.end(), 0),
            static_cast<int>(frame.elements.tets.size()));
  EXPECT_FALSE(style.has_nan);
}

TEST_F(ViewsTest, TheHistogramCountsWhatIsColored) {
  const Frame frame = broken_->frame();
  const auto counted = [&](const std::string& quantity, ElementStyle style, const HiddenBodies& hidden) {
    ViewSettings view;
    view.quantity = quantity;
    view.elements = style;
    const auto drawn = draw_scene_from_frame(frame, embedded_display(frame, scene_), scene_, view, {}, {}, hidden);
    const std::vector<int>& counts = drawn.surface.scalar_style.histogram;
    return std::accumulate(counts.begin(), counts.end(), std::ptrdiff_t{0});
  };
  const auto all = std::ssize(frame.elements.tets);
  const auto rigid =
      std::ranges::count_if(frame.elements.bodies, [&](BodyId body) { return frame.bodies[body].rigid; });
  ASSERT_GT(rigid, 0);
  EXPECT_EQ(counted("von_mises", ElementStyle::surface, {}), all - rigid) << "rigid ones are gray";
  EXPECT_EQ(counted("von_mises", ElementStyle::wireframe, {}), all) << "a wireframe has no gray";
  EXPECT_EQ(counted("element_quality", ElementStyle::surface, {}), all);
  EXPECT_EQ(counted("speed", ElementStyle::surface, {}), std::ssize(frame.nodes.positions));
  EXPECT_EQ(counted("speed", ElementStyle::surface, {0}), 0) << "hidden";
}

TEST_F(ViewsTest, UnlitPixelsHaveTheLegendsColorOfTheirElementsValue) {
  ViewSettings view;
  view.quantity = "von_mises";
  view.shading = view.edges = false;
  view.range = Vec2(1e3, 9e4);
  const Frame frame = struck_->frame();
  const QuantityValues values = quantity_values(frame, *find_quantity(view.quantity));
  auto drawn = draw_scene_from_frame(frame, embedded_display(frame, scene_), scene_, view, {});
  drawn.ground.reset();  // it hides what rests on it and sinks in by a hair
  renderer_->render(drawn, {{1.5f, 1.7f, 3.2f}, {0, 1, 0}, 40}, picture_options(kWidth, kHeight, 1, view));
  const render::Image image = renderer_->image();
  int pixels = 0;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const std::int32_t tet = renderer_->id_at(x, y);
      if (tet < 0) continue;
      const float t = (values.values[static_cast<std::size_t>(tet)] - 1e3f) / (9e4f - 1e3f);
      const render::Rgb color = render::color_map_color(render::ColorMap::viridis, t);
      const auto seen = image.pixel(x, y);
      EXPECT_EQ(seen[0], std::lround(255 * color.r));
      EXPECT_EQ(seen[1], std::lround(255 * color.g));
      EXPECT_EQ(seen[2], std::lround(255 * color.b));
      ++pixels;
    }
  EXPECT_GT(pixels, 10000);
}

TEST_F(ViewsTest, LabelsStandWhereTheirPlacesAreSeen) {
  render::DrawScene scene;
  const render::Camera camera = {{0, 0, 5}, {0, 0, 0}, 90};
  scene.labels = {{{0, 0, 0}, "middle"}, {{0, 2.5f, 0}, "up"}, {{-5, 0, 0}, "left"}, {{0, 0, 9}, "behind"}};
  const std::vector<ui::PictureLabel> labels = scene_labels(scene, camera, 2);
  ASSERT_EQ(labels.size(), 3u);
  const float expected[3][2] = {{0.5f, 0.5f}, {0.5f, 0.25f}, {0.25f, 0.5f}};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(labels[i].x, expected[i][0], 1e-5);
    EXPECT_NEAR(labels[i].y, expected[i][1], 1e-5);
  }
}

TEST_F(ViewsTest, SliceHidesTheSideThatItsNormalPointsTo) {
  const render::DrawScene cut = drawn(*struck_, "slice");
  ASSERT_TRUE(cut.visible);
  EXPECT_GT(cut.visible->normal.z(), 0.99f);  // toward the eye
  EXPECT_NEAR(cut.visible->offset, 0, 0.05);
}

}  // namespace
}  // namespace griffith::app
