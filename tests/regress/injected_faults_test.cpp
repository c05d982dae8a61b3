#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <random>

#include "app/regress/report.h"
#include "tests/app/program.h"
#include "tests/regress/drawn_picture.h"

namespace griffith::app {
namespace {

using render::Image;

constexpr char kNodeView[] = "candidate_plane+element_forces";

/// Faults in pictures as the program draws them: each must be found, and what drivers do must not.
class InjectedFaults : public ::testing::Test {
 protected:
  static void SetUpTestSuite() { drawer_ = std::make_unique<Drawer>(); }
  static void TearDownTestSuite() { drawer_.reset(); }

  /// Checks that the image alone reveals the difference.
  static void expect_seen(const Drawing& golden, const Drawing& spoiled, const char* what) {
    const ImageComparison comparison = compare_images(drawer_->draw(golden).image, drawer_->draw(spoiled).image);
    EXPECT_FALSE(comparison.passed) << what << ": " << comparison.reason;
  }

  static inline std::unique_ptr<Drawer> drawer_;
};

/// The channel when all light is `factor` as strong; `value` in the sRGB encoding, 0 to 1.
float under_light(float value, double factor) {
  const double linear = value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
  const double lit = linear * factor;
  return static_cast<float>(lit <= 0.0031308 ? lit * 12.92 : 1.055 * std::pow(lit, 1 / 2.4) - 0.055);
}

render::Rgb under_light(const render::Rgb& color, double factor) {
  return {under_light(color.r, factor), under_light(color.g, factor), under_light(color.b, factor)};
}

Image shifted(const Image& image, int by) {
  Image result = image;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const auto pixel = image.pixel(std::clamp(x - by, 0, image.width - 1), y);
      std::ranges::copy(pixel, result.rgba.begin() + 4 * (y * image.width + x));
    }
  return result;
}

TEST_F(InjectedFaults, TheSameDrawingIsEqualToTheByte) {
  const Drawing wall = drawing_of_wall(kNodeView);
  const PictureResult result = compare_pictures("wall", drawer_->draw(wall), drawer_->draw(wall));
  EXPECT_EQ(result.status, PictureStatus::passed) << result.reason;
  EXPECT_TRUE(result.image.equal);
}

TEST_F(InjectedFaults, ALostLabelIsSeen) {
  const Drawing wall = drawing_of_wall(kNodeView);
  ASSERT_FALSE(wall.labels.empty());
  for (std::size_t i = 0; i < wall.labels.size(); ++i) {
    Drawing spoiled = wall;
    spoiled.labels.erase(spoiled.labels.begin() + static_cast<std::ptrdiff_t>(i));
    expect_seen(wall, spoiled, wall.labels[i].text.c_str());
  }
}

TEST_F(InjectedFaults, ALostAndAMovedLetterAreSeen) {
  Drawing wall = drawing_of_wall(kNodeView);
  for (const char* text : {"12", "a1", "7.", "il"}) {
    wall.labels = {{0.7f, 0.2f, text}};
    Drawing spoiled = wall;
    spoiled.labels[0].x += 2.0f / Drawer::kWidth;
    expect_seen(wall, spoiled, "moved");
    spoiled = wall;
    spoiled.labels[0].text.erase(0, 1);
    expect_seen(wall, spoiled, "lost");
  }
}

TEST_F(InjectedFaults, AWrongDigitIsSeen) {
  Drawing wall = drawing_of_wall(kNodeView);
  for (const auto& [right, wrong] : {std::pair{"18", "13"}, {"0.6 MPa", "0.5 MPa"}, {"1.2", "1,2"}, {"B 1", "B 7"}}) {
    Drawing spoiled = wall;
    wall.labels = {{0.7f, 0.2f, right}};
    spoiled.labels = {{0.7f, 0.2f, wrong}};
    expect_seen(wall, spoiled, wrong);
  }
}

TEST_F(InjectedFaults, ALostAndAMovedGlyphAreSeen) {
  Drawing wall = drawing_of_wall(kNodeView);
  // What covers arrows: the ground, on which the node stands, the labels, and the thick edges of the selected element.
  wall.scene.ground.reset();
  wall.labels.clear();
  std::vector<render::Glyph>& arrows = wall.scene.glyphs.arrows;
  std::erase_if(arrows, [&](const auto& arrow) { return arrow.id == wall.scene.embedded.selected_tet; });
  ASSERT_FALSE(arrows.empty());
  // Small ones may be hidden behind others, and so may those that point at the eye.
  const Eigen::Vector3f sight = (wall.camera.target - wall.camera.position).normalized();
  const auto seen_length = [&](const auto& arrow) { return arrow.axes.col(0).cross(sight).norm(); };
  std::swap(arrows.back(), *std::ranges::max_element(arrows, {}, seen_length));
  Drawing spoiled = wall;
  spoiled.scene.glyphs.arrows.pop_back();
  expect_seen(wall, spoiled, "lost");
  spoiled = wall;
  spoiled.scene.glyphs.arrows.back().center.x() += 0.03f;
  expect_seen(wall, spoiled, "moved");
}

TEST_F(InjectedFaults, AShiftByOnePixelIsSeen) {
  for (const char* view : {kNodeView, "utilization", "material"}) {
    const Image image = drawer_->draw(drawing_of_wall(view)).image;
    const ImageComparison comparison = compare_images(image, shifted(image, 1));
    EXPECT_FALSE(comparison.passed) << view << ": " << comparison.reason;
  }
}

TEST_F(InjectedFaults, AnotherColorMapIsSeen) {
  for (const char* view : {"utilization", "von_mises", "speed"})
    expect_seen(drawing_of_wall(view), drawing_of_wall(view, "cividis"), view);
}

TEST_F(InjectedFaults, OnePercentOfTheLightIsSeen) {
  const Drawing wall = drawing_of_wall("plain");
  for (const double factor : {0.99, 1.01}) {
    Drawing spoiled = wall;
    spoiled.scene.surface.color = under_light(wall.scene.surface.color, factor);
    ASSERT_TRUE(wall.scene.surface.scalars.empty() && wall.scene.surface.colors.empty());
    expect_seen(wall, spoiled, "the wall's light");
    spoiled = wall;
    spoiled.scene.ground->color = under_light(wall.scene.ground->color, factor);
    expect_seen(wall, spoiled, "the ground's light");
  }
}

/// The picture hardly shows it; the state's hash does.
TEST_F(InjectedFaults, ASilentlyDifferentSimulationIsReported) {
  const RegressionPicture golden = drawer_->draw(drawing_of_wall("material"));
  const RegressionPicture actual = drawer_->draw(drawing_of_wall("material", "viridis", 1 + 1e-9));
  ASSERT_TRUE(compare_images(golden.image, actual.image).passed);
  const PictureResult result = compare_pictures("wall", golden, actual);
  EXPECT_EQ(result.status, PictureStatus::failed);
  EXPECT_EQ(result.simulation_changed, std::optional(true));
  EXPECT_NE(result.reason.find("The simulation changed"), std::string::npos) << result.reason;
}

TEST_F(InjectedFaults, AChangedDrawingOfTheSameSimulationIsReported) {
  const Drawing wall = drawing_of_wall("utilization");
  Drawing spoiled = wall;
  spoiled.scene.surface.scalar_style.color_map = render::ColorMap::cividis;
  const PictureResult result = compare_pictures("wall", drawer_->draw(wall), drawer_->draw(spoiled));
  EXPECT_EQ(result.status, PictureStatus::failed);
  EXPECT_EQ(result.simulation_changed, std::optional(false));
  EXPECT_NE(result.reason.find("the drawing changed"), std::string::npos) << result.reason;
  EXPECT_TRUE(result.ids.passed) << result.ids.reason;
}

TEST_F(InjectedFaults, APieceThatIsMissingIsSeenInTheIds) {
  const Drawing wall = drawing_of_wall("plain");
  Drawing spoiled = wall;
  spoiled.scene.spheres.clear();
  std::ranges::fill(spoiled.scene.surface.ids, 7);
  const IdComparison comparison = compare_ids(drawer_->draw(wall).ids, drawer_->draw(spoiled).ids);
  EXPECT_FALSE(comparison.passed);
  EXPECT_NE(comparison.reason.find("gone: "), std::string::npos) << comparison.reason;
}

/// Adds to some of the pixels: 34 of 921,600 any color, as llvmpipe does on another generation of processors.
Image with_sparse_noise(Image image, std::mt19937& random) {
  const int count = static_cast<int>(std::ceil(34.0 * image.width * image.height / 921600));
  for (int i = 0; i < count; ++i) {
    const std::size_t at = 4 * (random() % (image.rgba.size() / 4));
    for (std::size_t k = 0; k < 3; ++k) image.rgba[at + k] = static_cast<std::uint8_t>(random());
  }
  return image;
}

/// Adds −1 or +1 to every other byte.
Image with_rounding_noise(Image image, std::mt19937& random) {
  for (std::size_t i = 0; i < image.rgba.size(); ++i) {
    if (i % 4 == 3 || random() % 2 == 0) continue;
    const int value = image.rgba[i] + (random() % 2 == 0 ? -1 : 1);
    image.rgba[i] = static_cast<std::uint8_t>(std::clamp(value, 0, 255));
  }
  return image;
}

/// Lets six pixels below one another at an edge show what is on its other side.
Image with_edge_noise(Image image, std::mt19937& random) {
  for (int tries = 0; tries < 10000; ++tries) {
    const int x = 1 + static_cast<int>(random() % (image.width - 2)),
              y = static_cast<int>(random() % (image.height - 6));
    bool is_edge = true;
    for (int i = 0; i < 6; ++i) is_edge &= std::abs(image.pixel(x, y + i)[0] - image.pixel(x + 1, y + i)[0]) > 30;
    if (!is_edge) continue;
    for (int i = 0; i < 6; ++i)
      std::ranges::copy(image.pixel(x + 1, y + i), image.rgba.begin() + 4 * ((y + i) * image.width + x));
    return image;
  }
  ADD_FAILURE() << "the picture has no edge";
  return image;
}

TEST_F(InjectedFaults, NoiseOfDriversPasses) {
  std::mt19937 random(11);
  for (const char* view : {kNodeView, "utilization", "material"}) {
    const Image image = drawer_->draw(drawing_of_wall(view)).image;
    for (int i = 0; i < 20; ++i)
      for (const auto noise : {with_sparse_noise, with_rounding_noise, with_edge_noise}) {
        const Image noisy = noise(image, random);
        const ImageComparison comparison = compare_images(image, noisy);
        EXPECT_FALSE(comparison.equal);
        EXPECT_TRUE(comparison.passed) << view << ": " << comparison.reason;
      }
    const Image all = with_edge_noise(with_rounding_noise(with_sparse_noise(image, random), random), random);
    EXPECT_TRUE(compare_images(image, all).passed) << compare_images(image, all).reason;
  }
}

/// Mesa leaves instructions unused that this variable takes from it, as on an older processor.
TEST_F(InjectedFaults, PicturesOfAnOlderProcessorPass) {
  const std::string scene = small_wall_file().string();
  for (const char* view : {"utilization", "fracture_planes+exploded", "stress_axes"}) {
    const auto image = [&](const char* instructions) {
      const auto path = test_folder() / (std::string(instructions) + ".png");
      const Outcome outcome = run_program(
          "render " + scene + " --frame 6 --samples 1 --size 320x180 --view " + view + " -o " + path.string(),
          std::string("GALLIUM_OVERRIDE_CPU_CAPS=") + instructions);
      EXPECT_EQ(outcome.code, 0) << outcome.output;
      return render::load_png(path);
    };
    const Image golden = image("avx");
    for (const char* older : {"sse2", "sse4.1"}) {
      const ImageComparison comparison = compare_images(golden, image(older));
      EXPECT_TRUE(comparison.passed) << view << ", " << older << ": " << comparison.reason;
    }
  }
}

/// Returns the picture with data on its origin.
RegressionPicture explained(RegressionPicture picture, const char* view, double pieces) {
  picture.metadata = {{"renderer", "llvmpipe (LLVM 15.0.6, 256 bits)"},
                      {"scene", "small_wall.json"},
                      {"frame", "6"},
                      {"view", view},
                      {"camera", "front"},
                      {"version", "griffith 0.1.0"}};
  picture.statistics = {{"pieces", pieces}, {"crack events", 4}, {"kinetic energy [J]", 1234.5678}};
  return picture;
}

TEST_F(InjectedFaults, AReportOfAHundredPicturesIsOfReasonableSize) {
  const Drawing node = drawing_of_wall(kNodeView), colors = drawing_of_wall("utilization");
  Drawing spoiled = node;
  spoiled.labels.pop_back();
  Drawing dimmed = drawing_of_wall("plain");
  const RegressionPicture bright = explained(drawer_->draw(dimmed), "plain", 3);
  dimmed.scene.surface.color = under_light(dimmed.scene.surface.color, 0.99);
  std::vector<PictureResult> results = {
      compare_pictures("small_wall/front/element_forces_0006", explained(drawer_->draw(node), kNodeView, 3),
                       explained(drawer_->draw(spoiled), kNodeView, 3)),
      compare_pictures("small_wall/front/utilization_0006", explained(drawer_->draw(colors), "utilization", 3),
                       explained(drawer_->draw(drawing_of_wall("utilization", "viridis", 1.1)), "utilization", 5)),
      compare_pictures("small_wall/front/plain_0006", bright, explained(drawer_->draw(dimmed), "plain", 3)),
      without_golden("small_wall/side/plain_0006", bright),
      without_picture("large_wall/front/plain_0000", "scenes/large_wall.json: there is no such scene file")};
  for (PictureResult& result : results)
    if (result.status != PictureStatus::error)
      result.accept_command = "griffith regress suite --accept '" + result.name + "'";
  for (int i = 0; i < 95; ++i)
    results.push_back(compare_pictures("small_wall/front/plain_" + std::to_string(1000 + i), bright, bright));
  const std::string page = report_html(
      {"suite", "llvmpipe (LLVM 15.0.6, 256 bits)", "griffith 0.1.0", "griffith regress suite --accept", 12.3},
      results);
  std::ofstream(test_folder() / "report.html") << page;
  EXPECT_LT(page.size(), 5'000'000u);
}

}  // namespace
}  // namespace griffith::app
