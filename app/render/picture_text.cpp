#include "app/render/picture_text.h"

#include <cmath>
#include <cstdio>

namespace griffith::app {
namespace {

std::string number(const char* format, double value) {
  char text[40];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

std::string pixels(float value) { return " " + std::to_string(std::lround(value)); }

/// Joins the lines of a widget's text.
std::string on_one_line(const std::string& text) {
  std::string line;
  for (const char c : text) line += c == '\n' ? std::string("\\n") : std::string(1, c);
  return line;
}

}  // namespace

std::string writing_text(const std::optional<ui::Legend>& legend, const std::vector<ui::PictureLabel>& labels) {
  std::string text;
  if (legend)
    text += "legend " + ui::legend_title(*legend) + number(" %.6g", legend->minimum) +
            number(" to %.6g", legend->maximum) + "\n";
  for (const ui::PictureLabel& label : labels)
    text += "label" + number(" %.4f", label.x) + number(" %.4f", label.y) + " " + on_one_line(label.text) + "\n";
  return text;
}

std::string widget_text(const ui::WidgetTags& tags) {
  std::string text;
  for (const ui::WidgetTag& tag : tags) {
    text += tag.name;
    if (!tag.value.empty()) text += " = " + on_one_line(tag.value);
    if (!tag.enabled) text += " (disabled)";
    text += " @" + pixels(tag.minimum.x) + pixels(tag.minimum.y) + pixels(tag.maximum.x - tag.minimum.x) +
            pixels(tag.maximum.y - tag.minimum.y) + "\n";
  }
  return text;
}

}  // namespace griffith::app
