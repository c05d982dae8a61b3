// Large pictures: the parts together are the whole.

#include "app/picture/large_picture.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "app/render/render_job.h"
#include "program.h"
#include "renderer/egl_context.h"
#include "sim/scene/scene_reader.h"

namespace griffith::app {
namespace {

/// Returns the number of pixels in which two pictures of one size differ by more than 4 of 255.
int differing_pixels(const render::Image& a, const render::Image& b) {
  int count = 0;
  for (std::size_t pixel = 0; pixel < a.rgba.size(); pixel += 4) {
    int most = 0;
    for (std::size_t c = pixel; c < pixel + 3; ++c) most = std::max(most, std::abs(a.rgba[c] - b.rgba[c]));
    count += most > 4;
  }
  return count;
}

/// Draws the small wall some steps after its first crack.
RenderedPicture drawn(int largest_part, const std::string& quality, bool legend, bool transparent = false) {
  RenderJob job;
  job.scene = small_wall_file();
  job.frames = {20};
  job.width = 900;
  job.height = 700;
  job.largest_part = largest_part;
  job.legend = legend;
  job.transparent = transparent;
  set_quality(job, quality);
  RenderedPicture result;
  render_job(job, read_scene(job.scene), false, [&](RenderedPicture picture) { result = std::move(picture); });
  return result;
}

class LargePicture : public ::testing::Test {
 private:
  render::EglContext context_;
};

TEST_F(LargePicture, OfPartsIsTheWholePicture) {
  for (const char* quality : {"draft", "standard"}) {
    const RenderedPicture whole = drawn(4096, quality, false), joined = drawn(640, quality, false);
    ASSERT_EQ(joined.image.width, 900);
    ASSERT_EQ(joined.image.height, 700);
    EXPECT_LT(differing_pixels(whole.image, joined.image), 900 * 700 / 500)
        << quality << ": noise of shadows and edges";
    int other_ids = 0;
    for (std::size_t i = 0; i < whole.ids.ids.size(); ++i) other_ids += whole.ids.ids[i] != joined.ids.ids[i];
    EXPECT_LT(other_ids, 900 * 700 / 2000) << quality;
  }
}

TEST_F(LargePicture, HasItsTextInPlace) {
  const RenderedPicture whole = drawn(4096, "draft", true), joined = drawn(640, "draft", true);
  EXPECT_EQ(whole.record.text, joined.record.text);
  EXPECT_LT(differing_pixels(whole.image, joined.image), 900 * 700 / 500);
  EXPECT_GT(differing_pixels(whole.image, drawn(4096, "draft", false).image), 900 * 700 / 500) << "there is text";
}

TEST_F(LargePicture, WithoutBackgroundIsTheWholeToo) {
  const RenderedPicture whole = drawn(4096, "draft", false, true), joined = drawn(640, "draft", false, true);
  EXPECT_LT(differing_pixels(whole.image, joined.image), 900 * 700 / 500);
}

TEST(PaintInParts, CoversEveryPixelOnceWithItsOwn) {
  render::RenderOptions options;
  options.width = 1001;
  options.height = 503;
  int parts = 0;
  const PaintedPicture painted = paint_in_parts(options, 500, [&](const render::RenderOptions& part) {
    ++parts;
    EXPECT_LE(std::max(part.width, part.height), 500);
    EXPECT_EQ(part.part->left % 4, 0);
    PaintedPicture picture{{part.width, part.height, {}}, {part.width, part.height, {}}};
    for (int y = 0; y < part.height; ++y)
      for (int x = 0; x < part.width; ++x) {
        const int id = (part.part->top + y) * part.part->whole_width + part.part->left + x;
        picture.ids.ids.push_back(id);
        for (int channel = 0; channel < 4; ++channel)
          picture.image.rgba.push_back(static_cast<std::uint8_t>(id >> (8 * channel)));
      }
    return picture;
  });
  EXPECT_GT(parts, 2);
  for (int i = 0; i < options.width * options.height; ++i) ASSERT_EQ(painted.ids.ids[static_cast<std::size_t>(i)], i);
  const auto last = painted.image.pixel(1000, 502);
  EXPECT_EQ(last[0] + 256 * last[1] + 65536 * last[2], 1001 * 503 - 1);
}

}  // namespace
}  // namespace griffith::app
