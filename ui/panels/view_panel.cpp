#include <algorithm>
#include <array>
#include <cfloat>
#include <vector>

#include "sim/scene/quantities.h"
#include "sim/scene/view_names.h"
#include "ui/model/view_layers.h"
#include "ui/panels/panels.h"
#include "ui/widgets/field_range.h"
#include "ui/widgets/number_field.h"
#include "ui/widgets/widgets.h"

namespace griffith::ui {
namespace {

void quantity_row(Panel& panel) {
  const std::vector<const Quantity*> quantities = view_quantities();
  std::vector<std::string> labels;
  for (const Quantity* quantity : quantities) labels.emplace_back(quantity->label);
  const Quantity* current = find_view_quantity(panel.state.view.quantity);
  const std::string shown(current ? current->label : panel.state.view.quantity);
  const int chosen = combo_row(panel, "view/quantity", "Color by", labels, shown);
  if (chosen < 0) return;
  panel.state.view.quantity = quantities[static_cast<std::size_t>(chosen)]->key;
  panel.state.view.range.reset();
}

void quality_row(Panel& panel) {
  const std::vector<std::string> names(picture_quality_names().begin(), picture_quality_names().end());
  PictureQuality& quality = panel.state.view.quality;
  const int chosen = combo_row(panel, "view/quality", "Quality", names, names[static_cast<std::size_t>(quality)]);
  if (chosen >= 0) quality = static_cast<PictureQuality>(chosen);
}

void color_map_row(Panel& panel) {
  const std::vector<std::string> names(color_map_names().begin(), color_map_names().end());
  const int chosen = combo_row(panel, "view/color_map", "Color map", names, panel.state.view.color_map);
  if (chosen >= 0) panel.state.view.color_map = names[static_cast<std::size_t>(chosen)];
}

/// Draws both ends of a locked range, in the quantity's unit.
void range_rows(Panel& panel) {
  Vec2& range = *panel.state.view.range;
  Numbers numbers = range_of<ViewSettings>("range");
  if (const auto& legend = panel.input.views.front().legend) numbers.unit = legend->unit;
  const SiPrefix prefix = shared_prefix(panel.state, "view/range_", range.cwiseAbs().maxCoeff(), unit_symbol(numbers));
  constexpr std::array kTags = {"view/range_minimum", "view/range_maximum"}, kLabels = {"From", "To"};
  for (std::size_t i = 0; i < 2; ++i) {
    const auto end = static_cast<Eigen::Index>(i);
    Vec2 edited = range;
    const Edit edit = number_field_row(panel,
                                       {.tag = kTags[i],
                                        .label = kLabels[i],
                                        .numbers = numbers,
                                        .prefix = prefix,
                                        .vector_magnitude = range.cwiseAbs().maxCoeff()},
                                       edited[end]);
    if (!edit.changed) continue;
    if (edited[0] < edited[1])
      range = edited;
    else
      panel.state.field_note = {kTags[i],
                                "The lower end of the range must be below its upper end; it was not changed."};
  }
}

void range_part(Panel& panel) {
  bool locked = panel.state.view.range.has_value();
  ImGui::BeginDisabled(!panel.input.views.front().legend);
  if (checkbox(panel, "view/lock_range", "Lock color range", locked)) {
    issue(panel, {.name = "view.lock_range"});
  }
  ImGui::EndDisabled();
  if (panel.state.view.range) return range_rows(panel);
  const bool always = parts_at_zero(panel.state.view);
  bool symmetric = always || panel.state.view.symmetric;
  ImGui::BeginDisabled(!panel.input.views.front().legend || always);
  if (checkbox(panel, "view/symmetric", "Symmetric about 0", symmetric)) panel.state.view.symmetric = symmetric;
  ImGui::EndDisabled();
  if (always) tooltip("The automatic color map of signed values is symmetric. Choose another map for another range.");
}

/// Draws a number of the view.
void view_row(Panel& panel, const std::string& name, const char* label, double& value) {
  number_field_row(panel, {.tag = "view/" + name, .label = label, .numbers = range_of<ViewSettings>(name)}, value);
}

/// Aligns the slice with an axis or the view; it still passes through the same point at the center of the bodies.
void align_slice(Panel& panel, const Vec3& normal) {
  const Vec3 middle = 0.5 * (panel.input.low + panel.input.high), unit = normal.normalized();
  panel.state.view.slice = SlicePlane{unit, unit.dot(middle)};
}

void slice_rows(Panel& panel) {
  bool cut = panel.state.view.slice.has_value();
  if (checkbox(panel, "view/slice", "Slice", cut)) issue(panel, {.name = "view.slice"});
  if (!panel.state.view.slice) return;
  row_label(panel, "Align");
  const std::pair<const char*, Vec3> axes[] = {
      {"X", Vec3::UnitX()}, {"Y", Vec3::UnitY()}, {"Z", Vec3::UnitZ()}, {"Eye", panel.input.toward_eye}};
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
  const double reach = 0.5 * slice.normal.normalized().cwiseAbs().dot(panel.input.high - panel.input.low);
  number_field_row(panel,
                   {.tag = "view/slice_offset",
                    .label = "Offset",
                    .numbers = range_of<SlicePlane>("offset"),
                    .vector_magnitude = reach},
                   slice.offset);
}

void element_rows(Panel& panel) {
  open_if_sought(panel, "view/element_rows");
  const bool open = ImGui::CollapsingHeader("Elements and slice");
  tag_last_item(panel.tags, "view/element_rows", open ? "open" : "closed");
  if (!open) return;
  const std::vector<std::string> styles(element_style_names().begin(), element_style_names().end());
  ViewSettings& view = panel.state.view;
  const int chosen =
      combo_row(panel, "view/elements", "Elements", styles, styles[static_cast<std::size_t>(view.elements)]);
  if (chosen >= 0) view.elements = static_cast<ElementStyle>(chosen);
  view_row(panel, "deformation_scale", "Deformation", view.deformation_scale);
  view_row(panel, "explode", "Explode", view.explode);
  view_row(panel, "opacity", "Opacity", view.opacity);
  slice_rows(panel);
  view_row(panel, "edge_width", "Edge width", view.edge_width);
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
  const bool open = begin_combo("##layers", text.c_str());
  if (open) {
    for (std::size_t i = 0; i < view_layers().size(); ++i) layer_entry(panel, i);
    ImGui::EndCombo();
  } else {
    tag_last_item(panel.tags, "view/layers", text);
  }
  if (count == 0) return;
  view_row(panel, "glyph_scale", "Glyph size", panel.state.view.glyph_scale);
  if (!shows_layer(panel.state.view, ViewLayer::fracture_planes)) return;
  number_field_row(panel,
                   {.tag = "view/fracture_planes",
                    .label = "Crack planes",
                    .numbers = range_of<ViewSettings>("fracture_planes"),
                    .tooltip = "Number of cracks whose planes are shown, newest first."},
                   panel.state.view.fracture_planes);
}

/// True if a view shows tetrahedra rather than splinters, shards or surface files: values belong to tetrahedra.
bool shows_tets(const ViewSettings& view) {
  if (!view.splinters || view.quantity == "tet" || view.elements != ElementStyle::surface) return true;
  const Quantity* quantity = find_view_quantity(view.quantity);
  return quantity && quantity->has_values();
}

void edges_row(Panel& panel) {
  checkbox(panel, "view/edges", "Element edges", panel.state.view.edges);
  if (panel.state.view.edges && !shows_tets(panel.state.view))
    hint(panel, "Not shown on splinters, shards and surface files.");
}

}  // namespace

void draw_view_panel(Panel& panel) {
  heading(panel, "View");
  quantity_row(panel);
  color_map_row(panel);
  range_part(panel);
  quality_row(panel);
  checkbox(panel, "view/shading", "Shading", panel.state.view.shading);
  tooltip("Without shading, pixels have exactly the colors of the legend.");
  checkbox(panel, "view/dust", "Dust and crumbs", panel.state.view.dust);
  tooltip("Debris of cracks in natural colors: a visual effect that does not affect the simulation.");
  edges_row(panel);
  checkbox(panel, "view/splinters", "Splinters and surfaces", panel.state.view.splinters);
  layer_rows(panel);
  element_rows(panel);
}

}  // namespace griffith::ui
