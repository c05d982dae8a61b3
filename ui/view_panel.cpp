#include <algorithm>
#include <vector>

#include "sim/scene/view_quantity.h"
#include "ui/panels.h"
#include "ui/units.h"
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
  if (panel.state.view.range) range_rows(panel);
}

}  // namespace

void draw_view_panel(Panel& panel) {
  heading(panel, "View");
  quantity_row(panel);
  color_map_row(panel);
  range_part(panel);
  checkbox(panel, "view/edges", "Element edges", panel.state.view.edges);
  checkbox(panel, "view/splinters", "Splinters and surfaces", panel.state.view.splinters);
}

}  // namespace griffith::ui
