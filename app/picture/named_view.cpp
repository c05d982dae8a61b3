#include "app/picture/named_view.h"

#include <algorithm>
#include <charconv>
#include <sstream>
#include <string_view>

#include "app/picture/bounds_of.h"
#include "sim/core/error.h"
#include "sim/scene/quantities.h"
#include "sim/scene/view_names.h"
#include "ui/model/view_layers.h"

namespace griffith::app {
namespace {

constexpr double kExplode = 0.6;

bool use_quantity(ViewSettings& view, const std::string& name) {
  if (!find_view_quantity(name)) return false;
  if (view.quantity != name) view.range.reset();
  view.quantity = name;
  return true;
}

bool use_layer(ViewSettings& view, const std::string& name) {
  const auto found = std::ranges::find(view_layers(), name, &ViewLayerInfo::key);
  if (found == view_layers().end()) return false;
  ui::show_layer(view, static_cast<ViewLayer>(found - view_layers().begin()));
  return true;
}

bool use_style(ViewSettings& view, const std::string& name) {
  const auto found = std::ranges::find(element_style_names(), name);
  if (found == element_style_names().end()) return false;
  view.elements = static_cast<ElementStyle>(found - element_style_names().begin());
  return true;
}

/// Takes "deformed=400", a magnification of the deformation.
bool use_deformation(ViewSettings& view, std::string_view name) {
  constexpr std::string_view kName = "deformed=";
  constexpr double kLargest = 1e6;
  if (!name.starts_with(kName)) return false;
  name.remove_prefix(kName.size());
  double scale = -1;
  const auto [end, error] = std::from_chars(name.begin(), name.end(), scale);
  if (error != std::errc() || end != name.end() || !(scale >= 0 && scale <= kLargest))
    throw InputError("--view", "\"deformed=" + std::string(name) + "\" has no magnification",
                     "write a number from 0 to 1e6: deformed=400");
  view.deformation_scale = scale;
  return true;
}

SlicePlane slice_through(const Frame& frame, const Vec3& toward_eye) {
  Eigen::AlignedBox3d box = bounds_of(frame);
  if (box.isEmpty()) box.extend(Vec3(Vec3::Zero()));
  return ui::middle_slice(box.min(), box.max(), toward_eye);
}

std::string all_names() {
  std::string names;
  for (const Quantity* quantity : view_quantities()) names.append(quantity->key).append(", ");
  for (const ViewLayerInfo& layer : view_layers()) names.append(layer.key).append(", ");
  for (const std::string_view style : element_style_names()) names.append(style).append(", ");
  return names + "exploded, slice, unlit, deformed=400";
}

}  // namespace

void use_named_view(ViewSettings& view, const std::string& names, const Frame& frame, const Vec3& toward_eye) {
  bool has_quantity = false, has_layer = false;
  std::istringstream list(names);
  for (std::string name; std::getline(list, name, '+');) {
    if (use_quantity(view, name)) {
      has_quantity = true;
    } else if (use_layer(view, name)) {
      has_layer = true;
    } else if (name == "exploded") {
      view.explode = kExplode;
    } else if (name == "unlit") {
      view.shading = false;
    } else if (name == "slice") {
      view.slice = slice_through(frame, toward_eye);
    } else if (!use_deformation(view, name) && !use_style(view, name)) {
      throw InputError("--view", "there is no view \"" + name + "\"", "join any of these with +: " + all_names());
    }
  }
  if (has_layer && !has_quantity) use_quantity(view, "plain");
}

}  // namespace griffith::app
