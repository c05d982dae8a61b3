#include <cmath>

#include "renderer/surroundings.h"
#include "renderer_fixture.h"

namespace griffith::render {
namespace {

class GroundTest : public RendererFixture {
 protected:
  static Image ground_seen(const DrawScene& scene, const Camera& camera) {
    RenderOptions how = options();
    how.shadows = false;
    renderer_->render(scene, camera, how);
    return renderer_->image();
  }
};

/// Mean over all channels, of 255.
double difference(const Image& a, const Image& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.rgba.size(); ++i) sum += std::abs(a.rgba[i] - b.rgba[i]);
  return sum / static_cast<double>(a.rgba.size());
}

TEST(GridLevel, SpacingIsAPowerOfTenThatSuitsTheView) {
  for (float height = 1e-3f; height < 1e4f; height *= 1.07f) {
    const GridLevel level = grid_level(height);
    const float power = std::log10(level.spacing);
    EXPECT_NEAR(power, std::round(power), 1e-4);
    EXPECT_LE(level.spacing, 0.401f * height);
    EXPECT_GT(level.spacing, 0.039f * height);
    EXPECT_GE(level.fade, 0);
    EXPECT_LT(level.fade, 1);
  }
}

TEST_F(GroundTest, GridDoesNotJumpWhereItsSpacingChanges) {
  DrawScene scene;
  scene.ground = Ground{};
  for (const float height : {0.25f, 2.5f, 25.0f}) {
    const Camera there = zoom(camera(), height / height_at_target(camera()));
    const Camera before = zoom(there, 0.9995f), after = zoom(there, 1.0005f);
    ASSERT_NEAR(grid_level(height_at_target(after)).spacing, 10 * grid_level(height_at_target(before)).spacing,
                1e-3f * height);
    EXPECT_LT(difference(ground_seen(scene, before), ground_seen(scene, after)), 0.3) << height;
  }
}

TEST_F(GroundTest, DebrisThatFliesAwayChangesNothingAtOnce) {
  DrawScene scene;
  scene.ground = Ground{};
  scene.spheres = {{{0, 0.4f, 0}, 0.4f}, {{0, 0.1f, 0}, 0.05f}};
  Image before;
  for (float way = 3; way < 3000; way *= 1.02f) {
    scene.spheres[1].center = {way, 0.1f, way};  // out of the picture from the start
    const Image now = ground_seen(scene, camera());
    if (!before.rgba.empty()) {
      ASSERT_LT(difference(before, now), 0.5) << "at " << way << " m";
    }
    before = now;
  }
}

}  // namespace
}  // namespace griffith::render
