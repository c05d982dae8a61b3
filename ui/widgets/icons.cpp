#include "ui/widgets/icons.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <iterator>
#include <utility>

namespace griffith::ui {
namespace {

constexpr float kPi = 3.14159265f;

/// Draws in a square from -1 to 1, y downward.
class Pen {
 public:
  Pen(ImDrawList* list, ImVec2 center, float size, ImU32 color)
      : list_(list), center_(center), half_(size / 2), color_(color) {}

  ImVec2 at(float x, float y) const { return {center_.x + half_ * x, center_.y + half_ * y}; }
  void triangle(ImVec2 a, ImVec2 b, ImVec2 c) const {
    list_->AddTriangleFilled(at(a.x, a.y), at(b.x, b.y), at(c.x, c.y), color_);
  }
  void box(float x0, float y0, float x1, float y1) const {
    list_->AddRectFilled(at(x0, y0), at(x1, y1), color_, 0.1f * half_);
  }
  void line(float x0, float y0, float x1, float y1) const { list_->AddLine(at(x0, y0), at(x1, y1), color_, width()); }
  void frame(float x0, float y0, float x1, float y1) const {
    list_->AddRect(at(x0, y0), at(x1, y1), color_, 0.2f * half_, 0, width());
  }
  void arc(float radius, float from, float to) const {
    list_->PathArcTo(center_, radius * half_, from, to, 20);
    list_->PathStroke(color_, 0, width());
  }
  void disc(float x, float y, float radius) const { list_->AddCircleFilled(at(x, y), radius * half_, color_, 16); }
  void text(const char* letter) const {
    const ImVec2 size = ImGui::CalcTextSize(letter);
    list_->AddText({std::round(center_.x - size.x / 2), std::round(center_.y - size.y / 2)}, color_, letter);
  }

 private:
  float width() const { return 0.22f * half_; }

  ImDrawList* list_;
  ImVec2 center_;
  float half_;
  ImU32 color_;
};

/// Draws three quarters of a circle with an arrowhead; `side` -1 turns left, 1 right.
void draw_turn(const Pen& pen, float side) {
  if (side < 0) {
    pen.arc(0.75f, -0.75f * kPi, 0.8f * kPi);
  } else {
    pen.arc(0.75f, 0.2f * kPi, 1.75f * kPi);
  }
  pen.triangle({side * 0.95f, -0.95f}, {side * 0.95f, -0.1f}, {side * 0.1f, -0.25f});
}

void draw_corners(const Pen& pen) {
  for (const float x : {-0.85f, 0.85f}) {
    for (const float y : {-0.85f, 0.85f}) {
      pen.line(x, y, 0.4f * x, y);
      pen.line(x, y, x, 0.4f * y);
    }
  }
  pen.disc(0, 0, 0.25f);
}

void draw_bow(const Pen& pen, float side) {
  pen.line(-side * 0.8f, 0.5f, -side * 0.8f, -0.05f);
  pen.line(-side * 0.8f, -0.05f, side * 0.4f, -0.05f);
  pen.triangle({side * 0.9f, -0.05f}, {side * 0.25f, -0.6f}, {side * 0.25f, 0.5f});
}

void draw_eye(const Pen& pen, bool open) {
  constexpr int kParts = 8;
  for (int i = 0; i < kParts; ++i) {
    const auto lid = [](int part) { return 0.5f * std::sin(kPi * static_cast<float>(part) / kParts); };
    const float x = -0.9f + 1.8f * static_cast<float>(i) / kParts, next = x + 1.8f / kParts;
    pen.line(x, lid(i), next, lid(i + 1));
    if (open) pen.line(x, -lid(i), next, -lid(i + 1));
  }
  if (open) pen.disc(0, 0, 0.3f);
}

/// Draws a box in perspective.
void draw_box(const Pen& pen) {
  pen.frame(-0.8f, -0.35f, 0.35f, 0.8f);
  pen.line(-0.8f, -0.35f, -0.35f, -0.8f);
  pen.line(-0.35f, -0.8f, 0.8f, -0.8f);
  pen.line(0.8f, -0.8f, 0.35f, -0.35f);
  pen.line(0.8f, -0.8f, 0.8f, 0.35f);
  pen.line(0.8f, 0.35f, 0.35f, 0.8f);
}

/// Drawing of each icon; none for Icon::none.
using Drawing = std::pair<Icon, void (*)(const Pen& pen)>;
constexpr Drawing kDrawings[] = {
    {Icon::play,
     [](const Pen& pen) {
       pen.triangle({-0.6f, -0.85f}, {-0.6f, 0.85f}, {0.85f, 0});
     }},
    {Icon::pause,
     [](const Pen& pen) {
       pen.box(-0.65f, -0.8f, -0.15f, 0.8f);
       pen.box(0.15f, -0.8f, 0.65f, 0.8f);
     }},
    {Icon::step,
     [](const Pen& pen) {
       pen.triangle({-0.7f, -0.8f}, {-0.7f, 0.8f}, {0.4f, 0});
       pen.box(0.45f, -0.8f, 0.75f, 0.8f);
     }},
    {Icon::step_back,
     [](const Pen& pen) {
       pen.triangle({0.7f, -0.8f}, {0.7f, 0.8f}, {-0.4f, 0});
       pen.box(-0.75f, -0.8f, -0.45f, 0.8f);
     }},
    {Icon::to_start,
     [](const Pen& pen) {
       for (const float x : {-0.1f, 0.75f}) pen.triangle({x, -0.7f}, {x, 0.7f}, {x - 0.75f, 0});
       pen.line(-0.9f, -0.7f, -0.9f, 0.7f);
     }},
    {Icon::to_end,
     [](const Pen& pen) {
       for (const float x : {-0.75f, 0.1f}) pen.triangle({x, -0.7f}, {x, 0.7f}, {x + 0.75f, 0});
       pen.line(0.9f, -0.7f, 0.9f, 0.7f);
     }},
    {Icon::reset, [](const Pen& pen) { draw_turn(pen, 1); }},
    {Icon::fire,
     [](const Pen& pen) {
       pen.disc(0.35f, -0.1f, 0.45f);
       for (const float y : {-0.4f, 0.0f, 0.4f}) pen.line(-0.9f, y - 0.1f, -0.35f + 0.2f * (y == 0), y - 0.1f);
     }},
    {Icon::grab,
     [](const Pen& pen) {
       pen.frame(-0.9f, 0, -0.1f, 0.8f);
       for (int i = 0; i < 4; ++i) {
         const float x = -0.3f + 0.3f * static_cast<float>(i), y = 0.2f - 0.3f * static_cast<float>(i);
         pen.line(x, y, x + (i % 2 ? 0 : 0.3f), y - (i % 2 ? 0.3f : 0));
       }
       pen.disc(0.65f, -0.75f, 0.22f);
     }},
    {Icon::push,
     [](const Pen& pen) {
       pen.line(-0.95f, 0, -0.35f, 0);
       pen.triangle({-0.45f, -0.4f}, {-0.45f, 0.4f}, {0.1f, 0});
       pen.frame(0.25f, -0.65f, 0.9f, 0.65f);
     }},
    {Icon::open,
     [](const Pen& pen) {
       pen.box(-0.85f, -0.65f, -0.1f, -0.3f);
       pen.frame(-0.85f, -0.4f, 0.85f, 0.65f);
     }},
    {Icon::camera,
     [](const Pen& pen) {
       pen.frame(-0.9f, -0.45f, 0.9f, 0.7f);
       pen.box(-0.3f, -0.75f, 0.3f, -0.4f);
       pen.disc(0, 0.12f, 0.3f);
     }},
    {Icon::frame, [](const Pen& pen) { draw_corners(pen); }},
    {Icon::help, [](const Pen& pen) { pen.text("?"); }},
    {Icon::undo, [](const Pen& pen) { draw_bow(pen, -1); }},
    {Icon::redo, [](const Pen& pen) { draw_bow(pen, 1); }},
    {Icon::body, [](const Pen& pen) { draw_box(pen); }},
    {Icon::support,
     [](const Pen& pen) {
       pen.triangle({0, -0.6f}, {-0.65f, 0.4f}, {0.65f, 0.4f});
       pen.line(-0.9f, 0.65f, 0.9f, 0.65f);
     }},
    {Icon::load,
     [](const Pen& pen) {
       pen.line(0, -0.9f, 0, 0.1f);
       pen.triangle({-0.5f, 0}, {0.5f, 0}, {0, 0.8f});
     }},
    {Icon::projectile, [](const Pen& pen) { pen.disc(0, 0, 0.6f); }},
    {Icon::probe,
     [](const Pen& pen) {
       pen.arc(0.6f, 0, 2 * kPi);
       pen.disc(0, 0, 0.2f);
     }},
    {Icon::eye, [](const Pen& pen) { draw_eye(pen, true); }},
    {Icon::closed_eye, [](const Pen& pen) { draw_eye(pen, false); }},
};

}  // namespace

void draw_icon(ImDrawList* list, Icon icon, ImVec2 center, float size, ImU32 color) {
  const auto* drawing = std::ranges::find(kDrawings, icon, &Drawing::first);
  if (drawing != std::end(kDrawings)) drawing->second(Pen(list, center, size, color));
}

}  // namespace griffith::ui
