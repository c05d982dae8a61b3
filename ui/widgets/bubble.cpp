#include "ui/widgets/bubble.h"

#include <algorithm>

#include "ui/widgets/style.h"

namespace griffith::ui {
namespace {

constexpr float kWidest = 24, kNarrowest = 9;  // em

}  // namespace

BubblePlace::BubblePlace(const Box& item, const Box& window, ImVec2 screen, float em)
    : item_(item), window_(window), screen_(screen), em_(em) {
  const float frame = 2 * padding() + em;  // and the gaps on either side
  const float left = window.low.x - frame, right = screen.x - window.high.x - frame;
  to_the_right_ = right >= left;
  beside_ = std::max(left, right) >= kNarrowest * em;
  text_width_ = std::min(kWidest * em, beside_ ? std::max(left, right) : screen.x - frame);
}

Box BubblePlace::box(ImVec2 text_size) const {
  const ImVec2 size = {text_size.x + 2 * padding(), text_size.y + 2 * padding()};
  const float gap = em_ / 2;
  ImVec2 low = item_.low;
  if (beside_) {
    low.x = to_the_right_ ? window_.high.x + gap : window_.low.x - gap - size.x;
  } else {
    const bool below = item_.high.y + gap + size.y <= screen_.y;
    low.y = below ? item_.high.y + gap : item_.low.y - gap - size.y;
  }
  low.x = std::clamp(low.x, 0.0f, std::max(screen_.x - size.x, 0.0f));
  low.y = std::clamp(low.y, 0.0f, std::max(screen_.y - size.y, 0.0f));
  return {low, {low.x + size.x, low.y + size.y}};
}

void draw_bubble(std::string_view text, ImU32 border) {
  const ImVec2 corner = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
  const BubblePlace place({ImGui::GetItemRectMin(), ImGui::GetItemRectMax()},
                          {corner, {corner.x + size.x, corner.y + size.y}}, ImGui::GetIO().DisplaySize,
                          ImGui::GetFontSize());
  const char *begin = text.data(), *end = begin + text.size();
  const Box box = place.box(ImGui::CalcTextSize(begin, end, false, place.text_width()));
  const float rounding = ImGui::GetStyle().PopupRounding;
  ImDrawList* list = ImGui::GetForegroundDrawList();
  list->AddRectFilled(box.low, box.high, palette::kWindow, rounding);
  list->AddRect(box.low, box.high, border, rounding);
  list->AddText(ImGui::GetFont(), ImGui::GetFontSize(), {box.low.x + place.padding(), box.low.y + place.padding()},
                palette::kText, begin, end, place.text_width());
}

void tooltip(std::string_view text) {
  if (!text.empty() && ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) draw_bubble(text, palette::kLine);
}

}  // namespace griffith::ui
