#include <algorithm>
#include <cfloat>
#include <vector>

#include "sim/scene/view_quantity.h"
#include "ui/panels.h"
#include "ui/units.h"
#include "ui/view_layers.h"
#include "ui/widgets.h"

namespace griffith::ui {
namespace {

void quantity_row(Panel& panel) {
  std::vector<std::string> labels;
  std::string shown = panel.state.view.quantity;
  for (const ViewQuantity& quantity : view_quantities()) {
    labels.emplace_back(quantity.label);
    if (quantity.key == panel.state.view.quantity) shown = quantity.label;
  }
  const int chosen = combo_row(panel, "view/quantity", "Colour by", labels, shown);
  if (chosen < 0) return;
  panel.state.view.quantity = view_quantities()[static_cast<std::size_t>(chosen)].key;
  panel.state.view.range.reset();
}

void color_map_row(Panel& panel) {
  const std::vector<std::string> names(color_map_names().begin(), color_map_names().end());
  const int chosen = combo_row(panel, "view/color_map", "Colours", names, panel.state.view.color_map);
  if (chosen >= 0) panel.state.view.color_map = names[static_cast<std::size_t>(chosen)];
}

/// Both ends of a locked range, in the quantity's unit with the prefix of the larger one.
void range_rows(Panel& panel) {
  Vec2& range = *panel.state.view.range;
  const std::string_view unit = panel.input.legend ? std::string_view(panel.input.legend->unit) : "";
  const SiPrefix prefix = si_prefix(range.cwiseAbs().maxCoeff(), unit);
  const std::string format = "%.4g " + std::string(prefix.symbol) + std::string(unit);
  double ends[2] = {range[0] / prefix.factor, range[1] / prefix.factor};
  const float speed = static_cast<float>((ends[1] - ends[0]) / 200);
  const char* labels[2] = {"From", "To"};
  const char* tags[2] = {"view/range_minimum", "view/range_maximum"};
  for (int i = 0; i < 2; ++i) {
    row_label(panel, labels[i]);
    ImGui::DragScalar(("##" + std::string(tags[i])).c_str(), ImGuiDataType_Double, &ends[i], speed, nullptr, nullptr,
                      format.c_str());
    tag_last_item(panel.tags, tags[i], format_quantity(range[i], unit));
  }
  if (ends[0] < ends[1]) range = Vec2(ends[0], ends[1]) * prefix.factor;
}

void range_part(Panel& panel) {
  bool locked = panel.state.view.range.has_value();
  ImGui::BeginDisabled(!panel.input.legend);
  if (checkbox(panel, "view/lock_range", "Lock colour range", locked)) {
    issue(panel, {.id = CommandId::toggle_range_lock});
  }
  ImGui::EndDisabled();
  if (panel.state.view.range) return range_rows(panel);
  const bool always = parts_at_zero(panel.state.view);
  bool symmetric = always || panel.state.view.symmetric;
  ImGui::BeginDisabled(!panel.input.legend || always);
  if (checkbox(panel, "view/symmetric", "Symmetric about 0", symmetric)) panel.state.view.symmetric = symmetric;
  ImGui::EndDisabled();
  if (always) tooltip("Automatic colours of what has a sign part at 0. Choose others for another range.");
}

/// A slider from `low` to `high` that keeps what lies beyond them.
void slider_row(Panel& panel, const char* tag, const char* label, double& value, double low, double high,
                const char* format, bool logarithmic = false) {
  row_label(panel, label);
  const ImGuiSliderFlags flags = (logarithmic ? ImGuiSliderFlags_Logarithmic : 0) | ImGuiSliderFlags_AlwaysClamp;
  ImGui::SliderScalar(("##" + std::string(tag)).c_str(), ImGuiDataType_Double, &value, &low, &high, format, flags);
  tag_last_item(panel.tags, tag, format_quantity(value, "-"));
}

/// Turns the slice to an axis, or to face the eye; it stays where it cuts the middle of the bodies.
void align_slice(Panel& panel, const Vec3& normal) {
  const Vec3 middle = 0.5 * (panel.input.low + panel.input.high), unit = normal.normalized();
  panel.state.view.slice = SlicePlane{unit, unit.dot(middle)};
}

void slice_rows(Panel& panel) {
  bool cut = panel.state.view.slice.has_value();
  if (checkbox(panel, "view/slice", "Slice", cut)) issue(panel, {.id = CommandId::toggle_slice});
  if (!panel.state.view.slice) return;
  row_label(panel, "Align");
  const std::pair<const char*, Vec3> axes[] = {
      {"X", Vec3::UnitX()}, {"Y", Vec3::UnitY()}, {"Z", Vec3::UnitZ()}, {"Eye", panel.input.towards_eye}};
  for (const auto& [name, normal] : axes) {
    if (normal != axes[0].second) ImGui::SameLine();
    if (text_button(panel, ("view/slice_" + std::string(name)).c_str(), name)) align_slice(panel, normal);
  }
  row_label(panel, "Side");
  if (text_button(panel, "view/slice_flip", "Flip", -FLT_MIN)) {
    panel.state.view.slice->normal *= -1;
    panel.state.view.slice->offset *= -1;
  }
  SlicePlane& slice = *panel.state.view.slice;
  const Vec3 normal = slice.normal.normalized(), middle = 0.5 * (panel.input.low + panel.input.high);
  const double reach = 0.5 * normal.cwiseAbs().dot(panel.input.high - panel.input.low);
  slider_row(panel, "view/slice_offset", "Offset", slice.offset, normal.dot(middle) - reach, normal.dot(middle) + reach,
             "%.4g m");
}

void element_rows(Panel& panel) {
  const bool open = ImGui::CollapsingHeader("Elements and slice");
  tag_last_item(panel.tags, "view/element_rows", open ? "open" : "closed");
  if (!open) return;
  const std::vector<std::string> styles(element_style_names().begin(), element_style_names().end());
  ViewSettings& view = panel.state.view;
  const int chosen =
      combo_row(panel, "view/elements", "Elements", styles, styles[static_cast<std::size_t>(view.elements)]);
  if (chosen >= 0) view.elements = static_cast<ElementStyle>(chosen);
  slider_row(panel, "view/explode", "Explode", view.explode, 0, 5, "%.2f", true);
  slider_row(panel, "view/opacity", "Opacity", view.opacity, 0.05, 1, "%.2f");
  slice_rows(panel);
  slider_row(panel, "view/edge_width", "Edge width", view.edge_width, 0.25, 10, "%.2f", true);
}

void layer_entry(Panel& panel, std::size_t index) {
  const ViewLayerInfo& info = view_layers()[index];
  const auto layer = static_cast<ViewLayer>(index);
  bool shown = shows_layer(panel.state.view, layer);
  if (checkbox(panel, ("view/layers/" + std::string(info.key)).c_str(), std::string(info.label).c_str(), shown))
    show_layer(panel.state.view, layer, shown);
  tooltip(info.hint);
}

void layer_rows(Panel& panel) {
  const std::size_t count = panel.state.view.layers.size();
  const std::string text = count == 0 ? "none" : std::to_string(count) + " shown";
  row_label(panel, "Layers");
  const bool open = ImGui::BeginCombo("##layers", text.c_str(), ImGuiComboFlags_HeightLargest);
  if (open) {
    for (std::size_t i = 0; i < view_layers().size(); ++i) layer_entry(panel, i);
    ImGui::EndCombo();
  } else {
    tag_last_item(panel.tags, "view/layers", text);
  }
  if (count == 0) return;
  slider_row(panel, "view/glyph_scale", "Size of signs", panel.state.view.glyph_scale, 0.1, 10, "%.2f", true);
  if (shows_layer(panel.state.view, ViewLayer::fracture_planes))
    integer_row(panel, "view/fracture_planes", "Planes of last", panel.state.view.fracture_planes, 1, 1000000);
}

}  // namespace

void draw_view_panel(Panel& panel) {
  heading(panel, "View");
  quantity_row(panel);
  color_map_row(panel);
  range_part(panel);
  checkbox(panel, "view/shading", "Shading", panel.state.view.shading);
  tooltip("Without, a pixel has exactly the colour that the legend gives to its value.");
  checkbox(panel, "view/edges", "Element edges", panel.state.view.edges);
  checkbox(panel, "view/splinters", "Splinters and surfaces", panel.state.view.splinters);
  layer_rows(panel);
  element_rows(panel);
}

}  // namespace griffith::ui
