#include "app/picture/large_picture.h"

#include <algorithm>

namespace griffith::app {
namespace {

/// Interval of pixels along a side, and the longer one that is drawn for it.
struct Span {
  int first = 0, count = 0;
  int drawn_first = 0, drawn_count = 0;
};

/// Returns the width of the border that is drawn around a part [pixels]: the reach of ambient occlusion and of
/// refraction, of which the latter is a fraction of the picture's height.
int border_of(int whole_height) {
  constexpr int kOcclusion = 208, kRefraction = 64;
  return 4 * std::max(kOcclusion / 4, whole_height / kRefraction / 4);  // patterns repeat after four pixels
}

/// Divides a side of the picture.
std::vector<Span> spans(int length, int largest, int border) {
  if (length <= largest) return {{0, length, 0, length}};
  const int step = std::max(largest - 2 * border, 4) / 4 * 4;
  std::vector<Span> all;
  for (int first = 0; first < length; first += step) {
    const int end = std::min(first + step, length);
    const int drawn_first = std::max(first - border, 0), drawn_end = std::min(end + border, length);
    all.push_back({first, end - first, drawn_first, drawn_end - drawn_first});
  }
  return all;
}

/// Copies the inner part of rows of `values` numbers per pixel.
template <class Value>
void copy_rows(const std::vector<Value>& part, std::vector<Value>& whole, const Span& x, const Span& y, int width,
               std::size_t values) {
  for (int row = 0; row < y.count; ++row) {
    const auto from_pixel =
        static_cast<std::size_t>(y.first - y.drawn_first + row) * x.drawn_count + x.first - x.drawn_first;
    const auto to_pixel = static_cast<std::size_t>(y.first + row) * width + x.first;
    std::copy_n(part.begin() + static_cast<std::ptrdiff_t>(values * from_pixel), values * x.count,
                whole.begin() + static_cast<std::ptrdiff_t>(values * to_pixel));
  }
}

}  // namespace

PaintedPicture paint_in_parts(const render::RenderOptions& whole, int largest_part,
                              const std::function<PaintedPicture(const render::RenderOptions&)>& paint) {
  constexpr std::size_t kChannels = 4;
  if (std::max(whole.width, whole.height) <= largest_part) return paint(whole);
  const int border = border_of(whole.height);
  const std::size_t pixels = static_cast<std::size_t>(whole.width) * whole.height;
  PaintedPicture result{{whole.width, whole.height, {}}, {whole.width, whole.height, {}}};
  result.image.rgba.resize(kChannels * pixels);
  result.ids.ids.resize(pixels);
  for (const Span& y : spans(whole.height, largest_part, border))
    for (const Span& x : spans(whole.width, largest_part, border)) {
      render::RenderOptions options = whole;
      options.width = x.drawn_count;
      options.height = y.drawn_count;
      options.part = {x.drawn_first, y.drawn_first, whole.width, whole.height};
      const PaintedPicture part = paint(options);
      copy_rows(part.image.rgba, result.image.rgba, x, y, whole.width, kChannels);
      copy_rows(part.ids.ids, result.ids.ids, x, y, whole.width, 1);
    }
  return result;
}

render::Image large_picture(render::Renderer& renderer, const render::DrawScene& scene, const render::Camera& camera,
                            const render::RenderOptions& options) {
  return paint_in_parts(options, kLargestPart,
                        [&](const render::RenderOptions& part) {
                          renderer.render(scene, camera, part);
                          return PaintedPicture{renderer.image(), renderer.ids()};
                        })
      .image;
}

}  // namespace griffith::app
