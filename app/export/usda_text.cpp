#include "app/export/usda_text.h"

#include "sim/core/number_text.h"

namespace griffith::app {
namespace {

template <class Vectors>
std::string array_text(const Vectors& vectors) {
  std::string text = "[";
  for (const auto& vector : vectors)
    text +=
        (text.size() > 1 ? ", " : "") + usda_tuple(std::span(vector.data(), static_cast<std::size_t>(vector.size())));
  return text + ']';
}

}  // namespace

std::string usda_tuple(std::span<const double> values) {
  std::string text = "(";
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i > 0) text += ", ";
    append_number(text, static_cast<float>(values[i]));
  }
  return text + ')';
}

std::string usda_tuple(const Vec3& v) { return usda_tuple(std::span<const double>(v.data(), 3)); }

std::string usda_tuple(std::initializer_list<double> values) {
  return usda_tuple(std::span<const double>(values.begin(), values.size()));
}

std::string usda_array(std::span<const Vec3> vectors) { return array_text(vectors); }
std::string usda_array(std::span<const Vec2> vectors) { return array_text(vectors); }

UsdaText::UsdaText(double frames_per_second, int last_frame) {
  line("#usda 1.0");
  line("(");
  line("    defaultPrim = \"World\"");
  line("    metersPerUnit = 1");
  line("    upAxis = \"Y\"");
  line("    timeCodesPerSecond = " + number_text(frames_per_second));
  line("    framesPerSecond = " + number_text(frames_per_second));
  line("    startTimeCode = 0");
  line("    endTimeCode = " + std::to_string(last_frame));
  line(")");
}

void UsdaText::line(const std::string& text) {
  text_.append(static_cast<std::size_t>(4 * depth_), ' ').append(text) += '\n';
}

void UsdaText::open(const std::string& head) {
  line(head + " {");
  ++depth_;
}

void UsdaText::close() {
  --depth_;
  line("}");
}

}  // namespace griffith::app
