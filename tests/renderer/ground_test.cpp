#include <algorithm>
#include <cmath>

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
  for (std::size_t i = 0; i < a.rgba.size(); ++i) sum += std::abs(int(a.rgba[i]) - int(b.rgba[i]));
  return sum / static_cast<double>(a.rgba.size());
}

TEST_F(GroundTest, GridDoesNotJumpWhileTheViewWidens) {
  DrawScene scene;
  scene.ground = Ground{};
  std::vector<double> changes;
  Image before;
  for (int i = 0; i <= 120; ++i) {
    const Image now = ground_seen(scene, zoom(camera(), std::pow(10.0f, static_cast<float>(i) / 80)));
    if (i > 0) changes.push_back(difference(before, now));
    before = now;
  }
  const double largest = *std::ranges::max_element(changes);
  std::ranges::nth_element(changes, changes.begin() + 60);
  EXPECT_LT(largest, 2 * changes[60]);
  EXPECT_GT(changes[60], 0.05);  // there is a grid
}

TEST_F(GroundTest, DebrisThatFliesAwayChangesNothingAtOnce) {
  DrawScene scene;
  scene.ground = Ground{};
  scene.spheres = {{{0, 0.4f, 0}, 0.4f}, {{0, 0.1f, 0}, 0.05f}};
  Image before;
  for (float way = 3; way < 3000; way *= 1.02f) {
    scene.spheres[1].center = {way, 0.1f, way};  // out of the picture from the start
    const Image now = ground_seen(scene, camera());
    if (!before.rgba.empty()) ASSERT_LT(difference(before, now), 0.5) << "at " << way << " m";
    before = now;
  }
}

}  // namespace
}  // namespace griffith::render
