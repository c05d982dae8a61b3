#include "app/render/contact_sheet.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/editor/imgui_context_owner.h"
#include "renderer/target.h"
#include "sim/core/error.h"

namespace griffith::app {
namespace {

constexpr int kMaxWidth = 320;  ///< width of a cell's picture [pixels]
constexpr int kGap = 8, kCaptionHeight = 22;
constexpr int kMaxSheet = 16384;  ///< [pixels], in both directions
constexpr render::Rgb kPaper = {0.13f, 0.14f, 0.16f};

struct Grid {
  int columns, rows, cell_width, cell_height;  ///< size of a cell with its caption and a gap [pixels]

  int left(int index) const { return kGap + index % columns * cell_width; }
  int top(int index) const { return kGap + index / columns * cell_height; }
  int width() const { return kGap + columns * cell_width; }
  int height() const { return kGap + rows * cell_height; }
};

void paste(const render::Image& picture, int left, int top, render::Image& sheet) {
  for (int y = 0; y < picture.height; ++y) {
    const auto from = picture.rgba.begin() + 4 * static_cast<std::ptrdiff_t>(y) * picture.width;
    const auto to = sheet.rgba.begin() + 4 * (static_cast<std::ptrdiff_t>(top + y) * sheet.width + left);
    for (int x = 0; x < 4 * picture.width; x += 4) {
      if (from[x + 3] == 255) std::copy_n(from + x, 4, to + x);
      if (from[x + 3] == 255) continue;
      for (int c = 0; c < 3; ++c)
        to[x + c] = static_cast<std::uint8_t>((from[x + c] * from[x + 3] + to[x + c] * (255 - from[x + 3])) / 255);
    }
  }
}

/// Returns the text, or as much of its end as fits.
std::string fitted(const std::string& text, float width) {
  std::size_t from = 0;
  while (from < text.size() && ImGui::CalcTextSize(text.c_str() + from).x > width) ++from;
  return from == 0 ? text : "…" + text.substr(std::min(text.size(), from + 1));
}

}  // namespace

void ContactSheet::add(const render::Image& image, std::string caption) {
  const int width = std::min(image.width, kMaxWidth);
  const int height = std::max(1, static_cast<int>(std::lround(1.0 * image.height * width / image.width)));
  cells_.push_back({width == image.width ? image : render::resized(image, width, height), std::move(caption)});
}

render::Image ContactSheet::image(const std::string& where) const {
  Grid grid{columns_, 1, kGap, kGap};
  for (const Cell& cell : cells_) {
    grid.cell_width = std::max(grid.cell_width, cell.picture.width + kGap);
    grid.cell_height = std::max(grid.cell_height, cell.picture.height + kCaptionHeight + kGap);
  }
  const int count = static_cast<int>(cells_.size());
  const bool too_high = columns_ > 0 && (count + columns_ - 1) / columns_ * grid.cell_height > kMaxSheet - kGap;
  if (columns_ == 0 || too_high)
    grid.columns = static_cast<int>(std::ceil(std::sqrt(1.0 * count * grid.cell_height / grid.cell_width)));
  grid.columns = std::clamp(grid.columns, 1, std::max(count, 1));
  grid.rows = (count + grid.columns - 1) / grid.columns;
  if (std::max(grid.width(), grid.height()) > kMaxSheet)
    throw InputError(where, "is too small for " + std::to_string(count) + " pictures",
                     "use fewer frames, or smaller pictures");
  ImGuiContextOwner imgui(1);
  const render::Target target(grid.width(), grid.height());
  imgui.begin_frame(grid.width(), grid.height());
  for (int i = 0; i < count; ++i) {
    const float top = static_cast<float>(grid.top(i) + grid.cell_height - kGap - kCaptionHeight + 3);
    const std::string caption = fitted(cells_[i].caption, static_cast<float>(grid.cell_width - kGap));
    ImGui::GetBackgroundDrawList()->AddText({static_cast<float>(grid.left(i)), top}, IM_COL32(225, 225, 225, 255),
                                            caption.c_str());
  }
  target.bind();
  target.clear(kPaper);
  imgui.end_frame();
  render::Image sheet = target.image();
  for (std::size_t pixel = 3; pixel < sheet.rgba.size(); pixel += 4) sheet.rgba[pixel] = 255;
  for (int i = 0; i < count; ++i) paste(cells_[i].picture, grid.left(i), grid.top(i), sheet);
  return sheet;
}

}  // namespace griffith::app
