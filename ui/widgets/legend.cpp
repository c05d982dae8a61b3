#include "ui/widgets/legend.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "ui/model/units.h"
#include "ui/widgets/style.h"

namespace griffith::ui {
namespace {

constexpr float kLowest = 90;          // height of a card, in design pixels
constexpr float kSampleHeight = 1.6f;  // height of a sample, in heights of its text
constexpr float kPadding = 12;         // design pixels between the card's edge and its content

/// Returns 1, 2, 2.5 or 5 times a power of ten, at least `minimum`.
double tick_step(double minimum) {
  const double power = std::pow(10, std::floor(std::log10(minimum)));
  for (const double factor : {1.0, 2.0, 2.5, 5.0}) {
    if (factor * power >= minimum * (1 - 1e-9)) return factor * power;
  }
  return 10 * power;
}

double display_factor(const Legend& legend) {
  return si_prefix(std::max(std::abs(legend.minimum), std::abs(legend.maximum)), legend.unit).factor;
}

std::string number_text(double value, double step) {
  const int decimals = std::clamp(static_cast<int>(std::ceil(-std::log10(step) - 1e-9)), 0, 6);
  const bool between = decimals < 6 && std::abs(std::remainder(value, std::pow(10, -decimals))) > step * 1e-3;
  char text[32];
  if (std::abs(value) >= 1e5 || step < 1e-6) {
    std::snprintf(text, sizeof text, "%.3g", value);
  } else {
    std::snprintf(text, sizeof text, "%.*f", decimals + between, std::abs(value) < step * 1e-6 ? 0.0 : value);
  }
  return text;
}

void draw_color_bar(ImDrawList* list, const Legend& legend, ImVec2 minimum, ImVec2 maximum) {
  const int count = static_cast<int>(legend.colors.size() / 4);
  const float height = (maximum.y - minimum.y) / static_cast<float>(count);
  for (int i = 0; i < count; ++i) {
    const std::uint8_t* c = &legend.colors[static_cast<std::size_t>(4 * i)];
    const float bottom = maximum.y - height * static_cast<float>(i);
    list->AddRectFilled({minimum.x, bottom - height}, {maximum.x, bottom}, IM_COL32(c[0], c[1], c[2], 255));
  }
}

/// Draws bars that extend left from the colors whose values they count, with the square root of the count so that rare
/// values show.
void draw_histogram(ImDrawList* list, const Legend& legend, ImVec2 minimum, ImVec2 maximum) {
  const int highest =
      legend.histogram.empty() ? 0 : *std::max_element(legend.histogram.begin(), legend.histogram.end());
  const float height = (maximum.y - minimum.y) / static_cast<float>(std::max<std::size_t>(legend.histogram.size(), 1));
  for (std::size_t i = 0; i < legend.histogram.size(); ++i) {
    const float fraction =
        std::sqrt(static_cast<float>(legend.histogram[i]) / static_cast<float>(std::max(highest, 1)));
    const float bottom = maximum.y - height * static_cast<float>(i);
    if (fraction > 0)
      list->AddRectFilled({maximum.x - fraction * (maximum.x - minimum.x), bottom - height}, {maximum.x, bottom},
                          IM_COL32(140, 149, 160, 150));
  }
}

/// Draws the samples below each other.
void draw_samples(ImDrawList* list, const Legend& legend, const Fonts& fonts, ImVec2 corner, float scale) {
  const float size = kSmallText * scale;
  for (const auto& [color, meaning] : legend.samples) {
    list->AddRectFilled(corner, {corner.x + 18 * scale, corner.y + size}, IM_COL32(color[0], color[1], color[2], 255));
    list->AddText(fonts.small, size, {corner.x + 28 * scale, corner.y}, palette::kText, meaning.c_str());
    corner.y += kSampleHeight * size;
  }
}

void draw_ticks(ImDrawList* list, const Legend& legend, const Fonts& fonts, ImVec2 minimum, ImVec2 maximum,
                float scale) {
  const float size = kSmallText * scale;
  const double factor = display_factor(legend);
  const std::vector<double> ticks =
      legend_ticks(legend.minimum / factor, legend.maximum / factor, legend_tick_count(maximum.y - minimum.y, size));
  const double step = ticks.size() > 1 ? ticks[1] - ticks[0] : (legend.maximum - legend.minimum) / factor;
  for (const double tick : ticks) {
    const double t = (tick * factor - legend.minimum) / (legend.maximum - legend.minimum);
    const float y = maximum.y - static_cast<float>(t) * (maximum.y - minimum.y);
    list->AddLine({maximum.x, y}, {maximum.x + 5 * scale, y}, palette::kTextDim, scale);
    list->AddText(fonts.small, size, {maximum.x + 10 * scale, y - size / 2}, palette::kText,
                  number_text(tick, step).c_str());
  }
}

std::string written_title(const Legend& legend) { return legend_title(legend) + (legend.locked ? "  locked" : ""); }

constexpr float kPlainWidth = 110;  ///< width of a card without a histogram [design pixels]

/// Width of the histogram, which small pictures omit.
float bars_width(const Legend& legend, const ScreenArea& picture, float scale) {
  constexpr float kBars = 44, kMostOfPicture = 0.375f;  // design pixels; fraction of the picture's width
  const bool fits = (kPlainWidth + kBars) * scale <= kMostOfPicture * (picture.maximum.x - picture.minimum.x);
  return legend.histogram.empty() || !fits ? 0 : kBars * scale;
}

}  // namespace

std::vector<double> legend_ticks(double minimum, double maximum, double count) {
  constexpr double kFinest = 10;
  const double step = tick_step((maximum - minimum) / count);
  const double first = std::ceil(minimum / step - 1e-9), last = std::floor(maximum / step + 1e-9);
  std::vector<double> ticks;
  for (double i = first; i <= last && ticks.size() < 1000; ++i) ticks.push_back(i * step);
  if (ticks.size() > 1 || count >= kFinest) return ticks;
  ticks = legend_ticks(minimum, maximum, kFinest);  // one number gives no scale: ticks near both ends
  return {ticks.front(), ticks.back()};
}

double legend_tick_count(double bar_height, double text_height) {
  constexpr double kLineSpacing = 1.15, kMost = 5;
  return std::clamp(bar_height / (kLineSpacing * text_height), 1.0, kMost);
}

std::string legend_title(const Legend& legend) {
  if (legend.unit.empty() || legend.unit == "-") return legend.title;
  const double largest = std::max(std::abs(legend.minimum), std::abs(legend.maximum));
  return legend.title + " [" + std::string(si_prefix(largest, legend.unit).symbol) + legend.unit + "]";
}

bool legend_fits(const ScreenArea& picture, float scale) {
  return 2 * kPlainWidth * scale <= picture.maximum.x - picture.minimum.x &&
         2 * kLowest * scale <= picture.maximum.y - picture.minimum.y;
}

ScreenArea legend_card(const Legend& legend, LegendCorner corner, const Fonts& fonts, const ScreenArea& picture,
                       float scale) {
  constexpr float kMargin = 14, kOtherCards = 40;  // design pixels; the other cards are hints in the editor's view
  const float text_width = fonts.small->CalcTextSizeA(kSmallText * scale, FLT_MAX, 0, written_title(legend).c_str()).x;
  const ImVec2 size = {
      std::max(text_width + 2 * kPadding * scale, kPlainWidth * scale + bars_width(legend, picture, scale)),
      std::clamp(0.4f * (picture.maximum.y - picture.minimum.y), kLowest * scale, 300 * scale)};
  const bool left = corner == LegendCorner::upper_left || corner == LegendCorner::lower_left;
  const bool lower = corner == LegendCorner::lower_right || corner == LegendCorner::lower_left;
  const float margin = kMargin * scale, edge = margin + (left || lower ? kOtherCards * scale : 0);
  const ImVec2 low = {left ? picture.minimum.x + margin : picture.maximum.x - margin - size.x,
                      lower ? picture.maximum.y - edge - size.y : picture.minimum.y + edge};
  return {low, {low.x + size.x, low.y + size.y}};
}

void draw_legend(ImDrawList* list, const Legend& legend, const Fonts& fonts, const ScreenArea& picture, float scale) {
  const float size = kSmallText * scale, padding = kPadding * scale;
  const auto [corner, end] = legend_card(legend, legend.corner, fonts, picture, scale);
  list->AddRectFilled(corner, end, IM_COL32(24, 27, 32, 215), 6 * scale);
  list->AddText(fonts.small, size, {corner.x + padding, corner.y + padding * 0.75f}, palette::kText,
                written_title(legend).c_str());
  const ImVec2 bar = {corner.x + padding + bars_width(legend, picture, scale), corner.y + padding * 1.9f + size};
  const float below = kSampleHeight * size * static_cast<float>(legend.samples.size());
  const ImVec2 bar_end = {bar.x + 18 * scale, end.y - padding - size * 0.3f - below};
  if (bars_width(legend, picture, scale) > 0)
    draw_histogram(list, legend, {corner.x + padding, bar.y}, {bar.x - 2 * scale, bar_end.y});
  draw_color_bar(list, legend, bar, bar_end);
  draw_ticks(list, legend, fonts, bar, bar_end, scale);
  draw_samples(list, legend, fonts, {bar.x, bar_end.y + 0.6f * size}, scale);
}

}  // namespace griffith::ui
